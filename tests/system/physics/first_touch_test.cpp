// SPDX-License-Identifier: Apache-2.0
// The event that a material is touched for the first time: Simulation::first_touched.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "support/laws.hpp"
#include "support/named_material.hpp"

namespace hapticut::first_touch_test {
namespace {

using units::mm;

constexpr double kVoxel = 0.1 * mm, kRadius = 0.6 * mm, kFeed = 5 * mm, kTick = 1e-3;
constexpr MaterialId kFirst = 1, kSecond = 2, kThird = 3;

Material soft(const std::string& name) {
  Material material = test::plain_material();
  material.name = name;
  return material;
}

/// Layers of 0.3 mm from z = 0 down, of materials 1, 2, 3 ...
Workpiece layers(int count) {
  std::vector<Layer> all;
  for (int n = 1; n <= count; ++n) all.push_back({soft("layer " + std::to_string(n)), 0.3 * mm});
  return build_layered_slab({Vec3(-1.6, -1.6, -0.3 * count) * mm, Vec3(1.6, 1.6, 0) * mm}, kVoxel, all);
}

Tool drill() { return test::tool_of(SphereHead{kRadius}, test::kSpin); }

/// The pose after step n of a feed along -z; the ball's lowest point begins 0.1 mm above the first layer.
Pose fed(int n) { return Pose::from_translation(Vec3(0.01 * mm, 0.02 * mm, kRadius + 0.1 * mm - kFeed * n * kTick)); }
const Twist kDown = {Vec3(0, 0, -kFeed), Vec3::Zero()};

std::vector<MaterialId> ids_of(const MaterialSet& set) {
  std::vector<MaterialId> ids;
  set.for_each([&](MaterialId id) { ids.push_back(id); });
  return ids;
}

TEST(MaterialSet, HoldsEachOf255Materials) {
  MaterialSet set;
  EXPECT_TRUE(set.empty());
  for (int id = 1; id <= kMaxMaterials; id += 2) set.insert(MaterialId(id));
  for (int id = 0; id <= kMaxMaterials; ++id) EXPECT_EQ(set.has(MaterialId(id)), id % 2 == 1);
  EXPECT_EQ(set.size(), 128);
  EXPECT_EQ(ids_of(set).size(), 128U);
  EXPECT_EQ(ids_of(set).back(), 255);
  MaterialSet other;
  other.insert(MaterialId(2));
  other.insert(set);
  EXPECT_EQ(other.size(), 129);
  EXPECT_NE(other, set);
}

TEST(FirstTouch, ComesOnceForEachMaterialWhereItsDistanceBecomesZero) {
  for (const int count : {3, 12}) {
    Simulation simulation(layers(count), drill());
    std::vector<MaterialId> order;
    for (int n = 1; n <= 60 * count; ++n) {
      (void)simulation.step(fed(n), kDown, kTick);
      const MaterialSet now = simulation.first_touched();
      now.for_each([&](MaterialId id) {
        order.push_back(id);
        EXPECT_TRUE(simulation.totals().touched.has(id));
        EXPECT_EQ(simulation.totals().first_touch[id], simulation.steps());
        // The step moves the head by 0.05 voxels, and cuts.
        EXPECT_LT(simulation.distance_to(id, fed(n)), 0.1 * kVoxel) << int(id);
        EXPECT_GT(simulation.distance_to(id, fed(n - 2)), 0) << int(id);
        EXPECT_NEAR(-(fed(n).translation.z() - kRadius), 0.3 * mm * (id - 1), kVoxel) << int(id);
      });
      ASSERT_EQ(simulation.totals().touched.size(), int(order.size()));
    }
    ASSERT_EQ(order.size(), std::size_t(count));
    for (int id = 1; id <= count; ++id) EXPECT_EQ(order[std::size_t(id - 1)], id) << "from the top down";
    EXPECT_EQ(simulation.totals().first_touch[0], 0U);
  }
}

TEST(FirstTouch, OfAStepIsForgottenByTheNextOneAndNotByTheSet) {
  Simulation simulation(layers(2), drill());
  int n = 1;
  while (simulation.first_touched().empty()) (void)simulation.step(fed(n++), kDown, kTick);
  EXPECT_EQ(ids_of(simulation.first_touched()), std::vector<MaterialId>{kFirst});
  (void)simulation.step(fed(n), kDown, kTick);
  EXPECT_TRUE(simulation.first_touched().empty());
  EXPECT_EQ(ids_of(simulation.totals().touched), std::vector<MaterialId>{kFirst});
}

TEST(FirstTouch, IsThatOfEveryLawWithItsHead) {
  for (const test::NamedLaw& named : test::all_laws()) {
    SimulationConfig config;
    config.law = named.law;
    config.removal = RemovalLaw::none;
    Simulation simulation(layers(2), test::tool_of(named.head), config);
    const double lowest = named.head.bounding_box().min.z();
    bool met = false;
    for (int n = 0; n <= 200 && !met; ++n) {
      const Pose X_WH = Pose::from_translation(Vec3(0, 0, 0.1 * mm - lowest - kFeed * n * kTick));
      met = simulation.step(X_WH, kDown, kTick).contact.voxels > 0;
      EXPECT_EQ(simulation.totals().touched.has(kFirst), met) << named.name << " " << n;
    }
    EXPECT_TRUE(met) << named.name;
    EXPECT_FALSE(simulation.totals().touched.has(kSecond)) << named.name;
  }
}

TEST(FirstTouch, StaysThroughExchangesOfTheToolAndRestoresButNotThroughAReset) {
  Simulation simulation(layers(3), drill());
  const WorkpieceSnapshot whole = simulation.workpiece().snapshot();
  for (int n = 1; n <= 50; ++n) (void)simulation.step(fed(n), kDown, kTick);
  ASSERT_TRUE(simulation.totals().touched.has(kFirst));
  const std::uint64_t first = simulation.totals().first_touch[kFirst];
  simulation.set(test::tool_of(SphereHead{0.5 * mm}, test::kSpin));
  simulation.history().restore(whole);
  EXPECT_TRUE(simulation.totals().touched.has(kFirst));
  EXPECT_EQ(simulation.totals().first_touch[kFirst], first);
  simulation.reset(layers(3));
  EXPECT_TRUE(simulation.totals().touched.empty());
  EXPECT_TRUE(simulation.first_touched().empty());
  EXPECT_EQ(simulation.totals().first_touch[kFirst], 0U);
}

TEST(FirstTouch, NeedsAStepThatIsTaken) {
  Simulation simulation(layers(1), drill());
  (void)simulation.step(fed(1), kDown, kTick);
  (void)simulation.history().restore(simulation.workpiece().snapshot());
  EXPECT_TRUE(has_any(simulation.step(fed(60), kDown, kTick).status, StepStatus::tool_waits));
  EXPECT_TRUE(simulation.totals().touched.empty()) << "the tool waits: it feels nothing";
  EXPECT_TRUE(has_any(simulation.step(fed(60), kDown, -1).status, StepStatus::dt_rejected));
  (void)simulation.probe(fed(60), kDown, kTick);
  (void)simulation.touches(fed(60));
  EXPECT_TRUE(simulation.totals().touched.empty()) << "questions change nothing";
}

TEST(FirstTouch, ThroughACouplingIsThatOfAllSubTicks) {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Simulation simulation(layers(3), drill(), config);
  VirtualCoupling coupling(simulation, CouplingGains{});
  MaterialSet events;
  int ticks = 0;
  const double fast = 20 * kFeed;  // several sub-ticks in a tick
  for (int n = 0; n < 30; ++n) {
    const Pose X_WD = Pose::from_translation(Vec3(0, 0, kRadius + 1 * mm - fast * n * kTick));
    const CoupledResult& tick = coupling.step(X_WD, {Vec3(0, 0, -fast), Vec3::Zero()}, kTick);
    ticks += tick.first_touched.empty() ? 0 : 1;
    events.insert(tick.first_touched);
    EXPECT_EQ(events, simulation.totals().touched) << n;
  }
  EXPECT_TRUE(events.has(kFirst));
  EXPECT_GE(ticks, 1);
}

TEST(NormalForces, AreThoseOfTheLayersThatAreCutAndEndWithTheWorkpiece) {
  Simulation simulation(layers(3), drill());
  int n = 0;
  for (; fed(n).translation.z() - kRadius > -0.5 * mm; ++n) (void)simulation.step(fed(n), kDown, kTick);
  const ByMaterial<double> forces = simulation.normal_forces();
  EXPECT_GT(forces[kFirst], 0.1 * forces[kSecond]);
  EXPECT_GT(forces[kSecond], 0.1 * forces[kFirst]);
  EXPECT_EQ(forces[kThird], 0);
  simulation.reset(layers(1));
  EXPECT_EQ(simulation.normal_forces(), ByMaterial<double>{});
}

}  // namespace
}  // namespace hapticut::first_touch_test
