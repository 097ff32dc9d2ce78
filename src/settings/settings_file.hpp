// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::settings {

/// Reads a settings file in TOML. Whole numbers stand for numbers; nothing else is converted. The files that it names
/// are relative to its folder.
/// @throws Error `file:line: key: what is allowed`, for a key that is not a setting (with the nearest one), a value of
///         another type and a value that is not allowed
/// @param left    keys at the top that are somebody else's: whatever they hold is left alone
/// @param advice  completes the message that there is no such file
/// @return the other keys at the top
std::set<std::string> read_settings_file(const std::filesystem::path& path, const std::vector<Setting>& settings,
                                         const std::set<std::string>& left = {}, const std::string& advice = "");

/// The same of a text.
/// @param name    in messages, where that of a file would be
/// @param folder  that the files it names are relative to; empty: the working folder
std::set<std::string> read_settings(std::string_view text, const std::string& name,
                                    const std::vector<Setting>& settings, const std::set<std::string>& left = {},
                                    const std::filesystem::path& folder = {});

}  // namespace hapticut::settings
