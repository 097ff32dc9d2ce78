// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <mutex>
#include <string>
#include <vector>

#include "dhdc.h"
#include "dhdsim.h"

/// @file
/// The state of the stand-in for the library of Force Dimension.
namespace dhdsim {

using Vec = std::array<double, 3>;

struct Output {
  Vec force{}, torque{};
};

struct Failure {
  int error = DHD_NO_ERROR, times = 0;
};

struct Device {
  dhdsim_device spec{};
  std::string name;
  bool open = false, in_use = false, shared = false, unplugged = false, nan = false;
  bool calibrated = true, wrist_initialised = true;
  Vec position{}, velocity{}, angular_velocity{};
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  unsigned buttons = 0;
  std::array<Failure, DHDSIM_CALLS> failures{};
  int success = 0;

  bool force_on = false, brakes_on = true, gravity_on = false;
  int cause = DHD_FORCE_OFF_NONE;
  bool held_off = false;      // by a button or another program
  double last_command = -1;   // [s] -1: no command since the forces are on
  Output committed, command;  // rendered by the amplifiers; commanded
  double carried = 0;         // [N] upwards, compensated weight of the last command
  std::vector<Output> history;
  dhdsim_counters counters{};
};

/// One per process, like the real library.
struct Simulation {
  std::mutex mutex;
  std::vector<Device> devices;
  bool expert = false, real_time = false;
  double time = 0, real_start = 0;
};

Simulation& simulation();

/// Sets the last error of the calling thread.  @return -1
int fail(int error);

/// The open device of an identifier; null, with the error set, when there is no such device or it is unplugged.
Device* find(char id);

/// Consumes an injected failure of a kind of call.  @return the error, or DHD_NO_ERROR
int injected(Device& device, dhdsim_call call);

void switch_off(Device& device, int cause);

/// Advances the clock and simulates what happens meanwhile: watchdog, brakes, a sinking arm.
void let_pass(double seconds);

/// Advances the clock to the present if real time is used.
void catch_up();

/// Runs a command on an open device.
template <typename Work>
int on(char id, const Work& work) {
  const std::lock_guard lock(simulation().mutex);
  catch_up();
  Device* device = find(id);
  return device == nullptr ? -1 : work(*device);
}

/// Runs a command that needs expert mode on an open device.
template <typename Work>
int expert(char id, const Work& work) {
  return on(id, [&](Device& device) {
    if (simulation().expert) return work(device);
    ++device.counters.expert_mode_violations;
    return fail(DHD_ERROR_EXPERT_MODE_DISABLED);
  });
}

}  // namespace dhdsim
