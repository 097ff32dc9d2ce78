// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/contact/cut_voxel.hpp and of the kernels: a voxel that the head's surface crosses.

/// The depth from which on material is cut.
template <class Real>
struct CutDepth {
  Real threshold;  ///< w0
  Real excess;  ///< top^2 - w0^2, top: the largest depth of the part; <= 0: nothing is cut. Precise where it is small

  HAPTICUT_FORMULA static CutDepth of(Real top, Real threshold) {
    return {threshold, (top - threshold) * (top + threshold)};
  }
  /// top - w0, not below 0
  [[nodiscard]] HAPTICUT_FORMULA Real beyond(Real top) const {
    return select(excess > 0, excess * reciprocal(top + threshold), Real(0));
  }
};

/// A voxel seen along n.
template <class Real>
struct VoxelSection {
  Real p, q;      ///< [1] widths of the two boxes whose convolution is the section
  Real per_area;  ///< [1] 1/(p q)

  /// [1] While material is cut, a narrower box is widened to this; no sum over voxels changes. Cutting of the next
  /// voxel begins before the last part of the voxel above it is removed, so the force dips at the change of layers. A
  /// longer overlap makes the dip smaller: along the grid 2.1 % at 0.05 and 0.5 % at 0.3.
  static constexpr float kMinWidth = 0.3F;
  /// [1] The same for a head whose spindle is off, under which layers change only by crushing. The relative error of a
  /// static force on a face of the grid is (width l/depth)^2/12: with 0.3 a flat head pressed with 0.5 N would feel up
  /// to five times that.
  static constexpr float kMinStandingWidth = 0.01F;

  /// @param max_component  [1] the largest |n_i| along the grid's axes, 1/sqrt(3) ... 1
  /// @param min_width      [1] kMinWidth or kMinStandingWidth
  HAPTICUT_FORMULA explicit VoxelSection(Real max_component, Real min_width = Real(kMinWidth))
      : p(max_component),
        q(max(sqrt(max(Real(0), 1 - max_component * max_component)), min_width)),
        per_area(reciprocal(p * q)) {}
  HAPTICUT_FORMULA VoxelSection(Real wide, Real narrow, Real inverse) : p(wide), q(narrow), per_area(inverse) {}

  /// [1] h: length from the far corner to the near corner
  [[nodiscard]] HAPTICUT_FORMULA Real span() const { return p + q; }

  /// [1] Distance of the plane from the far corner when the fraction `fill` of the voxel is filled.
  [[nodiscard]] HAPTICUT_FORMULA Real height_of(Real fill) const {
    if (all(fill >= 1)) return span();
    const Real wide = max(p, q), narrow = min(p, q);
    const Real ramp = wide * min(fill, 1 - fill), twice = ramp + ramp;
    const Real height = select(twice <= narrow, sqrt(max(Real(0), twice * narrow)), ramp + Real(0.5) * narrow);
    return select(fill <= Real(0.5), height, span() - height);
  }

  /// [1] Area of the section at a height.
  [[nodiscard]] HAPTICUT_FORMULA Real area_at(Real height) const {
    const Real area = max(Real(0), height) - max(Real(0), height - p) - max(Real(0), height - q);
    return max(Real(0), area) * per_area;
  }
  /// [1] Filled fraction below a height <= span(): the inverse of `height_of`.
  [[nodiscard]] HAPTICUT_FORMULA Real fill_below(Real height) const {
    const Real whole = max(Real(0), height), x_p = max(Real(0), height - p), x_q = max(Real(0), height - q);
    return (whole * whole - x_p * x_p - x_q * x_q) * per_area * Real(0.5);
  }

  // Integrals over the filled part below a height whose top has a depth > 0, for an edge length l = 1, relative to the
  // volume of the voxel. A(v) (p q) = v - max(v - p, 0) - max(v - q, 0) below the near corner. Written so that nothing
  // cancels where the layer in contact is thin.

  /// [1] Integral of max(w, 0)
  [[nodiscard]] HAPTICUT_FORMULA Real depth(Real height, Real depth) const {
    return depth_of_ramps(height, depth) * (per_area * Real(1.0 / 6));
  }
  /// [1] Integral of 1 where w > 0
  [[nodiscard]] HAPTICUT_FORMULA Real volume(Real height, Real depth) const {
    return volume_of_ramps(height, depth) * (per_area * Real(0.5));
  }
  /// [1] Integral of w where w > w0
  /// @param beyond  CutDepth::beyond
  [[nodiscard]] HAPTICUT_FORMULA Real cutting(Real height, Real threshold, Real beyond) const {
    const Real depth = Real(1.0 / 6) * depth_of_ramps(height, beyond);
    if (all(threshold == 0)) return depth * per_area;
    return (depth + Real(0.5) * threshold * volume_of_ramps(height, beyond)) * per_area;
  }
  /// [1] Integral of max(w, 0)^2/2; zero where the depth is not positive
  [[nodiscard]] HAPTICUT_FORMULA Real energy(Real height, Real depth) const {
    const Real d = max(Real(0), depth);
    const Real squares = square_of_ramp(height, d) - square_of_ramp(max(Real(0), height - p), d) -
                         square_of_ramp(max(Real(0), height - q), d);
    return squares * (per_area * Real(1.0 / 24));
  }

 private:
  [[nodiscard]] HAPTICUT_FORMULA Real volume_of_ramps(Real height, Real d) const {
    return volume_of_ramp(height, d) - volume_of_ramp(max(Real(0), height - p), d) -
           volume_of_ramp(max(Real(0), height - q), d);
  }
  [[nodiscard]] HAPTICUT_FORMULA Real depth_of_ramps(Real height, Real d) const {
    return depth_of_ramp(height, d) - depth_of_ramp(max(Real(0), height - p), d) -
           depth_of_ramp(max(Real(0), height - q), d);
  }

  /// 2 x the integral of 1 over the last part, of length d, of the ramp u = 0 ... x.
  HAPTICUT_FORMULA static Real volume_of_ramp(Real x, Real d) {
    const Real m = min(x, d);
    return m * (x + x - m);
  }
  /// 6 x the integral of the depth u - (x - d) over that part.
  HAPTICUT_FORMULA static Real depth_of_ramp(Real x, Real d) {
    const Real m = min(x, d);
    return m * m * (3 * max(x, d) - m);
  }
  /// 24 x the integral of half the square of that depth: d^3 (4 x - d) for d < x, else x^2 (x^2 - 4 x d + 6 d^2).
  HAPTICUT_FORMULA static Real square_of_ramp(Real x, Real d) {
    const Real m = min(x, d), rest = d - m;
    return m * m * (m * (4 * x - m) + rest * (6 * rest + 8 * m));
  }
};

/// The filled part of a voxel, beyond a plane across n. Lengths are in voxel edges.
template <class Real>
struct FilledPart {
  VoxelSection<Real> section;
  Real far;     ///< [1] depth of the far corner
  Real top;     ///< [1] depth of the plane that ends the part
  Real height;  ///< [1] from the far corner to that plane
  Real fill;    ///< [1] phi

  /// @param center  [1] depth of the voxel's centre
  HAPTICUT_FORMULA static FilledPart of(const VoxelSection<Real>& section, Real center, Real fill) {
    const Real far = center - Real(0.5) * section.span(), height = section.height_of(fill);
    return {section, far, far + height, height, fill};
  }
};
