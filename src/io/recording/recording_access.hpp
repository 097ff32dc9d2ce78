// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "io/recording/recording_columns.hpp"

/// @file
/// Internals of a Recording.
namespace hapticut {

struct OpenRecording {
  std::filesystem::path path;
  std::unique_ptr<RecordingSource> source;
  RecordingInfo info;
  SimulationConfig config;
  bool default_law = true;
  std::optional<Tool> tool;
  MaterialTable materials;
  DeviceCapabilities capabilities;
  std::vector<RecordedEffects> effects;
  std::vector<const Column*> columns;
  std::uint64_t size = 0;              ///< number of rows that all columns have
  std::uint64_t before_first_gap = 0;  ///< number of rows that can be repeated
};

/// Gives export and replay access to the columns.
struct RecordingAccess {
  static const OpenRecording& state(const Recording& recording) { return *recording.state_; }
};

/// Refuses to write a file over the recording that is being read.
/// @throws Error with the name of the file
void require_other_file(const Recording& recording, const std::filesystem::path& path);

/// Packed rows of one column.
/// @throws Error with the name of the file
void read_rows(const Recording& recording, const Column& column, std::uint64_t first, std::uint64_t count,
               std::vector<std::byte>& rows);

}  // namespace hapticut
