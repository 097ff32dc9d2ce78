// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/tool/spindle.hpp"

namespace hapticut {

/// The default cutter of a head: a twist drill if only a conical point cuts and the side above it is smooth, as in
/// `twist_drill_head`; else a carbide bur.
[[nodiscard]] inline Cutter usual_cutter(const ToolHead& head) {
  const std::vector<ProfileEdge> edges = head.profile().edges;
  const bool points = edges[0].kind == EdgeKind::cutting && edges[0].radius == 0 && edges[0].z > head.tip();
  const bool smooth_above =
      edges.size() > 2 && edges[1].z > edges[0].z &&
      std::all_of(edges.begin() + 1, edges.end(), [](const ProfileEdge& e) { return e.kind == EdgeKind::smooth; });
  return {points && smooth_above ? CutterKind::twist_drill : CutterKind::carbide_bur};
}

/// The tool in the hand: a head on a handle, driven by a spindle. Immutable; the constructor checks all values.
class Tool {
 public:
  /// `Tool(SphereHead{1 * mm}, RayHandle{20 * mm}, Spindle{40000 * rpm})`
  /// @param handle   by default none: the pose of the hand is the pose of the head, and there is no lever arm
  /// @param spindle  by default at rest: the head presses and rubs, but cuts nothing (StepStatus::spindle_stands)
  /// @param cutter   by default that of `usual_cutter`
  /// @throws Error if a dimension of the head or handle, a value of the spindle or the number of lips is out of range,
  ///         or if a size must have been meant in millimetres
  explicit Tool(ToolHead head, Handle handle = RayHandle{0}, Spindle spindle = {}, std::optional<Cutter> cutter = {})
      : head_(std::move(head)),
        handle_(handle),
        spindle_(spindle),
        cutter_(cutter.value_or(usual_cutter(head_))),
        X_HT_(head_in_handle(handle)) {
    validate(spindle_);
    validate(cutter_);
    cutter_.lips = lips_of(cutter_);
    require_metres(head_.reach(), kMaxHeadReach, "reach of the head [m]");
    require_metres(X_HT_.translation.norm(), kMaxHandleReach, "length of the handle [m]");
  }

  [[nodiscard]] const ToolHead& head() const { return head_; }
  [[nodiscard]] const Handle& handle() const { return handle_; }
  [[nodiscard]] const Spindle& spindle() const { return spindle_; }
  [[nodiscard]] const Cutter& cutter() const { return cutter_; }  ///< with the number of lips, even if it was not given
  [[nodiscard]] const Pose& X_HT() const { return X_HT_; }        ///< pose of the head in the handle frame

 private:
  ToolHead head_;
  Handle handle_;
  Spindle spindle_;
  Cutter cutter_;
  Pose X_HT_;
};

/// [1] Feed per lip over the diameter from which the chips of a twist drill crowd its flutes: an assumption, twice that
/// of ordinary drilling. With the steep law of `formulas::CutResistance` no hand feeds it more than a tenth.
inline constexpr double kCrowdedFeed = 0.08;

/// [m] The chip, along the normal of a drill's point, from which chips crowd its flutes; 0 for other cutters, whose
/// chips are never as thick.
[[nodiscard]] inline double crowded_chip(const Tool& tool) {
  if (tool.cutter().kind != CutterKind::twist_drill) return 0;
  const Profile profile = tool.head().profile();
  double facing = 0;  // [1] largest component of the cutting edges' normals along the axis
  double rho = 0, z = profile.tip;
  for (const ProfileEdge& edge : profile.edges) {
    const double along = std::abs(edge.rho - rho) / std::hypot(edge.rho - rho, edge.z - z);
    if (edge.kind == EdgeKind::cutting) facing = std::max(facing, edge.radius == 0 ? along : 1.0);
    rho = edge.rho, z = edge.z;
  }
  return kCrowdedFeed * 2 * tool.head().cutting_radius() * facing;
}

}  // namespace hapticut
