// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

namespace hapticut::open_haptics {

/// The function that the driver calls in every tick of a run.
class TickTarget {
 public:
  virtual HDCallbackCode tick() noexcept = 0;

 protected:
  ~TickTarget() = default;
};

/// The entry through which the driver calls a run. It lives as long as the process, so a late call finds it closed.
class Entry {
 public:
  void open(TickTarget& target) noexcept { target_.store(&target); }

  /// Closes the entry: later calls return at once. A call that is inside may still run.
  void close() noexcept { target_.store(nullptr); }
  [[nodiscard]] bool is_entered() const noexcept { return inside_.load(); }

  /// @realtime no lock
  HDCallbackCode call() noexcept {
    inside_.store(true);  // before the load: either this call sees `close`, or `close` sees this call
    TickTarget* target = target_.load();
    const HDCallbackCode code = target != nullptr ? target->tick() : HD_CALLBACK_DONE;
    inside_.store(false);
    return code;
  }

 private:
  std::atomic<TickTarget*> target_{nullptr};
  std::atomic<bool> inside_{false};
};

/// The driver's scheduler, one per process. It runs while a device of this library runs.
class Scheduler {
 public:
  static Scheduler& instance();

  /// Acquires a closed entry. Return it with `return_entry` only when the driver will not call it any more.
  [[nodiscard]] Entry& acquire_entry();
  void return_entry(Entry& entry);

  /// Requests a period if the scheduler does not run yet.  @return [s] the period of the scheduler
  /// @throws Error when the scheduler runs with another period
  double choose_period(double asked, HHD device);

  /// Schedules calls of the highest priority. Starts the scheduler if it does not run yet.
  /// @param period  [s] result of `choose_period`
  /// @throws Error when the driver refuses, or the period has changed since
  HDSchedulerHandle join(Entry& entry, double period);

  /// Ends the calls, and stops the scheduler with the last device.  @pre the entry is closed and no call is inside
  /// @param finished  the last call has returned HD_CALLBACK_DONE
  void leave(HDSchedulerHandle handle, bool finished);

  /// @name The right to call the driver, which has one current device per process
  /// A tick releases the driver while the user's code runs, so that another thread can release the hand meanwhile.
  /// @realtime no lock
  /// @{
  [[nodiscard]] bool acquire_driver() noexcept { return !driver_in_use_.test_and_set(std::memory_order_acquire); }
  void release_driver() noexcept { driver_in_use_.clear(std::memory_order_release); }
  /// @}
  /// Waits for the driver; not in a tick.  @return false when the driver hangs in a call
  [[nodiscard]] bool wait_for_driver() noexcept;

  /// @realtime no lock
  [[nodiscard]] bool is_running() const { return users_.load() > 0; }

  /// Runs a function between two ticks, or at once when there are no ticks.
  void between_ticks(const std::function<void()>& work);

 private:
  std::mutex mutex_;
  std::deque<Entry> entries_;
  std::vector<Entry*> free_entries_;
  std::atomic_flag driver_in_use_;
  double asked_ = 0, period_ = 0;  // [s]
  std::atomic<int> users_{0};
  int waiting_ = 0;  // number of calls of between_ticks in progress
};

}  // namespace hapticut::open_haptics
