// SPDX-License-Identifier: Apache-2.0
// Which controls of a page do nothing at present, and why.
#include <algorithm>
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "page/session/material_numbers.hpp"
#include "page/session/view_controls.hpp"

namespace hapticut::apps {
namespace {

constexpr double kHandSpeed = 5e-3;  // [m/s] speed of a careful hand
constexpr double kFelt = 0.01;       // [1] smallest part of the force that a hand feels
constexpr double kFeltInACut = 0.1;  // [1] chi v that changes the force of a cut, mostly its energy, by 1 %

}  // namespace

void ViewControls::tell_idle_ones() {
  for (view::Control& control : controls_) control.idle = why_idle(control.id);
}

/// Whether the chosen head has a dimension for which `is` is true.
bool ViewControls::head_has(bool (*is)(const HeadShape::Dimension&)) const {
  const auto chosen = std::size_t(at(kHead));
  return chosen != 0 && std::ranges::any_of(head_shapes()[chosen - 1].dimensions, is);
}

std::string ViewControls::why_idle(std::uint16_t id) const {
  const auto unless = [](bool acts, const char* why) { return std::string(acts ? "" : why); };
  if (id >= kMaterial) {
    const int place = id - kMaterial;
    const MaterialTable now = materials();
    return why_idle(kMaterialNumbers[place % kIdsOfAMaterial].member, now[MaterialId(place / kIdsOfAMaterial + 1)]);
  }
  if (id >= kGravity && id < kHeat && id != kSound && id != kVolume && !haptics()) return "haptics is off";
  const bool is_of_scene = at(kHead) == 0;
  switch (id) {
    case kRemoval:
      if (dynamic_cast<const ThesisLaw*>(config_.law.get()) != nullptr) return "the law of the thesis removes by power";
      if (!config_.law->is_foundation()) return "the law of this scene has its own";
      return unless(at(kCutting) != 0, "cutting is off");
    case kSpeed:
    case kPower:
      return unless(at(kSpindle) != 0, "the spindle is off");
    case kDiameter:
      return unless(!is_of_scene, "choose a head first");
    case kLength:
      return is_of_scene ? "choose a head first" : unless(head_has(is_height), "this head has no length");
    case kAngle:
      return is_of_scene ? "choose a head first" : unless(head_has(is_cone_angle), "this head has no angle");
    case kNeck:
    case kBend:
      return unless(at(kHandle) != 0, "only an L has one");
    case kMass:
      return unless(at(kGravity) != 0, "gravity is off");
    case kVolume:
      return unless(sound(), "the sound is off");
    case kLoosePieces:
      return unless(!recording(), "loose pieces stay in a recording");
    case kWater:
      return unless(beside().heat, "the heat is off");
    case kIrrigation:
      return beside().heat ? unless(at(kWater) != 0, "the water is off") : "the heat is off";
    case kDelta:
    case kEpsilon:
      return unless(at(kFilter) != 0, "the filter is off");
    case kFrequency:
    case kAmplitude:
    case kPerWatt:
    case kMaxAmplitude:
      return unless(at(kVibration) != 0, "vibration is off");
    default:
      return "";
  }
}

std::string ViewControls::why_idle(double Material::*number, const Material& material) const {
  const bool spins = at(kSpindle) != 0 && at(kSpeed) != 0;
  if (number == &Material::static_friction || number == &Material::dynamic_friction) {
    if (config_.friction)
      return "this scene has one friction for all, " + format_number(config_.friction->static_friction);
    return spins ? "only while the spindle stands" : "";
  }
  const bool is_thesis = dynamic_cast<const ThesisLaw*>(config_.law.get()) != nullptr;
  if (number == &Material::relative_stiffness)
    return config_.law->is_foundation() || is_thesis ? "" : "the law of this scene has its own";
  if (number == &Material::damping && (config_.law->is_foundation() || is_thesis)) {
    const double others = 1 + config_.contact_damping.value_or(0) * kHandSpeed;
    const bool cuts = !is_thesis && spins && at(kCutting) != 0;
    const double felt = cuts ? kFeltInACut : kFelt * others;
    return material.damping * kHandSpeed < felt ? "at 5 mm/s less than 1 % of the force" : "";
  }
  if (!config_.law->is_foundation())
    return is_thesis ? "not in the law of the thesis" : "the law of this scene has its own";
  if (!spins) return "only while the spindle turns";
  if (number == &Material::specific_cutting_energy && at(kCutting) == 0) return "cutting is off";
  return "";
}

}  // namespace hapticut::apps
