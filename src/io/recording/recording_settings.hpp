// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>

#include "hapticut/safety/device_state.hpp"
#include "hapticut/simulation/config.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/material.hpp"
#include "io/recording/hdf5.hpp"

/// @file
/// Settings of a simulation as data sets, each with its unit.
namespace hapticut {

/// Writes the groups `simulation`, `tool` and `materials`.
void write_settings(hid_t file, const SimulationConfig& config, const Tool& tool, const MaterialTable& materials);

/// @throws Error when a value is missing or out of range
[[nodiscard]] SimulationConfig read_config(RecordingSource& source);  ///< without law and effects
[[nodiscard]] bool read_default_law(RecordingSource& source);         ///< whether the law was FoundationLaw
[[nodiscard]] Tool read_tool(RecordingSource& source);
[[nodiscard]] MaterialTable read_materials(RecordingSource& source);

/// The group `device`.
void write_capabilities(hid_t file, const DeviceCapabilities& capabilities);
[[nodiscard]] DeviceCapabilities read_capabilities(RecordingSource& source);

/// Effects as a row of numbers; each change of the effects adds a row. An absent effect is written with its defaults.
namespace detail {

/// Number of numbers in a field of an effect.
template <class Type>
inline constexpr std::size_t kNumbersOf = std::is_arithmetic_v<Type> ? 1 : 3;

template <class Struct>
constexpr std::size_t count_numbers() {
  std::size_t count = 0;
  for_each_field<Struct>(
      [&](const auto& field) { count += kNumbersOf<typename std::remove_cvref_t<decltype(field)>::Type>; });
  return count;
}

}  // namespace detail

inline constexpr std::size_t kEffectNumbers =
    4 + detail::count_numbers<Gravity>() + detail::count_numbers<Vibration>() + detail::count_numbers<ToothPassing>() +
    detail::count_numbers<DeltaFilter>() + detail::count_numbers<AxisMask>() + detail::count_numbers<OutputLimits>();
using EffectNumbers = std::array<double, kEffectNumbers>;
[[nodiscard]] EffectNumbers pack(const Effects& effects) noexcept;

/// @param names  names of the numbers, from `effect_names` of the version that wrote the file
/// @throws Error when a name is unknown
[[nodiscard]] Effects unpack(const std::string& names, std::span<const double> numbers);

/// The names of the numbers, separated by commas.
[[nodiscard]] std::string effect_names();

}  // namespace hapticut
