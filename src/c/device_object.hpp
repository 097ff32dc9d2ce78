// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "c/handles.hpp"
#include "hapticut/device/device.hpp"

namespace hapticut::c {

class DeviceObject final : public Object {
 public:
  static constexpr Kind kKind = Kind::device;
  explicit DeviceObject(std::unique_ptr<Device> a_device) : device(std::move(a_device)) {}

  const std::unique_ptr<Device> device;
  std::atomic<bool> driven{false};  ///< a loop has it
};

}  // namespace hapticut::c
