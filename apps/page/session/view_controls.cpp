// SPDX-License-Identifier: Apache-2.0
#include "page/session/view_controls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/heat/heat_field.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "page/session/known_range.hpp"
#include "page/session/material_numbers.hpp"
#include "page/session/watched_model.hpp"

namespace hapticut::apps {
namespace {

std::string names_of_heads() {
  std::string names = "of the scene";
  for (const HeadShape& shape : head_shapes()) names += std::string("|") + shape.name;
  return names;
}

constexpr double kMaxWatts = 1000;
constexpr double kSpray = 3000;  // [W/(m^2 K)]
constexpr Range kIrrigations = slider_range(&HeatConfig::irrigation, Range::between(0, 20000));
constexpr const char* kAxisNames[] = {"force x", "force y", "force z", "torque x", "torque y", "torque z"};

}  // namespace

ViewControls::ViewControls(const Tool& tool, const MaterialTable& materials, const SimulationConfig& config,
                           bool can_record, const BesideTheStep& beside)
    : materials_(materials), config_(config), tool_(tool) {
  add_application(tool, can_record, beside.loose_pieces);
  add_tool(tool);
  add_heat(beside);
  add_materials();
  add_additional(config.effects);
  tell_idle_ones();
}

void ViewControls::number(std::uint16_t id, const std::string& panel, const std::string& label, const std::string& unit,
                          double value, double min, double max) {
  using Kind = view::Control::Kind;
  // A scene may exceed the range of the control; changing another control must not change the value.
  controls_.push_back({id, Kind::number, value, std::min(min, value), std::max(max, value), panel, label, unit});
}

void ViewControls::on_off(std::uint16_t id, const std::string& panel, const std::string& label, bool value) {
  controls_.push_back({id, view::Control::Kind::on_off, value ? 1.0 : 0.0, 0, 1, panel, label, ""});
}

void ViewControls::add_application(const Tool& tool, bool can_record, bool removes_loose_pieces) {
  using Kind = view::Control::Kind;
  on_off(kHaptics, "application", "Haptics", true);
  on_off(kCutting, "application", "Cutting", true);
  on_off(kSpindle, "application", "Spindle", tool.spindle().speed != 0);
  controls_.push_back(
      {kRemoval, Kind::choice, 0, 0, 1, "application", "Removal", "", "constant_energy|elastic_release"});
  on_off(kLoosePieces, "application", "Remove loose pieces", removes_loose_pieces);
  if (can_record) on_off(kRecord, "application", "Record", false);
  controls_.push_back({kReset, Kind::button, 1, 0, 1, "application", "Reset", ""});
  controls_.push_back({kRestart, Kind::button, 1, 0, 1, "application", "Restart", ""});
}

void ViewControls::add_tool(const Tool& tool) {
  using Kind = view::Control::Kind;
  const HeadBox box = tool.head().bounding_box();
  controls_.push_back({kHead, Kind::choice, 0, 0, double(head_shapes().size()), "tool", "Head", "", names_of_heads()});
  number(kDiameter, "tool", "Diameter", "mm", 2 * tool.head().max_radius() / units::mm, 0.2, 30);
  number(kLength, "tool", "Length", "mm", (box.max.z() - box.min.z()) / units::mm, 0.2, 60);
  number(kAngle, "tool", "Cone angle", "°", 30, 1, 80);
  const double rpm = std::abs(tool.spindle().speed) / units::rpm;
  number(kSpeed, "tool", "Speed", "rpm", rpm > 0 ? rpm : 40000, 0, 500000);
  number(kPower, "tool", "Power limit", "W", std::min(tool.spindle().power_limit, kMaxWatts), 0.1, kMaxWatts);
  const auto* bent = std::get_if<LHandle>(&tool.handle());
  const double length = bent != nullptr ? bent->length : std::get<RayHandle>(tool.handle()).length;
  controls_.push_back({kHandle, Kind::choice, bent != nullptr ? 1.0 : 0.0, 0, 1, "tool", "Handle", "", "ray|L"});
  number(kHandleLength, "tool", "Handle length", "mm", length / units::mm, 0, 300);
  number(kNeck, "tool", "Neck", "mm", bent != nullptr ? bent->neck / units::mm : 15, 0, 100);
  number(kBend, "tool", "Bend", "°", bent != nullptr ? bent->bend / units::deg : 90, -180, 180);
}

void ViewControls::add_heat(const BesideTheStep& beside) {
  on_off(kHeat, "heat", "Heat", beside.heat);
  on_off(kWater, "heat", "Water", beside.irrigation > 0);
  number(kIrrigation, "heat", "Irrigation", "W/(m² K)", beside.irrigation > 0 ? beside.irrigation : kSpray,
         kIrrigations.low, kIrrigations.high);
}

void ViewControls::add_materials() {
  for (int n = 0; n < std::min(materials_.size(), kShownMaterials); ++n) {
    const Material& material = materials_[MaterialId(n + 1)];
    std::string name = material.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    auto id = std::uint16_t(kMaterial + kIdsOfAMaterial * n);
    for (const MaterialNumber& one : kMaterialNumbers) {
      const KnownRange known = known_range(material, one);
      const bool has = !known.source.empty();
      number(id++, "material", name + " " + one.label, one.unit, material.*one.member / one.factor,
             has ? std::min(one.range().low, known.low) : one.range().low,
             has ? std::max(one.range().high, known.high) : one.range().high);
      view::Control& control = controls_.back();
      control.low = known.low, control.typical = known.typical, control.high = known.high;
      control.source = known.source;
    }
  }
}

template <class Effect, std::size_t kCount>
void ViewControls::add_numbers(const char* panel, const EffectNumber<Effect> (&numbers)[kCount], const Effect& effect) {
  for (const EffectNumber<Effect>& one : numbers)
    number(one.id, panel, one.label, std::string(one.unit()), effect.*one.member, one.range().low, one.range().high);
}

template <class Effect, std::size_t kCount>
void ViewControls::show_numbers(const EffectNumber<Effect> (&numbers)[kCount], const Effect& effect) {
  for (const EffectNumber<Effect>& one : numbers) at(one.id) = effect.*one.member;
}

template <class Effect, std::size_t kCount>
Effect ViewControls::with_numbers(const EffectNumber<Effect> (&numbers)[kCount], Effect effect) const {
  for (const EffectNumber<Effect>& one : numbers) effect.*one.member = at(one.id);
  return effect;
}

void ViewControls::add_additional(const Effects& effects) {
  Vibration vibration = effects.vibration.value_or(Vibration{});
  vibration.max_amplitude = std::max(vibration.max_amplitude, vibration.amplitude);
  on_off(kGravity, "additional", "Gravity", effects.gravity.has_value());
  add_numbers("additional", kGravityNumbers, effects.gravity.value_or(Gravity{.mass = 0.1}));
  on_off(kSound, "additional", "Sound of the drill", true);
  number(kVolume, "additional", "Volume", "", 0.5, 0, 1);
  on_off(kFilter, "additional", "Filter", effects.delta_filter.has_value());
  add_numbers("additional", kFilterNumbers, effects.delta_filter.value_or(DeltaFilter{}));
  on_off(kVibration, "vibration", "Vibration", effects.vibration.has_value());
  add_numbers("vibration", kVibrationNumbers, vibration);
  for (std::uint16_t axis = 0; axis < 6; ++axis)
    on_off(std::uint16_t(kMask + axis), "outputs", kAxisNames[axis],
           axis < 3 ? effects.enabled.force[axis] : effects.enabled.torque[axis - 3U]);
}

double& ViewControls::at(std::uint16_t id) {
  static double nowhere = 0;
  const auto found = std::ranges::find(controls_, id, &view::Control::id);
  return found == controls_.end() ? nowhere = 0 : found->value;
}

double ViewControls::at(std::uint16_t id) const {
  const auto found = std::ranges::find(controls_, id, &view::Control::id);
  return found == controls_.end() ? 0 : found->value;
}

Change ViewControls::change_of(std::uint16_t id) {
  if (id >= kMaterial) return Change::materials;
  if (id >= kHeat) return Change::heat;
  if (id >= kMask) return Change::effects;
  if (id >= kGravity) return id == kSound || id == kVolume ? Change::haptics : Change::effects;
  if (id == kSpeed || id == kSpindle) return Change::spindle;
  if (id >= kHead) return Change::tool;
  switch (id) {
    case kHaptics:
      return Change::effects;
    case kCutting:
    case kRemoval:
      return Change::removal;
    case kRecord:
      return Change::record;
    case kReset:
      return Change::reset;
    case kRestart:
      return Change::restart;
    case kLoosePieces:
      return Change::loose_pieces;
    default:
      return Change::none;
  }
}

Change ViewControls::set(const view::SetControl& command) {
  const auto found = std::ranges::find(controls_, command.id, &view::Control::id);
  if (found == controls_.end() || !(command.value >= found->min && command.value <= found->max)) return Change::none;
  if (found->kind != view::Control::Kind::number && command.value != std::floor(command.value)) return Change::none;
  const Change change = change_of(command.id);
  if (change == Change::materials) require_friction_order(command);
  before_ = controls_;
  if (found->kind == view::Control::Kind::button) return change;
  found->value = command.value;
  if (change == Change::materials) show(materials());
  tell_idle_ones();
  return change;
}

/// A higher dynamic friction raises the static one; a lower static friction is refused.
void ViewControls::require_friction_order(const view::SetControl& command) const {
  const int number = (command.id - kMaterial) % kIdsOfAMaterial;
  if (kMaterialNumbers[number].member != &Material::static_friction) return;
  static_assert(kMaterialNumbers[kDynamicFriction].member == &Material::dynamic_friction);
  const double dynamic = at(std::uint16_t(command.id - number + kDynamicFriction));
  if (command.value < dynamic)
    throw Error("the static friction must be at least the dynamic friction, " + format_number(dynamic) +
                "; lower the dynamic friction first.");
}

void ViewControls::show(const MaterialTable& materials) {
  for (int n = 0; n < std::min(materials.size(), kShownMaterials); ++n) {
    auto id = std::uint16_t(kMaterial + kIdsOfAMaterial * n);
    for (const MaterialNumber& one : kMaterialNumbers) at(id++) = materials[MaterialId(n + 1)].*one.member / one.factor;
  }
}

void ViewControls::show_recording(bool on) {
  at(kRecord) = on ? 1 : 0;
  tell_idle_ones();
}

void ViewControls::show_heat(bool on) {
  at(kHeat) = on ? 1 : 0;
  tell_idle_ones();
}

void ViewControls::set_spindle(double speed) {
  at(kSpindle) = speed != 0 ? 1 : 0;
  if (speed != 0) at(kSpeed) = std::min(std::abs(speed) / units::rpm, 500000.0);
}

void ViewControls::show(const ModelSettings& model) {
  set_spindle(model.spindle_speed);
  at(kCutting) = model.removal != RemovalLaw::none ? 1 : 0;
  if (model.removal != RemovalLaw::none) at(kRemoval) = model.removal == RemovalLaw::elastic_release ? 1 : 0;
  show(model.effects);
  tell_idle_ones();
}

void ViewControls::show(const Effects& effects) {
  at(kGravity) = effects.gravity ? 1 : 0;
  if (effects.gravity) show_numbers(kGravityNumbers, *effects.gravity);
  at(kFilter) = effects.delta_filter ? 1 : 0;
  if (effects.delta_filter) show_numbers(kFilterNumbers, *effects.delta_filter);
  at(kVibration) = effects.vibration ? 1 : 0;
  if (effects.vibration) show_numbers(kVibrationNumbers, *effects.vibration);
  const AxisMask& on = effects.enabled;
  const auto any = [](const auto& axes) { return std::ranges::any_of(axes, [](bool axis) { return axis; }); };
  at(kHaptics) = any(on.force) || any(on.torque) ? 1 : 0;
  if (!haptics()) return;  // the model does not know which axes the switch restores
  for (std::uint16_t axis = 0; axis < 3; ++axis) {
    at(std::uint16_t(kMask + axis)) = on.force[axis] ? 1 : 0;
    at(std::uint16_t(kMask + 3 + axis)) = on.torque[axis] ? 1 : 0;
  }
}

AngularSpeed ViewControls::spindle_speed() const { return (at(kSpindle) != 0 ? at(kSpeed) : 0) * units::rpm; }

RemovalLaw ViewControls::removal() const {
  if (at(kCutting) == 0) return RemovalLaw::none;
  return at(kRemoval) == 0 ? RemovalLaw::constant_energy : RemovalLaw::elastic_release;
}

BesideTheStep ViewControls::beside() const {
  return {at(kHeat) != 0, at(kWater) != 0 ? at(kIrrigation) : 0, at(kLoosePieces) != 0};
}

AxisMask ViewControls::mask() const {
  AxisMask mask;
  for (std::uint16_t axis = 0; axis < 3; ++axis) {
    mask.force[axis] = haptics() && at(std::uint16_t(kMask + axis)) != 0;
    mask.torque[axis] = haptics() && at(std::uint16_t(kMask + 3 + axis)) != 0;
  }
  return mask;
}

Effects ViewControls::effects() const {
  Effects effects = config_.effects;
  effects.gravity.reset(), effects.vibration.reset(), effects.delta_filter.reset();
  if (at(kGravity) != 0) effects.gravity = with_numbers(kGravityNumbers, config_.effects.gravity.value_or(Gravity{}));
  if (at(kVibration) != 0) {
    Vibration& vibration = effects.vibration.emplace(with_numbers(kVibrationNumbers, Vibration{}));
    vibration.max_amplitude = std::max(vibration.max_amplitude, vibration.amplitude);
  }
  if (at(kFilter) != 0) {
    DeltaFilter& filter = effects.delta_filter.emplace(with_numbers(kFilterNumbers, DeltaFilter{}));
    filter.epsilon = std::min(filter.epsilon, filter.delta);
  }
  effects.enabled = mask();
  return effects;
}

MaterialTable ViewControls::materials() const {
  std::vector<Material> changed;
  for (int n = 0; n < materials_.size(); ++n) {
    Material& material = changed.emplace_back(materials_[MaterialId(n + 1)]);
    if (n >= kShownMaterials) continue;
    auto id = std::uint16_t(kMaterial + kIdsOfAMaterial * n);
    for (const MaterialNumber& one : kMaterialNumbers) material.*one.member = at(id++) * one.factor;
    material.static_friction = std::max(material.static_friction, material.dynamic_friction);
  }
  return MaterialTable(std::move(changed));
}

/// Whether a dimension is set by the control of the length; other lengths follow that of the diameter.
bool ViewControls::is_height(const HeadShape::Dimension& dimension) {
  return dimension.what.name.ends_with("length") || dimension.what.name.ends_with("height");
}

/// Whether a dimension is set by the control of the cone angle; other angles, and numbers, keep their usual values.
bool ViewControls::is_cone_angle(const HeadShape::Dimension& dimension) { return dimension.what.name == "half_angle"; }

/// The usual head with the diameter, length and angle of the controls.
ToolHead ViewControls::head() const {
  const auto chosen = std::size_t(at(kHead));
  if (chosen == 0) return tool_.head();
  const HeadShape& shape = head_shapes()[chosen - 1];
  const ToolHead usual = shape.usual();
  const HeadBox box = usual.bounding_box();
  const double diameter = at(kDiameter) * units::mm, length = at(kLength) * units::mm;
  const auto value_of = [&](const HeadShape::Dimension& dimension) {
    if (is_cone_angle(dimension)) return at(kAngle) * units::deg;
    if (dimension.what.unit != "m") return dimension.usual;
    if (!is_height(dimension)) return dimension.usual / (2 * usual.max_radius()) * diameter;
    const double height = dimension.usual / (box.max.z() - box.min.z()) * length;
    return dimension.what.name == "widest_height" ? std::max(diameter / 2, height) : height;
  };
  std::vector<double> values;
  for (const HeadShape::Dimension& dimension : shape.dimensions) values.push_back(value_of(dimension));
  return shape.make(values);
}

Tool ViewControls::tool() const {
  const double length = at(kHandleLength) * units::mm;
  Handle handle = RayHandle{length};
  if (at(kHandle) != 0) handle = LHandle{length, at(kNeck) * units::mm, at(kBend) * units::deg};
  Spindle spindle = tool_.spindle();
  spindle.speed = spindle_speed();
  if (at(kPower) < kMaxWatts) spindle.power_limit = at(kPower);
  Cutter cutter = tool_.cutter();  // cutter kind of the scene's materials
  ToolHead its_head = head();
  if (at(kHead) != 0 && usual_cutter(its_head).kind == CutterKind::twist_drill)
    cutter.lips = lips_of({CutterKind::twist_drill});
  return Tool(std::move(its_head), handle, spindle, cutter);
}

}  // namespace hapticut::apps
