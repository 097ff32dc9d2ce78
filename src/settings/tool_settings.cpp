// SPDX-License-Identifier: Apache-2.0
#include "settings/tool_settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hapticut/core/units.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "settings/profile_file.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

using Head = ToolSettings::Head;
using HandleKind = ToolSettings::HandleKind;

using Number = std::optional<double> ToolSettings::*;

/// The numbers that describe heads, by their keys.
struct Dimension {
  const char* key;
  Number value;
};
constexpr Dimension kRadius{"tool.radius_mm", &ToolSettings::radius_mm},
    kHeight{"tool.height_mm", &ToolSettings::height_mm},
    kHalfAngle{"tool.half_angle_deg", &ToolSettings::half_angle_deg},
    kDiameter{"tool.diameter_mm", &ToolSettings::diameter_mm}, kLength{"tool.length_mm", &ToolSettings::length_mm},
    kTip{"tool.tip_diameter_mm", &ToolSettings::tip_diameter_mm},
    kNeck{"tool.neck_diameter_mm", &ToolSettings::neck_diameter_mm},
    kShank{"tool.shank_diameter_mm", &ToolSettings::shank_diameter_mm},
    kWidest{"tool.widest_height_mm", &ToolSettings::widest_height_mm},
    kPointAngle{"tool.point_angle_deg", &ToolSettings::point_angle_deg};
constexpr std::array kDimensions = {kRadius, kHeight, kHalfAngle, kDiameter, kLength,
                                    kTip,    kNeck,   kShank,     kWidest,   kPointAngle};

/// What one kind of head is called and needs, and how it is made.
struct HeadKind {
  Head head;
  const char* name;
  const char* owner;  // in messages
  std::vector<Dimension> needs;
  std::vector<Dimension> may_have;
  ToolHead (*make)(const ToolSettings& s);
};

/// @throws Error that names the file, whether it cannot be read or its profile is no head
ToolHead head_of_profile(const std::string& file) {
  try {
    return ProfileHead(read_profile(file));
  } catch (const Error& error) {
    const std::string reason = error.what();
    if (reason.find(file) != std::string::npos) throw;
    throw Error(file + ": " + reason);
  }
}

double mm_of(const std::optional<double>& value) { return *value * units::mm; }

const std::vector<HeadKind>& head_kinds() {
  static const std::vector<HeadKind> kinds = {
      {Head::sphere,
       "sphere",
       "a sphere",
       {kRadius},
       {},
       [](const ToolSettings& s) -> ToolHead { return SphereHead{mm_of(s.radius_mm)}; }},
      {Head::cone,
       "cone",
       "a cone, given by angle and height,",
       {kHalfAngle, kHeight},
       {},
       [](const ToolSettings& s) -> ToolHead {
         return ConeHead{*s.half_angle_deg * units::deg, mm_of(s.height_mm)};
       }},
      {Head::flat,
       "flat",
       "a flat head",
       {kRadius, kHeight},
       {},
       [](const ToolSettings& s) -> ToolHead {
         return FlatHead{mm_of(s.radius_mm), mm_of(s.height_mm), s.flat_rule.value_or(FlatRule::nearest)};
       }},
      {Head::profile,
       "profile",
       "a head of a profile",
       {},
       {},
       [](const ToolSettings& s) { return head_of_profile(s.profile); }},
      {Head::round,
       "round",
       "a round head",
       {kDiameter},
       {},
       [](const ToolSettings& s) { return round_head(mm_of(s.diameter_mm)); }},
      {Head::inverted_cone,
       "inverted_cone",
       "an inverted cone",
       {kTip, kNeck, kLength},
       {},
       [](const ToolSettings& s) {
         return inverted_cone_head(mm_of(s.tip_diameter_mm), mm_of(s.neck_diameter_mm), mm_of(s.length_mm));
       }},
      {Head::cylinder,
       "cylinder",
       "a cylinder",
       {kDiameter, kLength},
       {},
       [](const ToolSettings& s) { return cylinder_head(mm_of(s.diameter_mm), mm_of(s.length_mm)); }},
      {Head::round_end_cylinder,
       "round_end_cylinder",
       "a round-end cylinder",
       {kDiameter, kLength},
       {},
       [](const ToolSettings& s) { return round_end_cylinder_head(mm_of(s.diameter_mm), mm_of(s.length_mm)); }},
      {Head::tapered,
       "tapered",
       "a tapered head",
       {kTip, kDiameter, kLength},
       {},
       [](const ToolSettings& s) {
         return tapered_head(mm_of(s.tip_diameter_mm), mm_of(s.diameter_mm), mm_of(s.length_mm));
       }},
      {Head::round_end_tapered,
       "round_end_tapered",
       "a round-end tapered head",
       {kTip, kDiameter, kLength},
       {},
       [](const ToolSettings& s) {
         return round_end_tapered_head(mm_of(s.tip_diameter_mm), mm_of(s.diameter_mm), mm_of(s.length_mm));
       }},
      {Head::needle,
       "needle",
       "a needle",
       {kDiameter, kLength},
       {},
       [](const ToolSettings& s) { return needle_head(mm_of(s.diameter_mm), mm_of(s.length_mm)); }},
      {Head::flame,
       "flame",
       "a flame",
       {kDiameter, kLength, kNeck, kWidest},
       {},
       [](const ToolSettings& s) {
         return flame_head(mm_of(s.diameter_mm), mm_of(s.length_mm), mm_of(s.neck_diameter_mm),
                           mm_of(s.widest_height_mm));
       }},
      {Head::pear,
       "pear",
       "a pear",
       {kDiameter, kLength, kNeck},
       {},
       [](const ToolSettings& s) {
         return pear_head(mm_of(s.diameter_mm), mm_of(s.length_mm), mm_of(s.neck_diameter_mm));
       }},
      {Head::wheel,
       "wheel",
       "a wheel",
       {kDiameter, kLength, kShank},
       {},
       [](const ToolSettings& s) {
         return wheel_head(mm_of(s.diameter_mm), mm_of(s.length_mm), mm_of(s.shank_diameter_mm));
       }},
      {Head::christmas_tree,
       "christmas_tree",
       "a christmas tree",
       {kDiameter, kLength},
       {},
       [](const ToolSettings& s) {
         return christmas_tree_head(mm_of(s.diameter_mm), mm_of(s.length_mm), int(s.tiers));
       }},
      {Head::twist_drill,
       "twist_drill",
       "a twist drill",
       {kDiameter, kLength},
       {kPointAngle},
       [](const ToolSettings& s) {
         return twist_drill_head(mm_of(s.diameter_mm), mm_of(s.length_mm),
                                 s.point_angle_deg.value_or(118) * units::deg);
       }}};
  return kinds;
}

bool holds(const std::vector<Dimension>& dimensions, const Dimension& d) {
  return std::any_of(dimensions.begin(), dimensions.end(),
                     [&](const Dimension& other) { return other.value == d.value; });
}

/// The heads that have a dimension: "choose --head cone or flat".
std::string heads_with(const Dimension& d) {
  std::string names;
  for (const HeadKind& kind : head_kinds())
    if (holds(kind.needs, d) || holds(kind.may_have, d))
      names += (names.empty() ? "" : " or ") + std::string(kind.name);
  return "choose --head " + names;
}

ToolHead make_head(const ToolSettings& s) {
  if (!s.head)
    throw Error(
        "the head of the tool is missing. Set --head to sphere, cone, flat, profile or a name of the catalogue, or "
        "head under "
        "[tool] in the settings file.");
  const HeadKind& kind =
      *std::find_if(head_kinds().begin(), head_kinds().end(), [&](const HeadKind& k) { return k.head == *s.head; });
  for (const Dimension& d : kDimensions)
    if (!holds(kind.needs, d) && !holds(kind.may_have, d)) refuse(s.*d.value, d.key, kind.owner, heads_with(d));
  for (const Dimension& d : kind.needs) (void)required(s.*d.value, d.key, kind.owner);
  const auto tiers = s.tiers > 0 ? std::optional(double(s.tiers)) : std::nullopt;
  if (kind.head == Head::christmas_tree) (void)required(tiers, "tool.tiers", kind.owner);
  if (kind.head != Head::christmas_tree) refuse(tiers, "tool.tiers", kind.owner, "choose --head christmas_tree");
  if (kind.head != Head::flat) refuse(s.flat_rule, "tool.flat_rule", kind.owner, "choose --head flat");
  if (kind.head == Head::profile && s.profile.empty()) fail_missing("tool.profile", kind.owner);
  if (kind.head != Head::profile && !s.profile.empty())
    refuse(std::optional(s.profile), "tool.profile", kind.owner, "choose --head profile");
  return kind.make(s);
}

std::vector<std::pair<std::string, Head>> names_of_heads() {
  std::vector<std::pair<std::string, Head>> names;
  for (const HeadKind& kind : head_kinds()) names.emplace_back(kind.name, kind.head);
  return names;
}

Handle make_handle(const ToolSettings& s) {
  if (s.handle.value_or(HandleKind::ray) == HandleKind::ray) {
    refuse(s.handle_neck_mm, "tool.handle_neck_mm", "a ray handle", "choose --handle L");
    refuse(s.handle_bend_deg, "tool.handle_bend_deg", "a ray handle", "choose --handle L");
    if (s.handle) (void)required(s.handle_length_mm, "tool.handle_length_mm", "a ray handle");
    return RayHandle{s.handle_length_mm.value_or(0) * units::mm};
  }
  return LHandle{required(s.handle_length_mm, "tool.handle_length_mm", "an L handle") * units::mm,
                 required(s.handle_neck_mm, "tool.handle_neck_mm", "an L handle") * units::mm,
                 s.handle_bend_deg.value_or(90) * units::deg};
}

}  // namespace

std::vector<Setting> settings_of(ToolSettings& t) {
  return {
      choice("tool.head", "--head", t.head, names_of_heads(), "shape of the cutting head; docs/heads.md draws them"),
      number("tool.radius_mm", "--radius_mm", t.radius_mm, Range::positive(), "radius of a sphere or flat head"),
      number("tool.height_mm", "--height_mm", t.height_mm, Range::positive(), "height of a cone or flat head"),
      number("tool.half_angle_deg", "--half_angle_deg", t.half_angle_deg, Range{0, 90, true},
             "angle of a cone between axis and side"),
      choice("tool.flat_rule", "--flat_rule", t.flat_rule, "which surface of a flat head carries the spring [nearest]"),
      number("tool.diameter_mm", "--diameter_mm", t.diameter_mm, Range::positive(),
             "largest diameter of a head of the catalogue"),
      number("tool.length_mm", "--length_mm", t.length_mm, Range::positive(),
             "length of a head of the catalogue, thickness of a wheel"),
      number("tool.tip_diameter_mm", "--tip_diameter_mm", t.tip_diameter_mm, Range::positive(),
             "diameter at the tip of an inverted_cone, tapered or round_end_tapered head"),
      number("tool.neck_diameter_mm", "--neck_diameter_mm", t.neck_diameter_mm, Range::positive(),
             "diameter at the shank of an inverted_cone, flame or pear"),
      number("tool.shank_diameter_mm", "--shank_diameter_mm", t.shank_diameter_mm, Range::positive(),
             "of a wheel: what of its upper face does not cut"),
      number("tool.widest_height_mm", "--widest_height_mm", t.widest_height_mm, Range::positive(),
             "of a flame: from the tip to its widest place"),
      integer("tool.tiers", "--tiers", t.tiers, 1, 20, "of a christmas_tree: number of cones"),
      number("tool.point_angle_deg", "--point_angle_deg", t.point_angle_deg, Range{0, 180, true},
             "of a twist_drill: full angle of its point [118]"),
      path("tool.profile", "--profile", t.profile,
           "of a head of kind profile: CSV file of its meridian, or a mesh of revolution in mm (glTF in m), shank "
           "towards +z"),
      choice("tool.shank", "--shank", t.shank, "what holds the head and may lean on the workpiece [nothing]"),
      number("tool.shank_neck_mm", "--shank_neck_mm", t.shank_neck_mm, Range::positive(),
             "diameter of the neck between head and shank"),
      choice(
          "tool.handle", "--handle", t.handle, {{"ray", HandleKind::ray}, {"L", HandleKind::angled}},
          "straight (ray) or angled (L) handpiece [ray where it has a length; else none, and the hand is at the head]"),
      number("tool.handle_length_mm", "--handle_length_mm", t.handle_length_mm, Range::not_negative(),
             "from the hand to the head, or to the elbow of an L"),
      number("tool.handle_neck_mm", "--handle_neck_mm", t.handle_neck_mm, Range::not_negative(),
             "L handle: from the elbow to the head"),
      number("tool.handle_bend_deg", "--handle_bend_deg", t.handle_bend_deg, Range::between(-180, 180),
             "L handle: between stylus and spindle axis [90]"),
      number("tool.spindle_rpm", "--spindle_rpm", t.spindle_rpm, Range::between(-1e6, 1e6),
             "spindle speed, positive counter-clockwise seen from the shank; 0: stands, nothing is cut"),
      choice("tool.motor", "--motor", t.motor,
             "what turns the spindle and how it yields to a load [air_turbine above 200000 rpm, electric below]"),
      number("tool.power_limit_W", "--power_limit_W", t.power_limit_W, Range::positive(),
             "power of the spindle, above which it slows down [of the motor]"),
      number("tool.torque_limit_Nmm", "--torque_limit_Nmm", t.torque_limit_Nmm, Range::positive(),
             "torque of the spindle, above which it stalls [of the motor]"),
      number("tool.rotor_inertia_gmm2", "--rotor_inertia_gmm2", t.rotor_inertia_gmm2, Range::not_negative(),
             "moment of inertia of all that turns, as the head turns [of the motor]"),
      number("tool.acceleration_rpm_per_s", "--acceleration_rpm_per_s", t.acceleration_rpm_per_s, Range::positive(),
             "how fast the spindle recovers its speed after a load [at once]"),
      number("tool.droop_rpm_per_Nmm", "--droop_rpm_per_Nmm", t.droop_rpm_per_Nmm, Range::not_negative(),
             "speed that the spindle loses per load torque, as an air turbine does [of the motor]"),
      choice("tool.cutter", "--cutter", t.cutter,
             "what the head cuts with [twist_drill of a twist drill, carbide_bur of others]"),
      integer("tool.lips", "--lips", t.lips, 1, 1000, "cutting edges that pass a place in a turn [as common cutters]"),
  };
}

namespace {

Spindle make_spindle(const ToolSettings& s) {
  const double rpm = required(s.spindle_rpm, "tool.spindle_rpm", "every tool");
  const MotorKind motor = s.motor.value_or(common_motor(rpm * units::rpm));
  const double fastest = fastest_speed(motor);
  if (std::abs(rpm) * units::rpm > fastest)
    throw Error("tool.spindle_rpm = " + format_number(rpm) + "; must be at most " +
                format_number(fastest / units::rpm) + " with the motor " + std::string(name_or_null(motor)) +
                ". Lower it, or choose another --motor.");
  if (rpm == 0 && motor != MotorKind::ideal)
    refuse(s.motor, "tool.motor", "a spindle that stands", "give --spindle_rpm");
  return common_spindle(motor, rpm * units::rpm);
}

}  // namespace

Tool make_tool(const ToolSettings& s) {
  ToolHead head = make_head(s);
  if (s.shank)
    head = on_shank(head,
                    standard_shank(*s.shank, required(s.shank_neck_mm, "tool.shank_neck_mm", "a shank") * units::mm));
  else
    refuse(s.shank_neck_mm, "tool.shank_neck_mm", "a head without a shank", "choose --shank");
  Handle handle = make_handle(s);
  Spindle spindle = make_spindle(s);
  if (s.power_limit_W) spindle.power_limit = *s.power_limit_W;
  if (s.acceleration_rpm_per_s) spindle.acceleration_limit = *s.acceleration_rpm_per_s * units::rpm;
  if (s.torque_limit_Nmm) spindle.torque_limit = *s.torque_limit_Nmm * units::N_mm;
  if (s.rotor_inertia_gmm2) spindle.rotor_inertia = *s.rotor_inertia_gmm2 * 1e-9;
  if (s.droop_rpm_per_Nmm) spindle.droop = *s.droop_rpm_per_Nmm * units::rpm / units::N_mm;
  const Cutter cutter{s.cutter.value_or(usual_cutter(head).kind), int(s.lips)};
  return Tool(std::move(head), std::move(handle), spindle, cutter);
}

}  // namespace hapticut::settings
