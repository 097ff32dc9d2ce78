// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <utility>

#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "io/recording/hdf5.hpp"

/// @file
/// What the writer and the reader of recordings share: the places in the file.
namespace hapticut {

inline constexpr char kMagic[] = "hapticut recording";  // attribute `content` of the root
inline constexpr char kWorkpieceGroup[] = "workpiece";
inline constexpr char kWorkpieceBytes[] = "vdb";  // a .vdb file, byte by byte
inline constexpr char kEffectsGroup[] = "effects";
inline constexpr char kFirstSteps[] = "first_step";
inline constexpr char kEffectValues[] = "values";

/// The texts of a RecordingInfo and the attributes of the root that hold them.
inline constexpr std::pair<const char*, std::string RecordingInfo::*> kInfoTexts[] = {
    {"version", &RecordingInfo::version}, {"commit", &RecordingInfo::commit}, {"compiler", &RecordingInfo::compiler},
    {"cpu", &RecordingInfo::cpu},         {"begun", &RecordingInfo::begun},   {"device", &RecordingInfo::device},
    {"note", &RecordingInfo::note}};

/// Access properties of a file in the newest format of this HDF5, which is what single-writer-multiple-reader needs.
[[nodiscard]] hdf5::Properties newest_format();

/// Writes everything that is known before the first step into a file that exists. Asks for the room first: HDF5 itself
/// cannot recover from a full disk.
/// @throws Error when the file cannot be written
void write_recording_header(const std::filesystem::path& path, const RecordingInfo& info, const Simulation& simulation,
                            const RecorderOptions& options);

/// Notes that the recording is complete.
void write_recording_end(hid_t file, std::uint64_t lost, std::uint64_t workpiece_hash);

/// The result of a step as a row holds it.
void note_result(const StepResult& result, RecordedStep& row) noexcept;

/// The pose of the handle as a reading of a device whose base is the world, where nobody gave the device's own.
[[nodiscard]] DeviceState reading_of_handle(const RecordedStep& step) noexcept;

/// Workpiece::hash, and what else of it a force depends on: frame, materials and centroids.
[[nodiscard]] std::uint64_t full_hash(const Workpiece& workpiece);

}  // namespace hapticut
