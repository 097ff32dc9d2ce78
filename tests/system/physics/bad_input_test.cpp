// SPDX-License-Identifier: Apache-2.0
// What the step does with rubbish: a status bit, no force, and an untouched workpiece.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "support/cutting.hpp"
#include "support/places.hpp"

namespace hapticut::bad_input_test {
namespace {

using test::plain_material;
using units::mm;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class BadInput : public testing::Test {
 protected:
  /// A ball that has cut its way 0.3 mm into a block.
  BadInput()
      : simulation_(build_block({Vec3(-2, -2, -2) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, plain_material()),
                    Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{2000 * units::rad_per_s})) {
    for (int i = 0; i < 150; ++i) (void)simulation_.step(at(i), {Vec3(0, 0, -2 * mm), Vec3::Zero()}, 1e-3);
    before_ = simulation_.workpiece().hash();
  }
  static Pose at(int i) { return Pose::from_translation(Vec3(0.013, 0.007, 1) * mm - Vec3(0, 0, 2e-6) * (i + 1)); }

  void expect_rejected(const Pose& pose, const Twist& velocity, double dt, StepStatus bit) {
    const StepResult& result = simulation_.step(pose, velocity, dt);
    EXPECT_TRUE(has_any(result.status, bit));
    EXPECT_EQ(result.force, Vec3::Zero().eval());
    EXPECT_EQ(result.torque, Vec3::Zero().eval());
    EXPECT_TRUE(result.removed_voxels.empty());
    EXPECT_EQ(result.removed_volume, 0);
    EXPECT_EQ(simulation_.workpiece().hash(), before_);
  }
  void expect_works_again() {
    const StepResult& result = simulation_.step(at(150), {Vec3(0, 0, -2 * mm), Vec3::Zero()}, 1e-3);
    EXPECT_FALSE(has_any(result.status, kRejected));
    EXPECT_GT(result.force.z(), 0);
    EXPECT_GT(result.removed_volume, 0);
  }

  Simulation simulation_;
  std::uint64_t before_ = 0;
};

TEST_F(BadInput, APoseThatIsNotFiniteIsRejected) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    Pose pose = at(150);
    pose.translation.y() = bad;
    expect_rejected(pose, {}, 1e-3, StepStatus::pose_rejected);
    pose = at(150);
    pose.rotation(1, 2) = bad;
    expect_rejected(pose, {}, 1e-3, StepStatus::pose_rejected);
  }
  expect_works_again();
}

TEST_F(BadInput, AMatrixThatIsNoRotationIsRejected) {
  for (const Mat3& bad : {Mat3(1.01 * Mat3::Identity()), Mat3(Mat3::Zero()), Mat3(Vec3(1, 1, -1).asDiagonal())}) {
    Pose pose = at(150);
    pose.rotation = bad;
    expect_rejected(pose, {}, 1e-3, StepStatus::pose_rejected);
  }
  expect_works_again();
}

TEST_F(BadInput, AVelocityThatIsNotFiniteOrOfNoHandIsRejected) {
  expect_rejected(at(150), {Vec3(kNan, 0, 0), Vec3::Zero()}, 1e-3, StepStatus::velocity_rejected);
  expect_rejected(at(150), {Vec3::Zero(), Vec3(0, kInfinity, 0)}, 1e-3, StepStatus::velocity_rejected);
  for (const double speed : {1e7, 1e39, 1e300}) {
    expect_rejected(at(150), {Vec3(0, 0, -speed), Vec3::Zero()}, 1e-3, StepStatus::velocity_rejected);
    expect_rejected(at(150), {Vec3::Zero(), Vec3(speed, 0, 0)}, 1e-3, StepStatus::velocity_rejected);
  }
  expect_works_again();
}

TEST_F(BadInput, AStepOfNoNegativeOrTenSecondsIsRejected) {
  for (const double dt : {0.0, -1e-3, 10.0, kNan, kInfinity}) expect_rejected(at(150), {}, dt, StepStatus::dt_rejected);
  expect_works_again();
}

TEST_F(BadInput, AfterAJumpTheToolGoesOnWhereTheHandIsThereAgain) {
  expect_rejected(Pose::from_translation(Vec3(0, 0, 500) * mm), {}, 1e-3, StepStatus::jump_rejected);
  expect_rejected(Pose::from_translation(Vec3(1e300, 0, 0)), {}, 1e-3, StepStatus::jump_rejected);
  expect_works_again();
}

TEST_F(BadInput, AfterAJumpTheNextStepStartsFromThere) {
  const Pose there = Pose::from_translation(Vec3(0, 0, 500) * mm);
  expect_rejected(there, {}, 1e-3, StepStatus::jump_rejected);
  EXPECT_EQ(simulation_.step(there, {}, 1e-3).status, StepStatus::ok);
}

TEST_F(BadInput, AHeadThatTurnsIsNotPutIntoMaterial) {
  const Pose out = Pose::from_translation(Vec3(0, 0, 500) * mm), inside = Pose::from_translation(Vec3(1, 1, -1) * mm);
  expect_rejected(out, {}, 1e-3, StepStatus::jump_rejected);
  EXPECT_EQ(simulation_.step(out, {}, 1e-3).status, StepStatus::ok);
  for (int n = 0; n < 10; ++n) expect_rejected(inside, {}, 1e-3, StepStatus::tool_waits);
  const std::string told = sentences_of(simulation_.last_result().status);
  EXPECT_NE(told.find("bring it out of the material"), std::string::npos) << told;
  EXPECT_EQ(simulation_.step(out, {}, 1e-3).status, StepStatus::ok);
  simulation_.halt_spindle();
  expect_rejected(inside, {}, 1e-3, StepStatus::jump_rejected);
  EXPECT_GT(simulation_.step(inside, {}, 1e-3).contact.voxels, 0) << "a standing one cuts nothing there";
}

TEST_F(BadInput, AWayThatWasMadeDuringRefusedInputsIsNotSweptAtOnce) {
  const Pose on_top = Pose::from_translation(Vec3(0, 0, 5) * mm);
  simulation_.step(on_top, {}, 1e-3);  // a jump
  EXPECT_EQ(simulation_.step(on_top, {}, 1e-3).status, StepStatus::ok);
  for (int n = 0; n < 3; ++n) simulation_.step(on_top, {Vec3(kNan, 0, 0), Vec3::Zero()}, 1e-3);
  expect_rejected(Pose::from_translation(Vec3(0, 0, 2.5) * mm), {}, 1e-3, StepStatus::jump_rejected);
  EXPECT_EQ(simulation_.step(on_top, {}, 1e-3).status, StepStatus::ok);
}

TEST_F(BadInput, APoseAnywhereInTheUniverseIsAcceptedAsTheFirst) {
  Simulation fresh(simulation_.workpiece().clone(), simulation_.tool());
  const StepResult& result = fresh.step(Pose::from_translation(Vec3(1e30, -1e200, 1e300)), {}, 1e-3);
  EXPECT_EQ(result.contact.voxels, 0);
  EXPECT_EQ(result.force, Vec3::Zero().eval());
}

TEST(ToolAndWorkpiece, AToolWhollyOutsideFeelsNothing) {
  Simulation simulation(build_block({Vec3(-1, -1, -1) * mm, Vec3(1, 1, 1) * mm}, 0.1 * mm, plain_material()),
                        Tool(SphereHead{0.5 * mm}, RayHandle{0}, Spindle{2000 * units::rad_per_s}));
  const StepResult& result = simulation.step(Pose::from_translation(Vec3(0, 0, 1.6) * mm), {}, 1e-3);
  EXPECT_EQ(result.status, StepStatus::ok);
  EXPECT_EQ(result.contact.voxels, 0);
  EXPECT_EQ(result.force, Vec3::Zero().eval());
}

TEST(ToolAndWorkpiece, AToolWhollyInsideIsPushedToNoSide) {
  Simulation simulation(build_block({Vec3(-3, -3, -3) * mm, Vec3(3, 3, 3) * mm}, 0.1 * mm, plain_material()),
                        Tool(SphereHead{1 * mm}));
  const StepResult& result = simulation.step(Pose{}, {}, 1e-3);
  EXPECT_GT(result.contact.voxels, 4000);
  // Symmetric grid, symmetric ball: the springs cancel, to single-precision rounding of their sum of about 20 kN.
  EXPECT_LT(result.force.norm(), 0.1);
}

TEST(ToolAndWorkpiece, AToolOfZeroSizeIsRefused) {
  EXPECT_THROW(Tool(SphereHead{0}), Error);
  EXPECT_THROW(Tool(ConeHead{0, 1 * mm}), Error);
  EXPECT_THROW(Tool(FlatHead{1 * mm, 0}), Error);
}

TEST(ToolAndWorkpiece, AToolThinnerThanAVoxelIsRefused) {
  EXPECT_THROW(Simulation(build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, 0.1 * mm, plain_material()),
                          Tool(SphereHead{0.04 * mm})),
               Error);
}

TEST(ToolAndWorkpiece, AToolOfMoreVoxelsThanMemoryHasIsRefused) {
  const auto with = [](const ToolHead& head) {
    Simulation(build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, 0.1 * mm, plain_material()), Tool(head));
  };
  EXPECT_NO_THROW(with(SphereHead{5 * mm}));
  for (const double radius : {1.0, 1e10, 1e300}) EXPECT_THROW(with(SphereHead{radius}), Error);
  EXPECT_THROW(with(FlatHead{1 * mm, 1.0}), Error);
  try {
    with(SphereHead{1});  // a millimetre, meant
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("reach of the head [m] = 1; must be <= 0.3"), std::string::npos) << message;
    EXPECT_NE(message.find("in metres: 1 mm is 0.001"), std::string::npos) << message;
  }
  try {
    with(SphereHead{0.2});
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("spans 4000 x 4000 x 4000 voxels; must be at most 1e+09"), std::string::npos) << message;
    EXPECT_NE(message.find("in metres"), std::string::npos) << message;
  }
}

TEST(ToolAndWorkpiece, SizesThatMustHaveBeenMeantInMillimetresAreRefused) {
  const auto message_of = [](const auto& make) {
    try {
      make();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string handle = message_of([] { (void)Tool(SphereHead{1 * mm}, RayHandle{20}); });
  EXPECT_NE(handle.find("length of the handle [m] = 20; must be <= 5"), std::string::npos) << handle;
  const std::string voxel = message_of([] {
    (void)build_block({Vec3::Zero(), Vec3(20, 20, 20)}, 0.1, plain_material());
  });
  EXPECT_NE(voxel.find("Sizes are in metres: 0.1 mm is 0.0001"), std::string::npos) << voxel;
  EXPECT_EQ(message_of([] { (void)Tool(SphereHead{0.1}, RayHandle{1}); }), "accepted");
}

TEST(ToolAndWorkpiece, AnEmptyWorkpieceIsRefused) {
  Workpiece nothing = Workpiece::from_blocks({{0, 0, 0}, {15, 15, 15}}, GridFrame{}, MaterialTable({plain_material()}),
                                             [](const VoxelIndex&, BlockContent&) { return BlockKind::empty(); });
  EXPECT_THROW(Simulation(std::move(nothing), Tool(SphereHead{1 * mm})), Error);
}

TEST(ToolAndWorkpiece, AVoxelSizeOfZeroIsRefused) {
  EXPECT_THROW((void)build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, 0, plain_material()), Error);
  EXPECT_THROW((void)build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, kNan, plain_material()), Error);
}

TEST(ToolAndWorkpiece, AConfigurationOutOfRangeIsRefusedByName) {
  SimulationConfig config;
  config.reference_stiffness = -1;
  try {
    Simulation(build_block({Vec3::Zero(), Vec3(1, 1, 1) * mm}, 0.1 * mm, plain_material()), Tool(SphereHead{1 * mm}),
               config);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("reference_stiffness"), std::string::npos) << error.what();
  }
}

TEST(BlockPool, WhenItIsExhaustedMaterialIsFeltButNotCutAndTheStatusSaysSo) {
  SimulationConfig config;
  config.reserved_blocks = 2;
  Simulation simulation(build_block({Vec3(-3, -3, -3) * mm, Vec3(3, 3, 0) * mm}, 0.1 * mm, plain_material()),
                        Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{2000 * units::rad_per_s}), config);
  const auto step = [&](int i) -> const StepResult& {
    return simulation.step(Pose::from_translation(Vec3(0.013, 0.007, 1 - 0.002 * (i + 1)) * mm),
                           {Vec3(0, 0, -2 * mm), Vec3::Zero()}, 1e-3);
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

TEST(StepStatusText, StandsInThePageOfTheStep) {
  std::ifstream page(test::source_path("docs/step.md"));
  const std::string text(std::istreambuf_iterator<char>(page), {});
  for (const auto& bit : names_of(Of<StepStatus>())) {
    if (bit.value == StepStatus::ok) continue;
    EXPECT_NE(text.find("| `" + std::string(bit.name) + "` | " + std::string(bit.words) + " |"), std::string::npos)
        << bit.name;
  }
}

}  // namespace
}  // namespace hapticut::bad_input_test
