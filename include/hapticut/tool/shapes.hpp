// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <string>
#include <vector>

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/formulas/numbers.hpp"

/// @file
/// What the shapes of cutting heads have in common (docs/model.md, heads; thesis section 5.2.1). Each shape is a struct
/// in a file of its own; `ToolHead::Shape` lists them.
///
/// Tool frame T: +z is the spindle axis, pointing from the cutting tip towards the shank. Every head is a body of
/// revolution about z, so a point enters only by its distance `rho` from the axis and its height `z`, and the direction
/// from the local spring centre through it lies in the same meridian plane.
namespace hapticut {
namespace detail {
/// Text of a length [m]: "2 mm".
[[nodiscard]] inline std::string in_mm(double length) { return format_number(length / units::mm) + " mm"; }
}  // namespace detail

/// [1] beta: the depth w grows beta times as fast below a smooth surface as below a cutting surface. A wall then
/// presses on a smooth side earlier than on the cutting edges, and the corner leaves less uncut material. The value 2
/// gives the thrust of a drill within 1 % if the layer is a fiftieth of the drill's radius. A larger value would make
/// smooth sides too stiff for single precision and for the coupling.
inline constexpr double kSmoothScale = 2;

/// Extent of a head in its own frame T.
struct HeadBox {
  Vec3 min;  ///< [m]
  Vec3 max;  ///< [m]

  /// The box around a body of revolution.
  [[nodiscard]] static HeadBox around_axis(double radius, double low, double high) {
    return {Vec3(-radius, -radius, low), Vec3(radius, radius, high)};
  }
};

/// Whether an edge of a profile cuts.
enum class EdgeKind {
  cutting,  ///< the edge presses and cuts
  smooth    ///< safe side, margin, neck or shank: presses and rubs, and cuts only close to a cutting edge
};

constexpr auto names_of(Of<EdgeKind>) {
  using enum EdgeKind;
  return std::array{
      Named{cutting, "cutting"},
      Named{smooth, "smooth"},
  };
}

/// One edge of a meridian. It begins at the end of the previous edge.
struct ProfileEdge {
  double rho = 0;  ///< [m] end: distance from the axis, >= 0
  double z = 0;    ///< [m] end: height
  /// [m] 0: straight; > 0: arc that bulges outwards; < 0: hollow arc. At most a half circle.
  double radius = 0;
  EdgeKind kind = EdgeKind::cutting;
};

/// The meridian of a body of revolution, in the tool frame: from its tip on the axis outwards, up and back to the axis
/// on the shank's side, with the body to the left.
///
///       z ^
///         +-----+       edges: tip -> (R, 0) -> (R, H) -> (0, H)
///         |     |
///         |     |
///     tip +-----+--> rho
///
struct Profile {
  double tip = 0;  ///< [m] z of the starting point, at rho = 0
  std::vector<ProfileEdge> edges;
};

/// What a shape of head has, in T. Its springs are `formulas::with_springs`. A shape with dimensions is described by
/// `fields_of` and has a head of `usual()` dimensions and a name `kInSentences`, "a cone". `validate()` checks what the
/// ranges of the fields do not.
template <class S>
concept ShapeOfHead = requires(const S& shape) {
  // In settings and recordings, "cone"; in C++ and Python, "ConeHead"; shape and size, for messages.
  { S::kWord } -> std::convertible_to<std::string>;
  { S::kName } -> std::convertible_to<std::string>;
  { shape.description() } -> std::same_as<std::string>;
  // Extent; [m] largest distance from the origin; [m] largest rho of the cutting edges; [m^3]. All are exact.
  { shape.bounding_box() } -> std::same_as<HeadBox>;
  { shape.reach() } -> std::same_as<double>;
  { shape.cutting_radius() } -> std::same_as<double>;
  { shape.volume() } -> std::same_as<double>;
  // [m] Where the meridian begins on the axis; its edges, a std::array. Surfaces without a spring are smooth.
  { shape.tip() } -> std::same_as<double>;
  { *shape.edges().begin() } -> std::convertible_to<ProfileEdge>;
};

namespace formulas {
#include "hapticut/formulas/springs.inl"
}  // namespace formulas

using formulas::MeridianSpring;

}  // namespace hapticut
