// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// From where on a step sets bits of StepStatus; the reports of the program use the same limits.
namespace hapticut {

inline constexpr double kMuchCrushed = 0.1;  ///< [1] crushing's part of the energy that removes material
inline constexpr double kHardlyCut = 0.01;   ///< [1] cutting's part of the work of edges that carry the load

/// [N] The thrust that the edges of a twist drill carry in a material without a chip, u h_e z R/kappa.
[[nodiscard]] inline double load_of_edges(const Material& m, const Tool& tool) noexcept {
  if (!(m.cutting_ratio > 0)) return 0;
  return m.specific_cutting_energy * m.edge_length / m.cutting_ratio * tool.cutter().lips *
         tool.head().cutting_radius();
}

}  // namespace hapticut
