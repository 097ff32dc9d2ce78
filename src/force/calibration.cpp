// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut {
namespace {

using units::kPi;

constexpr double kLeastSpread = 1.05;  // [1] of feed per turn over radius, to tell edge from chip
constexpr double kLargestError = 0.5;  // [1] standard error over the constant
constexpr double kSmallEdge = 0.1;     // [1] of the thrust; an edge known to this is known, be it 0

double chip_over_radius(const DrillingTest& t) { return t.feed_speed / (std::abs(t.spindle_speed) * t.radius); }

/// The best u and p_e for a kappa, and the sum of squares that they leave.
struct Fit {
  double kappa = 0, u = 0, edge = 0, squares = std::numeric_limits<double>::infinity();
};

Fit fit_at(double kappa, std::span<const DrillingTest> tests, bool with_edge) {
  // Rows (a, b) . (u, p_e) = 1: thrust and torque over their measured values.
  double aa = 0, ab = 0, bb = 0, a1 = 0, b1 = 0;
  const auto for_each_row = [&](const auto& visit) {
    for (const DrillingTest& t : tests) {
      const double R = t.radius, x = t.feed_speed / std::abs(t.spindle_speed);
      visit(2 * kPi * R * x / kappa / t.thrust, kPi * R * R / t.thrust);
      visit(kPi * R * R * x / t.torque, 2 * kPi / 3 * kappa * R * R * R / t.torque);
    }
  };
  for_each_row([&](double a, double b) { aa += a * a, ab += a * b, bb += b * b, a1 += a, b1 += b; });
  const auto squares = [&](double u, double edge) {
    double sum = 0;
    for_each_row([&](double a, double b) { sum += std::pow(a * u + b * edge - 1, 2); });
    return sum;
  };
  Fit best{kappa};
  const auto consider = [&](double u, double edge) {
    if (!(u >= 0) || !(edge >= 0)) return;
    const double s = squares(u, edge);
    if (s < best.squares) best = {kappa, u, edge, s};
  };
  consider(a1 / aa, 0);
  const double determinant = aa * bb - ab * ab;
  if (with_edge) consider(0, b1 / bb);
  if (with_edge && determinant > 0) consider((a1 * bb - b1 * ab) / determinant, (b1 * aa - a1 * ab) / determinant);
  return best;
}

/// The best fit of all kappa: on a logarithmic grid, then by halving the step about the best.
/// @throws Error when it lies at an end of the grid, or no kappa fits
Fit best_fit(std::span<const DrillingTest> tests, bool with_edge) {
  constexpr int kGrid = 69, kHalvings = 37;  // steps of 0.1 to each side, 0.001 to 1000, down to 1e-12
  const auto squares = [&](double log_kappa) { return fit_at(std::exp(log_kappa), tests, with_edge).squares; };
  double best = 0, step = 0.1;
  const auto try_at = [&](double at) {
    if (squares(at) < squares(best)) best = at;
  };
  for (int n = -kGrid; n <= kGrid; ++n) try_at(n * step);
  const bool at_an_end = std::abs(best) > (kGrid - 0.5) * step;
  for (int halving = 0; halving < kHalvings; ++halving, step /= 2) {
    const double middle = best;
    try_at(middle - step);
    try_at(middle + step);
  }
  const Fit fit = fit_at(std::exp(best), tests, with_edge);
  if (at_an_end || !std::isfinite(fit.squares))
    throw Error(
        "no cutting ratio between 0.001 and 1000 explains the drilling tests; that of drills in bone is 2.5 to "
        "5.3. Check the units of radius, feed, thrust and torque.");
  return fit;
}

/// How well a fit knows its constants.
struct Known {
  bool chip = true, edge = false;
};

/// From the standard errors that the fit's residuals leave in u and p_e.
Known known_by(const Fit& fit, std::span<const DrillingTest> tests) {
  double thrust = 0, chips = 0, sections = 0;  // sums over the tests; chips: thrust per u
  for (const DrillingTest& t : tests) {
    thrust += t.thrust;
    chips += 2 * kPi * t.radius * t.feed_speed / (fit.kappa * std::abs(t.spindle_speed));
    sections += kPi * t.radius * t.radius;
  }
  const double whole_u = thrust / chips, whole_edge = thrust / sections;  // that alone would give the thrust
  // How the relative errors of thrust and torque change with ln kappa, u and p_e, the latter two in these units.
  Mat3 normal = Mat3::Zero();
  for (const DrillingTest& t : tests) {
    const double R = t.radius, x = t.feed_speed / std::abs(t.spindle_speed);
    const double chip_thrust = 2 * kPi * R * x / fit.kappa / t.thrust, edge_thrust = kPi * R * R / t.thrust;
    const double chip_torque = kPi * R * R * x / t.torque, edge_torque = 2 * kPi / 3 * fit.kappa * R * R * R / t.torque;
    const Vec3 of_thrust(-chip_thrust * fit.u, chip_thrust * whole_u, edge_thrust * whole_edge);
    const Vec3 of_torque(edge_torque * fit.edge, chip_torque * whole_u, edge_torque * whole_edge);
    normal += of_thrust * of_thrust.transpose() + of_torque * of_torque.transpose();
  }
  const double variance = fit.squares / (2.0 * double(tests.size()) - 3);
  const Vec3 errors = (variance * normal.inverse().diagonal()).cwiseSqrt();
  return {errors.y() < kLargestError * fit.u / whole_u,
          errors.z() < std::max(kLargestError * fit.edge / whole_edge, kSmallEdge)};
}

}  // namespace

AxialCutForce axial_cut_force(const Calibration& c, double radius, double spindle_speed, double feed_speed) {
  const double x = feed_speed / std::abs(spindle_speed);
  return {kPi * radius * radius * c.edge_pressure + 2 * kPi * radius * c.specific_cutting_energy * x / c.cutting_ratio,
          2 * kPi / 3 * c.cutting_ratio * c.edge_pressure * std::pow(radius, 3) +
              c.specific_cutting_energy * kPi * radius * radius * x};
}

Calibration calibrate(std::span<const DrillingTest> tests) {
  if (tests.empty()) throw Error("there is no drilling test to calibrate on; at least one is needed.");
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const DrillingTest& t : tests) {
    require_positive(t.radius, "DrillingTest::radius [m]");
    require_positive(std::abs(t.spindle_speed), "DrillingTest::spindle_speed [rad/s]");
    require_positive(t.feed_speed, "DrillingTest::feed_speed [m/s]");
    require_positive(t.thrust, "DrillingTest::thrust [N]");
    require_positive(t.torque, "DrillingTest::torque [N m]");
    least = std::min(least, chip_over_radius(t));
    most = std::max(most, chip_over_radius(t));
  }
  Fit fit;
  Calibration c;
  if (most > kLeastSpread * least) {
    fit = best_fit(tests, true);
    const Known known = known_by(fit, tests);
    c.edge_identified = known.edge;
    c.chip_identified = known.chip;
  }
  if (!c.edge_identified) {
    fit = best_fit(tests, false);
    c.chip_identified = true;
  }
  c.specific_cutting_energy = fit.u;
  c.cutting_ratio = fit.kappa;
  c.edge_pressure = fit.edge;
  for (const DrillingTest& t : tests) {
    const AxialCutForce model = axial_cut_force(c, t.radius, t.spindle_speed, t.feed_speed);
    c.thrust_residual += std::pow(model.thrust / t.thrust - 1, 2) / double(tests.size());
    c.torque_residual += std::pow(model.torque / t.torque - 1, 2) / double(tests.size());
  }
  c.thrust_residual = std::sqrt(c.thrust_residual);
  c.torque_residual = std::sqrt(c.torque_residual);
  return c;
}

}  // namespace hapticut
