// SPDX-License-Identifier: Apache-2.0
// A tool in a hole that it has drilled, or in a prepared hole.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"
#include "hapticut/tool/profile.hpp"

namespace hapticut::gestures {
namespace {

constexpr double kDrillRadius = 1 * mm;  // [m]
constexpr double kDrillLength = 6 * mm;  // [m]
constexpr double kHoleDepth = 3 * mm;    // [m] depth of the tip
constexpr Vec3::Scalar kFeed = 5 * mm;   // [m/s]
constexpr double kPointAngle = 118 * units::deg;

/// A head that drills a hole, and the height of its point.
struct Borer {
  std::string name;
  ToolHead head;
  double point;  // [m]
};

/// A head that cuts only with its end.
ToolHead end_cutting_head(double radius, double length) {
  return ProfileHead({0, {{radius, 0}, {radius, length, 0, EdgeKind::smooth}, {0, length, 0, EdgeKind::smooth}}});
}

std::vector<Borer> borers() {
  return {{"twist drill 2 mm", twist_drill_head(2 * kDrillRadius, kDrillLength, kPointAngle),
           kDrillRadius / std::tan(kPointAngle / 2)},
          {"cylinder 2 mm", cylinder_head(2 * kDrillRadius, kDrillLength), 0},
          {"round-end cylinder 2 mm", round_end_cylinder_head(2 * kDrillRadius, kDrillLength), kDrillRadius},
          {"end-cutting bur 2 mm", end_cutting_head(kDrillRadius, kDrillLength), 0}};
}

Material bone_of(bool cortical) {
  return cortical ? presets::cortical_bone(CutterKind::twist_drill) : presets::trabecular_bone(CutterKind::twist_drill);
}

/// A spinning drill that was driven directly down to kHoleDepth and rests there.
struct Drilled {
  Drilled(Report& report, const Borer& borer, const Material& bone)
      : tool(tool_of(borer.head, Spindle{3000 * rpm}, {CutterKind::twist_drill, 2})),
        loop(report, slab(1.8 * mm, 4 * mm, report.voxel(), bone), tool, Grip::directly, at_the_end()) {
    Hand hand(tool, Vec3(0, 0, 0.1 * mm));
    loop.play(hand.move({0, 0, -0.1 * mm - kHoleDepth}, (0.1 * mm + kHoleDepth) / kFeed).hold(0.05));
  }
  static SimulationConfig at_the_end() {
    SimulationConfig config;
    config.contact_time = ContactTime::end;
    return config;
  }
  /// Stops the spindle and puts a coupling between hand and drill.
  void stop_and_couple() {
    loop.simulation.spindle().set_speed(AngularSpeed{});
    loop.couple(touch_gains());
  }

  Tool tool;
  ScriptedLoop loop;
};

/// [m^2] Part of a disk of radius R, moved by x, that lies outside its old place.
double crescent(double R, double x) {
  return kPi * R * R - 2 * R * R * std::acos(x / (2 * R)) + x / 2 * std::sqrt(4 * R * R - x * x);
}
double axial_of(const Tick& tick) { return std::abs(tick.felt.force.z()); }

/// The tool must hardly move while the hand follows a path.
void demand_to_stay(Report& report, ScriptedLoop& loop, const Hand& hand, const std::string& why = "") {
  const Vec3 before = loop.log.ticks.back().X_WH.translation;
  loop.play(hand);
  const Vec3 strayed = loop.log.ticks.back().X_WH.translation - before;
  report.at_most("strays sideways", 1e3 * strayed.head<2>().norm(), 0.1, "mm", why);
  report.at_most("climbs", 1e3 * std::abs(strayed.z()), 0.1, "mm");
  loop.judge();
}

void drill_lift_push(Report& report) {
  constexpr double kLift = 0.6 * mm, kPush = 0.5 * mm;
  for (const Borer& borer : borers()) {
    report.scene(borer.name + ", cortical bone, directly");
    const Material bone = bone_of(true);
    Drilled drilled(report, borer, bone);
    drilled.loop.simulation.spindle().set_speed(AngularSpeed{});
    drilled.loop.play(drilled.loop.from_here().move({0, 0, kLift}, 0.06).hold(0.02));
    // A closed path: sideways, out, back over the hole, and down again to the start.
    const double before = drilled.loop.simulation.last_result().energy.hand_work;
    const Span pushed = drilled.loop.play(drilled.loop.from_here().move({kPush, 0, 0}, 0.1).hold(0.02));
    const SceneLog& log = drilled.loop.log;
    Hand out = drilled.loop.from_here();
    out.move({0, 0, kHoleDepth}, 0.3).move({-kPush, 0, 0}, 0.02).move({0, 0, -kHoleDepth}, 0.3);
    const Span round = {pushed.first, drilled.loop.play(out).last};
    const double cost = log.ticks.back().energy.hand_work - before;
    double turned = 0;
    for (std::size_t n = round.first; n < round.last; ++n)
      turned += std::abs(log.ticks[n].energy.hand_work - log.ticks[n - 1].energy.hand_work);

    // The wall in front of the head bears the springs' force up to the strength; friction holds the flanks. The end
    // presses on the layer below it wherever it lies outside its hole.
    const double inside = kHoleDepth - kLift, length = inside - borer.point;
    const double strength = strength_of(bone), outside = crescent(kDrillRadius, kPush);
    const double k = drilled.loop.simulation.config().reference_stiffness * bone.relative_stiffness;
    const double springs = 2.0 / 3 * k * std::pow(kSmoothScale * kPush, 2) * kDrillRadius * length;
    const double side = log.max_of(pushed, side_of), axial = log.max_of(pushed, axial_of);
    report.between("side force", side, 0.5 * std::min(strength * 2 * kDrillRadius * length, springs),
                   strength * ((1 + bone.static_friction) * 2 * kDrillRadius * inside + bone.static_friction * outside),
                   "N",
                   "half of strength times 2 R L or of (2/3) k (beta x)^2 R L ... strength and friction on all of it");
    report.quantity("side force", side, "N", 0.3);
    report.at_most("axial force", axial, kPush / (3 * length) * side + strength * outside, "N",
                   "x/(3L) of the side force, and strength times the area of the end outside the hole");
    report.at_least("closed path", 1e3 * cost, -1e-3 * 1e3 * turned, "mJ",
                    "sideways, out, back and in again: a thousandth of the turnover");
    drilled.loop.judge();
  }
  report.scene("twist drill 2 mm, trabecular bone, coupled");
  Drilled drilled(report, borers().front(), bone_of(false));
  drilled.stop_and_couple();
  drilled.loop.play(drilled.loop.from_here().move({0, 0, kLift}, 0.2).hold(0.1));
  demand_to_stay(report, drilled.loop, drilled.loop.from_here().move({1 * mm, 0, 0}, 0.2).hold(0.3), "0.7 N of spring");
}

void tilt_in_hole(Report& report) {
  constexpr double kSpeed = 20 * units::deg;  // [rad/s]
  const Borer borer = borers().front();
  report.scene(borer.name + ", cortical bone, turning, tilted about the middle of its hole, directly");
  Drilled drilled(report, borer, bone_of(true));
  const Vec3 middle(0, 0, -0.5 * kHoleDepth);
  const double length = kHoleDepth - borer.point;
  const double thrust =
      drilled.loop.log.ticks.back().felt.force.z();  // [N] the edges on the bottom, below their cutting threshold
  double before = 0;
  for (const double angle : {1.0, 2.0, 5.0}) {
    Hand tilt = before == 0 ? drilled.loop.from_here() : Hand(drilled.loop.log.ticks.back().X_WD);
    tilt.turn({0, (angle - before) * units::deg, 0}, middle, (angle - before) * units::deg / kSpeed);
    drilled.loop.play(tilt);
    before = angle;
    const Tick& tick = drilled.loop.log.ticks.back();
    const double couple = transport(tick.felt, tick.X_WD.translation - middle).torque.y();
    const std::string at = " at " + shown(angle, "deg");
    report.at_most("couple" + at, 1e3 * couple, 0, "N mm", "against the tilt");
    report.at_most("ejection" + at, tick.felt.force.z() - thrust, 0.15 * std::abs(couple) / (length / 3) + 0.3, "N",
                   "beyond " + shown(thrust, "N") + " before: 15 % of the side forces couple/(L/3), and 0.3 N");
  }
  drilled.loop.judge();
}

void pull_standing_drill(Report& report) {
  constexpr double kPull = 1;  // [N]
  for (const Borer& borer : {borers()[0], borers()[1], borers()[2]}) {
    report.scene(borer.name + ", standing in its hole in trabecular bone, coupled");
    Drilled drilled(report, borer, bone_of(false));
    drilled.stop_and_couple();
    drilled.loop.play(drilled.loop.from_here().hold(0.1));
    demand_to_stay(report, drilled.loop,
                   drilled.loop.from_here().move({kPull / touch_gains().stiffness, 0, 0}, 0.3).hold(0.5));
  }
}

/// A ball on a shank.
ToolHead ball_on_shank(double ball, double shank, double length) {
  return ProfileHead(Profile{0,
                             {{ball, ball, ball},
                              {shank, 2 * ball, 0, EdgeKind::smooth},
                              {shank, length, 0, EdgeKind::smooth},
                              {0, length, 0, EdgeKind::smooth}}});
}

void shank_on_rim(Report& report) {
  constexpr double kHole = 0.8 * mm, kDepth = 4 * mm, kBall = 0.4 * mm, kShank = 0.6 * mm, kAngle = 4 * units::deg;
  for (const int turns : {0, 30000}) {
    report.scene(std::string("ball 0.8 mm on a shank of 1.2 mm, ") + (turns > 0 ? "turning" : "standing") +
                 ", tilted in a hole of 1.6 mm, directly");
    const Tool tool = tool_of(ball_on_shank(kBall, kShank, 8 * mm), Spindle{turns * rpm});
    ScriptedLoop loop(report,
                      with_hole(2 * mm, kDepth + 0.5 * mm, report.voxel(), presets::cortical_bone(), kHole, kDepth),
                      tool, Grip::directly);
    Hand hand(tool, Vec3(0, 0, -kDepth + 0.1 * mm));
    const Vec3 ball_center(0, 0, -kDepth + 0.1 * mm + kBall);
    const Span tilted = loop.play(hand.hold(0.02).turn({0, kAngle, 0}, ball_center, 0.4).hold(0.05));
    // The shank is d deep in the rim. It is less deep below the rim and on both sides of the deepest line. With w =
    // beta d at that line, F = (8/15) k beta^2 r sqrt(2/(R - r)) d^3.5/(3.5 tan a).
    const double deep = -ball_center.z() * std::tan(kAngle) + kShank / std::cos(kAngle) - kHole;
    const double k = loop.simulation.config().reference_stiffness * presets::cortical_bone().relative_stiffness;
    const double force = 8.0 / 15 * k * std::pow(kSmoothScale, 2) * kShank * std::sqrt(2 / (kHole - kShank)) *
                         std::pow(deep, 3.5) / (3.5 * std::tan(kAngle));
    report.between("rim pushes", loop.log.max_of(tilted, side_of), force / 2, 2 * force, "N",
                   "the shank is " + shown(1e3 * deep, "mm") + " in the rim");
    const double cut = loop.log.ticks.back().energy.cutting - loop.log.ticks[tilted.first].energy.cutting;
    report.at_most("shank cuts", 1e3 * cut, 1e-6, "mJ", "material of the rim is only crushed");
    loop.judge();
  }
}

void press_fit(Report& report) {
  constexpr double kPin = 1 * mm, kHole = 0.95 * mm, kIn = 2 * mm;
  report.scene("cylinder 2 mm, standing, 2 mm deep in a hole of 1.9 mm in cortical bone, directly");
  const Material bone = presets::cortical_bone();
  const Tool pin = tool_of(cylinder_head(2 * kPin, 4 * mm));
  ScriptedLoop loop(report, with_hole(1.8 * mm, 3.4 * mm, report.voxel(), bone, kHole, 2.8 * mm), pin, Grip::directly);
  Hand hand(pin, Vec3(0, 0, -kIn));
  loop.play(hand.hold(0.02));
  loop.log.begin(loop.simulation);  // the tool was placed in the hole without work
  const double k = loop.simulation.config().reference_stiffness * bone.relative_stiffness;
  const auto squeeze = [&](double length) {  // [N] sum of the normal forces: pressure k w^2/2 on the wall
    return k * std::pow(kPin - kHole, 2) / 2 * 2 * kPi * kHole * length;
  };
  constexpr double kPulled = 0.2 * mm;
  const Span turned = loop.play(loop.from_here().turn({0, 0, 0.3}, Vec3::Zero(), 0.15));
  report.near("torque", 1e3 * -loop.log.mean(turned.tail(0.2), [](const Tick& t) { return t.felt.torque.z(); }),
              1e3 * bone.dynamic_friction * squeeze(kIn) * kHole, 0.2, "N mm", "mu times the sum of normal forces, R");
  const Span pulled = loop.play(loop.from_here().move({0, 0, kPulled}, 0.1));
  report.near("pull", -loop.log.mean(pulled.tail(0.2), thrust_of), bone.dynamic_friction * squeeze(kIn - kPulled), 0.2,
              "N", "mu times the sum of normal forces");
  loop.judge();
}

}  // namespace

std::vector<Gesture> hole_gestures() {
  return {{"G1", "drill 3 mm, stop, lift 0.6 mm, push sideways, lift out", drill_lift_push},
          {"G2", "tilt the turning drill in its own hole", tilt_in_hole},
          {"G3", "pull the standing drill sideways in its hole by 1 N", pull_standing_drill},
          {"G4", "lean the shank on the rim of a deep narrow hole", shank_on_rim},
          {"G12", "pull and turn a pin with a press fit of 0.05 mm", press_fit}};
}

}  // namespace hapticut::gestures
