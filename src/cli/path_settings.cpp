// SPDX-License-Identifier: Apache-2.0
#include "cli/path_settings.hpp"

#include <algorithm>
#include <variant>

#include "cli/curves.hpp"
#include "cli/pose_file.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::cli {
namespace {

using Kind = PathSettings::Kind;
using Point = PathSettings::Point;

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::line:
      return "line";
    case Kind::circle:
      return "circle";
    case Kind::spiral:
      return "spiral";
    case Kind::cavity:
      return "cavity";
    case Kind::poses:
      break;
  }
  return "poses";
}

/// Looks settings up for one kind of path: what it needs must be there, what it does not know must not.
class Lookup {
 public:
  explicit Lookup(Kind kind) : kind_(kind) {}

  template <class Value>
  Value need(const std::optional<Value>& value, const std::string& name) {
    if (!value)
      throw Error("path." + name + " is missing; a path of kind " + name_of(kind_) + " needs it. Set --" + name +
                  ", or " + name + " under [path] in the settings file.");
    return *value;
  }

  template <class Value>
  void refuse_unless(std::initializer_list<Kind> kinds, const std::optional<Value>& value, const char* name) const {
    if (value && std::find(kinds.begin(), kinds.end(), kind_) == kinds.end())
      throw Error(std::string("path.") + name + " is set, but a path of kind " + name_of(kind_) +
                  " has none. Leave it out, or choose another kind.");
  }

 private:
  Kind kind_;
};

void refuse_what_does_not_belong(const PathSettings& s) {
  const Lookup lookup(*s.kind);
  const std::initializer_list<Kind> curves = {Kind::line, Kind::circle, Kind::spiral, Kind::cavity};
  lookup.refuse_unless({Kind::line}, s.from_mm, "from_mm");
  lookup.refuse_unless({Kind::line}, s.to_mm, "to_mm");
  lookup.refuse_unless({Kind::circle, Kind::spiral, Kind::cavity}, s.center_mm, "center_mm");
  lookup.refuse_unless({Kind::circle, Kind::spiral, Kind::cavity}, s.axis, "axis");
  lookup.refuse_unless({Kind::circle}, s.radius_mm, "circle_radius_mm");
  lookup.refuse_unless({Kind::circle}, s.turns, "turns");
  lookup.refuse_unless({Kind::circle}, s.start_angle_deg, "start_angle_deg");
  lookup.refuse_unless({Kind::spiral}, s.start_radius_mm, "start_radius_mm");
  lookup.refuse_unless({Kind::spiral}, s.end_radius_mm, "end_radius_mm");
  lookup.refuse_unless({Kind::spiral, Kind::cavity}, s.pitch_mm, "pitch_mm");
  lookup.refuse_unless({Kind::spiral, Kind::cavity}, s.depth_mm, "depth_mm");
  lookup.refuse_unless({Kind::cavity}, s.top_radius_mm, "top_radius_mm");
  lookup.refuse_unless({Kind::cavity}, s.bottom_radius_mm, "bottom_radius_mm");
  lookup.refuse_unless({Kind::cavity}, s.layer_mm, "layer_mm");
  lookup.refuse_unless(curves, s.feed_mm_per_s, "feed_mm_per_s");
  if (!s.file.empty()) lookup.refuse_unless({Kind::poses}, std::optional(s.file), "file");
}

std::vector<Vec3> curve_of(const PathSettings& s, const Vec3& tool_axis) {
  Lookup lookup(*s.kind);
  using units::mm;
  if (*s.kind == Kind::line) return {lookup.need(s.from_mm, "from_mm") * mm, lookup.need(s.to_mm, "to_mm") * mm};
  const CurvePlane plane{lookup.need(s.center_mm, "center_mm") * mm, s.axis.value_or(tool_axis)};
  if (!(plane.axis.norm() > 0)) throw Error("path.axis = 0 0 0; must have a length. Set path.axis, e.g. 0,0,1.");
  if (*s.kind == Kind::circle)
    return circle(plane, lookup.need(s.radius_mm, "circle_radius_mm") * mm, lookup.need(s.turns, "turns"),
                  s.start_angle_deg.value_or(0) * units::deg);
  const double pitch = lookup.need(s.pitch_mm, "pitch_mm") * mm, depth = lookup.need(s.depth_mm, "depth_mm") * mm;
  if (*s.kind == Kind::spiral)
    return spiral(plane, lookup.need(s.start_radius_mm, "start_radius_mm") * mm,
                  lookup.need(s.end_radius_mm, "end_radius_mm") * mm, pitch, depth);
  return cavity(plane, {lookup.need(s.top_radius_mm, "top_radius_mm") * mm,
                        lookup.need(s.bottom_radius_mm, "bottom_radius_mm") * mm, depth,
                        lookup.need(s.layer_mm, "layer_mm") * mm, pitch});
}

Mat3 orientation_of(const PathSettings& s) {
  const Vec3 axis = s.tool_axis.value_or(Vec3::UnitZ());
  if (!(axis.norm() > 0)) throw Error("path.tool_axis = 0 0 0; must have a length. Set path.tool_axis, e.g. 0,0,1.");
  const double roll = s.tool_roll_deg.value_or(0) * units::deg;
  return CurvePlane{Vec3::Zero(), axis}.frame().rotation * rotation_from_vector(Vec3(0, 0, roll));
}

/// Moves on along a straight line.
void append(std::vector<TimedPose>& poses, const Vec3& target, const Mat3& rotation, double feed) {
  const double length = (target - poses.back().pose.translation).norm();
  if (length > 1e-12) poses.push_back({poses.back().t + length / feed, {rotation, target}});
}

std::vector<TimedPose> follow(const PathSettings& s) {
  const Mat3 rotation = orientation_of(s);
  const Vec3 outwards = rotation.col(2);
  const double feed = Lookup(*s.kind).need(s.feed_mm_per_s, "feed_mm_per_s") * units::mm_per_s;
  const double approach_feed = s.approach_feed_mm_per_s ? *s.approach_feed_mm_per_s * units::mm_per_s : feed;
  const std::vector<Vec3> points = curve_of(s, outwards);

  std::vector<TimedPose> poses;
  poses.push_back({0, {rotation, points.front() + outwards * s.approach_mm.value_or(0) * units::mm}});
  append(poses, points.front(), rotation, approach_feed);
  for (const Vec3& point : points) append(poses, point, rotation, feed);
  append(poses, points.back() + outwards * s.retract_mm.value_or(0) * units::mm, rotation, approach_feed);
  return poses;
}

}  // namespace

Vec3 tip_in_head(const ToolHead& head) {
  if (const auto* sphere = std::get_if<SphereHead>(&head.shape())) return {0, 0, -sphere->radius};
  return Vec3::Zero();
}

std::vector<Setting> settings_of(PathSettings& p) {
  const Range any = Range::any(), positive = Range::positive(), not_negative = Range::not_negative();
  return {
      choice("path.kind", "--path", p.kind,
             {{"line", Kind::line},
              {"circle", Kind::circle},
              {"spiral", Kind::spiral},
              {"cavity", Kind::cavity},
              {"poses", Kind::poses}},
             "how the tool moves"),
      choice("path.point", "--point", p.point, {{"tip", Point::tip}, {"head", Point::head}, {"handle", Point::handle}},
             "what the positions are of: the tip of the tool, the origin of the head (centre of a sphere), or, with "
             "poses only, the hand [tip]"),
      number("path.feed_mm_per_s", "--feed_mm_per_s", p.feed_mm_per_s, positive, "speed along the path"),
      number("path.approach_mm", "--approach_mm", p.approach_mm, not_negative,
             "distance along the tool axis from which the path is entered [0]"),
      number("path.approach_feed_mm_per_s", "--approach_feed_mm_per_s", p.approach_feed_mm_per_s, positive,
             "speed of approach and retract [the feed]"),
      number("path.retract_mm", "--retract_mm", p.retract_mm, not_negative,
             "distance along the tool axis to which the tool is pulled out at the end [0]"),
      vector("path.tool_axis", "--tool_axis", p.tool_axis, any, "direction from the tip to the shank [0,0,1]"),
      number("path.tool_roll_deg", "--tool_roll_deg", p.tool_roll_deg, any, "turn of the tool about its axis [0]"),
      vector("path.from_mm", "--from_mm", p.from_mm, any, "line: start"),
      vector("path.to_mm", "--to_mm", p.to_mm, any, "line: end"),
      vector("path.center_mm", "--center_mm", p.center_mm, any, "circle, spiral, cavity: centre"),
      vector("path.axis", "--axis", p.axis, any,
             "circle, spiral, cavity: normal of the curve, out of the material [the tool axis]"),
      number("path.circle_radius_mm", "--circle_radius_mm", p.radius_mm, positive, "circle: radius"),
      number("path.turns", "--turns", p.turns, positive, "circle: number of turns"),
      number("path.start_angle_deg", "--start_angle_deg", p.start_angle_deg, any, "circle: where it starts [0]"),
      number("path.start_radius_mm", "--start_radius_mm", p.start_radius_mm, not_negative, "spiral: first radius"),
      number("path.end_radius_mm", "--end_radius_mm", p.end_radius_mm, not_negative, "spiral: last radius"),
      number("path.pitch_mm", "--pitch_mm", p.pitch_mm, positive, "spiral, cavity: distance of neighbouring turns"),
      number("path.depth_mm", "--depth_mm", p.depth_mm, not_negative, "spiral, cavity: depth below the centre"),
      number("path.top_radius_mm", "--top_radius_mm", p.top_radius_mm, not_negative,
             "cavity: radius of the first layer"),
      number("path.bottom_radius_mm", "--bottom_radius_mm", p.bottom_radius_mm, not_negative,
             "cavity: radius of the last layer"),
      number("path.layer_mm", "--layer_mm", p.layer_mm, positive, "cavity: distance of neighbouring layers"),
      text("path.file", "--poses", p.file,
           "poses: a CSV file with the columns t_s, x_mm, y_mm, z_mm and, for the "
           "rotation, qw, qx, qy, qz or r00 ... r22"),
  };
}

Motion make_motion(const PathSettings& s, const Tool& tool) {
  if (!s.kind)
    throw Error(
        "the path is missing. Set --path to line, circle, spiral, cavity or poses, or kind under [path] in the "
        "settings file.");
  refuse_what_does_not_belong(s);
  const Point point = s.point.value_or(Point::tip);
  std::vector<TimedPose> poses;
  if (*s.kind == Kind::poses) {
    if (s.file.empty()) throw Error("path.file is missing; a path of poses needs it. Set --poses FILE.csv.");
    if (s.approach_mm || s.retract_mm || s.approach_feed_mm_per_s)
      throw Error(
          "path.approach_mm, approach_feed_mm_per_s and retract_mm belong to curves; put the way in and out "
          "into the file of poses.");
    poses = read_poses(s.file, orientation_of(s));
  } else {
    if (point == Point::handle)
      throw Error("path.point = handle goes with a path of poses only. Set path.point to tip or head.");
    poses = follow(s);
  }

  // From the named point to the frame of the head.
  Pose X_PT = Pose::from_translation(Vec3::Zero());
  if (point == Point::tip) X_PT.translation = -tip_in_head(tool.head());
  if (point == Point::handle) X_PT = tool.X_HT();
  for (TimedPose& timed : poses) timed.pose = timed.pose * X_PT;
  return Motion(std::move(poses));
}

}  // namespace hapticut::cli
