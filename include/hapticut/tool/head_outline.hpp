// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "hapticut/tool/head.hpp"

namespace hapticut {

/// The surface of a head, for distances from outside. `ToolHead::spring_at` gives depths inside, and outside only near
/// the surface; this gives the exact distance of any point, for any shape, from its `tip()` and `edges()`.
///
/// A head is a body of revolution, so the nearest point of its surface lies in the meridian plane of the point: the
/// distance is that of a point from a few lines and arcs.
class HeadOutline {
 public:
  /// @param head  must outlive the outline
  explicit HeadOutline(const ToolHead& head) noexcept {
    head.visit([this](const auto& shape) { take(shape); });
  }
  /// @param shape  has `tip()` and `edges()` as ShapeOfHead; a ProfileHead must outlive the outline
  template <class Shape>
  requires requires(const Shape& shape) {
    shape.tip();
    shape.edges();
  }
  explicit HeadOutline(const Shape& shape) noexcept { take(shape); }

  /// A point seen from the head.
  struct Place {
    double distance;  ///< [m] from the surface, negative inside
    double n_radial;  ///< [1] component away from the axis of n, the unit vector from the head through the point
    double n_axial;   ///< [1] component of n along +z of T
  };

  /// [m] Distance of a point from the surface, negative inside.
  /// @realtime no allocation, no lock; O(edges of the profile)
  [[nodiscard]] double distance(double rho, double z) const noexcept {
    if (ball_radius_ > 0) return std::sqrt(rho * rho + z * z) - ball_radius_;
    return place(rho, z).distance;
  }

  /// Distance of a point and the direction of its growth.
  /// @realtime no allocation, no lock; O(edges of the profile)
  [[nodiscard]] Place place(double rho, double z) const noexcept {
    if (ball_radius_ > 0) {
      const double from_center = std::sqrt(rho * rho + z * z);
      if (!(from_center > 0)) return {-ball_radius_, 0, 1};
      return {from_center - ball_radius_, rho / from_center, z / from_center};
    }
    Nearest nearest;
    bool inside = false;
    for (const ProfilePiece<double>& piece : pieces()) {
      const Nearest here = nearest_on(piece, rho, z);
      if (here.distance < nearest.distance) nearest = here;
      if ((piece.z_0 <= z) != (piece.z_1 <= z)) inside ^= ProfileSprings<double>::crossing(piece, z) > rho;
    }
    // Next to the surface the direction of the difference is lost in rounding, so the normal is used.
    constexpr double kOnSurface = 1e-10;  // [m]
    if (nearest.distance < kOnSurface) return {0, nearest.normal_rho, nearest.normal_z};
    const double outward = inside ? -1 : 1;
    const double scale = outward / nearest.distance;
    return {outward * nearest.distance, scale * (rho - nearest.rho), scale * (z - nearest.z)};
  }

 private:
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    double rho = 0, z = 0;                // [m] point of the piece
    double normal_rho = 0, normal_z = 1;  // [1] out of the head
  };

  void take(const SphereHead& ball) noexcept { ball_radius_ = ball.radius; }
  void take(const ProfileHead& profile) noexcept { profile_ = profile.table().exact_pieces; }
  template <class Shape>
  void take(const Shape& shape) noexcept {
    static_assert(kEdgesOf<Shape> > 0,
                  "edges() of a shape must return a std::array, as that of ConeHead, because HeadOutline must not "
                  "allocate; a shape with a variable number of edges is a ProfileHead");
    static_assert(kEdgesOf<Shape> <= kMaxEdges, "a shape must not have more edges than each of ToolHead::Shape");
    ProfileEdge from = {0, shape.tip()};
    for (const ProfileEdge& edge : shape.edges()) {
      add(from, edge);
      from = edge;
    }
  }

  /// Appends the pieces of an edge. An arc is divided where it is highest or lowest, so that each piece has one rho at
  /// each height.
  /// @param from  the end of the previous edge
  void add(const ProfileEdge& from, const ProfileEdge& to) noexcept {
    if (to.radius == 0) {
      own_[count_++] = {from.rho, from.z, to.rho, to.z, 0, 0, 0, 0, 0};
      return;
    }
    const double sense = to.radius > 0 ? 1 : -1, radius = std::abs(to.radius);
    const double along_rho = to.rho - from.rho, along_z = to.z - from.z;
    const double squared = along_rho * along_rho + along_z * along_z;
    const double left = sense * std::sqrt(std::max(0.0, radius * radius / squared - 0.25));  // of the chord, over it
    const double center_rho = (from.rho + to.rho) / 2 - left * along_z,
                 center_z = (from.z + to.z) / 2 + left * along_rho;
    const auto add_piece = [&](double rho_0, double z_0, double rho_1, double z_1) {
      own_[count_++] = {rho_0, z_0, rho_1, z_1, center_rho, center_z, radius, sense, z_1 > z_0 ? sense : -sense};
    };
    if ((from.rho - center_rho) * (to.rho - center_rho) < 0) {
      const double z = center_z + (sense * (from.rho - center_rho) > 0 ? radius : -radius);
      add_piece(from.rho, from.z, center_rho, z);
      add_piece(center_rho, z, to.rho, to.z);
    } else {
      add_piece(from.rho, from.z, to.rho, to.z);
    }
  }
  [[nodiscard]] std::span<const ProfilePiece<double>> pieces() const noexcept {
    return count_ > 0 ? std::span<const ProfilePiece<double>>(own_.data(), count_) : profile_;
  }

  [[nodiscard]] static Nearest nearest_on(const ProfilePiece<double>& p, double rho, double z) noexcept {
    Nearest found;
    if (p.radius == 0) {
      const double along_rho = p.rho_1 - p.rho_0, along_z = p.z_1 - p.z_0;
      const double squared = along_rho * along_rho + along_z * along_z;
      const double s = std::clamp(((rho - p.rho_0) * along_rho + (z - p.z_0) * along_z) / squared, 0.0, 1.0);
      found.rho = p.rho_0 + s * along_rho, found.z = p.z_0 + s * along_z;
      const double length = std::sqrt(squared);  // the body is to the left of the piece
      found.normal_rho = along_z / length, found.normal_z = -along_rho / length;
    } else {
      const double v_rho = rho - p.center_rho, v_z = z - p.center_z;
      const double after = (p.rho_0 - p.center_rho) * v_z - (p.z_0 - p.center_z) * v_rho;
      const double before = v_rho * (p.z_1 - p.center_z) - v_z * (p.rho_1 - p.center_rho);
      const double from_center = std::sqrt(v_rho * v_rho + v_z * v_z);
      if (from_center > 0 && p.sense * after >= 0 && p.sense * before >= 0) {
        found.rho = p.center_rho + p.radius / from_center * v_rho;
        found.z = p.center_z + p.radius / from_center * v_z;
      } else {
        const bool first = std::hypot(rho - p.rho_0, z - p.z_0) <= std::hypot(rho - p.rho_1, z - p.z_1);
        found.rho = first ? p.rho_0 : p.rho_1, found.z = first ? p.z_0 : p.z_1;
      }
      found.normal_rho = p.sense * (found.rho - p.center_rho) / p.radius;
      found.normal_z = p.sense * (found.z - p.center_z) / p.radius;
    }
    found.distance = std::sqrt((rho - found.rho) * (rho - found.rho) + (z - found.z) * (z - found.z));
    return found;
  }

  /// Number of edges of a shape; 0 if its type does not tell.
  template <class Shape>
  static constexpr std::size_t kEdgesOf = [] {
    using Edges = std::remove_cvref_t<decltype(std::declval<const Shape&>().edges())>;
    if constexpr (requires { std::tuple_size<Edges>::value; })
      return std::tuple_size_v<Edges>;
    else
      return std::size_t(0);
  }();
  static constexpr std::size_t kMaxEdges = []<class... Shape>(Of<std::variant<Shape...>>) {
    return std::max({kEdgesOf<Shape>...});
  }(Of<ToolHead::Shape>{});

  double ball_radius_ = 0;                                    // [m] 0: not a ball
  std::array<ProfilePiece<double>, 2 * kMaxEdges> own_ = {};  // pieces of a shape with a fixed number of edges
  std::size_t count_ = 0;                                     // number of pieces in `own_`
  std::span<const ProfilePiece<double>> profile_;             // pieces of a profile
};

}  // namespace hapticut
