// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut {

/// @throws Error that names the file and the reason
[[noreturn]] inline void cannot_read(const std::filesystem::path& path, const std::string& reason) {
  throw Error("cannot read '" + path.string() + "': " + reason);
}

/// Size of a regular file that can be opened for reading.
/// @throws Error otherwise
[[nodiscard]] std::uint64_t readable_size(const std::filesystem::path& path);

/// The first bytes of a file, at most `count`.
[[nodiscard]] std::string first_bytes(const std::filesystem::path& path, std::size_t count);

}  // namespace hapticut
