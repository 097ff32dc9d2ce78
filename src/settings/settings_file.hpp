// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "settings/setting.hpp"

namespace hapticut::settings {

/// The message for an unknown key such as "output.picture"; empty: the usual message.
using ExplainKey = std::function<std::string(const std::string& key)>;

/// Reads a settings file in TOML. A whole number is accepted for a number; nothing else is converted. Relative file
/// names start at the folder of the settings file.
/// @throws Error `file:line: key: what is allowed`, for an unknown key (with the most similar one), a value of another
///         type, and a value that is not allowed
/// @param ignored  top-level keys that are skipped
/// @param advice  end of the message that there is no such file
/// @param explain  explains the unknown keys
/// @return the other top-level keys
std::set<std::string> read_settings_file(const std::filesystem::path& path, const std::vector<Setting>& settings,
                                         const std::set<std::string>& ignored = {}, const std::string& advice = "",
                                         const ExplainKey& explain = {});

/// Reads the text of a settings file.
/// @param name    stands for the file name in messages
/// @param folder  base of relative file names; empty: the working folder
std::set<std::string> read_settings(std::string_view text, const std::string& name,
                                    const std::vector<Setting>& settings, const std::set<std::string>& ignored = {},
                                    const std::filesystem::path& folder = {}, const ExplainKey& explain = {});

}  // namespace hapticut::settings
