// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <atomic>
#include <functional>
#include <mutex>

namespace hapticut::open_haptics {

/// The driver's scheduler, of which there is one per process: it runs while a device of ours runs.
class Scheduler {
 public:
  static Scheduler& instance();

  /// Schedules a callback of the highest priority, and starts the scheduler for the first.
  /// @throws Error when the driver refuses
  HDSchedulerHandle join(HDSchedulerCallback callback, void* data, double rate);

  /// Takes a callback back, and stops the scheduler after the last.
  /// @param finished  the callback has returned HD_CALLBACK_DONE
  void leave(HDSchedulerHandle handle, bool finished);

  /// @realtime no lock
  [[nodiscard]] bool is_running() const { return users_.load() > 0; }

  /// Runs something between two ticks, or at once when there are none.
  void between_ticks(const std::function<void()>& work);

 private:
  std::mutex mutex_;
  std::atomic<int> users_{0};
  int waiting_ = 0;  // calls of between_ticks under way
};

}  // namespace hapticut::open_haptics
