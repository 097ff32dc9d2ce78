// SPDX-License-Identifier: Apache-2.0
// The table of "Passivity at the hand" in docs/decisions/0005-implicit-coupling.md: its numbers and their formula.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/device/simulated/device_models.hpp"
#include "hapticut/loop/coupling_gains.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "support/places.hpp"

namespace hapticut::passivity_page_test {
namespace {

constexpr double kPeriod = 1e-3;  // [s]

/// A spring and a damper that are read and held in ticks of kPeriod.
struct Held {
  double stiffness, damping;  // spring and damper of the coupling
  double own_damping;         // damping of the device
};

/// [N s/m] Effective damping at a frequency, after `delay` ticks (Colgate and Schenkel 1997, for a spring and a damper
/// on the backward difference). Negative: the hand gets energy.
double left_of(const Held& held, double frequency, int delay) {
  const double angle = 2 * units::kPi * frequency * kPeriod;
  const double spring = 0.5 * held.stiffness * kPeriod * std::sin((delay + 0.5) * angle) / std::sin(0.5 * angle);
  return held.own_damping + held.damping * std::cos((delay + 1) * angle) - spring;
}

/// [Hz] Frequency up to which the device is passive.
int passive_up_to(const Held& held, int delay) {
  const int half_rate = int(std::lround(0.5 / kPeriod));
  int frequency = 0;
  while (frequency < half_rate && left_of(held, frequency + 1, delay) > 0) ++frequency;
  return frequency;
}

std::string rounded(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(3) << value;
  return out.str();
}

std::string row_of(const std::string& name, const Held& held, const std::string& quantum, const std::string& friction) {
  std::string row = "| " + name + " | " + rounded(held.own_damping);
  std::ostringstream numbers;
  numbers << " | " << held.stiffness << " | " << rounded(held.damping);
  row += numbers.str() + " | " + rounded(0.5 * held.stiffness * kPeriod);
  for (int delay = 0; delay <= 2; ++delay)
    row += (delay == 0 ? " | " : ", ") + std::to_string(passive_up_to(held, delay));
  const double delay = (held.own_damping + held.damping) / held.stiffness - 0.5 * kPeriod;
  return row + " | " + rounded(1e3 * delay) + " | " + quantum + " | " + friction + " |";
}

std::vector<std::string> expected_rows() {
  std::vector<std::string> rows;
  for (const DeviceModel& device : device_models()) {
    const CouplingGains gains = coupling_gains(capabilities(device));
    const std::string name(device.name);
    rows.push_back(row_of(name, {gains.stiffness, gains.damping, device.damping},
                          rounded(gains.stiffness * device.encoder_step), rounded(2 * device.dry_friction)));
    if (gains.angular_stiffness > 0)
      rows.push_back(row_of(name + ", turning",
                            {gains.angular_stiffness, gains.angular_damping, device.rotational_damping}, "-", "-"));
  }
  return rows;
}

/// The rows of the only table under the heading.
std::vector<std::string> documented_rows() {
  std::ifstream page(test::source_path("docs/decisions/0005-implicit-coupling.md"));
  std::vector<std::string> rows;
  std::string line;
  bool here = false;
  while (std::getline(page, line)) {
    if (line.rfind("## ", 0) == 0) here = line == "## Passivity at the hand";
    if (here && line.rfind("| ", 0) == 0 && line.rfind("| device", 0) != 0) rows.push_back(line);
  }
  return rows;
}

TEST(PassivityPage, HasTheNumbersOfEveryDevice) { EXPECT_EQ(documented_rows(), expected_rows()); }

TEST(PassivityPage, CoversTheStepsOfEncodersByDryFriction) {
  for (const DeviceModel& device : device_models())
    EXPECT_LE(coupling_gains(capabilities(device)).stiffness * device.encoder_step, 2 * device.dry_friction)
        << device.name;
}

// Compares the formula with a hand that oscillates on a wall. The held force and the damping of the device dissipate
// energy. This damping is minimal when the hand moves evenly in a tick.
TEST(PassivityPage, HasTheFormulaOfAHandThatSwings) {
  for (const DeviceModel& device : device_models()) {
    const CouplingGains gains = coupling_gains(capabilities(device));
    const Held held{gains.stiffness, gains.damping, device.damping};
    for (int delay = 0; delay <= 2; ++delay)
      for (const double frequency : {3.0, 50.0, 120.0, 200.0, 260.0, 400.0}) {
        const auto at = [&](int n) { return std::cos(2 * units::kPi * frequency * kPeriod * n); };  // [m]
        double dissipated = 0, square = 0;
        for (int n = 0; n < 1000; ++n) {  // whole periods
          const int known = n - 1 - delay;
          const double force = held.stiffness * at(known) + held.damping * (at(known) - at(known - 1)) / kPeriod;
          const double moved = at(n) - at(n - 1);
          dissipated += force * moved + held.own_damping * moved * moved / kPeriod;
          square += moved * moved / kPeriod;
        }
        EXPECT_NEAR(dissipated / square, left_of(held, frequency, delay), 1e-6 * held.stiffness)
            << device.name << ", " << frequency << " Hz, " << delay;
      }
  }
}

}  // namespace
}  // namespace hapticut::passivity_page_test
