// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <mutex>
#include <utility>

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

DeviceDriver absent(std::string scheme, std::string usage, std::string missing) {
  return {std::move(scheme), std::move(usage), std::move(missing), nullptr};
}

Registry& registry() {
  static Registry all{
      {},
      {
          mock_driver(),
          mouse_driver(),
          absent("replay", "replay:FILE, FILE a recording",
                 "what hapticut's component io needs (scripts/install-deps.sh), then build hapticut with "
                 "-DHAPTICUT_WITH_IO=ON, link hapticut::io and call hapticut::use_recordings()"),
          absent("openhaptics", "openhaptics[:NAME], NAME as in the maker's setup program",
                 "3D Systems OpenHaptics 3.0 or later and the device's driver, then build hapticut with "
                 "-DHAPTICUT_WITH_OPENHAPTICS=ON and call hapticut::use_open_haptics()"),
          absent(
              "forcedimension", "forcedimension[:NAME], NAME a serial number or a model, e.g. omega.7 or sigma.7-left",
              "the Force Dimension SDK 3.17 or later, then build hapticut with -DHAPTICUT_WITH_FORCEDIMENSION=ON and "
              "call hapticut::use_force_dimension()"),
      }};
  return all;
}

std::string list(const std::vector<DeviceDriver>& drivers) {
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
  throw Error("There is no device \"" + name + "\"; there are: " + list(drivers) + ".");
}

}  // namespace hapticut
