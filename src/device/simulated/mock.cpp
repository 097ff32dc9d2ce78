// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/mock.hpp"

#include <cmath>
#include <sstream>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/effects/output_limits.hpp"

namespace hapticut {
namespace {

constexpr double kMaxRunTime = 1e6;  // [s] largest value in a text

MockOptions with_defaults(MockOptions options) {
  if (!options.path) options.path = scripted_path("rest");
  if (options.device.mass == 0) options.device = device_model("touch");
  require_fields_within(options, "MockOptions::");
  return options;
}

double seconds_from(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  if (!(in >> value) || !in.eof() || !(value > 0 && value <= kMaxRunTime))
    throw Error("The mock device's seconds=" + text + " must be a number above 0, e.g. seconds=10.");
  return value;
}

Plant plant_of(const MockOptions& options, double period) {
  const bool moved = !options.rigid;
  return {options.device,
          options.hand,
          {period, period / 50, options.dry_friction && moved, options.encoder && moved, moved}};
}

}  // namespace

MockDevice::MockDevice(MockOptions options, std::string name)
    : PolledDevice(std::move(name),
                   hapticut::capabilities(options.device.mass > 0 ? options.device : device_model("touch"))),
      options_(with_defaults(std::move(options))),
      plant_(plant_of(options_, period_)) {}

MockDevice::~MockDevice() = default;

void MockDevice::begin_run(const RunOptions& options) {
  period_ = options.guard.period;
  plant_ = plant_of(options_, period_);
  tick_ = 0;
  velocity_ = {};
  X_BS_last_ = options_.path(0);
  plant_.reset(X_BS_last_);
}

bool MockDevice::read(DeviceState& state) noexcept {
  const double time = double(tick_) * period_;
  if (options_.end > 0 && time >= options_.end) return false;
  if (options_.rigid)
    plant_.reset(options_.path(time));
  else
    plant_.set_target(options_.path(time));
  const Pose X_BS = plant_.measured_pose();
  Twist raw = twist_between(X_BS_last_, X_BS, period_);
  if (!is_finite(raw.linear) || !is_finite(raw.angular)) raw = {};  // otherwise NaN would stay in the filter
  const double memory =
      options_.velocity_filter > 0 ? std::exp(-2 * units::kPi * options_.velocity_filter * period_) : 0;
  velocity_.linear = memory * velocity_.linear + (1 - memory) * raw.linear;
  velocity_.angular = memory * velocity_.angular + (1 - memory) * raw.angular;
  X_BS_last_ = X_BS;
  state = {};
  state.X_BS = X_BS;
  state.velocity = velocity_;
  state.time = time;
  state.sequence = ++tick_;
  return true;
}

Wrench MockDevice::write(const Wrench& wrench) noexcept {
  Wrench applied{saturated(wrench.force, options_.device.peak_force),
                 rendered_torque(options_.device, X_BS_last_.rotation.col(2), wrench.torque)};
  if (!options_.rigid) plant_.advance(applied);
  return applied;
}

std::unique_ptr<MockDevice> open_mock(const std::string& text) {
  MockOptions options;
  options.device = device_model("touch");
  std::istringstream parts(text);
  std::string part;
  std::getline(parts, part, ',');
  options.path = scripted_path(part);
  while (std::getline(parts, part, ',')) {
    const std::size_t equals = part.find('=');
    const std::string key = part.substr(0, equals), value = equals == std::string::npos ? "" : part.substr(equals + 1);
    if (key == "device") {
      options.device = device_model(value);
    } else if (key == "hand") {
      options.hand = hand_model(value);
      options.rigid = false;
    } else if (key == "seconds") {
      options.end = seconds_from(value);
    } else {
      throw Error("The mock device has no option \"" + part +
                  "\"; write mock:PATH,device=NAME,hand=NAME,seconds=NUMBER, each after PATH optional.");
    }
  }
  return std::make_unique<MockDevice>(std::move(options), "mock:" + text);
}

DeviceDriver mock_driver() {
  return {"mock", "mock:PATH[,device=NAME][,hand=NAME][,seconds=NUMBER], PATH rest, press, line, circle or spiral", "",
          [](const std::string& rest) -> std::unique_ptr<Device> { return open_mock(rest); }};
}

}  // namespace hapticut
