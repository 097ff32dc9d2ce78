// SPDX-License-Identifier: Apache-2.0
#include "hapticut/analysis/stability.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/interruption.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kHopeless = 1e6;     // [1] growth of the nudge that is unstable
constexpr double kApproach = 0.2e-3;  // [m] above the surface where a flight begins
constexpr double kLost = 1e6;         // [m] from the base: the loop has diverged
constexpr double kBuzzRms = 50e-6;    // [m]
constexpr double kBuzzForce = 0.3;    // [N]
constexpr double kBuzzPower = 5e-3;   // [W]

// [m/s] The difference of two loops in speed. Their positions may stay apart: material that is pressed deeply holds a
// tool where it has come to rest.
double distance(const ClosedLoop& a, const ClosedLoop& b) {
  return (a.plant().velocity().linear - b.plant().velocity().linear).norm();
}

void require_stiffness(double stiffness) { require_within(stiffness, Range::any(), "the stiffness"); }

struct Flight {
  double in = 0, out = 0, energy = 0, penetration = 0, force = 0;
};

Flight fly(const ClosedLoopConfig& config, const ForceModel& model, const BounceTest& test, double phase) {
  ClosedLoop loop(config);
  const Vec3 start(0, 0, test.height + kApproach + phase * test.speed * config.period);
  loop.reset(Pose::from_translation(start));
  loop.plant().set_velocity({0, 0, -test.speed});
  Flight flight;
  double z = start.z();
  bool inside = false, left = false;
  const auto watch = [&](const Plant& plant, const Wrench& applied) {
    if (left) return;
    const double next = plant.pose().translation.z(), speed = plant.velocity().linear.z();
    flight.energy += applied.force.z() * (next - z);
    z = next;
    flight.force = std::max(flight.force, applied.force.norm());
    flight.penetration = std::max(flight.penetration, test.height - z);
    if (!inside && z < test.height) {
      inside = true;
      flight.in = -speed;
    } else if (inside && z > test.height && speed > 0) {
      left = true;
      flight.out = speed;
    }
  };
  const long ticks = std::lround(test.time_limit / config.period);
  for (long n = 0; n < ticks && !left; ++n) {
    look_for_interruption();
    loop.write(model(loop.read()), watch);
  }
  return flight;
}

}  // namespace

bool is_stable(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
               const StabilitySearch& search) {
  struct Run {
    ClosedLoop loop;
    ForceModel model;
  };
  require_stiffness(stiffness);
  require_fields_within(search, "StabilitySearch::");
  Run calm{ClosedLoop(config), factory(stiffness)}, nudged{ClosedLoop(config), factory(stiffness)};
  const long settle = std::lround(search.settle / config.period);
  for (Run* run : {&calm, &nudged}) {
    run->loop.reset(search.start);
    run->loop.plant().set_target(search.target);
    for (long n = 0; n < settle; ++n) {
      look_for_interruption();
      run->loop.tick(run->model);
      if (!(run->loop.plant().pose().translation.norm() < kLost)) return false;
    }
  }
  nudged.loop.plant().set_velocity(nudged.loop.plant().velocity().linear - Vec3(0, 0, search.nudge));

  const long window = std::max(1L, std::lround(search.window / config.period));
  double last = 0;
  for (int w = 0; w < search.windows; ++w) {
    double swing = 0;
    for (long n = 0; n < window; ++n) {
      look_for_interruption();
      calm.loop.tick(calm.model);
      nudged.loop.tick(nudged.model);
      swing = std::max(swing, distance(calm.loop, nudged.loop));
      if (!(swing < kHopeless * search.nudge)) return false;
    }
    if (swing < search.forgotten * search.nudge) return true;
    if (w == search.windows - 1) return swing <= last;
    last = swing;
  }
  return true;
}

double max_stable_stiffness(const ClosedLoopConfig& config, const ModelFactory& factory,
                            const StabilitySearch& search) {
  require_fields_within(search, "StabilitySearch::");
  if (!(search.low < search.high))
    throw Error("StabilitySearch::low"_name + " = " + format_number(search.low, search.high) + "; must be below " +
                "StabilitySearch::high"_name + " = " + format_number(search.high, search.low) + ".");
  const auto stable = [&](double stiffness) { return is_stable(config, factory, stiffness, search); };
  double low = search.low, high = low;
  if (!stable(low)) return 0;
  do {
    low = high;
    if (low >= search.high) return search.high;
    high = std::min(search.high, low * search.coarse_factor);
  } while (stable(high));
  while (high > low * (1 + search.tolerance)) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

Bounce measure_bounce(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                      const BounceTest& test) {
  require_stiffness(stiffness);
  require_fields_within(test, "BounceTest::");
  Bounce result;
  result.generated_energy = -HUGE_VAL;
  for (int n = 0; n < test.phases; ++n) {
    const Flight flight = fly(config, factory(stiffness), test, double(n) / test.phases);
    const double e = flight.in > 0 ? flight.out / flight.in : 0;
    result.restitution = std::max(result.restitution, e);
    result.mean_restitution += e / test.phases;
    result.generated_energy = std::max(result.generated_energy, flight.energy);
    result.penetration = std::max(result.penetration, flight.penetration);
    result.peak_force = std::max(result.peak_force, flight.force);
  }
  return result;
}

bool Buzz::buzzes() const {
  return position_rms > kBuzzRms || force_peak_to_peak > kBuzzForce || generated_power > kBuzzPower;
}

Buzz measure_buzz(const ClosedLoopConfig& config, const ModelFactory& factory, double stiffness,
                  const PressTest& test) {
  require_stiffness(stiffness);
  require_fields_within(test, "PressTest::");
  require_between(test.approach, 0, test.seconds, "PressTest::approach [s]");
  require_between(test.measured, config.period, test.seconds, "PressTest::measured [s]");
  ClosedLoop loop(config);
  const ForceModel model = factory(stiffness);
  loop.reset(Pose::from_translation({0, 0, test.height + 10 * kApproach}));
  loop.plant().set_velocity({0, 0, -test.speed});
  const long waits = std::lround(test.approach / config.period);

  const long ticks = std::lround(test.seconds / config.period), measured = std::lround(test.measured / config.period);
  std::vector<double> z, force;
  z.reserve(std::size_t(measured));
  force.reserve(std::size_t(measured));
  Buzz buzz;
  double energy_before = 0;
  for (long n = 0; n < ticks; ++n) {
    look_for_interruption();
    if (n == waits) loop.plant().set_target(Pose::from_translation({0, 0, test.height - test.depth}));
    if (n == ticks - measured) energy_before = loop.generated_energy();
    const bool counts = n >= ticks - measured;
    if (counts) z.push_back(loop.plant().pose().translation.z());
    loop.tick(model);
    if (counts) force.push_back(loop.applied().force.z());
    buzz.max_force = std::max(buzz.max_force, loop.applied().force.norm());
  }
  double mean = 0;
  for (const double value : z) mean += value / double(z.size());
  int crossings = 0;
  for (std::size_t n = 0; n < z.size(); ++n) {
    buzz.position_rms += (z[n] - mean) * (z[n] - mean) / double(z.size());
    if (n > 0 && (z[n] - mean) * (z[n - 1] - mean) < 0) ++crossings;
  }
  buzz.position_rms = std::sqrt(buzz.position_rms);
  buzz.frequency = crossings / (2 * test.measured);
  const auto [min_force, max_force] = std::minmax_element(force.begin(), force.end());
  buzz.force_peak_to_peak = *max_force - *min_force;
  buzz.generated_power = (loop.generated_energy() - energy_before) / test.measured;
  return buzz;
}

}  // namespace hapticut
