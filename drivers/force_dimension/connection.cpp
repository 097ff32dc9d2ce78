// SPDX-License-Identifier: Apache-2.0
#include "force_dimension/connection.hpp"

#include <dhdc.h>
#include <drdc.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstring>
#include <mutex>

#include "device/careful_limits.hpp"
#include "force_dimension/frames.hpp"
#include "force_dimension/models.hpp"
#include "hapticut/core/errors.hpp"

namespace hapticut::force_dimension {
namespace {

constexpr double kWatchdogUnit = 125e-6;  // [s]

// Limits of a device that is not in the table: lower than those of all devices in it.
constexpr double kCarefulStiffness = 400;  // [N/m]
constexpr double kCarefulDamping = 2;      // [N·s/m]

// An arm reaches farther than the documented workspace; how far is not documented. A pose beyond this factor is not
// plausible.
constexpr double kReach = 1.4;  // [1] reach over the table's workspace

// Entries of the status, by number because names in the header have changed between versions. A newer library may have
// more entries.
constexpr std::size_t kReset = 3, kForce = 5, kWristDetected = 8, kWristInitialised = 12, kCause = 14;
constexpr std::size_t kStatusEntries = DHD_MAX_STATUS < 64 ? 64 : DHD_MAX_STATUS;

/// Devices that this process has open, because the library might open the same device twice.
std::array<std::atomic<bool>, 128> open_devices{};

/// Expert mode is one state for all devices of the process.
std::mutex expert_mutex;

class ExpertMode {
 public:
  explicit ExpertMode(std::unique_lock<std::mutex> lock) noexcept : lock_(std::move(lock)) {
    if (lock_.owns_lock()) dhdEnableExpertMode();
  }
  ~ExpertMode() {
    if (lock_.owns_lock()) dhdDisableExpertMode();
  }
  ExpertMode(const ExpertMode&) = delete;
  ExpertMode& operator=(const ExpertMode&) = delete;
  [[nodiscard]] bool is_on() const noexcept { return lock_.owns_lock(); }

 private:
  std::unique_lock<std::mutex> lock_;
};

/// The library's last error in this thread, as text with its number.
std::string last_error() {
  const int code = dhdErrorGetLast();
  const char* words = dhdErrorGetLastStr();
  return (words != nullptr && *words != '\0' ? std::string(words) : "unknown error") + " (error " +
         std::to_string(code) + ")";
}

Reply reply_of(int result) noexcept {
  Reply a;
  a.saturated = result == DHD_MOTOR_SATURATED;
  if (result >= 0) return a;
  a.ok = false;
  a.error = dhdErrorGetLast();
  a.fault = fault_of(a.error);
  return a;
}

std::string list_of_models() {
  std::string names;
  for (const Model& model : models()) names += (names.empty() ? "" : ", ") + std::string(model.name);
  return names;
}

int open_by_name(const std::string& name) {
  if (name.empty()) return dhdOpen();
  int serial = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), serial);
  if (error == std::errc() && end == name.data() + name.size() && serial >= 0) return dhdOpenSerial(serial);
  int id = -1;
  bool known = false;
  for (const Model& model : models()) {
    if (!answers_to(model, name)) continue;
    known = true;
    if (id < 0) id = dhdOpenType(model.type);
  }
  if (!known)
    throw Error("There is no device \"" + name + "\" of Force Dimension; give a serial number, or one of " +
                list_of_models() + ".");
  return id;
}

}  // namespace

Connection::Connection(const ForceDimensionOptions& options) : options_(options) {
  require_fields_within(options, "ForceDimensionOptions::");
  open(options.device_name);
  try {
    describe_device();
    if (options.calibrate) calibrate();
  } catch (...) {
    dhdClose(id_);
    open_devices[number_] = false;
    throw;
  }
  opening_warnings_ = warnings_.size();
}

Connection::~Connection() {
  end();
  dhdClose(id_);
  open_devices[number_] = false;
}

void Connection::open(const std::string& name) {
  const int id = open_by_name(name);
  if (id < 0) {
    const std::string reason = last_error();
    throw Error("The library of Force Dimension opens no device" + (name.empty() ? "" : " \"" + name + "\"") + ": " +
                reason + ", " + std::to_string(dhdGetDeviceCount()) + " connected, " +
                std::to_string(dhdGetAvailableCount()) +
                " of them free; check cable, power, the permission to use its USB device (a udev rule, "
                "docs/devices.md), and that no other program uses it.");
  }
  number_ = std::size_t(id);
  if (number_ >= open_devices.size() || open_devices[number_].exchange(true))
    throw Error("The device" + (name.empty() ? "" : " \"" + name + "\"") +
                " of Force Dimension is open in this program already; close it first, or name another one.");
  id_ = char(id);
}

void Connection::describe_device() {
  DeviceCapabilities& c = capabilities_;
  const char* name = dhdGetSystemName(id_);
  c.model = name != nullptr ? name : "unknown";
  if (dhdIsLeftHanded(id_)) c.model += ", left-handed";
  c.vendor = "Force Dimension";
  ushort serial = 0;
  if (dhdGetSerialNumber(&serial, id_) >= 0) c.serial_number = std::to_string(serial);
  std::array<int, 4> version{};
  dhdGetSDKVersion(&version[0], &version[1], &version[2], &version[3]);
  for (const int part : version) {
    if (!c.driver_version.empty()) c.driver_version += '.';
    c.driver_version += std::to_string(part);
  }

  has_wrist_ = dhdHasWrist(id_);
  active_wrist_ = has_wrist_ && dhdHasActiveWrist(id_);
  c.input_degrees_of_freedom = has_wrist_ ? 6 : 3;
  c.output_degrees_of_freedom = active_wrist_ ? 6 : 3;
  double x = 0, y = 0, z = 0;
  reports_angular_velocity_ = has_wrist_ && dhdGetAngularVelocityRad(&x, &y, &z, id_) >= 0;

  const int type = dhdGetSystemType(id_);
  const Model* model = find_model(type);
  if (model != nullptr) {
    c.peak_force = model->force;
    c.stiffness = model->stiffness;
    c.damping = model->damping;
    const auto& half = model->half_width;
    c.workspace_high = kReach * to_base(Vec3(half[0], half[1], half[2]));
    c.workspace_low = -c.workspace_high;
  } else {
    c.peak_force = kCarefulForce;
    c.stiffness = kCarefulStiffness;
    c.damping = kCarefulDamping;
    warnings_.push_back("The device " + c.model + " (type " + std::to_string(type) + ") is unknown; it is limited to " +
                        format_number(kCarefulForce) + " N and " + format_number(kCarefulStiffness) + " N/m.");
  }
  if (!active_wrist_) return;
  if (model != nullptr && model->torque > 0) {
    c.peak_torque = model->torque;
    c.rotational_stiffness = model->rotational_stiffness;
  } else {
    c.peak_torque = kCarefulTorque;
    warnings_.push_back("The peak torque of the device " + c.model + " is unknown; it is limited to " +
                        format_number(kCarefulTorque) + " N·m.");
  }
}

void Connection::calibrate() {
  if (drdOpenID(id_) < 0)
    throw Error("The device " + capabilities_.model + " cannot be calibrated: " + last_error() +
                "; calibrate it by hand, with " + "ForceDimensionOptions::calibrate"_name + " = false.");
  if (drdIsInitialized(id_)) return;
  const bool done = drdAutoInit(id_) >= 0;
  const std::string reason = done ? "" : last_error();
  drdStop(false, id_);
  if (!done)
    throw Error("The device " + capabilities_.model + " could not calibrate itself: " + reason +
                "; release it and keep its workspace free, or calibrate it by hand.");
}

void Connection::complain(const std::string& what) {
  warnings_.push_back("The device " + capabilities_.model + " " + what + ": " + last_error() + ".");
}

void Connection::begin() {
  warnings_.resize(opening_warnings_);
  begun_ = true;
  const auto require = [this](int result, const char* what) {
    if (reply_of(result).ok) return;
    throw Error("The device " + capabilities_.model + " cannot " + what + ": " + last_error() +
                "; check its power and its lights, and that no other program uses it.");
  };
  try {
    (void)dhdSetBrakes(DHD_OFF, id_);  // not every device has brakes
    if (dhdSetGravityCompensation(DHD_ON, id_) < 0) complain("does not compensate the weight of its arm");
    if (options_.effector_mass > 0 && dhdSetEffectorMass(options_.effector_mass, id_) < 0)
      complain("refuses the effector_mass of its options");
    if (dhdSetMaxForce(capabilities_.peak_force, id_) < 0) complain("has no force limit of its own");
    if (active_wrist_ && dhdSetMaxTorque(capabilities_.peak_torque, id_) < 0)
      complain("has no torque limit of its own");

    (void)write({});  // a command must exist when the forces are switched on
    const ExpertMode expert{std::unique_lock(expert_mutex)};
    Status status;
    const Reply asked = read_status(status);
    require(asked.ok ? 0 : -1, "report its status");
    if (status.calibrated) {
      const int on = dhdEnableForce(DHD_ON, id_);
      // For example a button that is not pressed: the loop runs without forces and reports it.
      if (on >= 0 || reply_of(on).fault != DeviceFault::none) require(on, "switch its forces on");
    }
    if (dhdSetWatchdog(static_cast<unsigned char>(std::lround(options_.watchdog / kWatchdogUnit)), id_) < 0)
      complain("has no watchdog, so it keeps its last force when a debugger or SIGKILL stops this program");
    (void)write({});
  } catch (...) {
    end();
    throw;
  }
}

void Connection::end() noexcept {
  if (!begun_) return;
  begun_ = false;
  (void)write({});
  const ExpertMode expert{std::unique_lock(expert_mutex)};
  dhdEnableForce(DHD_OFF, id_);
  dhdSetBrakes(DHD_ON, id_);
}

Reply Connection::read(DeviceState& state) noexcept {
  std::array<double, 3> p{}, v{}, w{};
  double m[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Reply pose = reply_of(has_wrist_ ? dhdGetPositionAndOrientationFrame(&p[0], &p[1], &p[2], m, id_)
                                         : dhdGetPosition(&p[0], &p[1], &p[2], id_));
  if (!pose.ok) return pose;
  state.X_BS.translation = to_base(Vec3(p[0], p[1], p[2]));
  Mat3 R_D;
  R_D << m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2];
  state.X_BS.rotation = orthonormalized(to_base(R_D));

  const Reply moving = reply_of(dhdGetLinearVelocity(&v[0], &v[1], &v[2], id_));
  if (moving.fault != DeviceFault::none) return moving;
  state.velocity.linear = moving.ok ? to_base(Vec3(v[0], v[1], v[2])) : Vec3::Zero();
  if (reports_angular_velocity_) {
    const Reply rotating = reply_of(dhdGetAngularVelocityRad(&w[0], &w[1], &w[2], id_));
    if (rotating.fault != DeviceFault::none) return rotating;
    state.velocity.angular = rotating.ok ? to_base(Vec3(w[0], w[1], w[2])) : Vec3::Zero();
  }
  state.buttons = dhdGetButtonMask(id_);
  return pose;
}

Reply Connection::write(const Wrench& wrench) noexcept {
  const Vec3 f = to_library(wrench.force);
  if (!active_wrist_) return reply_of(dhdSetForce(f.x(), f.y(), f.z(), id_));
  const Vec3 t = to_library(wrench.torque);
  return reply_of(dhdSetForceAndTorqueAndGripperForce(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), 0, id_));
}

Reply Connection::read_status(Status& status) noexcept {
  std::array<int, kStatusEntries> entries{};
  const Reply asked = reply_of(dhdGetStatus(entries.data(), id_));
  if (!asked.ok) return asked;
  status.force = entries[kForce] != 0;
  const bool wrist_unknown = has_wrist_ && entries[kWristDetected] != 0 && entries[kWristInitialised] == 0;
  status.calibrated = entries[kReset] == 0 && !wrist_unknown;
  const int cause = entries[kCause];
  status.cause = cause > 0 && cause < int(ForceOff::count) ? ForceOff(cause) : ForceOff::none;
  return asked;
}

Reply Connection::switch_on() noexcept {
  const ExpertMode expert{std::unique_lock(expert_mutex, std::try_to_lock)};
  if (!expert.is_on()) return {false, false, error::kBusy, DeviceFault::none};
  (void)dhdSetBrakes(DHD_OFF, id_);
  return reply_of(dhdEnableForce(DHD_ON, id_));
}

void Connection::copy_last_error(std::array<char, 128>& words) noexcept {
  const char* last = dhdErrorGetLastStr();
  std::strncpy(words.data(), last != nullptr ? last : "unknown error", words.size() - 1);
}

}  // namespace hapticut::force_dimension
