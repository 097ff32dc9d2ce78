// SPDX-License-Identifier: Apache-2.0
// Invalid input of a step: a status bit, no force, and an untouched workpiece.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "experiments/setup/cutting.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "support/places.hpp"
#include "support/refusal.hpp"

namespace hapticut::bad_input_test {
namespace {

using namespace test;
using units::mm;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class BadInput : public testing::Test {
 protected:
  /// A ball that has cut 0.3 mm into a block.
  BadInput() : simulation_(plain_block(), tool_of(SphereHead{kRadius}, kSpin)) {
    for (int i = 0; i < 150; ++i) (void)simulation_.step(at(i), down_, kTick);
    before_ = simulation_.workpiece().hash();
  }
  static Pose at(int i) { return Pose::from_translation(Vec3(0.013, 0.007, 1) * mm - Vec3(0, 0, 2e-6) * (i + 1)); }

  void expect_rejected(StepStatus bit, const Pose& pose, const Twist& velocity = {}, double dt = kTick) {
    const StepResult& result = simulation_.step(pose, velocity, dt);
    EXPECT_TRUE(has_any(result.status, bit));
    EXPECT_EQ(result.force, Vec3::Zero().eval());
    EXPECT_EQ(result.torque, Vec3::Zero().eval());
    EXPECT_TRUE(result.removed_voxels.empty());
    EXPECT_EQ(result.removed_volume, 0);
    EXPECT_EQ(simulation_.workpiece().hash(), before_);
  }
  void expect_works_again() {
    const StepResult& result = simulation_.step(at(150), down_, kTick);
    EXPECT_FALSE(has_any(result.status, kRejected));
    EXPECT_GT(result.force.z(), 0);
    EXPECT_GT(result.removed_volume, 0);
  }

  const Twist down_ = {Vec3(0, 0, -kFeed), Vec3::Zero()};
  Simulation simulation_;
  std::uint64_t before_ = 0;
};

TEST_F(BadInput, AnInvalidReadingIsRejectedAndTheNextStepContinues) {
  using enum StepStatus;
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    Pose pose = at(150);
    pose.translation.y() = bad;
    expect_rejected(pose_rejected, pose);
    pose = at(150);
    pose.rotation(1, 2) = bad;
    expect_rejected(pose_rejected, pose);
  }
  for (const Mat3& bad : {Mat3(1.01 * Mat3::Identity()), Mat3(Mat3::Zero()), Mat3(Vec3(1, 1, -1).asDiagonal())})
    expect_rejected(pose_rejected, {bad, at(150).translation});
  expect_rejected(velocity_rejected, at(150), {Vec3(kNan, 0, 0), Vec3::Zero()});
  expect_rejected(velocity_rejected, at(150), {Vec3::Zero(), Vec3(0, kInfinity, 0)});
  for (const double speed : {1e7, 1e39, 1e300}) {
    expect_rejected(velocity_rejected, at(150), {Vec3(0, 0, -speed), Vec3::Zero()});
    expect_rejected(velocity_rejected, at(150), {Vec3::Zero(), Vec3(speed, 0, 0)});
  }
  for (const double dt : {0.0, -1e-3, 10.0, kNan, kInfinity}) expect_rejected(dt_rejected, at(150), {}, dt);
  expect_works_again();
}

TEST_F(BadInput, AfterARejectedJumpTheToolContinuesAtItsPlace) {
  expect_rejected(StepStatus::jump_rejected, Pose::from_translation(Vec3(0, 0, 500) * mm));
  expect_rejected(StepStatus::jump_rejected, Pose::from_translation(Vec3(1e300, 0, 0)));
  expect_works_again();
}

TEST_F(BadInput, AHeadThatTurnsIsNotPutIntoMaterial) {
  const Pose out = Pose::from_translation(Vec3(0, 0, 500) * mm), inside = Pose::from_translation(Vec3(1, 1, -1) * mm);
  expect_rejected(StepStatus::jump_rejected, out);
  EXPECT_EQ(simulation_.step(out, {}, 1e-3).status, StepStatus::ok);
  for (int n = 0; n < 10; ++n) expect_rejected(StepStatus::tool_waits, inside);
  const std::string told = sentences_of(simulation_.last_result().status);
  EXPECT_NE(told.find("bring it out of the material"), std::string::npos) << told;
  EXPECT_EQ(simulation_.step(out, {}, 1e-3).status, StepStatus::ok);
  simulation_.spindle().halt();
  expect_rejected(StepStatus::jump_rejected, inside);
  EXPECT_GT(simulation_.step(inside, {}, 1e-3).contact.voxels, 0) << "a standing head cuts nothing there";
}

TEST_F(BadInput, AWayThatWasMadeDuringRejectedInputsIsNotSweptAtOnce) {
  const Pose on_top = Pose::from_translation(Vec3(0, 0, 5) * mm);
  simulation_.step(on_top, {}, 1e-3);  // a jump
  EXPECT_EQ(simulation_.step(on_top, {}, 1e-3).status, StepStatus::ok);
  for (int n = 0; n < 3; ++n) simulation_.step(on_top, {Vec3(kNan, 0, 0), Vec3::Zero()}, 1e-3);
  expect_rejected(StepStatus::jump_rejected, Pose::from_translation(Vec3(0, 0, 2.5) * mm));
  EXPECT_EQ(simulation_.step(on_top, {}, 1e-3).status, StepStatus::ok);
}

TEST_F(BadInput, APoseAnywhereInTheUniverseIsAcceptedAsTheFirst) {
  Simulation fresh(simulation_.workpiece().clone(), simulation_.tool());
  const StepResult& result = fresh.step(Pose::from_translation(Vec3(1e30, -1e200, 1e300)), {}, 1e-3);
  EXPECT_EQ(result.contact.voxels, 0);
  EXPECT_EQ(result.force, Vec3::Zero().eval());
}

TEST(ToolAndWorkpiece, AToolWhollyInsideIsPushedToNoSide) {
  Simulation simulation(build_block({Vec3(-3, -3, -3) * mm, Vec3(3, 3, 3) * mm}, kVoxel, plain_material()),
                        Tool(SphereHead{kRadius}));
  const StepResult& result = simulation.step(Pose{}, {}, 1e-3);
  EXPECT_GT(result.contact.voxels, 4000);
  // Symmetric grid, symmetric ball: the springs cancel, to single-precision rounding of their sum of about 20 kN.
  EXPECT_LT(result.force.norm(), 0.1);
}

TEST(ToolAndWorkpiece, AToolThinnerThanAVoxelOrOfMoreVoxelsThanMemoryHasIsRefused) {
  const auto with = [](const ToolHead& head) {
    return [head] { Simulation(plain_block(1 * mm, 1 * mm), Tool(head)); };
  };
  expect_refused(with(SphereHead{0.04 * mm}), {});
  EXPECT_EQ(refusal(with(SphereHead{5 * mm})), "");
  for (const double radius : {1e10, 1e300}) expect_refused(with(SphereHead{radius}), {});
  expect_refused(with(FlatHead{1 * mm, 1.0}), {});
  expect_refused(with(SphereHead{1}), {"reach of the head [m] = 1; must be <= 0.3", "in metres: 1 mm is 0.001"});
  expect_refused(with(SphereHead{0.2}), {"spans 4000 x 4000 x 4000 voxels; must be at most 1e+09", "in metres"});
}

TEST(ToolAndWorkpiece, SizesThatMustHaveBeenMeantInMillimetresAreRefused) {
  expect_refused([] { (void)Tool(SphereHead{1 * mm}, RayHandle{20}); },
                 {"length of the handle [m] = 20; must be <= 5"});
  expect_refused(
      [] {
        (void)build_block({Vec3::Zero(), Vec3(20, 20, 20)}, 0.1, plain_material());
      },
      {"Sizes are in metres: 0.1 mm is 0.0001"});
  EXPECT_EQ(refusal([] { (void)Tool(SphereHead{0.1}, RayHandle{1}); }), "");
}

TEST(ToolAndWorkpiece, AWorkpieceWithoutVoxelsOrWithVoxelsOfNoSizeIsRefused) {
  expect_refused(
      [] {
        Workpiece nothing =
            Workpiece::from_blocks({{0, 0, 0}, {15, 15, 15}}, GridFrame{}, MaterialTable({plain_material()}),
                                   [](const VoxelIndex&, BlockContent&) { return BlockKind::empty(); });
        Simulation(std::move(nothing), Tool(SphereHead{1 * mm}));
      },
      {});
  for (const double voxel : {0.0, kNan})
    expect_refused([&] { (void)build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, voxel, plain_material()); }, {});
}

TEST(BlockPool, WhenItIsExhaustedMaterialIsFeltButNotCutAndTheStatusSaysSo) {
  SimulationConfig config;
  config.reserved_blocks = 2;
  Simulation simulation(plain_block(3 * mm, 3 * mm), tool_of(SphereHead{kRadius}, kSpin), config);
  const auto step = [&](int i) -> const StepResult& {
    return step_to(simulation, Vec3(0.013, 0.007, 1 - 0.002 * (i + 1)) * mm, Vec3(0, 0, -kFeed));
  };
  int i = 0;
  StepStatus status = StepStatus::ok;
  for (; i < 200; ++i) status |= step(i).status;
  EXPECT_TRUE(has_any(status, StepStatus::blocks_low));
  EXPECT_TRUE(has_any(status, StepStatus::blocks_exhausted));
  simulation.reserve_blocks(256);
  EXPECT_FALSE(has_any(step(i).status, StepStatus::blocks_exhausted));
}

TEST(StepStatusText, NamesEveryBitThatIsSet) {
  EXPECT_EQ(describe(StepStatus::ok), "ok");
  EXPECT_EQ(describe(StepStatus::blocks_low), "blocks_low");
  EXPECT_EQ(describe(StepStatus::power_limited | StepStatus::pose_rejected), "pose_rejected | power_limited");
}

TEST(StepStatusText, IsNamedInThePagesThatExplainIt) {
  for (const char* const page : {"docs/step.md", "docs/troubleshooting.md"}) {
    std::ifstream file(test::source_path(page));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    for (const auto& bit : names_of(Of<StepStatus>())) {
      if (bit.value == StepStatus::ok) continue;
      const std::string cited = '`' + std::string(bit.name) + '`';
      EXPECT_NE(text.find(cited), std::string::npos) << cited << " in " << page;
    }
  }
}

}  // namespace
}  // namespace hapticut::bad_input_test
