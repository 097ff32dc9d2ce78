// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "io/recording/hdf5.hpp"

/// @file
/// Names in the file, shared by writer and reader of recordings.
namespace hapticut {

inline constexpr char kMagic[] = "hapticut recording";  // attribute `content` of the root
inline constexpr char kWorkpieceGroup[] = "workpiece";
inline constexpr char kWorkpieceBytes[] = "vdb";  // a .vdb file, byte by byte
inline constexpr char kEffectsGroup[] = "effects";
inline constexpr char kFirstSteps[] = "first_step";
inline constexpr char kEffectValues[] = "values";

/// The texts of a RecordingInfo and the attributes of the root that store them.
inline constexpr std::pair<const char*, std::string RecordingInfo::*> kInfoTexts[] = {
    {"version", &RecordingInfo::version}, {"commit", &RecordingInfo::commit}, {"compiler", &RecordingInfo::compiler},
    {"cpu", &RecordingInfo::cpu},         {"begun", &RecordingInfo::begun},   {"device", &RecordingInfo::device},
    {"note", &RecordingInfo::note}};

/// Access properties for the newest file format of this HDF5, which single-writer-multiple-reader mode needs.
[[nodiscard]] hdf5::Properties newest_format();

/// Writes everything known before the first step into an existing file. Reserves the disk space first, because HDF5
/// cannot recover from a full disk.
/// @throws Error when the file cannot be written
void write_recording_header(const std::filesystem::path& path, const RecordingInfo& info, const Simulation& simulation,
                            const RecorderOptions& options);

/// Marks the recording as complete.
/// @param workpiece_hash  of the workpiece after the last recorded step; empty: it is another one by now
void write_recording_end(hid_t file, std::uint64_t lost, std::optional<std::uint64_t> workpiece_hash);

/// The result of a step in the form of a row.
void note_result(const StepResult& result, RecordedStep& row) noexcept;

/// The pose of the handle as the reading of a device whose base is the world, for steps without device data.
[[nodiscard]] DeviceState reading_of_handle(const RecordedStep& step) noexcept;

/// Workpiece::hash extended by frame, materials and centroids, on which forces depend too.
[[nodiscard]] std::uint64_t full_hash(const Workpiece& workpiece);

}  // namespace hapticut
