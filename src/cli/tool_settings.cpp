// SPDX-License-Identifier: Apache-2.0
#include "cli/tool_settings.hpp"

#include "hapticut/core/units.hpp"

namespace hapticut::cli {
namespace {

using Head = ToolSettings::Head;
using HandleKind = ToolSettings::HandleKind;

[[noreturn]] void fail_missing(const std::string& name, const std::string& owner) {
  throw Error("tool." + name + " is missing; " + owner + " needs it. Set --" + name + ", or " + name +
              " under [tool] in the settings file.");
}

double required(const std::optional<double>& value, const std::string& name, const std::string& owner) {
  if (!value) fail_missing(name, owner);
  return *value;
}

template <class Value>
void refuse(const std::optional<Value>& value, const std::string& name, const std::string& owner) {
  if (value) throw Error("tool." + name + " is set, but " + owner + " has none. Leave it out, or choose another.");
}

ToolHead make_head(const ToolSettings& s) {
  if (!s.head)
    throw Error(
        "the head of the tool is missing. Set --head to sphere, cone or flat, or head under [tool] in the "
        "settings file.");
  switch (*s.head) {
    case Head::sphere:
      refuse(s.height_mm, "height_mm", "a sphere");
      refuse(s.half_angle_deg, "half_angle_deg", "a sphere");
      refuse(s.flat_rule, "flat_rule", "a sphere");
      return SphereHead{required(s.radius_mm, "radius_mm", "a sphere") * units::mm};
    case Head::cone:
      refuse(s.radius_mm, "radius_mm", "a cone, given by angle and height,");
      refuse(s.flat_rule, "flat_rule", "a cone");
      return ConeHead{required(s.half_angle_deg, "half_angle_deg", "a cone") * units::deg,
                      required(s.height_mm, "height_mm", "a cone") * units::mm};
    case Head::flat:
      break;
  }
  refuse(s.half_angle_deg, "half_angle_deg", "a flat head");
  return FlatHead{required(s.radius_mm, "radius_mm", "a flat head") * units::mm,
                  required(s.height_mm, "height_mm", "a flat head") * units::mm,
                  s.flat_rule.value_or(FlatRule::nearest)};
}

Handle make_handle(const ToolSettings& s) {
  if (s.handle.value_or(HandleKind::ray) == HandleKind::ray) {
    refuse(s.handle_neck_mm, "handle_neck_mm", "a ray handle");
    refuse(s.handle_bend_deg, "handle_bend_deg", "a ray handle");
    return RayHandle{s.handle_length_mm.value_or(0) * units::mm};
  }
  return LHandle{required(s.handle_length_mm, "handle_length_mm", "an L handle") * units::mm,
                 required(s.handle_neck_mm, "handle_neck_mm", "an L handle") * units::mm,
                 s.handle_bend_deg.value_or(90) * units::deg};
}

}  // namespace

std::vector<Setting> settings_of(ToolSettings& t) {
  return {
      choice("tool.head", "--head", t.head, {{"sphere", Head::sphere}, {"cone", Head::cone}, {"flat", Head::flat}},
             "shape of the cutting head"),
      number("tool.radius_mm", "--radius_mm", t.radius_mm, Range::positive(), "radius of a sphere or flat head"),
      number("tool.height_mm", "--height_mm", t.height_mm, Range::positive(), "height of a cone or flat head"),
      number("tool.half_angle_deg", "--half_angle_deg", t.half_angle_deg, Range{0, 90, true},
             "angle of a cone between axis and side"),
      choice("tool.flat_rule", "--flat_rule", t.flat_rule,
             {{"nearest", FlatRule::nearest},
              {"bottom_only", FlatRule::bottom_only},
              {"side_only", FlatRule::side_only},
              {"both", FlatRule::both}},
             "which surface of a flat head carries the spring [nearest]"),
      choice("tool.handle", "--handle", t.handle, {{"ray", HandleKind::ray}, {"L", HandleKind::angled}},
             "straight (ray) or angled (L) handpiece [ray]"),
      number("tool.handle_length_mm", "--handle_length_mm", t.handle_length_mm, Range::not_negative(),
             "from the hand to the head, or to the elbow of an L [0 for a ray]"),
      number("tool.handle_neck_mm", "--handle_neck_mm", t.handle_neck_mm, Range::not_negative(),
             "L handle: from the elbow to the head"),
      number("tool.handle_bend_deg", "--handle_bend_deg", t.handle_bend_deg, Range::between(-180, 180),
             "L handle: between stylus and spindle axis [90]"),
      number("tool.spindle_rpm", "--spindle_rpm", t.spindle_rpm, Range::any(),
             "spindle speed, positive counter-clockwise seen from the shank; 0: stands, nothing is cut"),
      number("tool.power_limit_W", "--power_limit_W", t.power_limit_W, Range::positive(),
             "power of the spindle, above which it slows down [no limit]"),
  };
}

Tool make_tool(const ToolSettings& s) {
  ToolHead head = make_head(s);
  Handle handle = make_handle(s);
  const double rpm = required(s.spindle_rpm, "spindle_rpm", "every tool");
  Spindle spindle{rpm * units::rpm};
  if (s.power_limit_W) spindle.power_limit = *s.power_limit_W;
  return Tool(std::move(head), std::move(handle), spindle);
}

}  // namespace hapticut::cli
