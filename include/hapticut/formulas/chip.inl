// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/force/chip.hpp and of the kernels: cutting energy that depends on the chip.

/// The energy and the threshold depth of the cut of a voxel, in place of u and w0. In any units of length and time;
/// `material` has the lengths `threshold` (w0), `edge_length` and `size_length`, the density `energy` (u) and its
/// inverse.
template <class Real>
struct ChipChord {
  Real energy;         ///< [J/m^3] u/sigma_c
  CutDepth<Real> cut;  ///< [m] depth from which the pressure exceeds the threshold, p_e included

  static constexpr float kMinRoots = 1e-9F;  ///< [sqrt(m/s)] minimum of y_1 + y_2

  /// @param tooth_rate  [1/s] f_z of the lips that take a chip (ChippingLips)
  /// @param work        [J/(m^4 s)] kappa k_v g_d s/2 >= 0
  /// @param top,bottom  [m] depths of the part of a voxel; bottom <= 0: it contains the bottom of the layer
  /// @param speed       [m/s] of the head into the surface, without its ripple
  template <class Material>
  HAPTICUT_FORMULA static ChipChord of(const Material& material, Real tooth_rate, Real work, Real top, Real bottom,
                                       Real speed) {
    const Roots root_of_speed(material, tooth_rate, work);
    const Real at_top = root_of_speed.at(top);
    // [1] 1 when half of the voxel or more is below the layer
    const Real outside = min(Real(1), -2 * bottom / (top - bottom));
    Real other = outside * sqrt(max(Real(0), speed));
    if (const auto below = bottom > 0; any(below)) other = select(below, root_of_speed.at(bottom), other);
    const Real dearer = 1 + root_of_speed.b / max(at_top + other, Real(kMinRoots));  // 1/sigma_c
    const Real rate = root_of_speed.rate;
    const Real excess = select(rate > 0, at_top * at_top * dearer / rate, Real(0));
    return {material.energy * dearer, {sqrt(max(Real(0), top * top - excess)), excess}};
  }

  /// [m/s] Speed v(q) at which a column recedes whose top is at a depth; without chips where `tooth_rate` is 0.
  template <class Material>
  HAPTICUT_FORMULA static Real recession_at(Real depth, const Material& material, Real tooth_rate, Real work) {
    const Real root = Roots(material, tooth_rate, work).at(depth);
    return root * root;
  }

 private:
  /// sqrt(v(q)) at depths of the layer.
  struct Roots {
    Real rate;  // [1/(m s)] k_d without chips
    Real edge, square, b, w0_squared;
    template <class Material>
    HAPTICUT_FORMULA Roots(const Material& material, Real tooth_rate, Real work)
        : rate(work * material.per_energy),
          edge(material.edge_length * tooth_rate),
          square(material.size_length * tooth_rate),
          b(sqrt(square)),
          w0_squared(material.threshold * material.threshold) {}
    [[nodiscard]] HAPTICUT_FORMULA Real at(Real depth) const {
      const Real q = max(Real(0), rate * (depth * depth - w0_squared) - edge);
      return 2 * q / max(b + sqrt(square + 4 * q), Real(kMinRoots));
    }
  };
};
