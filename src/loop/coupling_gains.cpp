// SPDX-License-Identifier: Apache-2.0
#include "hapticut/loop/coupling_gains.hpp"

#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

constexpr double kMinDampingRatio = 0.5, kDampingRatio = 0.7;  // [1] below which a tool rings, and the chosen ratio
constexpr double kMinMass = 1e-3;                              // [kg] mass of a tool that a hand could hold

}  // namespace

CouplingGains coupling_gains(const DeviceCapabilities& device, std::optional<double> mass) {
  if (!(device.stiffness > 0))
    throw Error("the device " + device.model + " states no stiffness, so no coupling can be chosen for it; set " +
                "CouplingGains"_name + ".");
  CouplingGains gains;
  gains.stiffness = device.stiffness;
  const auto max_mass = [&](double ratio) { return std::pow(device.damping / (2 * ratio), 2) / gains.stiffness; };
  const double common = gains.mass;
  gains.mass = mass.value_or(device.damping > 0 ? std::min(common, max_mass(kDampingRatio)) : common);
  if (!mass && gains.mass < kMinMass)
    throw Error(
        "a stiffness of " + format_number(device.stiffness) + " N/m with a damping of " +
        format_number(device.damping) + " N s/m, which the device " + device.model +
        " states, would ring with any tool of more than " + format_number(max_mass(kMinDampingRatio)) + " kg." +
        Sentence::clause(" Give the stiffness that it renders in " + "DeviceCapabilities::stiffness"_name + "."));
  gains.inertia *= gains.mass / common;
  if (device.damping > 0 && gains.mass > max_mass(kMinDampingRatio))
    throw Error("CouplingGains::mass"_name + " [kg] = " + format_number(gains.mass) + " would ring on the device " +
                device.model + ", whose damping is " + format_number(device.damping) + " N s/m. Choose at most " +
                format_number(max_mass(kMinDampingRatio)) + " kg.");
  gains.damping = 2 * std::sqrt(gains.stiffness * gains.mass);
  if (device.damping > 0) gains.damping = std::min(gains.damping, device.damping);
  if (device.peak_force > 0) gains.max_force = device.peak_force;
  if (device.peak_torque > 0) gains.max_torque = device.peak_torque;
  if (device.output_degrees_of_freedom == 6 && device.rotational_stiffness > 0) {
    gains.angular_stiffness = device.rotational_stiffness;
    gains.angular_damping = 2 * std::sqrt(gains.angular_stiffness * gains.inertia);
  }
  validate(gains);
  return gains;
}

}  // namespace hapticut
