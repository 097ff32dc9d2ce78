// SPDX-License-Identifier: Apache-2.0
#include "open_haptics/scheduler.hpp"

#include <chrono>
#include <cmath>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "open_haptics/errors.hpp"

namespace hapticut::open_haptics {
namespace {

constexpr int kTriesForDriver = 20;    // [ms]
constexpr double kUsualPeriod = 1e-3;  // [s] for a driver that does not report its period

/// All devices share one period.
void require_same(double asked, double period) {
  if (asked == period) return;
  throw Error("GuardOptions::period"_name + " = " + format_number(asked) + " s is not the " + format_number(period) +
              " s of the OpenHaptics device that already runs. The driver has one scheduler for all devices; give all "
              "runs the same period.");
}

extern "C" HDCallbackCode HDCALLBACK hapticut_on_tick(void* entry) { return static_cast<Entry*>(entry)->call(); }

extern "C" HDCallbackCode HDCALLBACK hapticut_between_ticks(void* work) {
  Scheduler& scheduler = Scheduler::instance();
  const bool has_driver = scheduler.wait_for_driver();
  (*static_cast<const std::function<void()>*>(work))();
  if (has_driver) scheduler.release_driver();
  return HD_CALLBACK_DONE;
}

}  // namespace

Scheduler& Scheduler::instance() {
  static Scheduler& scheduler = *new Scheduler;  // never destroyed: the driver may call back while the process ends
  return scheduler;
}

Entry& Scheduler::acquire_entry() {
  const std::lock_guard lock(mutex_);
  if (free_entries_.empty()) return entries_.emplace_back();
  Entry& entry = *free_entries_.back();
  free_entries_.pop_back();
  return entry;
}

void Scheduler::return_entry(Entry& entry) {
  const std::lock_guard lock(mutex_);
  free_entries_.push_back(&entry);
}

bool Scheduler::wait_for_driver() noexcept {
  for (int n = 0; n < kTriesForDriver; ++n) {
    if (acquire_driver()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

double Scheduler::choose_period(double asked, HHD device) {
  const std::lock_guard lock(mutex_);
  if (users_ > 0) {
    if (asked != asked_) require_same(asked, period_);
    return period_;
  }
  asked_ = period_ = asked;
  drain();
  hdMakeCurrentDevice(device);
  hdSetSchedulerRate(HDulong(std::lround(1 / asked)));
  if (!drain().any()) return period_;
  HDint kept = 0;
  hdGetIntegerv(HD_UPDATE_RATE, &kept);
  period_ = !drain().any() && kept > 0 ? 1.0 / kept : kUsualPeriod;
  return period_;
}

HDSchedulerHandle Scheduler::join(Entry& entry, double period) {
  const std::lock_guard lock(mutex_);
  require_same(period, period_);
  drain();
  const HDSchedulerHandle handle = hdScheduleAsynchronous(hapticut_on_tick, &entry, HD_MAX_SCHEDULER_PRIORITY);
  Errors errors = drain();
  if (errors.any()) throw Error("The OpenHaptics scheduler refuses the callback: " + errors.describe() + ".");
  if (users_ == 0) {
    hdStartScheduler();
    errors = drain();
    if (errors.has(HD_TIMER_ERROR) || errors.has(HD_COMM_ERROR) || errors.has(HD_INVALID_OPERATION)) {
      hdStopScheduler();
      hdUnschedule(handle);
      drain();
      throw Error("The OpenHaptics scheduler does not start: " + errors.describe() +
                  "; check that no other program uses the device.");
    }
  }
  ++users_;
  return handle;
}

void Scheduler::leave(HDSchedulerHandle handle, bool finished) {
  std::unique_lock lock(mutex_);
  // A call of between_ticks must get its tick before the ticks end. If the driver never calls back, do not wait.
  while (users_ == 1 && waiting_ > 0 && finished) {
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    lock.lock();
  }
  if (--users_ == 0) hdStopScheduler();
  if (!finished) {
    hdUnschedule(handle);
    drain();
  }
}

void Scheduler::between_ticks(const std::function<void()>& work) {
  {
    const std::lock_guard lock(mutex_);
    ++waiting_;
  }
  hdScheduleSynchronous(hapticut_between_ticks, const_cast<std::function<void()>*>(&work), HD_MIN_SCHEDULER_PRIORITY);
  const std::lock_guard lock(mutex_);
  --waiting_;
}

}  // namespace hapticut::open_haptics
