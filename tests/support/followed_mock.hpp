// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <utility>

#include "hapticut/device/simulated/mock.hpp"

namespace hapticut::test {

/// A simulated device: a test changes its readings and sees what its motors render.
class FollowedMock final : public MockDevice {
 public:
  using Read = std::function<void(DeviceState& state)>;
  using Rendered = std::function<void(const Wrench& wrench)>;

  explicit FollowedMock(
      MockOptions options, Read read, Rendered rendered = [](const Wrench&) {})
      : MockDevice(std::move(options)), read_(std::move(read)), rendered_(std::move(rendered)) {}

 protected:
  bool read(DeviceState& state) noexcept override {
    if (!MockDevice::read(state)) return false;
    read_(state);
    return true;
  }
  Wrench write(const Wrench& wrench) noexcept override {
    Wrench given = MockDevice::write(wrench);
    rendered_(given);
    return given;
  }

 private:
  Read read_;
  Rendered rendered_;
};

/// The options of a touch that holds its path exactly.
inline MockOptions rigid_touch() {
  MockOptions options;
  options.device = device_model("touch");
  return options;
}

}  // namespace hapticut::test
