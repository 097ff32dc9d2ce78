// SPDX-License-Identifier: Apache-2.0
// A standing head that is pressed and slid, and a standing or cutting head in a corner.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"

namespace hapticut::gestures {
namespace {

// --- G10 -------------------------------------------------------------------------------------------------------------

/// Pushes a ball into the corner of a floor and a wall, 5 mm beyond it, in several directions.
void corner(Report& report) {
  constexpr double kRadius = 1 * mm, kIn = 5 * mm;
  const Box box{Vec3(-2.5, -2.5, -2.5) * mm, Vec3(2, 2.5, 2) * mm};
  for (const bool cutting : {false, true}) {
    report.scene(std::string("ball 2 mm, ") + (cutting ? "turning" : "standing") + ", coupled");
    std::string unexplained, force;
    double worst = 0;  // [1] unexplained work
    bool bounded = true;
    for (const double kappa : {0.5, 1.0, 2.0, 3.3, 5.0}) {
      Material hard = plain_material();
      hard.cutting_ratio = kappa;
      hard.specific_cutting_energy = 1e11;  // too hard to be cut away
      Workpiece piece = carved(box, report.voxel(), hard, [](const Vec3& p) { return std::min(p.x(), p.z()); });
      const Tool ball = tool_of(SphereHead{kRadius}, Spindle{(cutting ? 30000 : 0) * rpm});
      ScriptedLoop loop(report, std::move(piece), ball, Grip::by_coupling);
      Hand hand(Pose::from_translation(Vec3(1.1, 0, 1.1) * mm));
      hand.hold(0.02);
      for (const double angle : {45.0, 20.0, 70.0})
        hand.to(Pose::from_translation(Vec3(1.1 * mm - kIn * std::cos(angle * units::deg), 0.2 * mm,
                                            1.1 * mm - kIn * std::sin(angle * units::deg))),
                0.12);
      loop.play(hand.to(Pose::from_translation(Vec3(1.3, 0, 1.3) * mm), 0.15));
      const CouplingEnergy e = loop.coupling().last_result().energy;
      const double lost = std::abs(e.closure()), most = loop.log.max_of(loop.log.all(), force_of);
      list(unexplained, "kappa " + shown(kappa, "") + ":", shown(100 * lost, "%"));
      list(force, "kappa " + shown(kappa, "") + ":", shown(most, "N"));
      worst = std::max(worst, lost);
      bounded = bounded && most <= 1.001 * loop.log.limits.force;
      if (kappa == 5.0) loop.judge();
    }
    report.that("converges", "less than 1 % of the work unexplained, or a status bit", unexplained, worst < 1e-2,
                worst / 1e-2);
    report.that("force", "at most 3.3 N, max_force of the coupling", force, bounded);
  }
}

// --- G11 -------------------------------------------------------------------------------------------------------------

/// A head, and the largest area that it crushes in a plate of a given thickness.
struct Punch {
  std::string name;
  ToolHead head;
  double (*area)(double thickness);  // [m^2]
  double radius;                     // [m] radius of the hole
  double travel;                     // [m] travel of the tip beyond the thickness, until the head is through
};

constexpr double kPunch = 0.5 * mm;             // [m] radius of ball and cylinder
constexpr double kConeHeight = 1.5 * mm;        // [m]
constexpr double kConeAngle = 20 * units::deg;  // half-apex angle

double cone_radius() { return kConeHeight * std::tan(kConeAngle); }
double area_of_punch(double) { return kPi * kPunch * kPunch; }
double area_of_ball(double t) { return t < kPunch ? kPi * (2 * kPunch * t - t * t) : kPi * kPunch * kPunch; }
double area_of_cone(double t) {
  return kPi * (std::pow(cone_radius(), 2) - std::pow(std::max(0.0, kConeHeight - t) * std::tan(kConeAngle), 2));
}

void plates(Report& report) {
  const std::vector<Punch> punches = {
      {"cylinder 1 mm", cylinder_head(2 * kPunch, 3 * mm), area_of_punch, kPunch, 0.3 * mm},
      {"ball 1 mm", SphereHead{kPunch}, area_of_ball, kPunch, 2 * kPunch + 0.1 * mm},
      {"cone of 40 degrees", ConeHead{kConeAngle, kConeHeight}, area_of_cone, cone_radius(), kConeHeight + 0.1 * mm}};
  for (const Material& bone : {presets::cortical_bone(), presets::trabecular_bone()})
    for (const Punch& punch : punches) {
      report.scene(punch.name + ", standing, plates of 0.2, 0.5, 1 mm of " + bone.name + ", directly");
      std::string resists, hole, energy;
      bool resisted = true, left = true, agrees = true;
      for (const double t : {0.2 * mm, 0.5 * mm, 1 * mm}) {
        const Tool tool = tool_of(punch.head);
        const double before = 0.05 * mm, way = before + t + punch.travel,
                     volume = kPi * punch.radius * punch.radius * t;
        ScriptedLoop loop(
            report, build_block({Vec3(-1.13, -1.17, -1e3 * t) * mm, Vec3(1.1, 1.1, 0) * mm}, report.voxel(), bone),
            tool, Grip::directly);
        Hand hand(tool, Vec3(0, 0, before));
        loop.play(hand.move({0, 0, -way}, way / (10 * mm)));
        const double solid_before = (1.1 + 1.13) * (1.1 + 1.17) * mm * mm * t;
        const double less = solid_before - loop.simulation.workpiece().amounts().front().volume;
        const double gone = less > 1e-6 * volume ? less : 0;  // a smaller loss is rounding in single precision
        const double most = loop.log.max_of(loop.log.all(), thrust_of);
        const double strength = strength_of(bone) * punch.area(t);
        // The remaining wall presses on the side; friction there adds to the resistance.
        const double rubs = strength_of(bone) * bone.static_friction * 2 * kPi * punch.radius * t;
        const double crushed = loop.simulation.last_result().energy.crushed;
        list(resists, shown(1e3 * t, "mm") + ":", shown(most, "N") + " of " + shown(strength, "N"));
        list(hole, shown(1e3 * t, "mm") + ":", shown(100 * gone / volume, "%"));
        list(energy, shown(1e3 * t, "mm") + ":",
             shown(1e3 * crushed, "mJ") + " of " + shown(1e3 * strength_of(bone) * gone, "mJ"));
        resisted = resisted && most > 0.6 * strength && most < 1.1 * (strength + rubs);
        left = left && gone > 0.6 * volume && gone < 1.1 * volume;
        agrees = agrees && gone > 0 && std::abs(crushed - strength_of(bone) * gone) < 0.1 * crushed;
        if (t == 1 * mm) loop.judge();
      }
      report.that("resists", "0.6 of strength times crushed area ... 1.1 of that and friction on the wall", resists,
                  resisted);
      report.that("leaves a hole", "0.6 ... 1.1 of pi R^2 t", hole, left);
      report.that("energy of the hole", "what crushing took is strength times its volume, within 10 %", energy, agrees);
    }
}

// --- G13 -------------------------------------------------------------------------------------------------------------

void groove(Report& report) {
  constexpr double kRadius = 1 * mm, kPressed = 30 * units::um, kLeft = 0.1, kRight = 0.5;
  Material left = plain_material(), right = plain_material();
  left.name = "left", left.static_friction = left.dynamic_friction = kLeft;
  right.name = "right", right.static_friction = right.dynamic_friction = kRight;
  const Box box{Vec3(-1.7, -2.3, -2) * mm, Vec3(1.7, 2.3, 0) * mm};
  for (const Grip grip : {Grip::directly, Grip::by_coupling}) {
    report.scene(std::string("ball 2 mm, standing, slid along a V of 90 degrees, mu 0.1 and 0.5, ") +
                 (grip == Grip::directly ? "directly" : "coupled"));
    Workpiece piece =
        build_body({box,
                    [=](const Vec3& p) {  // the walls rise from a line 1.6 mm below the top
                      return std::max(box_distance(box, p), (p.z() + 1.6 * mm - std::abs(p.x())) / std::sqrt(2));
                    },
                    [](const Vec3& p) { return MaterialId(p.x() < 0 ? 1 : 2); }},
                   report.voxel(), MaterialTable({left, right}), 8);
    ScriptedLoop loop(report, std::move(piece), tool_of(SphereHead{kRadius}), grip);
    const double seat = -1.6 * mm + std::sqrt(2) * kRadius;  // [m] height of the ball's centre
    const double pressed = grip == Grip::directly ? std::sqrt(2) * kPressed : 2.0 / touch_gains().stiffness;
    Hand hand(Pose::from_translation(Vec3(0, -1 * mm, seat + 0.2 * mm)));
    hand.move({0, 0, -0.18 * mm}, 0.1).hold(0.02);  // a tool that begins in contact would wait
    hand.move({0, 0, -0.02 * mm - pressed}, 0.05).hold(0.02);
    const Span slid = loop.play(hand.move({0, grip == Grip::directly ? 1.5 * mm : 2.5 * mm, 0}, 0.4)).tail(0.3);
    const double along = -loop.log.mean(slid, [](const Tick& t) { return t.model.force.y(); });
    const double normal = loop.log.mean(slid, [](const Tick& t) { return t.model.force.z(); }) / std::sqrt(2);
    report.near("friction", along, (kLeft + kRight) * normal, 0.1, "N", "mu of each wall on its own normal force");
    loop.judge();
  }
}

// --- G14 -------------------------------------------------------------------------------------------------------------

void press_by_default(Report& report) {
  constexpr double kForce = 2;  // [N]
  for (const NamedHead& named : catalogue()) {
    report.scene(named.name + ", standing, coupled");
    const Tool tool = tool_of(named.head);
    const double radius = named.head.max_radius();
    std::string indents;
    double worst = 0;
    for (const Material& material : {presets::enamel(), presets::dentin(), presets::cortical_bone()}) {
      ScriptedLoop loop(report, slab(radius + 0.5 * mm, 2 * mm, report.voxel(), material), tool, Grip::by_coupling);
      Hand hand(tool, Vec3(0.013, 0.021, 0.1) * mm);
      hand.hold(0.01).move({0, 0, -0.1 * mm - kForce / touch_gains().stiffness}, 0.15);
      loop.play(hand.hold(0.15));
      const double depth = tip_below_hand(tool) - loop.log.ticks.back().X_WH.translation.z();
      const double k = loop.simulation.config().reference_stiffness * material.relative_stiffness;
      const double bound = std::max(0.05 * radius, 1.2 * pressed_depth(named.head, kForce, material, k));
      list(indents, material.name, shown(1e6 * depth, "um") + " of " + shown(1e6 * bound, "um"));
      worst = std::max(worst, depth / bound);
      if (material.name == "cortical_bone") loop.judge();
    }
    report.that("indents",
                "at most 0.05 R under 2 N, or 1.2 of the depth at which foundation and strength carry the force",
                indents, worst <= 1);
  }
}

}  // namespace

std::vector<Gesture> press_gestures() {
  return {{"G10", "push into the corner of two faces", corner},
          {"G11", "press a standing head through plates", plates},
          {"G13", "slide along a groove of two materials", groove},
          {"G14", "press with 2 N, all settings left to the program", press_by_default}};
}

}  // namespace hapticut::gestures
