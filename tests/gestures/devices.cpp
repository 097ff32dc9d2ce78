// SPDX-License-Identifier: Apache-2.0
// Devices with a coupling, and the guard with a force.
#include <random>

#include "gestures/gesture_list.hpp"
#include "gestures/scripted_loops.hpp"
#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/safety/guard.hpp"

namespace hapticut::gestures {
namespace {

// --- G8 --------------------------------------------------------------------------------------------------------------

/// Force of the motors while the hand leaves an ideal spring.
struct Leaving {
  double pulled = 0;  // [N] largest inward force
  double left = 0;    // [N] largest force at 5 mm or more outside
};

Leaving press_spring(const DeviceModel& model, double period) {
  constexpr double kSpeed = 0.1, kOutside = 0.065;  // [m/s], [m]
  const double depth = 0.9 * model.peak_force / model.rendered_stiffness;
  GuardOptions options;
  options.period = period;
  SafetyGuard guard(capabilities(model), options);
  guard.start();
  Hand hand(Pose::from_translation(Vec3(0, 0, 0.01)));
  hand.hold(1.7).move({0, 0, -0.01}, 0.1);
  for (int press = 0; press < 3; ++press)
    hand.move({0, 0, -depth}, depth / kSpeed)
        .move({0, 0, depth + kOutside}, (depth + kOutside) / kSpeed)
        .move({0, 0, -kOutside}, kOutside / kSpeed);
  Leaving seen;
  DeviceState reading;
  Vec3 last = hand.at(0).translation;
  bool leaves = false;
  for (long n = 0; double(n) * period < hand.seconds(); ++n) {
    reading.X_BS = hand.at(double(n) * period);
    const Vec3 p = reading.X_BS.translation;
    reading.velocity.linear = (p - last) / period;
    reading.time = double(n) * period;
    reading.sequence = std::uint64_t(n + 1);
    if (reading.velocity.linear.z() > 0 && p.z() < 0) leaves = true;
    if (reading.velocity.linear.z() < 0) leaves = false;
    last = p;
    const DeviceState& admitted = guard.admit(reading);
    const double force = std::max(0.0, -model.rendered_stiffness * admitted.X_BS.translation.z());
    const Wrench given = guard.limit({Vec3(0, 0, force), Vec3::Zero()});
    guard.report_applied(given);
    if (!leaves) continue;
    seen.pulled = std::max(seen.pulled, -given.force.z());
    if (p.z() > 5 * mm) seen.left = std::max(seen.left, given.force.norm());
  }
  return seen;
}

void passive_spring(Report& report) {
  report.scene("ideal spring as stiff as the device renders, 0.1 m/s, guard");
  std::string pulled, left;
  bool free = true, clean = true;
  for (const DeviceModel& model : device_models()) {
    const Leaving seen = press_spring(model, report.period);
    list(pulled, std::string(model.name), shown(seen.pulled, "N"));
    list(left, std::string(model.name), shown(seen.left, "N"));
    free = free && seen.pulled <= 0.01;
    clean = clean && seen.left <= 1e-9;
    report.add_bits(std::uint64_t(1e9 * (seen.pulled + seen.left)));
  }
  report.that("pulled back in", "at most 0.01 N", pulled, free);
  report.that("left 5 mm outside", "nothing", left, clean);
}

// --- G16 -------------------------------------------------------------------------------------------------------------

/// The first example of the README, on a Touch.
void readme_on_touch(Report& report) {
  const auto bone = [&] {
    return build_block({Vec3(-3, -3, -4) * mm, Vec3(3, 3, 0) * mm}, report.voxel(), presets::cortical_bone());
  };
  const Tool bur(SphereHead{1.5 * mm}, RayHandle{20 * mm}, Spindle{40000 * rpm});
  Hand hand(bur, Vec3(0, 0, 0.3 * mm));
  hand.move({0, 0, -3.4 * mm}, 0.8).hold(0.4);  // from here on the hand is steady
  {
    report.scene("README's first example, Touch in a nominal hand, stepped directly, which SimulationModel refuses");
    Simulation simulation(bone(), bur);
    SceneLog log({device_model("touch").peak_force, 0, device_model("touch").rendered_stiffness, false}, report);
    simulation.observers().add(log);
    ClosedLoopConfig config;
    config.device = device_model("touch");
    config.hand = hand_model("nominal");
    config.period = report.period;
    config.saturation = true;
    ClosedLoop loop(config);
    loop.reset(hand.at(0));
    log.begin(simulation);
    for (long n = 1; double(n) * report.period <= hand.seconds(); ++n) {
      loop.plant().set_target(hand.at(double(n) * report.period));
      const DeviceState reading = loop.read();
      const StepResult& result = simulation.step(reading.X_BS, reading.velocity, report.period);
      loop.write({result.force, result.torque});
      Tick tick = tick_of(simulation, double(n) * report.period, Mat3::Identity());
      tick.X_WD = tick.X_WH = reading.X_BS;
      tick.felt = {result.force, result.torque};
      tick.applied = loop.applied();
      tick.removed = result.removed_volume;
      log.add(tick, simulation, nullptr);
    }
    report.at_least("sd of the steady force", 100 * log.unsteadiness(log.within(0.95, 1.2), force_of), 5, "%",
                    "so the refusal of SimulationModel is right");
    simulation.observers().remove(log);
  }
  for (const bool coupled : {false, true}) {
    report.scene(std::string("README's first example, Touch in a nominal hand, ") +
                 (coupled ? "coupled" : "SimulationModel without a coupling"));
    try {
      DeviceChain chain(report, bone(), bur, {.hand = "nominal", .coupled = coupled});
      chain.play(hand);
      demand_steady(report, chain.log, chain.log.within(0.95, 1.2));
      chain.judge();
    } catch (const Error& refusal) {
      report.that("sd of the steady force", "at most 5 % of its mean, or refused", "refused", !coupled);
    }
  }
}

// --- G17 -------------------------------------------------------------------------------------------------------------

void heavy_tool(Report& report) {
  constexpr double kMass = 0.3;
  report.scene("tool of 0.3 kg on a Touch, 20 mm in 60 ms, in the air, coupled");
  std::optional<CouplingGains> gains;
  try {
    gains = touch_gains(kMass);
  } catch (const Error&) {
    report.that("damping ratio", "at least 0.5, or refused", "refused", true);
    return;
  }
  const double zeta = gains->damping / (2 * std::sqrt(gains->stiffness * gains->mass));
  const Tool ball = tool_of(SphereHead{1 * mm});
  ScriptedLoop loop(report, slab(1 * mm, 1 * mm, 0.2 * mm, plain_material()), ball, Grip::by_coupling, {}, gains);
  Hand hand(ball, Vec3(0, 0, 5 * mm));
  loop.play(hand.hold(0.05).move({20 * mm, 0, 0}, 0.06).hold(1.5));
  double rings = 0;
  for (const Tick& tick : loop.log.ticks)
    if (force_of(tick) > 0.1) rings = tick.time - 0.11;
  report.at_least("damping ratio", zeta, 0.5, "", "or refused");
  report.at_most("rings", rings, 0.25, "s", "until the force stays below 0.1 N");
  loop.judge();
}

// --- G24 -------------------------------------------------------------------------------------------------------------

void flick(Report& report) {
  constexpr double kLength = 100 * mm, kTurning = 10;  // [m], [rad/s]
  const int flicks = report.voxel() < 2e-4 ? 100 : 1000;
  report.scene("ball 2 mm on a handle of 100 mm, standing, Touch, coupled");
  const Tool tool(SphereHead{1 * mm}, RayHandle{kLength});
  WorkspaceMapOptions map;
  map.X_WB = Pose::from_translation(Vec3(0, 0, kLength));  // the hand is at the base's origin
  DeviceChain chain(report, build_block({Vec3(1.5, -3, -3) * mm, Vec3(5, 3, 3) * mm}, report.voxel(), plain_material()),
                    tool, {.map = map});
  const Pose start;
  Hand hand(start);
  hand.hold(0.02);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> begins;  // [s] start times of the flicks
  for (int n = 0; n < flicks; ++n) {
    begins.push_back(hand.seconds());
    for (int part = 0; part < 4; ++part) {  // the wrist rotates and the arm follows
      Pose pose = start;
      const double turn = 0.06 * unit(random);
      pose.rotation = rotation_from_vector(Vec3(0, -turn, 0));
      pose.translation += Vec3(2.5, 1, 0.5).cwiseProduct(Vec3(unit(random), unit(random), unit(random))) * mm;
      const double last = vector_from_rotation(hand.end().rotation).y();
      hand.to(pose, std::max(0.003, std::abs(turn + last) / kTurning));
    }
    hand.to(start, 0.012).hold(0.05);
  }
  begins.push_back(hand.seconds());
  chain.play(hand);
  int giving = 0;
  double worst = 0, sum = 0, most = 0;
  const double spring = device_model("touch").rendered_stiffness;
  const std::vector<Tick>& ticks = chain.log.ticks;
  for (std::size_t n = 0; n + 1 < begins.size(); ++n) {
    const Span span = chain.log.within(begins[n], begins[n + 1]);
    double work = 0;  // [J] work of the hand on the stylus, which renders no torque
    for (std::size_t k = std::max<std::size_t>(span.first, 1); k < span.last; ++k) {
      const Vec3 moved = ticks[k].X_WD.translation - ticks[k - 1].X_WD.translation;
      work += -ticks[k - 1].applied.force.dot(moved) + 0.5 * spring * moved.squaredNorm();
      most = std::max(most, ticks[k].applied.force.norm());
    }
    giving += work < -1e-6 ? 1 : 0;
    worst = std::max(worst, -work);
    sum += work;
  }
  report.at_least("force of the largest flick", most, 1, "N");
  report.that("energy to the hand", "none over all flicks, and at most 2 mJ in one",
              std::to_string(giving) + " of " + std::to_string(flicks) + " give energy, " + shown(1e3 * worst, "mJ") +
                  " at most; all together the hand gives " + shown(1e3 * sum, "mJ"),
              sum > 0 && worst < 2e-3);
  chain.judge();
}

// --- G52 -------------------------------------------------------------------------------------------------------------

/// The case of the thesis with six degrees of freedom. The handle is held by the gimbal and the fingers alone, so a
/// lever of the length L makes the contact softer by K/L^2.
void l_handle(Report& report) {
  constexpr double kDeeper = 4 * mm;  // travel of the hand below the surface
  double last = 0;                    // [N] with the longer lever
  for (const double length : {100 * mm, 30 * mm}) {
    report.scene("ball 2 mm on an L handle of " + shown(1e3 * length, "mm") +
                 ", 40 000 rpm, cortical bone, Premium 6DOF in a nominal hand, coupled");
    const Tool tool(SphereHead{1 * mm}, LHandle{length, 20 * mm}, Spindle{40000 * rpm});
    DeviceChain chain(report, slab(1.6 * mm, 3 * mm, report.voxel(), presets::cortical_bone()), tool,
                      {.device = "premium6dof", .hand = "nominal"});
    Hand hand(Pose::from_translation(Vec3(0, 0, 1.2 * mm)) * tool.X_HT().inverse());
    chain.play(hand.move({0, 0, -0.2 * mm - kDeeper}, 0.3).hold(0.5));
    const Span steady = chain.log.within(0.4, 0.8);
    const double force = chain.log.mean(steady, [](const Tick& tick) { return tick.applied.force.norm(); });
    const double gimbal = coupling_gains(capabilities(device_model("premium6dof"))).angular_stiffness;
    const double fingers = hand_model("nominal").angular_stiffness;
    const double springs = kDeeper / (length * length * (1 / gimbal + 1 / fingers));  // [N] if nothing else gave way
    report.between("presses", force, 0.3 * springs, springs, "N", "gimbal and fingers in series, on this lever");
    if (last > 0) {
      report.at_least("shorter lever presses harder", force, 3 * last, "N");
      report.at_least("cuts", 1e9 * chain.log.sum(chain.log.all(), removed_of), 0.001, "mm^3");
      demand_steady(report, chain.log, steady);
    }
    chain.judge();
    last = force;
  }
}

}  // namespace

std::vector<Gesture> device_gestures() {
  return {{"G8", "press an ideal passive spring and let it out, every device", passive_spring, false},
          {"G16", "feed README's first example to a Touch", readme_on_touch},
          {"G17", "move a heavy tool fast and stop", heavy_tool, false},
          {"G24", "flick the wrist at 10 rad/s with a long tool, no torque motors", flick},
          {"G52", "press with an L handle on a device with torque", l_handle}};
}

}  // namespace hapticut::gestures
