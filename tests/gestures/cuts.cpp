// SPDX-License-Identifier: Apache-2.0
// A head that cuts.
#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"
#include "hapticut/islands/island_watch.hpp"

namespace hapticut::gestures {
namespace {

namespace forms = closed_forms;
using forms::SteadyCut;

SteadyCut cut_of(const Material& m, const Tool& tool, double feed) {
  return steady_cut(m, tool.cutter(), std::abs(tool.spindle().speed), feed);
}

// --- G15 -------------------------------------------------------------------------------------------------------------

/// A plunge at constant feed, driven directly. @return [N] mean thrust of the last fifth
double thrust_of_plunge(Report& report, const Tool& tool, const Material& material, double feed, double depth) {
  ScriptedLoop loop(report, slab(1.5 * mm, depth + 0.4 * mm, report.voxel(), material), tool, Grip::directly);
  Hand hand(tool, Vec3(0, 0, 0.02 * mm));
  const Span fed = loop.play(hand.move({0, 0, -depth}, depth / feed));
  loop.judge();
  return loop.log.mean(fed.tail(0.2), thrust_of);
}

/// C29 for a drill's point with an energy that depends on the chip: each point of the surface recedes with the feed
/// times the sine of half the point angle.
double thrust_of_drill(const SteadyCut& cut, double R, double half_angle) {
  SteadyCut normal = cut;
  normal.feed_speed *= std::sin(half_angle);
  return forms::axial_chip_wrench(normal, R).force.z();
}

void cut_by_default(Report& report) {
  const auto hold_to = [&](const std::string& scene, const Tool& tool, const Material& material, double feed,
                           double depth, double expected, const std::string& why) {
    report.scene(scene);
    const double seen = thrust_of_plunge(report, tool, material, feed, depth);
    report.near("thrust", seen, expected, 0.1, "N", why);
    report.quantity("thrust", seen, "N", 0.1);
  };
  const Tool flat = tool_of(FlatHead{1 * mm, 3 * mm, FlatRule::bottom_only}, Spindle{2000 * units::rad_per_s});
  hold_to("flat 2 mm, u 3e8 J/m^3, 2 mm/s, directly", flat, plain_material(), 2 * mm, 0.3 * mm,
          forms::axial_cutting_force_of_a_flat_head(cut_of(plain_material(), flat, 2 * mm), 1 * mm), "C20");
  const Tool ball = tool_of(SphereHead{1 * mm}, Spindle{2000 * units::rad_per_s});
  hold_to("ball 2 mm, u 3e8 J/m^3, 4 mm/s, directly", ball, plain_material(), 4 * mm, 1.3 * mm,
          forms::ball_plunge_wrench(cut_of(plain_material(), ball, 4 * mm), 1 * mm, 1.2 * mm).force.z(), "C28");
  const Material bone = presets::cortical_bone(CutterKind::twist_drill);
  const Tool drill = tool_of(twist_drill_head(2 * mm, 4 * mm), Spindle{1000 * rpm}, {CutterKind::twist_drill, 2});
  hold_to("twist drill 2 mm, 1000 rpm, cortical bone, 2 mm/s, directly", drill, bone, 2 * mm, 1 * mm,
          thrust_of_drill(cut_of(bone, drill, 2 * mm), 1 * mm, 59 * units::deg), "C29 with chips");
  const Material enamel = presets::enamel(CutterKind::fine_diamond);
  const Tool diamond = tool_of(FlatHead{0.6 * mm, 3 * mm, FlatRule::bottom_only}, Spindle{300000 * rpm},
                               Cutter{CutterKind::fine_diamond});
  hold_to("fine diamond 1.2 mm, 300 000 rpm, enamel, 0.5 mm/s, directly", diamond, enamel, 0.5 * mm, 0.15 * mm,
          forms::axial_chip_wrench(cut_of(enamel, diamond, 0.5 * mm), 0.6 * mm).force.z(), "C35");
}

// --- G18 -------------------------------------------------------------------------------------------------------------

void side_milling(Report& report) {
  constexpr double kRadius = 1 * mm, kHeight = 1 * mm, kFeed = 4 * mm, kWay = 1.6 * mm;
  for (const bool climb : {true, false}) {
    report.scene(std::string("cylinder 2 mm, 1 mm deep, half of it engaged, ") + (climb ? "climb" : "conventional") +
                 ", directly");
    std::string seen;
    bool pass = true;
    for (const double kappa : {0.5, 1.6, 3.3}) {
      Material material = plain_material();
      material.cutting_ratio = kappa;
      // The feed is along +x and the spin is about +z, so at +y a chip begins with its full thickness.
      const double low = climb ? 0 : -1.7 * mm, high = climb ? 1.7 * mm : 0;
      Workpiece piece = build_block({Vec3(-1.57 * mm, low, -kHeight), Vec3(3 * mm, high, 0)}, report.voxel(), material);
      const Tool tool = tool_of(FlatHead{kRadius, 3 * mm, FlatRule::side_only}, Spindle{3000 * units::rad_per_s});
      ScriptedLoop loop(report, std::move(piece), tool, Grip::directly);
      Hand hand(tool, Vec3(-2.6 * mm, 0, -kHeight - 0.5 * mm));
      const Span fed = loop.play(hand.move({kWay + 1 * mm, 0, 0}, (kWay + 1 * mm) / kFeed)).tail(0.15);
      const Wrench form = forms::side_milling_wrench(cut_of(material, tool, kFeed), kRadius, kHeight,
                                                     climb ? 0 : -kPi / 2, climb ? kPi / 2 : 0);
      const Vec3 force(loop.log.mean(fed, [](const Tick& t) { return t.felt.force.x(); }),
                       loop.log.mean(fed, [](const Tick& t) { return t.felt.force.y(); }), 0);
      const double error = (force - form.force).norm() / form.force.norm();
      list(seen, "kappa " + shown(kappa, "") + ":", shown(force.norm(), "N") + ", off by " + shown(100 * error, "%"));
      pass = pass && error <= 0.1;
      if (kappa == 0.5) loop.judge();
      if (kappa == 0.5) report.quantity("force", force.norm(), "N", 0.05);
    }
    report.that("force", "C25 in direction and size, within 10 %", seen, pass);
  }
}

// --- G19 -------------------------------------------------------------------------------------------------------------

void undercut(Report& report) {
  report.scene("ball 0.8 mm through the stem of a mushroom, directly");
  const Box box{Vec3(-1.2, -1.2, -2.4) * mm, Vec3(1.2, 1.2, 0) * mm};
  Workpiece piece = carved(box, report.voxel(), plain_material(), [](const Vec3& p) {
    const double stem = std::max(std::hypot(p.x(), p.y()) - 0.3 * mm, std::max(-1.8 * mm - p.z(), p.z() + 0.5 * mm));
    const double cap = std::max(-0.8 * mm - p.z(), std::hypot(p.x(), p.y()) - 1 * mm);
    return std::min({stem, cap, p.z() + 1.7 * mm});
  });
  const Tool ball = tool_of(SphereHead{0.4 * mm}, Spindle{40000 * rpm});
  ScriptedLoop loop(report, std::move(piece), ball, Grip::directly);
  Hand hand(Pose::from_translation(Vec3(-1.6, 0, -1.25) * mm));
  for (const double side : {-0.3, 0.0, 0.3})
    hand.to(Pose::from_translation(Vec3(-1.2, side, -1.25) * mm), 0.05)
        .move({2.2 * mm, 0, 0}, 0.15)
        .move({-2.2 * mm, 0, 0}, 0.1);
  loop.play(hand.hold(0.05));
  const Workpiece& left = loop.simulation.workpiece();
  int ticks = 0;
  for (Island& found : find_islands(left)) {
    IslandRemoval leaving{std::move(found)};
    do ++ticks;
    while (!remove_island(loop.simulation, leaving, IslandWatchOptions{}.blocks_per_tick));
  }
  report.at_most("leaves within", 1e3 * (IslandWatchOptions{}.period + ticks * report.period), 50, "ms",
                 "the period of IslandWatch and its ticks, without the search");
  double island = 0;
  const double voxel = report.voxel();
  const IndexBox bounds = left.bounds();
  for (int i = bounds.min[0]; i <= bounds.max[0]; ++i)
    for (int j = bounds.min[1]; j <= bounds.max[1]; ++j)
      for (int k = bounds.min[2]; k <= bounds.max[2]; ++k) {
        const Vec3 p = left.frame().X_WV * Vec3(voxel * Vec3(i, j, k));
        if (p.z() > -0.7 * mm) island += left.fill_at({i, j, k});
      }
  report.at_most("island", 1e9 * island * std::pow(voxel, 3), 0, "mm^3", "the free cap must be removed within 50 ms");
  loop.judge();
}

// --- G20 -------------------------------------------------------------------------------------------------------------

void break_through(Report& report) {
  constexpr double kPlate = 0.6 * mm, kGap = 2 * mm, kForce = 5, kRadius = 1 * mm;
  report.scene("ball 2 mm, 30 000 rpm, omega in a nominal hand that wants 5 N, u 3e8 J/m^3, coupled");
  const Box box{Vec3(-1.5, -1.5, -4.6) * mm, Vec3(1.5, 1.5, 0) * mm};
  Workpiece piece = carved(box, report.voxel(), plain_material(), [](const Vec3& p) {
    return std::min(-kPlate - p.z(), p.z() + kPlate + kGap);  // between the plates
  });
  const Tool ball = tool_of(SphereHead{kRadius}, Spindle{30000 * rpm});
  DeviceChain chain(report, std::move(piece), ball, {.device = "omega", .hand = "nominal"});
  const double reach = kForce / hand_model("nominal").stiffness;
  Hand hand(Pose::from_translation(Vec3(0, 0, kRadius + 0.5 * mm)));
  chain.play(hand.move({0, 0, -0.5 * mm - reach}, 0.3).hold(0.9));
  // The ball has broken through when its lowest point has passed the plate.
  const SceneLog& log = chain.log;
  std::size_t through = log.ticks.size(), meets = log.ticks.size();
  const auto tip = [](const Tick& tick) { return tick.X_WH.translation.z() - kRadius; };
  for (std::size_t n = 0; n < log.ticks.size(); ++n) {
    if (through == log.ticks.size() && tip(log.ticks[n]) < -kPlate - 0.5 * mm) through = n;
    if (meets == log.ticks.size() && tip(log.ticks[n]) < -kPlate - kGap) meets = n;
  }
  const bool came = meets < log.ticks.size();
  report.that("breaks through", "within 1.2 s", came ? shown(log.ticks[meets].time, "s") : "not", came);
  if (!came) return chain.judge();
  double down = 0, up = 0;
  for (std::size_t n = through + 1; n < log.ticks.size(); ++n) {
    const double v = (tip(log.ticks[n]) - tip(log.ticks[n - 1])) / report.period;
    if (n <= meets)
      down = std::max(down, -v);
    else
      up = std::max(up, v);
  }
  report.at_most("rebound", up / down, 1.05, "", "speed back over speed of the plunge");
  report.at_most("plunge", down, 1, "m/s");
  const Span after{meets, std::min(meets + std::size_t(std::lround(0.03 / report.period)), log.ticks.size())};
  // The depth that the ball reaches by C28 under the largest force of the plunge, starting at the surface.
  const double most = log.max_of(after, force_of);
  double bound = 0.05 * mm;
  for (std::size_t n = after.first; n < after.last; ++n) {
    const double per_speed = forms::ball_plunge_wrench(cut_of(plain_material(), ball, 1), kRadius, bound).force.z();
    bound += most / per_speed * report.period;
  }
  report.at_most("into the second plate", 1e3 * -(kPlate + kGap + log.min_of(after, tip)), 1e3 * bound, "mm",
                 "depth of C28 under the largest force in 30 ms, and 0.05 mm");
  chain.judge();
}

// --- G21 -------------------------------------------------------------------------------------------------------------

void wiggle_in_slot(Report& report) {
  constexpr double kRadius = 1 * mm;
  report.scene("cylinder 2 mm, 30 000 rpm, slot of its width, Premium of six motors, u 3e9 J/m^3, coupled");
  const Box box{Vec3(-3, -2, -2.5) * mm, Vec3(3, 2, 0) * mm};
  Material hard = plain_material();
  hard.specific_cutting_energy = 3e9;
  Workpiece piece = carved(box, report.voxel(), hard,
                           [](const Vec3& p) { return std::min(kRadius * 1.01 - std::abs(p.y()), p.z() + 2 * mm); });
  const Tool bur = tool_of(FlatHead{kRadius, 4 * mm}, Spindle{30000 * rpm});
  DeviceChain chain(report, std::move(piece), bur, {.device = "premium6dof"});
  Hand hand(bur, Vec3(0, 0, 0.3 * mm));
  hand.move({0, 0, -1.5 * mm}, 0.2);
  for (int n = 0; n < 3; ++n)
    hand.move({0.3 * mm, 0.8 * mm, 0}, 0.08)
        .turn({3 * units::deg, 0, 0}, hand.end().translation, 0.05)
        .move({-0.3 * mm, -1.6 * mm, 0}, 0.16)
        .turn({-3 * units::deg, 0, 0}, hand.end().translation, 0.05)
        .move({0, 0.8 * mm, 0}, 0.08);
  const double moved = hand.seconds();
  chain.play(hand.move({0, 1 * mm, 0}, 0.1).hold(0.4));
  const Span rest = chain.log.within(moved + 0.3, moved + 0.5);
  demand_steady(report, chain.log, rest);
  chain.judge();
}

// --- G25 -------------------------------------------------------------------------------------------------------------

void along_the_grid(Report& report) {
  struct Bur {
    std::string name;
    ToolHead head;
    double speed, radius;  // [rad/s], [m]
    Material material;
  };
  for (const Bur& bur : {Bur{"cylinder 3 mm, 40 000 rpm", cylinder_head(3 * mm, 5 * mm), 40000 * rpm, 1.5 * mm,
                             presets::cortical_bone()},
                         Bur{"tapered fissure 1 mm, 300 000 rpm", tapered_head(0.8 * mm, 1 * mm, 4 * mm), 300000 * rpm,
                             0.4 * mm, presets::enamel()}}) {
    report.scene(bur.name + ", " + bur.material.name + ", loop mock:press, coupled");
    const Tool tool = tool_of(bur.head, Spindle{bur.speed * units::rad_per_s});
    DeviceChain chain(report, build_block({Vec3(-2, -2, -4) * mm, Vec3(2, 2, 0) * mm}, report.voxel(), bur.material),
                      tool);
    // The script of mock:press moves the hand from 5 mm above the surface to 5 mm below it in 2 s, and holds it there.
    Hand hand(tool, Vec3(0, 0, 5 * mm));
    chain.play(hand.move({0, 0, -10 * mm}, 2).hold(0.5));
    const Span held = chain.log.within(2.1, 2.5);
    const double force = chain.log.mean(held, thrust_of);
    const Tick &from = chain.log.ticks[held.first], &to = chain.log.ticks[held.last - 1];
    const double feed = (from.X_WH.translation.z() - to.X_WH.translation.z()) / (to.time - from.time);
    const double expected = forms::feed_with_chips_under(force, cut_of(bur.material, tool, 1e-3), bur.radius);
    report.quantity("feed", 1e3 * feed, "mm/s", 0.1);
    report.near("feed", 1e3 * feed, 1e3 * expected, 0.2, "mm/s", "C36 under the " + shown(force, "N") + " on the hand");
    chain.judge();
  }
}

}  // namespace

std::vector<Gesture> cutting_gestures() {
  return {{"G15", "cut, all settings left to the program", cut_by_default},
          {"G18", "mill with the side, climb and conventional", side_milling},
          {"G19", "undercut a piece until it is free", undercut},
          {"G20", "break through a plate onto a second one", break_through},
          {"G21", "wiggle a turning bur in its slot", wiggle_in_slot},
          {"G25", "press a flat-ended bur along the grid, by default", along_the_grid}};
}

}  // namespace hapticut::gestures
