// SPDX-License-Identifier: Apache-2.0
#include "experiments/checks.hpp"

namespace hapticut::experiments {
namespace {

template <class T>
std::vector<T> one_list(std::initializer_list<std::vector<T>> parts) {
  std::vector<T> all;
  for (const std::vector<T>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

Check error_of(const std::string& id, const std::string& what, double value, const Tolerance& allowed,
               const char* unit) {
  return {id, what, unit, 0, value, allowed, 1};
}

Check order_of(const std::string& id, double least, double found, const Tolerance& tolerance) {
  return {id + " order", "order of convergence, at least", "1", least, found, tolerance, 0, true};
}

std::vector<Check> joined(std::initializer_list<std::vector<Check>> parts) { return one_list(parts); }

std::vector<Experiment> all_experiments() {
  return one_list({ball_experiments(), cone_flat_experiments(), layer_experiments(), any_head_experiments(),
                   pressure_experiments(), term_experiments(), axial_experiments(), cutting_experiments(),
                   grid_experiments(), pushed_experiments(), law_experiments(), figure_experiments(),
                   measurement_experiments(), defect_experiments()});
}

}  // namespace hapticut::experiments
