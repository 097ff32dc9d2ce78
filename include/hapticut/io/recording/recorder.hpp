// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "hapticut/device/device.hpp"
#include "hapticut/loop/device_tick.hpp"
#include "hapticut/simulation/simulation.hpp"

namespace hapticut {

/// Options of a recording.
struct RecorderOptions {
  std::string device;               ///< name of the device; empty: no device, and no columns for it
  std::string note;                 ///< free text
  DeviceCapabilities capabilities;  ///< capabilities of the device, needed for playback

  /// The device whose loop makes the steps. It supplies name, capabilities and the device data of every step. Null: a
  /// custom loop supplies them by `device`, `capabilities` and `Recorder::set_device_tick`; without the last, the pose
  /// of the handle is recorded as the reading.
  const Device* driven_by = nullptr;

  std::size_t buffered_steps = 8192;  ///< capacity of the buffer between loop and disk, about 1.5 kB per step
  double flush_period = 0.2;          ///< [s] 0.01 ... 0.5; a killed process loses about this much of the recording

  /// When the buffer is full: true waits for the disk (for simulations without a hand); false drops the step and counts
  /// it in the recording (for loops).
  bool wait_when_full = false;

  /// File from which `load_vdb` read the initial workpiece. The recording then stores the file name and a hash instead
  /// of the voxels. Empty: the recording stores the workpiece.
  std::filesystem::path workpiece_file;
};

/// Records every step of a simulation, including the steps of a loop or a coupling. The recorder is an observer of the
/// simulation. It puts each step into a bounded lock-free buffer; its own thread writes the buffer to an HDF5 file. The
/// file is readable at any moment: a killed process loses only the last fraction of a second.
///
/// The recording ends when the workpiece is exchanged, `undo` restores voxels, or a loose piece is removed. The steps
/// continue unrecorded.
///
/// Call `step` and `set_device_tick` only from the thread that makes the steps. The other functions may be called from
/// any thread.
class Recorder final : public StepObserver {
 public:
  /// Writes everything that is known before the first step. If `path` exists, the recording is written to the same name
  /// with the suffix `.new`, and `close` moves it to `path`.
  /// @param simulation  is fresh (Simulation::is_fresh); must outlive the recorder, at the same address
  /// @throws Error when the simulation is not fresh, an option is out of range, the file cannot be written, or another
  ///         recorder, of this or another program, is still writing it
  Recorder(const std::filesystem::path& path, Simulation& simulation, const RecorderOptions& options = {});

  /// Without a call of `close`, the recording lacks the hash at the end, and a `.new` file keeps its name. A
  /// recording without steps is removed.
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Makes a step of the simulation: `set_device_tick` and Simulation::step in one call.
  /// @param device  null: the step has no device
  const StepResult& step(const StepInput& input, const DeviceTick* device = nullptr) noexcept;

  /// Sets the device data of the following steps, for a custom loop.
  /// @realtime no allocation, no lock
  void set_device_tick(const DeviceTick& tick) noexcept;

  /// Records a step and the settings changed since the last step (spindle speed, halts, holds, effects, reserved
  /// blocks).
  /// @realtime no allocation, no lock, unless RecorderOptions::wait_when_full
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override;
  void on_removal(const BlockVoxels& removed) noexcept override;

  [[nodiscard]] std::uint64_t recorded() const noexcept;  ///< number of recorded steps
  [[nodiscard]] std::uint64_t lost() const noexcept;  ///< number of steps lost: buffer full, or recording over; after
                                                      ///< `close` also those that could not be written
  [[nodiscard]] bool failed() const noexcept;         ///< whether writing or `close` failed; `close` throws why

  /// Writes the remaining steps and the hash of the workpiece, and ends the recording. On a full disk the recording
  /// keeps the steps that fit and the number of missing steps.
  /// @throws Error when something could not be written, now or earlier
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
