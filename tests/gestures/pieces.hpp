// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/tool/tool.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/solid_depth.hpp"

/// @file
/// Workpieces, heads and key-framed hands of the gestures.
namespace hapticut::gestures {

using units::kPi;
using units::mm;
using units::rpm;

using test::crushing_depth;
using test::plain_material;
using test::strength_of;

// --- pieces ----------------------------------------------------------------------------------------------------------

/// A block of the half space z < 0, on a grid whose lines match neither the surface nor the head.
[[nodiscard]] inline Workpiece slab(double half_width, double depth, double voxel, Material material) {
  return build_block({Vec3(-half_width - 0.21 * voxel, -half_width - 0.37 * voxel, -depth - 0.61 * voxel),
                      Vec3(half_width, half_width, 0)},
                     voxel, std::move(material));
}

/// [m] Distance of a point from a box, negative inside. Outside an edge or a corner it is a lower bound.
[[nodiscard]] inline double box_distance(const Box& box, const Vec3& p) {
  return std::max((box.min - p).maxCoeff(), (p - box.max).maxCoeff());
}

/// The part of a box where `distance` is negative, of one material.
template <class Distance>
[[nodiscard]] Workpiece carved(const Box& box, double voxel, Material material, const Distance& distance) {
  const Vec3 aside = voxel * Vec3(0.21, 0.37, 0.61);
  return build_body({{box.min - aside, box.max + aside},
                     [=](const Vec3& p) { return std::max(box_distance(box, p), distance(p)); },
                     [](const Vec3&) { return MaterialId(1); }},
                    voxel, MaterialTable({std::move(material)}), 4);
}

/// A half space with a straight hole. The bottom of the hole is flat, or has the point angle of a drill.
[[nodiscard]] inline Workpiece with_hole(double half_width, double depth, double voxel, Material material,
                                         double radius, double hole_depth, double point_angle = kPi) {
  const double slope = point_angle < kPi ? 1 / std::tan(point_angle / 2) : 0;  // [1] rise of the point
  const Box box{Vec3(-half_width, -half_width, -depth), Vec3(half_width, half_width, 0)};
  return carved(box, voxel, std::move(material), [=](const Vec3& p) {
    const double rho = std::hypot(p.x(), p.y());
    const double bottom = (-hole_depth + slope * rho - p.z()) / std::hypot(1, slope);
    return -std::max(rho - radius, bottom);  // solid outside the hole
  });
}

// --- heads -----------------------------------------------------------------------------------------------------------

struct NamedHead {
  std::string name;
  ToolHead head;
};

/// One head of each shape of the catalogue.
[[nodiscard]] inline std::vector<NamedHead> catalogue() {
  return {{"round 1 mm", round_head(1 * mm)},
          {"inverted cone 1.4 mm", inverted_cone_head(1.4 * mm, 0.9 * mm, 1.2 * mm)},
          {"cylinder 1 mm", cylinder_head(1 * mm, 4 * mm)},
          {"round-end cylinder 1.2 mm", round_end_cylinder_head(1.2 * mm, 4 * mm)},
          {"tapered 1.6 mm", tapered_head(0.9 * mm, 1.6 * mm, 4 * mm)},
          {"round-end tapered 1.6 mm", round_end_tapered_head(0.8 * mm, 1.6 * mm, 4 * mm)},
          {"needle 1.2 mm", needle_head(1.2 * mm, 4 * mm)},
          {"flame 1.4 mm", flame_head(1.4 * mm, 4 * mm, 0.9 * mm, 2 * mm)},
          {"pear 1.4 mm", pear_head(1.4 * mm, 2.6 * mm, 0.8 * mm)},
          {"wheel 2.4 mm", wheel_head(2.4 * mm, 0.8 * mm, 1 * mm)},
          {"christmas tree 2 mm", christmas_tree_head(2 * mm, 3 * mm, 3)},
          {"twist drill 2 mm", twist_drill_head(2 * mm, 4 * mm)}};
}

/// [m^2] Area of a head's section at a height above the tip.
[[nodiscard]] inline double section_area(const ToolHead& head, double height) {
  constexpr int kSteps = 200;
  const HeadBox box = head.bounding_box();
  const double step = box.max.x() / kSteps, z = box.min.z() + height;
  double radius = 0;
  head.visit_springs<double>([&](const auto& springs) {
    for (int n = 0; n < kSteps; ++n)
      if (springs.margin(n * step, z) > 0) radius = (n + 0.5) * step;
    return 0;
  });
  return kPi * radius * radius;
}

/// [m] Depth to which a force presses a standing head into a face. Each ring of the head bears the pressure k w^2/2,
/// and at most the strength. w is the thickness of the layer below the ring, along the ring's normal.
/// @param stiffness  [N/m^4] k of the material
[[nodiscard]] inline double pressed_depth(const ToolHead& head, double force, const Material& material,
                                          double stiffness) {
  constexpr double kStep = 2e-6;
  const double strength = strength_of(material);
  std::vector<double> radii = {0};  // [m] at multiples of kStep above the tip
  const auto carried = [&](std::size_t rings) {
    double sum = 0;
    for (std::size_t n = 0; n < rings; ++n) {
      const double wider = std::max(0.0, radii[n + 1] - radii[n]), upright = wider / std::hypot(wider, kStep);
      const double layer = (double(rings - n) - 0.5) * kStep * upright;
      sum += kPi * (radii[n + 1] + radii[n]) * wider * std::min(0.5 * stiffness * layer * layer, strength);
    }
    return sum;
  };
  do radii.push_back(std::sqrt(section_area(head, double(radii.size()) * kStep) / kPi));
  while (carried(radii.size() - 1) < force && double(radii.size()) * kStep < 1 * mm);
  return double(radii.size() - 1) * kStep;
}

/// [m] Distance of the tip of a tool below its handle point.
[[nodiscard]] inline double tip_below_hand(const Tool& tool) {
  return -(tool.X_HT().translation.z() + tool.head().bounding_box().min.z());
}

/// The cut in the terms of the closed forms.
/// @param spin, feed  [rad/s], [m/s]
[[nodiscard]] inline closed_forms::SteadyCut steady_cut(const Material& m, const Cutter& cutter, double spin,
                                                        double feed) {
  closed_forms::SteadyCut cut{m.specific_cutting_energy, m.cutting_ratio, spin, feed, m.edge_pressure};
  cut.tooth_rate = tooth_rate(cutter, spin);
  cut.edge_length = m.edge_length;
  cut.size_length = m.size_length;
  return cut;
}

/// A tool whose handle point lies at To.
[[nodiscard]] inline Tool tool_of(ToolHead head, const Spindle& spindle = {}, Cutter cutter = {}) {
  return Tool(std::move(head), RayHandle{0}, spindle, cutter);
}

// --- hands -----------------------------------------------------------------------------------------------------------

/// The path of a hand: key frames with constant speed in between.
class Hand {
 public:
  explicit Hand(const Pose& start) { frames_.push_back({0, start}); }
  /// Starts with the tip of an upright tool at a point.
  Hand(const Tool& tool, const Vec3& tip) : Hand(Pose::from_translation(tip + Vec3(0, 0, tip_below_hand(tool)))) {}

  Hand& hold(double seconds) { return to(end(), seconds); }
  Hand& move(const Vec3& by, double seconds) {
    Pose pose = end();
    pose.translation += by;
    return to(pose, seconds);
  }
  /// @param by     [rad] about an axis of W
  /// @param pivot  [m] fixed point, in W
  Hand& turn(const Vec3& by, const Vec3& pivot, double seconds) {
    constexpr int kParts = 16;  // chords of the arc
    const Mat3 part = rotation_from_vector(by / kParts);
    for (int n = 0; n < kParts; ++n) {
      const Pose pose = end();
      to({part * pose.rotation, pivot + part * (pose.translation - pivot)}, seconds / kParts);
    }
    return *this;
  }
  Hand& to(const Pose& pose, double seconds) {
    frames_.push_back({frames_.back().time + seconds, pose});
    return *this;
  }

  [[nodiscard]] double seconds() const { return frames_.back().time; }  ///< [s] so far
  [[nodiscard]] Pose end() const { return frames_.back().pose; }        ///< by value, because the vector reallocates
  [[nodiscard]] Pose at(double time) const {
    if (time <= 0) return frames_.front().pose;
    for (std::size_t n = 1; n < frames_.size(); ++n) {
      const Frame &from = frames_[n - 1], &to = frames_[n];
      if (time > to.time) continue;
      const double span = to.time - from.time, share = span > 0 ? (time - from.time) / span : 1;
      return advance(from.pose, twist_between(from.pose, to.pose, 1), share);
    }
    return end();
  }

 private:
  struct Frame {
    double time;  // [s]
    Pose pose;
  };
  std::vector<Frame> frames_;
};

}  // namespace hapticut::gestures
