// SPDX-License-Identifier: Apache-2.0
#include <mutex>

#include "c/device_object.hpp"
#include "c/structs.hpp"
#include "device/use_maker_devices.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/recording/playback.hpp"
#endif

namespace hapticut::c {
namespace {

/// Registers all kinds of devices of this build, once.
void use_all_devices() {
  static std::once_flag once;
  std::call_once(once, [] {
#ifdef HAPTICUT_HAS_IO
    use_recordings();
#endif
    use_maker_devices();
  });
}

}  // namespace
}  // namespace hapticut::c

using namespace hapticut;
using namespace hapticut::c;

extern "C" {

int hapticut_device_open(const char* name, hapticut_device* device) {
  return guarded([&] {
    require_argument(name, "name");
    require_argument(device, "device");
    use_all_devices();
    *device = add_object(Kind::device, std::make_shared<DeviceObject>(open_device(name)));
  });
}

int hapticut_device_describe(hapticut_device device, hapticut_device_info* info) {
  if (const int code = check_size(info, "info"); code != HAPTICUT_OK) return code;
  return within(Use<DeviceObject>(device), [&](const auto& use) {
    const DeviceCapabilities& has = use->device->capabilities();
    hapticut_device_info own{};
    own.input_degrees_of_freedom = has.input_degrees_of_freedom;
    own.output_degrees_of_freedom = has.output_degrees_of_freedom;
    own.rate = has.rate;
    own.peak_force = has.peak_force;
    own.continuous_force = has.continuous_force;
    own.peak_torque = has.peak_torque;
    own.stiffness = has.stiffness;
    own.damping = has.damping;
    put(has.workspace_low, own.workspace_min);
    put(has.workspace_high, own.workspace_max);
    copy_text(has.model, own.model, sizeof own.model);
    copy_text(has.serial_number, own.serial_number, sizeof own.serial_number);
    write_struct(own, info);
  });
}

}  // extern "C"
