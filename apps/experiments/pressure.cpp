// SPDX-License-Identifier: Apache-2.0
// C11: the wrench of the foundation is that of the pressure k_v w^2/2 on the surface of the material inside the head. A
// plane quadrature of this pressure, with depths of the heads that are written here independently, is compared with the
// voxels in 200 poses of each head: six components, tilted heads, tilted planes, bent handles.
#include <algorithm>
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/setup/random_pose.hpp"
#include "experiments/vocabulary.hpp"
#include "hapticut/tool/catalogue.hpp"

namespace hapticut::experiments {
namespace pressure_identity {

using closed_forms::Plane;
using test::RandomPoses;

constexpr int kPlanes = 10;
constexpr int kPosesPerPlane = 20;

constexpr int kQuadraturePoints = 200;

/// The oracle's description of a head: its depth, which vanishes on its whole surface, and its smooth end. The smooth
/// end is a disk. It stays outside the material here (tests/system/physics/smooth_sides_test.cpp presses it in), but it
/// bounds the depth below the disk.
struct OracleHead {
  const char* name;
  ToolHead head;
  std::function<double(double rho, double z)> depth;  // [m] <= 0 outside
  double closed_end;                                  // [m] z in T; 0: no smooth end
  double closed_radius;                               // [m]

  // Expected error of voxels, with the largest depth w of the pose: error <= constant (l/w)^2. Sections give constants
  // up to 0.5 for an upright head (C1, C4), and 4 for a ball whose centre is in the material (error_of_cap). Where the
  // direction of the springs jumps inside the material (between wall and bottom of a flat head, between side and base
  // of a cone), lattice points add an error of order 1.5.
  double constant;
  double behind;            // constant when To is in the material
  double root_mean_square;  // [1] over all poses at l = 0.05 mm; grows by order 2 to coarser voxels, and falls by
                            // `min_order` to finer ones
  double min_order;

  /// [m] Radius of a ball about the middle of the head that contains the head.
  [[nodiscard]] double reach() const {
    return closed_end > 0 ? std::hypot(closed_end / 2, head.max_radius()) : head.max_radius();
  }
};

OracleHead ball() {
  const double R = 1 * mm;
  return {"ball", SphereHead{R}, [=](double rho, double z) { return R - std::hypot(rho, z); }, 0, 0, 1.5, 4.5, 0.003,
          1.7};
}

OracleHead cone() {
  const double a = 35 * deg, h = 1.6 * mm;
  return {"cone",
          ConeHead{a, h},
          [=](double rho, double z) { return std::min(z * std::sin(a) - rho * std::cos(a), kSmoothScale * (h - z)); },
          h,
          h * std::tan(a),
          4,  // voxels at the crease, where the distance jumps, are integrated in space
          4,
          0.008,
          1.6};
}

OracleHead flat() {
  const double r = 0.8 * mm, h = 1.6 * mm;
  return {"flat head",
          FlatHead{r, h},
          [=](double rho, double z) {
            return std::min({z, r - rho, kSmoothScale * (h - z)});
          },
          h,
          r,
          3.5,
          3.5,
          0.008,
          1.6};
}

OracleHead round_end() {
  const double r = 0.7 * mm, h = 1.6 * mm;
  return {
      "round end",
      round_end_cylinder_head(2 * r, h),
      [=](double rho, double z) { return std::min(r - std::hypot(rho, std::min(0.0, z - r)), kSmoothScale * (h - z)); },
      h,
      r,
      1.5,
      1.5,
      0.003,
      1.7};
}

/// The rim of the tip is sharper than a right angle, so the direction of the springs jumps more.
OracleHead inverted_cone() {
  const double tip = 0.8 * mm, neck = 0.5 * mm, h = 1.4 * mm;
  return {"inverted cone",
          inverted_cone_head(2 * tip, 2 * neck, h),
          [=](double rho, double z) {
            const double wall = ((tip - rho) * h - z * (tip - neck)) / std::hypot(h, tip - neck);
            return std::min({z, wall, kSmoothScale * (h - z)});
          },
          h,
          neck,
          6.0,
          6.0,
          0.011,
          1.6};
}

/// Two tiers: ridges and a hollow corner.
OracleHead tree() {
  const double R = 0.9 * mm, h = 1.6 * mm;
  struct Segment {
    Eigen::Vector2d from, to;
    double longest;  // [1] used length over its length: the last segment is extended
  };
  const double inner = kTreeWaist * R / 2;
  const std::vector<Segment> segments = {
      {{0, 0}, {R / 2, h / 2}, 1}, {{R / 2, h / 2}, {inner, h / 2}, 1}, {{inner, h / 2}, {R, h}, 9}};
  return {"tree",
          christmas_tree_head(2 * R, h, 2),
          [=](double rho, double z) {
            const double limit = z < h / 2 ? z * R / h : inner + (2 * z / h - 1) * (R - inner);
            if (z >= h || rho >= limit) return -1.0;
            double nearest = kSmoothScale * (h - z);
            for (const Segment& s : segments) {
              const Eigen::Vector2d along = s.to - s.from, x(rho, z);
              const double share = std::clamp(along.dot(x - s.from) / along.squaredNorm(), 0.0, s.longest);
              nearest = std::min(nearest, (x - s.from - share * along).norm());
            }
            return nearest;
          },
          h,
          R,
          5,  // ridges and a crease with the smooth end
          5,
          0.01,
          1.6};
}

Wrench pressure_on_plane(const OracleHead& oracle, const Pose& X_WT, const Plane& plane, int points) {
  return closed_forms::wrench_on_plane(kStiffness, oracle.depth, X_WT, plane, Vec3(0, 0, oracle.closed_end / 2),
                                       oracle.reach(), points);
}

/// [m] Height of the lowest point of the closed end's rim above the plane.
double lowest_of_closed_end(const OracleHead& oracle, const Pose& X_WT, const Plane& plane) {
  const double across = plane.normal.dot(X_WT.rotation.col(2));
  return plane.height(X_WT * Vec3(0, 0, oracle.closed_end)) -
         oracle.closed_radius * std::sqrt(std::max(0.0, 1 - across * across));
}

/// A random pose with the head pressed in deeply and its closed end outside.
Pose random_pose(const OracleHead& oracle, const Plane& plane, RandomPoses& random) {
  const double reach = oracle.reach();
  for (;;) {
    const Mat3 R_WT = random.rotation();
    const Vec3 on_plane = plane.offset * plane.normal + 0.1 * reach * random.direction();
    Pose X_WT = {
        R_WT, on_plane + random.between(-0.5, 0.9) * reach * plane.normal - R_WT * Vec3(0, 0, oracle.closed_end / 2)};
    if (oracle.closed_end > 0 && lowest_of_closed_end(oracle, X_WT, plane) < 0.02 * mm) continue;
    const Wrench wrench = pressure_on_plane(oracle, X_WT, plane, 40);
    if (wrench.force.norm() > 0.02 * kStiffness * std::pow(0.8 * mm, 4)) return X_WT;
  }
}

Workpiece half_space_below(const Plane& plane, double half_edge, double voxel_size) {
  Box box = {Vec3::Constant(-half_edge), Vec3::Constant(half_edge)};
  // Subsampling finds a plane along the grid only to half a subsample, so this plane is built exactly.
  if (plane.normal == Vec3::UnitZ()) {
    box.max.z() = plane.offset;
    return box_at_phase(box, voxel_size, phase(6));
  }
  const BodyDescription body = {box, [=](const Vec3& p) { return plane.height(p); },
                                [](const Vec3&) { return MaterialId(1); }};
  return build_body(body, voxel_size, materials_of_stiffness({1}));
}

/// Errors of one pose: force, torque about To and torque about Ho, relative to force and force times lever.
struct PoseError {
  double force, torque_T, torque_H;
  double depth;  // [m] greatest w
  [[nodiscard]] double largest() const { return std::max({force, torque_T, torque_H}); }
};

PoseError error_at(Simulation& simulation, const Pose& X_WT, const Wrench& expected_T, double reach) {
  const Pose X_WH = X_WT * simulation.tool().X_HT().inverse();
  const StepResult& felt = rest_ok_at(simulation, X_WH);
  const Vec3 p_HoTo_W = X_WT.translation - X_WH.translation;
  const Vec3 expected_torque_H = expected_T.torque + p_HoTo_W.cross(expected_T.force);
  const Vec3 torque_T = felt.torque - p_HoTo_W.cross(felt.force);
  const double force = expected_T.force.norm();
  return {(felt.force - expected_T.force).norm() / force, (torque_T - expected_T.torque).norm() / (force * reach),
          (felt.torque - expected_torque_H).norm() / (force * (reach + p_HoTo_W.norm())), felt.contact.depth};
}

Handle random_handle(int n, RandomPoses& random) {
  if (n % 2 == 0) return RayHandle{random.between(0, 5 * mm)};
  return LHandle{random.between(0, 5 * mm), random.between(0, 3 * mm), random.between(-kPi, kPi)};
}

// The grids, from coarse to fine. On the first grid the deepest springs of a pose have a handful of voxels, so the
// bound of a single pose applies to the other grids only.
constexpr double kVoxelSizes[] = {0.1 * mm, 0.05 * mm, 0.025 * mm};

/// Errors of force, torque about To and torque about Ho in all poses: each pose, and the root mean square.
void measure(const OracleHead& oracle, Convergence& c, Largest& single) {
  const double reach = oracle.reach();
  RandomPoses random(7);
  for (int n = 0; n < kPlanes; ++n) {
    const Plane plane = {n == 0 ? Vec3(0, 0, 1) : random.direction(), random.between(-0.2, 0.2) * mm};
    // The box is larger than the region of all poses, so its faces stay outside the head.
    const double half_edge = 2.3 * reach;
    const Tool tool(oracle.head, random_handle(n, random));
    std::vector<Simulation> on_grid;
    for (const double l : kVoxelSizes)
      on_grid.emplace_back(half_space_below(plane, half_edge, l), tool, static_config());
    for (int m = 0; m < kPosesPerPlane; ++m) {
      const Pose X_WT = random_pose(oracle, plane, random);
      const Wrench expected_T = pressure_on_plane(oracle, X_WT, plane, kQuadraturePoints);
      for (std::size_t level = 0; level < 3; ++level) {
        const PoseError e = error_at(on_grid[level], X_WT, expected_T, reach);
        c.error[level] += e.largest() * e.largest() / (kPlanes * kPosesPerPlane);
        if (level == 0) continue;
        const double constant = plane.height(X_WT.translation) < 0 ? oracle.behind : oracle.constant;
        single.add(e.largest(), constant * std::pow(kVoxelSizes[level] / e.depth, 2));
      }
    }
  }
  for (double& error : c.error) error = std::sqrt(error);
}

/// Error of the quadrature: compared with four times as many points.
Check quadrature(const OracleHead& oracle, const std::string& id) {
  Largest off;
  RandomPoses random(11);
  for (int n = 0; n < 10; ++n) {
    const Plane plane = {random.direction(), 0};
    const Pose X_WT = random_pose(oracle, plane, random);
    const Wrench used = pressure_on_plane(oracle, X_WT, plane, kQuadraturePoints);
    const Wrench finer = pressure_on_plane(oracle, X_WT, plane, 4 * kQuadraturePoints);
    off.add((used.force - finer.force).norm(), 2e-4 * finer.force.norm());
    off.add((used.torque - finer.torque).norm(), 2e-4 * finer.force.norm() * oracle.reach());
  }
  return off.check(id + " quadrature", "error of the quadrature", "2e-4 of the force");
}

std::vector<Check> checks_of(const OracleHead& oracle) {
  const std::string id = std::string("C11 ") + oracle.name;
  Convergence c = {{kVoxelSizes[0], kVoxelSizes[1], kVoxelSizes[2]}, {0, 0, 0}};
  Largest single;
  measure(oracle, c, single);
  Refined error(id, std::string(oracle.name) + ", force and torque in 200 poses, root mean square of the error", 2,
                "measured; lattice points at ridges", {1 - oracle.min_order / 2, "of 200 poses"});
  error.add(c, [&](double l) {
    return oracle.root_mean_square * std::pow(l / kVoxelSizes[1], l > kVoxelSizes[1] ? 2 : oracle.min_order);
  });
  return joined(
      {error.checks(),
       {single.check(id + " each", "error of each pose", "constant of the head (l/w)^2"), quadrature(oracle, id)}});
}

}  // namespace pressure_identity

std::vector<Experiment> pressure_experiments() {
  using namespace pressure_identity;
  std::vector<Experiment> experiments;
  for (const OracleHead& oracle : {ball(), cone(), flat(), round_end(), inverted_cone(), tree()})
    experiments.push_back(
        // Proves: pressure identity.
        {"pressure identity, " + std::string(oracle.name), [=] { return checks_of(oracle); }});
  return experiments;
}

}  // namespace hapticut::experiments
