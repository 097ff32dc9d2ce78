// SPDX-License-Identifier: Apache-2.0
// What a hand does behind a coupling at any rate, with any head: G42 and on.
#include "gestures/gesture_list.hpp"
#include "gestures/rigs.hpp"
#include "hapticut/tool/motors.hpp"

namespace hapticut::gestures {
namespace {

namespace forms = closed_forms;

/// A bur in a material, and how hard it is pressed.
struct Pressed {
  std::string name;
  Tool tool;
  Material material;
  double force;  // [N]
  CouplingGains gains = touch_gains();
};

std::vector<Pressed> turning_burs() {
  return {{"mastoid bur 5 mm, 80 000 rpm, 2.6 N on cortical bone",
           tool_of(round_head(5 * mm), common_spindle(80000 * rpm)), presets::cortical_bone(), 2.6},
          {"ball 1.6 mm, 300 000 rpm, 1.2 N on enamel", tool_of(round_head(1.6 * mm), common_spindle(300000 * rpm)),
           presets::enamel(), 1.2},
          {"ball 3 mm, 40 000 rpm, 2 N on cortical bone", tool_of(round_head(3 * mm), common_spindle(40000 * rpm)),
           presets::cortical_bone(), 2}};
}

Workpiece slab_for(const Report& report, const Pressed& of) {
  const double radius = of.tool.head().cutting_radius();
  return slab(std::min(radius + 0.6 * mm, 2 * mm), 1.2 * mm, report.voxel(), of.material);
}

/// Pressed down on the spot.
Hand pressing(const Pressed& of) {
  Hand hand(of.tool, Vec3(0.017, 0.006, 0.3) * mm);
  return hand.move({0, 0, -0.3 * mm - of.force / of.gains.stiffness}, 0.1);
}

/// [m/s] of the tool beyond the hand's, at most.
double stray_speed(const Story& story, const Span& span) {
  double most = 0;
  for (std::size_t n = std::max<std::size_t>(span.first, 1); n < span.last; ++n) {
    const Tick &last = story.ticks[n - 1], &now = story.ticks[n];
    const Vec3 way = (now.X_WH.translation - last.X_WH.translation) - (now.X_WD.translation - last.X_WD.translation);
    most = std::max(most, way.norm() / (now.time - last.time));
  }
  return most;
}

bool is_unbalanced(const Tick& tick) { return has_any(tick.status, StepStatus::not_in_balance); }

// --- G42 -------------------------------------------------------------------------------------------------------------

void circles_at_any_rate(Report& report) {
  constexpr double kCircle = 0.15 * mm;  // [m] its radius
  const double period = report.period;
  for (const Pressed& of : turning_burs()) {
    report.scene(of.name + ", circles of 0.3 mm at 0.5 ... 16 kHz, coupled");
    double min_volume = std::numeric_limits<double>::infinity(), max_volume = 0, stray = 0;
    double min_force = min_volume, max_force = 0, unbalanced = 0, ticks = 0;
    for (const double faster : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      report.period = period / faster;
      Rig rig(report, slab_for(report, of), of.tool, Held::by_coupling);
      Hand hand = pressing(of);
      hand.move({kCircle, 0, 0}, 0.02);
      constexpr int kChords = 24;
      for (int n = 1; n <= kChords; ++n) {
        const auto at = [&](int k) {
          return Vec3(std::cos(2 * kPi * k / kChords), std::sin(2 * kPi * k / kChords), 0);
        };
        hand.move(kCircle * (at(n) - at(n - 1)), 0.4 / kChords);
      }
      const Span steady = rig.play(hand).tail(0.5);
      const double volume = rig.story.sum(rig.story.all(), removed_of), force = rig.story.mean(steady, force_of);
      min_volume = std::min(min_volume, volume), max_volume = std::max(max_volume, volume);
      min_force = std::min(min_force, force), max_force = std::max(max_force, force);
      stray = std::max(stray, stray_speed(rig.story, steady));
      unbalanced += rig.story.sum(rig.story.all(), is_unbalanced);
      ticks += double(rig.story.ticks.size());
      if (faster == 1.0) {
        rig.judge();
        report.quantity("volume", 1e9 * volume, "mm^3", 0.1);
      }
    }
    report.period = period;
    report.at_most("volume", 100 * (max_volume / min_volume - 1), 2, "%", "from one rate to another");
    report.at_most("mean force", 100 * (max_force / min_force - 1), 2, "%", "from one rate to another");
    report.at_most("tool's speed beyond the hand's", 1e3 * stray, 10, "mm/s");
    report.at_most("not in balance", 100 * unbalanced / ticks, 0.2, "%", "of all ticks");
  }
}

// --- G43 -------------------------------------------------------------------------------------------------------------

void jerk(Report& report) {
  for (const Pressed& of : turning_burs()) {
    report.scene(of.name + ", the hand displaced by 0.3 mm in one tick, coupled");
    Rig rig(report, slab_for(report, of), of.tool, Held::by_coupling);
    rig.play(pressing(of));
    Hand on(rig.story.ticks.back().X_WD);
    const Span after = rig.play(on.move({0.3 * mm, 0, 0}, report.period).hold(0.15)).tail(2.0 / 3);
    report.at_most("tool's speed 50 ms later", 1e3 * stray_speed(rig.story, after), 10, "mm/s");
    rig.judge();
  }
}

// --- G44 -------------------------------------------------------------------------------------------------------------

void drill_a_hole(Report& report) {
  for (const double diameter : {1.5 * mm, 2.5 * mm, 3.5 * mm}) {
    Pressed of{"", tool_of(twist_drill_head(diameter, 8 * mm), Spindle{4000 * rpm}, Cutter{CutterKind::twist_drill, 2}),
               presets::trabecular_bone(), 2};
    for (const bool common : {true, false}) {
      of.gains = common ? CouplingGains{} : touch_gains();
      report.scene("twist drill " + shown(1e3 * diameter, "mm") + ", 4000 rpm, 2 N on trabecular bone, " +
                   (common ? "gains by default" : "gains of a Touch"));
      const double depth = 2.5 * mm;
      Rig rig(report, slab(diameter / 2 + 1 * mm, depth + 1 * mm, report.voxel(), of.material), of.tool,
              Held::by_coupling, {}, of.gains);
      Hand hand = pressing(of);
      rig.play(hand.move({0, 0, -depth}, depth / (5 * mm)).hold(0.1));
      const Vec3 tip = rig.story.ticks.back().X_WH.translation - Vec3(0, 0, tip_below_hand(of.tool));
      const double volume = rig.story.sum(rig.story.all(), removed_of), deep = -tip.z();
      const double cone = 0.5 * diameter / std::tan(59 * units::deg), point = std::min(deep, cone);  // [m] of its point
      const double wide = 0.5 * diameter * point / cone;                                             // [m] radius there
      const double hole = kPi * wide * wide * (point / 3 + deep - point);
      const double wider = std::pow(volume / hole, deep > cone ? 1.0 / 2 : 1.0 / 3);
      report.between("hole", wider, 0.95, 1.05, "",
                     "of the drill's width, by the volume; " + shown(1e3 * deep, "mm") + " deep");
      report.at_most("not in balance", 100 * rig.story.mean(rig.story.all(), is_unbalanced), 0.2, "%", "of all ticks");
      rig.judge();
    }
  }
}

// --- G45 -------------------------------------------------------------------------------------------------------------

/// [m] radius at which a standing cone carries a force: crushed where it is pressed deeper than `layer`, pressed in
/// where it is not, and held by friction along its side.
/// @param rubs  [1] 1 + mu/tan(alpha)
double cone_radius(double force, double strength, double layer, double rubs) {
  const double square = force / (kPi * strength * rubs);
  const double elastic = std::pow(6 * layer * layer * square, 0.25);
  if (elastic < layer) return elastic;
  return 2.0 / 3 * layer + std::sqrt(square - layer * layer / 18);
}

void needle(Report& report) {
  constexpr double kForce = 1;
  const Tool tool = tool_of(needle_head(1.2 * mm, 4 * mm));
  const double slope = 0.6 * mm / (4 * mm);  // [1] of its side
  for (const Material& material : {presets::enamel(), presets::cortical_bone(), presets::trabecular_bone()}) {
    report.scene("needle 1.2 mm, standing, 1 N on " + material.name + ", coupled");
    Rig rig(report, slab(0.8 * mm, 3 * mm, report.voxel(), material), tool, Held::by_coupling);
    Hand hand(tool, Vec3(0.017, 0.006, 0.3) * mm);
    const double strength = strength_of(material);
    const auto depth_by_strength = [&](double force) { return std::sqrt(force / (kPi * strength)) / slope; };
    hand.move({0, 0, -0.3 * mm - depth_by_strength(kForce) - kForce / touch_gains().stiffness}, 0.3);
    rig.play(hand.hold(0.2));
    const Tick& end = rig.story.ticks.back();
    const double depth = tip_below_hand(tool) - end.X_WH.translation.z(), force = end.felt.force.norm();
    const double layer =
        crushing_depth(rig.simulation.config().reference_stiffness * material.relative_stiffness, strength);
    const double radius = cone_radius(force, strength, layer, 1 + material.static_friction / slope);
    report.near("sinks", 1e3 * depth, 1e3 * radius / slope, 0.25, "mm", "a cone that crushes and rubs");
    if (material.name == "cortical_bone")
      report.near("sinks as strength says", 1e3 * depth, 1e3 * depth_by_strength(force), 0.25, "mm",
                  "without friction");
    const double hole = std::pow(std::max(0.0, 1 - layer / radius), 3);
    const double gone = rig.simulation.last_result().energy.crushed / strength;
    report.at_least("hole that is left", gone / (kPi * std::pow(slope * depth, 2) * depth / 3), 0.5 * hole, "",
                    "of what the needle fills; half of what is pressed deeper than the layer");
    report.quantity("sinks", 1e3 * depth, "mm", 0.1);
    rig.play(Hand(end.X_WD).move({0, 0, 4 * mm}, 0.4));
    report.at_most("not in balance", 100 * rig.story.mean(rig.story.all(), is_unbalanced), 0.2, "%", "of all ticks");
    rig.judge();
  }
}

// --- G46 -------------------------------------------------------------------------------------------------------------

void constant_force(Report& report) {
  const std::vector<Pressed> all = {
      {"ball 1.6 mm, 40 000 rpm, 1 N on dentin", tool_of(round_head(1.6 * mm), common_spindle(40000 * rpm)),
       presets::dentin(), 1},
      {"ball 1.6 mm, 300 000 rpm, 1 N on enamel", tool_of(round_head(1.6 * mm), common_spindle(300000 * rpm)),
       presets::enamel(), 1},
      {"cylinder 1.6 mm, 40 000 rpm, 2 N on cortical bone",
       tool_of(cylinder_head(1.6 * mm, 4 * mm), common_spindle(40000 * rpm)), presets::cortical_bone(), 2}};
  for (const Pressed& of : all) {
    report.scene(of.name + ", drawn along at 2 mm/s, coupled");
    Rig rig(report, slab(2 * mm, 1.5 * mm, report.voxel(), of.material), of.tool, Held::by_coupling);
    Hand hand(of.tool, Vec3(-1, 0.006, 0.3) * mm);
    hand.move({0, 0, -0.3 * mm - of.force / of.gains.stiffness}, 0.1);
    rig.play(hand.move({1.6 * mm, 0, 0}, 0.8));
    report.quantity("volume", 1e9 * rig.story.sum(rig.story.all(), removed_of), "mm^3", 0.1);
    rig.judge();
  }
}

// --- G47 -------------------------------------------------------------------------------------------------------------

/// What is done to a simulation while its tool is pressed, with nothing said to the coupling.
struct Exchange {
  const char* name;
  std::function<void(Rig&, const WorkpieceSnapshot&)> happens;
};

void exchange_in_contact(Report& report) {
  const Pressed of = turning_burs().back();
  const std::vector<Exchange> all = {
      {"undo", [](Rig& rig, const auto&) { test::undo_all(rig.simulation); }},
      {"undo and redo",
       [](Rig& rig, const auto&) {
         test::undo_all(rig.simulation);
         test::redo_all(rig.simulation);
       }},
      {"restore", [](Rig& rig, const WorkpieceSnapshot& before) { rig.simulation.restore(before); }},
      {"a larger tool",
       [](Rig& rig, const auto&) {
         rig.simulation.set_tool(tool_of(round_head(4 * mm), common_spindle(40000 * rpm)));
       }},
      {"other materials",
       [](Rig& rig, const auto&) { rig.simulation.set_materials(MaterialTable({presets::trabecular_bone()})); }},
      {"release", [](Rig& rig, const auto&) { rig.coupling().reset(); }}};
  for (const Exchange& exchange : all) {
    report.scene(of.name + ", then " + exchange.name + ", coupled");
    Rig rig(report, slab_for(report, of), of.tool, Held::by_coupling);
    const WorkpieceSnapshot before = rig.simulation.snapshot();
    rig.simulation.reserve_undo(4000);
    (void)rig.simulation.set_undo_mark();
    rig.play(pressing(of).hold(0.3));
    const Tick last = rig.story.ticks.back();
    exchange.happens(rig, before);
    Hand on(last.X_WD);
    const Span after = rig.play(on.hold(0.05));
    report.at_most("cut in the tick", 1e9 * rig.story.ticks[after.first].removed, 0, "mm^3");
    const double moved =
        rig.story.most(after, [&](const Tick& tick) { return (tick.X_WH.translation - last.X_WH.translation).norm(); });
    const bool waits = has_any(rig.coupling().last_result().status, StepStatus::tool_waits);
    report.that("tool stays", "within half a voxel, or waits and says so", waits ? "waits" : shown(1e3 * moved, "mm"),
                waits || moved <= 0.5 * report.voxel());
  }
}

// --- G48 -------------------------------------------------------------------------------------------------------------

void refused_readings(Report& report) {
  for (const bool turning : {false, true}) {
    Pressed of = turning_burs().back();
    if (!turning) of.tool = tool_of(round_head(3 * mm));
    of.name = turning ? of.name : "ball 3 mm, standing, 2 N on cortical bone";
    report.scene(of.name + ", every 2nd, 10th, 100th reading NaN, turned over or late, coupled");
    const auto end_of = [&](const std::function<void(Pose&, double&)>& spoil, double& removed) {
      Rig rig(report, slab_for(report, of), of.tool, Held::by_coupling);
      rig.play(pressing(of));
      Hand on(rig.story.ticks.back().X_WD);
      rig.play(on.hold(0.3), spoil);
      removed = rig.story.sum(rig.story.all(), removed_of);
      Vec3 at = rig.coupling().last_result().X_WH.translation;
      return at;
    };
    double whole = 0, max_moved = 0, max_removed = 0;
    const Vec3 rest = end_of({}, whole);
    for (const int every : {2, 10, 100})
      for (const int kind : {0, 1, 2}) {
        int n = 0;
        double removed = 0;
        const Vec3 at = end_of(
            [&](Pose& pose, double& dt) {
              if (++n % every != 0) return;
              if (kind == 0) pose.translation.x() = std::numeric_limits<double>::quiet_NaN();
              if (kind == 1) pose.rotation = pose.rotation * rotation_from_vector(Vec3(kPi, 0, 0));
              if (kind == 2) dt = 0.15;
            },
            removed);
        max_moved = std::max(max_moved, (at - rest).norm());
        max_removed = std::max(max_removed, removed);
      }
    report.at_most("elsewhere than without", 1e3 * max_moved, turning ? 0.1 : 0.02, "mm");
    report.at_most("removed", 1e9 * max_removed, 1e9 * 1.1 * whole + 1e-6, "mm^3", "a tenth more than without");
  }
}

// --- G49 -------------------------------------------------------------------------------------------------------------

void deep_holes(Report& report) {
  constexpr double kRadius = 1.25 * mm, kSpeed = 1500 * 2 * kPi / 60, kLip = 50 * units::um;  // [m] a lip
  const Material bone = presets::cortical_bone(CutterKind::twist_drill);
  const double feed = 2 * kLip * kSpeed / (2 * kPi);  // [m/s]
  for (const bool twist : {false, true}) {
    report.scene(std::string(twist ? "twist drill" : "cylinder") + " 2.5 mm, 1500 rpm, 50 um a lip, to 8 mm depth in " +
                 "cortical bone, directly");
    const Tool tool = tool_of(twist ? twist_drill_head(2 * kRadius, 10 * mm) : cylinder_head(2 * kRadius, 10 * mm),
                              Spindle{kSpeed * units::rad_per_s}, Cutter{CutterKind::twist_drill, 2});
    const forms::SteadyCut cut = steady_cut(bone, tool.cutter(), kSpeed, feed);
    const double expected = std::abs(forms::axial_chip_wrench(cut, kRadius).torque.z());
    Rig rig(report, slab(kRadius + 0.6 * mm, 8.6 * mm, report.voxel(), bone), tool, Held::directly);
    Hand hand(tool, Vec3(0.013, 0.007, 0.05) * mm);
    rig.play(hand.move({0, 0, -8.05 * mm}, 8.05 * mm / feed));
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const double depth : {2.0 * mm, 4.0 * mm, 6.0 * mm, 8.0 * mm}) {
      const double time = (depth + 0.05 * mm) / feed;
      const double torque = std::abs(
          rig.story.mean(rig.story.within(time - 0.05, time), [](const Tick& tick) { return tick.model.torque.z(); }));
      least = std::min(least, torque), most = std::max(most, torque);
    }
    report.between("torque at 2 ... 8 mm", least / expected, 0.9, 1.1, "", "of C35, the least");
    report.between("torque at 2 ... 8 mm, most", most / expected, 0.9, 1.1, "", "of C35");
    rig.judge();
  }
}

// --- G51 -------------------------------------------------------------------------------------------------------------

/// A tick takes 1 ms where 15 ns go for each voxel at the surface of the head (docs/performance.md).
void rigid_hand(Report& report) {
  constexpr double kMost = 1e-3 / 15e-9;
  for (const bool turning : {false, true}) {
    Pressed of{"", tool_of(round_head(4 * mm)), presets::cortical_bone(), 3.3};
    if (turning) of.tool = tool_of(round_head(4 * mm), common_spindle(40000 * rpm));
    report.scene(std::string("mastoid bur 4 mm, ") + (turning ? "40 000 rpm" : "standing") +
                 ", a hand 6 mm inside cortical bone, 3.3 N, coupled");
    Rig rig(report, slab_for(report, of), of.tool, Held::by_coupling);
    Hand hand(of.tool, Vec3(0.017, 0.006, 0.3) * mm);
    rig.play(hand.move({0, 0, -6.3 * mm}, 0.1).hold(0.3).move({0.5 * mm, 0, 0}, 0.1));
    report.at_most("voxels in a tick",
                   rig.story.most(rig.story.all(), [](const Tick& t) { return double(t.contacts) * t.voxels; }), kMost,
                   "", "in all contacts that the coupling asks for");
    rig.judge();
  }
}

}  // namespace

std::vector<Gesture> coupled_gestures() {
  return {{"G42", "cut in circles at any rate", circles_at_any_rate},
          {"G43", "jerk the hand while cutting", jerk},
          {"G44", "drill a hole behind the coupling", drill_a_hole},
          {"G45", "press a needle", needle},
          {"G46", "cut under a constant force", constant_force},
          {"G47", "exchange while pressing", exchange_in_contact},
          {"G48", "refuse readings while pressing", refused_readings},
          {"G49", "drill deep", deep_holes},
          {"G51", "hold a bur 6 mm inside with a rigid hand", rigid_hand}};
}

}  // namespace hapticut::gestures
