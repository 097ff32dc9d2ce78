// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <mutex>
#include <utility>

#include "device/usages.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"

namespace hapticut {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<DeviceDriver> drivers;
};

/// The component that contains a driver. Its function, e.g. use_recordings, registers the driver.
struct Component {
  bool is_built;
  std::string name, option, function;
  std::string needs;  ///< what to install to build it
};

DeviceDriver unregistered_driver(const std::string& scheme, const std::string& usage, const Component& component) {
  const std::string cure = "link hapticut::" + component.name + " and call hapticut::" + component.function + "()";
  if (!component.is_built)
    return {scheme, usage, component.needs + ", then build hapticut with " + component.option + "=ON", nullptr};
  return {scheme, usage + "; after hapticut::" + component.function + "()", "",
          [scheme, cure](const std::string&) -> std::unique_ptr<Device> {
            throw Error("The device \"" + scheme + "\" is in this build, but its driver is not registered; " + cure +
                        " before open_device.");
          }};
}

#ifdef HAPTICUT_HAS_IO
constexpr bool kHasIo = true;
#else
constexpr bool kHasIo = false;
#endif
#ifdef HAPTICUT_HAS_OPENHAPTICS
constexpr bool kHasOpenHaptics = true;
#else
constexpr bool kHasOpenHaptics = false;
#endif
#ifdef HAPTICUT_HAS_FORCEDIMENSION
constexpr bool kHasForceDimension = true;
#else
constexpr bool kHasForceDimension = false;
#endif

Registry& registry() {
  static Registry all{
      {},
      {
          mock_driver(),
          mouse_driver(),
          unregistered_driver("replay", kReplayUsage,
                              {kHasIo, "io", "-DHAPTICUT_WITH_IO", "use_recordings",
                               "the dependencies of hapticut's component io (scripts/install-deps.sh)"}),
          unregistered_driver("openhaptics", kOpenHapticsUsage,
                              {kHasOpenHaptics, "openhaptics", "-DHAPTICUT_WITH_OPENHAPTICS", "use_open_haptics",
                               "3D Systems OpenHaptics 3.0 or later and the device's driver"}),
          unregistered_driver("forcedimension", kForceDimensionUsage,
                              {kHasForceDimension, "forcedimension", "-DHAPTICUT_WITH_FORCEDIMENSION",
                               "use_force_dimension", "the Force Dimension SDK 3.17 or later"}),
      }};
  return all;
}

std::string list_of(const std::vector<DeviceDriver>& drivers) {
  std::string text;
  for (const DeviceDriver& driver : drivers)
    text += (text.empty() ? "" : "; ") + driver.usage + (driver.missing.empty() ? "" : " (not in this build)");
  return text;
}

}  // namespace

void register_device_driver(DeviceDriver driver) {
  if (driver.scheme.empty() || driver.scheme.find(':') != std::string::npos)
    throw Error("A device driver's scheme \"" + driver.scheme + "\" must be a word without a colon.");
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto same = std::find_if(all.drivers.begin(), all.drivers.end(),
                                 [&](const DeviceDriver& other) { return other.scheme == driver.scheme; });
  if (same != all.drivers.end())
    *same = std::move(driver);
  else
    all.drivers.push_back(std::move(driver));
}

std::vector<DeviceDriver> device_drivers() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  return all.drivers;
}

std::unique_ptr<Device> open_device(const std::string& name) {
  const std::vector<DeviceDriver> drivers = device_drivers();
  const std::size_t colon = name.find(':');
  const std::string scheme = name.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : name.substr(colon + 1);
  for (const DeviceDriver& driver : drivers) {
    if (driver.scheme != scheme) continue;
    if (!driver.missing.empty() || !driver.open)
      throw Error("The device \"" + name + "\" cannot be used by this build; install " + driver.missing + ".");
    return driver.open(rest);
  }
  throw Error("There is no device \"" + name + "\"; choose one of: " + list_of(drivers) + ".");
}

}  // namespace hapticut
