// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hapticut/io/recording/recording.hpp"
#include "hapticut/view/protocol.hpp"

namespace hapticut::cli {

/// What a server would have said while a recording was made: "HCRP", version (uint32: 1), then for each message its
/// time (float64, s), its length (uint32) and its bytes. Compressed by gzip. The steps are made again, thirty pictures
/// a second.
/// @throws Error when the recording cannot be run again
[[nodiscard]] std::vector<std::uint8_t> replay_stream(const Recording& recording);

/// Writes one page that needs nothing else: the built page and the recording in it.
/// @param page  folder of the built page
/// @throws Error when the page cannot be read or the file cannot be written
void write_replay_page(const Recording& recording, const std::filesystem::path& page,
                       const std::filesystem::path& target);

/// The same as a folder for a server.
void write_replay_folder(const Recording& recording, const std::filesystem::path& page,
                         const std::filesystem::path& folder);

}  // namespace hapticut::cli
