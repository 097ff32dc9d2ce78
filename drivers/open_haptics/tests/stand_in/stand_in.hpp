// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <HD/hd.h>

#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "hdsim.h"

/// @file
/// The state of the stand-in for the OpenHaptics device library.
namespace hdsim {

using Vec = std::array<double, 3>;

struct Reading {
  std::array<double, 16> transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  Vec velocity{};
  int buttons = 0;
};

struct Output {
  Vec force{}, torque{};  // N, mNm
};

struct Device {
  hdsim_device spec{};
  std::string name, model;
  bool initialised = false;
  Reading actual, current;
  Output set, committed, previous;  // outputs of the current frame, of the last frame, of the frame before
  Output rendered;                  // by the motors in the last tick
  double ramp = 0;                  // [N] limit of the amplifiers
  std::vector<Output> history;
  int frame_depth = 0;
  bool frame_done = false, frame_this_tick = false;
  std::set<HDenum> enabled{HD_MAX_FORCE_CLAMPING,      HD_FORCE_RAMPING,   HD_SOFTWARE_FORCE_LIMIT,
                           HD_SOFTWARE_VELOCITY_LIMIT, HD_ONE_FRAME_LIMIT, HD_SOFTWARE_FORCE_IMPULSE_LIMIT};
  double temperature = 0;
  HDenum calibration = HD_CALIBRATION_OK;
  Vec calibration_jump{}, calibration_offset{};
  bool nan = false, unplugged = false;
  double impulse_limit = 4;
  hdsim_counters counters{};
};

struct Callback {
  HDSchedulerCallback function = nullptr;
  void* data = nullptr;
  HDushort priority = 0;
};

/// One per process, like the real library.
struct Simulation {
  std::recursive_mutex tick;   // held during a tick, so hdUnschedule and hdStopScheduler wait for its end
  std::recursive_mutex mutex;  // held during a call; acquired after `tick`, and not held during a callback
  std::vector<HDErrorInfo> errors;
  std::vector<Device> devices;
  std::set<std::string> refused;
  bool refuse_default = false, license_required = false, licensed = false, fail_start = false;
  HHD current = HD_INVALID_HANDLE;

  std::map<HDSchedulerHandle, Callback> callbacks;
  Callback unscheduled;  // the last callback that hdUnschedule removed
  HDSchedulerHandle next_handle = 1;
  std::vector<std::pair<HDSchedulerHandle, Callback>> order;  // calls of a tick; kept so that a tick allocates nothing
  bool running = false, use_thread = false;
  double rate = 1000;
  long ticks = 0;
  std::thread thread;
  std::thread::id servo;  // thread of the tick that is running
  std::atomic<bool> stop_thread{false};
};

Simulation& simulation();

/// The device of a handle, or null.
Device* find(HHD handle);
Device* current();

/// The current device for a call that needs one. Pushes an error when there is no current device.
Device* needed();

void push(HDerror code, int internal = 0, HHD handle = 0);
void sample(Device& device);

/// Computes the force of the motors from the committed force: zero in the tick in which a limit is exceeded, and
/// limited by a ramp after that and after the start.
void render(Device& device, HHD handle);
int run_tick();

}  // namespace hdsim
