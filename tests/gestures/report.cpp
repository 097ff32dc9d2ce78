// SPDX-License-Identifier: Apache-2.0
#include "gestures/report.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace hapticut::gestures {
namespace {

std::string with_reason(const std::string& text, const std::string& why) {
  return why.empty() ? text : text + " (" + why + ")";
}

}  // namespace

std::string shown(double value, const std::string& unit) {
  std::array<char, 32> text{};
  const double negligible = 1e-9;  // whatever the unit
  const double size = std::abs(value);
  const char* format = size >= 1000 && size < 1e6 ? "%.0f" : "%.3g";
  (void)std::snprintf(text.data(), text.size(), format, size < negligible ? 0.0 : value);
  return unit.empty() ? text.data() : std::string(text.data()) + " " + unit;
}

void Report::that(const std::string& demand, const std::string& expected, const std::string& seen, bool is_met,
                  double strain) {
  rows_.push_back({gesture_, scene_, voxel_, demand, expected, seen, is_met, strain});
}

void Report::at_most(const std::string& demand, double seen, double bound, const std::string& unit,
                     const std::string& why) {
  that(demand, with_reason("at most " + shown(bound, unit), why), shown(seen, unit), seen <= bound, seen / bound);
}

void Report::at_least(const std::string& demand, double seen, double bound, const std::string& unit,
                      const std::string& why) {
  that(demand, with_reason("at least " + shown(bound, unit), why), shown(seen, unit), seen >= bound, bound / seen);
}

void Report::between(const std::string& demand, double seen, double low, double high, const std::string& unit,
                     const std::string& why) {
  that(demand, with_reason(shown(low, "") + " ... " + shown(high, unit), why), shown(seen, unit),
       seen >= low && seen <= high, std::abs(2 * seen - low - high) / (high - low));
}

void Report::near(const std::string& demand, double seen, double expected, double tolerance, const std::string& unit,
                  const std::string& why) {
  that(demand, with_reason(shown(expected, unit) + " within " + shown(100 * tolerance, "%"), why), shown(seen, unit),
       std::abs(seen - expected) <= tolerance * std::abs(expected),
       std::abs(seen - expected) / (tolerance * std::abs(expected)));
}

}  // namespace hapticut::gestures
