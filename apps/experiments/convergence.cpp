// SPDX-License-Identifier: Apache-2.0
#include "experiments/convergence.hpp"

#include <cmath>
#include <utility>

namespace hapticut::experiments {

double Convergence::order() const { return std::log(error[0] / error[2]) / std::log(size[0] / size[2]); }

Convergence converge(double coarsest, const std::function<double(double, const Vec3&)>& relative_error) {
  Convergence c;
  double voxel_size = coarsest;
  for (std::size_t level = 0; level < 3; ++level, voxel_size /= 2) {
    double sum = 0;
    for (int n = 0; n < kPhases; ++n) {
      const double e = relative_error(voxel_size, phase(n));
      sum += e * e;
    }
    c.size[level] = voxel_size;
    c.error[level] = std::sqrt(sum / kPhases);
  }
  return c;
}

std::function<double(double)> second_order(double constant, double length) {
  return [=](double l) { return constant * std::pow(l / length, 2); };
}

Refined::Refined(std::string id, std::string what, double order, const char* reason, Tolerance of_order)
    : id_(std::move(id)), what_(std::move(what)), order_(order), reason_(reason), of_order_(of_order) {}

void Refined::add(const Convergence& c, const std::function<double(double)>& bound) {
  for (std::size_t level = 0; level < 3; ++level) worst_.add(c.error[level], bound(c.size[level]));
  if (!(c.order() >= min_order_)) min_order_ = c.order();
}

std::vector<Check> Refined::checks() const {
  return {worst_.check(id_, what_ + "; error", reason_), order_of(id_, order_, min_order_, of_order_)};
}

void Largest::add(double value, double bound) {
  const double share = std::abs(value) / bound;
  if (!(share <= of_bound) && !std::isnan(of_bound)) of_bound = share;
}

Check Largest::check(const std::string& id, const std::string& what, const char* reason) const {
  return error_of(id, what + " (largest, over its bound)", of_bound, {1, reason});
}

}  // namespace hapticut::experiments
