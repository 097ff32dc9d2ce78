// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>

#include "stand_in.hpp"

namespace hdsim {
namespace {

bool in_servo() { return simulation().servo == std::this_thread::get_id(); }

bool known_rate(HDulong rate) {
  if (rate == 500 || rate == 1000 || rate == 1600 || rate == 2000) return true;
  for (int n = 4; n <= 16; ++n)
    if (rate == HDulong(8000.0 / n + 0.5)) return true;
  return false;
}

void finish_threads() {
  auto& s = simulation();
  s.stop_thread = true;
  if (s.thread.joinable() && !in_servo()) s.thread.join();
}

/// Waits until a callback needs no further call.  @return false when the scheduler was stopped first
bool has_ended(HDSchedulerHandle handle) {
  auto& s = simulation();
  for (;;) {
    {
      const std::lock_guard lock(s.mutex);
      if (s.callbacks.count(handle) == 0) return true;
      if (!s.running) return false;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

}  // namespace

int run_tick() {
  auto& s = simulation();
  const std::lock_guard whole_tick(s.tick);
  std::unique_lock lock(s.mutex);
  if (!s.running) return 0;
  s.servo = std::this_thread::get_id();
  for (Device& device : s.devices) device.frame_done = device.frame_this_tick = false;
  s.order.assign(s.callbacks.begin(), s.callbacks.end());
  std::sort(s.order.begin(), s.order.end(),
            [](const auto& a, const auto& b) { return a.second.priority > b.second.priority; });
  int called = 0;
  for (const auto& [handle, callback] : s.order) {
    if (s.callbacks.count(handle) == 0) continue;
    ++called;
    lock.unlock();
    const HDCallbackCode code = callback.function(callback.data);
    lock.lock();
    if (code == HD_CALLBACK_DONE) s.callbacks.erase(handle);
  }
  for (std::size_t n = 0; n < s.devices.size(); ++n) {
    Device& device = s.devices[n];
    if (device.initialised) render(device, HHD(n));
    if (device.frame_depth > 0) ++device.counters.open_frames;
    if (device.initialised && called > 0 && !device.frame_this_tick) ++device.counters.ticks_without_frame;
  }
  ++s.ticks;
  s.servo = {};
  return called;
}

}  // namespace hdsim

using hdsim::simulation;

extern "C" {

void hdStartScheduler(void) {
  auto& s = simulation();
  {
    const std::lock_guard lock(s.mutex);
    if (s.fail_start) return hdsim::push(HD_TIMER_ERROR);
    if (s.running) return hdsim::push(HD_INVALID_OPERATION);
    s.running = true;
    s.stop_thread = false;
    for (hdsim::Device& device : s.devices) device.ramp = 0;
    if (!s.use_thread) return;
  }
  s.thread = std::thread([&s, period = std::chrono::nanoseconds(long(1e9 / s.rate))] {
    auto next = std::chrono::steady_clock::now();
    while (!s.stop_thread) {
      hdsim::run_tick();
      next += period;
      std::this_thread::sleep_until(next);
    }
  });
}

void hdStopScheduler(void) {
  auto& s = simulation();
  {
    const std::lock_guard tick(s.tick);
    const std::lock_guard lock(s.mutex);
    if (!s.running) return;
    s.running = false;
    for (hdsim::Device& device : s.devices)
      if (device.initialised)
        device.counters.zero_force_before_stop =
            device.committed.force == hdsim::Vec{} && device.committed.torque == hdsim::Vec{} ? 1 : 0;
  }
  hdsim::finish_threads();
}

void hdSetSchedulerRate(HDulong rate) {
  const std::lock_guard lock(simulation().mutex);
  if (!hdsim::known_rate(rate)) return hdsim::push(HD_INVALID_VALUE);
  simulation().rate = double(rate);
}

void hdScheduleSynchronous(HDSchedulerCallback callback, void* data, HDushort priority) {
  auto& s = simulation();
  bool at_once = false;
  {
    const std::lock_guard lock(s.mutex);
    at_once = !s.running || hdsim::in_servo();
  }
  if (at_once) {
    while (callback(data) == HD_CALLBACK_CONTINUE) {
    }
    return;
  }
  const HDSchedulerHandle handle = hdScheduleAsynchronous(callback, data, priority);
  if (hdsim::has_ended(handle)) return;
  {
    const std::lock_guard lock(s.mutex);  // the scheduler was stopped first
    if (s.callbacks.erase(handle) == 0) return;
  }
  while (callback(data) == HD_CALLBACK_CONTINUE) {
  }
}

HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback callback, void* data, HDushort priority) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  const HDSchedulerHandle handle = s.next_handle++;
  if (hdsim::in_servo() && callback(data) == HD_CALLBACK_DONE) return handle;
  s.callbacks[handle] = {callback, data, priority};
  return handle;
}

void hdUnschedule(HDSchedulerHandle handle) {
  auto& s = simulation();
  const std::lock_guard tick(s.tick);
  const std::lock_guard lock(s.mutex);
  const auto found = s.callbacks.find(handle);
  if (found == s.callbacks.end()) return hdsim::push(HD_INVALID_OPERATION);
  s.unscheduled = found->second;
  s.callbacks.erase(found);
}
}
