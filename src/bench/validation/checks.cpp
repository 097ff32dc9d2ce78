// SPDX-License-Identifier: Apache-2.0
#include "bench/validation/checks.hpp"

namespace hapticut::validation {

std::vector<Experiment> all_experiments() {
  std::vector<Experiment> all;
  for (const auto& part : {static_experiments(), term_experiments(), cutting_experiments(), grid_experiments(),
                           pushed_experiments(), law_experiments(), measurement_experiments(), defect_experiments()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace hapticut::validation
