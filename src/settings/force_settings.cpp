// SPDX-License-Identifier: Apache-2.0
#include "settings/force_settings.hpp"

#include <string>
#include <tuple>

#include "hapticut/force/laws/foundation.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

using Law = ForceSettings::Law;
using S = ForceSettings;

/// A law with constants.
template <class L>
struct LawKind {
  Law law;
  const char* owner;  // in messages
  Keys keys;          // of its constants
};

constexpr LawKind<ThesisLaw> kThesis{
    Law::thesis,
    "the law of the thesis",
    {"force", "thesis", {{"reference_voxel_size", "voxel"}, {"cutting_speed", "cutting"}}, "law thesis: "}};
constexpr LawKind<ContactMechanicsLaw> kContactMechanics{
    Law::contact_mechanics, "the law of contact mechanics", {"force", "", {}, "law contact_mechanics: "}};
constexpr LawKind<HertzianBurrLaw> kHertzianBurr{
    Law::hertzian_burr, "the law of the Hertzian burr", {"force", "burr", {}, "law hertzian_burr: "}};
constexpr LawKind<DampingMatrixLaw> kDampingMatrix{
    Law::damping_matrix,
    "the law of the damping matrix",
    {"force", "", {{"friction", "matrix_friction"}}, "law damping_matrix: "}};
constexpr LawKind<TwistDrillLaw> kTwistDrill{Law::twist_drill,
                                             "the law of the twist drill",
                                             {"force", "", {{"specific_energy", "chip_energy"}}, "law twist_drill: "}};

/// Calls `visit(kind, constants)` for each law with constants.
template <class Settings, class Visit>
void for_each_kind(Settings& s, const Visit& visit) {
  const auto visit_each = [&]<class... L>(const LawKind<L>&... kinds) {
    (visit(kinds, std::get<Given<typename L::Constants>>(s.constants)), ...);
  };
  visit_each(kThesis, kContactMechanics, kHertzianBurr, kDampingMatrix, kTwistDrill);
}

/// Friction for all materials; nullopt when none of its constants is set.
std::optional<DryFriction> make_friction(const S& s) {
  if (!s.static_friction && !s.dynamic_friction && !s.tangential_stiffness_N_per_m) return std::nullopt;
  DryFriction friction;
  friction.static_friction = s.static_friction.value_or(s.dynamic_friction.value_or(friction.static_friction));
  friction.dynamic_friction = s.dynamic_friction.value_or(friction.static_friction);
  friction.tangential_stiffness = s.tangential_stiffness_N_per_m.value_or(friction.tangential_stiffness);
  require_at_most(friction.dynamic_friction, "force.dynamic_friction"_name, friction.static_friction,
                  "force.static_friction"_name);
  return friction;
}

}  // namespace

std::shared_ptr<const ForceLaw> make_law(const S& s) {
  const Law law = s.law.value_or(Law::foundation);
  std::string owner = "the foundation law";
  for_each_kind(s, [&](const auto& kind, const auto&) {
    if (kind.law == law) owner = kind.owner;
  });
  std::shared_ptr<const ForceLaw> made;
  for_each_kind(s, [&]<class L>(const LawKind<L>& kind, const auto& constants) {
    if (kind.law == law)
      made = std::make_shared<L>(constants.make(kind.keys, owner));
    else
      constants.refuse(kind.keys, owner, "choose " + "force.law"_name + " " + name_or_null(kind.law));
  });
  return made != nullptr ? made : std::make_shared<FoundationLaw>();
}

std::vector<Setting> law_settings_of(ForceSettings& s) {
  std::vector<Setting> all = {
      choice("force.law", "--law", s.law, "force law; docs/forces.md gives the formulas [foundation]")};
  for_each_kind(s, [&](const auto& kind, auto& constants) { constants.add_settings(kind.keys, all); });
  return all;
}

std::vector<Setting> settings_of(ForceSettings& s) {
  return together(
      {law_settings_of(s),
       {
           number("force.static_friction", "--static_friction", s.static_friction,
                  range_of(&DryFriction::static_friction),
                  "static friction when the spindle stands still, for all materials [value of each material]"),
           number("force.dynamic_friction", "--dynamic_friction", s.dynamic_friction,
                  range_of(&DryFriction::dynamic_friction),
                  "dynamic friction when the spindle stands still, for all materials; not above the static one [static "
                  "friction]"),
           number("force.tangential_stiffness_N_per_m", "--tangential_stiffness_N_per_m",
                  s.tangential_stiffness_N_per_m, range_of(&DryFriction::tangential_stiffness),
                  "stiffness of the sticking anchor, for all materials; 0: equal to the normal stiffness of the "
                  "contact [0 when a friction coefficient is set here]"),
           boolean("force.deep_contact", "--deep_contact", s.deep_contact,
                   "a ball pressed deeper than its radius keeps pushing back [true]"),
           choice("force.handle_torque", "--handle_torque", s.handle_torque,
                  "torque at the hand: exact (full_wrench) or by the formulas of the thesis [full_wrench]"),
           number("force.handle_torque_scale", "--handle_torque_scale", s.handle_torque_scale, Range::any(),
                  "handle_torque thesis: constant zeta [1]"),
       }});
}

void apply(const ForceSettings& s, SimulationConfig& config) {
  config.law = make_law(s);
  config.friction = make_friction(s);
  config.deep_contact = s.deep_contact;
  config.handle_torque = s.handle_torque.value_or(config.handle_torque);
  if (config.handle_torque != HandleTorque::thesis)
    refuse(s.handle_torque_scale, "force.handle_torque_scale"_name, "the full wrench",
           "choose " + "force.handle_torque"_name + " thesis");
  config.handle_torque_scale = s.handle_torque_scale.value_or(config.handle_torque_scale);
}

}  // namespace hapticut::settings
