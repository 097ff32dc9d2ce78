// SPDX-License-Identifier: Apache-2.0
// hapticut stability: the closed loop of device, hand and library in simulated time.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/wall_table.hpp"
#include "cli/commands/command.hpp"
#include "hapticut/analysis/faults.hpp"
#include "hapticut/analysis/pressed_ball.hpp"
#include "hapticut/core/build_info.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "reports/delivery.hpp"
#include "reports/json_file.hpp"
#include "reports/progress.hpp"
#include "reports/table.hpp"

namespace hapticut::apps {

using namespace settings;
namespace {

constexpr double kWallTolerance = 0.05;  // [1] the table is rounded and comes from another program
constexpr double kMinGain = 10;          // [1] required gain in stiffness of a coupling over a directly driven device
constexpr double kPressedStiffness = 1e16;  // [N/m^4] k_v of bounces, presses and faults with a coupling

struct StabilitySettings {
  std::optional<std::string> device, hand;
  std::string json;
};

ClosedLoopConfig loop_of(const DeviceModel& device, std::string_view hand, int delay) {
  ClosedLoopConfig config;
  config.device = device;
  config.hand = hand_model(hand);
  config.delay = delay;
  return config;
}

ModelFactory linear_walls() {
  return [](double stiffness) {
    LinearWall wall;
    wall.stiffness = stiffness;
    wall.one_sided = false;
    return ForceModel(wall);
  };
}

/// The findings, for the text, the JSON report and the exit code.
struct Findings {
  Json wall = Json::array(), contact = Json::array(), faults = Json::array();
  std::vector<std::string> complaints;
  ProgressBar* progress = nullptr;  // paused while lines are printed
  Delivery* delivery = nullptr;

  /// Prints a line made like printf.
  template <class... Values>
  void print(const char* format, const Values&... values) const {
    std::array<char, 512> line;
    std::snprintf(line.data(), line.size(), format, values...);
    delivery->print(line.data());
  }
};

/// Compares the linear wall with the table and with K = 2 b/T.
void measure_wall(const DeviceModel& device, Findings& findings) {
  for (const WallRow& row : kWallTable) {
    if (row.device != device.name) continue;
    for (int delay = 0; delay < kWallDelays; ++delay) {
      const double limit = max_stable_stiffness(loop_of(device, row.hand, delay), linear_walls());
      const double expected = row.max_stiffness[std::size_t(delay)], error = limit / expected - 1;
      const auto paused = findings.progress->pause();
      findings.print("%-12s %-11s delay %d  wall     %8s N/m, table %s (%+.1f %%)\n", device.name.data(),
                     row.hand.data(), delay, rounded(limit).c_str(), rounded(expected).c_str(), 100 * error);
      findings.wall.push_back({{"device", device.name},
                               {"hand", row.hand},
                               {"delay_ticks", delay},
                               {"k_max", limit},
                               {"expected", expected},
                               {"relative_error", error}});
      if (std::abs(error) > kWallTolerance)
        findings.complaints.push_back("the wall of " + std::string(device.name) + ", " + std::string(row.hand) +
                                      ", delay " + std::to_string(delay) + " is off by more than 5 %");
    }
  }
}

CouplingGains gains_of(const DeviceModel& device) {
  CouplingGains gains = coupling_gains(capabilities(device));
  gains.angular_stiffness = 0;  // the ball has no lever arm
  return gains;
}

/// Measures the real model, driven directly and through the coupling.
void measure_contact(const DeviceModel& device, std::string_view hand, Findings& findings) {
  for (int delay = 0; delay < kWallDelays; ++delay) {
    ClosedLoopConfig config = loop_of(device, hand, delay);
    config.velocity_filter = 100;
    const PressedBall direct, coupled{.coupling = gains_of(device)};
    const double slope = max_contact_stiffness(SphereHead{direct.radius});
    const double k_direct = max_stable_stiffness(config, contact_models(direct), pressed_search(direct));
    const double k_coupled = max_stable_stiffness(config, contact_models(coupled), pressed_search(coupled));
    BounceTest bounced;
    bounced.height = direct.radius;
    bounced.phases = 10;
    PressTest pressed;
    pressed.height = direct.radius;
    pressed.depth = 5e-3;
    pressed.seconds = 2;
    pressed.measured = 0.5;
    const Bounce bounce_coupled = measure_bounce(config, contact_models(coupled), kPressedStiffness, bounced);
    const Buzz buzz = measure_buzz(config, contact_models(coupled), kPressedStiffness, pressed);
    const bool at_end = k_coupled >= pressed_search(coupled).high;
    const auto paused = findings.progress->pause();
    findings.print(
        "%-12s %-11s delay %d  contact  direct k_v %s, coupled %s%s N/m^4; restitution %.2f, energy %.2g mJ, buzz %.2g "
        "um\n",
        device.name.data(), std::string(hand).c_str(), delay, rounded(k_direct, 3).c_str(), at_end ? ">= " : "",
        rounded(k_coupled, 3).c_str(), bounce_coupled.restitution, 1e3 * bounce_coupled.generated_energy,
        1e6 * buzz.position_rms);
    findings.contact.push_back({{"device", device.name},
                                {"hand", hand},
                                {"delay_ticks", delay},
                                {"coupling_stiffness_N_per_m", coupled.coupling->stiffness},
                                {"k_max_direct", k_direct},
                                {"k_max_direct_N_per_m", k_direct * slope},
                                {"k_max", k_coupled},
                                {"k_max_N_per_m", k_coupled * slope},
                                {"k_max_is_the_end_of_the_search", at_end},
                                {"restitution", bounce_coupled.restitution},
                                {"generated_energy_J", bounce_coupled.generated_energy},
                                {"buzz_um", 1e6 * buzz.position_rms},
                                {"buzz_N", buzz.force_peak_to_peak}});
    if (!(k_coupled >= kMinGain * k_direct))
      findings.complaints.push_back("the coupling of " + std::string(device.name) + ", delay " + std::to_string(delay) +
                                    " is stable up to k_v = " + rounded(k_coupled, 3) +
                                    " N/m^4, less than ten times the " + rounded(k_direct, 3) +
                                    " N/m^4 of the device without a coupling");
    if (bounce_coupled.restitution > 1)
      findings.complaints.push_back("the coupling of " + std::string(device.name) + ", delay " + std::to_string(delay) +
                                    " pushes the hand back faster than it arrived");
  }
}

/// Measures every injected fault, with the real model behind guard and coupling.
void measure_faults(const DeviceModel& device, std::string_view hand, Findings& findings) {
  const PressedBall ball{.coupling = gains_of(device)};
  GuardOptions options;
  options.stiffness = ball.coupling->stiffness;
  const SafetyGuard guard(capabilities(device), options);
  for (int delay = 0; delay < kWallDelays; ++delay) {
    double max_time_to_zero = 0;
    int broken = 0;
    for (const InjectedFault fault : injected_faults()) {
      ClosedLoopConfig config = loop_of(device, hand, delay);
      config.dry_friction = config.encoder = config.saturation = true;
      config.velocity_filter = 100;
      const FaultResponse response =
          measure_fault_response(config, contact_models(ball), kPressedStiffness, options, fault, ball.radius);
      const bool obeyed = obeys_the_rules(response, guard, config.period);
      findings.faults.push_back(
          {{"device", device.name},
           {"hand", hand},
           {"delay_ticks", delay},
           {"fault", name_of(fault)},
           {"time_to_zero_ms", response.time_to_zero < 0 ? Json() : Json(1e3 * response.time_to_zero)},
           {"max_force_N", response.max_force},
           {"max_growth_N", response.max_growth},
           {"oldest_force_ms", 1e3 * response.oldest_force},
           {"end", name_of(response.end)},
           {"rules_obeyed", obeyed}});
      max_time_to_zero = std::max(max_time_to_zero, response.time_to_zero);
      broken += obeyed ? 0 : 1;
      if (!obeyed)
        findings.complaints.push_back("the fault " + std::string(name_of(fault)) + " on " + std::string(device.name) +
                                      ", delay " + std::to_string(delay) + " breaks a rule");
    }
    const auto paused = findings.progress->pause();
    findings.print(
        "%-12s %-11s delay %d  faults   %zu injected, %d against the rules, no force at the latest after %.3g ms\n",
        device.name.data(), std::string(hand).c_str(), delay, injected_faults().size(), broken, 1e3 * max_time_to_zero);
  }
}

void run_stability(const StabilitySettings& s) {
  const std::string hand = s.hand.value_or("nominal"), which = s.device.value_or("all");
  Delivery delivery({s.json});
  ProgressBar progress("simulating devices");
  Findings findings;
  findings.progress = &progress;
  findings.delivery = &delivery;
  for (const DeviceModel& device : device_models()) {
    if (which != "all" && which != device.name) continue;
    measure_wall(device, findings);
    measure_contact(device, hand, findings);
    measure_faults(device, hand, findings);
  }
  const BuildInfo build = build_info();
  write_json(delivery, s.json,
             {{"wall", findings.wall},
              {"contact", findings.contact},
              {"faults", findings.faults},
              {"complaints", findings.complaints},
              {"build", {{"version", build.version}, {"commit", build.commit}}}});
  const std::size_t broken = findings.complaints.size();
  if (broken > 0)
    tell_error((broken == 1 ? "1 rule is broken: " : std::to_string(broken) + " rules are broken; the first: ") +
               findings.complaints.front() + ". The report of --json lists all.");
  delivery.finish();
  if (broken > 0) throw AlreadyTold();
}

/// The names of the presets, each mapped to itself.
template <typename Models>
std::vector<std::pair<std::string, std::string>> names_of(const Models& models) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& model : models) names.emplace_back(model.name, model.name);
  return names;
}

}  // namespace

Command stability_command() {
  auto settings = std::make_shared<StabilitySettings>();
  auto devices = names_of(device_models());
  devices.insert(devices.begin(), {"all", "all"});
  return {"stability",
          "Test the closed loop of device, hand and library in simulated time",
          {choice("stability.device", "--device", settings->device, devices, "simulated device [all]"),
           choice("stability.hand", "--hand", settings->hand, names_of(hand_models()),
                  "hand that presses the real model [nominal]"),
           json_setting(settings->json)},
          [settings] { run_stability(*settings); }};
}

}  // namespace hapticut::apps
