// SPDX-License-Identifier: Apache-2.0
// Further gestures without a device: slow and fast motions, edges, borders, and heads that are too small.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::gestures {
namespace {

namespace forms = closed_forms;

/// [m^3] Volume of a ball below a surface, down to a depth less than its radius.
double cap_volume(double R, double depth) { return kPi * depth * depth * (R - depth / 3); }

// --- G38 -------------------------------------------------------------------------------------------------------------

void creep(Report& report) {
  constexpr double kRadius = 0.5 * mm, kFeed = 0.02 * mm, kDepth = 0.1 * mm, kSpin = 4000;
  report.scene("ball 1 mm, fed by 0.02 um in a tick, u 3e8 J/m^3, directly");
  const Tool ball = tool_of(SphereHead{kRadius}, Spindle{kSpin * units::rad_per_s});
  ScriptedLoop loop(report, slab(0.8 * mm, 0.6 * mm, report.voxel(), plain_material()), ball, Grip::directly);
  const double start = 1 * units::um;
  Hand hand(ball, Vec3(0.013 * mm, 0.007 * mm, start));
  const Span fed = loop.play(hand.move({0, 0, -kDepth - start}, (kDepth + start) / kFeed));
  const double removed = loop.log.sum(fed, removed_of);
  report.near("volume", 1e9 * removed, 1e9 * cap_volume(kRadius, kDepth), 0.05, "mm^3", "of the cap");
  const double thrust = loop.log.mean(fed.tail(0.1), thrust_of);
  report.near(
      "thrust", 1e3 * thrust,
      1e3 * forms::ball_plunge_wrench(steady_cut(plain_material(), {}, kSpin, kFeed), kRadius, 0.95 * kDepth).force.z(),
      0.1, "mN", "C28");
  report.quantity("thrust", 1e3 * thrust, "mN", 0.1);
  loop.judge();
}

// --- G39 -------------------------------------------------------------------------------------------------------------

void reverse_at_bottom(Report& report) {
  constexpr double kRadius = 0.8 * mm, kFeed = 2 * mm;
  report.scene("cylinder 1.6 mm that reverses from 3000 to -3000 rad/s in 30 ms while it is fed, directly");
  Spindle spindle{3000 * units::rad_per_s};
  spindle.acceleration_limit = 6000 / 0.03;
  const Tool bur = tool_of(FlatHead{kRadius, 3 * mm, FlatRule::bottom_only}, spindle);
  ScriptedLoop loop(report, slab(1.2 * mm, 1.8 * mm, report.voxel(), plain_material()), bur, Grip::directly);
  Hand hand(bur, Vec3(0, 0, 0.02 * mm));
  const Span before = loop.play(hand.move({0, 0, -0.5 * mm}, 0.5 * mm / kFeed)).tail(0.2);
  loop.simulation.spindle().set_speed(-3000 * units::rad_per_s);
  loop.play(loop.from_here().move({0, 0, -0.1 * mm}, 0.1 * mm / kFeed));
  const Span after = loop.play(loop.from_here().move({0, 0, -0.4 * mm}, 0.4 * mm / kFeed)).tail(0.2);
  report.near("thrust after", loop.log.mean(after, thrust_of), loop.log.mean(before, thrust_of), 0.1, "N", "as before");
  const auto torque = [](const Tick& t) { return t.felt.torque.z(); };
  report.near("torque after", 1e3 * loop.log.mean(after, torque), -1e3 * loop.log.mean(before, torque), 0.1, "N mm",
              "in the other direction");
  loop.judge();
}

// --- G40 -------------------------------------------------------------------------------------------------------------

void over_a_border(Report& report) {
  constexpr double kRadius = 0.8 * mm, kHeight = 0.6 * mm, kFeed = 4 * mm, kSpin = 4000;
  report.scene("side of a cylinder of 1.6 mm in a slot from u 3e8 into u 3e9 J/m^3, directly");
  Material soft = plain_material(), hard = plain_material();
  soft.name = "soft", hard.name = "hard";
  hard.specific_cutting_energy = 3e9;
  const double voxel = report.voxel();
  const Box box{Vec3(-2 * mm, -1.13 * mm, -kHeight), Vec3(2.4 * mm, 1.13 * mm, 0)};
  Workpiece piece = build_body({box, [=](const Vec3& p) { return box_distance(box, p); },
                                [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); }},
                               voxel, MaterialTable({soft, hard}), 4);
  const Tool bur = tool_of(FlatHead{kRadius, 3 * mm, FlatRule::side_only}, Spindle{kSpin * units::rad_per_s});
  ScriptedLoop loop(report, std::move(piece), bur, Grip::directly);
  Hand hand(bur, Vec3(-2 * mm - kRadius, 0, -kHeight - 0.5 * mm));
  loop.play(hand.move({3.4 * mm, 0, 0}, 3.4 * mm / kFeed));
  const double in_hard =
      forms::slotting_wrench(steady_cut(hard, {}, kSpin, kFeed), kRadius, kHeight).force.head<2>().norm();
  report.at_most("overshoot", loop.log.max_of(loop.log.all(), side_of) / in_hard, 1.1, "", "of C24 in the hard one");
  const double end = loop.log.mean(loop.log.all().tail(0.08), side_of);
  report.near("force behind it", end, in_hard, 0.1, "N", "C24");
  report.quantity("force behind it", end, "N", 0.1);
  loop.judge();
}

// --- G26 -------------------------------------------------------------------------------------------------------------

void slide_off_an_edge(Report& report) {
  constexpr double kRadius = 1 * mm, kForce = 2;
  for (const double speed : {5 * mm, 50 * mm}) {
    report.scene("ball 2 mm, standing, pressed with 2 N, slid off the edge of cortical bone at " +
                 shown(1e3 * speed, "mm/s") + ", coupled");
    Workpiece piece =
        build_block({Vec3(-3, -1.5, -3) * mm, Vec3(0, 1.5, 0) * mm}, report.voxel(), presets::cortical_bone());
    const Tool ball = tool_of(SphereHead{kRadius});
    ScriptedLoop loop(report, std::move(piece), ball, Grip::by_coupling);
    Hand hand(ball, Vec3(-1 * mm, 0.013 * mm, 0.1 * mm));
    hand.move({0, 0, -0.1 * mm - kForce / touch_gains().stiffness}, 0.1).hold(0.05);
    loop.play(hand);
    const Span slid = loop.play(loop.from_here().move({3 * mm, 0, 0}, 3 * mm / speed).hold(0.2));
    double sunk = 0;  // [m] below the surface of the bone
    for (std::size_t n = slid.first; n < slid.last; ++n) {
      const Vec3& p = loop.log.ticks[n].X_WH.translation;
      if (p.x() < -0.2 * mm) sunk = std::max(sunk, kRadius - p.z());
    }
    report.at_most("sinks before the edge", 1e3 * sunk, 0.1, "mm");
    report.at_most("force in the air", loop.log.max_of(loop.log.all().tail(0.01), force_of), 0.01, "N",
                   "0.2 s after it left");
    loop.judge();
  }
}

// --- G27 -------------------------------------------------------------------------------------------------------------

void tremor(Report& report) {
  constexpr double kRadius = 1 * mm, kPressed = 3 * mm;  // [m]; the spring of a Touch has 2.1 N at 3 mm
  double calm = 0;
  for (const bool trembling : {false, true}) {
    report.scene(std::string("ball 2 mm, 30 000 rpm, pressed with 2 N on cortical bone, ") +
                 (trembling ? "tremor of 0.2 mm at 8 ... 12 Hz" : "steady") + ", coupled");
    const Tool ball = tool_of(SphereHead{kRadius}, Spindle{30000 * rpm});
    ScriptedLoop loop(report, slab(2 * mm, 2 * mm, report.voxel(), presets::cortical_bone()), ball, Grip::by_coupling);
    Hand hand(ball, Vec3(0, 0, 0.1 * mm));
    hand.move({0, 0, -0.1 * mm - kPressed}, 0.1);
    const Pose middle = hand.end();
    for (int n = 0; n < 900; ++n) {
      const double t = n * 1e-3, phase = 2 * kPi * (8 * t + 2.2 * t * t);  // 8 Hz to 12 Hz
      Pose pose = middle;
      if (trembling)
        pose.translation += 0.2 * mm * Vec3(std::sin(phase), 0.7 * std::cos(1.1 * phase), 0.5 * std::sin(1.3 * phase));
      hand.to(pose, 1e-3);
    }
    loop.play(hand);
    const double removed = loop.log.sum(loop.log.all(), removed_of);
    report.quantity("removed volume", 1e9 * removed, "mm^3", 0.1);
    if (trembling) report.between("cuts", removed / calm, 1, 3, "", "of the steady hand; the tremor widens the hole");
    calm = removed;
    loop.judge();
  }
}

// --- G41 -------------------------------------------------------------------------------------------------------------

void sweep_from_afar(Report& report) {
  constexpr double kArm = 100 * mm, kSpeed = 2;  // [m], [rad/s]: 0.2 m/s at the head
  report.scene(
      "ball 2 mm on a handle of 100 mm, 30 000 rpm, swept through u 3e8 J/m^3 by turning it about its end, coupled");
  const Tool ball(SphereHead{1 * mm}, RayHandle{kArm}, Spindle{30000 * rpm});
  ScriptedLoop loop(report, build_block({Vec3(-2, -2, -3) * mm, Vec3(2, 2, 0) * mm}, report.voxel(), plain_material()),
                    ball, Grip::by_coupling);
  const Vec3 pivot(0, 0, kArm + 0.4 * mm);
  const double wide = 0.05;
  Hand hand(Pose{rotation_from_vector(Vec3(0, wide, 0)), pivot});
  hand.hold(0.02);
  for (int n = 0; n < 4; ++n)
    hand.turn({0, n % 2 == 0 ? -2 * wide : 2 * wide, 0}, pivot, 2 * wide / kSpeed).move({0, 0, -0.2 * mm}, 0.02);
  loop.play(hand.hold(0.3));
  report.at_most("force at rest", loop.log.mean(loop.log.all().tail(0.02), force_of), 0.01, "N",
                 "the tool is in free air");
  loop.judge();
}

// --- G29 -------------------------------------------------------------------------------------------------------------

void too_thin(Report& report) {
  for (const double size : {0.8, 1.2, 2.0}) {
    report.scene("ball of " + shown(size, "") + " voxels across, plunged by its radius into u 3e8 J/m^3, directly");
    const double R = 0.5 * size * report.voxel(), feed = R / 0.2;
    const Tool ball = tool_of(SphereHead{R}, Spindle{4000 * units::rad_per_s});
    try {
      ScriptedLoop loop(report, slab(4 * report.voxel(), 4 * report.voxel(), report.voxel(), plain_material()), ball,
                        Grip::directly);
      Hand hand(ball, Vec3(0.011 * mm, 0.017 * mm, 0));
      const Span fed = loop.play(hand.move({0, 0, -3 * R}, 3 * R / feed)).tail(0.3);
      report.near("thrust", loop.log.mean(fed, thrust_of),
                  forms::ball_plunge_wrench(steady_cut(plain_material(), {}, 4000, feed), R, R).force.z(), 0.2, "N",
                  "C28, or refused");
      loop.judge();
    } catch (const Error& refusal) {
      report.that("thrust", "C28 within 20 %, or refused", std::string("refused"), true);
    }
  }
}

}  // namespace

std::vector<Gesture> further_gestures() {
  return {{"G26", "slide a standing head off an edge", slide_off_an_edge},
          {"G27", "press a cutting head with a trembling hand", tremor},
          {"G29", "cut with a head as thin as a voxel", too_thin},
          {"G38", "creep into bone, a fiftieth of a micrometre in a tick", creep},
          {"G39", "reverse the spindle at the bottom of the hole", reverse_at_bottom},
          {"G40", "mill over the border of two materials", over_a_border},
          {"G41", "sweep through bone by turning about a far point", sweep_from_afar}};
}

}  // namespace hapticut::gestures
