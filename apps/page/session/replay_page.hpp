// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "hapticut/io/recording/recording.hpp"
#include "hapticut/view/protocol.hpp"

namespace hapticut::apps {

/// The messages that a server would have sent during a recording: "HCRP", version (uint32: 1), then for each message
/// its time (float64, s), its length (uint32) and its bytes. Compressed by gzip. Replays the steps, with thirty
/// pictures per second.
/// @throws Error when the recording cannot be replayed
[[nodiscard]] std::vector<std::uint8_t> replay_stream(const Recording& recording);

/// Writes one self-contained page: the built page with the recording inside.
/// @param page  folder of the built page
/// @throws Error when the page cannot be read or the file cannot be written
void write_replay_page(const Recording& recording, const std::filesystem::path& page,
                       const std::filesystem::path& target);

/// Writes the page and the recording as a folder for a server.
/// @param page  folder of the built page
/// @throws Error when the page cannot be read or a file cannot be written
void write_replay_folder(const Recording& recording, const std::filesystem::path& page,
                         const std::filesystem::path& folder);

}  // namespace hapticut::apps
