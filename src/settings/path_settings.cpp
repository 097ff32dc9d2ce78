// SPDX-License-Identifier: Apache-2.0
#include "settings/path_settings.hpp"

#include <algorithm>
#include <variant>

#include "hapticut/core/units.hpp"
#include "settings/curves.hpp"
#include "settings/pose_file.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

using PathKind = PathSettings::Kind;
using Point = PathSettings::Point;

const std::vector<std::pair<std::string, PathKind>>& kinds() {
  static const std::vector<std::pair<std::string, PathKind>> kKinds = {{"line", PathKind::line},
                                                                       {"circle", PathKind::circle},
                                                                       {"spiral", PathKind::spiral},
                                                                       {"cavity", PathKind::cavity},
                                                                       {"poses", PathKind::poses}};
  return kKinds;
}

const std::string& name_of(PathKind kind) {
  return std::find_if(kinds().begin(), kinds().end(), [&](const auto& known) { return known.second == kind; })->first;
}

/// A number or vector of some kinds of path.
template <class Value>
struct PathField {
  std::string name;  // of the key and of the flag
  std::optional<Value> PathSettings::*member;
  std::vector<PathKind> kinds;
  Range range;
  const char* meaning;
};

const std::vector<PathField<double>>& number_fields() {
  const Range any = Range::any(), positive = Range::positive(), not_negative = Range::not_negative();
  constexpr PathKind kLine = PathKind::line, kCircle = PathKind::circle, kSpiral = PathKind::spiral,
                     kCavity = PathKind::cavity;
  static const std::vector<PathField<double>> fields = {
      {"feed_mm_per_s",
       &PathSettings::feed_mm_per_s,
       {kLine, kCircle, kSpiral, kCavity},
       positive,
       "speed along the path"},
      {"approach_mm",
       &PathSettings::approach_mm,
       {kLine, kCircle, kSpiral, kCavity},
       not_negative,
       "distance along the tool axis from which the path is entered [0]"},
      {"approach_feed_mm_per_s",
       &PathSettings::approach_feed_mm_per_s,
       {kLine, kCircle, kSpiral, kCavity},
       positive,
       "speed of approach and retract [the feed]"},
      {"retract_mm",
       &PathSettings::retract_mm,
       {kLine, kCircle, kSpiral, kCavity},
       not_negative,
       "distance along the tool axis to which the tool is pulled out at the end [0]"},
      {"circle_radius_mm", &PathSettings::radius_mm, {kCircle}, positive, "radius"},
      {"turns", &PathSettings::turns, {kCircle}, positive, "number of turns"},
      {"start_angle_deg", &PathSettings::start_angle_deg, {kCircle}, any, "where it starts [0]"},
      {"start_radius_mm", &PathSettings::start_radius_mm, {kSpiral}, not_negative, "first radius"},
      {"end_radius_mm", &PathSettings::end_radius_mm, {kSpiral}, not_negative, "last radius"},
      {"pitch_mm", &PathSettings::pitch_mm, {kSpiral, kCavity}, positive, "distance of neighbouring turns"},
      {"depth_mm", &PathSettings::depth_mm, {kSpiral, kCavity}, not_negative, "depth below the centre"},
      {"top_radius_mm", &PathSettings::top_radius_mm, {kCavity}, not_negative, "radius of the first layer"},
      {"bottom_radius_mm", &PathSettings::bottom_radius_mm, {kCavity}, not_negative, "radius of the last layer"},
      {"layer_mm", &PathSettings::layer_mm, {kCavity}, positive, "distance of neighbouring layers"},
  };
  return fields;
}

const std::vector<PathField<Vec3>>& vector_fields() {
  const std::vector<PathKind> round = {PathKind::circle, PathKind::spiral, PathKind::cavity};
  static const std::vector<PathField<Vec3>> fields = {
      {"from_mm", &PathSettings::from_mm, {PathKind::line}, Range::any(), "start"},
      {"to_mm", &PathSettings::to_mm, {PathKind::line}, Range::any(), "end"},
      {"center_mm", &PathSettings::center_mm, round, Range::any(), "centre"},
      {"axis", &PathSettings::axis, round, Range::any(), "normal of the curve, out of the material [the tool axis]"},
  };
  return fields;
}

std::string joined(const std::vector<PathKind>& some, const std::string& separator) {
  std::string list;
  for (const PathKind kind : some) list += (list.empty() ? "" : separator) + name_of(kind);
  return list;
}

/// "circle, spiral: radius", or without the kinds when only poses are left out.
template <class Value>
std::string meaning_of(const PathField<Value>& field) {
  if (field.kinds.size() + 1 == kinds().size()) return field.meaning;
  return joined(field.kinds, ", ") + ": " + field.meaning;
}

template <class Value>
const Value& need(const std::optional<Value>& value, PathKind kind, const std::string& name) {
  if (!value)
    throw Error("path." + name + " is missing; a path of kind " + name_of(kind) + " needs it. Set --" + name + ", or " +
                name + " under [path] in the settings file.");
  return *value;
}

template <class Value>
void refuse_what_does_not_belong(const PathSettings& s, const std::vector<PathField<Value>>& fields) {
  for (const PathField<Value>& field : fields)
    if (s.*field.member && std::find(field.kinds.begin(), field.kinds.end(), *s.kind) == field.kinds.end())
      throw Error("path." + field.name + equals(*(s.*field.member)) + "; must be left out, because a path of kind " +
                  name_of(*s.kind) + " has none. " +
                  (*s.kind == PathKind::poses ? "Put it into the file of poses."
                                              : "Leave it out, or choose --path " + joined(field.kinds, " or ") + "."));
}

void refuse_what_does_not_belong(const PathSettings& s) {
  refuse_what_does_not_belong(s, number_fields());
  refuse_what_does_not_belong(s, vector_fields());
  if (!s.file.empty() && *s.kind != PathKind::poses)
    throw Error("path.file = \"" + s.file + "\"; must be left out, because a path of kind " + name_of(*s.kind) +
                " has none. Leave it out, or choose --path poses.");
}

std::vector<Vec3> curve_of(const PathSettings& s, const Vec3& tool_axis) {
  const PathKind kind = *s.kind;
  using units::mm;
  if (kind == PathKind::line) return {need(s.from_mm, kind, "from_mm") * mm, need(s.to_mm, kind, "to_mm") * mm};
  const CurvePlane plane{need(s.center_mm, kind, "center_mm") * mm, s.axis.value_or(tool_axis)};
  if (!(plane.axis.norm() > 0)) throw Error("path.axis = 0 0 0; must have a length. Set path.axis, e.g. 0,0,1.");
  if (kind == PathKind::circle)
    return circle(plane, need(s.radius_mm, kind, "circle_radius_mm") * mm, need(s.turns, kind, "turns"),
                  s.start_angle_deg.value_or(0) * units::deg);
  const double pitch = need(s.pitch_mm, kind, "pitch_mm") * mm, depth = need(s.depth_mm, kind, "depth_mm") * mm;
  if (kind == PathKind::spiral)
    return spiral(plane, need(s.start_radius_mm, kind, "start_radius_mm") * mm,
                  need(s.end_radius_mm, kind, "end_radius_mm") * mm, pitch, depth);
  return cavity(plane, {need(s.top_radius_mm, kind, "top_radius_mm") * mm,
                        need(s.bottom_radius_mm, kind, "bottom_radius_mm") * mm, depth,
                        need(s.layer_mm, kind, "layer_mm") * mm, pitch});
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
  const double feed = need(s.feed_mm_per_s, *s.kind, "feed_mm_per_s") * units::mm_per_s;
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
  std::vector<Setting> settings = {
      choice("path.kind", "--path", p.kind, kinds(), "how the tool moves"),
      choice("path.point", "--point", p.point, {{"tip", Point::tip}, {"head", Point::head}, {"handle", Point::handle}},
             "what the positions are of: the tip of the tool, the origin of the head (centre of a sphere), or, with "
             "poses only, the hand [tip]"),
      vector("path.tool_axis", "--tool_axis", p.tool_axis, Range::any(), "direction from the tip to the shank [0,0,1]"),
      number("path.tool_roll_deg", "--tool_roll_deg", p.tool_roll_deg, Range::any(),
             "turn of the tool about its axis [0]"),
  };
  for (const auto& f : vector_fields())
    settings.push_back(vector("path." + f.name, "--" + f.name, p.*f.member, f.range, meaning_of(f)));
  for (const auto& f : number_fields())
    settings.push_back(number("path." + f.name, "--" + f.name, p.*f.member, f.range, meaning_of(f)));
  settings.push_back(path("path.file", "--poses", p.file,
                          "poses: a CSV file with the columns t_s, x_mm, y_mm, z_mm and, for the rotation, qw, qx, "
                          "qy, qz or r00 ... r22"));
  return settings;
}

Motion make_motion(const PathSettings& s, const Tool& tool) {
  if (!s.kind)
    throw Error(
        "the path is missing. Set --path to line, circle, spiral, cavity or poses, or kind under [path] in the "
        "settings file.");
  refuse_what_does_not_belong(s);
  const Point point = s.point.value_or(Point::tip);
  std::vector<TimedPose> poses;
  if (*s.kind == PathKind::poses) {
    if (s.file.empty()) throw Error("path.file is missing; a path of poses needs it. Set --poses FILE.csv.");
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

}  // namespace hapticut::settings
