// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/loop/device_tick.hpp"
#include "hapticut/simulation/simulation.hpp"

/// @file
/// Recordings: every step of a simulation with all that is needed to make it again, in an HDF5 file that other programs
/// read too. What is in it and what may be expected of a replay is written in docs/files.md.
namespace hapticut {

/// The newest format that this library writes; it reads all from 1 on.
inline constexpr std::uint64_t kRecordingFormat = 3;

/// One row of a recording: a step, what led to it and what came of it.
struct RecordedStep {
  std::uint64_t number = 0;  ///< steps since the recording began; where it jumps, steps were lost
  double time = 0;           ///< [s] at the end of the step: of the device's clock, or the sum of all dt

  // What went in.
  StepInput input;
  double spindle_setting = 0;         ///< [rad/s] asked of the spindle
  std::uint64_t reserved_blocks = 0;  ///< that were asked for
  std::uint64_t free_blocks = 0;      ///< left of them before the step
  bool hand_released = false;         ///< the hand had let go before the step: see Simulation::release_hand
  bool halted = false;                ///< the spindle had been halted before the step: see Simulation::halt_spindle
  OutputPath path = OutputPath::direct;
  HandOutput hand;  ///< of the coupling, where `path` is coupled

  // What came out.
  Vec3 force = Vec3::Zero();   ///< [N] what the hand felt, through a coupling or not
  Vec3 torque = Vec3::Zero();  ///< [N·m] the same
  Wrench model;
  double removed_volume = 0;              ///< [m^3]
  std::uint64_t removed_voxels = 0;       ///< how many
  std::uint64_t removed_voxels_hash = 0;  ///< of their indices and materials, in their order
  Contact contact;
  EnergyLedger energy;
  SpindleState spindle;
  std::int32_t sub_steps = 0;
  StepStatus status = StepStatus::ok;

  DeviceTick device;  ///< only where Recording::has_device
};

/// Which build, machine and device made a recording, and how it ended.
struct RecordingInfo {
  std::uint64_t format = kRecordingFormat;
  std::string version, commit, compiler, cpu;  ///< of the program that recorded: see BuildInfo
  std::string begun;                           ///< when, as 2026-01-31T23:59:59Z
  std::string device;                          ///< that the steps came from; empty: no device
  std::string note;                            ///< RecorderOptions::note, free text

  bool closed = false;     ///< false: the program ended before it could finish; the last moment is missing
  std::uint64_t lost = 0;  ///< steps that found the recorder's memory full; a replay ends before the first
  std::optional<std::uint64_t> workpiece_hash_at_end;  ///< Workpiece::hash, only when closed
  std::vector<std::string> remarks;  ///< what a reader should know, in sentences: lost steps, a missing end
};

/// A change of the effects between two steps.
struct RecordedEffects {
  std::uint64_t first_step = 0;  ///< number of the first step that they were in force
  Effects effects;
};

struct OpenRecording;

/// A recording that is open for reading; steps are read from the disk when they are asked for. Also one that is still
/// being written: what is there so far.
class Recording {
 public:
  Recording(Recording&&) noexcept;
  Recording& operator=(Recording&&) noexcept;
  ~Recording();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const RecordingInfo& info() const;
  [[nodiscard]] bool has_device() const;                         ///< whether the steps have a device's side
  [[nodiscard]] const DeviceCapabilities& capabilities() const;  ///< of the device, where there was one
  [[nodiscard]] std::uint64_t size() const;                      ///< steps that are in the file
  [[nodiscard]] bool default_law() const;  ///< whether the force law was the library's own, FoundationLaw

  /// Steps `first ... first + count - 1` in the order of the file, fewer at its end.
  /// @throws Error when they cannot be read
  [[nodiscard]] std::vector<RecordedStep> read(std::uint64_t first, std::uint64_t count) const;

  [[nodiscard]] const Tool& tool() const;
  [[nodiscard]] const SimulationConfig& config() const;               ///< without the law
  [[nodiscard]] const std::vector<RecordedEffects>& effects() const;  ///< the first entry belongs to step 0

  /// The workpiece before the first step: out of the recording, or out of the file that it names.
  /// @throws Error when that file is missing, or is not what was recorded
  [[nodiscard]] Workpiece workpiece() const;

 private:
  friend Recording read_recording(const std::filesystem::path& path);
  friend struct RecordingAccess;
  explicit Recording(std::unique_ptr<OpenRecording> state);
  std::unique_ptr<OpenRecording> state_;
};

/// Opens a recording.
/// @throws Error when the file is missing, damaged, not a recording, of a newer format, or lacks something
[[nodiscard]] Recording read_recording(const std::filesystem::path& path);

/// Writes the steps as text, a line a step, with the names of the columns on top and all digits.
/// @throws Error when the recording cannot be read or the file cannot be written
void write_csv(const Recording& recording, const std::filesystem::path& path);

/// Writes the steps as a NumPy archive (.npz): one array a column, of the names and shapes of the recording.
/// @throws Error as above
void write_npz(const Recording& recording, const std::filesystem::path& path);

/// Writes what the drill sounded like (DrillSound) as a WAV file of one channel with 16 bits. It is as long as the
/// steps took together; the flutes are the lips of the cutter.
/// @param sample_rate  [Hz] 8000 ... 192 000, rounded to a whole number
/// @throws Error as above, when the rate is out of range, or when the file would be longer than 4 GB
void write_wav(const Recording& recording, const std::filesystem::path& path, double sample_rate = 48'000);

}  // namespace hapticut
