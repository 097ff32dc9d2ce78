// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hapticut/tool/shapes.hpp"

/// @file
/// The table of a ProfileHead: for each cell, the curve of the meridian that gives the smallest depth.
///
/// The depth below a meridian of lines and arcs is not smooth (the direction jumps on the medial axis), so values on a
/// grid would blur it. The table therefore has no depths. For each square cell of the (rho, z) half-plane it stores
/// the one or two curves that decide there, and how they decide. Depth and direction then follow in closed form,
/// exactly, from the numbers of a curve. Where three or more curves compete (a few points of the medial axis, hollow
/// corners) the cell keeps the best two. Only these cells have an error, see ProfileTable::error.
namespace hapticut {

/// How the two curves of a cell decide.
enum class CellRule : std::uint32_t {
  first,    ///< only the first curve
  nearer,   ///< the one with the smaller depth: a ridge of the medial axis
  farther,  ///< the one with the larger depth: a hollow corner
  sides     ///< the second beyond its starting point, the first before it: a joint along the meridian
};

/// One cell packed in 32 bits: the first curve in bits 0-13, the second in bits 14-27, the rule in bits 28-30.
struct ProfileCell {
  static constexpr std::uint32_t kMaxCurves = 1U << 14U;

  [[nodiscard]] static constexpr std::uint32_t pack(std::uint32_t first, std::uint32_t second, CellRule rule) {
    return first | second << 14U | std::uint32_t(rule) << 28U;
  }
  [[nodiscard]] static constexpr std::uint32_t first(std::uint32_t cell) { return cell & (kMaxCurves - 1); }
  [[nodiscard]] static constexpr std::uint32_t second(std::uint32_t cell) { return cell >> 14U & (kMaxCurves - 1); }
  [[nodiscard]] static constexpr CellRule rule(std::uint32_t cell) { return CellRule(cell >> 28U & 7U); }

  /// For ProfileTable::cells_near: bit 31 says that the head does not reach into the cell; the other bits are copied
  /// from a nearby cell that the head reaches into.
  static constexpr std::uint32_t kOutside = 1U << 31U;
  [[nodiscard]] static constexpr bool is_outside(std::uint32_t cell) { return (cell & kOutside) != 0; }
  [[nodiscard]] static constexpr std::uint32_t of_head(std::uint32_t cell) { return cell & ~kOutside; }
};

/// Curves as a structure of arrays, each padded with zeros to a multiple of sixteen. A curve is a circle of signed
/// curvature k through a point p with the unit normal m that points into the head; k > 0 bulges outwards, k = 0 is a
/// straight line, k < 0 is hollow, and a hollow corner is a circle of a millionth of the head's size. With q = x - p,
///
///     g = k q - m      depth w = s (2 m.q - k q.q) / (1 + |g|)      n = g / |g|
///
/// (formulas/curves.inl). This equals s (R - |x - c|) for a circle, without its cancellation, and s m.q for a line. s
/// is kSmoothScale inside a smooth curve and 1 otherwise (`depth_below`). Curve 0 is all zeros: no depth anywhere.
template <class Real>
struct ProfileCurves {
  std::vector<Real> rho, z;                ///< [m] starting point p, in the direction from tip to shank
  std::vector<Real> normal_rho, normal_z;  ///< [1] m
  std::vector<Real> curvature;             ///< [1/m] k
  std::vector<Real> scale;                 ///< [1] s
};

/// A corner of the meridian where a cutting edge meets a smooth one.
template <class Real>
struct ProfileCorner {
  Real rho, z;  ///< [m]
};

/// A piece of the meridian, monotone in z and in rho. The pieces tell whether a point is inside and how far it is from
/// the surface.
template <class Real>
struct ProfilePiece {
  Real rho_0, z_0, rho_1, z_1;  ///< [m] ends
  Real center_rho, center_z;    ///< [m] centre of an arc
  Real radius;                  ///< [m] radius of an arc, 0: straight
  Real sense;                   ///< [1] arc: +1 bulges outwards (counter-clockwise), -1 hollow
  Real side;                    ///< [1] arc: +1 to the right of its centre (larger rho), -1 to the left
};

/// All data of a profile that the step uses. Immutable once built; tools share it.
struct ProfileTable {
  ProfileCurves<float> curves;
  std::size_t curve_count = 0;         ///< without the padding
  ProfileCurves<double> exact_curves;  ///< curves in double precision
  std::vector<ProfilePiece<float>> pieces;
  std::vector<ProfilePiece<double>> exact_pieces;
  std::vector<ProfileCorner<float>> corners;
  std::vector<ProfileCorner<double>> exact_corners;

  /// Cell of column i and row j at `j * columns + i`; it covers rho in [i, i + 1) cell_size and
  /// z in bottom + [j, j + 1) cell_size.
  std::vector<std::uint32_t> cells;       ///< 0 where the head does not reach into the cell
  std::vector<std::uint32_t> cells_near;  ///< cells for points slightly outside the head; see ProfileCell::kOutside
  int columns = 0;
  int rows = 0;
  double cell_size = 0;  ///< [m]

  double radius = 0;  ///< [m] largest rho of the head: beyond it there is no spring
  double bottom = 0;  ///< [m] smallest z of the head: below it there is no spring
  double top = 0;     ///< [m] largest z of the head: at and above it there is no spring

  /// [m] Bound on the error of depths: the depth at a point differs by at most this from the exact depth there, or is
  /// the exact depth of a point within this distance. Found from 1089 points of each cell that may have an error, plus
  /// a bound for the points between them.
  double error = 0;

  /// `everywhere` is a cell that is correct for all points within `radius`, `bottom` and `top`, or 0. Most burs cut
  /// with one or two curves and need no table. If `lid` is not 0, it is one more curve, and the depth is the smaller of
  /// the depths of lid and cell. The lid is the smooth end that most heads have.
  std::uint32_t everywhere = 0, lid = 0;

  /// [m^2] Square of the largest rho in each of a few slabs of equal height between `bottom` and `top`. It tells which
  /// points may have a spring. Each slab is grown on all sides by `error`, because the table may have springs that far
  /// outside, and by 1e-5 of the head's size, because the slab of a point is found in single precision.
  static constexpr int kSlabs = 16;
  std::array<float, kSlabs> slab_radius_squared = {};
};

namespace formulas {
#include "hapticut/formulas/curves.inl"
}  // namespace formulas

/// The data of a profile that the hot loop needs. Has pointers into the table of the head; the table must outlive it.
template <class Real>
struct ProfileSprings {
  const Real *rho, *z, *normal_rho, *normal_z, *curvature, *scale;
  const std::uint32_t *cells, *cells_near;
  std::span<const ProfilePiece<Real>> pieces;
  std::span<const ProfileCorner<Real>> corners;
  std::size_t curve_count;
  int columns, rows;
  std::uint32_t everywhere, lid;
  Real cells_per_length;  ///< [1/m]
  Real radius, bottom, top;

  explicit ProfileSprings(const ProfileTable& t)
      : ProfileSprings(t, pick(t.curves, t.exact_curves), pick(t.pieces, t.exact_pieces),
                       pick(t.corners, t.exact_corners)) {}

  [[nodiscard]] MeridianSpring<Real> spring(Real at_rho, Real at_z) const {
    const int column = std::min(int(std::min(at_rho, radius) * cells_per_length), columns - 1);
    const int row = std::clamp(int((std::max(at_z, bottom) - bottom) * cells_per_length), 0, rows - 1);
    const std::size_t index = std::size_t(row) * std::size_t(columns) + std::size_t(column);
    const std::uint32_t cell = everywhere != 0 ? everywhere : cells_near[index];
    return decide(ProfileCell::of_head(cell), at_rho, at_z).bounded(*this, ProfileCell::is_outside(cell), at_rho, at_z);
  }

  /// The curve that decides at a point by the rule of a cell.
  [[nodiscard]] formulas::DecidingCurve<Real> decide(std::uint32_t cell, Real at_rho, Real at_z) const {
    formulas::DecidingCurve<Real> found(curve(ProfileCell::first(cell)), at_rho, at_z);
    const CellRule rule = ProfileCell::rule(cell);
    if (rule != CellRule::first) found.decide(rule, curve(ProfileCell::second(cell)), at_rho, at_z);
    if (lid != 0 && cell == everywhere) found.decide(CellRule::nearer, curve(lid), at_rho, at_z);
    return found;
  }
  [[nodiscard]] formulas::CurveSprings<Real> curve(std::uint32_t n) const {
    return {rho[n], z[n], normal_rho[n], normal_z[n], curvature[n], scale[n]};
  }

  /// [m] Distance to the surface, positive inside. O(edges).
  [[nodiscard]] Real margin(Real at_rho, Real at_z) const {
    Real nearest = std::numeric_limits<Real>::max();
    bool inside = false;
    for (const ProfilePiece<Real>& p : pieces) {
      nearest = std::min(nearest, distance(p, at_rho, at_z));
      if ((p.z_0 <= at_z) != (p.z_1 <= at_z)) inside ^= crossing(p, at_z) > at_rho;
    }
    return inside ? nearest : -nearest;
  }

  /// [m] rho at which a piece crosses a height between its ends.
  [[nodiscard]] static Real crossing(const ProfilePiece<Real>& p, Real at_z) {
    if (p.radius == 0) return p.rho_0 + (at_z - p.z_0) * (p.rho_1 - p.rho_0) / (p.z_1 - p.z_0);
    const Real up = at_z - p.center_z;
    return p.center_rho + p.side * std::sqrt(std::max(Real(0), p.radius * p.radius - up * up));
  }

 private:
  static const auto& pick(const auto& single, const auto& exact) {
    if constexpr (sizeof(Real) == sizeof(float))
      return single;
    else
      return exact;
  }
  ProfileSprings(const ProfileTable& t, const ProfileCurves<Real>& c, const std::vector<ProfilePiece<Real>>& p,
                 const std::vector<ProfileCorner<Real>>& ends)
      : rho(c.rho.data()),
        z(c.z.data()),
        normal_rho(c.normal_rho.data()),
        normal_z(c.normal_z.data()),
        curvature(c.curvature.data()),
        scale(c.scale.data()),
        cells(t.cells.data()),
        cells_near(t.cells_near.data()),
        pieces(p),
        corners(ends),
        curve_count(t.curve_count),
        columns(t.columns),
        rows(t.rows),
        everywhere(t.everywhere),
        lid(t.lid),
        cells_per_length(Real(1 / t.cell_size)),
        radius(Real(t.radius)),
        bottom(Real(t.bottom)),
        top(Real(t.top)) {}

  [[nodiscard]] static Real distance(const ProfilePiece<Real>& p, Real at_rho, Real at_z) {
    const Real to_0 = at_rho - p.rho_0, up_0 = at_z - p.z_0, to_1 = at_rho - p.rho_1, up_1 = at_z - p.z_1;
    if (p.radius == 0) {
      const Real along_rho = p.rho_1 - p.rho_0, along_z = p.z_1 - p.z_0;
      const Real fraction = (to_0 * along_rho + up_0 * along_z) / (along_rho * along_rho + along_z * along_z);
      const Real s = std::clamp(fraction, Real(0), Real(1));
      const Real d_rho = to_0 - s * along_rho, d_z = up_0 - s * along_z;
      return std::sqrt(d_rho * d_rho + d_z * d_z);
    }
    const Real v_rho = at_rho - p.center_rho, v_z = at_z - p.center_z;
    const Real after = (p.rho_0 - p.center_rho) * v_z - (p.z_0 - p.center_z) * v_rho;
    const Real before = v_rho * (p.z_1 - p.center_z) - v_z * (p.rho_1 - p.center_rho);
    if (p.sense * after >= 0 && p.sense * before >= 0) return std::abs(std::sqrt(v_rho * v_rho + v_z * v_z) - p.radius);
    return std::sqrt(std::min(to_0 * to_0 + up_0 * up_0, to_1 * to_1 + up_1 * up_1));
  }
};

}  // namespace hapticut
