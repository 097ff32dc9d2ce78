// SPDX-License-Identifier: Apache-2.0
// C20, C22, C24, C26-C29 in every direction of the grid, on stiff foundations, and with chips C35, C37, C38, C42.
#include <string>

#include "experiments/grid_cuts.hpp"
#include "experiments/vocabulary.hpp"

namespace hapticut::experiments {
namespace in_the_grid {

/// [1] Ripple of a slot through a plate of ten voxels whose faces lie inside voxels.
constexpr double kOtherFaces = 0.02;

/// [1] Ripple when a face along the grid recedes by half a voxel, ten layers, in a step: all voxels are in phase.
constexpr double kInPhase = 0.12;

/// [1] Error of the thrust in a groove with chips of edges. The floor behind the middle is cut only down to the depth
/// w0, so it presses up as well.
constexpr double kBehind = 0.12;

/// [1] Additional error of a layer that is not thin, over layer/R. Where the slip is low, at the pole of a ball and the
/// tip of a cone, pressure and layer are larger than at the radius; chips cost twice as much there.
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

/// A plunge; the tip is at the given depth in the middle of the measured part.
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

/// A feed whose chips cost 2 ... 2.4 times the energy, by edges, by the size effect, or by both.
struct Chips {
  const char* name;
  double edge, size;  // [1] lengths over the chip

  [[nodiscard]] forms::SteadyCut cut() const { return slow_cut_with_chips(edge, size); }
};
constexpr Chips kEdges = {"chips of edges", 2, 0}, kThin = {"thin chips", 0, 4}, kBoth = {"chips", 1, 2};

/// A cut with feed and spin scaled by a factor, and with steps of a given length.
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

GridCut with_chips(const char* form, const char* of, const Chips& chips, GridCut cut, const Wrench& expected) {
  cut.id = std::string(form) + (&chips == &kBoth ? "" : std::string(" ") + chips.name);
  cut.what = std::string(of) + ", " + chips.name;
  cut.cut = chips.cut();
  cut.expected = expected;
  return cut;
}

constexpr double kGroove = 0.6 * kR, kDepth = 0.7 * mm, kAlpha = 45 * deg, kSlot = 1 * mm;

std::vector<Check> drilled_chips() {
  const auto drill = [](const Chips& chips) {
    return with_chips("C35", "flat head fed axially", chips, drilled(0), forms::axial_chip_wrench(chips.cut(), kR));
  };
  const Limits limits = {0.03, 0.03, 0.013, 0.4, 1e15}, of_thin = {0.03, 0.03, 0.016, 0.4, 1e15};
  return joined({in_every_direction(drill(kBoth), limits, 0.1 * mm),
                 in_every_direction(drill(kEdges), limits, 0.1 * mm),
                 in_every_direction(drill(kThin), of_thin, 0.1 * mm),
                 tilted(drill(kThin), {0.03, 0.03, 0.013}, {1e15, 1e16, 1e17})});
}

/// Behind the middle, the slot's walls press and rub with a layer of thickness w0, which is too thin to be cut.
std::vector<Check> slotted_chips() {
  const auto slot = [](const char* id, const Chips& chips) {
    return with_chips(id, "slotting", chips, slotted(), forms::slotting_chip_wrench(chips.cut(), kR, kSlot));
  };
  constexpr double kForce = 0.035, kRubbed = 0.07, kRipple = 0.013;
  const auto along = [&](const Chips& chips) {
    return joined({along_the_faces(slot("C37 soft", chips), {kForce, kRubbed, kRipple}, {1e15, 1e16}),
                   along_the_faces(slot("C37 stiff", chips), {kForce, kForce, kRipple}, {1e17})});
  };
  return joined({in_every_direction(slot("C37", kBoth), {kForce, kRubbed, kOtherFaces, kEvenLayer}, 0.1 * mm),
                 along(kBoth), along(kEdges),
                 along_the_faces(slot("C37", kThin), {kForce, 0.03, kRipple}, {1e15, 1e16, 1e17})});
}

std::vector<Check> plunged_chips() {
  GridCut ball = plunged("", "", SphereHead{kR}, 1.2 * kR, {});
  ball.box.min.z() = -2 * mm;
  const auto deep = [&](const Chips& chips, double torque) {
    return in_every_direction(
        with_chips("C38", "ball deeper than its radius", chips, ball, forms::ball_plunge_chip_wrench(chips.cut(), kR)),
        {0.03, torque, 0.015, kChipLayer}, 0.1 * mm);
  };
  const GridCut groove = with_chips("C42", "ball in a groove of depth 0.6 R", kBoth,
                                    milled("", "", SphereHead{kR}, kPlate, kR - kGroove, {}),
                                    forms::groove_chip_wrench(kBoth.cut(), kR, kGroove));
  return joined({deep(kBoth, 0.06), deep(kEdges, 0.06), deep(kThin, 0.03),
                 in_every_direction(groove, {kBehind, 0.07, 0.015, kChipLayer}, 0.1 * mm)});
}

/// A feed of half a voxel per tick, ten times the layer. The rim is 1000 times as fast as the feed, as the closed forms
/// require.
std::vector<Check> hurried_cuts() {
  const GridCut drill = hurried(drilled(0), "C20 50 mm/s", "flat head fed axially at 50 mm/s", 25, kTick),
                slot = hurried(slotted(), "C24 50 mm/s", "slotting at 50 mm/s", 25, kTick);
  return joined({in_every_direction(drill, {0.02, 0.02, kInPhase, 0.6}, 0.1 * mm),
                 in_every_direction(slot, {0.02, 0.02, 0.03, 0.2}, 0.1 * mm)});
}

}  // namespace in_the_grid

std::vector<Experiment> grid_experiments() {
  using namespace in_the_grid;
  const Box buried = {Vec3(-0.4, -1.4, -1.4) * mm, Vec3(2.6, 1.4, 1.4) * mm};
  const Limits flat = {0.02, 0.02, 0.015, kEvenLayer, 1e15}, fine = {0.02, 0.01, 0.015};
  return {
      {"grid, drilling", [=] { return in_every_direction(drilled(0), flat, fine); }},
      {"grid, drilling with an edge", [=] { return in_every_direction(drilled(1e6), flat, fine); }},
      // Proves: tangential force of the spin.
      {"grid, slotting",
       [=] {
         return joined({in_every_direction(slotted(), {0.02, 0.02, kOtherFaces, kEvenLayer, 1e15}, {0.02, 0.02, 0.015}),
                        along_the_faces(slotted(), {0.02, 0.02, 0.008}, {1e15, 1e16, 1e17})});
       }},
      {"grid, groove",
       [=] {
         return in_every_direction(milled("C26", "ball in a groove of depth 0.6 R", SphereHead{kR}, kPlate,
                                          kR - kGroove, forms::groove_wrench(kSlowCut, kR, kGroove)),
                                   {0.04, 0.02, 0.015, kRoundLayer}, {0.04, 0.02, 0.015});
       }},
      // Proves: removal by law A.
      {"grid, buried ball",
       [=] {
         return in_every_direction(milled("C27", "buried ball fed sideways", SphereHead{kR}, buried, 0,
                                          forms::buried_ball_wrench(kSlowCut, kR)),
                                   {0.02, 0.02, 0.015, kRoundLayer}, {0.02, 0.02, 0.015});
       }},
      // Proves: removal by law A.
      {"grid, plunging ball",
       [=] {
         return in_every_direction(plunged("C28", "ball plunged to 0.7 R", SphereHead{kR}, kDepth,
                                           forms::ball_plunge_wrench(kSlowCut, kR, kDepth)),
                                   {0.04, 0.04, 0.015, kRoundLayer}, {0.04, 0.04, 0.015});
       }},
      {"grid, 50 mm/s in steps of 1 ms", hurried_cuts},
      {"grid, steps of 0.1 ms",
       [] {
         return in_every_direction(
             hurried(drilled(0), "C20 0.1 ms", "flat head fed axially in steps of 0.1 ms", 1, 0.1 * kTick),
             {0.02, 0.02, 0.015, kEvenLayer}, 0.1 * mm);
       }},
      // Proves: chips; energy ledger.
      {"grid, chips, drilling", drilled_chips},
      // Proves: chips.
      {"grid, chips, slotting", slotted_chips},
      // Proves: chips.
      {"grid, chips, balls", plunged_chips},
      {"grid, plunging cone", [=] {
         return in_every_direction(plunged("C29", "cone plunged to 0.7 mm", ConeHead{kAlpha, 2 * mm}, kDepth,
                                           forms::cone_plunge_wrench(kSlowCut, kAlpha, kDepth)),
                                   {0.06, 0.06, 0.015, kTipLayer}, {0.06, 0.06, 0.015});
       }}};
}

}  // namespace hapticut::experiments
