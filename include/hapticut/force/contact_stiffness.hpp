// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/spatial.hpp"

/// How the force of the contact responds to a small motion of the tool. An implicit coupling, or your own implicit
/// integrator, needs this beside the force.
namespace hapticut {

/// Minus the derivative of (force, torque) on the tool with respect to (translation, rotation) of the tool, about one
/// point and in one frame. [N/m], [N] and [N·m/rad]; symmetric.
using Stiffness = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// Transforms a stiffness to another point and another frame.
/// @param stiffness_T  about To, in T
/// @param R_WT         from T to W
/// @param p_HoTo_W     [m] from the new point Ho to the old one To, in W
[[nodiscard]] inline Stiffness transport(const Stiffness& stiffness_T, const Mat3& R_WT, const Vec3& p_HoTo_W) {
  Mat3 arm;  // v_To = v_Ho - [p]x Omega
  arm << 0, -p_HoTo_W.z(), p_HoTo_W.y(), p_HoTo_W.z(), 0, -p_HoTo_W.x(), -p_HoTo_W.y(), p_HoTo_W.x(), 0;
  Stiffness to_T = Stiffness::Zero();  // twist at Ho in W -> twist at To in T
  to_T.topLeftCorner<3, 3>() = to_T.bottomRightCorner<3, 3>() = R_WT.transpose();
  to_T.topRightCorner<3, 3>() = -R_WT.transpose() * arm;
  return to_T.transpose() * stiffness_T * to_T;
}

}  // namespace hapticut
