// SPDX-License-Identifier: Apache-2.0
// C20, C22, C24, C26-C29 in every direction of the grid, on stiff foundations, and with chips C35, C37, C38, C42.
#include "bench/validation/bench.hpp"
#include "bench/validation/checks.hpp"
#include "bench/validation/grid_cuts.hpp"

namespace hapticut::validation {
namespace {

using units::deg;
using units::mm;

/// [1] Ripple in a slot through ten voxels of a plate whose faces go through voxels.
constexpr double kOtherFaces = 0.02;

/// [1] Ripple where a face along the grid recedes by half a voxel, ten layers, in a step: all its voxels in phase.
constexpr double kInPhase = 0.12;

/// [1] Thrust in a groove that edges cut: its floor behind the middle, cut no further than to w0, presses up as well.
constexpr double kBehind = 0.12;

/// [1] What a layer that is not thin adds, in layer/R. Where a surface turns slowly, at the pole of a ball and the tip
/// of a cone, the pressure and with it the layer are larger than at the radius; chips cost twice as much there.
constexpr double kEvenLayer = 0.1, kRoundLayer = 1, kChipLayer = 1.7, kTipLayer = 3.5;

GridCut drilled(double edge_pressure) {
  forms::SteadyCut cut = kSlowCut;
  cut.edge_pressure = edge_pressure;
  return {edge_pressure > 0 ? "C22" : "C20",
          edge_pressure > 0 ? "flat head fed axially, p_e = 1 MPa" : "flat head fed axially",
          FlatHead{kR, 8 * mm, FlatRule::bottom_only},
          kBlock,
          Vec3(0, 0, 0.1) * mm,
          Vec3(0, 0, -0.4) * mm,
          Vec3(0, 0, -0.9) * mm,
          0.7,
          {Vec3(0, 0, forms::axial_cutting_force_of_a_flat_head(cut, kR)),
           Vec3(0, 0, forms::axial_cutting_torque_of_a_flat_head(cut, kR))},
          cut};
}

/// Straight down until the tip is at the depth in the middle of what is measured.
GridCut plunged(const char* id, const char* what, const ToolHead& head, double depth, const Wrench& expected) {
  const double top = -head.bounding_box().min.z();
  return {id,
          what,
          head,
          kBlock,
          Vec3(0, 0, top + 0.1 * mm),
          Vec3(0, 0, top - depth + 0.25 * mm),
          Vec3(0, 0, top - depth - 0.1 * mm),
          0.2 / 0.35,
          expected};
}

/// A feed whose chips cost about as much again as what they take away, by edges and by being thin.
forms::SteadyCut with_chips() {
  forms::SteadyCut cut = kSlowCut;
  cut.tooth_rate = tooth_rate(GridCut::kCutter, cut.spin);
  const double chip = cut.feed_speed / cut.tooth_rate;
  cut.edge_length = chip;
  cut.size_length = 2 * chip;
  return cut;
}

/// The same cut at another speed, of feed and spin alike, or in other steps.
GridCut hurried(GridCut cut, const char* id, const char* what, double factor, double tick) {
  cut.id = id;
  cut.what = what;
  cut.cut.feed_speed *= factor;
  cut.cut.spin *= factor;
  cut.tick = tick;
  return cut;
}

GridCut slotted() {
  return milled("C24", "slotting with a cylinder", FlatHead{kR, 4 * mm, FlatRule::side_only}, kPlate, -1.5 * mm,
                forms::slotting_wrench(kSlowCut, kR, 1 * mm));
}

GridCut with_chips(GridCut cut, const char* id, const char* what, const Wrench& expected) {
  cut.id = id;
  cut.what = what;
  cut.cut = with_chips();
  cut.expected = expected;
  return cut;
}

}  // namespace

std::vector<Experiment> grid_experiments() {
  const double groove = 0.6 * kR, depth = 0.7 * mm, alpha = 45 * deg;
  const Box buried = {Vec3(-0.4, -1.4, -1.4) * mm, Vec3(2.6, 1.4, 1.4) * mm};
  return {
      {"grid, drilling",
       [] {
         return in_every_direction(drilled(0), {0.02, 0.02, 0.015, kEvenLayer}, {0.02, 0.01, 0.015});
       }},
      {"grid, drilling with an edge",
       [] {
         return in_every_direction(drilled(1e6), {0.02, 0.02, 0.015, kEvenLayer}, {0.02, 0.01, 0.015});
       }},
      {"grid, slotting",
       [=] {
         return in_every_direction(slotted(), {0.02, 0.02, kOtherFaces, kEvenLayer}, {0.02, 0.02, 0.015});
       }},
      {"grid, groove",
       [=] {
         return in_every_direction(milled("C26", "ball in a groove of depth 0.6 R", SphereHead{kR}, kPlate, kR - groove,
                                          forms::groove_wrench(kSlowCut, kR, groove)),
                                   {0.04, 0.02, 0.015, kRoundLayer}, {0.04, 0.02, 0.015});
       }},
      {"grid, buried ball",
       [=] {
         return in_every_direction(milled("C27", "buried ball fed sideways", SphereHead{kR}, buried, 0,
                                          forms::buried_ball_wrench(kSlowCut, kR)),
                                   {0.02, 0.02, 0.015, kRoundLayer}, {0.02, 0.02, 0.015});
       }},
      {"grid, plunging ball",
       [=] {
         return in_every_direction(plunged("C28", "ball plunged to 0.7 R", SphereHead{kR}, depth,
                                           forms::ball_plunge_wrench(kSlowCut, kR, depth)),
                                   {0.04, 0.04, 0.015, kRoundLayer}, {0.04, 0.04, 0.015});
       }},
      {"grid, 50 mm/s in steps of 1 ms",
       [] {
         std::vector<Check> checks =
             in_every_direction(hurried(drilled(0), "C20 50 mm/s", "flat head fed axially at 50 mm/s", 25, kTick),
                                {0.02, 0.02, kInPhase, 0.6}, 0.1 * mm);
         for (Check& check : in_every_direction(hurried(slotted(), "C24 50 mm/s", "slotting at 50 mm/s", 25, kTick),
                                                {0.02, 0.02, 0.03, 0.2}, 0.1 * mm))
           checks.push_back(std::move(check));
         return checks;
       }},
      {"grid, steps of 0.1 ms",
       [] {
         return in_every_direction(
             hurried(drilled(0), "C20 0.1 ms", "flat head fed axially in steps of 0.1 ms", 1, 0.1 * kTick),
             {0.02, 0.02, 0.015, kEvenLayer}, 0.1 * mm);
       }},
      {"grid, chips",
       [=] {
         const double slot = 1 * mm, deep = 1.2 * kR;
         std::vector<Check> checks = in_every_direction(
             with_chips(drilled(0), "C35", "flat head fed axially, chips", forms::axial_chip_wrench(with_chips(), kR)),
             {0.03, 0.03, 0.015, 0.4}, 0.1 * mm);
         const auto add = [&](const GridCut& cut, const Limits& limits) {
           for (Check& check : in_every_direction(cut, limits, 0.1 * mm)) checks.push_back(std::move(check));
         };
         add(with_chips(slotted(), "C37", "slotting, chips", forms::slotting_chip_wrench(with_chips(), kR, slot)),
             {0.035, 0.07, kOtherFaces, kEvenLayer});
         GridCut ball = plunged("", "", SphereHead{kR}, deep, {});
         ball.box.min.z() = -2 * mm;
         add(with_chips(ball, "C38", "ball deeper than its radius, chips",
                        forms::ball_plunge_chip_wrench(with_chips(), kR)),
             {0.03, 0.07, 0.015, kChipLayer});
         add(with_chips(milled("", "", SphereHead{kR}, kPlate, kR - groove, {}), "C42",
                        "ball in a groove of depth 0.6 R, chips", forms::groove_chip_wrench(with_chips(), kR, groove)),
             {kBehind, 0.07, 0.015, kChipLayer});
         return checks;
       }},
      {"grid, plunging cone", [=] {
         return in_every_direction(plunged("C29", "cone plunged to 0.7 mm", ConeHead{alpha, 2 * mm}, depth,
                                           forms::cone_plunge_wrench(kSlowCut, alpha, depth)),
                                   {0.06, 0.06, 0.015, kTipLayer}, {0.06, 0.06, 0.015});
       }}};
}

}  // namespace hapticut::validation
