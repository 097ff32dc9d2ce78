// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/heat/heat_collector.hpp"
#include "hapticut/islands/islands.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "support/allocation_count.hpp"
#include "support/laws.hpp"
#include "support/named_material.hpp"
#include "support/scenes.hpp"

namespace hapticut::no_allocation_test {
namespace {

constexpr int kSteps = 10000;

/// Keeps the compiler from optimising an allocation away.
void escape(void* p) { asm volatile("" : : "g"(p) : "memory"); }

TEST(CallCounts, SeeEveryKindOfAllocationAndLock) {
  test::arm_call_counts();
  auto integer = std::make_unique<int>(3);
  std::vector<double> numbers(10);
  auto* bytes = static_cast<char*>(std::malloc(10));
  struct alignas(128) Wide {
    char c[128];
  };
  auto wide = std::make_unique<Wide>();
  for (void* p : {static_cast<void*>(integer.get()), static_cast<void*>(numbers.data()), static_cast<void*>(bytes),
                  static_cast<void*>(wide.get())})
    escape(p);
  std::free(bytes);
  std::mutex mutex;
  mutex.lock();
  const test::CallCounts counts = test::disarm_call_counts();
  mutex.unlock();
  EXPECT_GE(counts.allocations, 4);
  EXPECT_GE(counts.deallocations, 1);
  EXPECT_EQ(counts.locks, 1);
}

/// Expects that an action does not allocate, free or lock.
template <class Work>
void expect_no_calls(const Work& work) {
  test::arm_call_counts();
  work();
  const test::CallCounts counts = test::disarm_call_counts();
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.deallocations, 0);
  EXPECT_EQ(counts.locks, 0);
}

class NoAllocation : public testing::TestWithParam<std::string> {};

TEST_P(NoAllocation, In10000StepsOfTheScene) {
  const test::Scene& scene = test::find_scene(GetParam());
  Simulation simulation = scene.make();
  std::vector<StepInput> inputs;
  for (int tick = 0; tick < kSteps; ++tick) inputs.push_back(scene.input(tick));

  double removed = 0;
  int contacts = 0;
  StepStatus status = StepStatus::ok;
  expect_no_calls([&] {
    for (const StepInput& input : inputs) {
      const StepResult& result = simulation.step(input.X_WH, input.V_WH, input.dt);
      removed += result.removed_volume;
      contacts += result.contact.voxels > 0 ? 1 : 0;
      status |= result.status;
    }
  });
  EXPECT_GT(contacts, kSteps / 10) << "the scene must have contacts, else the test proves nothing";
  if (simulation.tool().spindle().speed != 0) {
    EXPECT_GT(removed, 0);
  }
  EXPECT_FALSE(has_any(status, StepStatus::blocks_exhausted | StepStatus::removed_list_full));
}

TEST(NoAllocation, WhileCollectedHeatAndChangedBlocksAreNotRead) {
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  HeatCollectorOptions options;
  options.pulses = 100;
  options.blocks.block_capacity = 50;
  HeatCollector collector(simulation, options);
  double removed = 0;
  expect_no_calls([&] {
    for (int tick = 0; tick < 2000; ++tick) {
      const StepInput input = scene.input(tick);
      removed += simulation.step(input.X_WH, input.V_WH, input.dt).removed_volume;
    }
  });
  EXPECT_GT(removed, 0);
  HeatPulse pulse;
  EXPECT_TRUE(collector.receive(pulse));
}

TEST(NoAllocation, WhileDistancesAreMeasuredAndMaterialsAreFirstTouched) {
  const Box box{Vec3(-2, -2, -3) * units::mm, Vec3(2, 2, 0) * units::mm};
  std::vector<Layer> layers;
  for (int n = 0; n < 20; ++n) layers.push_back({test::named("layer " + std::to_string(n)), 0.1 * units::mm});
  Simulation simulation(build_layered_slab(box, 0.1 * units::mm, layers),
                        test::tool_of(SphereHead{0.5 * units::mm}, test::kSpin));
  double sum = 0;
  int hits = 0;
  expect_no_calls([&] {
    for (int n = 0; n < 500; ++n) {
      const Pose X_WH = Pose::from_translation(Vec3(0, 0, 0.55 * units::mm - 2e-6 * n));
      (void)simulation.step(X_WH, {Vec3(0, 0, -2e-3), Vec3::Zero()}, 1e-3);
      sum += simulation.distance_to(20, X_WH) + simulation.distance_to(kEmpty, X_WH, 1 * units::mm);
      hits += simulation.workpiece().first_hit(X_WH.translation, Vec3(0.1, 0.2, -1), 1, 20).has_value() ? 1 : 0;
    }
  });
  EXPECT_GT(sum, 0);
  EXPECT_EQ(hits, 500);
  EXPECT_GT(simulation.totals().touched.size(), 5);
}

TEST(NoAllocation, WhileAnIslandLeavesBetweenSteps) {
  const double voxel = 0.1 * units::mm;
  Workpiece bar = build_block({Vec3::Zero(), voxel * Vec3(24, 24, 80)}, voxel, test::named("bone"));
  Simulation simulation(std::move(bar), Tool(SphereHead{0.6 * units::mm}));
  simulation.history().reserve(100);
  simulation.history().mark();
  BlockVoxels layer;  // between the two halves
  for (int x = 0; x < kBlockEdge; ++x)
    for (int y = 0; y < kBlockEdge; ++y) layer.voxels.add(block_offset(x, y, 0));
  for (const int x : {0, 8, 16})
    for (const int y : {0, 8, 16}) {
      layer.origin = {x, y, 48};
      ASSERT_TRUE(simulation.remove_voxels(layer));
    }
  const std::vector<Island> islands = find_islands(simulation.workpiece());
  ASSERT_EQ(islands.size(), 1U);
  IslandRemoval removal{islands[0]};
  expect_no_calls([&] {
    while (!remove_island(simulation, removal, 5)) {
    }
  });
  EXPECT_FALSE(removal.joined);
  EXPECT_EQ(simulation.workpiece().solid_voxels(), 24 * 24 * 48);
}

TEST(NoAllocationOnBadInput, WhenTheInputIsRejectedOrThePoolIsExhausted) {
  const test::Scene& scene = test::find_scene("deep_ball");
  Simulation simulation = scene.make();
  StepInput bad = scene.input(0);
  bad.X_WH.translation.x() = std::nan("");
  expect_no_calls([&] {
    (void)simulation.step(bad.X_WH, bad.V_WH, bad.dt);
    (void)simulation.step(scene.input(0).X_WH, {}, -1);
    (void)simulation.step(Pose::from_translation(Vec3(1, 1, 1)), {}, 1e-3);
    (void)simulation.step(Pose::from_translation(Vec3(-1, 1, 1)), {}, 1e-3);
  });
}

TEST(NoAllocationWithEveryTerm, WhileTheSpindleStartsAndStops) {
  SimulationConfig config;
  config.effects.gravity = Gravity{0.05};
  config.effects.vibration = Vibration{};
  config.effects.delta_filter = DeltaFilter{};
  config.effects.limits = {3, 0.1, 1000, 100, 0.1};
  config.handle_torque = HandleTorque::thesis;
  Spindle spindle{0, 5, 100, 1e3};
  Simulation simulation(
      build_block({Vec3(-5, -5, -5) * units::mm, Vec3(5, 5, 0) * units::mm}, test::kVoxel, test::named("bone")),
      Tool(SphereHead{1e-3}, LHandle{0.1, 0.02, 1.2}, spindle), config);
  const Pose X_TH = simulation.tool().X_HT().inverse();
  int standing = 0, between = 0, spinning = 0;
  expect_no_calls([&] {
    for (int tick = 0; tick < kSteps; ++tick) {
      if (tick % 500 == 0) simulation.spindle().set_speed((tick % 1000 == 0 ? 0 : 20) * units::rad_per_s);
      const double t = 1e-3 * tick;
      const Vec3 head(2e-3 * std::sin(t), 2e-3 * std::cos(t), 0.9e-3);
      const StepResult& result = simulation.step(Pose::from_translation(head) * X_TH, {}, 1e-3);
      const double fraction = dry_friction_fraction(result.spindle.speed, 1e-3);
      ++(fraction == 1 ? standing : fraction == 0 ? spinning : between);
    }
  });
  EXPECT_GT(std::min({standing, between, spinning}), kSteps / 20);
  EXPECT_GT(simulation.last_result().energy.sliding, 0);
}

TEST(NoAllocationOfAnyLaw, WhileItCuts) {
  for (const test::NamedLaw& named : test::all_laws()) {
    SCOPED_TRACE(named.name);
    SimulationConfig config;
    config.law = named.law;
    Simulation simulation(
        build_block({Vec3(-2, -2, -3) * units::mm, Vec3(2, 2, 0) * units::mm}, test::kVoxel, test::named("bone")),
        test::tool_of(named.head, test::kSpin), config);
    const double lowest = named.head.bounding_box().min.z();
    double removed = 0;
    expect_no_calls([&] {
      for (int tick = 0; tick < 1000; ++tick) {
        const Vec3 head(1e-4 * std::sin(0.01 * tick), 0, -lowest - 1e-6 * tick);
        removed += simulation.step(Pose::from_translation(head), {}, 1e-3).removed_volume;
      }
    });
    EXPECT_GT(removed, 0);
  }
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const test::Scene& scene : test::scenes()) names.push_back(scene.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, NoAllocation, testing::ValuesIn(scene_names()),
                         [](const auto& scene) { return scene.param; });

TEST(NoAllocation, InStepsOfAVirtualCoupling) {
  SimulationConfig config = test::on_foundation(1e16);
  config.contact_time = ContactTime::end;
  const Box box{Vec3(-4e-3, -4e-3, -4e-3), Vec3(4e-3, 4e-3, 0)};
  Simulation simulation(build_block(box, test::kVoxel, test::plain_material()),
                        Tool(SphereHead{1e-3}, RayHandle{20e-3}, Spindle{2000 * units::rad_per_s}), config);
  CouplingGains gains;
  gains.angular_stiffness = 0.3;
  VirtualCoupling coupling(simulation, gains);
  double removed = 0;
  expect_no_calls([&] {
    for (int n = 0; n < 2000; ++n) {
      const double z = 22e-3 - 4e-6 * n;
      removed += coupling.step(Pose::from_translation({1e-6 * n, 0, z}), {Vec3(1e-3, 0, -4e-3), Vec3::Zero()}, 1e-3)
                     .removed_volume;
    }
  });
  EXPECT_GT(removed, 1e-9);
}

}  // namespace
}  // namespace hapticut::no_allocation_test
