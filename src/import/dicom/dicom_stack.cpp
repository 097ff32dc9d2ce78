// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "hapticut/core/errors.hpp"
#include "import/dicom/dicom_picture.hpp"

namespace hapticut {
namespace {

constexpr double kSamePlace = 1e-4;  // [mm]

/// The most frequent distance between neighbouring planes (the smaller one of two). Zero: all are at one place.
double usual_step(std::vector<double> steps) {
  std::erase_if(steps, [](double step) { return step <= kSamePlace; });
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + std::ptrdiff_t(steps.size() - 1) / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::string millimetres(double length) { return format_number(std::round(length * 1e4) / 1e4) + " mm"; }

}  // namespace

std::vector<std::size_t> stack_planes(const std::vector<Vec3>& places_mm, const std::string& planes,
                                      const std::function<std::string(std::size_t)>& name, FileGeometry& geometry) {
  const Vec3 normal = geometry.direction.col(2);
  constexpr double kRounding = 0.011;  // [mm] scanners round positions to hundredths of a millimetre
  if (geometry.axes_assumed)
    for (const Vec3& place : places_mm)
      if (!((place - places_mm.front()).head<2>().norm() <= kRounding))
        throw Error("it lacks the orientation of its " + planes +
                    " (Image Orientation), and their positions show that they are not axial. Export it with the "
                    "orientation.");
  std::vector<std::size_t> order(places_mm.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return places_mm[a].dot(normal) < places_mm[b].dot(normal); });
  const auto place = [&](std::size_t n) { return places_mm[order[n]]; };
  std::vector<double> steps;
  for (std::size_t n = 1; n < order.size(); ++n) steps.push_back((place(n) - place(n - 1)).dot(normal));
  const double usual = usual_step(steps);
  const double tolerance = std::min(std::max(kRounding, 0.01 * usual), 0.4 * usual);
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const std::string pair = name(order[n]) + " and " + name(order[n + 1]);
    if (steps[n] <= kSamePlace)
      throw Error("its " + planes + " are not evenly spaced: " + pair +
                  " are at the same place; one is a duplicate, or there are several volumes. Separate them first.");
    if (!(std::abs(steps[n] - usual) <= 2 * tolerance))
      throw Error("its " + planes + " are not evenly spaced: " + pair + " are " + millimetres(steps[n]) +
                  " apart, the others " + millimetres(usual) +
                  (steps[n] > 1.5 * usual
                       ? "; planes between them are missing. Get a complete copy, or resample it first."
                       : ". Resample it first."));
  }
  const Vec3 step = (place(order.size() - 1) - place(0)) / double(steps.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Vec3 error = place(n) - place(0) - double(n) * step;
    if (!(std::abs(error.dot(normal)) <= tolerance))
      throw Error("its " + planes + " are not evenly spaced at " + name(order[n]) + ". Resample it first.");
    if (!(error.norm() <= 2 * tolerance))
      throw Error("its " + planes + " are shifted against each other at " + name(order[n]) + ". Resample it first.");
  }
  // If positions deviate from the normal by more than their rounding, either the directions are rounded or the stack is
  // sheared.
  const double off = (step - step.dot(normal) * normal).norm();
  if (off * double(steps.size()) > 2 * tolerance) {
    if (!(off <= kMaxRounding * step.norm()))
      throw Error("its " + planes + " are shifted against each other (a tilted gantry). Resample it first.");
    geometry.direction.col(2) = step.normalized();
    for (int axis = 0; axis < 2; ++axis) {
      const Vec3 along = geometry.direction.col(axis);
      geometry.direction.col(axis) = (along - along.dot(step) / step.squaredNorm() * step).normalized();
    }
  }
  geometry.origin_mm = place(0);
  geometry.spacing_mm.z() = step.norm();
  return order;
}

}  // namespace hapticut
