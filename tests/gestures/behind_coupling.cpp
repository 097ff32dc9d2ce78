// SPDX-License-Identifier: Apache-2.0
// Gestures behind a coupling at any rate and with any head, from G42 on.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"
#include "hapticut/tool/motors.hpp"

namespace hapticut::gestures {
namespace {

namespace forms = closed_forms;

/// A bur, its material and the force that presses it.
struct PressedBur {
  std::string name;
  Tool tool;
  Material material;
  double force;  // [N]
  CouplingGains gains = touch_gains();
};

std::vector<PressedBur> turning_burs() {
  return {{"mastoid bur 5 mm, 80 000 rpm, 2.6 N on cortical bone",
           tool_of(round_head(5 * mm), common_spindle(80000 * rpm)), presets::cortical_bone(), 2.6},
          {"ball 1.6 mm, 300 000 rpm, 1.2 N on enamel", tool_of(round_head(1.6 * mm), common_spindle(300000 * rpm)),
           presets::enamel(), 1.2},
          {"ball 3 mm, 40 000 rpm, 2 N on cortical bone", tool_of(round_head(3 * mm), common_spindle(40000 * rpm)),
           presets::cortical_bone(), 2}};
}

Workpiece slab_for(const Report& report, const PressedBur& bur) {
  const double radius = bur.tool.head().cutting_radius();
  return slab(std::min(radius + 0.6 * mm, 2 * mm), 1.2 * mm, report.voxel(), bur.material);
}

/// A hand that presses the bur down without moving sideways.
Hand pressing(const PressedBur& bur) {
  Hand hand(bur.tool, Vec3(0.017, 0.006, 0.3) * mm);
  return hand.move({0, 0, -0.3 * mm - bur.force / bur.gains.stiffness}, 0.1);
}

/// [m/s] Largest speed of the tool relative to the hand.
double stray_speed(const SceneLog& log, const Span& span) {
  double most = 0;
  for (std::size_t n = std::max<std::size_t>(span.first, 1); n < span.last; ++n) {
    const Tick &last = log.ticks[n - 1], &now = log.ticks[n];
    const Vec3 way = (now.X_WH.translation - last.X_WH.translation) - (now.X_WD.translation - last.X_WD.translation);
    most = std::max(most, way.norm() / (now.time - last.time));
  }
  return most;
}

bool is_unbalanced(const Tick& tick) { return has_any(tick.status, StepStatus::not_in_balance); }

// --- G42 -------------------------------------------------------------------------------------------------------------

void circles_at_any_rate(Report& report) {
  constexpr double kCircle = 0.15 * mm;  // [m] radius of the circle
  const double period = report.period;
  for (const PressedBur& bur : turning_burs()) {
    report.scene(bur.name + ", circles of 0.3 mm at 0.5 ... 16 kHz, coupled");
    double min_volume = std::numeric_limits<double>::infinity(), max_volume = 0, stray = 0;
    double min_force = min_volume, max_force = 0, unbalanced = 0, ticks = 0;
    for (const double faster : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
      report.period = period / faster;
      ScriptedLoop loop(report, slab_for(report, bur), bur.tool, Grip::by_coupling);
      Hand hand = pressing(bur);
      hand.move({kCircle, 0, 0}, 0.02);
      constexpr int kChords = 24;
      for (int n = 1; n <= kChords; ++n) {
        const auto at = [&](int k) {
          return Vec3(std::cos(2 * kPi * k / kChords), std::sin(2 * kPi * k / kChords), 0);
        };
        hand.move(kCircle * (at(n) - at(n - 1)), 0.4 / kChords);
      }
      const Span steady = loop.play(hand).tail(0.5);
      const double volume = loop.log.sum(loop.log.all(), removed_of), force = loop.log.mean(steady, force_of);
      min_volume = std::min(min_volume, volume), max_volume = std::max(max_volume, volume);
      min_force = std::min(min_force, force), max_force = std::max(max_force, force);
      stray = std::max(stray, stray_speed(loop.log, steady));
      unbalanced += loop.log.sum(loop.log.all(), is_unbalanced);
      ticks += double(loop.log.ticks.size());
      if (faster == 1.0) {
        loop.judge();
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
  for (const PressedBur& bur : turning_burs()) {
    report.scene(bur.name + ", the hand displaced by 0.3 mm in one tick, coupled");
    ScriptedLoop loop(report, slab_for(report, bur), bur.tool, Grip::by_coupling);
    loop.play(pressing(bur));
    Hand on(loop.log.ticks.back().X_WD);
    const Span after = loop.play(on.move({0.3 * mm, 0, 0}, report.period).hold(0.15)).tail(2.0 / 3);
    report.at_most("tool's speed 50 ms later", 1e3 * stray_speed(loop.log, after), 10, "mm/s");
    loop.judge();
  }
}

// --- G44 -------------------------------------------------------------------------------------------------------------

void drill_a_hole(Report& report) {
  for (const double diameter : {1.5 * mm, 2.5 * mm, 3.5 * mm}) {
    PressedBur bur{"",
                   tool_of(twist_drill_head(diameter, 8 * mm), Spindle{4000 * rpm}, Cutter{CutterKind::twist_drill, 2}),
                   presets::trabecular_bone(), 2};
    for (const bool common : {true, false}) {
      bur.gains = common ? CouplingGains{} : touch_gains();
      report.scene("twist drill " + shown(1e3 * diameter, "mm") + ", 4000 rpm, 2 N on trabecular bone, " +
                   (common ? "gains by default" : "gains of a Touch"));
      const double depth = 2.5 * mm;
      ScriptedLoop loop(report, slab(diameter / 2 + 1 * mm, depth + 1 * mm, report.voxel(), bur.material), bur.tool,
                        Grip::by_coupling, {}, bur.gains);
      Hand hand = pressing(bur);
      loop.play(hand.move({0, 0, -depth}, depth / (5 * mm)).hold(0.1));
      const Vec3 tip = loop.log.ticks.back().X_WH.translation - Vec3(0, 0, tip_below_hand(bur.tool));
      const double volume = loop.log.sum(loop.log.all(), removed_of), slope = 59 * units::deg;
      const double cone = 0.5 * diameter / std::tan(slope);                               // [m] height of the point
      const double face = kPi * std::pow(std::min(-tip.z(), cone) * std::tan(slope), 2);  // [m^2] under the force
      const double stiff = loop.simulation.config().reference_stiffness * bur.material.relative_stiffness;
      const double layer = std::sqrt(2 * bur.force / (face * stiff));                        // [m] pressed in, not cut
      const double deep = -tip.z() - layer / std::sin(slope), point = std::min(deep, cone);  // [m] hole, its point
      const double wide = 0.5 * diameter * point / cone;                                     // [m] radius there
      const double hole = kPi * wide * wide * (point / 3 + deep - point);
      const double wider = std::pow(volume / hole, deep > cone ? 1.0 / 2 : 1.0 / 3);
      report.between(
          "hole", wider, 0.95, 1.05, "",
          "of the drill's width, by the volume without the pressed layer; " + shown(1e3 * deep, "mm") + " deep");
      report.at_most("not in balance", 100 * loop.log.mean(loop.log.all(), is_unbalanced), 0.2, "%", "of all ticks");
      loop.judge();
    }
  }
}

// --- G45 -------------------------------------------------------------------------------------------------------------

/// [m] Radius at which a standing cone carries a force. Material deeper than `layer` is crushed, the rest is elastic,
/// and friction holds the side.
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
  const double slope = 0.6 * mm / (4 * mm);  // [1] slope of the side
  for (const Material& material : {presets::enamel(), presets::cortical_bone(), presets::trabecular_bone()}) {
    report.scene("needle 1.2 mm, standing, 1 N on " + material.name + ", coupled");
    ScriptedLoop loop(report, slab(0.8 * mm, 3 * mm, report.voxel(), material), tool, Grip::by_coupling);
    Hand hand(tool, Vec3(0.017, 0.006, 0.3) * mm);
    const double strength = strength_of(material);
    const auto depth_by_strength = [&](double force) { return std::sqrt(force / (kPi * strength)) / slope; };
    hand.move({0, 0, -0.3 * mm - depth_by_strength(kForce) - kForce / touch_gains().stiffness}, 0.3);
    loop.play(hand.hold(0.2));
    const Tick& end = loop.log.ticks.back();
    const double depth = tip_below_hand(tool) - end.X_WH.translation.z(), force = end.felt.force.norm();
    const double layer =
        crushing_depth(loop.simulation.config().reference_stiffness * material.relative_stiffness, strength);
    const double radius = cone_radius(force, strength, layer, 1 + material.static_friction / slope);
    report.near("sinks", 1e3 * depth, 1e3 * radius / slope, 0.25, "mm", "a cone that crushes and rubs");
    if (material.name == "cortical_bone")
      report.near("sinks as strength says", 1e3 * depth, 1e3 * depth_by_strength(force), 0.25, "mm",
                  "without friction");
    const double hole = std::pow(std::max(0.0, 1 - layer / radius), 3);
    const double gone = loop.simulation.last_result().energy.crushed / strength;
    report.at_least("hole that is left", gone / (kPi * std::pow(slope * depth, 2) * depth / 3), 0.5 * hole, "",
                    "of the needle's volume; half of the volume deeper than the layer");
    report.quantity("sinks", 1e3 * depth, "mm", 0.1);
    loop.play(Hand(end.X_WD).move({0, 0, 4 * mm}, 0.4));
    report.at_most("not in balance", 100 * loop.log.mean(loop.log.all(), is_unbalanced), 0.2, "%", "of all ticks");
    loop.judge();
  }
}

// --- G46 -------------------------------------------------------------------------------------------------------------

void constant_force(Report& report) {
  const std::vector<PressedBur> all = {
      {"ball 1.6 mm, 40 000 rpm, 1 N on dentin", tool_of(round_head(1.6 * mm), common_spindle(40000 * rpm)),
       presets::dentin(), 1},
      {"ball 1.6 mm, 300 000 rpm, 1 N on enamel", tool_of(round_head(1.6 * mm), common_spindle(300000 * rpm)),
       presets::enamel(), 1},
      {"cylinder 1.6 mm, 40 000 rpm, 2 N on cortical bone",
       tool_of(cylinder_head(1.6 * mm, 4 * mm), common_spindle(40000 * rpm)), presets::cortical_bone(), 2}};
  for (const PressedBur& bur : all) {
    report.scene(bur.name + ", drawn along at 2 mm/s, coupled");
    ScriptedLoop loop(report, slab(2 * mm, 1.5 * mm, report.voxel(), bur.material), bur.tool, Grip::by_coupling);
    Hand hand(bur.tool, Vec3(-1, 0.006, 0.3) * mm);
    hand.move({0, 0, -0.3 * mm - bur.force / bur.gains.stiffness}, 0.1);
    loop.play(hand.move({1.6 * mm, 0, 0}, 0.8));
    report.quantity("volume", 1e9 * loop.log.sum(loop.log.all(), removed_of), "mm^3", 0.1);
    loop.judge();
  }
}

// --- G47 -------------------------------------------------------------------------------------------------------------

/// Exchanges something in a simulation while the tool is pressed. The coupling gets no notice of it.
struct Exchange {
  const char* name;
  std::function<void(ScriptedLoop&, const WorkpieceSnapshot&)> happens;
};

void exchange_in_contact(Report& report) {
  const PressedBur bur = turning_burs().back();
  const std::vector<Exchange> all = {
      {"undo", [](ScriptedLoop& loop, const auto&) { test::undo_all(loop.simulation); }},
      {"undo and redo",
       [](ScriptedLoop& loop, const auto&) {
         test::undo_all(loop.simulation);
         test::redo_all(loop.simulation);
       }},
      {"restore",
       [](ScriptedLoop& loop, const WorkpieceSnapshot& before) { loop.simulation.history().restore(before); }},
      {"a larger tool",
       [](ScriptedLoop& loop, const auto&) {
         loop.simulation.set(tool_of(round_head(4 * mm), common_spindle(40000 * rpm)));
       }},
      {"other materials",
       [](ScriptedLoop& loop, const auto&) { loop.simulation.set(MaterialTable({presets::trabecular_bone()})); }},
      {"release", [](ScriptedLoop& loop, const auto&) { loop.coupling().reset(); }}};
  for (const Exchange& exchange : all) {
    report.scene(bur.name + ", then " + exchange.name + ", coupled");
    ScriptedLoop loop(report, slab_for(report, bur), bur.tool, Grip::by_coupling);
    const WorkpieceSnapshot before = loop.simulation.workpiece().snapshot();
    loop.simulation.history().reserve(4000);
    (void)loop.simulation.history().mark();
    loop.play(pressing(bur).hold(0.3));
    const Tick last = loop.log.ticks.back();
    exchange.happens(loop, before);
    Hand on(last.X_WD);
    const Span after = loop.play(on.hold(0.05));
    report.at_most("cut in the tick", 1e9 * loop.log.ticks[after.first].removed, 0, "mm^3");
    const double moved = loop.log.max_of(
        after, [&](const Tick& tick) { return (tick.X_WH.translation - last.X_WH.translation).norm(); });
    const bool waits = has_any(loop.coupling().last_result().status, StepStatus::tool_waits);
    report.that("tool stays", "within half a voxel, or waits with a status bit",
                waits ? "waits" : shown(1e3 * moved, "mm"), waits || moved <= 0.5 * report.voxel());
  }
}

// --- G48 -------------------------------------------------------------------------------------------------------------

void refused_readings(Report& report) {
  for (const bool turning : {false, true}) {
    PressedBur bur = turning_burs().back();
    if (!turning) bur.tool = tool_of(round_head(3 * mm));
    bur.name = turning ? bur.name : "ball 3 mm, standing, 2 N on cortical bone";
    report.scene(bur.name + ", every 2nd, 10th, 100th reading NaN, turned over or late, coupled");
    const auto end_of = [&](const std::function<void(Pose&, double&)>& spoil, double& removed) {
      ScriptedLoop loop(report, slab_for(report, bur), bur.tool, Grip::by_coupling);
      loop.play(pressing(bur));
      Hand on(loop.log.ticks.back().X_WD);
      loop.play(on.hold(0.3), spoil);
      removed = loop.log.sum(loop.log.all(), removed_of);
      Vec3 at = loop.coupling().last_result().X_WH.translation;
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
  constexpr double kRadius = 1.25 * mm, kSpeed = 1500 * 2 * kPi / 60, kLip = 50 * units::um;  // kLip: [m] per lip
  const Material bone = presets::cortical_bone(CutterKind::twist_drill);
  const double feed = 2 * kLip * kSpeed / (2 * kPi);  // [m/s]
  for (const bool twist : {false, true}) {
    report.scene(std::string(twist ? "twist drill" : "cylinder") + " 2.5 mm, 1500 rpm, 50 um a lip, to 8 mm depth in " +
                 "cortical bone, directly");
    const Tool tool = tool_of(twist ? twist_drill_head(2 * kRadius, 10 * mm) : cylinder_head(2 * kRadius, 10 * mm),
                              Spindle{kSpeed * units::rad_per_s}, Cutter{CutterKind::twist_drill, 2});
    const forms::SteadyCut cut = steady_cut(bone, tool.cutter(), kSpeed, feed);
    const double expected = std::abs(forms::axial_chip_wrench(cut, kRadius).torque.z());
    ScriptedLoop loop(report, slab(kRadius + 0.6 * mm, 8.6 * mm, report.voxel(), bone), tool, Grip::directly);
    Hand hand(tool, Vec3(0.013, 0.007, 0.05) * mm);
    loop.play(hand.move({0, 0, -8.05 * mm}, 8.05 * mm / feed));
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const double depth : {2.0 * mm, 4.0 * mm, 6.0 * mm, 8.0 * mm}) {
      const double time = (depth + 0.05 * mm) / feed;
      const double torque = std::abs(
          loop.log.mean(loop.log.within(time - 0.05, time), [](const Tick& tick) { return tick.model.torque.z(); }));
      least = std::min(least, torque), most = std::max(most, torque);
    }
    report.between("torque at 2 ... 8 mm", least / expected, 0.9, 1.1, "", "of C35, minimum");
    report.between("torque at 2 ... 8 mm, maximum", most / expected, 0.9, 1.1, "", "of C35");
    loop.judge();
  }
}

// --- G51 -------------------------------------------------------------------------------------------------------------

/// A tick must fit into 1 ms, at 15 ns for each voxel at the surface of the head (docs/performance.md).
void rigid_hand(Report& report) {
  constexpr double kMaxVoxels = 1e-3 / 15e-9;
  for (const bool turning : {false, true}) {
    PressedBur bur{"", tool_of(round_head(4 * mm)), presets::cortical_bone(), 3.3};
    if (turning) bur.tool = tool_of(round_head(4 * mm), common_spindle(40000 * rpm));
    report.scene(std::string("mastoid bur 4 mm, ") + (turning ? "40 000 rpm" : "standing") +
                 ", a hand 6 mm inside cortical bone, 3.3 N, coupled");
    ScriptedLoop loop(report, slab_for(report, bur), bur.tool, Grip::by_coupling);
    Hand hand(bur.tool, Vec3(0.017, 0.006, 0.3) * mm);
    loop.play(hand.move({0, 0, -6.3 * mm}, 0.1).hold(0.3).move({0.5 * mm, 0, 0}, 0.1));
    report.at_most("voxels in a tick",
                   loop.log.max_of(loop.log.all(), [](const Tick& t) { return double(t.contacts) * t.voxels; }),
                   kMaxVoxels, "", "in all contacts that the coupling evaluates");
    loop.judge();
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
