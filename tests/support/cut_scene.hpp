// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>

#include "experiments/setup/static_contact.hpp"
#include "support/generators.hpp"

/// @file
/// A tool that moves through a block of two materials: the scene for properties of every cut.
namespace hapticut::test {

inline constexpr double kSceneVoxel = 0.1 * units::mm;

/// [1] Tolerance of `difference`. Positions in single precision differ in their last bits between frames. One voxel
/// among hundreds may then count a step earlier or later, or get another curve of a profile.
inline constexpr double kOneVoxel = 5e-3;

/// A block of two materials that the head is pressed into, along a straight path.
struct CutScene {
  Box box_V = {Vec3(-1.52, -1.43, -1.61) * units::mm, Vec3(1.38, 1.51, 0.03) * units::mm};
  GridFrame frame = {kSceneVoxel, {}};
  VoxelIndex shift = {0, 0, 0};  // added to the indices of all voxels
  bool mirrored = false;         // at x = 0 of the grid
  ToolHead head = SphereHead{0.8 * units::mm};
  Handle handle = RayHandle{0};  // a ray without length: the wrench is about To
  std::shared_ptr<const ForceLaw> law = SimulationConfig{}.law;
  RemovalLaw removal = RemovalLaw::constant_energy;
  double spin = 2000;                                                   // [rad/s]
  std::optional<double> later_spin;                                     // [rad/s] set half-way
  double acceleration_limit = std::numeric_limits<double>::infinity();  // [rad/s^2]
  Pose X_VT;                                                            // where the head starts, in the grid's frame
  Vec3 feed_V = Vec3(3, 1, -5) * units::mm_per_s;
  Vec3 omega_V = Vec3::Zero();  // [rad/s] angular velocity of the head about its origin
  Material soft, hard;

  CutScene() {
    soft.name = "soft", soft.relative_stiffness = 0.4, soft.cutting_ratio = 0.3;
    soft.specific_cutting_energy = 1e8, soft.damping = 5;
    hard.name = "hard", hard.edge_pressure = 1e5;
    X_VT = {rotation_from_vector(Vec3(0.5, 0.3, 0.2)), Vec3(0.1, -0.05, 0.3) * units::mm};
  }
};

struct CutOutcome {
  std::vector<Wrench> wrenches_V;  // about To, in the frame of the grid
  std::vector<double> max_normal;  // [N] upper bound on the sum of all normal forces
  double one_voxel = 0;            // [N] upper bound on the force of a voxel by the default law
  double removed_volume = 0;
  EnergyLedger energy;
  double turnover = 0;     // [J] magnitudes of the works of hand and motor
  double min_loss = 0;     // [J] the most negative change of a dissipation in a step
  double max_sliding = 0;  // [J] maximum dissipation of dry friction in a step
};

/// The irreversible terms of a ledger.
inline std::array<double, 7> losses(const EnergyLedger& e) {
  return {e.cutting, e.crushed, e.released, e.damping, e.rubbing, e.sliding, e.credited};
}

inline CutOutcome run(const CutScene& scene, int steps = 40) {
  const auto mirror = [&](Vec3 v) {
    if (scene.mirrored) v.x() = -v.x();
    return v;
  };
  Box box = scene.box_V;
  if (scene.mirrored) std::tie(box.min.x(), box.max.x()) = std::pair(-box.max.x(), -box.min.x());
  const Vec3 shift = kSceneVoxel * Vec3(scene.shift[0], scene.shift[1], scene.shift[2]);
  GridFrame frame = scene.frame;
  frame.X_WV.translation -= frame.X_WV.rotation * shift;
  Workpiece workpiece = box_on_grid(
      {box.min + shift, box.max + shift}, frame, MaterialTable({scene.soft, scene.hard}),
      [&](const Vec3& p) { return MaterialId(mirror(p - shift).dot(Vec3(1, 2, 3)) < -0.2317 * units::mm ? 2 : 1); });
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  config.law = scene.law;
  config.removal = scene.removal;
  const double hand = scene.mirrored ? -1 : 1;
  Spindle spindle{hand * scene.spin * units::rad_per_s};
  spindle.acceleration_limit = scene.acceleration_limit;
  const Tool tool(scene.head, scene.handle, spindle);
  const Pose X_TH = tool.X_HT().inverse();
  Simulation simulation(std::move(workpiece), tool, config);
  CutOutcome outcome;
  const Mat3 R_WV = scene.frame.X_WV.rotation;
  EnergyLedger before;
  for (int i = 1; i <= steps; ++i) {
    Pose X_VT = scene.X_VT;
    X_VT.translation += scene.feed_V * 1e-3 * i;
    X_VT.rotation = rotation_from_vector(scene.omega_V * 1e-3 * i) * X_VT.rotation;
    Vec3 omega_V = scene.omega_V;
    if (scene.mirrored) {
      // A mirrored head of revolution is the same head, with its y axis reversed to keep the frame right-handed.
      const Mat3 M = Vec3(-1, 1, 1).asDiagonal(), S = Vec3(1, -1, 1).asDiagonal();
      X_VT = {M * X_VT.rotation * S, M * X_VT.translation};
      omega_V.tail<2>() *= -1;
    }
    if (scene.later_spin && i == steps / 2) simulation.spindle().set_speed(hand * *scene.later_spin * units::rad_per_s);
    const Pose X_WT = scene.frame.X_WV * X_VT, X_WH = X_WT * X_TH;
    const Vec3 p_HoTo_W = X_WT.translation - X_WH.translation;
    const Twist of_head{R_WV * mirror(scene.feed_V), R_WV * omega_V};
    const StepResult& result = simulation.step(X_WH, transport(of_head, -p_HoTo_W), 1e-3);
    RC_ASSERT(!has_any(result.status, kRejected));
    const Wrench at_head = transport(Wrench{result.force, result.torque}, -p_HoTo_W);
    outcome.wrenches_V.push_back({R_WV.transpose() * at_head.force, R_WV.transpose() * at_head.torque});
    const double max_stiffness =
        config.reference_stiffness * std::max(scene.soft.relative_stiffness, scene.hard.relative_stiffness);
    outcome.max_normal.push_back(max_stiffness * result.contact.depth * result.contact.volume);
    const double ratio = std::max(scene.soft.cutting_ratio, scene.hard.cutting_ratio);
    if (scene.law->is_foundation())
      outcome.one_voxel = std::max(
          outcome.one_voxel, max_stiffness * result.contact.depth * std::pow(kSceneVoxel, 3) * std::hypot(1.0, ratio));
    outcome.removed_volume += result.removed_volume;
    const EnergyLedger& after = result.energy;
    outcome.turnover += std::abs(after.hand_work - before.hand_work) + std::abs(after.motor_work - before.motor_work);
    const auto a = losses(before), b = losses(after);
    for (std::size_t n = 0; n < a.size(); ++n) outcome.min_loss = std::min(outcome.min_loss, b[n] - a[n]);
    outcome.max_sliding = std::max(outcome.max_sliding, after.sliding - before.sliding);
    before = after;
  }
  outcome.energy = before;
  return outcome;
}

/// Maximum difference of force and torque on the path. Forces are relative to the maximum force, torques to the maximum
/// force times 1 mm. A contact of few voxels is treated like a contact of hundreds of voxels.
inline double difference(const CutOutcome& a, const CutOutcome& b) {
  double force = 0, worst = 0;
  for (std::size_t n = 0; n < a.wrenches_V.size(); ++n) {
    force = std::max(force, a.wrenches_V[n].force.norm());
    worst = std::max(worst, (a.wrenches_V[n].force - b.wrenches_V[n].force).norm());
    worst = std::max(worst, (a.wrenches_V[n].torque - b.wrenches_V[n].torque).norm() / (1 * units::mm));
  }
  RC_ASSERT(force > 0);  // a scene without a force compares nothing
  return worst / std::max(force, a.one_voxel / kOneVoxel);
}

/// The expected wrench of a mirrored scene: a force mirrors like a position, a torque with the opposite sign.
inline CutOutcome mirrored_back(CutOutcome outcome) {
  for (Wrench& wrench : outcome.wrenches_V) {
    wrench.force.x() = -wrench.force.x();
    wrench.torque.tail<2>() *= -1;
  }
  return outcome;
}

/// A head in the middle of the upper face, in any orientation, that moves in any direction at up to 10 mm/s.
inline CutScene arbitrary_cut_scene(const ToolHead& head) {
  CutScene scene;
  scene.head = head;
  const HeadBox box = scene.head.bounding_box();
  const Vec3 middle = 0.5 * (box.min + box.max);
  const Mat3 R_VT = *arbitrary_rotation();
  scene.X_VT = {R_VT,
                Vec3(*number_between(-0.2, 0.2), *number_between(-0.2, 0.2), *number_between(-0.1, 0.1)) * units::mm -
                    R_VT * middle};
  scene.feed_V = *arbitrary_vector(10 * units::mm_per_s);
  scene.spin = *number_between(500, 5000);
  return scene;
}

/// A scene whose springs are conservative: their depth is zero wherever material can enter. This holds for any ball,
/// and for a cone or a flat head of rule `nearest` as long as its upper end stays outside.
/// @param kinds  1: balls; 3: cones and flat heads too
inline CutScene arbitrary_conservative_scene(int kinds = 3) {
  using units::mm;
  const int kind = *rc::gen::inRange(0, kinds);
  if (kind == 0) return arbitrary_cut_scene(SphereHead{*number_between(0.3 * mm, 1.5 * mm)});
  const double height = *number_between(2 * mm, 3 * mm);
  CutScene scene = arbitrary_cut_scene(SphereHead{1 * mm});
  if (kind == 1)
    scene.head = ConeHead{*number_between(15 * units::deg, 35 * units::deg), height};
  else
    scene.head = FlatHead{*number_between(0.4 * mm, 1.2 * mm), height};
  const Vec3 tilt_axis(*number_between(-0.5, 0.5), *number_between(-0.5, 0.5), 0);
  scene.X_VT = {rotation_from_vector(tilt_axis),
                Vec3(*number_between(-0.5, 0.5), *number_between(-0.5, 0.5), -*number_between(0.35, 0.5)) * mm};
  return scene;
}

/// Any valid material.
inline void make_arbitrary(Material& m) {
  m.relative_stiffness = *number_between(0.05, 2);
  m.cutting_ratio = *number_between(0, 3);
  m.specific_cutting_energy = std::pow(10, *number_between(7, 10));
  m.edge_pressure = *rc::gen::element(0.0, 1e4, 1e6);
  m.damping = *number_between(0, 50);
}

/// Any valid dry friction.
inline void make_rough(Material& m) {
  m.static_friction = *number_between(0, 1);
  m.dynamic_friction = *number_between(0, m.static_friction);
  m.tangential_stiffness = std::pow(10, *number_between(2, 4));
}

/// A straight or bent handle of up to a few centimetres.
inline Handle arbitrary_handle() {
  using units::mm;
  if (*rc::gen::arbitrary<bool>()) return RayHandle{*number_between(0, 30 * mm)};
  return LHandle{*number_between(0, 30 * mm), *number_between(0, 15 * mm), *number_between(-units::kPi, units::kPi)};
}

}  // namespace hapticut::test
