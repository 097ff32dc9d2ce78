// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace hapticut::cli {

/// A report; its fields keep the order in which they were added.
using Json = nlohmann::ordered_json;

/// Which build of the program made a report.
[[nodiscard]] Json build_json();

/// Writes a report; the file appears when it is complete. Does nothing when there is no file name.
/// @throws Error when it cannot be written
void write_json(const std::filesystem::path& path, const Json& report);

/// Says before the work begins that a file cannot be written, rather than after it, and makes the folders that it lies
/// in; an empty path means no file.
/// @throws Error naming the file
void require_writable(const std::filesystem::path& path);

}  // namespace hapticut::cli
