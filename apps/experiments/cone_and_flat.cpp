// SPDX-License-Identifier: Apache-2.0
// Cones and flat heads pressed into half spaces, walls and edges, with the spindle standing: C4-C9.
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"

namespace hapticut::experiments {
namespace pressed_edges {

constexpr double kHeight = 1.2 * mm;
constexpr double kTall = 3 * kHeight;  // so that the smooth end is farther away than the cutting surface
constexpr double kCoarsest = 0.1 * mm;

/// [1] Relative error of the number of lattice points in a disk of radius R: 0.82 sqrt(R/l) of pi (R/l)^2, root mean
/// square (Kendall). A sum over springs that do not vanish at the rim of the bottom has this error.
double rim_error(double l) { return 0.26 * std::pow(l / kR, 1.5); }

/// [m^2] Error of the integral of z from 0 on a lattice: l^2/2 times the second Bernoulli polynomial of the place of
/// the first point, whose root mean square is 0.0745. The springs of a bottom, which end at z = 0, have this error.
double kink_error(double l) { return 0.0745 / 2 * l * l; }

// Predictions are for all phases of the grid. Twelve phases are within a factor of 1.5, sums of two errors within 2.
constexpr double kPhaseFactor = 2;

std::vector<Check> cone() {
  const double depth = 0.8 * mm;
  Refined axial("C4", "cone at 0.8 mm, half-apex angle 15, 30, 45 deg, force", kSecondOrder,
                "springs at the centres of voxels");
  Refined aside("C4 sideways", "cone: force across the axis", kSecondOrder, "springs that turn on the axis");
  for (const double angle : {15 * deg, 30 * deg, 45 * deg}) {
    const double expected = forms::cone_force(kStiffness, angle, depth);
    const auto press = [&](double l, const Vec3& phase) {
      Simulation simulation(box_at_phase(half_space(kHeight * std::tan(angle), depth, l), l, phase),
                            Tool(ConeHead{angle, kHeight}), static_config());
      return rest_ok_at(simulation, Vec3(0, 0, -depth)).force;
    };
    // A full voxel has the spring of its centre, without -l^2/24 of its Laplacian: 1/(2 tan(a)^2) (l/d)^2. The parts at
    // the surface, assumed to lie across n, return (1 - sin a)/sin(a) of this; their fills add a little.
    axial.add(converge(depth / 8, [&](double l, const Vec3& p) { return press(l, p).z() / expected - 1; }),
              second_order(0.5 / std::pow(std::tan(angle), 2) + 0.2, depth));
    // Sideways the springs change their direction on the axis, where they are deepest. Each layer has an error
    // l^2 w cos(a) that depends on the phase; the sum is (l/d)^2/tan(a)^3 of the small axial force.
    aside.add(converge(depth / 8, [&](double l, const Vec3& p) { return press(l, p).head<2>().norm() / expected; }),
              second_order(1.1 / std::pow(std::tan(angle), 3), depth));
  }
  return joined({axial.checks(), aside.checks()});
}

/// Force of a flat head at depth d in a half space.
Vec3 press_flat(FlatRule rule, double depth, double l, const Vec3& phase) {
  Simulation simulation(box_at_phase(half_space(kR, depth, l), l, phase), Tool(FlatHead{kR, kTall, rule}),
                        static_config());
  return rest_ok_at(simulation, Vec3(0, 0, -depth)).force;
}

std::vector<Check> flat() {
  Refined bottom("C5", "flat head at 0.2, 0.6 and 1 mm, rule bottom_only, force", kRimOrder,
                 "lattice points at the rim", kOfRimOrder);
  Refined nearest("C6", "flat head at 0.2, 0.6 and 1 mm, rule nearest, force", kRimOrder, "lattice points of the ridge",
                  kOfRimOrder);
  Largest both_up, both_aside, side_up;
  for (const double d : {0.2 * mm, 0.6 * mm, 1.0 * mm}) {
    const double whole = forms::flat_bottom_force(kStiffness, kR, d),
                 inner = forms::flat_nearest_force(kStiffness, kR, d);
    const auto refined = [d](FlatRule rule, double expected) {
      return converge(kCoarsest, [=](double l, const Vec3& p) { return press_flat(rule, d, l, p).z() / expected - 1; });
    };
    bottom.add(refined(FlatRule::bottom_only, whole),
               [&](double l) { return kPhaseFactor * std::hypot(rim_error(l), kink_error(l) / (d * d / 2)); });
    // The direction jumps where wall and bottom are equally near. These places form a cone, some of whose normals are
    // normals of the lattice's planes, so the order is that of a disk (measured: 0.2 to 0.5 (l/R)^1.5).
    nearest.add(refined(FlatRule::nearest, inner), [&](double l) {
      return 0.6 * std::pow(l / kR, 1.5) + 1.5 * kink_error(l) / (d * d / 2) * whole / inner;
    });
    // A voxel that the bottom crosses is cut across the sum of both springs: second order.
    for (const double l : {kCoarsest / 2, kCoarsest / 4}) {
      const Vec3 both = press_flat(FlatRule::both, d, l, phase(1));
      both_up.add(both.z() / press_flat(FlatRule::bottom_only, d, l, phase(1)).z() - 1, 0.2 * std::pow(l / d, 2));
      if (l == kCoarsest / 2) both_aside.add(both.head<2>().norm(), 0.01 * both.z());
    }
    side_up.add(press_flat(FlatRule::side_only, d, kCoarsest / 2, phase(2)).z(), 1e-12 * whole);
  }
  return joined(
      {bottom.checks(),
       nearest.checks(),
       {both_up.check("C5 both", "rule both has the axial force of the bottom, error", "0.2 (l/d)^2"),
        both_aside.check("C5 both, sideways", "rule both: remaining side force", "1 %, asymmetry of the lattice"),
        side_up.check("C5 side_only", "rule side_only: axial force", "1e-12, none")}});
}

/// A wall x > R - d beside the head, from z0 to z1 above its bottom.
struct Wall {
  double depth;                           // [m] d
  double z0 = 0.35 * mm, z1 = 0.85 * mm;  // [m]

  [[nodiscard]] Box box(double l) const {
    const double reach = kR + 2 * l;
    return {Vec3(kR - depth, -reach, z0), Vec3(reach, reach, z1)};
  }
  [[nodiscard]] double area() const { return forms::disk_area_before(kR, depth - kR); }  // area of the segment
  [[nodiscard]] double force() const { return forms::side_wall_force(kStiffness, kR, depth, z1 - z0); }

  /// [1] Error of the force over (l/d)^2. At the wall's ends n lies in the end faces. A part that is assumed to lie
  /// across n is l/12 too shallow on average over all fills: k_v l^2/6 times the integral of n_x over the segment.
  [[nodiscard]] double error() const {
    const double c = kR - depth, a = std::sqrt(kR * kR - c * c);
    const double along = kR * a - c * c * std::log((kR + a) / c);
    return 1.3 * kStiffness * along / 6 * depth * depth / std::abs(force()) + 0.1;
  }
  [[nodiscard]] StepResult press(FlatRule rule, double l, const Vec3& phase, double handle_length = 0) const {
    Simulation simulation(box_at_phase(box(l), l, phase), Tool(FlatHead{kR, kTall, rule}, RayHandle{handle_length}),
                          static_config());
    return rest_ok_at(simulation, Vec3(0, 0, handle_length));
  }
};

constexpr std::array kWallDepths = {0.1 * mm, 0.3 * mm, 0.6 * mm, 0.9 * mm};

std::vector<Check> wall() {
  Refined force("C7", "side of a cylinder 0.1, 0.3, 0.6, 0.9 mm in a wall, force vector", kSecondOrder,
                "1.3 of the fills at the wall's ends");
  Refined torque("C8", "torque of this wall about a point of the handle", kSecondOrder,
                 "1.3 of the fills at the wall's ends");
  for (const double depth : kWallDepths) {
    const Wall wall = {depth};
    const double reference = 1.5 * mm;
    const double moment = forms::side_wall_torque(kStiffness, kR, depth, wall.z0, wall.z1, reference);
    force.add(converge(kCoarsest / 2,
                       [&](double l, const Vec3& p) {
                         const Vec3 felt = wall.press(FlatRule::side_only, l, p).force;
                         return (felt - Vec3(wall.force(), 0, 0)).norm() / std::abs(wall.force());
                       }),
              second_order(wall.error(), depth));
    torque.add(converge(kCoarsest / 2,
                        [&](double l, const Vec3& p) {
                          return wall.press(FlatRule::side_only, l, p, reference).torque.y() / moment - 1;
                        }),
               second_order(wall.error(), depth));
  }
  return joined({force.checks(), torque.checks()});
}

std::vector<Check> wall_rules() {
  Largest both_aside, both_up, nearest, bottom;
  for (const double depth : kWallDepths) {
    const Wall wall = {depth};
    const double fine = kCoarsest / 8;
    const Vec3 side = wall.press(FlatRule::side_only, fine, phase(3)).force;
    const Vec3 both = wall.press(FlatRule::both, fine, phase(3)).force;
    both_aside.add(both.x() / side.x() - 1, 0.5 * std::pow(fine / depth, 2));  // the bound of C5 both
    // Lattice points in a circular segment, which is at least 0.1 mm = 8 voxels deep here.
    both_up.add(both.z() / (kStiffness * wall.area() * (wall.z1 * wall.z1 - wall.z0 * wall.z0) / 2) - 1, 0.02);
    // A thin ledge so high above the bottom that the wall is nearer at all these depths.
    const Wall ledge = {depth, 0.95 * mm, 1.1 * mm};
    const StepResult by_side = ledge.press(FlatRule::side_only, kCoarsest / 4, phase(4));
    const StepResult by_nearest = ledge.press(FlatRule::nearest, kCoarsest / 4, phase(4));
    nearest.add((by_side.force - by_nearest.force).norm(), 1e-12 * by_side.force.norm());
    nearest.add((by_side.torque - by_nearest.torque).norm(), 1e-12 * by_side.torque.norm());
    const Vec3 of_bottom = wall.press(FlatRule::bottom_only, kCoarsest / 2, phase(5)).force;
    bottom.add(of_bottom.head<2>().norm(), 1e-12 * side.norm());
  }
  return {
      both_aside.check("C7 both", "rule both has the side force of the side, error", "0.5 (l/d)^2"),
      both_up.check("C7 both, up", "rule both: axial force of the bottom over the segment, error",
                    "2 %, lattice points in a segment"),
      nearest.check("C7 nearest", "rule nearest, high above the bottom, has the side force, error", "1e-12, identical"),
      bottom.check("C7 bottom_only", "rule bottom_only: side force", "1e-12, none")};
}

std::vector<Check> edge() {
  const double d = 0.3 * mm;
  Refined force("C9", "flat bottom over an edge at -0.5, 0 and 0.4 mm, force", kRimOrder, "lattice points at the rim",
                kOfRimOrder);
  Refined torque("C9 torque", "flat bottom over an edge, torque", kRimOrder, "lattice points at half of the rim",
                 kOfRimOrder);
  for (const double x0 : {-0.5 * mm, 0.0, 0.4 * mm}) {
    const auto press = [&](double l, const Vec3& phase) {
      Box box = half_space(kR, d, l);
      box.max.x() = x0;
      Simulation simulation(box_at_phase(box, l, phase), Tool(FlatHead{kR, kHeight, FlatRule::bottom_only}),
                            static_config());
      return StepResult(rest_ok_at(simulation, Vec3(0, 0, -d)));
    };
    // The rim has the error of lattice points, as in C5. The covered area is as small as a fifth of the disk.
    const auto bound = [d](double covered) {
      return [=](double l) {
        return kPhaseFactor * std::hypot(rim_error(l) * kPi * kR * kR / covered, kink_error(l) / (d * d / 2));
      };
    };
    const double push = forms::edge_force(kStiffness, kR, d, x0), turn = forms::edge_torque(kStiffness, kR, d, x0);
    force.add(converge(kCoarsest, [&](double l, const Vec3& p) { return press(l, p).force.z() / push - 1; }),
              bound(forms::disk_area_before(kR, x0)));
    // At most half of the rim counts; its mean square lever is R^2/2.
    const double moment = 2.0 / 3 * std::pow(kR * kR - x0 * x0, 1.5);  // [m^3] moment of the area about the axis
    torque.add(converge(kCoarsest, [&](double l, const Vec3& p) { return press(l, p).torque.y() / turn - 1; }),
               bound(2 * moment / kR));
  }
  return joined({force.checks(), torque.checks()});
}

}  // namespace pressed_edges

std::vector<Experiment> cone_flat_experiments() {
  return {// Proves: normal force.
          {"cone", pressed_edges::cone},
          // Proves: normal force.
          {"flat head", pressed_edges::flat},
          // Proves: normal force; torque.
          {"flat head in a wall", pressed_edges::wall},
          {"flat head in a wall, rules", pressed_edges::wall_rules},
          // Proves: normal force.
          {"flat head over an edge", pressed_edges::edge}};
}

}  // namespace hapticut::experiments
