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
/// Recordings: every step of a simulation with everything needed to repeat it, in an HDF5 file that other programs can
/// read too. docs/files.md describes the file and what a replay guarantees.
namespace hapticut {

/// The only format that this library writes and reads.
inline constexpr std::uint64_t kRecordingFormat = 3;

/// One row of a recording: one step with its input and its result.
struct RecordedStep {
  std::uint64_t number = 0;  ///< number of the step since the recording began; a gap means lost steps
  double time = 0;           ///< [s] end of the step, by the device's clock or as the sum of all dt

  // Input.
  StepInput input;
  double spindle_setting = 0;         ///< [rad/s] set speed of the spindle; 0 while it is held
  std::uint64_t reserved_blocks = 0;  ///< number of blocks requested
  std::uint64_t free_blocks = 0;      ///< free blocks before the step
  bool hand_released = false;         ///< Simulation::release_hand was called before the step
  bool halted = false;                ///< SpindleDrive::halt was called before the step, or a hold began
  bool spindle_set = false;           ///< the speed was set before the step, after the last halt; or a hold ended
  bool spindle_held = false;          ///< SpindleDrive::hold
  OutputPath path = OutputPath::direct;
  HandOutput hand;  ///< output of the coupling, if `path` is coupled

  // Result.
  Vec3 force = Vec3::Zero();   ///< [N] on the hand, after the coupling if there is one
  Vec3 torque = Vec3::Zero();  ///< [N·m] on the hand, after the coupling if there is one
  Wrench model;
  double removed_volume = 0;              ///< [m^3]
  std::uint64_t removed_voxels = 0;       ///< number of emptied voxels
  std::uint64_t removed_voxels_hash = 0;  ///< hash of their indices and materials, in order
  Contact contact;
  EnergyLedger energy;
  SpindleState spindle;
  std::int32_t sub_steps = 0;
  StepStatus status = StepStatus::ok;

  DeviceTick device;  ///< only if Recording::has_device
};

/// Build, machine and device of a recording, and how it ended.
struct RecordingInfo {
  std::uint64_t format = kRecordingFormat;
  std::string version, commit, compiler, cpu;  ///< build of the recording program: see BuildInfo
  std::string begun;                           ///< start time, as 2026-01-31T23:59:59Z
  std::string device;                          ///< name of the device; empty: no device
  std::string note;                            ///< RecorderOptions::note, free text

  bool closed = false;     ///< false: the program ended before `close`; the last moment is missing
  std::uint64_t lost = 0;  ///< number of steps dropped because the buffer was full; a replay ends before the first
  std::optional<std::uint64_t> workpiece_hash_at_end;  ///< Workpiece::hash; only when closed, and not after an exchange
  std::vector<std::string> remarks;                    ///< remarks in sentences: lost steps, a missing end
};

/// A change of the effects between two steps.
struct RecordedEffects {
  std::uint64_t first_step = 0;  ///< number of the first step with these effects
  Effects effects;
};

struct OpenRecording;

/// A recording that is open for reading. `read` loads steps from the disk on demand. A recording that is still being
/// written shows the steps written so far.
class Recording {
 public:
  Recording(Recording&&) noexcept;
  Recording& operator=(Recording&&) noexcept;
  ~Recording();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const RecordingInfo& info() const;
  [[nodiscard]] bool has_device() const;                         ///< whether the steps have device data
  [[nodiscard]] const DeviceCapabilities& capabilities() const;  ///< capabilities of the device, if there was one
  [[nodiscard]] std::uint64_t size() const;                      ///< number of steps in the file
  [[nodiscard]] bool default_law() const;                        ///< whether the force law was FoundationLaw

  /// Steps `first ... first + count - 1` in the order of the file, fewer at its end.
  /// @throws Error when the steps cannot be read
  [[nodiscard]] std::vector<RecordedStep> read(std::uint64_t first, std::uint64_t count) const;

  [[nodiscard]] const Tool& tool() const;
  [[nodiscard]] const SimulationConfig& config() const;               ///< configuration without the force law
  [[nodiscard]] const std::vector<RecordedEffects>& effects() const;  ///< the first entry belongs to step 0

  /// The workpiece before the first step, from the recording or from the file that it names.
  /// @throws Error when that file is missing or has other content
  [[nodiscard]] Workpiece workpiece() const;

 private:
  friend Recording read_recording(const std::filesystem::path& path);
  friend struct RecordingAccess;
  explicit Recording(std::unique_ptr<OpenRecording> state);
  std::unique_ptr<OpenRecording> state_;
};

/// Opens a recording.
/// @throws Error when the file is missing, damaged, incomplete, not a recording or of a newer format
[[nodiscard]] Recording read_recording(const std::filesystem::path& path);

/// Writes the steps as text: a line of column names, then one line per step, with all digits.
/// @throws Error when the recording cannot be read or the file cannot be written
void write_csv(const Recording& recording, const std::filesystem::path& path);

/// Writes the steps as a NumPy archive (.npz): one array per column, with the names and shapes of the recording.
/// @throws Error when the recording cannot be read or the file cannot be written
void write_npz(const Recording& recording, const std::filesystem::path& path);

/// Writes the sound of the drill (DrillSound) as a WAV file with one channel and 16 bits. Its duration is the sum of
/// all dt. The number of flutes is the number of lips of the cutter.
/// @param sample_rate  [Hz] 8000 ... 192 000, rounded to a whole number
/// @throws Error when the recording cannot be read, the file cannot be written, the rate is out of range, or the file
///         would be longer than 4 GB
void write_wav(const Recording& recording, const std::filesystem::path& path, double sample_rate = 48'000);

}  // namespace hapticut
