// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "stand_in.hpp"

namespace dhdsim {
namespace {

constexpr double kGravity = 9.81;         // [m/s^2]
constexpr double kWatchdogUnit = 125e-6;  // [s]
constexpr double kCarries = 2.5e-3;       // [s] for which one command compensates gravity
constexpr double kArmMass = 0.2;          // [kg] that gravity compensation carries
constexpr double kSpeedLimit = 1;         // [m/s] above which the device brakes

double length(const Vec& v) { return std::hypot(v[0], v[1], v[2]); }
bool is_zero(const Output& output) { return output.force == Vec{} && output.torque == Vec{}; }

/// Opens the first device that fulfils `wanted`.
template <typename Wanted>
int open_first(const Wanted& wanted) {
  auto& s = simulation();
  const std::lock_guard lock(s.mutex);
  int error = DHD_ERROR_NO_DEVICE_FOUND;
  for (std::size_t n = 0; n < s.devices.size(); ++n) {
    Device& device = s.devices[n];
    if (!wanted(int(n), device) || device.unplugged) continue;
    error = DHD_ERROR_DEVICE_IN_USE;
    if (device.in_use || (device.open && !device.shared)) continue;
    error = injected(device, DHDSIM_OPEN);
    if (error != DHD_NO_ERROR) continue;
    device.open = true;
    return int(n);
  }
  return fail(error);
}

/// Reads a flag of a device; false if there is no such device.
template <typename Question>
bool ask(char id, const Question& question) {
  const std::lock_guard lock(simulation().mutex);
  const Device* device = find(id);
  return device != nullptr && question(*device);
}

int set_force(char id, const Output& wanted, double gripper) {
  return on(id, [&](Device& d) {
    if (const int error = injected(d, DHDSIM_WRITE)) return fail(error);
    ++d.counters.commands;
    if (!d.spec.active_wrist && wanted.torque != Vec{}) ++d.counters.torques_on_passive_wrist;
    if (gripper != 0) ++d.counters.gripper_forces;
    d.command = wanted;
    if (!d.spec.active_wrist) d.command.torque = {};
    d.committed = d.force_on ? d.command : Output{};
    d.last_command = simulation().time;
    // Computed only here: without commands the weight of a moving arm is not compensated.
    d.carried = d.gravity_on ? kArmMass * kGravity : 0;
    d.history.push_back(d.committed);
    return d.success;
  });
}

template <typename Value>
int read(char id, dhdsim_call call, const Value& value) {
  return on(id, [&](Device& d) {
    if (const int error = injected(d, call)) return fail(error);
    value(d);
    return d.success;
  });
}

void frame(const Device& d, double matrix[3][3]) {
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) matrix[row][column] = d.rotation[3 * row + column];
}

void position(const Device& d, double* px, double* py, double* pz) {
  *px = d.nan ? std::numeric_limits<double>::quiet_NaN() : d.position[0];
  *py = d.position[1];
  *pz = d.position[2];
}

}  // namespace

Simulation& simulation() {
  static Simulation s;
  return s;
}

Device* find(char id) {
  auto& devices = simulation().devices;
  const std::size_t n = id < 0 ? 0 : std::size_t(id);
  if (n >= devices.size() || !devices[n].open) {
    if (n < devices.size()) ++devices[n].counters.calls_after_close;
    fail(DHD_ERROR_INVALID_INDEX);
    return nullptr;
  }
  if (!devices[n].unplugged) return &devices[n];
  fail(DHD_ERROR_COM);
  return nullptr;
}

int injected(Device& device, dhdsim_call call) {
  Failure& failure = device.failures[std::size_t(call)];
  if (failure.times <= 0) return DHD_NO_ERROR;
  --failure.times;
  return failure.error;
}

void switch_off(Device& device, int cause) {
  device.force_on = false;
  device.brakes_on = device.spec.has_brakes != 0;
  device.cause = cause;
  device.committed = {};
  device.last_command = -1;
}

void let_pass(double seconds) {
  auto& s = simulation();
  s.time += seconds;
  for (Device& d : s.devices) {
    if (!d.force_on) continue;
    const double without = d.last_command < 0 ? seconds : s.time - d.last_command;
    if (!d.gravity_on || d.last_command < 0 || without > kCarries) d.counters.unsupported += seconds;
    if (d.counters.watchdog > 0 && without > d.counters.watchdog * kWatchdogUnit)
      switch_off(d, DHD_FORCE_OFF_WATCHDOG);
    else if (length(d.velocity) > kSpeedLimit)
      switch_off(d, DHD_FORCE_OFF_VELOCITY);
  }
}

}  // namespace dhdsim

using dhdsim::ask;
using dhdsim::Device;
using dhdsim::expert;
using dhdsim::fail;
using dhdsim::on;
using dhdsim::read;
using dhdsim::simulation;

extern "C" {

int dhdGetDeviceCount() {
  const std::lock_guard lock(simulation().mutex);
  return int(simulation().devices.size());
}
int dhdGetAvailableCount() {
  const std::lock_guard lock(simulation().mutex);
  const auto& devices = simulation().devices;
  return int(std::count_if(devices.begin(), devices.end(),
                           [](const Device& d) { return !d.open && !d.in_use && !d.unplugged; }));
}

int dhdOpen() {
  return dhdsim::open_first([](int, const Device&) { return true; });
}
int dhdOpenType(int type) {
  return dhdsim::open_first([=](int, const Device& d) { return d.spec.type == type; });
}
int dhdOpenSerial(int serial) {
  return dhdsim::open_first([=](int, const Device& d) { return d.spec.serial == serial; });
}

int dhdClose(char id) {
  const std::lock_guard lock(simulation().mutex);
  const std::size_t n = id < 0 ? 0 : std::size_t(id);
  if (n >= simulation().devices.size() || !simulation().devices[n].open) return fail(DHD_ERROR_INVALID_INDEX);
  Device& d = simulation().devices[n];
  ++d.counters.closes;
  d.counters.off_before_close = !d.force_on && (d.brakes_on || d.spec.has_brakes == 0) ? 1 : 0;
  dhdsim::switch_off(d, DHD_FORCE_OFF_SOFTWARE);
  d.open = false;
  return 0;
}

int dhdGetSystemType(char id) {
  return on(id, [](Device& d) { return d.spec.type; });
}
const char* dhdGetSystemName(char id) {
  const std::lock_guard lock(simulation().mutex);
  const Device* d = dhdsim::find(id);
  return d == nullptr ? nullptr : d->name.c_str();
}
int dhdGetSerialNumber(ushort* serial, char id) {
  return on(id, [=](Device& d) {
    *serial = ushort(d.spec.serial);
    return 0;
  });
}
void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = 3;
  *minor = 17;
  *release = 5;
  *revision = 0;
}

int dhdEnableForce(uchar val, char id) {
  return expert(id, [=](Device& d) {
    if (const int error = dhdsim::injected(d, DHDSIM_ENABLE)) return fail(error);
    if (val == DHD_OFF) {
      d.counters.zero_force_before_off = dhdsim::is_zero(d.command) ? 1 : 0;
      dhdsim::switch_off(d, DHD_FORCE_OFF_SOFTWARE);
      return 0;
    }
    if (d.held_off) {
      ++d.counters.enables_in_vain;
      return fail(DHD_ERROR_NOT_ENABLED);
    }
    if (!d.calibrated) return fail(DHD_ERROR_DEVICE_NOT_READY);
    ++d.counters.enables;
    d.force_on = true;
    d.brakes_on = false;
    d.cause = DHD_FORCE_OFF_NONE;
    d.last_command = simulation().time;
    return 0;
  });
}

int dhdGetStatus(int status[DHD_MAX_STATUS], char id) {
  return on(id, [=](Device& d) {
    if (const int error = dhdsim::injected(d, DHDSIM_STATUS)) return fail(error);
    std::fill_n(status, DHD_MAX_STATUS, 0);
    status[DHD_STATUS_POWER] = status[DHD_STATUS_CONNECTED] = status[DHD_STATUS_STARTED] = 1;
    status[DHD_STATUS_RESET] = d.calibrated ? 0 : 1;
    status[DHD_STATUS_IDLE] = d.calibrated && !d.force_on && !d.brakes_on ? 1 : 0;
    status[DHD_STATUS_FORCE] = d.force_on ? 1 : 0;
    status[DHD_STATUS_BRAKE] = d.brakes_on ? 1 : 0;
    status[DHD_STATUS_WRIST_DETECTED] = d.spec.wrist;
    status[DHD_STATUS_GRAVITY] = d.gravity_on ? 1 : 0;
    status[DHD_STATUS_WRIST_INIT] = d.spec.wrist != 0 && d.wrist_initialised ? 1 : 0;
    status[DHD_STATUS_FORCE_OFF_CAUSE] = d.cause;
    return 0;
  });
}

bool dhdHasWrist(char id) {
  return ask(id, [](const Device& d) { return d.spec.wrist != 0; });
}
bool dhdHasActiveWrist(char id) {
  return ask(id, [](const Device& d) { return d.spec.active_wrist != 0; });
}
bool dhdIsLeftHanded(char id) {
  return ask(id, [](const Device& d) { return d.spec.left_handed != 0; });
}

int dhdGetPosition(double* px, double* py, double* pz, char id) {
  return read(id, DHDSIM_READ, [=](const Device& d) { dhdsim::position(d, px, py, pz); });
}
int dhdGetPositionAndOrientationFrame(double* px, double* py, double* pz, double matrix[3][3], char id) {
  return read(id, DHDSIM_READ, [=](const Device& d) {
    dhdsim::position(d, px, py, pz);
    dhdsim::frame(d, matrix);
  });
}
int dhdGetLinearVelocity(double* vx, double* vy, double* vz, char id) {
  return read(id, DHDSIM_VELOCITY, [=](const Device& d) {
    *vx = d.velocity[0];
    *vy = d.velocity[1];
    *vz = d.velocity[2];
  });
}
int dhdGetAngularVelocityRad(double* wx, double* wy, double* wz, char id) {
  return on(id, [=](Device& d) {
    if (d.spec.reports_angular_velocity == 0) return fail(DHD_ERROR_NOT_AVAILABLE);
    *wx = d.angular_velocity[0];
    *wy = d.angular_velocity[1];
    *wz = d.angular_velocity[2];
    return d.success;
  });
}

int dhdSetForce(double fx, double fy, double fz, char id) { return dhdsim::set_force(id, {{fx, fy, fz}, {}}, 0); }
int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz, double fg,
                                        char id) {
  return dhdsim::set_force(id, {{fx, fy, fz}, {tx, ty, tz}}, fg);
}

uint dhdGetButtonMask(char id) {
  const std::lock_guard lock(simulation().mutex);
  const Device* d = dhdsim::find(id);
  return d == nullptr ? 0 : d->buttons;
}

int dhdSetGravityCompensation(int val, char id) {
  return on(id, [=](Device& d) {
    d.gravity_on = val != DHD_OFF;
    return 0;
  });
}
int dhdSetEffectorMass(double mass, char id) {
  return on(id, [=](Device& d) {
    d.counters.effector_mass = mass;
    return 0;
  });
}
int dhdSetBrakes(int val, char id) {
  return on(id, [=](Device& d) {
    if (d.spec.has_brakes == 0) return fail(DHD_ERROR_NOT_AVAILABLE);
    d.counters.brakes_commanded = d.brakes_on = val != DHD_OFF;
    if (d.brakes_on) d.force_on = false;
    return 0;
  });
}
int dhdSetMaxForce(double f, char id) {
  return on(id, [=](Device& d) {
    d.counters.max_force = f;
    return 0;
  });
}
int dhdSetMaxTorque(double t, char id) {
  return on(id, [=](Device& d) {
    d.counters.max_torque = t;
    return 0;
  });
}
}
