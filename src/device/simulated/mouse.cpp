// SPDX-License-Identifier: Apache-2.0
#include "hapticut/device/simulated/mouse.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/effects/output_limits.hpp"

namespace hapticut {
namespace {

DeviceCapabilities capabilities_of_a_mouse(const MouseOptions& options) {
  DeviceModel model = device_model(options.device);
  model.workspace_half_width = options.reach;
  DeviceCapabilities c = capabilities(model);
  c.model = "mouse";
  c.continuous_force = 0;           // no motors get warm
  c.output_degrees_of_freedom = 3;  // the keys rotate its gimbal, independent of the torque
  c.peak_torque = c.continuous_torque = c.rotational_stiffness = 0;
  c.hard_realtime = false;
  return c;
}

void add(std::atomic<double>& sum, double amount) noexcept {
  if (!std::isfinite(amount)) return;
  double old = sum.load(std::memory_order_relaxed);
  while (!sum.compare_exchange_weak(old, old + amount, std::memory_order_relaxed)) {
  }
}

}  // namespace

struct MouseDevice::Inputs {
  std::atomic<double> x{0}, y{0}, z{0};  // [m] requested since the last tick
  std::atomic<std::uint32_t> buttons{0};
  std::array<std::atomic<bool>, std::size_t(MoveKey::count)> keys{};
  std::array<std::atomic<double>, 3> set_point{};
};

MouseDevice::MouseDevice(const MouseOptions& options)
    : PolledDevice("mouse", capabilities_of_a_mouse(options)),
      options_(options),
      plant_(device_model(options.device), hand_model(options.hand), {}),
      inputs_(std::make_unique<Inputs>()) {
  require_fields_within(options, "MouseOptions::");
}

MouseDevice::~MouseDevice() = default;

void MouseDevice::pointer_moved(double dx, double dy) noexcept {
  add(inputs_->x, options_.per_pixel * dx);
  add(inputs_->y, -options_.per_pixel * dy);
}

void MouseDevice::wheel_turned(double notches) noexcept { add(inputs_->z, -options_.per_notch * notches); }

void MouseDevice::button(int number, bool pressed) noexcept {
  if (number < 0 || number > 31) return;
  const std::uint32_t bit = 1U << unsigned(number);
  if (pressed)
    inputs_->buttons.fetch_or(bit, std::memory_order_relaxed);
  else
    inputs_->buttons.fetch_and(~bit, std::memory_order_relaxed);
}

void MouseDevice::key(MoveKey key, bool pressed) noexcept {
  if (key < MoveKey::count) inputs_->keys[std::size_t(key)].store(pressed, std::memory_order_relaxed);
}

Vec3 MouseDevice::set_point() const noexcept {
  return {inputs_->set_point[0].load(), inputs_->set_point[1].load(), inputs_->set_point[2].load()};
}

void MouseDevice::begin_run(const RunOptions& options) {
  period_ = options.guard.period;
  simulated_ = options.simulated_time;
  tick_ = 0;
  angle_ = 0;
  for (std::atomic<double>* moved : {&inputs_->x, &inputs_->y, &inputs_->z}) moved->store(0);  // forgets older motion
  target_ = {};
  wanted_.setZero();
  plant_ = Plant(plant_.device(), plant_.hand(), {period_, period_ / 50, false, false, false});
  plant_.reset(target_);
}

bool MouseDevice::read(DeviceState& state) noexcept {
  const auto held = [&](MoveKey key) {
    return inputs_->keys[std::size_t(key)].load(std::memory_order_relaxed) ? 1 : 0;
  };
  const auto axis = [&](MoveKey minus, MoveKey plus) { return double(held(plus) - held(minus)); };
  wanted_ += Vec3(inputs_->x.exchange(0), inputs_->y.exchange(0), inputs_->z.exchange(0));
  wanted_ +=
      options_.key_speed * period_ *
      Vec3(axis(MoveKey::left, MoveKey::right), axis(MoveKey::down, MoveKey::up), axis(MoveKey::away, MoveKey::nearer));
  wanted_ = wanted_.cwiseMax(-options_.reach).cwiseMin(options_.reach);
  angle_ += options_.key_angular_speed * period_ * axis(MoveKey::turn_right, MoveKey::turn_left);
  target_.translation += saturated(wanted_ - target_.translation, options_.max_speed * period_);
  target_.rotation = rotation_from_vector(Vec3(0, 0, angle_));
  plant_.set_target(target_);
  for (std::size_t n = 0; n < 3; ++n) inputs_->set_point[n].store(target_.translation[Eigen::Index(n)]);

  const double now = monotonic_time();
  if (tick_ == 0) begin_ = now;
  state = {};
  state.X_BS = plant_.pose();
  state.velocity = plant_.velocity();
  state.buttons = inputs_->buttons.load(std::memory_order_relaxed);
  state.time = simulated_ ? double(tick_) * period_ : now - begin_;
  state.sequence = ++tick_;
  return true;
}

Wrench MouseDevice::write(const Wrench& wrench) noexcept {
  plant_.advance(wrench);
  return wrench;
}

DeviceDriver mouse_driver() {
  return {"mouse", "mouse", "", [](const std::string& rest) -> std::unique_ptr<Device> {
            if (!rest.empty()) throw Error("The device \"mouse\" takes no name, but got \"" + rest + "\".");
            return std::make_unique<MouseDevice>();
          }};
}

}  // namespace hapticut
