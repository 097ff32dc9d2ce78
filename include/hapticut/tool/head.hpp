// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "hapticut/tool/cone.hpp"
#include "hapticut/tool/flat.hpp"
#include "hapticut/tool/profile.hpp"
#include "hapticut/tool/shapes.hpp"
#include "hapticut/tool/sphere.hpp"

namespace hapticut {

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

  /// The shape of the head, e.g. a SphereHead.
  [[nodiscard]] const Shape& shape() const { return shape_; }

  /// Calls `function(shape)`. Whatever depends on the shape asks it in this way.
  // Not std::visit, which can throw.
  template <std::size_t kIndex = 0, class Function>
  decltype(auto) visit(const Function& function) const {
    if constexpr (kIndex + 1 < std::variant_size_v<Shape>)
      if (shape_.index() != kIndex) return visit<kIndex + 1>(function);
    return function(*std::get_if<kIndex>(&shape_));
  }

  /// The ball, if the head is one; else null. Only a ball has neither an edge nor a smooth surface.
  [[nodiscard]] const SphereHead* ball() const { return std::get_if<SphereHead>(&shape_); }

  /// The smallest axis-aligned box around the head, in T, exact.
  [[nodiscard]] HeadBox bounding_box() const {
    return visit([](const auto& shape) { return shape.bounding_box(); });
  }

  /// [m] radius of the ball about the frame's origin that contains the head, exact.
  [[nodiscard]] double reach() const {
    return visit([](const auto& shape) { return shape.reach(); });
  }

  /// [m^3] volume of the head, exact.
  [[nodiscard]] double volume() const {
    return visit([](const auto& shape) { return shape.volume(); });
  }

  /// [m] Largest radius of the head about its axis: R for sphere and flat head, the base radius for a cone, the largest
  /// rho for a profile.
  [[nodiscard]] double max_radius() const { return bounding_box().max.x(); }

  /// [m] Largest radius of the cutting edges, without neck and shank.
  [[nodiscard]] double cutting_radius() const {
    return visit([](const auto& shape) { return shape.cutting_radius(); });
  }

  /// [m] Height of the tip, where the axis enters the head: -R for a sphere, 0 for a cone and a flat head.
  [[nodiscard]] double tip() const {
    return visit([](const auto& shape) { return shape.tip(); });
  }

  /// Shape and size for messages: "a cone of half angle 30 deg and height 2 mm".
  [[nodiscard]] std::string description() const {
    return visit([](const auto& shape) { return shape.description(); });
  }

  /// The outline as a meridian of lines and arcs. The surfaces of a flat head that its rule does not use are smooth.
  [[nodiscard]] Profile profile() const {
    return visit([](const auto& shape) -> Profile {
      const auto& edges = shape.edges();
      return {shape.tip(), {edges.begin(), edges.end()}};
    });
  }

  /// Calls `function(springs)` with the springs of this head's shape in precision `Real`. Call it once per block of
  /// points, not once per point.
  template <class Real, class Function>
  decltype(auto) visit_springs(const Function& function) const {
    return visit([&](const auto& shape) -> decltype(auto) { return formulas::with_springs<Real>(shape, function); });
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
  void validate() const {
    visit([]<class S>(const S& shape) {
      if constexpr (Described<S>) require_fields_within(shape, std::string(S::kName) + "::");
      if constexpr (requires { shape.validate(); }) shape.validate();
    });
  }

  Shape shape_;
};

/// Calls `function(Of<Shape>{})` for each shape of head.
template <std::size_t kIndex = 0, class Function>
constexpr void for_each_shape(const Function& function) {
  using Shape = std::variant_alternative_t<kIndex, ToolHead::Shape>;
  static_assert(ShapeOfHead<Shape>);
  function(Of<Shape>{});
  if constexpr (kIndex + 1 < std::variant_size_v<ToolHead::Shape>) for_each_shape<kIndex + 1>(function);
}

}  // namespace hapticut
