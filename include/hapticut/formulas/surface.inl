// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/force/laws/foundation.hpp and of the kernels: the material and the motion where the head's surface
// meets a voxel.

/// Hunt and Crossley's damping of the motion w_dot into the material: smooth and never negative.
template <class Real>
struct Damping {
  Real factor;  ///< [1] g_d
  Real slope;   ///< [1] its change with chi w_dot

  /// Of the motion that the device measures.
  /// @param r  [m] the voxel's centre, from To
  /// @param n  [1] the normal there
  HAPTICUT_FORMULA static Damping of(const HeadMotion& m, Real chi, const Triple<Real>& r, const Triple<Real>& n) {
    return of(chi * dot(n, velocity_at(r, m.felt_velocity, m.felt_angular_velocity)));
  }
  /// @param x  [1] chi w_dot
  HAPTICUT_FORMULA static Damping of(Real x) { return of_factor((1 + max(x, Real(0))) / (1 - min(x, Real(0)))); }
  HAPTICUT_FORMULA static Damping of_factor(Real factor) {
    const Real opening = min(factor, Real(1));
    return {factor, opening * opening};
  }
  /// [m] Depth at which a column's pressure k_v g_d w^2/2 is the strength; deeper material is crushed.
  /// @param at_rest  [m] ContactMaterial::crushing_depth
  [[nodiscard]] HAPTICUT_FORMULA Real crushing_depth(Real at_rest) const {
    return at_rest * inverse_root(max(factor, Real(1)));
  }
};

/// The constants of a material at the head's surface. Lengths are in voxel edges.
template <class Real>
struct SurfaceMaterial {
  Real stiffness;       ///< [N/m^3] k_v l: pressure gradient at a depth of one edge
  Real damping;         ///< [s/m] chi
  Real cutting_ratio;   ///< [1] kappa
  Real energy;          ///< [J/m^3] u
  Real per_energy;      ///< [m^3/J] 1/u
  Real threshold;       ///< [1] w0/l
  Real edge_length;     ///< [1] h_e/l
  Real size_length;     ///< [1] h_s/l
  Real viscosity;       ///< [Pa s/m] eta
  Real crushing_depth;  ///< [1] w_c/l

  static constexpr float kNeverCut = 1e6F;  ///< [1] w0/l of a surface that does not cut

  /// [J/m^3] k_v l^2: twice what springs store at a depth of one edge
  [[nodiscard]] HAPTICUT_FORMULA Real stored(float voxel_size) const { return stiffness * Real(voxel_size); }

  HAPTICUT_FORMULA static SurfaceMaterial of(const ContactMaterial& m, float voxel_size) {
    const float per_edge = 1 / voxel_size;
    return {Real(m.stiffness * voxel_size),
            Real(m.damping),
            Real(m.cutting_ratio),
            Real(m.cutting_energy),
            Real(1 / m.cutting_energy),
            Real(m.cutting_depth * per_edge),
            Real(m.edge_length * per_edge),
            Real(m.size_length * per_edge),
            Real(m.viscosity),
            Real(m.crushing_depth * per_edge)};
  }

  /// @param u  [J/m^3]
  [[nodiscard]] HAPTICUT_FORMULA SurfaceMaterial with_energy(Real u) const {
    SurfaceMaterial other = *this;
    other.energy = u, other.per_energy = reciprocal(u);
    return other;
  }

  /// The constants at a surface that may be smooth, for depths that are distances.
  /// @param smooth          [m^2] MeridianSpring::smooth
  /// @param square_of_land  [m^2] ContactMaterial::square_of_land
  [[nodiscard]] HAPTICUT_FORMULA SurfaceMaterial at(Real smooth, Real sliding_ratio, Real square_of_land) const {
    const auto is_smooth = smooth > 0;
    if (!any(is_smooth)) return *this;
    const auto slides = is_smooth && smooth > square_of_land;
    const Real scale = select(is_smooth, Real(kSmoothScale), Real(1)),
               inverse = select(is_smooth, Real(1 / kSmoothScale), Real(1));
    SurfaceMaterial there = *this;
    there.stiffness = stiffness * (scale * scale);
    there.damping = damping * scale;
    there.cutting_ratio = select(slides, sliding_ratio, cutting_ratio);
    there.threshold = select(slides, Real(kNeverCut), threshold * inverse);
    there.crushing_depth = crushing_depth * inverse;
    return there;
  }
};

/// The slip with which voxels near the axis are cut. The slip omega rho varies over such a voxel, and its centre does
/// not represent the whole. Thrust is proportional to 1/slip, so the harmonic mean over the section, 1/mean(1/rho),
/// counts. Its square is that of the centre plus an excess E(q), q = rho^2 in voxel edges squared: kOnAxis^2 on the
/// axis, negative from 0.46 edges on, -1/12 far away. The fit to the mean over the directions of a unit square gives
/// 1/rho within 1.2 %.
template <class Real>
struct AxisSlip {
  static constexpr float kZone = 2;          ///< [voxel edges] about the spindle's axis
  static constexpr float kOnAxis = 0.2837F;  ///< 1/mean(1/rho) over a unit square about the axis = 1/(4 asinh 1)
  static constexpr float kFar = -1.0F / 12, kPeak = kOnAxis * kOnAxis - kFar;
  static constexpr float kZero = 4.75F, kFlat = 1.3F, kSteep = 46.0F;

  float per_edge;     ///< [1/m^2] 1/l^2
  float per_slip;     ///< [m^2/s^2] (l omega)^2
  float min_squared;  ///< [m^2/s^2] square of the slip of a voxel centred on the axis: the minimum

  HAPTICUT_FORMULA explicit AxisSlip(const HeadMotion& m)
      : per_edge(1 / (m.voxel_size * m.voxel_size)),
        per_slip(m.voxel_size * m.voxel_size * m.turning() * m.turning()),
        min_squared(kOnAxis * kOnAxis * per_slip) {}

  /// [m^2/s^2] Square of the slip with which a voxel is cut, less that of its centre at r.
  [[nodiscard]] HAPTICUT_FORMULA Real beyond(Real of_center, const Triple<Real>& r) const {
    const Real q = (r.x * r.x + r.y * r.y) * Real(per_edge);
    const auto near = q < Real(kZone * kZone);
    if (!any(near)) return Real(0);
    const Real peak = Real(kPeak) * (1 - Real(kZero) * q), below = 1 + q * q * (Real(kFlat) + Real(kSteep) * q);
    const Real excess = Real(per_slip) * (peak / below + Real(kFar));
    return select(near, max(excess, Real(min_squared) - of_center), Real(0));
  }
};

/// How the head's surface moves at a voxel.
template <class Real>
struct SurfaceMotion {
  static constexpr float kRegular = 1e-3F;  ///< [m/s] v_eps

  Triple<Real> velocity;  ///< [m/s] v of the turning surface
  Real rate;              ///< [m/s] w_dot: of the handpiece along n, which changes the depth
  Real inverse_slip;      ///< [s/m] 1/sqrt(s^2 + v_eps^2)
  Real slip;              ///< [m/s] s^2/sqrt(s^2 + v_eps^2)
  Real beyond;            ///< [m^2/s^2] square of the slip less that of the voxel's centre (AxisSlip)

  /// [m/s] w_dot, for a place r and its normal n
  HAPTICUT_FORMULA static Real rate_of(const HeadMotion& m, const Triple<Real>& r, const Triple<Real>& n) {
    return dot(n, velocity_at(r, m.velocity, m.angular_velocity));
  }
  /// @param r  [m] the voxel's centre, from To
  /// @param n  [1] the normal there
  HAPTICUT_FORMULA static SurfaceMotion of(const HeadMotion& m, const AxisSlip<Real>& axis, const Triple<Real>& r,
                                           const Triple<Real>& n) {
    SurfaceMotion s;
    s.velocity = velocity_at(r, m.velocity, m.angular_velocity);
    s.rate = rate_of(m, r, n);
    s.velocity.x = s.velocity.x - Real(m.spin) * r.y;
    s.velocity.y = s.velocity.y + Real(m.spin) * r.x;  // across n on a body of revolution
    const Real of_center = max(Real(0), dot(s.velocity, s.velocity) - s.rate * s.rate);
    s.beyond = axis.beyond(of_center, r);
    const Real squared = of_center + s.beyond;
    s.inverse_slip = inverse_root(squared + Real(kRegular * kRegular));
    s.slip = squared * s.inverse_slip;
    return s;
  }

  /// [J/m^3] Half of the work of the slip per depth: kappa k_v g_d s/2 times the time, for `stiffness` = k_v l.
  [[nodiscard]] HAPTICUT_FORMULA Real work(Real kappa, Real stiffness, Real damping, float time) const {
    return Real(0.5F) * kappa * stiffness * damping * slip * Real(time);
  }
};

/// What a cut takes that depends on the motion. The edge pressure is a pressure, so the damping makes its depth
/// smaller. A viscous material takes the pressure eta v more at a speed v, which is the energy kappa s eta of the slip
/// s. The chips of a drill fill its flutes when they are too thick: a head that moves into a surface faster than
/// HeadMotion::fastest_chips pays the eighth power of the ratio. It is the speed of the head and not that of the
/// recession at some depth, so that a layer is as dear at its top as at its bottom.
template <class Real>
struct CutResistance {
  static constexpr float kMostCrowded = 16, kLeastDamping = 1e-6F;  ///< [1] keep the arithmetic finite

  /// @param damping  [1] g_d
  /// @return `material` with the energy and the threshold of its cut
  HAPTICUT_FORMULA static SurfaceMaterial<Real> of(const HeadMotion& m, const SurfaceMotion<Real>& surface,
                                                   Real damping, const SurfaceMaterial<Real>& material) {
    Real energy = material.energy + material.cutting_ratio * surface.slip * material.viscosity;
    if (m.fastest_chips > 0) {
      const Real ratio = min(Real(kMostCrowded), max(Real(1), surface.rate * Real(1 / m.fastest_chips)));
      const Real second = ratio * ratio, fourth = second * second;
      energy = energy * (fourth * fourth);
    }
    SurfaceMaterial<Real> there = material.with_energy(energy);
    there.threshold = material.threshold * inverse_root(max(damping, Real(kLeastDamping)));
    return there;
  }
};

/// The reaction of a voxel, which is minus the force on the tool: F_v = -f n - kappa f v_t/sqrt(s^2 + v_eps^2).
template <class Real>
struct VoxelReaction {
  Triple<Real> force;  ///< [N/m^3]
  Real drag;           ///< [N s/m^4] its tangential part per slip

  /// @param push   [N/m^3] f, along the normal n
  /// @param kappa  [1] 0: the spindle stands
  HAPTICUT_FORMULA static VoxelReaction of(const SurfaceMotion<Real>& surface, const Triple<Real>& n, Real push,
                                           Real kappa) {
    const Triple<Real>& v = surface.velocity;
    const Real drag = kappa * push * surface.inverse_slip, along = push - drag * surface.rate;
    return {{along * n.x + drag * v.x, along * n.y + drag * v.y, along * n.z + drag * v.z}, drag};
  }
  /// Under a spindle that stands.
  HAPTICUT_FORMULA static VoxelReaction of(const Triple<Real>& n, Real push) {
    return {{push * n.x, push * n.y, push * n.z}, Real(0)};
  }
  /// [W/m^3] Power of the drag with what the slip exceeds that of the voxel's centre by; a couple about the axis takes
  /// it.
  [[nodiscard]] HAPTICUT_FORMULA Real couple(const SurfaceMotion<Real>& surface) const { return drag * surface.beyond; }
};

/// How far the head moves into a voxel, in voxel edges.
template <class Real>
struct HeadAdvance {
  Real moved;     ///< [1] advance in the sub-step
  Real approach;  ///< [1] advance in the time, not negative

  /// @param rate  [m/s] w_dot
  HAPTICUT_FORMULA static HeadAdvance of(const HeadMotion& m, Real rate) {
    const Real moved = rate * Real(m.duration / m.voxel_size);
    return {moved, max(Real(0), moved * Real(m.level_of_detail))};
  }
  /// [m/s] w_dot without its ripple.
  [[nodiscard]] HAPTICUT_FORMULA Real mean_rate(const HeadMotion& m, const Triple<Real>& n) const {
    const Triple<Real> ripple = {Real(m.ripple.x()), Real(m.ripple.y()), Real(m.ripple.z())};
    return moved * Real(m.voxel_size / m.duration) - dot(n, ripple);
  }
};

/// The lips that take a chip. Within half a degree of the feed a lip passes along the surface, and fewer count: h_e and
/// h_s are scaled with the speed towards the surface or away from it.
template <class Real>
struct ChippingLips {
  static constexpr float kGrazing = 0.01F;  ///< [1] part of the feed towards a surface from which on all lips count
  static constexpr float kMinFeed = 1e-6F;  ///< [m/s] feed of a head that only presses

  float passing;   ///< [1] lips that pass in the time
  float per_edge;  ///< [s/m] the time over the voxel's edge
  float per_feed;  ///< [s/m] inverse of the feed without its ripple

  HAPTICUT_FORMULA explicit ChippingLips(const HeadMotion& m)
      : passing(m.tooth_rate * m.duration * m.level_of_detail),
        per_edge(m.duration * m.level_of_detail / m.voxel_size),
        per_feed(1 / std::max((m.velocity - m.ripple).norm(), kMinFeed)) {}

  /// [1]
  /// @param mean_rate  [m/s] w_dot without its ripple
  [[nodiscard]] HAPTICUT_FORMULA Real at(Real mean_rate) const {
    return Real(passing) * min(Real(1), abs(mean_rate) * Real(per_feed / kGrazing) + Real(kMinFeed * per_feed));
  }
  /// [1] What the head advances in the time at this rate, in voxel edges.
  [[nodiscard]] HAPTICUT_FORMULA Real advance(Real mean_rate) const { return mean_rate * Real(per_edge); }
};
