// SPDX-License-Identifier: Apache-2.0
#include "settings/tool_settings.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "hapticut/core/units.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "io/file_errors.hpp"
#include "settings/profile_file.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

using HandleKind = ToolSettings::HandleKind;

/// @throws Error that names the file, when it cannot be read or its profile is not valid
ToolHead head_of_profile(const std::string& file) {
  try {
    return ProfileHead(read_profile(file));
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw Error(file + ": " + error.sentence());
  }
}

std::string key_of(const HeadDimension& dimension) { return key_of_dimension(dimension.name, dimension.unit); }

/// Names the heads that have a dimension: "choose tool.head cone or flat".
Sentence heads_with(const HeadDimension& dimension) {
  std::vector<std::string> names;
  for (const HeadShape& shape : head_shapes())
    if (shape.find(dimension.name) != nullptr) names.emplace_back(shape.name);
  return "choose " + "tool.head"_name + " " + joined(names, " or ");
}

/// "sphere, cone".
std::string words_of_shapes() {
  std::vector<std::string> words;
  for_each_shape([&]<class Shape>(Of<Shape>) { words.emplace_back(Shape::kWord); });
  return joined(words);
}

ToolHead make_head(const ToolSettings& s) {
  if (!s.head)
    throw Error("tool.head"_name + " is missing. Set " + "tool.head"_name + " to " + words_of_shapes() +
                " or a name of the catalogue.");
  const HeadShape* shape = *s.head;
  const char* owner = shape != nullptr ? shape->in_sentences : "a profile head";
  const bool is_flat = shape != nullptr && shape->name == std::string_view(FlatHead::kWord);
  for (const HeadDimension& one : head_dimensions())
    if (shape == nullptr || shape->find(one.name) == nullptr)
      refuse(s.dimension(one.name), Name(key_of(one)), owner, heads_with(one));
  if (!is_flat) refuse(s.flat_rule, "tool.flat_rule"_name, owner, "choose " + "tool.head"_name + " flat");
  if (shape == nullptr) {
    if (s.profile.empty()) fail_missing("tool.profile"_name, owner);
    return head_of_profile(s.profile);
  }
  if (!s.profile.empty())
    refuse(std::optional(s.profile), "tool.profile"_name, owner, "choose " + "tool.head"_name + " profile");
  std::vector<double> dimensions;
  for (const HeadShape::Dimension& needed : shape->dimensions) {
    const std::optional<double> given = s.dimension(needed.what.name);
    const double factor = shown_unit(needed.what.unit).factor;
    dimensions.push_back(given || !needed.optional ? required(given, Name(key_of(needed.what)), owner) * factor
                                                   : needed.usual);
  }
  if (is_flat) return FlatHead{dimensions[0], dimensions[1], s.flat_rule.value_or(FlatRule::nearest)};
  return shape->make(dimensions);
}

/// The heads that settings can name. A profile is not a shape of the catalogue, so it has no HeadShape.
std::vector<std::pair<std::string, const HeadShape*>> names_of_heads() {
  std::vector<std::pair<std::string, const HeadShape*>> names;
  for (const HeadShape& shape : head_shapes()) names.emplace_back(shape.name, &shape);
  names.emplace_back(ProfileHead::kWord, nullptr);
  return names;
}

/// Text of a dimension, with its default if it has one: "full angle of its point [118]".
std::string meaning_of(const HeadDimension& dimension) {
  std::string meaning(dimension.meaning);
  for (const HeadShape& shape : head_shapes())
    if (const auto* found = shape.find(dimension.name); found != nullptr && found->optional)
      meaning += " [" + format_number(found->usual / shown_unit(dimension.unit).factor) + "]";
  return meaning;
}

Setting setting_of(const HeadDimension& dimension, ToolSettings& t) {
  const std::string key = key_of(dimension), flag = "--" + key.substr(key.find('.') + 1);
  const double factor = shown_unit(dimension.unit).factor;
  Range shown = dimension.range;
  if (dimension.unit == std::string_view("m")) shown.high = std::min(shown.high, kMaxHeadReach);
  shown.low /= factor, shown.high /= factor;
  std::optional<double>& given = t.dimensions[dimension.name];
  if (dimension.is_whole) return integer(key, flag, given, shown.low, shown.high, meaning_of(dimension));
  return number(key, flag, given, shown, meaning_of(dimension));
}

Handle make_handle(const ToolSettings& s) {
  if (s.handle.value_or(HandleKind::ray) == HandleKind::ray) {
    refuse(s.handle_neck_mm, "tool.handle_neck_mm"_name, "a ray handle", "choose " + "tool.handle"_name + " L");
    refuse(s.handle_bend_deg, "tool.handle_bend_deg"_name, "a ray handle", "choose " + "tool.handle"_name + " L");
    if (s.handle) (void)required(s.handle_length_mm, "tool.handle_length_mm"_name, "a ray handle");
    return RayHandle{s.handle_length_mm.value_or(0) * units::mm};
  }
  return LHandle{required(s.handle_length_mm, "tool.handle_length_mm"_name, "an L handle") * units::mm,
                 required(s.handle_neck_mm, "tool.handle_neck_mm"_name, "an L handle") * units::mm,
                 s.handle_bend_deg.value_or(90) * units::deg};
}

}  // namespace

std::string key_of_dimension(std::string_view name, std::string_view unit) {
  const std::string shown = shown_unit(unit).name;
  return "tool." + std::string(name) + (shown.empty() ? "" : "_" + shown);
}

std::optional<double> ToolSettings::dimension(std::string_view name) const {
  const auto found = dimensions.find(name);
  return found == dimensions.end() ? std::nullopt : found->second;
}

void ToolSettings::set_sphere(double radius_mm) {
  head = &*std::ranges::find(head_shapes(), std::string_view(SphereHead::kWord), &HeadShape::name);
  dimensions["radius"] = radius_mm;
}

Setting cutter_setting(std::optional<CutterKind>& cutter, const std::string& standard) {
  return choice("tool.cutter", "--cutter", cutter,
                "kind of cutter, which the constants of presets depend on [" + standard + "]");
}

Setting sharpness_setting(std::optional<Sharpness>& sharpness) {
  return choice("tool.sharpness", "--sharpness", sharpness,
                "how worn the cutter is, which the constants of presets depend on [used]");
}

std::vector<Setting> settings_of(ToolSettings& t) {
  std::vector<Setting> settings = {choice("tool.head", "--head", t.head, names_of_heads(),
                                          "shape of the cutting head; docs/heads-and-materials.md shows the shapes")};
  settings.back().begin_anew = [&t] {
    for (auto& [name, given] : t.dimensions) given.reset();
    t.flat_rule.reset();
    t.profile.clear();
  };
  for (const HeadDimension& one : head_dimensions()) settings.push_back(setting_of(one, t));
  const Range up_to_a_handle = Range::between(0, kMaxHandleReach / units::mm);
  std::vector<Setting> others = {
      choice("tool.flat_rule", "--flat_rule", t.flat_rule,
             "surface of a flat head that determines depth and direction [nearest]"),
      path("tool.profile", "--profile", t.profile,
           "head profile: CSV file of the meridian, or a mesh of revolution in mm (glTF in m) with its shank towards "
           "+z"),
      choice("tool.shank", "--shank", t.shank, "shank that holds the head and can touch the workpiece [no shank]"),
      number("tool.shank_neck_mm", "--shank_neck_mm", t.shank_neck_mm, Range::positive(),
             "diameter of the neck between head and shank"),
      choice("tool.handle", "--handle", t.handle, {{"ray", HandleKind::ray}, {"L", HandleKind::angled}},
             "straight (ray) or angled (L) handpiece [ray with handle_length_mm; without it the hand is at the head]"),
      number("tool.handle_length_mm", "--handle_length_mm", t.handle_length_mm, up_to_a_handle,
             "distance from the hand to the head, or to the elbow of an L handle"),
      number("tool.handle_neck_mm", "--handle_neck_mm", t.handle_neck_mm, up_to_a_handle,
             "L handle: distance from the elbow to the head"),
      number("tool.handle_bend_deg", "--handle_bend_deg", t.handle_bend_deg, Range::between(-180, 180),
             "L handle: angle between stylus and spindle axis [90]"),
      number("tool.spindle_rpm", "--spindle_rpm", t.spindle_rpm, Range::between(-1e6, 1e6),
             "spindle speed, positive counter-clockwise seen from the shank; 0: the spindle stands still and does not "
             "cut"),
      choice("tool.motor", "--motor", t.motor,
             "motor of the spindle, which determines how load slows it down [air_turbine above 200000 rpm, else "
             "electric]"),
      number("tool.power_limit_W", "--power_limit_W", t.power_limit_W, Range::positive(),
             "power above which the spindle slows down [value of the motor]"),
      number("tool.torque_limit_Nmm", "--torque_limit_Nmm", t.torque_limit_Nmm, Range::positive(),
             "torque above which the spindle stalls [value of the motor]"),
      number("tool.rotor_inertia_gmm2", "--rotor_inertia_gmm2", t.rotor_inertia_gmm2, Range::not_negative(),
             "moment of inertia of all rotating parts, referred to the head [value of the motor]"),
      number("tool.acceleration_rpm_per_s", "--acceleration_rpm_per_s", t.acceleration_rpm_per_s, Range::positive(),
             "acceleration of the spindle after a load [immediate recovery]"),
      number("tool.droop_rpm_per_Nmm", "--droop_rpm_per_Nmm", t.droop_rpm_per_Nmm, Range::not_negative(),
             "speed drop per load torque, as in an air turbine [value of the motor]"),
      cutter_setting(t.cutter, "twist_drill for a twist drill, else carbide_bur"),
      sharpness_setting(t.sharpness),
      integer("tool.lips", "--lips", t.lips, 1, 1000,
              "number of cutting edges that pass a point per revolution [value of common cutters]"),
  };
  return together({std::move(settings), std::move(others)});
}

namespace {

Spindle make_spindle(const ToolSettings& s) {
  const double rpm = required(s.spindle_rpm, "tool.spindle_rpm"_name, "every tool");
  const MotorKind motor = s.motor.value_or(common_motor(rpm * units::rpm));
  const double limit = max_speed(motor);
  if (std::abs(rpm) * units::rpm > limit)
    throw Error("tool.spindle_rpm"_name + " = " + format_number(rpm, limit / units::rpm) + "; must be at most " +
                format_number(limit / units::rpm, rpm) + " with the motor " + std::string(name_or_null(motor)) +
                ". Lower the speed, or choose another " + "tool.motor"_name + ".");
  if (rpm == 0 && motor != MotorKind::ideal)
    refuse(s.motor, "tool.motor"_name, "a spindle at rest", "give " + "tool.spindle_rpm"_name);
  return common_spindle(motor, rpm * units::rpm);
}

}  // namespace

Tool make_tool(const ToolSettings& s) {
  ToolHead head = make_head(s);
  if (s.shank)
    head = on_shank(
        head, standard_shank(*s.shank, required(s.shank_neck_mm, "tool.shank_neck_mm"_name, "a shank") * units::mm));
  else
    refuse(s.shank_neck_mm, "tool.shank_neck_mm"_name, "a head without a shank", "choose " + "tool.shank"_name);
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
