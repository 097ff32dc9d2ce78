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

/// How a recording is made.
struct RecorderOptions {
  std::string device;  ///< name of the device that the steps come from; empty: no device and no columns for it
  std::string note;    ///< free text
  DeviceCapabilities capabilities;  ///< of that device, so that it can be played back

  /// The device whose loop makes the steps: then its name, its capabilities and its side of every step are taken from
  /// it. Null: a loop of your own gives them, with `device`, `capabilities` and `Recorder::set_device_tick`; without
  /// the last, the pose of the handle stands for the reading.
  const Device* driven_by = nullptr;

  std::size_t steps = 8192;   ///< that the memory between loop and disk holds, about 1.5 kB each
  double flush_period = 0.2;  ///< [s] in 0.01 ... 0.5; a process that is killed loses this, and what it takes to write

  /// Where the memory is full: true waits for the disk, for simulations without a hand; false loses the step and
  /// says so in the recording, for loops.
  bool wait_when_full = false;

  /// File that the initial workpiece was loaded from, by `load_vdb`. The recording then holds its name and a hash
  /// instead of its content. Empty: the recording holds the workpiece.
  std::filesystem::path workpiece_file;
};

/// Records every step of a simulation, as its observer: your own, those of a loop and of a coupling. Each step is put
/// into a bounded memory without lock, and a thread of the recorder's own writes it to an HDF5 file. The file is in
/// order at any moment: a process that is killed loses the last fraction of a second, not the recording.
///
/// When the workpiece is exchanged, put back by `undo`, or a piece that was cut loose leaves, the recording is over:
/// the steps go on, unrecorded.
///
/// `step` and `set_device_tick` belong to the thread that makes the steps; the rest may be called from any.
class Recorder final : public StepObserver {
 public:
  /// Writes what there is before the first step. Where `path` exists, the recording grows beside it, in the same name
  /// with `.new` behind it, and `close` puts it in place.
  /// @param simulation  that has made no step yet, or was just reset; it must stay where it is until the end
  /// @throws Error when the simulation has made steps, an option is out of range, or the file
  ///         cannot be written
  Recorder(const std::filesystem::path& path, Simulation& simulation, const RecorderOptions& options = {});

  /// Ends without the hash at the end, and beside an older recording, when `close` was not called.
  ~Recorder() override;
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Makes a step of the simulation: `set_device_tick` and Simulation::step in one call.
  /// @param device  null: no device leads to this step
  const StepResult& step(const StepInput& input, const DeviceTick* device = nullptr) noexcept;

  /// The device's side of the steps that follow, for a loop of your own.
  /// @realtime no allocation, no lock
  void set_device_tick(const DeviceTick& tick) noexcept;

  /// Records a step, with what was set since the last one (spindle speed, effects, reserved blocks).
  /// @realtime no allocation, no lock, unless RecorderOptions::wait_when_full
  void on_step(const ObservedStep& step) noexcept override;
  void on_exchange() noexcept override;
  void on_removal(const BlockVoxels& removed) noexcept override;

  [[nodiscard]] std::uint64_t recorded() const noexcept;  ///< steps that were taken over
  [[nodiscard]] std::uint64_t lost() const noexcept;      ///< steps that found the memory full or came after the end
  [[nodiscard]] bool failed() const noexcept;  ///< the disk is full, or the like, or `close` failed, and says what

  /// Writes what is left, and the hash of the workpiece, and ends the recording. On a full disk what fits is kept, and
  /// says how many steps are missing.
  /// @throws Error when something could not be written, also earlier
  void close();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
