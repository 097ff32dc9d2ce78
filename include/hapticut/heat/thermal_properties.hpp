// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/description.hpp"

/// @file
/// How materials store and conduct heat, each with its source: one table, which programs, documentation and Python
/// read.
namespace hapticut {

/// How a material stores and conducts heat. The defaults are those of cortical bone.
struct ThermalProperties {
  double conductivity = 0.55;    ///< [W/(m K)] k
  double heat_capacity = 2.5e6;  ///< [J/(m^3 K)] rho c, of a volume

  [[nodiscard]] bool operator==(const ThermalProperties&) const = default;
};

constexpr auto fields_of(Of<ThermalProperties>) {
  using P = ThermalProperties;
  return std::tuple{
      field("conductivity", &P::conductivity, "W/(m K)", Range::positive(), "k"),
      field("heat_capacity", &P::heat_capacity, "J/(m^3 K)", Range::positive(), "rho c, of a volume"),
  };
}

/// The thermal properties of a material with a name.
struct KnownThermalProperties {
  std::string_view material;     ///< its name, as in `preset_names`
  ThermalProperties properties;  ///< conductivity [W/(m K)] and heat capacity of a volume [J/(m^3 K)]
  std::string_view source;       ///< who measured it, under which assumptions
};

constexpr auto fields_of(Of<KnownThermalProperties>) {
  using K = KnownThermalProperties;
  return std::tuple{
      field("material", &K::material, "its name, as in `preset_names`"),
      field("properties", &K::properties, "conductivity [W/(m K)] and heat capacity of a volume [J/(m^3 K)]"),
      field("source", &K::source, "who measured it, under which assumptions"),
  };
}

/// The thermal properties of all presets, the table of docs/beside-the-step.md.
[[nodiscard]] std::span<const KnownThermalProperties> known_thermal_properties();

/// Conductivity [W/(m K)] and heat capacity of a volume [J/(m^3 K)] of a preset by its name. Every other name has those
/// of cortical bone. `known_thermal_properties` has the sources.
[[nodiscard]] ThermalProperties thermal_properties_of(std::string_view material) noexcept;

}  // namespace hapticut
