// SPDX-License-Identifier: Apache-2.0
// The loop of a device: arming, clutch, faults, commands, and a lost connection.
#include <limits>

#include "gestures/gesture_list.hpp"
#include "gestures/loop_scenes.hpp"

namespace hapticut::gestures {
namespace {

/// [m] Depth of the hand below the surface at which the coupling of a Touch presses with a force.
double press_depth(double force) { return force / touch_gains().stiffness; }

/// [m] Largest distance of the tool, within a span, from its place before the span.
double strayed(const SceneLog& log, const Span& span) {
  const Vec3 before = log.ticks[span.first > 0 ? span.first - 1 : 0].X_WH.translation;
  return log.max_of(span, [&](const Tick& tick) { return (tick.X_WH.translation - before).norm(); });
}

// --- G5 --------------------------------------------------------------------------------------------------------------

void arm_with_weight(Report& report) {
  constexpr double kInterrupted = 0.35;  // [s]
  for (const double mass : {0.015, 0.05, 0.3}) {
    const double weight = mass * 9.80665;  // [N]
    report.scene("ball 2 mm that weighs " + shown(1e3 * mass, "g") +
                 ", standing, in the air, then pressed as hard as it weighs, interrupted there, coupled");
    ChainOptions options;
    options.config.effects.gravity = Gravity{};
    options.config.effects.gravity->mass = mass;
    DeviceChain chain(report, bone_for(report), turning_ball(0), options);
    Hand hand(turning_ball(0), Vec3(0, 0, 0.5 * mm));
    hand.hold(0.05).move({0, 0, -0.5 * mm - press_depth(weight)}, 0.2).hold(0.3);
    chain.at(kInterrupted, [&] { chain.device().interrupt(SafetyEvent::reclutched); });
    chain.play(hand);
    const ArmingState state = chain.log.at(0).arming;
    report.that("arms in the air", "on", name_of(state), state == ArmingState::on);
    ArmingState last = ArmingState::off;
    int armed = 0;
    for (const Tick& tick : chain.log.ticks) {
      if (tick.arming == ArmingState::ramp && last == ArmingState::wait_free && tick.voxels > 0) ++armed;
      last = tick.arming;
    }
    report.that("arms while touching", "never", armed > 0 ? "arms in contact" : "does not", armed == 0);
    chain.judge();
  }
}

// --- G6 --------------------------------------------------------------------------------------------------------------

void open_clutch(Report& report) {
  constexpr double kOpen = 0.4, kClose = 1.4;  // [s]
  report.scene("ball 2 mm, 40 000 rpm, pressed with 2.6 N on cortical bone, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  Hand hand(turning_ball(), Vec3(0, 0, 0.2 * mm));
  hand.move({0, 0, -0.2 * mm - press_depth(2.6)}, 0.2).hold(0.25);
  hand.move({0, 0, 10 * mm}, 0.4).move({0, 0, -8 * mm}, 0.5).hold(0.3);
  chain.at(kOpen, [&] { chain.tell(commands::OpenClutch{}); });
  chain.at(kClose, [&] { chain.tell(commands::CloseClutch{}); });
  chain.play(hand);
  const SceneLog& log = chain.log;
  const Span open = log.within(kOpen + 2e-3, kClose), closing = log.within(kClose, kClose + 0.02);
  report.at_most("felt while open", log.max_of(open, applied_of), 0, "N");
  report.at_most("cut while open", 1e9 * log.sum(open, removed_of), 1e-6, "mm^3");
  demand_slow_growth(report, log, closing, "force step of closing");
  report.at_most("tool jumps at closing", 1e3 * strayed(log, closing), 0.1, "mm");
  chain.judge();
}

// --- G9 --------------------------------------------------------------------------------------------------------------

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kFaultAt = 0.5;  // [s]

/// A ball that is pressed and cuts. The fault comes after half a second.
Hand pressing() {
  Hand hand(turning_ball(), Vec3(0, 0, 0.2 * mm));
  return hand.move({0, 0, -0.2 * mm - 4 * mm}, 0.2).hold(0.6);
}

/// @param fresh  [s] time of the first good reading after the fault
void demand_calm(Report& report, const SceneLog& log, double fresh) {
  const Span before = log.within(kFaultAt - 0.1, kFaultAt), after = log.within(kFaultAt, fresh + 0.1);
  const double usual = strayed(log, before), rate = log.sum(before, removed_of) / double(before.size());
  report.at_most("tool stays", 1e3 * strayed(log, after), 1e3 * (2.5 * usual + 0.02 * mm), "mm",
                 "2.5 times its motion in the 0.1 s before");
  const Span within = log.within(kFaultAt, fresh + 5e-3);
  report.at_most("cut at the fault", 1e9 * log.sum(within, removed_of),
                 1e9 * (2 * rate * double(within.size()) + 1e-15), "mm^3", "twice the rate before");
}

void faults_in_a_cut(Report& report) {
  struct Bad {
    const char* name;
    void (*spoil)(Pose& pose);
  };
  for (const Bad& bad : {Bad{"one NaN pose", [](Pose& pose) { pose.translation.setConstant(kNan); }},
                         Bad{"one pose 30 mm away", [](Pose& pose) { pose.translation.z() -= 30 * mm; }}}) {
    const std::string what = bad.name;
    const double dt = report.period;
    const auto is_now = [=](double time) { return std::abs(time - kFaultAt) < 0.5 * dt; };
    report.scene(what + ", ball 2 mm that cuts cortical bone, own loop, coupled");
    ScriptedLoop loop(report, bone_for(report), turning_ball(), Grip::by_coupling);
    loop.play(pressing(), [&](Pose& pose, double time) {
      if (is_now(time)) bad.spoil(pose);
    });
    demand_calm(report, loop.log, kFaultAt + 2 * dt);
    report.at_least("force comes back", force_of(loop.log.at(kFaultAt + 0.1)),
                    0.9 * force_of(loop.log.at(kFaultAt - dt)), "N", "0.9 of the force before, 0.1 s later");
    loop.judge();

    report.scene(what + ", ball 2 mm that cuts cortical bone, loop of a device, coupled");
    DeviceChain chain(report, bone_for(report), turning_ball());
    chain.spoil = [&](DeviceState& reading, double time) {
      if (is_now(time)) bad.spoil(reading.X_BS);
    };
    chain.play(pressing());
    demand_calm(report, chain.log, kFaultAt + 2 * dt);
    chain.judge();
  }
  report.scene("one tick 150 ms late, ball 2 mm that cuts cortical bone, loop of a device, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.spoil = [&](DeviceState& reading, double time) {
    if (time >= kFaultAt - 1e-9) reading.time += 0.15;
  };
  chain.play(pressing());
  demand_calm(report, chain.log, kFaultAt + report.period);
  chain.judge();
}

// --- G50 -------------------------------------------------------------------------------------------------------------

void stop_at_once(Report& report) {
  report.scene("ball 2 mm that cuts cortical bone, loop of a device, coupled; the device's emergency stop after 0.5 s");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.at(kFaultAt, [&] { chain.device().emergency_stop(); });
  chain.play(pressing());
  const SceneLog& log = chain.log;
  report.at_least("force before it", applied_of(log.at(kFaultAt - report.period)), 0.5, "N");
  report.at_most("force after it", log.max_of(log.within(kFaultAt + 0.1, 10), applied_of), 0, "N",
                 "from 100 ms on, although the hand presses on");
  report.at_most("cut after it", 1e9 * log.sum(log.within(kFaultAt + 0.1, 10), removed_of), 0, "mm^3");
  chain.judge();
}

// --- G22 -------------------------------------------------------------------------------------------------------------

void change_while_touching(Report& report) {
  const int changes = report.voxel() < 2e-4 ? 400 : 10000;
  report.scene("tool, materials, effects and direction of the spindle, ball 2 mm on cortical bone, coupled");
  Material soft = presets::cortical_bone();
  soft.relative_stiffness *= 0.5;
  DeviceChain chain(report, bone_for(report), turning_ball());
  LoopCommand other_tool = chain.model().prepare_tool(tool_of(SphereHead{1.3 * kBallRadius}, Spindle{40000 * rpm}));
  LoopCommand other_material = chain.model().prepare_materials(MaterialTable({soft}));
  Hand hand(turning_ball(), Vec3(0, 0, 1 * mm));
  const double turn = 0.5;  // [s] back and forth
  while (hand.seconds() < 2 * report.period * changes)
    hand.move({0, 0, -2.5 * mm}, 0.3 * turn).hold(0.3 * turn).move({0, 0, 2.5 * mm}, 0.2 * turn).hold(0.2 * turn);
  int n = 0, refused = 0;
  std::vector<std::size_t> exchanges;  // ticks
  chain.before = [&](double time) {
    if (time < 0.02 || ++n % 2 != 0) return;
    const int kind = n / 2 % 40;  // exchanges are rare, so that the hand has a force in between
    bool applied = true;
    if (kind == 0 || kind == 20) {
      if (chain.snapshot().tool.contact_voxels > 0) exchanges.push_back(chain.log.ticks.size());
      applied = chain.model().apply(kind == 0 ? other_tool : other_material);
    } else if (kind % 2 == 0) {
      Effects effects;
      effects.gravity = Gravity{};
      effects.gravity->mass = kind % 4 == 0 ? 0.01 : 0.0;
      applied = chain.tell(commands::SetEffects{effects});
    } else {
      applied = chain.tell(commands::SetSpindleSpeed{(kind % 4 == 1 ? 1 : -1) * 40000 * rpm});
    }
    refused += applied ? 0 : 1;
  };
  const Span span = chain.play(hand);
  const SceneLog& log = chain.log;
  report.at_most("refused", refused, 0, "");
  demand_slow_growth(report, log, span);
  int early = 0;
  double jump = 0;
  for (const std::size_t at : exchanges) {
    bool free = false;
    for (std::size_t k = at; k < std::min(at + 20, log.ticks.size()); ++k) {
      free = free || (k > at + 1 && log.ticks[k].voxels == 0);
      if (!free && k > at && !log.ticks[k].applied.force.isZero(0)) ++early;
    }
    const std::size_t last = std::min(at + 2, log.ticks.size() - 1);
    const Vec3 way = log.ticks[last].X_WD.translation - log.ticks[at - 1].X_WD.translation;
    jump = std::max(jump, strayed(log, {at, last + 1}) - way.norm());
  }
  report.at_most("felt before it was free", early, 0, "ticks", "after a change of tool or materials while touching");
  report.at_most("tool jumps", 1e3 * jump, 0.1, "mm",
                 "more than the hand moves, where tool or materials change in contact");
  chain.judge();
}

// --- G23 -------------------------------------------------------------------------------------------------------------

void unplug(Report& report) {
  {
    report.scene("unplugged and plugged in again, ball 2 mm that cuts cortical bone, coupled");
    DeviceChain chain(report, bone_for(report), turning_ball());
    chain.spoil = [](DeviceState& reading, double time) {
      if (time < kFaultAt) return;
      reading.valid = false;
      reading.fault = DeviceFault::disconnected;
    };
    chain.play(pressing());
    report.that("run ends", "because the device was lost", describe(chain.report.fault),
                chain.report.fault == DeviceFault::disconnected);
    chain.spoil = {};
    Hand again(pressing().end());  // still pressed at the old place
    again.hold(0.1).move({0, 0, 8 * mm}, 0.2);
    const Span second = chain.play(again.hold(2.2));
    double removed = 0, force = 0;
    for (std::size_t n = second.first; n < chain.log.ticks.size(); ++n) {
      const Tick& tick = chain.log.ticks[n];
      if (tick.time > 0.1) break;
      removed += tick.removed;
      force = std::max(force, applied_of(tick));
    }
    report.at_most("force before it is free", force, 0, "N");
    report.at_most("cut before it is free", 1e9 * removed, 1e-6, "mm^3");
    const ArmingState end = chain.log.ticks.back().arming;
    report.that("arms when free", "on", name_of(end), end == ArmingState::on);
    chain.judge();
  }
  report.scene("asleep for 10 s, ball 2 mm that cuts cortical bone, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.spoil = [](DeviceState& reading, double time) {
    if (time >= kFaultAt - 1e-9) reading.time += 10;
  };
  chain.play(pressing());
  const Span awake = chain.log.within(kFaultAt, kFaultAt + 0.2);
  report.at_most("force on waking", chain.log.max_of(awake, applied_of), 0, "N", "the tool touches");
  report.at_most("cut on waking", 1e9 * chain.log.sum(awake, removed_of), 1e-6, "mm^3");
  report.at_most("tool stays", 1e3 * strayed(chain.log, awake), 0.1, "mm");
  chain.judge();
}

}  // namespace

std::vector<Gesture> loop_gestures() {
  return {{"G5", "arm with a tool that has a weight", arm_with_weight},
          {"G6", "open the clutch in a cut, close it again", open_clutch},
          {"G9", "one bad pose or one late tick in a cut", faults_in_a_cut},
          {"G50", "press the emergency stop in a cut", stop_at_once},
          {"G22", "change tool, materials, effects and direction while touching", change_while_touching},
          {"G23", "lose the device, or a machine that sleeps, in contact", unplug}};
}

}  // namespace hapticut::gestures
