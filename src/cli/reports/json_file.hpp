// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace hapticut::cli {

/// A report; its fields keep their order.
using Json = nlohmann::ordered_json;

/// Build of the program that made a report.
[[nodiscard]] Json build_json();

/// Writes a report. The file appears when it is complete. Does nothing when the file name is empty.
/// @throws Error when it cannot be written
void write_json(const std::filesystem::path& path, const Json& report);

/// Checks before the work begins that a file can be written, and creates its folders. An empty path means no file.
/// @throws Error that names the file
void require_writable(const std::filesystem::path& path);

}  // namespace hapticut::cli
