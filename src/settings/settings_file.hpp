// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::cli {

/// Reads a settings file in TOML. Whole numbers stand for numbers; nothing else is converted.
/// @throws Error `file:line: key: what is allowed`, for a key that is not a setting (with the nearest one), a value of
///         another type and a value that is not allowed
void read_settings_file(const std::filesystem::path& path, const std::vector<Setting>& settings);

}  // namespace hapticut::cli
