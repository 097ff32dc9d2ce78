// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "settings/setting.hpp"

namespace hapticut::apps {

class Delivery;

/// A report; its fields keep their order.
using Json = nlohmann::ordered_json;

/// Build of the program that made a report.
[[nodiscard]] Json build_json();

/// Writes a report, if it is wanted. The file appears when it is complete; "-" is standard output.
void write_json(Delivery& delivery, const std::string& file, const Json& report);

/// The setting `json` of all commands.
[[nodiscard]] settings::Setting json_setting(std::string& file);

/// Checks before the work begins that a file can be written, and creates its folders. An empty path means no file.
/// @throws Error that names the file
void require_writable(const std::filesystem::path& path);

}  // namespace hapticut::apps
