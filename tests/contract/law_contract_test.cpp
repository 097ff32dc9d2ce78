// SPDX-License-Identifier: Apache-2.0
// Contract of every force law, on which the step relies.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/random_pose.hpp"
#include "hapticut/contact/cut_voxel.hpp"
#include "support/cut_scene.hpp"
#include "support/laws.hpp"
#include "support/refusal.hpp"

namespace hapticut::law_contract_test {
namespace {

using test::NamedLaw;
using units::deg;
using units::mm;

constexpr double kTick = 1e-3;
constexpr double kSpin = 2000;  // [rad/s]

/// A path of the head over a block whose surface is z = 0: down, to the side, and out again.
struct Cut {
  double spin = kSpin;
  RemovalLaw removal = RemovalLaw::constant_energy;
  double side = 0.4 * mm;
  int ticks = 500;
};

struct Outcome {
  std::vector<Wrench> wrenches;  // about To
  double removed = 0;
  EnergyLedger energy;
  double turnover = 0;  // [J] sum of the absolute changes of both works
  double min_loss = 0;  // [J] the smallest change of a dissipation in a step; negative if a dissipation decreased
};

Vec3 head_at(const Cut& cut, int tick) {
  const double t = tick;
  if (t <= 200) return {0.03 * mm, 0.02 * mm, -0.002 * mm * t};
  if (t <= 400) return {0.03 * mm + cut.side * (t - 200) / 200, 0.02 * mm, -0.4 * mm};
  return {0.03 * mm + cut.side, 0.02 * mm, -0.4 * mm + 0.006 * mm * (t - 400)};
}

Outcome run(const NamedLaw& named, const Cut& cut) {
  SimulationConfig config;
  config.law = named.law;
  config.removal = cut.removal;
  const double l = 0.1 * mm;
  const GridFrame frame{l, Pose::from_translation(Vec3::Constant(0.5 * l))};
  const IndexBox domain{{-24, -24, -24}, {23, 23, -1}};
  Material material = test::plain_material();
  material.static_friction = material.dynamic_friction = 0;
  Workpiece workpiece = Workpiece::from_blocks(domain, frame, MaterialTable({material}),
                                               [](const VoxelIndex&, BlockContent&) { return BlockKind::solid(1); });
  Simulation simulation(std::move(workpiece), Tool(named.head, RayHandle{0}, Spindle{cut.spin * units::rad_per_s}),
                        config);
  const double lowest = named.head.bounding_box().min.z();
  Outcome outcome;
  auto before = test::losses({});
  double hand = 0, motor = 0;
  Vec3 last = head_at(cut, 0);
  for (int tick = 1; tick <= cut.ticks; ++tick) {
    const Vec3 at = head_at(cut, tick);
    const Pose X_WT = Pose::from_translation(at - Vec3(0, 0, lowest));
    const StepResult& result = simulation.step(X_WT, {(at - last) / kTick, Vec3::Zero()}, kTick);
    last = at;
    EXPECT_FALSE(has_any(result.status, kRejected | StepStatus::blocks_exhausted));
    EXPECT_TRUE(is_finite(result.force) && is_finite(result.torque));
    outcome.wrenches.push_back({result.force, result.torque});
    outcome.removed += result.removed_volume;
    outcome.turnover += std::abs(result.energy.hand_work - hand) + std::abs(result.energy.motor_work - motor);
    hand = result.energy.hand_work, motor = result.energy.motor_work;
    const auto after = test::losses(result.energy);
    for (std::size_t i = 0; i < after.size(); ++i) outcome.min_loss = std::min(outcome.min_loss, after[i] - before[i]);
    before = after;
  }
  outcome.energy = simulation.last_result().energy;
  return outcome;
}

class LawContract : public testing::TestWithParam<NamedLaw> {
 protected:
  const NamedLaw& named() const { return GetParam(); }
};

/// One block full of random samples.
/// @param parts  whether the samples are parts of voxels, along the axes of the grid; otherwise they are points
ContactBlock random_block(test::RandomPoses& random, bool parts, float voxel_size) {
  ContactBlock block;
  block.sub_voxel = parts;
  block.rows = kBlockRows;
  block.samples = kBlockVoxels;
  block.one_material = 1;
  for (int i = 0; i < kBlockVoxels; ++i) {
    const auto n = std::size_t(i);
    const Vec3 p = random.vector(0.8 * mm), normal = random.vector(1).normalized();
    block.x[n] = float(p.x()), block.y[n] = float(p.y()), block.z[n] = float(p.z());
    block.normal_x[n] = float(normal.x()), block.normal_y[n] = float(normal.y()), block.normal_z[n] = float(normal.z());
    const bool empty = i % 5 == 0;
    block.depth[n] = empty ? 0.0F : float(random.between(0, 0.3) * mm);
    block.fill[n] = empty ? 0.0F : float(random.between(0.01, 1));
    block.max_component[n] = float(normal.cwiseAbs().maxCoeff());
    const VoxelSection<float> section(block.max_component[n], block.min_width);
    const float above_middle = section.height_of(block.fill[n]) - section.span() / 2;
    block.top[n] = empty ? 0.0F : block.depth[n] + voxel_size * above_middle;
    block.force_x[n] = block.force_y[n] = block.force_z[n] = block.fill_after[n] = 99;  // must be overwritten
  }
  for (int row = 0; row < kBlockRows; ++row) {
    block.row[std::size_t(row)] = std::uint8_t(row);
    block.inside[std::size_t(row)] = 0xff;
  }
  return block;
}

// Proves: contract of every law.
TEST_P(LawContract, NeverAddsMaterial) {
  test::RandomPoses random(3);
  ContactMaterials materials = {};
  materials[0].cutting_energy = 1;
  materials[1] = {1e13F, 2, 0.5F, 3e8F, 0};
  for (const float spin : {0.0F, 2000.0F, -2000.0F})
    for (const RemovalLaw removal : {RemovalLaw::none, RemovalLaw::constant_energy, RemovalLaw::elastic_release}) {
      ContactBlock block = random_block(random, named().law->integrates_parts(), 1e-4F);
      HeadMotion motion{Eigen::Vector3f(0.001F, 0.002F, -0.003F),
                        Eigen::Vector3f(0.1F, 0, 0),
                        {0, 0, -0.003F},
                        {0, 0, 0},
                        spin,
                        1e-3F,
                        1e-4F,
                        removal,
                        8e-4F};
      WholeContact whole;
      if (named().law->needs_moments()) {
        add_moments(block, motion, materials, whole.moments);
        whole.lumped = named().law->lump(named().head, motion, whole.moments);
        motion.whole = &whole;
      }
      const LawTotals totals = named().law->evaluate(motion, materials, block);
      for (int i = 0; i < block.lanes(); ++i) {
        const auto n = std::size_t(i);
        ASSERT_TRUE(std::isfinite(block.force_x[n] + block.force_y[n] + block.force_z[n]));
        ASSERT_GE(block.fill_after[n], 0);
        ASSERT_LE(block.fill_after[n], block.fill[n]);
        if (spin == 0 || removal == RemovalLaw::none || !totals.may_remove) {
          ASSERT_EQ(block.fill_after[n], block.fill[n]);
        }
        if (block.fill[n] == 0) {
          ASSERT_EQ(std::abs(block.force_x[n]) + std::abs(block.force_y[n]) + std::abs(block.force_z[n]), 0);
        }
      }
    }
}

// Proves: contract of every law.
TEST_P(LawContract, PushesBackWhereItIsPressedInAndOpposesTheSpin) {
  for (const double spin : {kSpin, -kSpin}) {
    Cut cut;
    cut.spin = spin;
    cut.ticks = 200;
    const Outcome outcome = run(named(), cut);
    Wrench mean;
    for (int tick = 100; tick < 200; ++tick) {
      mean.force += outcome.wrenches[std::size_t(tick)].force / 100;
      mean.torque += outcome.wrenches[std::size_t(tick)].torque / 100;
    }
    EXPECT_GT(mean.force.z(), 1e-3);
    if (named().name != "DampingMatrix") {
      EXPECT_LT(mean.torque.z() * spin, 0);
    }
  }
}

// Proves: contract of every law.
TEST_P(LawContract, CutsWhileItSpinsAndOnlyThen) {
  Cut cut;
  EXPECT_GT(run(named(), cut).removed, 0);
  cut.removal = RemovalLaw::none;
  EXPECT_EQ(run(named(), cut).removed, 0);
  cut.spin = 0;
  cut.removal = RemovalLaw::constant_energy;
  EXPECT_EQ(run(named(), cut).removed, 0);
}

// The limit for every combination of the model is 0.5 %.
// Proves: contract of every law.
TEST_P(LawContract, ClosesItsEnergyLedgerAndHasNoNegativeLoss) {
  for (const RemovalLaw removal : {RemovalLaw::constant_energy, RemovalLaw::none})
    for (const double spin : {kSpin, -kSpin, 0.0}) {
      Cut cut;
      cut.removal = removal;
      cut.spin = spin;
      const Outcome outcome = run(named(), cut);
      const EnergyLedger& e = outcome.energy;
      EXPECT_LE(std::abs(e.imbalance()), 5e-3 * outcome.turnover)
          << "spin " << spin << " hand " << e.hand_work << " motor " << e.motor_work << " elastic " << e.elastic
          << " cutting " << e.cutting << " released " << e.released << " damping " << e.damping << " rubbing "
          << e.rubbing << " credited " << e.credited;
      if (named().always_loses || spin == 0) {
        EXPECT_GE(outcome.min_loss, -1e-9 * outcome.turnover);
      }
    }
}

// Proves: contract of every law.
TEST_P(LawContract, RepeatsBitByBitAndHasNoForceInTheAir) {
  const Outcome a = run(named(), {}), b = run(named(), {});
  ASSERT_EQ(a.wrenches.size(), b.wrenches.size());
  for (std::size_t n = 0; n < a.wrenches.size(); ++n) {
    ASSERT_EQ(a.wrenches[n].force, b.wrenches[n].force);
    ASSERT_EQ(a.wrenches[n].torque, b.wrenches[n].torque);
  }
  EXPECT_EQ(a.removed, b.removed);
  EXPECT_EQ(a.wrenches.back().force, Vec3(0, 0, 0)) << "the path ends 0.2 mm above the surface";
  EXPECT_EQ(a.wrenches.back().torque, Vec3(0, 0, 0));
}

INSTANTIATE_TEST_SUITE_P(Laws, LawContract, testing::ValuesIn(test::all_laws()),
                         [](const auto& named) { return named.param.name; });

// --- heads without a formula, constants out of range -----------------------------------------------------------------

Simulation with(const std::shared_ptr<const ForceLaw>& law, const ToolHead& head) {
  SimulationConfig config;
  config.law = law;
  return Simulation(build_block({Vec3(-1, -1, -1) * mm, Vec3(1, 1, 0) * mm}, 0.1 * mm, test::plain_material()),
                    Tool(head), config);
}

TEST(LawInput, AHeadWithoutAFormulaIsRefusedNamingThoseThatHaveOne) {
  using test::expect_refused;
  const auto mechanics = std::make_shared<ContactMechanicsLaw>(1e6);
  const auto drill = std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{});
  expect_refused([] { with(std::make_shared<HertzianBurrLaw>(1e6), ConeHead{0.5, 1 * mm}); }, {"round burr only"});
  expect_refused([&] { with(drill, SphereHead{1 * mm}); },
                 {"was given a sphere of radius 1 mm", "a cone, a flat head and a profile"});
  expect_refused([&] { with(mechanics, round_end_cylinder_head(1 * mm, 2 * mm)); },
                 {"was given a profile of radius 0.5 mm and height 2 mm"});
  EXPECT_NO_THROW(with(mechanics, SphereHead{1 * mm}));
}

TEST(LawInput, ConstantsOutOfRangeAreRefused) {
  using test::expect_refused;
  expect_refused([] { ContactMechanicsLaw law(-1); }, {"effective_modulus [Pa]"});
  expect_refused([] { HertzianBurrLaw law(0); }, {"stiffness [Pa]"});
  expect_refused([] { DampingMatrixLaw law({1e8, -0.1}); }, {"friction [1]"});
  expect_refused([] { DampingMatrixLaw law({0, 0.1}); }, {"resistance"});
  expect_refused([] { TwistDrillLaw law({-1, 1}); }, {"specific_energy"});
  ThesisLaw::Constants damping, size;
  damping.damping = -1;
  expect_refused([&] { ThesisLaw law(damping); }, {"ThesisLaw::damping"});
  size.reference_voxel_size = 0;
  expect_refused([&] { ThesisLaw law(size); }, {"reference_voxel_size"});
}

}  // namespace
}  // namespace hapticut::law_contract_test
