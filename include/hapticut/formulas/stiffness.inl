// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/force/laws/foundation.hpp and of the kernels: how the force of a voxel changes with a small motion.

/// The stiffness of a voxel is a sum of dyads: a motion along `motion` is answered by a force against `force`, about To
/// `strength (force, r x force) (motion, r x motion)^T`. The rotation of the normals is neglected (Gauss-Newton
/// approximation), so without spin the stiffness is symmetric and positive semidefinite.
template <class Real>
struct StiffnessDyad {
  Real strength;
  Triple<Real> force, motion;
};

/// A voxel under the default law, relative to its volume.
template <class Real>
struct PartStiffness {
  StiffnessDyad<Real> spring;  ///< [N/m^4] along the normal; its force has the drag of the spin, kappa times the slip's
                               ///< direction
  StiffnessDyad<Real> turned;  ///< [N s^2/m^6] the drag is along the slip: a motion across the slip rotates it, which
                               ///< is a damper over the sub-step
  StiffnessDyad<Real> slowed;  ///< [N s^2/m^6] where the slip is slower than its regularisation, the drag grows with it

  static constexpr float kMinSlip = 1e-6F;  ///< [m/s] below which the drag has no direction
  static constexpr float kSlowSlip = 10 * SurfaceMotion<Real>::kRegular;  ///< [m/s] above which the drag is complete

  /// [N/m^4] Change of the normal force with depth. The springs yield while they are cut, and not at the crushing
  /// limit, which moves up with the closing speed.
  /// @param spring    [1] see PartEnergies
  /// @param yielding  [1] PartCrushing::yielding
  /// @param top       [1] of the part
  HAPTICUT_FORMULA static Real slope_of(const HeadMotion& m, const SurfaceMaterial<Real>& material,
                                        const Damping<Real>& damping, const PartSprings<Real>& springs, Real spring,
                                        Real yielding, Real top) {
    const Real yields = spring / max(springs.depth, Real(1e-20F));
    const Real limit = select(damping.factor > 1, Real(0.5) * top * yielding, Real(0));
    const Real damper =
        damping.slope * material.damping * (springs.depth - limit) * Real(m.voxel_size / m.time_to_move());
    return material.stiffness * Real(1 / m.voxel_size) * yields *
           ((springs.volume - yielding) * damping.factor + damper);
  }

  /// @param n      [1] the normal
  /// @param slope  [N/m^4]
  /// @param push   [N/m^3] force along the normal
  /// @param kappa  [1] 0: the spindle stands
  HAPTICUT_FORMULA static PartStiffness of(const HeadMotion& m, const SurfaceMotion<Real>& surface,
                                           const Triple<Real>& n, Real slope, Real push, Real kappa) {
    const Triple<Real>& v = surface.velocity;
    const auto unit = VoxelReaction<Real>::of(surface, n, Real(1), kappa);
    const Triple<Real> across = cross(n, v);
    const Real square = dot(across, across), min_square = Real(kMinSlip * kMinSlip), into = dot(n, v);
    const Real damper =
        select(square > min_square, unit.drag * push / (max(square, min_square) * Real(m.time_to_move())), Real(0));
    const Real regular = Real(SurfaceMotion<Real>::kRegular * SurfaceMotion<Real>::kRegular);
    const Real slow = select(square <= Real(kSlowSlip * kSlowSlip), damper * regular / (square + regular), Real(0));
    const Triple<Real> slip = {v.x - into * n.x, v.y - into * n.y, v.z - into * n.z};
    return {{slope, unit.force, n}, {damper, across, across}, {slow, slip, slip}};
  }
};
