// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iterator>

#include "hapticut/workpiece/material.hpp"
#include "page/session/slider_range.hpp"

namespace hapticut::apps {

inline constexpr int kShownMaterials = 15;

/// A number of a material in a panel.
struct MaterialNumber {
  const char* label;
  const char* unit;
  double Material::*member;
  double factor;      // value in SI units divided by shown value
  Range comfortable;  // of the shown value

  [[nodiscard]] constexpr Range range() const { return slider_range(member, comfortable, factor); }
};
inline constexpr MaterialNumber kMaterialNumbers[] = {
    {"stiffness", "", &Material::relative_stiffness, 1, Range::between(1e-3, 100)},
    {"damping", "s/m", &Material::damping, 1, Range::between(0, 1000)},
    {"cutting energy", "J/mm³", &Material::specific_cutting_energy, 1e9, Range::between(1e-4, 100)},
    {"cutting ratio", "", &Material::cutting_ratio, 1, Range::between(0, 10)},
    {"static friction", "", &Material::static_friction, 1, Range::between(0, 2)},
    {"dynamic friction", "", &Material::dynamic_friction, 1, Range::between(0, 2)},
};
inline constexpr int kIdsOfAMaterial = 10;
inline constexpr int kDynamicFriction = 5;  // place in the list
static_assert(std::size(kMaterialNumbers) <= kIdsOfAMaterial);

}  // namespace hapticut::apps
