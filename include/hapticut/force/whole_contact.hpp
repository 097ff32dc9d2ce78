// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/spatial.hpp"

/// @file
/// The contact as a whole, for force laws that know it only by its volume, its centroid or its depth.
namespace hapticut {

/// Integrals over the filled part of the head, in T. `w` is the depth, `n` the direction from the tool into the
/// material, `v_t` the slip of the head over it (spin and feed), `kappa` the material's cutting ratio.
struct ContactMoments {
  double volume = 0;                    ///< [m^3]  Int dV
  Vec3 first_moment = Vec3::Zero();     ///< [m^4]  Int r dV
  double depth_integral = 0;            ///< [m^4]  Int w dV
  Vec3 normal_integral = Vec3::Zero();  ///< [m^4]  Int w n dV
  Wrench rubbing;                       ///< [m^4], [m^5]  Int w kappa (t, r x t) dV,  t = v_t / sqrt(v_t^2 + v_eps^2)
  double rubbing_speed = 0;             ///< [m^5/s]  Int w kappa t . v_t dV
  double depth = 0;                     ///< [m] maximum w
  double radius = 0;                    ///< [m] maximum distance of material from the spindle's axis

  /// Mean direction into the material; zero without contact, or when opposite sides cancel.
  [[nodiscard]] Vec3 normal() const {
    const double length = normal_integral.norm();
    return length > 1e-9 * depth_integral ? Vec3(normal_integral / length) : Vec3::Zero();
  }
};

/// Result of a law of the whole contact.
struct LumpedForce {
  Wrench wrench_T;            ///< [N], [N·m] on the tool about To, in T
  double cutting_power = 0;   ///< [W] >= 0 available for cutting; the part that does not cut is rubbing
  double elastic_before = 0;  ///< [J] stored in the contact at the beginning of the sub-step
  double elastic = 0;         ///< [J] stored in the contact at the end of the sub-step
  double damped = 0;          ///< [J] dissipated in the sub-step in other ways
};

/// Moments and force, for laws that distribute the cut among the samples.
struct WholeContact {
  ContactMoments moments;
  LumpedForce lumped;
};

}  // namespace hapticut
