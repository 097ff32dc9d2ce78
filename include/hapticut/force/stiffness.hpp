// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/material.hpp"

/// @file
/// How stiff the foundation should be. Its stiffness k_v regularises the contact; two demands bound it, and they pull
/// apart: accuracy wants it stiff, a device that is driven directly wants it soft. A virtual coupling separates the
/// two.
namespace hapticut {

/// The k_v from which on the engaged layer of a steady cut is thinner than a tenth of the head's radius:
/// `200 u v_f / (kappa omega R^3)`. Below it cutting forces come out low.
/// @param material       u and kappa are used; kappa must be > 0
/// @param spindle_speed  [rad/s] not 0
/// @param feed_speed     [m/s] > 0
/// @return [N/m^4]
/// @throws Error when one of them is out of range
[[nodiscard]] double stiffness_for_accuracy(const ToolHead& head, const Material& material, double spindle_speed,
                                            double feed_speed);

/// The greatest contact stiffness of a head pressed into a flat solid of unit k_v, along its axis or sideways:
/// `max dF/dd`, by the pressure identity (C11) on a plane that moves through the head. For a sphere `(4 pi/27) R^3`
/// (C2).
/// @return [m^3] to be multiplied by k_v; relative error below 1 %
[[nodiscard]] double largest_contact_stiffness(const ToolHead& head);

/// The greatest k_v that a directly driven device can render stably: `K_max / largest_contact_stiffness(head)`.
/// @param device_stiffness  [N/m] K_max > 0, the stiffest wall the device renders
/// @return [N/m^4] for a material of relative stiffness 1
/// @throws Error when the device stiffness is not positive
[[nodiscard]] double stiffness_for_device(const ToolHead& head, double device_stiffness);

}  // namespace hapticut
