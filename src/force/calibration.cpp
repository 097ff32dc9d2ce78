// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/calibration.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/material.hpp"

namespace hapticut {
namespace {

using units::kPi;

constexpr double kMinSpread = 1.05;      // [1] largest chip over the smallest, to separate edge from chip
constexpr double kMaxError = 0.5;        // [1] standard error over the constant
constexpr double kSmallEdge = 0.1;       // [1] part of thrust and torque; an edge known within this is known, even if 0
constexpr double kMaxRadius = 0.05;      // [m]
constexpr double kExact = 1e-4;          // [1] root mean square residual of numbers that fit exactly
constexpr double kMinSeparation = 1e-6;  // [1] ratio of the eigenvalues above which constants are separated
constexpr double kWithinErrors = 4;      // [1] factor of the variance: two standard errors
constexpr double kScatter = 0.05;        // [1] of measured numbers that do not contradict a prior
constexpr double kLeastScatter = 0.02;   // [1] of measured numbers, even where a fit leaves less
constexpr double kDullest = 30, kSharpest = 0.1;  // [1] edge over chip between which an edge length is assumed
constexpr double kThin = 0.01;                    // [1] chip over size length; its root is the share that tells h_s
constexpr double kMuchBetter = 0.5;               // [1] residual of a better term over that of the term
constexpr double kMinFeedPerTurn = 1e-9;          // [m]

/// A thrust or a torque over its measured value, linear in u and in the second constant: chip u + edge e = 1. Both
/// coefficients are for kappa = 1. Thrusts are proportional to 1/kappa, except that of p_e; the torque of p_e is
/// proportional to kappa.
struct Row {
  double chip, edge;
  bool is_thrust, of_pressure;

  [[nodiscard]] double chip_at(double kappa) const { return is_thrust ? chip / kappa : chip; }
  [[nodiscard]] double edge_at(double kappa) const {
    if (of_pressure) return is_thrust ? edge : edge * kappa;
    return is_thrust ? edge / kappa : edge;
  }
  /// d/d ln kappa of chip u + edge e.
  [[nodiscard]] double change(double kappa, double u, double e) const {
    const double of_edge = of_pressure ? (is_thrust ? 0.0 : edge_at(kappa) * e) : (is_thrust ? -edge_at(kappa) * e : 0);
    return (is_thrust ? -chip_at(kappa) * u : 0) + of_edge;
  }
};

std::vector<Row> rows_of(std::span<const DrillingTest> tests, ChipTerm term) {
  std::vector<Row> rows;
  for (const DrillingTest& t : tests) {
    const double omega = std::abs(t.spindle_speed), tooth_rate = t.lips * omega / (2 * kPi), R = t.radius;
    const double chip = t.feed_speed / omega;  // [m/rad], as `edge`, which multiplies u h_e or u sqrt(h_s)
    const double edge =
        term == ChipTerm::size_length ? std::sqrt(tooth_rate * t.feed_speed) / omega : t.lips / (2 * kPi);
    const bool pressure = term == ChipTerm::edge_pressure;
    if (t.thrust > 0)
      rows.push_back(
          {2 * kPi * R * chip / t.thrust, (pressure ? kPi * R * R : 2 * kPi * R * edge) / t.thrust, true, pressure});
    if (t.torque > 0)
      rows.push_back({kPi * R * R * chip / t.torque,
                      (pressure ? 2 * kPi / 3 * R * R * R : kPi * R * R * edge) / t.torque, false, pressure});
  }
  return rows;
}

/// The best constants for a kappa, and their sum of squares.
struct Fit {
  double kappa = 0, u = 0, edge = 0, squares = std::numeric_limits<double>::infinity();
};

Fit fit_at(double kappa, const std::vector<Row>& rows, bool with_edge) {
  double aa = 0, ab = 0, bb = 0, a1 = 0, b1 = 0;
  for (const Row& row : rows) {
    const double a = row.chip_at(kappa), b = row.edge_at(kappa);
    aa += a * a, ab += a * b, bb += b * b, a1 += a, b1 += b;
  }
  Fit best{kappa};
  const auto consider = [&](double u, double edge) {
    if (!(u >= 0) || !(edge >= 0)) return;
    double squares = 0;
    for (const Row& row : rows) squares += std::pow(row.chip_at(kappa) * u + row.edge_at(kappa) * edge - 1, 2);
    if (squares < best.squares) best = {kappa, u, edge, squares};
  };
  consider(a1 / aa, 0);
  const double determinant = aa * bb - ab * ab;
  if (with_edge) consider(0, b1 / bb);
  if (with_edge && determinant > 0) consider((a1 * bb - b1 * ab) / determinant, (b1 * aa - a1 * ab) / determinant);
  return best;
}

/// The ratio of the presets of a cutter.
const PresetConstant& preset_ratio(CutterKind cutter) { return *find_constant(name_or_null(cutter), "cutting_ratio"); }

/// How kappa is found.
struct RatioSearch {
  bool identified;  // otherwise it is that of the presets
  CutterKind cutter;
};

/// The best fit of all kappa: on a logarithmic grid, then by halving the step about the best.
/// @throws Error when it lies at an end of the grid, or no kappa fits
Fit best_fit(const std::vector<Row>& rows, bool with_edge, const RatioSearch& ratio) {
  constexpr int kGrid = 69, kHalvings = 37;  // steps of 0.1 to each side, 0.001 to 1000, down to 1e-12
  const PresetConstant& presets = preset_ratio(ratio.cutter);
  if (!ratio.identified) return fit_at(presets.typical, rows, with_edge);
  const auto squares = [&](double log_kappa) { return fit_at(std::exp(log_kappa), rows, with_edge).squares; };
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
  const Fit fit = fit_at(std::exp(best), rows, with_edge);
  if (at_an_end || !std::isfinite(fit.squares))
    throw Error("no cutting ratio between 0.001 and 1000 explains the drilling tests; the presets of " +
                std::string(presets.of) + " have " + format_number(presets.low) + " to " + format_number(presets.high) +
                ". Check the units of radius, feed, thrust and torque.");
  return fit;
}

/// Number of measured numbers less number of constants.
int freedom_of(const std::vector<Row>& rows, bool with_edge, bool ratio_identified) {
  return int(rows.size()) - (1 + int(with_edge) + int(ratio_identified));
}

/// Which constants a fit determines.
struct Known {
  bool chip = true, edge = false;
};

/// Which constants the fit determines, by the standard errors of u and of the second constant from the residuals. With
/// as many numbers as constants there are no residuals: then the fit must be exact and unique.
Known known_by(const Fit& fit, const std::vector<Row>& rows, bool ratio_identified) {
  double chips = 0, edges = 0;
  for (const Row& row : rows) chips += row.chip_at(fit.kappa), edges += row.edge_at(fit.kappa);
  const double whole_u = double(rows.size()) / chips, whole_edge = double(rows.size()) / edges;  // each alone
  Mat3 normal = Mat3::Zero();
  for (const Row& row : rows) {
    const Vec3 change(ratio_identified ? row.change(fit.kappa, fit.u, fit.edge) : 0, row.chip_at(fit.kappa) * whole_u,
                      row.edge_at(fit.kappa) * whole_edge);
    normal += change * change.transpose();
  }
  if (!ratio_identified) normal(0, 0) = 1;
  const int freedom = freedom_of(rows, true, ratio_identified);
  if (freedom == 0) {
    const Vec3 eigenvalues = Eigen::SelfAdjointEigenSolver<Mat3>(normal, Eigen::EigenvaluesOnly).eigenvalues();
    return {fit.u > kExact * whole_u,
            fit.squares < kExact * kExact && eigenvalues.x() > kMinSeparation * eigenvalues.z()};
  }
  const double variance = std::max(fit.squares / freedom, kLeastScatter * kLeastScatter);
  const Vec3 errors = (variance * normal.inverse().diagonal()).cwiseSqrt();
  return {errors.y() < kMaxError * fit.u / whole_u,
          errors.z() < std::max(kMaxError * fit.edge / whole_edge, kSmallEdge)};
}

/// The best fit with a given ratio of the second constant to u.
Fit fit_with_ratio(double edge_over_u, std::vector<Row> rows, const RatioSearch& ratio) {
  for (Row& row : rows) row.chip += edge_over_u * row.edge;
  Fit fit = best_fit(rows, false, ratio);
  fit.edge = edge_over_u * fit.u;
  return fit;
}

/// [m] Feed per revolution.
double feed_per_turn(const DrillingTest& t) { return 2 * kPi * t.feed_speed / std::abs(t.spindle_speed); }

/// @param number  of the test, from 1
void require_measured(const DrillingTest& t, std::size_t number) {
  require_positive(t.radius, "DrillingTest::radius [m]");
  require_metres(t.radius, kMaxRadius, "DrillingTest::radius [m]");
  require_positive(std::abs(t.spindle_speed), "DrillingTest::spindle_speed [rad/s]");
  require_feed(t.feed_speed, "DrillingTest::feed_speed [m/s]");
  require_positive(t.lips, "DrillingTest::lips [1]");
  if (t.thrust != 0) require_positive(t.thrust, "DrillingTest::thrust [N]");
  if (t.torque != 0 || t.thrust == 0) require_positive(t.torque, "DrillingTest::torque [N m]");
  if (const double feed = feed_per_turn(t), diameter = 2 * t.radius; !(kMinFeedPerTurn <= feed && feed <= diameter))
    throw Error("drilling test " + std::to_string(number) + " has a feed of " +
                format_number(feed / units::mm, diameter / units::mm) + " mm per revolution; must be from " +
                format_number(kMinFeedPerTurn / units::mm) + " mm to the diameter of the tool, " +
                format_number(diameter / units::mm, feed / units::mm) +
                " mm. Check the units of feed, speed and radius: publications often have the feed per minute.");
}

}  // namespace

AxialCutForce axial_cut_force(const Calibration& c, double radius, AngularSpeed spindle_speed, double feed_speed,
                              double lips) {
  const double omega = std::abs(spindle_speed), tooth_rate = lips * omega / (2 * kPi);
  const double x =
      (feed_speed + std::sqrt(c.size_length * tooth_rate * feed_speed) + c.edge_length * tooth_rate) / omega;
  return {kPi * radius * radius * c.edge_pressure + 2 * kPi * radius * c.specific_cutting_energy * x / c.cutting_ratio,
          2 * kPi / 3 * c.cutting_ratio * c.edge_pressure * std::pow(radius, 3) +
              c.specific_cutting_energy * kPi * radius * radius * x};
}

namespace {

/// What is assumed when the tests do not tell the third constant.
struct Prior {
  ChipTerm term = ChipTerm::edge_length;
  double length = 0;  // [m]
};

/// [m] The length that presets of a cutter have for a term; 0: none.
double preset_length(CutterKind cutter, ChipTerm term) {
  const PresetConstant* const row = find_constant(name_or_null(cutter), name_or_null(term));
  return row != nullptr ? row->typical : 0;
}

/// The size effect of blades; edges of drills where they matter.
Prior prior_for(ChipTerm asked, CutterKind cutter, double thinnest) {
  if (asked == ChipTerm::edge_pressure) return {};
  if (const double size = preset_length(cutter, ChipTerm::size_length); size > 0) return {ChipTerm::size_length, size};
  const double edge = preset_length(cutter, ChipTerm::edge_length);
  if (asked != ChipTerm::edge_length || edge < kSharpest * thinnest) return {};
  return {ChipTerm::edge_length, edge};
}

/// Blades where the edge of a drill would leave nothing to the chip, else a drill.
CutterKind cutter_for(double thickest) {
  const double edge = preset_length(CutterKind::twist_drill, ChipTerm::edge_length);
  return edge > kDullest * thickest ? CutterKind::carbide_bur : CutterKind::twist_drill;
}

/// The term of the presets of a cutter; for diamonds, which have none, that of edges.
ChipTerm term_for(CutterKind cutter) {
  return preset_length(cutter, ChipTerm::size_length) > 0 ? ChipTerm::size_length : ChipTerm::edge_length;
}

/// [m] Smallest and largest feed per lip.
std::pair<double, double> feeds_per_lip(std::span<const DrillingTest> tests) {
  double thinnest = std::numeric_limits<double>::infinity(), thickest = 0;
  for (const DrillingTest& t : tests) {
    const double feed = feed_per_turn(t) / t.lips;
    thinnest = std::min(thinnest, feed), thickest = std::max(thickest, feed);
  }
  return {thinnest, thickest};
}

double residual_of(const Calibration& c) { return std::hypot(c.thrust_residual, c.torque_residual); }

/// Sets the residuals of a fit.
void compare(std::span<const DrillingTest> tests, Calibration& c) {
  double thrust_count = 0, torque_count = 0;
  const auto add = [&](double model, double measured, double& squares, double& count) {
    if (!(measured > 0)) return;
    squares += std::pow(model / measured - 1, 2), ++count;
    c.worst_factor = std::max({c.worst_factor, model / measured, measured / std::max(model, 1e-300)});
  };
  for (const DrillingTest& t : tests) {
    const AxialCutForce model = axial_cut_force(c, t.radius, t.spindle_speed, t.feed_speed, t.lips);
    add(model.thrust, t.thrust, c.thrust_residual, thrust_count);
    add(model.torque, t.torque, c.torque_residual, torque_count);
  }
  c.thrust_residual = std::sqrt(c.thrust_residual / std::max(thrust_count, 1.0));
  c.torque_residual = std::sqrt(c.torque_residual / std::max(torque_count, 1.0));
}

Calibration fit_term(std::span<const DrillingTest> tests, ChipTerm term, CutterKind cutter) {
  double min_chip = std::numeric_limits<double>::infinity(), max_chip = 0;
  bool thrusts = false, torques = false;
  for (const DrillingTest& t : tests) {
    const double section = term == ChipTerm::edge_pressure ? t.radius : t.lips;  // factor of the edge
    const double chip = t.feed_speed / (std::abs(t.spindle_speed) * section);
    min_chip = std::min(min_chip, chip);
    max_chip = std::max(max_chip, chip);
    thrusts |= t.thrust > 0;
    torques |= t.torque > 0;
  }
  const std::vector<Row> rows = rows_of(tests, term);
  Calibration c;
  c.cutter = cutter;
  c.term = term;
  c.ratio_identified = thrusts && torques;
  const RatioSearch ratio_search{c.ratio_identified, cutter};
  const int freedom = freedom_of(rows, true, c.ratio_identified);
  const bool may_separate = max_chip > kMinSpread * min_chip && freedom >= 0;
  Fit fit = best_fit(rows, may_separate, ratio_search);
  ChipTerm fitted = term;
  const auto [thinnest, thickest] = feeds_per_lip(tests);
  c.thinnest_chip = thinnest;
  const Prior prior = prior_for(term, cutter, thinnest);
  // All but a tenth of the force is proportional to u sqrt(h_s): a fit would take h_s from the scatter.
  const bool held = term == ChipTerm::size_length && thickest < kThin * prior.length;
  if (may_separate) {
    const Known known = known_by(fit, rows, c.ratio_identified);
    c.edge_identified = known.edge && !held;
    c.chip_identified = known.chip;
  }
  if (!c.edge_identified) {
    const double ratio = prior.term == ChipTerm::size_length ? std::sqrt(prior.length) : prior.length;
    const Fit assumed = fit_with_ratio(ratio, rows_of(tests, prior.term), ratio_search);
    const double bearable = std::max(fit.squares * (1 + (freedom > 0 ? kWithinErrors / freedom : 0)),
                                     double(rows.size()) * kScatter * kScatter);
    if (prior.length == 0 || !may_separate || held || assumed.squares <= bearable) {
      fit = assumed;
      fitted = prior.term;
      c.edge_assumed = prior.length > 0 && fitted == ChipTerm::edge_length;
      c.size_assumed = prior.length > 0 && fitted == ChipTerm::size_length;
      c.chip_identified = true;
    }
  }
  c.checked = freedom_of(rows, c.edge_identified, c.ratio_identified) > 0;
  c.specific_cutting_energy = fit.u;
  c.cutting_ratio = fit.kappa;
  if (fit.edge > 0) {
    if (fitted == ChipTerm::edge_pressure) c.edge_pressure = fit.edge;
    // If the edge carries all, u is the minimum at which the length is within its range.
    const double max_length = range_of(&Material::edge_length).high;
    const double min_u = fit.edge / (fitted == ChipTerm::edge_length ? max_length : std::sqrt(max_length));
    const double u = c.specific_cutting_energy = fitted == ChipTerm::edge_pressure ? fit.u : std::max(fit.u, min_u);
    if (fitted == ChipTerm::edge_length) c.edge_length = c.edge_assumed ? prior.length : fit.edge / u;
    if (fitted == ChipTerm::size_length) c.size_length = c.size_assumed ? prior.length : std::pow(fit.edge / u, 2);
  }
  compare(tests, c);
  return c;
}

}  // namespace

Calibration calibrate(std::span<const DrillingTest> tests, std::optional<ChipTerm> term,
                      std::optional<CutterKind> cutter) {
  if (tests.empty()) throw Error("there is no drilling test to calibrate on; at least one is needed.");
  for (std::size_t i = 0; i < tests.size(); ++i) require_measured(tests[i], i + 1);
  const CutterKind by = cutter.value_or(cutter_for(feeds_per_lip(tests).second));
  Calibration c = fit_term(tests, term.value_or(term_for(by)), by);
  double least = kMuchBetter * residual_of(c);
  if (!c.checked || c.size_assumed || least < kScatter) return c;
  for (const auto& other : names_of(Of<ChipTerm>{})) {
    if (other.value == c.term) continue;
    const Calibration with_other = fit_term(tests, other.value, by);
    if (!with_other.edge_identified || residual_of(with_other) >= least) continue;
    least = residual_of(with_other);
    c.better_term = other.value;
  }
  return c;
}

}  // namespace hapticut
