// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "stand_in.hpp"

using hdsim::Device;
using hdsim::simulation;

namespace {

constexpr std::size_t kHistory = 100000;  // [frames] reserved, so that none of them allocates

/// Runs `work` on a device under the lock.
template <typename Work>
auto with(int device, const Work& work) {
  const std::lock_guard lock(simulation().mutex);
  return work(simulation().devices.at(std::size_t(device)));
}

void copy(const hdsim::Output& output, double force[3], double torque[3]) {
  std::copy(output.force.begin(), output.force.end(), force);
  if (torque != nullptr) std::copy(output.torque.begin(), output.torque.end(), torque);
}

}  // namespace

extern "C" {

void hdsim_reset(void) {
  auto& s = simulation();
  hdStopScheduler();
  const std::lock_guard lock(s.mutex);
  s.errors.clear();
  s.errors.reserve(1024);
  s.order.reserve(64);
  s.devices.clear();
  s.refused.clear();
  s.refuse_default = s.license_required = s.licensed = s.fail_start = s.use_thread = false;
  s.current = HD_INVALID_HANDLE;
  s.callbacks.clear();
  s.unscheduled = {};
  s.rate = 1000;
  s.ticks = 0;
}

hdsim_device hdsim_touch(const char* name) {
  return {name, "Touch", 6, 3, 0.5, 3.3, 0.88, 0, 0, 0, {-210, -110, -85, 210, 205, 130}, HD_CALIBRATION_INKWELL};
}

hdsim_device hdsim_premium6dof(const char* name) {
  return {name,
          "PHANTOM Premium 1.5 6DOF",
          6,
          6,
          0.8,
          8.5,
          1.4,
          188,
          48,
          300,
          {-190, -96, -60, 190, 170, 130},
          HD_CALIBRATION_ENCODER_RESET};
}

int hdsim_add_device(const hdsim_device* spec) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  Device device;
  device.spec = *spec;
  device.name = spec->name;
  device.model = spec->model;
  device.history.reserve(kHistory);
  s.devices.push_back(std::move(device));
  return int(s.devices.size()) - 1;
}

void hdsim_refuse_name(const char* name) {
  const std::lock_guard lock(simulation().mutex);
  if (name == nullptr)
    simulation().refuse_default = true;
  else
    simulation().refused.insert(name);
}

void hdsim_require_license(int required) { simulation().license_required = required != 0; }

void hdsim_set_transform(int device, const double transform[16]) {
  with(device, [&](Device& d) { std::copy_n(transform, 16, d.actual.transform.begin()); });
}
void hdsim_set_velocity(int device, const double velocity[3]) {
  with(device, [&](Device& d) { std::copy_n(velocity, 3, d.actual.velocity.begin()); });
}
void hdsim_set_buttons(int device, int buttons) {
  with(device, [&](Device& d) { d.actual.buttons = buttons; });
}
void hdsim_set_temperature(int device, double hottest) {
  with(device, [&](Device& d) { d.temperature = hottest; });
}
void hdsim_set_calibration(int device, unsigned int status) {
  with(device, [&](Device& d) { d.calibration = status; });
}
void hdsim_set_calibration_jump(int device, const double jump[3]) {
  with(device, [&](Device& d) { std::copy_n(jump, 3, d.calibration_jump.begin()); });
}
void hdsim_set_nan(int device, int nan) {
  with(device, [&](Device& d) { d.nan = nan != 0; });
}
void hdsim_unplug(int device, int unplugged) {
  with(device, [&](Device& d) { d.unplugged = unplugged != 0; });
}

void hdsim_inject_error(int device, unsigned int code, int internal) {
  const std::lock_guard lock(simulation().mutex);
  hdsim::push(code, internal, HHD(device));
}
void hdsim_fail_start(int fail) { simulation().fail_start = fail != 0; }
void hdsim_use_thread(int use) { simulation().use_thread = use != 0; }

int hdsim_run_ticks(int ticks) {
  int called = 0;
  for (int n = 0; n < ticks; ++n) called += hdsim::run_tick();
  return called;
}
unsigned int hdsim_call_late(void) {
  const hdsim::Callback callback = simulation().unscheduled;
  return callback.function(callback.data);
}
double hdsim_time(void) {
  const std::lock_guard lock(simulation().mutex);
  return double(simulation().ticks) / simulation().rate;
}
int hdsim_is_running(void) {
  const std::lock_guard lock(simulation().mutex);
  return simulation().running ? 1 : 0;
}
int hdsim_scheduled_callbacks(void) {
  const std::lock_guard lock(simulation().mutex);
  return int(simulation().callbacks.size());
}

void hdsim_get_committed_force(int device, double force[3], double torque[3]) {
  with(device, [&](Device& d) { copy(d.history.empty() ? hdsim::Output{} : d.history.back(), force, torque); });
}
void hdsim_get_rendered_force(int device, double force[3]) {
  with(device, [&](Device& d) { copy(d.rendered, force, nullptr); });
}
long hdsim_committed_count(int device) {
  return with(device, [](Device& d) { return long(d.history.size()); });
}
void hdsim_get_committed(int device, long n, double force[3], double torque[3]) {
  with(device, [&](Device& d) { copy(d.history.at(std::size_t(n)), force, torque); });
}

hdsim_counters hdsim_get_counters(int device) {
  return with(device, [](Device& d) { return d.counters; });
}
}
