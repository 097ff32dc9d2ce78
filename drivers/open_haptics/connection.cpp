// SPDX-License-Identifier: Apache-2.0
#include "open_haptics/connection.hpp"

#include <clocale>

#include <array>
#include <atomic>

#include "device/careful_limits.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "open_haptics/errors.hpp"
#include "open_haptics/scheduler.hpp"

namespace hapticut::open_haptics {
namespace {

constexpr double kPerMillimetre = 1000;  // [1/m] N/mm to N/m
constexpr int kTriesToReopen = 10;

// The guard removes a force at once and lets it grow slowly. So the driver must accept a step of this many times the
// peak force.
constexpr double kMaxStep = 1.25;  // [1]

std::atomic<int> open_connections{0};

/// Sets the decimal point while the driver reads its files. With a decimal comma some drivers read wrong numbers, and
/// the position then stands still.
class DecimalPoint {
 public:
  DecimalPoint() : point_(newlocale(LC_NUMERIC_MASK, "C", duplocale(uselocale(nullptr)))), old_(uselocale(point_)) {}
  ~DecimalPoint() {
    uselocale(old_);
    freelocale(point_);
  }
  DecimalPoint(const DecimalPoint&) = delete;
  DecimalPoint& operator=(const DecimalPoint&) = delete;

 private:
  locale_t point_, old_;
};

/// A number that not every device has: zero if the driver reports an error.
double number(HDenum name) {
  HDdouble value = 0;
  hdGetDoublev(name, &value);
  return drain().any() ? 0 : value;
}

int integer(HDenum name, int fallback) {
  HDint value = 0;
  hdGetIntegerv(name, &value);
  return drain().any() ? fallback : value;
}

std::string text(HDenum name) {
  const char* value = hdGetString(name);
  return drain().any() || value == nullptr ? "" : value;
}

std::string quoted(const char* name) {
  if (name == nullptr) return "the default device";
  std::string words = "\"";  // built in parts, because GCC 12 warns wrongly about operator+
  words += name;
  words += '"';
  return words;
}

}  // namespace

Connection::Connection(const OpenHapticsOptions& options) {
  if (Scheduler::instance().is_running())
    throw Error("An OpenHaptics device is running; open all devices before the first of them runs.");
  if (!options.license_vendor.empty() &&
      hdDeploymentLicense(options.license_vendor.c_str(), options.license_application.c_str(),
                          options.license_password.c_str()) != HD_TRUE)
    throw Error("OpenHaptics refuses the deployment licence of \"" + options.license_vendor + "\" for \"" +
                options.license_application + "\"; check " + "OpenHapticsOptions::license_vendor"_name +
                ", license_application and license_password.");
  initialise(options);
  ++open_connections;
  try {
    hdMakeCurrentDevice(handle_);
    ask();
    calibrate(options.reset_encoders);
  } catch (...) {
    hdDisableDevice(handle_);
    drain();
    --open_connections;
    throw;
  }
}

Connection::~Connection() {
  Scheduler::instance().between_ticks([this] { hdDisableDevice(handle_); });
  drain();
  --open_connections;
}

void Connection::initialise(const OpenHapticsOptions& options) {
  std::vector<const char*> names = {options.device_name.empty() ? HD_DEFAULT_DEVICE : options.device_name.c_str()};
  const bool alone = open_connections == 0;
  if (options.other_names && alone)
    for (const char* name : std::initializer_list<const char*>{HD_DEFAULT_DEVICE, "Default Device", "Default PHANToM"})
      if (name != names.front()) names.push_back(name);

  const DecimalPoint decimal_point;
  std::string reasons;
  for (const char* name : names) {
    drain();
    handle_ = hdInitDevice(name);
    Errors errors = drain();
    // Other code in this process has opened the device and not closed it. A device that this library has open stays
    // open.
    for (int n = 0; n < kTriesToReopen && alone && errors.has(HD_DEVICE_ALREADY_INITIATED); ++n) {
      const HHD other = hdGetCurrentDevice();
      hdDisableDevice(other);
      drain();
      handle_ = hdInitDevice(name);
      errors = drain();
    }
    if (!errors.any() && handle_ != HD_INVALID_HANDLE) {  // 0 is a valid handle
      if (name != names.front())
        warnings_.push_back("The driver refused " + quoted(names.front()) + " (" + reasons + "); opened " +
                            quoted(name) + " instead.");
      return;
    }
    reasons += (reasons.empty() ? "" : "; ") + quoted(name) + ": " + errors.describe();
    if (errors.has(HD_INVALID_LICENSE))
      throw Error("OpenHaptics has no valid licence: " + errors.describe() +
                  "; install a development licence (OH_SDK_LICENSE_PATH), or set " +
                  "OpenHapticsOptions::license_vendor"_name + ".");
  }
  throw Error("OpenHaptics opens no device (" + reasons +
              "); check cable, power, the permission to use /dev/ttyACM* (group dialout), and the name in the "
              "maker's setup program.");
}

void Connection::ask() {
  DeviceCapabilities& c = capabilities_;
  c.model = text(HD_DEVICE_MODEL_TYPE);
  c.vendor = text(HD_DEVICE_VENDOR);
  c.serial_number = text(HD_DEVICE_SERIAL_NUMBER);
  c.driver_version = text(HD_DEVICE_DRIVER_VERSION);
  c.input_degrees_of_freedom = integer(HD_INPUT_DOF, 6);
  c.output_degrees_of_freedom = integer(HD_OUTPUT_DOF, 3) >= 6 ? 6 : 3;
  c.peak_force = number(HD_NOMINAL_MAX_FORCE);
  if (!(c.peak_force > 0)) {
    c.peak_force = kCarefulForce;
    warnings_.push_back("The driver does not report the peak force of the device; it is limited to " +
                        format_number(kCarefulForce) + " N.");
  }
  c.continuous_force = number(HD_NOMINAL_MAX_CONTINUOUS_FORCE);
  c.stiffness = number(HD_NOMINAL_MAX_STIFFNESS) * kPerMillimetre;
  c.damping = number(HD_NOMINAL_MAX_DAMPING) * kPerMillimetre;
  if (c.output_degrees_of_freedom == 6) {
    c.peak_torque = number(HD_NOMINAL_MAX_TORQUE_FORCE) * units::mN_m;
    if (!(c.peak_torque > 0)) c.peak_torque = kCarefulTorque;
    c.continuous_torque = number(HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE) * units::mN_m;
    c.rotational_stiffness = number(HD_NOMINAL_MAX_TORQUE_STIFFNESS) * units::mN_m;
  }
  std::array<HDdouble, 6> box{};
  hdGetDoublev(HD_MAX_WORKSPACE_DIMENSIONS, box.data());
  if (!drain().any()) {
    c.workspace_low = Vec3(box[0], box[1], box[2]) * units::mm;
    c.workspace_high = Vec3(box[3], box[4], box[5]) * units::mm;
  }
  c.rate = integer(HD_UPDATE_RATE, 1000);
  std::array<HDdouble, 6> temperatures{};
  hdGetDoublev(HD_MOTOR_TEMPERATURE, temperatures.data());
  measures_temperature_ = !drain().any();
}

void Connection::calibrate(bool reset_encoders) {
  const auto styles = HDenum(integer(HD_CALIBRATION_STYLE, 0));
  calibration_style_ = 0;
  for (const HDenum style :
       {HDenum(HD_CALIBRATION_AUTO), HDenum(HD_CALIBRATION_INKWELL), HDenum(HD_CALIBRATION_ENCODER_RESET)})
    if ((styles & style) != 0 && calibration_style_ == 0) calibration_style_ = style;
  if (calibration_style_ != HD_CALIBRATION_ENCODER_RESET) return;  // calibrated during the run
  if (reset_encoders) {
    hdUpdateCalibration(calibration_style_);
    const Errors errors = drain();
    if (errors.any()) throw Error("The encoders cannot be reset: " + errors.describe() + ".");
  } else if (hdCheckCalibration() != HD_CALIBRATION_OK) {
    drain();
    throw Error("The device " + capabilities_.model +
                " is not calibrated; hold all its links at right angles and open it with " +
                "OpenHapticsOptions::reset_encoders"_name + " = true.");
  }
  drain();
}

void Connection::enable_force(bool on) {
  Scheduler::instance().between_ticks([this, on] {
    hdMakeCurrentDevice(handle_);
    hand_released_.store(false);
    if (on) {
      for (const HDenum safety :
           {HDenum(HD_FORCE_RAMPING), HDenum(HD_MAX_FORCE_CLAMPING), HDenum(HD_SOFTWARE_FORCE_LIMIT)})
        hdEnable(safety);
      // The default limit of a few newtons would switch the motors of a strong device off when the force ends.
      const HDdouble needed = kMaxStep * capabilities_.peak_force;
      const double allowed = number(HD_SOFTWARE_FORCE_IMPULSE_LIMIT);
      if (allowed > 0 && allowed < needed) hdSetDoublev(HD_SOFTWARE_FORCE_IMPULSE_LIMIT, &needed);
      hdEnable(HD_FORCE_OUTPUT);
    } else {
      hdDisable(HD_FORCE_OUTPUT);
    }
    drain();
  });
}

void Connection::release_hand() noexcept {
  Scheduler& scheduler = Scheduler::instance();
  const bool has_driver = scheduler.wait_for_driver();  // goes on without the driver, because the hand comes first
  hdMakeCurrentDevice(handle_);
  hdDisable(HD_FORCE_OUTPUT);
  hand_released_.store(true);  // before another tick can check it
  if (has_driver) scheduler.release_driver();
}

}  // namespace hapticut::open_haptics
