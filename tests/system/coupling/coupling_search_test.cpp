// SPDX-License-Identifier: Apache-2.0
// The search for the balance of forces, with every head, in flats, slots and bowls of several materials: the contacts
// that a tick evaluates, and how often they are too few.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/catalogue_heads.hpp"
#include "support/touch_gains.hpp"

namespace hapticut::coupling_search_test {
namespace {

using namespace units;

constexpr int kSteps = 9;                  // and one contact for the step: 1 ms where each takes 0.1 ms
constexpr int kVoxels = 250, kExtra = 40;  // voxels of such a contact, and what else it takes; a smaller one takes less
constexpr int kTicks = 800;

enum class Shape { flat, slot, bowl };

/// A block of 8 x 8 x 4 mm below z = 0, with a slot 2.4 mm wide and deep, or a bowl of 2.5 mm radius.
Workpiece piece(Shape shape, double voxel) {
  const auto outside = [=](const Vec3& p) {
    const double block =
        std::max({std::abs(p.x()) - 4 * mm, std::abs(p.y()) - 4 * mm, std::abs(p.z() + 2 * mm) - 2 * mm});
    const double slot = 1.2 * mm - std::max(std::abs(p.x()), -p.z() - 1.2 * mm);
    const double bowl = 2.5 * mm - (p - Vec3(0, 0, 0.8 * mm)).norm();
    return std::max(block, shape == Shape::slot ? slot : shape == Shape::bowl ? bowl : block);
  };
  const auto material = [](const Vec3& p) { return MaterialId(p.x() > 0.3 * mm ? 1 : p.y() > 0 ? 2 : 3); };
  return build_body({{Vec3(-4.03, -4.03, -4.03) * mm, Vec3(4.03, 4.03, 0.03) * mm}, outside, material}, voxel,
                    MaterialTable({presets::enamel(), presets::dentin(), presets::pulp()}), 2);
}

struct Searches {
  int ticks = 0, unbalanced = 0, touched = 0;
  void operator+=(const Searches& other) {
    ticks += other.ticks, unbalanced += other.unbalanced, touched += other.touched;
  }
};

/// A hand that presses with about 0.6 N, strokes at up to 30 mm/s and tilts the tool by up to 20 degrees.
/// @param spindle  [rpm]
Searches stroke(const ToolHead& head, Shape shape, double voxel, double spindle) {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Simulation simulation(piece(shape, voxel), Tool(head, RayHandle{30 * mm}, common_spindle(spindle * rpm)), config);
  VirtualCoupling coupling(simulation, test::touch_gains());
  const Pose X_TH = simulation.tool().X_HT().inverse();
  Searches seen;
  Pose last;
  double height = 0.3 * mm;
  for (int n = 0; n < kTicks; ++n) {
    const double t = n * test::kTick, stroke = 2 * kPi * 1.7 * t, press = 0.6 + 0.5 * std::sin(2 * kPi * 0.9 * t);
    const double force = n == 0 ? 0 : coupling.last_result().hand.force.norm();
    height -= std::clamp((press - force) * 15 * mm, -30 * mm, 20 * mm) * test::kTick;
    Pose tip;
    tip.rotation = Eigen::AngleAxisd(0.35 * std::sin(kPi * t), Vec3(1, 0.4, 0).normalized()).toRotationMatrix();
    tip.translation = {1.5 * mm * std::sin(stroke), 1.05 * mm * std::sin(1.3 * stroke + 1), height};
    const Pose hand = tip * X_TH;
    const Twist V_WD = n == 0 ? Twist{} : twist_between(last, hand, test::kTick);
    last = hand;
    const CoupledResult& result = coupling.step(hand, V_WD, test::kTick);
    const int voxels = simulation.last_result().contact.voxels;
    // Two sub-ticks have twice the time, and may see other contacts than the last.
    if (result.sub_ticks <= 2 && result.newton_steps > result.sub_ticks * kSteps) {
      EXPECT_LE(result.newton_steps * (voxels / 2 + kExtra), result.sub_ticks * (kSteps + 1) * (kVoxels + kExtra))
          << voxels;
    }
    ++seen.ticks;
    seen.touched += simulation.last_result().contact.voxels > 0;
    seen.unbalanced += has_any(result.status, StepStatus::not_in_balance);
  }
  return seen;
}

std::vector<test::CatalogueHead> all_heads() {
  std::vector<test::CatalogueHead> heads = test::catalogue_heads();
  heads.push_back({"sphere", [] { return ToolHead(SphereHead{1 * mm}); }});
  heads.push_back({"flat", [] { return ToolHead(FlatHead{1 * mm, 3 * mm}); }});
  return heads;
}

class CouplingSearch : public testing::TestWithParam<test::CatalogueHead> {};

INSTANTIATE_TEST_SUITE_P(Heads, CouplingSearch, testing::ValuesIn(all_heads()),
                         [](const auto& head) { return head.param.name; });

TEST_P(CouplingSearch, FindsTheBalanceInTheTimeOfTenLargeContacts) {
  const ToolHead head = GetParam().make();
  Searches seen;
  for (const Shape shape : {Shape::flat, Shape::slot, Shape::bowl})
    for (const double spindle : {0.0, 5000.0, 40000.0})
      for (const double voxel : {0.2 * mm, 0.15 * mm, 0.1 * mm}) seen += stroke(head, shape, voxel, spindle);
  seen += stroke(head, Shape::bowl, 0.05 * mm, 40000);
  EXPECT_GT(seen.touched, seen.ticks / 3);
  const double bound = GetParam().name == "needle" ? 0.003 : 0.002;  // the force of its point jumps the most
  EXPECT_LE(seen.unbalanced, bound * seen.ticks) << "of " << seen.ticks;
  RecordProperty("unbalanced", std::to_string(seen.unbalanced) + " of " + std::to_string(seen.ticks));
}

}  // namespace
}  // namespace hapticut::coupling_search_test
