// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "hapticut/tool/profile.hpp"

/// @file
/// The exact geometry of a profile: its edges, and the curves, the nearest of which gives the depth.
namespace hapticut::detail {

using Vec2 = Eigen::Vector2d;  ///< (rho, z)

/// Positive when `b` points to the left of `a`.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
[[nodiscard]] inline Vec2 left_of(const Vec2& a) { return {-a.y(), a.x()}; }

/// An edge with the quantities derived from its two ends and its radius.
struct MeridianEdge {
  Vec2 from, to;                      ///< [m]
  double curvature = 0;               ///< [1/m] > 0 bulges outwards
  Vec2 center = Vec2::Zero();         ///< [m] centre of an arc
  double start_angle = 0, sweep = 0;  ///< [rad] angles of an arc about its centre; sweep > 0 counter-clockwise
  Vec2 start_tangent, end_tangent;    ///< [1]
  EdgeKind kind = EdgeKind::cutting;

  [[nodiscard]] double radius() const { return 1 / std::abs(curvature); }
  [[nodiscard]] bool straight() const { return curvature == 0; }
  /// [rad] Angle of a point about the centre, from the start in the direction of the sweep, in [0, 2 pi).
  [[nodiscard]] double angle_of(const Vec2& p) const;
  [[nodiscard]] Vec2 at_angle(double angle) const;
};

/// A curve that may give the depth, and the region in which it is in charge: the strip of a line, the sector of an arc,
/// or the wedge of a hollow corner or of the end of a cutting edge at a smooth one.
struct MeridianCurve {
  enum class Kind { line, arc, corner };
  Kind kind = Kind::line;
  MeridianEdge edge;          ///< for a corner: the edge before it
  Vec2 point = Vec2::Zero();  ///< [m] start; of a corner: the corner
  Vec2 next = Vec2::Zero();   ///< [1] for a corner: tangent of the edge after it
  double low = 0, high = 0;   ///< [m] or [rad] part of the edge's line or circle that is in charge
  /// Whether the curve is in charge at some point within a distance of x.  @param reach  [m] the distance
  [[nodiscard]] bool in_charge(const Vec2& x, double reach = 0) const;
  /// Distance and direction, independent of the kind of the edge; MeridianSpring::smooth is not set.
  [[nodiscard]] MeridianSpring<double> spring(const Vec2& x) const;
  [[nodiscard]] bool smooth() const { return edge.kind == EdgeKind::smooth; }
  [[nodiscard]] double scale() const { return smooth() ? kSmoothScale : 1; }
  [[nodiscard]] double depth(const Vec2& x) const {
    return formulas::depth_below(spring(x).depth, scale());
  }  ///< [m] w
};

class Meridian {
 public:
  /// @throws Error as ProfileHead's constructor
  explicit Meridian(const Profile& profile);

  [[nodiscard]] const std::vector<MeridianEdge>& edges() const { return edges_; }
  /// In their order along the meridian.
  [[nodiscard]] const std::vector<MeridianCurve>& curves() const { return curves_; }

  [[nodiscard]] double radius() const { return radius_; }  ///< [m] largest rho
  [[nodiscard]] double bottom() const { return bottom_; }  ///< [m] smallest z
  [[nodiscard]] double top() const { return top_; }        ///< [m] largest z
  [[nodiscard]] double size() const { return size_; }      ///< [m] larger of radius and height
  [[nodiscard]] double volume() const;                     ///< [m^3]
  [[nodiscard]] double reach() const;                      ///< [m]
  [[nodiscard]] double cutting_radius() const;             ///< [m] largest rho of the cutting edges
  [[nodiscard]] std::vector<ProfilePiece<double>> pieces() const;

  static constexpr std::size_t kNone = ~std::size_t(0);
  /// The corners where a cutting edge meets a smooth one.
  [[nodiscard]] std::vector<ProfileCorner<double>> corners() const;

  /// The curve with the smallest depth; kNone if no curve is in charge.
  [[nodiscard]] std::size_t nearest(const Vec2& x) const;

 private:
  void make_edges(const Profile& profile);
  void make_curves();
  void add_corner(const MeridianEdge& before, const Vec2& point, const Vec2& next);
  void add_edge(const MeridianEdge& edge, bool begins_before, bool goes_on);
  [[nodiscard]] bool bounds_all(const MeridianEdge& edge) const;
  void check_orientation() const;
  void check_crossings() const;

  std::vector<MeridianEdge> edges_;
  std::vector<MeridianCurve> curves_;
  double radius_ = 0, bottom_ = 0, top_ = 0, size_ = 0;
};

/// Points where two edges meet within a tolerance [m].
[[nodiscard]] std::vector<Vec2> crossings(const MeridianEdge& a, const MeridianEdge& b, double tolerance);

/// Makes the table of a meridian.  @throws Error if the tolerance needs more cells than are allowed
[[nodiscard]] ProfileTable make_profile_table(const Meridian& meridian, double tolerance);

}  // namespace hapticut::detail
