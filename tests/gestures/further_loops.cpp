// SPDX-License-Identifier: Apache-2.0
// Further gestures in the loop of a device: tapping, the rim of the workspace, commands in contact.
#include "gestures/gesture_list.hpp"
#include "gestures/loop_scenes.hpp"

namespace hapticut::gestures {
namespace {

constexpr double kNow = 0.5;  // [s] time of the event

/// A hand that presses with 2.8 N from 0.2 s on.
Hand pressed_hand() {
  Hand hand(turning_ball(), Vec3(0, 0, 0.2 * mm));
  return hand.move({0, 0, -4.2 * mm}, 0.2);
}

/// [m] Largest distance of the tool, within a span, from its place at the given time.
double moved_since(const SceneLog& log, double time, const Span& span) {
  const Vec3 from = log.at(time).X_WH.translation;
  return log.max_of(span, [&](const Tick& tick) { return (tick.X_WH.translation - from).norm(); });
}

/// After any command in a cut the tool must not jump, and must not cut until the device gets a force again.
void demand_quiet(Report& report, DeviceChain& chain, double until) {
  const SceneLog& log = chain.log;
  const Span after = log.within(kNow + 2e-3, until);
  report.at_most("tool jumps", 1e3 * moved_since(log, kNow - report.period, after), 0.2, "mm");
  double unfelt = 0;
  for (std::size_t n = after.first; n < after.last; ++n)
    if (applied_of(log.ticks[n]) == 0) unfelt += log.ticks[n].removed;
  report.at_most("cut without a force", 1e9 * unfelt, 1e-6, "mm^3");
  demand_slow_growth(report, log, after);
}

// --- G28 -------------------------------------------------------------------------------------------------------------

void press_far_tip(Report& report) {
  constexpr double kArm = 80 * mm;
  report.scene(
      "ball 2 mm on a handle of 80 mm that lies flat, standing, pressed on cortical bone, Premium of six motors, "
      "coupled");
  const Tool tool(SphereHead{kBallRadius}, RayHandle{kArm});
  DeviceChain chain(report, bone_for(report), tool, {.device = "premium6dof"});
  // The handle lies along x: the head is in the middle, the hand 80 mm beside it.
  Hand hand(Pose{rotation_from_vector(Vec3(0, kPi / 2, 0)), Vec3(kArm, 0, kBallRadius + 0.2 * mm)});
  hand.move({0, 0, -13 * mm}, 0.5);
  const double pressed = hand.seconds();
  chain.play(hand.hold(0.5));
  const Span rest = chain.log.within(pressed + 0.3, pressed + 0.5);
  demand_steady(report, chain.log, rest);
  chain.judge();
}

// --- G30 -------------------------------------------------------------------------------------------------------------

void lean_on_wall(Report& report) {
  for (const double kappa : {0.5, 3.3}) {
    Material material = plain_material();
    material.cutting_ratio = kappa;
    material.specific_cutting_energy = 3e9;
    report.scene("side of a cylinder of 2 mm, 30 000 rpm, leant with 0.3 N on a wall of u 3e9 J/m^3, kappa " +
                 shown(kappa, "") + ", Touch in a nominal hand, coupled");
    const Tool bur = tool_of(FlatHead{kBallRadius, 4 * mm}, Spindle{30000 * rpm});
    DeviceChain chain(report, build_block({Vec3(-9, 0, -2) * mm, Vec3(9, 1, 0) * mm}, report.voxel(), material), bur,
                      {.hand = "nominal"});
    Hand hand(bur, Vec3(0.2 * mm, -kBallRadius - 0.3 * mm, -1.5 * mm));
    hand.move({0, 0.3 * mm + 0.3 / 210, 0}, 0.3);  // springs of hand and coupling in series: 210 N/m
    const double leant = hand.seconds();
    chain.play(hand.hold(0.7));
    const Span rest = chain.log.within(leant + 0.4, leant + 0.7);
    demand_steady(report, chain.log, rest);
    chain.judge();
  }
}

// --- G37 -------------------------------------------------------------------------------------------------------------

void tap(Report& report) {
  report.scene(
      "ball 2 mm, standing, 10 taps a second from 2 mm above to 2 mm below enamel, Touch in a nominal hand, coupled");
  DeviceChain chain(report, slab(1.6 * mm, 2 * mm, report.voxel(), presets::enamel()), turning_ball(0),
                    {.hand = "nominal"});
  Hand hand(turning_ball(0), Vec3(0, 0, 2 * mm));
  for (int n = 0; n < 10; ++n) hand.move({0, 0, -4 * mm}, 0.05).move({0, 0, 4 * mm}, 0.05);
  const double taps = hand.seconds();
  chain.play(hand.hold(0.3));
  const Span rest = chain.log.within(taps + 0.2, taps + 0.3);
  report.at_most("force after the last tap", chain.log.max_of(rest, applied_of), 0.01, "N", "0.2 s after it");
  report.at_most("removed", 1e9 * chain.log.sum(chain.log.all(), removed_of), 1e-6, "mm^3");
  chain.judge();
}

// --- G31 -------------------------------------------------------------------------------------------------------------

void begin_inside(Report& report) {
  report.scene(
      "ball 2 mm, 40 000 rpm, 1 mm deep in cortical bone when the run begins, then drawn out and pressed, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  Hand hand(turning_ball(), Vec3(0, 0, -1 * mm));
  hand.hold(0.2);
  const double inside = hand.seconds();
  hand.move({0, 0, 2 * mm}, 0.2).hold(1.7);
  chain.play(hand.move({0, 0, -2 * mm}, 0.2).hold(0.1));
  const Span before = {0, chain.log.within(inside, inside + 1).first};
  report.at_most("cut inside", 1e9 * chain.log.sum(before, removed_of), 1e-6, "mm^3");
  report.at_most("felt inside", chain.log.max_of(before, applied_of), 0, "N");
  const Vec3 from = chain.log.ticks.front().X_WH.translation;
  report.at_most("tool is thrown",
                 1e3 * chain.log.max_of(before, [&](const Tick& t) { return (t.X_WH.translation - from).norm(); }), 2,
                 "mm", "the distance out of the bone");
  report.that("arms when free", "on", name_of(chain.log.ticks.back().arming),
              chain.log.ticks.back().arming == ArmingState::on);
  chain.judge();
}

// --- G32 -------------------------------------------------------------------------------------------------------------

void over_the_rim(Report& report) {
  report.scene("ball 2 mm that cuts cortical bone at the rim of a Touch's workspace, 2 mm beyond it and back, coupled");
  ChainOptions options;
  const double rim = device_model("touch").workspace_half_width + 0.05;  // [m] limit of accepted readings
  options.map.X_WB.translation.x() = -(rim - 1 * mm);
  DeviceChain chain(report, bone_for(report), turning_ball(), options);
  Hand in_world = pressed_hand();
  Pose start = in_world.at(0), down = in_world.end();
  start.translation.x() += rim - 1 * mm;
  down.translation.x() += rim - 1 * mm;
  Hand hand(start);
  hand.to(down, 0.2).hold(0.3).move({3 * mm, 0, 0}, 0.1).hold(0.3).move({-3 * mm, 0, 0}, 0.1).hold(0.3);
  chain.play(hand);
  demand_quiet(report, chain, hand.seconds());
  chain.judge();
}

// --- G33 ... G36 -----------------------------------------------------------------------------------------------------

void change_scale(Report& report) {
  report.scene("ball 2 mm that cuts cortical bone, scale from 1 to 3, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.at(kNow, [&] { chain.tell(commands::SetScale{3}); });
  Hand hand = pressed_hand();
  hand.hold(0.4);
  const double rests = hand.seconds();
  hand.move({0, 0, 3 * mm}, 0.2).hold(0.4);
  const double again = hand.seconds();
  chain.play(hand.move({0, 0, -2.3 * mm}, 0.2));
  demand_quiet(report, chain, rests);
  // The slope of the force over the hand's motion when it presses again.
  const SceneLog& log = chain.log;
  double slope = 0;
  for (std::size_t n = log.within(again, again + 0.05).first; n + 20 < log.ticks.size(); ++n) {
    const Tick &from = log.ticks[n], &to = log.ticks[n + 20];
    const double moved = from.X_WD.translation.z() - to.X_WD.translation.z();
    if (moved > 0.1 * mm && from.felt.force.z() > 0.3 && to.felt.force.z() < 2.5)
      slope = std::max(slope, (to.felt.force.z() - from.felt.force.z()) / moved);
  }
  report.at_most("stiffness that is felt", slope, 1.1 * device_model("touch").rendered_stiffness, "N/m",
                 "stiffness that the device renders");
  chain.judge();
}

void hold_and_leave(Report& report) {
  report.scene("ball 2 mm that cuts cortical bone, force held, hand 10 mm up and back, force released, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.at(kNow, [&] { chain.tell(commands::HoldForce{true}); });
  chain.at(kNow + 0.5, [&] { chain.tell(commands::HoldForce{false}); });
  Hand hand = pressed_hand();
  chain.play(hand.hold(0.35).move({0, 0, 10 * mm}, 0.2).move({0, 0, -10 * mm}, 0.2).hold(0.3));
  const Span after = chain.log.within(kNow + 0.5, kNow + 0.75);
  report.at_most("cut while held", 1e9 * chain.log.sum(chain.log.within(kNow + 2e-3, kNow + 0.5), removed_of), 1e-6,
                 "mm^3");
  report.at_most("tool jumps at the end", 1e3 * moved_since(chain.log, kNow + 0.5 - report.period, after), 0.2, "mm");
  report.at_most("cut after it", 1e9 * chain.log.sum(after, removed_of), 1e-6, "mm^3", "the tool was not free yet");
  chain.judge();
}

void undo_in_cavity(Report& report) {
  report.scene("ball 2 mm in the cavity that it cut in cortical bone, undone, then drawn out, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball(), {.undo_blocks = 4000});
  chain.tell(commands::SetUndoMark{});
  chain.at(kNow, [&] { chain.tell(commands::Undo{}); });
  Hand hand = pressed_hand();
  hand.hold(0.5);
  const double rests = hand.seconds();
  chain.play(hand.move({0, 0, 8 * mm}, 0.3).hold(0.4));
  demand_quiet(report, chain, rests);
  report.that("arms when free", "ramp or on", name_of(chain.log.ticks.back().arming),
              chain.log.ticks.back().arming == ArmingState::on || chain.log.ticks.back().arming == ArmingState::ramp);
  chain.judge();
}

void stop_and_go(Report& report) {
  report.scene("ball 2 mm that cuts cortical bone, spindle switched off for 0.3 s and on again, coupled");
  DeviceChain chain(report, bone_for(report), turning_ball());
  chain.at(kNow, [&] { chain.tell(commands::SetSpindleSpeed{0}); });
  chain.at(kNow + 0.3, [&] { chain.tell(commands::SetSpindleSpeed{40000 * rpm}); });
  Hand hand = pressed_hand();
  chain.play(hand.hold(1));
  const SceneLog& log = chain.log;
  const auto height = [&](double time) { return log.at(time).X_WH.translation.z(); };
  const double cutting = height(kNow - 0.1) - height(kNow);
  report.at_most("force step of stopping",
                 100 * std::abs(force_of(log.at(kNow + 0.05)) / force_of(log.at(kNow - 2e-3)) - 1), 10, "%");
  report.at_most("sinks while it stands", 1e3 * (height(kNow + 0.02) - height(kNow + 0.29)), 0.01, "mm");
  report.near("feed when it turns again", 1e3 * (height(kNow + 0.4) - height(kNow + 0.5)), 1e3 * cutting, 0.25, "mm",
              "in 0.1 s, as before");
  chain.judge();
}

}  // namespace

std::vector<Gesture> further_loop_gestures() {
  return {{"G28", "press the tip of a long tool, on a device that turns the hand", press_far_tip},
          {"G30", "lean the side of a turning bur on a wall", lean_on_wall},
          {"G31", "begin the run inside the bone", begin_inside},
          {"G32", "cut over the rim of the workspace", over_the_rim},
          {"G33", "hold the force, leave and come back", hold_and_leave},
          {"G34", "undo with the tool in the cavity", undo_in_cavity},
          {"G35", "change the scale in a cut, press again", change_scale},
          {"G36", "switch the spindle off in a cut and on again", stop_and_go},
          {"G37", "tap on enamel ten times a second", tap}};
}

}  // namespace hapticut::gestures
