// SPDX-License-Identifier: Apache-2.0
// Symmetries of the step, and its energy balance for anything that a hand may do.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/generators.hpp"
#include "support/static_contact.hpp"

namespace hapticut {
namespace {

using test::arbitrary_head;
using test::arbitrary_rotation;
using test::arbitrary_vector;
using test::number_between;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kVoxel = 0.1 * mm;

/// A block of two materials that the head is pressed into, cutting, along a straight path.
struct Scene {
  Box box_V = {Vec3(-1.52, -1.43, -1.61) * mm, Vec3(1.38, 1.51, 0.03) * mm};
  GridFrame frame = {kVoxel, {}};
  VoxelIndex shift = {0, 0, 0};  // the same voxels under other indices
  bool mirrored = false;         // at x = 0 of the grid
  ToolHead head = SphereHead{0.8 * mm};
  double spin = 2000;  // [rad/s]
  Pose X_VT;           // where the head starts, in the grid's frame
  Vec3 feed_V = Vec3(3, 1, -5) * units::mm_per_s;
  Material soft, hard;

  Scene() {
    soft.name = "soft", soft.relative_stiffness = 0.4, soft.cutting_ratio = 0.3;
    soft.specific_cutting_energy = 1e8, soft.damping = 5;
    hard.name = "hard", hard.edge_pressure = 1e5;
    X_VT = {rotation_from_vector(Vec3(0.5, 0.3, 0.2)), Vec3(0.1, -0.05, 0.3) * mm};
  }
};

struct Outcome {
  std::vector<Wrench> wrenches_V;  // about To, in the frame of the grid
  double removed_volume = 0;
  EnergyLedger energy;
};

Outcome run(const Scene& scene, int steps = 40) {
  const auto mirror = [&](Vec3 v) {
    if (scene.mirrored) v.x() = -v.x();
    return v;
  };
  Box box = scene.box_V;
  if (scene.mirrored) std::tie(box.min.x(), box.max.x()) = std::pair(-box.max.x(), -box.min.x());
  const Vec3 shift = kVoxel * Vec3(scene.shift[0], scene.shift[1], scene.shift[2]);
  GridFrame frame = scene.frame;
  frame.X_WV.translation -= frame.X_WV.rotation * shift;
  Workpiece workpiece = test::box_on_grid(
      {box.min + shift, box.max + shift}, frame, MaterialTable({scene.soft, scene.hard}),
      [&](const Vec3& p) { return MaterialId(mirror(p - shift).dot(Vec3(1, 2, 3)) < -0.2317 * mm ? 2 : 1); });
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  Simulation simulation(std::move(workpiece),
                        Tool(scene.head, RayHandle{}, {scene.mirrored ? -scene.spin : scene.spin}), config);
  Outcome outcome;
  const Mat3 R_WV = scene.frame.X_WV.rotation;
  for (int i = 1; i <= steps; ++i) {
    Pose X_VT = scene.X_VT;
    X_VT.translation += scene.feed_V * 1e-3 * i;
    if (scene.mirrored) {
      // A head of revolution mirrored is itself, with its y axis reversed to keep the frame right-handed.
      const Mat3 M = Vec3(-1, 1, 1).asDiagonal(), S = Vec3(1, -1, 1).asDiagonal();
      X_VT = {M * X_VT.rotation * S, M * X_VT.translation};
    }
    const StepResult& result =
        simulation.step(scene.frame.X_WV * X_VT, {R_WV * mirror(scene.feed_V), Vec3::Zero()}, 1e-3);
    RC_ASSERT(!has(result.status, kRejected));
    outcome.wrenches_V.push_back({R_WV.transpose() * result.force, R_WV.transpose() * result.torque});
    outcome.removed_volume += result.removed_volume;
  }
  outcome.energy = simulation.last_result().energy;
  return outcome;
}

/// Largest difference of force and torque on the way, relative to the largest force and to 1 mm times it.
double difference(const Outcome& a, const Outcome& b) {
  double force = 0, worst = 0;
  for (std::size_t n = 0; n < a.wrenches_V.size(); ++n) {
    force = std::max(force, a.wrenches_V[n].force.norm());
    worst = std::max(worst, (a.wrenches_V[n].force - b.wrenches_V[n].force).norm());
    worst = std::max(worst, (a.wrenches_V[n].torque - b.wrenches_V[n].torque).norm() / (1 * mm));
  }
  RC_ASSERT(force > 0);
  return worst / force;
}

// Positions in single precision differ in their last bits from one frame to another, and a voxel then counts one step
// earlier or later: where the spring does not vanish at the rim, or where cutting starts, that is one of hundreds.
constexpr double kOneVoxel = 5e-3;

Scene arbitrary_scene() {
  Scene scene;
  scene.head = *arbitrary_head();
  RC_PRE(scene.head.bounding_box().max.x() > 0.3 * mm);
  const HeadBox box = scene.head.bounding_box();
  const Vec3 middle = 0.5 * (box.min + box.max);
  const Mat3 R_VT = *arbitrary_rotation();
  scene.X_VT = {R_VT, Vec3(*number_between(-0.2, 0.2), *number_between(-0.2, 0.2), *number_between(-0.1, 0.1)) * mm -
                          R_VT * middle};
  scene.feed_V = *arbitrary_vector(10 * units::mm_per_s);
  scene.spin = *number_between(500, 5000);
  return scene;
}

RC_GTEST_PROP(Step, ARotatedSceneGivesTheRotatedWrench, ()) {
  Scene scene = arbitrary_scene();
  const Outcome straight = run(scene, 10);
  scene.frame.X_WV = {*arbitrary_rotation(), *arbitrary_vector(5 * mm)};
  RC_ASSERT(difference(straight, run(scene, 10)) < kOneVoxel);
}

RC_GTEST_PROP(Step, AMirroredSceneGivesTheMirroredWrench, ()) {
  Scene scene = arbitrary_scene();
  const Outcome straight = run(scene, 10);
  scene.mirrored = true;
  Outcome mirrored = run(scene, 10);
  for (Wrench& wrench : mirrored.wrenches_V) {
    wrench.force.x() = -wrench.force.x();  // a force mirrors like a position,
    wrench.torque.tail<2>() *= -1;         // a torque with the opposite sign
  }
  RC_ASSERT(difference(straight, mirrored) < kOneVoxel);
}

RC_GTEST_PROP(Step, TheGridsOriginDoesNotMatter, ()) {
  Scene scene = arbitrary_scene();
  const Outcome before = run(scene, 10);
  for (int& i : scene.shift) i = *rc::gen::inRange(-1000, 1000);
  RC_ASSERT(difference(before, run(scene, 10)) < kOneVoxel);
}

/// A scene whose springs are conservative: their depth vanishes wherever material can get in. That is any ball, and a
/// cone or a flat head of rule `nearest` as long as its upper end stays outside.
Scene arbitrary_conservative_scene() {
  Scene scene = arbitrary_scene();
  if (std::holds_alternative<SphereHead>(scene.head.shape())) return scene;
  const Vec3 tilt_axis = Vec3(1, 0, 0) * *number_between(-0.5, 0.5) + Vec3(0, 1, 0) * *number_between(-0.5, 0.5);
  const double height = *number_between(2 * mm, 3 * mm);
  if (*rc::gen::arbitrary<bool>())
    scene.head = ConeHead{*number_between(15 * deg, 35 * deg), height};
  else
    scene.head = FlatHead{*number_between(0.4 * mm, 1.2 * mm), height};
  scene.X_VT = {rotation_from_vector(tilt_axis),
                Vec3(*number_between(-0.5, 0.5), *number_between(-0.5, 0.5), *number_between(-0.2, 0.3)) * mm};
  return scene;
}

// Anything that a hand may do, with anything that a material may be: the ledger closes and nothing is gained.
RC_GTEST_PROP(Step, TheLedgerClosesAndNoLossIsNegativeInAnyCut, ()) {
  Scene scene = arbitrary_conservative_scene();
  for (Material* m : {&scene.soft, &scene.hard}) {
    m->relative_stiffness = *number_between(0.05, 2);
    m->cutting_ratio = *number_between(0, 3);
    m->specific_cutting_energy = std::pow(10, *number_between(7, 10));
    m->edge_pressure = *rc::gen::element(0.0, 1e4, 1e6);
    m->damping = *number_between(0, 50);
  }
  const Outcome outcome = run(scene);
  const EnergyLedger& e = outcome.energy;
  const double work = std::abs(e.hand_work) + std::abs(e.motor_work);
  RC_PRE(work > 0);
  RC_CLASSIFY(outcome.removed_volume > 0, "cuts");
  RC_LOG() << "closure " << e.closure() << " hand " << e.hand_work << " motor " << e.motor_work << " elastic "
           << e.elastic << " cutting " << e.cutting << " released " << e.released << " damping " << e.damping
           << " rubbing " << e.rubbing << " credited " << e.credited << " kind " << scene.head.shape().index() << " R "
           << scene.head.largest_radius();
  // A touch too light to fill the first voxel is booked to a few hundredths of that voxel's k_v l^5.
  RC_ASSERT(std::abs(e.imbalance()) < 0.005 * work + 3e-2 * 1e13 * std::pow(kVoxel, 5));
  for (const double term : {e.elastic, e.cutting, e.released, e.damping, e.rubbing, e.credited})
    RC_ASSERT(term >= -1e-6 * work);
  RC_ASSERT(outcome.removed_volume >= 0);
}

}  // namespace
}  // namespace hapticut
