// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "hapticut/tool/profile.hpp"
#include "hapticut/tool/shapes.hpp"

namespace hapticut {

/// Extent of a head in its own frame T.
struct HeadBox {
  Vec3 min;  ///< [m]
  Vec3 max;  ///< [m]
};

/// The spring at one point of a head, in T.
struct Spring {
  double depth;    ///< [m] below the cutting surface; <= 0: outside, no spring
  Vec3 direction;  ///< [1] n, a unit vector from the local spring centre through the point, into the material
};

/// The cutting head of a tool: any shape, asked for many points at once.
class ToolHead {
 public:
  using Shape = std::variant<SphereHead, ConeHead, FlatHead, ProfileHead>;

  /// @throws Error when a dimension is not positive or an angle not between 0 and pi/2
  ToolHead(Shape shape);  // NOLINT(google-explicit-constructor): a shape is a head

  template <class S>
  // NOLINTNEXTLINE(google-explicit-constructor): as above
  requires std::is_constructible_v<Shape, S> ToolHead(const S& shape) : ToolHead(Shape(shape)) {}

  [[nodiscard]] const Shape& shape() const { return shape_; }

  /// The smallest axis-aligned box around the head, in T, exact.
  [[nodiscard]] HeadBox bounding_box() const;

  /// [m] radius of the ball about the frame's origin that contains the head, exact.
  [[nodiscard]] double reach() const;

  /// [m^3] volume of the head, exact.
  [[nodiscard]] double volume() const;

  /// [m] largest radius of the head about its axis: sphere and flat R, cone the base radius, profile the largest rho.
  [[nodiscard]] double largest_radius() const;

  /// Shape and size as messages print them: "a cone of half angle 30 deg and height 2 mm".
  [[nodiscard]] std::string description() const;

  /// The outline as a meridian of lines and arcs. The two surfaces of a flat head are drawn as its rule uses them.
  [[nodiscard]] Profile profile() const;

  /// Calls `function(springs)` with the springs of this head's shape in precision `Real`: the one place where the shape
  /// is dispatched. Call it once per block of points, never per point.
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

  /// The spring at one point of T, for tests and set-up code.
  [[nodiscard]] Spring spring_at(const Vec3& p_TQ) const;

 private:
  Shape shape_;
};

}  // namespace hapticut
