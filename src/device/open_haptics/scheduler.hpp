// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <vector>

namespace hapticut::open_haptics {

/// What the driver calls in every tick of a run.
class TickTarget {
 public:
  virtual HDCallbackCode tick() noexcept = 0;

 protected:
  ~TickTarget() = default;
};

/// Where the driver enters a run. It lives as long as the process: a driver that calls back late finds it closed.
class Entry {
 public:
  void open(TickTarget& target) noexcept { target_.store(&target); }

  /// From here on a call ends at once; who is inside may still be.
  void close() noexcept { target_.store(nullptr); }
  [[nodiscard]] bool is_entered() const noexcept { return inside_.load(); }

  /// @realtime no lock
  HDCallbackCode call() noexcept {
    inside_.store(true);  // before the look, so that `close` is seen or is told that somebody is inside
    TickTarget* target = target_.load();
    const HDCallbackCode code = target != nullptr ? target->tick() : HD_CALLBACK_DONE;
    inside_.store(false);
    return code;
  }

 private:
  std::atomic<TickTarget*> target_{nullptr};
  std::atomic<bool> inside_{false};
};

/// The driver's scheduler, of which there is one per process: it runs while a device of ours runs.
class Scheduler {
 public:
  static Scheduler& instance();

  /// A closed entry; `give_back` only what the driver has let go of.
  [[nodiscard]] Entry& take_entry();
  void give_back(Entry& entry);

  /// Asks for ticks of a period, in [s], where the scheduler does not run, and says which it has.
  /// @throws Error when it runs with another
  double settle_period(double asked, HHD device);

  /// Schedules calls of the highest priority, and starts the scheduler for the first.
  /// @param period  [s] that was settled
  /// @throws Error when the driver refuses, or another period was settled since
  HDSchedulerHandle join(Entry& entry, double period);

  /// Takes the calls back, and stops the scheduler after the last.  @pre the entry is closed, and nobody is inside
  /// @param finished  the last call has returned HD_CALLBACK_DONE
  void leave(HDSchedulerHandle handle, bool finished);

  /// @name Whose turn it is to call the driver, whose current device is one for the process
  /// A tick gives it away while the user's code runs, so that another thread can let go of the hand meanwhile.
  /// @realtime no lock
  /// @{
  [[nodiscard]] bool take_turn() noexcept { return !turn_.test_and_set(std::memory_order_acquire); }
  void give_turn() noexcept { turn_.clear(std::memory_order_release); }
  /// @}
  /// Not in a tick. False when it does not come: the driver hangs in a call of its own.
  [[nodiscard]] bool wait_for_turn() noexcept;

  /// @realtime no lock
  [[nodiscard]] bool is_running() const { return users_.load() > 0; }

  /// Runs something between two ticks, or at once when there are none.
  void between_ticks(const std::function<void()>& work);

 private:
  std::mutex mutex_;
  std::deque<Entry> entries_;
  std::vector<Entry*> free_entries_;
  std::atomic_flag turn_;
  double asked_ = 0, period_ = 0;  // [s]
  std::atomic<int> users_{0};
  int waiting_ = 0;  // calls of between_ticks under way
};

}  // namespace hapticut::open_haptics
