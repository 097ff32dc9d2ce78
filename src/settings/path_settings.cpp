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

using P = PathSettings;
using PathKind = P::Kind;
using K = PathKind;
using Point = P::Point;

const std::vector<std::pair<std::string, PathKind>>& kinds() {
  static const std::vector<std::pair<std::string, PathKind>> kKinds = {
      {"line", K::line}, {"circle", K::circle}, {"spiral", K::spiral}, {"cavity", K::cavity}, {"poses", K::poses}};
  return kKinds;
}

const std::string& name_of(PathKind kind) {
  return std::ranges::find(kinds(), kind, &std::pair<std::string, PathKind>::second)->first;
}

using NumberMember = std::optional<double> P::*;
using VectorMember = std::optional<Vec3> P::*;

/// A setting that belongs to some kinds of path.
struct PathField {
  std::string name;  // name of the key and of the flag
  std::variant<NumberMember, VectorMember> member;
  std::vector<PathKind> kinds;
  Range range;
  const char* meaning;
};

const std::vector<PathField>& path_fields() {
  const Range any = Range::any(), positive = Range::positive(), not_negative = Range::not_negative();
  const std::vector<PathKind> all = {K::line, K::circle, K::spiral, K::cavity},
                              round = {K::circle, K::spiral, K::cavity};
  static const std::vector<PathField> fields = {
      {"from_mm", &P::from_mm, {K::line}, any, "start of the line"},
      {"to_mm", &P::to_mm, {K::line}, any, "end of the line"},
      {"center_mm", &P::center_mm, round, any, "centre of the curve"},
      {"axis", &P::axis, round, any, "normal of the curve; points out of the material [the tool axis]"},
      {"feed_mm_per_s", &P::feed_mm_per_s, all, positive, "speed along the path"},
      {"approach_mm", &P::approach_mm, all, not_negative,
       "distance along the tool axis between the start of the motion and the path [0]"},
      {"approach_feed_mm_per_s", &P::approach_feed_mm_per_s, all, positive, "speed of approach and retract [the feed]"},
      {"retract_mm", &P::retract_mm, all, not_negative,
       "distance along the tool axis that the tool retracts at the end [0]"},
      {"circle_radius_mm", &P::radius_mm, {K::circle}, positive, "radius of the circle"},
      {"turns", &P::turns, {K::circle}, positive, "number of turns"},
      {"start_angle_deg", &P::start_angle_deg, {K::circle}, any, "angle where the circle starts [0]"},
      {"start_radius_mm", &P::start_radius_mm, {K::spiral}, not_negative, "first radius"},
      {"end_radius_mm", &P::end_radius_mm, {K::spiral}, not_negative, "last radius"},
      {"pitch_mm", &P::pitch_mm, {K::spiral, K::cavity}, positive, "distance between turns"},
      {"depth_mm", &P::depth_mm, {K::spiral, K::cavity}, not_negative, "depth below the centre"},
      {"top_radius_mm", &P::top_radius_mm, {K::cavity}, not_negative, "radius of the first layer"},
      {"bottom_radius_mm", &P::bottom_radius_mm, {K::cavity}, not_negative, "radius of the last layer"},
      {"layer_mm", &P::layer_mm, {K::cavity}, positive, "distance between layers"},
  };
  return fields;
}

/// "circle, spiral: radius"; without the kinds when only `poses` lacks the setting.
std::string meaning_of(const PathField& field) {
  if (field.kinds.size() + 1 == kinds().size()) return field.meaning;
  return joined(field.kinds, ", ", name_of) + ": " + field.meaning;
}

Setting setting_of(const PathField& f, PathSettings& p) {
  const std::string key = "path." + f.name, flag = "--" + f.name;
  if (const VectorMember* member = std::get_if<VectorMember>(&f.member))
    return vector(key, flag, p.**member, f.range, meaning_of(f));
  return number(key, flag, p.*std::get<NumberMember>(f.member), f.range, meaning_of(f));
}

/// The value of a setting.
/// @throws Error when it is missing
template <class Value>
const Value& need(const PathSettings& s, std::optional<Value> P::*member) {
  const auto is_this = [&](const PathField& field) {
    return field.member == std::variant<NumberMember, VectorMember>(member);
  };
  if (!(s.*member))
    fail_missing(Name("path." + std::find_if(path_fields().begin(), path_fields().end(), is_this)->name),
                 "a path of kind " + name_of(*s.kind));
  return *(s.*member);
}

void refuse_what_does_not_belong(const PathSettings& s) {
  const std::string owner = "a path of kind " + name_of(*s.kind);
  for (const PathField& field : path_fields()) {
    if (std::ranges::find(field.kinds, *s.kind) != field.kinds.end()) continue;
    const Sentence instead = *s.kind == K::poses
                                 ? "put it into the file of poses"
                                 : "choose " + "path.kind"_name + " " + joined(field.kinds, " or ", name_of);
    std::visit([&](const auto member) { refuse(s.*member, Name("path." + field.name), owner, instead); }, field.member);
  }
  if (*s.kind != K::poses && !s.file.empty())
    refuse(std::optional(s.file), "path.file"_name, owner, "choose " + "path.kind"_name + " poses");
}

std::vector<Vec3> curve_of(const PathSettings& s, const Vec3& tool_axis) {
  const PathKind kind = *s.kind;
  using units::mm;
  if (kind == K::line) return {need(s, &P::from_mm) * mm, need(s, &P::to_mm) * mm};
  const CurvePlane plane{need(s, &P::center_mm) * mm, s.axis.value_or(tool_axis)};
  if (!(plane.axis.norm() > 0))
    throw Error("path.axis"_name + " = 0 0 0; must have a length. Set it to 0,0,1, for example.");
  if (kind == K::circle)
    return circle(plane, need(s, &P::radius_mm) * mm, need(s, &P::turns), s.start_angle_deg.value_or(0) * units::deg);
  const double pitch = need(s, &P::pitch_mm) * mm, depth = need(s, &P::depth_mm) * mm;
  if (kind == K::spiral)
    return spiral(plane, need(s, &P::start_radius_mm) * mm, need(s, &P::end_radius_mm) * mm, pitch, depth);
  return cavity(plane, {need(s, &P::top_radius_mm) * mm, need(s, &P::bottom_radius_mm) * mm, depth,
                        need(s, &P::layer_mm) * mm, pitch});
}

Mat3 orientation_of(const PathSettings& s) {
  const Vec3 axis = s.tool_axis.value_or(Vec3::UnitZ());
  if (!(axis.norm() > 0))
    throw Error("path.tool_axis"_name + " = 0 0 0; must have a length. Set it to 0,0,1, for example.");
  const double roll = s.tool_roll_deg.value_or(0) * units::deg;
  return CurvePlane{Vec3::Zero(), axis}.frame().rotation * rotation_from_vector(Vec3(0, 0, roll));
}

/// Adds a straight line to the motion.
void append(std::vector<TimedPose>& motion, const Vec3& target, const Mat3& rotation, double feed) {
  const double length = (target - motion.back().pose.translation).norm();
  if (length > 1e-12) motion.push_back({motion.back().t + length / feed, {rotation, target}});
}

std::vector<TimedPose> follow(const PathSettings& s) {
  const Mat3 rotation = orientation_of(s);
  const Vec3 outwards = rotation.col(2);
  const double feed = need(s, &P::feed_mm_per_s) * units::mm_per_s;
  const double approach_feed = s.approach_feed_mm_per_s ? *s.approach_feed_mm_per_s * units::mm_per_s : feed;
  const std::vector<Vec3> points = curve_of(s, outwards);

  std::vector<TimedPose> motion;
  motion.push_back({0, {rotation, points.front() + outwards * s.approach_mm.value_or(0) * units::mm}});
  append(motion, points.front(), rotation, approach_feed);
  for (const Vec3& point : points) append(motion, point, rotation, feed);
  append(motion, points.back() + outwards * s.retract_mm.value_or(0) * units::mm, rotation, approach_feed);
  return motion;
}

}  // namespace

std::vector<Setting> settings_of(PathSettings& p) {
  std::vector<Setting> settings = {
      choice("path.kind", "--path", p.kind, kinds(), "shape of the path of the tool"),
      choice("path.point", "--point", p.point, {{"tip", Point::tip}, {"head", Point::head}, {"handle", Point::handle}},
             "point of the tool that follows the path: its tip, the origin of the head (centre of a sphere), or the "
             "hand (poses only) [tip]"),
      vector("path.tool_axis", "--tool_axis", p.tool_axis, Range::any(), "direction from the tip to the shank [0,0,1]"),
      number("path.tool_roll_deg", "--tool_roll_deg", p.tool_roll_deg, Range::any(),
             "rotation of the tool about its axis [0]"),
  };
  for (const PathField& field : path_fields()) settings.push_back(setting_of(field, p));
  settings.push_back(path(
      "path.file", "--poses", p.file,
      "poses: CSV file with the columns t_s, x_mm, y_mm, z_mm and, for the rotation, qw, qx, qy, qz or r00 ... r22"));
  return settings;
}

Motion make_motion(const PathSettings& s, const Tool& tool) {
  if (!s.kind)
    throw Error("path.kind"_name + " is missing. Set " + "path.kind"_name +
                " to line, circle, spiral, cavity or poses.");
  refuse_what_does_not_belong(s);
  const Point point = s.point.value_or(Point::tip);
  std::vector<TimedPose> motion;
  if (*s.kind == K::poses) {
    if (s.file.empty()) fail_missing("path.file"_name, "a path of poses");
    motion = read_poses(s.file, orientation_of(s));
  } else {
    if (point == Point::handle)
      throw Error("path.point"_name + " = handle is possible only for a path of poses. Set it to tip or head.");
    motion = follow(s);
  }

  // Pose of the head relative to the chosen point.
  Pose X_PT = Pose::from_translation(Vec3::Zero());
  if (point == Point::tip) X_PT.translation = -Vec3(0, 0, tool.head().tip());
  if (point == Point::handle) X_PT = tool.X_HT();
  for (TimedPose& timed : motion) timed.pose = timed.pose * X_PT;
  return Motion(std::move(motion));
}

}  // namespace hapticut::settings
