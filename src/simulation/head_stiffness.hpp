// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "hapticut/force/contact_materials.hpp"
#include "hapticut/simulation/config.hpp"

namespace hapticut {

/// The reference stiffness that a simulation chooses for a head.
struct HeadStiffness {
  double chosen = 0;                                            // [N/m^4]
  double renderable = std::numeric_limits<double>::infinity();  // [N/m^4] limit for the stiffest material

  [[nodiscard]] double in(const MaterialTable& materials) const noexcept {
    return std::min(chosen, renderable / max_relative_stiffness(materials));
  }
};

[[nodiscard]] HeadStiffness stiffness_of(const ToolHead& head, const SimulationConfig& config);

}  // namespace hapticut
