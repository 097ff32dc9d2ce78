// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/workpiece/material.hpp"
#include "page/session/material_numbers.hpp"

namespace hapticut::apps {

/// What is known of a number of a material, in the unit of its control.
struct KnownRange {
  double low = 0, typical = 0, high = 0;
  std::string source;  // empty: nothing is known
};

/// The range of a number of a preset, from `preset_constants`. A cutting energy is that of the cutter times the share
/// of the material, so its range and its source are of both.
/// @param material  nothing is known of one whose name is not that of a preset
[[nodiscard]] KnownRange known_range(const Material& material, const MaterialNumber& number);

}  // namespace hapticut::apps
