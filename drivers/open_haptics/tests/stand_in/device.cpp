// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include "stand_in.hpp"

namespace hdsim {

Simulation& simulation() {
  static Simulation s;
  return s;
}

Device* find(HHD handle) {
  auto& devices = simulation().devices;
  return handle < devices.size() && devices[handle].initialised ? &devices[handle] : nullptr;
}

Device* current() { return find(simulation().current); }

Device* needed() {
  Device* device = current();
  if (device == nullptr) push(HD_BAD_HANDLE);
  return device;
}

void push(HDerror code, int internal, HHD handle) { simulation().errors.push_back({code, internal, handle}); }

void sample(Device& device) {
  device.current = device.actual;
  for (int axis = 0; axis < 3; ++axis) {
    double& p = device.current.transform[std::size_t(12 + axis)];
    p += device.calibration_offset[std::size_t(axis)];
    if (device.nan) p = std::numeric_limits<double>::quiet_NaN();
  }
}

namespace {

constexpr double kVelocityLimit = 1200;  // [mm/s]
constexpr double kRampingRate = 10;      // [N/s]

double length(const Vec& v) { return std::hypot(v[0], v[1], v[2]); }

bool is_zero(const Output& output) { return output.force == Vec{} && output.torque == Vec{}; }

}  // namespace

void render(Device& device, HHD handle) {
  const double tick = 1 / simulation().rate;  // [s]
  const Vec &force = device.committed.force, &before = device.previous.force;
  const auto on = [&](HDenum capability) { return device.enabled.count(capability) > 0; };
  const auto exceeded = [&](HDerror code) {
    push(code, 0, handle);
    ++device.counters.amplifier_toggles;
    device.ramp = 0;
  };
  if (on(HD_SOFTWARE_FORCE_LIMIT) && length(force) > device.spec.force * (1 + 1e-9)) exceeded(HD_EXCEEDED_MAX_FORCE);
  if (on(HD_SOFTWARE_FORCE_IMPULSE_LIMIT) &&
      length({force[0] - before[0], force[1] - before[1], force[2] - before[2]}) > device.impulse_limit)
    exceeded(HD_EXCEEDED_MAX_FORCE_IMPULSE);
  if (on(HD_SOFTWARE_VELOCITY_LIMIT) && length(force) > 0 && length(device.current.velocity) > kVelocityLimit)
    exceeded(HD_EXCEEDED_MAX_VELOCITY);
  device.rendered = device.committed;
  if (!on(HD_FORCE_RAMPING)) return;
  if (length(force) > device.ramp)
    for (double& part : device.rendered.force) part *= device.ramp / length(force);
  device.ramp += kRampingRate * tick;
}

}  // namespace hdsim

using hdsim::Device;
using hdsim::simulation;

extern "C" {

HHD hdInitDevice(HDstring name) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  static char decimal[16];
  std::snprintf(decimal, sizeof decimal, "%.1f", 1.5);
  const bool refused = name == nullptr ? s.refuse_default : s.refused.count(name) > 0;
  if (s.license_required && !s.licensed) {
    hdsim::push(HD_INVALID_LICENSE);
    return HD_INVALID_HANDLE;
  }
  for (std::size_t n = 0; n < s.devices.size() && !refused; ++n) {
    Device& device = s.devices[n];
    if (name == nullptr ? n != 0 : device.name != name) continue;
    if (device.unplugged) break;
    if (device.initialised) {
      hdsim::push(HD_DEVICE_ALREADY_INITIATED, 0, HHD(n));
      return HD_INVALID_HANDLE;
    }
    device.initialised = true;
    device.counters.running_at_init = s.running ? 1 : 0;
    device.counters.init_locale_point = decimal;
    device.counters.callbacks_at_disable = device.counters.zero_force_before_stop =
        device.counters.zero_force_before_disable = -1;
    hdsim::sample(device);
    s.current = HHD(n);
    return s.current;
  }
  hdsim::push(HD_DEVICE_FAULT);
  return HD_INVALID_HANDLE;
}

void hdMakeCurrentDevice(HHD handle) {
  const std::lock_guard lock(simulation().mutex);
  if (hdsim::find(handle) == nullptr) return hdsim::push(HD_BAD_HANDLE, 0, handle);
  simulation().current = handle;
}

void hdDisableDevice(HHD handle) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::find(handle);
  if (device == nullptr) return hdsim::push(HD_BAD_HANDLE, 0, handle);
  device->counters.callbacks_at_disable = int(simulation().callbacks.size());
  device->counters.zero_force_before_disable = hdsim::is_zero(device->committed) ? 1 : 0;
  device->initialised = false;
  if (simulation().current == handle) simulation().current = HD_INVALID_HANDLE;
}

HHD hdGetCurrentDevice(void) {
  const std::lock_guard lock(simulation().mutex);
  if (hdsim::current() == nullptr) {
    hdsim::push(HD_INVALID_OPERATION);
    return HD_INVALID_HANDLE;
  }
  return simulation().current;
}

void hdBeginFrame(HHD handle) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  Device* device = hdsim::find(handle);
  if (device == nullptr) return hdsim::push(HD_BAD_HANDLE, 0, handle);
  s.current = handle;
  if (device->unplugged) hdsim::push(HD_COMM_ERROR, -28, 0);  // like the real driver, without a handle
  if (device->frame_depth++ > 0) return;
  if (device->frame_done && device->enabled.count(HD_ONE_FRAME_LIMIT) > 0) {
    ++device->counters.illegal_begins;
    hdsim::push(HD_ILLEGAL_BEGIN, 0, handle);
  }
  if (!device->unplugged) hdsim::sample(*device);
  device->set = {};
}

void hdEndFrame(HHD handle) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::find(handle);
  if (device == nullptr) return hdsim::push(HD_BAD_HANDLE, 0, handle);
  if (device->frame_depth == 0) {
    ++device->counters.illegal_ends;
    return hdsim::push(HD_ILLEGAL_END, 0, handle);
  }
  if (--device->frame_depth > 0) return;
  ++device->counters.frames;
  device->frame_done = device->frame_this_tick = true;
  device->previous = device->committed;
  device->committed = device->set;
  const bool powered = device->enabled.count(HD_FORCE_OUTPUT) > 0 && simulation().running;
  if (!powered) device->committed = {};
  const auto& f = device->committed.force;
  const double length = std::hypot(f[0], f[1], f[2]);
  if (device->enabled.count(HD_MAX_FORCE_CLAMPING) > 0 && length > device->spec.force)
    for (double& part : device->committed.force) part *= device->spec.force / length;
  device->history.push_back(device->committed);
}

HDErrorInfo hdGetError(void) {
  const std::lock_guard lock(simulation().mutex);
  auto& errors = simulation().errors;
  if (errors.empty()) return {HD_SUCCESS, 12345, 67890};  // the other fields mean nothing
  const HDErrorInfo last = errors.back();
  errors.pop_back();
  return last;
}

HDstring hdGetErrorString(HDerror code) {
  switch (code) {
    case HD_SUCCESS:
      return "no error (stand-in)";
    case HD_COMM_ERROR:
      return "communication error (stand-in)";
    case HD_WARM_MOTORS:
      return "warm motors (stand-in)";
    case HD_DEVICE_FAULT:
      return "device fault (stand-in)";
    case HD_INVALID_LICENSE:
      return "invalid license (stand-in)";
    case HD_TIMER_ERROR:
      return "timer error (stand-in)";
    default:
      return "some error (stand-in)";
  }
}

void hdEnable(HDenum capability) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::needed();
  if (device == nullptr) return;
  device->enabled.insert(capability);
  if (capability == HD_FORCE_OUTPUT) device->counters.force_output_enabled = 1;
}

void hdDisable(HDenum capability) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::needed();
  if (device == nullptr) return;
  device->enabled.erase(capability);
  if (capability != HD_FORCE_OUTPUT) return;
  device->counters.force_output_enabled = 0;
  device->rendered = {};
}

HDenum hdCheckCalibration(void) {
  const std::lock_guard lock(simulation().mutex);
  const Device* device = hdsim::needed();
  return device != nullptr ? device->calibration : HD_CALIBRATION_NEEDS_MANUAL_INPUT;
}

void hdUpdateCalibration(HDenum style) {
  const std::lock_guard lock(simulation().mutex);
  Device* device = hdsim::needed();
  if (device == nullptr) return;
  if ((style & HDenum(device->spec.calibration_style)) == 0) return hdsim::push(HD_INVALID_VALUE);
  ++device->counters.calibration_updates;
  if (!hdsim::is_zero(device->committed)) device->counters.force_during_calibration = 1;
  device->calibration = HD_CALIBRATION_OK;
  for (std::size_t n = 0; n < 3; ++n) device->calibration_offset[n] += device->calibration_jump[n];
}

HDboolean hdDeploymentLicense(const char* vendor, const char* application, const char* password) {
  const std::lock_guard lock(simulation().mutex);
  simulation().licensed = vendor != nullptr && application != nullptr && password != nullptr && *password != '\0';
  return simulation().licensed ? HD_TRUE : HD_FALSE;
}
}
