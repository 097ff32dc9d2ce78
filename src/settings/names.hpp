// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hapticut/core/sentence.hpp"

/// @file
/// Settings by the names in messages of the library.
namespace hapticut::settings {

/// The key of the setting that sets a field: "workpiece.spacing_mm" for `VolumeReadOptions::spacing`. The name of a
/// setting is its key. Nothing for a field without a setting.
[[nodiscard]] std::optional<std::string_view> key_of(const Name& name);

/// The flag of a setting of a scene: "--radius_mm" for "tool.radius_mm". Nothing for another key.
[[nodiscard]] std::optional<std::string> flag_of(std::string_view key);

}  // namespace hapticut::settings
