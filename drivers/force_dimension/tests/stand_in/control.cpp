// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>

#include "stand_in.hpp"

using dhdsim::Device;
using dhdsim::simulation;

namespace {

constexpr std::size_t kHistory = 100000;  // [commands] reserved, so that none of them allocates

/// Runs `work` on a device under the lock.
template <typename Work>
auto with(int device, const Work& work) {
  const std::lock_guard lock(simulation().mutex);
  dhdsim::catch_up();
  return work(simulation().devices.at(std::size_t(device)));
}

void copy(const dhdsim::Output& output, double force[3], double torque[3]) {
  std::copy(output.force.begin(), output.force.end(), force);
  if (torque != nullptr) std::copy(output.torque.begin(), output.torque.end(), torque);
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

namespace dhdsim {

void catch_up() {
  auto& s = simulation();
  if (s.real_time) let_pass(now() - s.real_start - s.time);
}

}  // namespace dhdsim

extern "C" {

void dhdsim_reset(void) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  s.devices.clear();
  s.expert = s.real_time = false;
  s.time = 0;
}

dhdsim_device dhdsim_device_of(int type, int serial) {
  //                                     wrist, driven; left-handed; watchdog, brakes, angular velocity
  constexpr dhdsim_device kinds[] = {
      {DHD_DEVICE_OMEGA3, 0, "omega.3 (stand-in)", 0, 0, 0, 1, 1, 1},
      {DHD_DEVICE_OMEGA6_RIGHT, 0, "omega.6 (stand-in)", 1, 0, 0, 1, 1, 1},
      {DHD_DEVICE_OMEGA7_RIGHT, 0, "omega.7 (stand-in)", 1, 0, 0, 1, 1, 1},
      {DHD_DEVICE_SIGMA7_RIGHT, 0, "sigma.7 (stand-in)", 1, 1, 0, 1, 1, 1},
      {DHD_DEVICE_SIGMA7_LEFT, 0, "sigma.7 (stand-in)", 1, 1, 1, 1, 1, 1},
      {DHD_DEVICE_FALCON, 0, "Falcon (stand-in)", 0, 0, 0, 0, 0, 1},
  };
  dhdsim_device device = {type, 0, "custom (stand-in)", 0, 0, 0, 1, 1, 1};
  for (const dhdsim_device& kind : kinds)
    if (kind.type == type) device = kind;
  device.serial = serial;
  return device;
}

int dhdsim_add_device(const dhdsim_device* spec) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  Device device;
  device.spec = *spec;
  device.name = spec->name;
  device.history.reserve(kHistory);
  device.counters.zero_force_before_off = device.counters.off_before_close = -1;
  s.devices.push_back(std::move(device));
  return int(s.devices.size()) - 1;
}

void dhdsim_set_pose(int device, const double position[3], const double rotation[9]) {
  with(device, [&](Device& d) {
    std::copy_n(position, 3, d.position.begin());
    std::copy_n(rotation, 9, d.rotation.begin());
  });
}
void dhdsim_set_velocity(int device, const double linear[3], const double angular[3]) {
  with(device, [&](Device& d) {
    std::copy_n(linear, 3, d.velocity.begin());
    std::copy_n(angular, 3, d.angular_velocity.begin());
  });
}
void dhdsim_set_buttons(int device, unsigned int mask) {
  with(device, [&](Device& d) { d.buttons = mask; });
}
void dhdsim_set_nan(int device, int nan) {
  with(device, [&](Device& d) { d.nan = nan != 0; });
}
void dhdsim_set_calibrated(int device, int calibrated) {
  with(device, [&](Device& d) {
    d.calibrated = calibrated != 0;
    if (!d.calibrated) dhdsim::switch_off(d, DHD_FORCE_OFF_NONE);
  });
}
void dhdsim_set_wrist_initialised(int device, int initialised) {
  with(device, [&](Device& d) { d.wrist_initialised = initialised != 0; });
}
void dhdsim_unplug(int device) {
  with(device, [&](Device& d) {
    dhdsim::switch_off(d, DHD_FORCE_OFF_USBDISCN);
    d.unplugged = true;
  });
}
void dhdsim_set_in_use(int device, int in_use) {
  with(device, [&](Device& d) { d.in_use = in_use != 0; });
}
void dhdsim_share(int device, int shared) {
  with(device, [&](Device& d) { d.shared = shared != 0; });
}

void dhdsim_fail(int device, enum dhdsim_call call, int error, int times) {
  with(device, [&](Device& d) { d.failures.at(std::size_t(call)) = {error, times}; });
}
void dhdsim_return_on_success(int device, int value) {
  with(device, [&](Device& d) { d.success = value; });
}

void dhdsim_switch_off(int device, enum dhdsim_cause cause) {
  with(device, [&](Device& d) {
    dhdsim::switch_off(d, int(cause));
    d.held_off = cause == DHDSIM_OFF_BUTTON || cause == DHDSIM_OFF_DEADMAN || cause == DHDSIM_OFF_SOFTWARE;
  });
}
void dhdsim_switch_on(int device) {
  with(device, [&](Device& d) {
    d.held_off = false;
    d.force_on = true;
    d.brakes_on = false;
    d.cause = DHD_FORCE_OFF_NONE;
    d.last_command = simulation().time;
  });
}

void dhdsim_advance(double seconds) {
  const std::lock_guard lock(simulation().mutex);
  dhdsim::let_pass(seconds);
}
void dhdsim_use_real_time(int use) {
  const std::lock_guard lock(simulation().mutex);
  simulation().real_time = use != 0;
  simulation().real_start = now() - simulation().time;
}
double dhdsim_time(void) {
  const std::lock_guard lock(simulation().mutex);
  dhdsim::catch_up();
  return simulation().time;
}

void dhdsim_get_committed_force(int device, double force[3], double torque[3]) {
  with(device, [&](Device& d) { copy(d.committed, force, torque); });
}
void dhdsim_get_motor_force(int device, double force[3]) {
  with(device, [&](Device& d) {
    copy(d.committed, force, nullptr);
    if (d.force_on) force[2] += d.carried;
  });
}
long dhdsim_committed_count(int device) {
  return with(device, [](Device& d) { return long(d.history.size()); });
}
void dhdsim_get_committed(int device, long n, double force[3], double torque[3]) {
  with(device, [&](Device& d) { copy(d.history.at(std::size_t(n)), force, torque); });
}

dhdsim_counters dhdsim_get_counters(int device) {
  return with(device, [](Device& d) {
    dhdsim_counters c = d.counters;
    c.force_on = d.force_on ? 1 : 0;
    c.brakes_on = d.brakes_on ? 1 : 0;
    c.gravity_on = d.gravity_on ? 1 : 0;
    c.expert_mode = simulation().expert ? 1 : 0;
    return c;
  });
}
}
