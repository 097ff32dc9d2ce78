// SPDX-License-Identifier: Apache-2.0
#include "experiments/checks.hpp"

namespace hapticut::experiments {

std::vector<Experiment> all_experiments() {
  std::vector<Experiment> all;
  for (const auto& part :
       {ball_experiments(), cone_flat_experiments(), layer_experiments(), any_head_experiments(),
        pressure_experiments(), term_experiments(), axial_experiments(), cutting_experiments(), grid_experiments(),
        pushed_experiments(), law_experiments(), figure_experiments(), measurement_experiments(), defect_experiments()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace hapticut::experiments
