// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/device/simulated/mock.hpp"

namespace hapticut {
namespace {

using units::kPi;

constexpr double kHeight = 5 * units::mm;  // above and below the origin
constexpr double kApproach = 2;            // [s]
constexpr double kHalfLine = 10 * units::mm;
constexpr double kRadius = 8 * units::mm;
constexpr double kRoundTime = 4;              // [s] per round
constexpr double kSpiral = 20;                // [s] from the middle to the rim and back
constexpr double kDescent = 0.1 * units::mm;  // [m/s]

// Moves down with a smooth start and end.
double height(double t) { return t < kApproach ? kHeight * std::cos(kPi * t / kApproach) : -kHeight; }

Pose at(double x, double y, double z) { return Pose::from_translation({x, y, z}); }

Pose rest(double /*t*/) { return {}; }
Pose press(double t) { return at(0, 0, height(t)); }
Pose line(double t) {
  const double s = std::max(0.0, t - kApproach);
  return at(kHalfLine * std::sin(2 * kPi * s / kRoundTime), 0, height(t));
}
Pose circle(double t) {
  const double s = std::max(0.0, t - kApproach), angle = 2 * kPi * s / kRoundTime;
  return at(kRadius * (std::cos(angle) - 1), kRadius * std::sin(angle), height(t));
}
Pose spiral(double t) {
  const double s = std::max(0.0, t - kApproach), angle = 2 * kPi * s / kRoundTime;
  const double radius = kRadius * 0.5 * (1 - std::cos(2 * kPi * s / kSpiral));
  return at(radius * std::cos(angle), radius * std::sin(angle), height(t) - kDescent * s);
}

constexpr std::array<std::pair<const char*, Pose (*)(double)>, 5> kPaths = {
    {{"rest", rest}, {"press", press}, {"line", line}, {"circle", circle}, {"spiral", spiral}}};

}  // namespace

ScriptedPath scripted_path(const std::string& name) {
  std::string names;
  for (const auto& [known, path] : kPaths) {
    if (name == known) return path;
    names += (names.empty() ? "" : ", ") + std::string(known);
  }
  throw Error("There is no mock path \"" + name + "\"; choose one of " + names + ".");
}

}  // namespace hapticut
