// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/profile.hpp"
#include "hapticut/tool/shapes.hpp"

namespace hapticut {
namespace detail {
/// Text of a length [m]: "2 mm".
[[nodiscard]] inline std::string in_mm(double length) { return format_number(length / units::mm) + " mm"; }
}  // namespace detail

/// Extent of a head in its own frame T.
struct HeadBox {
  Vec3 min;  ///< [m]
  Vec3 max;  ///< [m]
};

/// The spring at one point of a head, in T.
struct Spring {
  double depth;    ///< [m] w below the surface, see MeridianSpring; <= 0: outside the head, no spring
  Vec3 direction;  ///< [1] n, a unit vector from the local spring centre through the point, into the material
  double smooth;   ///< [m^2] as MeridianSpring::smooth

  [[nodiscard]] bool on_smooth() const { return smooth > 0; }
  /// [1] Change of w per distance along n: kSmoothScale at smooth surfaces, else 1.
  [[nodiscard]] double scale() const { return on_smooth() ? kSmoothScale : 1; }
};

/// The cutting head of a tool, of any shape.
class ToolHead {
 public:
  using Shape = std::variant<SphereHead, ConeHead, FlatHead, ProfileHead>;

  /// @throws Error if a dimension is not positive or an angle is not between 0 and pi/2
  ToolHead(Shape shape) : shape_(std::move(shape)) {  // NOLINT(google-explicit-constructor): a shape is a head
    validate();
  }

  template <class S>
  // NOLINTNEXTLINE(google-explicit-constructor): as above
  requires std::is_constructible_v<Shape, S> ToolHead(const S& shape) : ToolHead(Shape(shape)) {}

  [[nodiscard]] const Shape& shape() const { return shape_; }

  /// The smallest axis-aligned box around the head, in T, exact.
  [[nodiscard]] HeadBox bounding_box() const {
    const auto around_axis = [](double radius, double low, double high) {
      return HeadBox{Vec3(-radius, -radius, low), Vec3(radius, radius, high)};
    };
    if (const auto* h = as<SphereHead>()) return around_axis(h->radius, -h->radius, h->radius);
    if (const auto* h = as<ConeHead>()) return around_axis(base_radius(*h), 0, h->height);
    if (const auto* h = as<FlatHead>()) return around_axis(h->radius, 0, h->height);
    const ProfileTable& table = as<ProfileHead>()->table();
    return around_axis(table.radius, table.bottom, table.top);
  }

  /// [m] radius of the ball about the frame's origin that contains the head, exact.
  [[nodiscard]] double reach() const {
    if (const auto* h = as<SphereHead>()) return h->radius;
    if (const auto* h = as<ConeHead>()) return std::hypot(base_radius(*h), h->height);
    if (const auto* h = as<FlatHead>()) return std::hypot(h->radius, h->height);
    return as<ProfileHead>()->reach();
  }

  /// [m^3] volume of the head, exact.
  [[nodiscard]] double volume() const {
    using units::kPi;
    if (const auto* h = as<SphereHead>()) return 4 * kPi / 3 * h->radius * h->radius * h->radius;
    if (const auto* h = as<ConeHead>()) return kPi / 3 * base_radius(*h) * base_radius(*h) * h->height;
    if (const auto* h = as<FlatHead>()) return kPi * h->radius * h->radius * h->height;
    return as<ProfileHead>()->volume();
  }

  /// [m] Largest radius of the head about its axis: R for sphere and flat head, the base radius for a cone, the largest
  /// rho for a profile.
  [[nodiscard]] double max_radius() const { return bounding_box().max.x(); }

  /// [m] Largest radius of the cutting edges, without neck and shank.
  [[nodiscard]] double cutting_radius() const {
    const auto* profile = as<ProfileHead>();
    return profile == nullptr ? max_radius() : profile->cutting_radius();
  }

  /// Shape and size for messages: "a cone of half angle 30 deg and height 2 mm".
  [[nodiscard]] std::string description() const {
    using detail::in_mm;
    if (const auto* h = as<SphereHead>()) return "a sphere of radius " + in_mm(h->radius);
    if (const auto* h = as<ConeHead>())
      return "a cone of half angle " + format_number(h->half_angle / units::deg) + " deg and height " +
             in_mm(h->height);
    if (const auto* h = as<FlatHead>())
      return "a flat head of radius " + in_mm(h->radius) + " and height " + in_mm(h->height);
    const ProfileTable& table = as<ProfileHead>()->table();
    return "a profile of radius " + in_mm(table.radius) + " and height " +
           in_mm(double(table.top) - double(table.bottom));
  }

  /// The outline as a meridian of lines and arcs. The surfaces of a flat head that its rule does not use are smooth.
  [[nodiscard]] Profile profile() const {
    constexpr EdgeKind kCutting = EdgeKind::cutting, kSmooth = EdgeKind::smooth;
    if (const auto* h = as<SphereHead>()) return {-h->radius, {{0, h->radius, h->radius, kCutting}}};
    if (const auto* h = as<ConeHead>())
      return {0, {{base_radius(*h), h->height, 0, kCutting}, {0, h->height, 0, kSmooth}}};
    if (const auto* h = as<FlatHead>()) {
      const EdgeKind bottom = h->rule == FlatRule::side_only ? kSmooth : kCutting;
      const EdgeKind side = h->rule == FlatRule::bottom_only ? kSmooth : kCutting;
      return {0, {{h->radius, 0, 0, bottom}, {h->radius, h->height, 0, side}, {0, h->height, 0, kSmooth}}};
    }
    return as<ProfileHead>()->profile();
  }

  /// Calls `function(springs)` with the springs of this head's shape in precision `Real`. Only this function dispatches
  /// on the shape. Call it once per block of points, not once per point.
  template <class Real, class Function>
  decltype(auto) visit_springs(Function&& function) const {
    if (const auto* sphere = std::get_if<SphereHead>(&shape_)) return function(SphereSprings<Real>(*sphere));
    if (const auto* cone = std::get_if<ConeHead>(&shape_)) return function(ConeSprings<Real>(*cone));
    if (const auto* profile = std::get_if<ProfileHead>(&shape_))
      return function(ProfileSprings<Real>(profile->table()));
    const FlatHead& flat = *std::get_if<FlatHead>(&shape_);
    switch (flat.rule) {
      case FlatRule::bottom_only:
        return function(FlatSprings<Real, FlatRule::bottom_only>(flat));
      case FlatRule::side_only:
        return function(FlatSprings<Real, FlatRule::side_only>(flat));
      case FlatRule::both:
        return function(FlatSprings<Real, FlatRule::both>(flat));
      case FlatRule::nearest:
        break;
    }
    return function(FlatSprings<Real, FlatRule::nearest>(flat));
  }

  /// The spring at one point, for tests and set-up code.  @param p_TQ  [m]
  [[nodiscard]] Spring spring_at(const Vec3& p_TQ) const {
    const double rho = std::hypot(p_TQ.x(), p_TQ.y());
    const MeridianSpring<double> s =
        visit_springs<double>([&](const auto& springs) { return springs.spring(rho, p_TQ.z()); });
    const double scale = rho > 0 ? s.n_radial / rho : 0.0;
    return {s.depth, Vec3(scale * p_TQ.x(), scale * p_TQ.y(), s.n_axial), s.smooth};
  }

  /// The local centre of the spring at a point: where its line meets the axis of the head (O''_i of the thesis, eqs.
  /// 5.6-5.8); the centre of a ball. Nothing where there is no spring or its line is parallel to the axis, as below the
  /// bottom of a flat head.
  /// @param p_TQ  [m] in T
  /// @return [m] in T
  [[nodiscard]] std::optional<Vec3> spring_center(const Vec3& p_TQ) const {
    const Spring s = spring_at(p_TQ);
    const double across = s.direction.head<2>().norm();
    if (!(s.depth > 0) || across == 0) return std::nullopt;
    return Vec3(0, 0, p_TQ.z() - p_TQ.head<2>().norm() / across * s.direction.z());
  }

 private:
  [[nodiscard]] static double base_radius(const ConeHead& cone) { return cone.height * std::tan(cone.half_angle); }

  template <class S>
  [[nodiscard]] const S* as() const {
    return std::get_if<S>(&shape_);
  }

  void validate() const {
    if (const auto* h = as<SphereHead>()) require_fields_within(*h, "SphereHead::");
    if (const auto* h = as<FlatHead>()) require_fields_within(*h, "FlatHead::");
    const auto* cone = as<ConeHead>();  // a profile was checked when it was made
    if (cone == nullptr) return;
    require_fields_within(*cone, "ConeHead::");
    if (!(cone->half_angle < units::kPi / 2))
      throw Error("ConeHead::half_angle = " + format_number(cone->half_angle) +
                  " rad; must be less than pi/2. Give half of the opening angle, in radians.");
  }

  Shape shape_;
};

}  // namespace hapticut
