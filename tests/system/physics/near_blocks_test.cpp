// SPDX-License-Identifier: Apache-2.0
// The step finds blocks and voxels once for several places of the head. What it found before must not matter.
#include <gtest/gtest.h>

#include "experiments/setup/grid_boxes.hpp"
#include "experiments/setup/random_pose.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/workpieces.hpp"

namespace hapticut::near_blocks_test {
namespace {

using test::RandomPoses;
using units::deg;
using units::mm;

constexpr double kVoxel = 0.1 * mm, kTick = 1e-3;

Simulation simulation_with(const ToolHead& head, AngularSpeed speed) {
  Material soft, hard;
  soft.name = "soft", soft.specific_cutting_energy = 1e7, soft.compressive_strength = 5e6;
  hard.name = "hard", hard.specific_cutting_energy = 3e7, hard.edge_pressure = 1e5;
  const Box box = {Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm};
  Workpiece workpiece = test::box_on_grid(box, {kVoxel, {}}, MaterialTable({soft, hard}),
                                          [](const Vec3& p) { return MaterialId(p.x() + p.y() < 0.03 * mm ? 1 : 2); });
  workpiece.reserve_undo(1000);
  SimulationConfig config;
  config.reference_stiffness = 1e13;
  return Simulation(std::move(workpiece), Tool(head, RayHandle{0}, Spindle{speed}), config);
}

struct Scene {
  std::string name;
  ToolHead head;
};

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {{"ball", SphereHead{0.6 * mm}},
                                         {"cone", ConeHead{30 * deg, 1 * mm}},
                                         {"flat", FlatHead{0.5 * mm, 1 * mm}},
                                         {"pear", pear_head(1.2 * mm, 2.4 * mm, 0.8 * mm)}};
  return all;
}

/// A block that is not full of voxels that were ever solid: it ends above the workpiece.
TEST(NearBlocksBesideATip, AreThoseThatTheTipReaches) {
  const auto make = [] {
    return Simulation(build_block({Vec3(-1.6, -1.6, -2) * mm, Vec3(1.6, 1.6, 0) * mm}, kVoxel, presets::dentin()),
                      Tool(needle_head(1 * mm, 4 * mm), RayHandle{0}, common_spindle(40000 * units::rpm)));
  };
  Simulation plain = make(), asked = make();
  const Vec3 velocity = Vec3(0, 0, -1.3e-3);
  Pose X_WH = Pose::from_translation(Vec3(0.013, 0.021, 0.12) * mm);
  for (int tick = 0; tick < 150; ++tick) {
    X_WH.translation += kTick * velocity;
    (void)asked.touches(Pose::from_translation(Vec3(9, 9, 9) * mm));
    const StepResult &a = plain.step(X_WH, {velocity, Vec3::Zero()}, kTick),
                     &b = asked.step(X_WH, {velocity, Vec3::Zero()}, kTick);
    ASSERT_EQ(a.contact.voxels, b.contact.voxels) << "tick " << tick;
    ASSERT_EQ(a.force, b.force) << "tick " << tick;
  }
  EXPECT_GT(plain.last_result().contact.voxels, 0);
}

class NearBlocks : public testing::TestWithParam<std::tuple<std::size_t, double>> {};

TEST_P(NearBlocks, GiveTheSameBitsWhateverWasFoundBefore) {
  const auto [number, speed] = GetParam();
  Simulation plain = simulation_with(scenes()[number].head, speed * units::rad_per_s);
  Simulation asked = simulation_with(scenes()[number].head, speed * units::rad_per_s);
  RandomPoses random(31 + number);
  const double bottom = plain.tool().head().bounding_box().min.z();
  Pose X_WH = Pose::from_translation(Vec3(0.013, 0.021, 0.1) * mm - Vec3(0, 0, bottom));
  Vec3 velocity = Vec3(0, 0, -4e-3);
  long touched = 0;
  for (int tick = 0; tick < 400; ++tick) {
    if (tick % 40 == 0) velocity = Vec3(0, 0, -3e-3) + random.vector(4e-3);
    const Vec3 spin = random.vector(0.3);
    X_WH = advance(X_WH, {velocity, spin}, kTick);
    // A question far away, and one within the distance for which voxels are listed.
    if (tick % 3 == 0) (void)asked.touches(Pose::from_translation(Vec3(5, 5, 5) * mm));
    if (tick % 3 == 1) (void)asked.touches({X_WH.rotation, X_WH.translation + random.vector(0.2 * kVoxel)});
    if (tick == 200) {
      ASSERT_TRUE(plain.history().mark() && asked.history().mark());
    }
    if (tick == 300) {
      ASSERT_TRUE(plain.history().undo(10000) && asked.history().undo(10000));
      X_WH.translation.z() += 2 * mm;
    }
    if (tick == 301) X_WH.translation.z() -= 2 * mm;
    const Twist V_WH = {velocity, spin};
    const StepResult &a = plain.step(X_WH, V_WH, kTick), &b = asked.step(X_WH, V_WH, kTick);
    ASSERT_EQ(a.force, b.force) << "tick " << tick;
    ASSERT_EQ(a.torque, b.torque) << "tick " << tick;
    ASSERT_EQ(a.removed_volume, b.removed_volume) << "tick " << tick;
    ASSERT_EQ(a.energy.elastic, b.energy.elastic) << "tick " << tick;
    touched += a.contact.voxels > 0 ? 1 : 0;
  }
  EXPECT_EQ(plain.workpiece().hash(), asked.workpiece().hash());
  EXPECT_GT(touched, 200) << "the head must touch, else the test proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Heads, NearBlocks,
                         testing::Combine(testing::Range<std::size_t>(0, 4), testing::Values(0.0, 3000.0)),
                         [](const auto& of) {
                           return scenes()[std::get<0>(of.param)].name +
                                  (std::get<1>(of.param) == 0 ? "_standing" : "_turning");
                         });

}  // namespace
}  // namespace hapticut::near_blocks_test
