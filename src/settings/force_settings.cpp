// SPDX-License-Identifier: Apache-2.0
#include "settings/force_settings.hpp"

#include <algorithm>

#include "hapticut/core/units.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "settings/required.hpp"

namespace hapticut::settings {
namespace {

using Law = ForceSettings::Law;
using S = ForceSettings;

/// A constant of one force law.
struct Constant {
  const char* name;  // name of the key and of the flag
  std::optional<double> S::*value;
  Range range;
  std::string meaning;
  bool needed = false;
};

/// " [0.3]": the default value of a constant, in brackets.
std::string or_else(double usual) { return " [" + format_number(usual) + "]"; }

/// The constants of a law, and how the law is made.
struct LawKind {
  Law law;
  const char* owner;  // name in messages
  std::vector<Constant> constants;
  std::shared_ptr<const ForceLaw> (*make)(const S& s);
};

const std::vector<LawKind>& law_kinds() {
  using Pointer = std::shared_ptr<const ForceLaw>;
  static const ThesisLaw::Constants thesis;
  static const DampingMatrixLaw::Constants matrix;
  static const TwistDrillLaw::Constants drill;
  static const std::vector<LawKind> kinds = {
      {Law::foundation,
       "the foundation law",
       {},
       [](const S&) -> Pointer { return std::make_shared<FoundationLaw>(); }},
      {Law::thesis,
       "the law of the thesis",
       {{"thesis_voxel_mm", &S::thesis_voxel_mm, Range::positive(),
         "voxel size at which its force equals that of the foundation law" +
             or_else(thesis.reference_voxel_size / units::mm)},
        {"thesis_damping_Ns_per_m", &S::thesis_damping_Ns_per_m, Range::not_negative(),
         "damping coefficient of one voxel, on top of that of its material" + or_else(thesis.damping)},
        {"thesis_spin_torque", &S::thesis_spin_torque, Range::not_negative(),
         "lambda, ratio of the spin torque to normal force times radius" + or_else(thesis.spin_torque)},
        {"thesis_spin_exponent", &S::thesis_spin_exponent, Range::between(-10, 10),
         "exponent of the spindle speed in the spin torque" + or_else(thesis.spin_exponent)},
        {"thesis_cutting_force_N", &S::thesis_cutting_force_N, Range::not_negative(),
         "force at which a flat head of 1 mm radius with springs at its bottom begins to cut a material of relative "
         "stiffness 1, if no reference stiffness is set; 0: it removes what it touches" +
             or_else(thesis.cutting_force)},
        {"thesis_cutting_rpm", &S::thesis_cutting_rpm, Range::positive(),
         "speed at which this force is enough" + or_else(thesis.cutting_speed / units::rpm)}},
       [](const S& s) -> Pointer {
         ThesisLaw::Constants c;
         if (s.thesis_voxel_mm) c.reference_voxel_size = *s.thesis_voxel_mm * units::mm;
         c.damping = s.thesis_damping_Ns_per_m.value_or(c.damping);
         c.spin_torque = s.thesis_spin_torque.value_or(c.spin_torque);
         c.spin_exponent = s.thesis_spin_exponent.value_or(c.spin_exponent);
         c.cutting_force = s.thesis_cutting_force_N.value_or(c.cutting_force);
         if (s.thesis_cutting_rpm) c.cutting_speed = *s.thesis_cutting_rpm * units::rpm;
         return std::make_shared<ThesisLaw>(c);
       }},
      {Law::contact_mechanics,
       "the law of contact mechanics",
       {{"effective_modulus_Pa", &S::effective_modulus_Pa, Range::positive(),
         "effective modulus E/(1 - nu^2) of the material", true}},
       [](const S& s) -> Pointer { return std::make_shared<ContactMechanicsLaw>(*s.effective_modulus_Pa); }},
      {Law::hertzian_burr,
       "the law of the Hertzian burr",
       {{"burr_stiffness_Pa", &S::burr_stiffness_Pa, Range::positive(),
         "constant C1 of the elastic force C1 R^2 (h/R)^1.5", true}},
       [](const S& s) -> Pointer { return std::make_shared<HertzianBurrLaw>(*s.burr_stiffness_Pa); }},
      {Law::damping_matrix,
       "the law of the damping matrix",
       {{"resistance_Ns_per_m3", &S::resistance_Ns_per_m3, Range::positive(),
         "viscous resistance of the motion, per contact area" + or_else(matrix.resistance)},
        {"matrix_friction", &S::matrix_friction, Range::not_negative(),
         "ratio of the sideways force, caused by the spin, to the resistance" + or_else(matrix.friction)}},
       [](const S& s) -> Pointer {
         DampingMatrixLaw::Constants c;
         c.resistance = s.resistance_Ns_per_m3.value_or(c.resistance);
         c.friction = s.matrix_friction.value_or(c.friction);
         return std::make_shared<DampingMatrixLaw>(c);
       }},
      {Law::twist_drill,
       "the law of the twist drill",
       {{"chip_energy_J_per_m3", &S::chip_energy_J_per_m3, Range::positive(),
         "K_s, specific energy of the chips" + or_else(drill.specific_energy)},
        {"max_feed_per_revolution_mm", &S::max_feed_per_revolution_mm, Range::positive(),
         "feed per revolution above which thrust and torque stay constant" +
             or_else(drill.max_feed_per_revolution / units::mm)}},
       [](const S& s) -> Pointer {
         TwistDrillLaw::Constants c;
         c.specific_energy = s.chip_energy_J_per_m3.value_or(c.specific_energy);
         if (s.max_feed_per_revolution_mm) c.max_feed_per_revolution = *s.max_feed_per_revolution_mm * units::mm;
         return std::make_shared<TwistDrillLaw>(c);
       }}};
  return kinds;
}

std::string key_of(const Constant& constant) { return std::string("force.") + constant.name; }

/// Friction for all materials; nullopt when none of its constants is set.
std::optional<DryFriction> make_friction(const S& s) {
  if (!s.static_friction && !s.dynamic_friction && !s.tangential_stiffness_N_per_m) return std::nullopt;
  DryFriction friction;
  friction.static_friction = s.static_friction.value_or(s.dynamic_friction.value_or(friction.static_friction));
  friction.dynamic_friction = s.dynamic_friction.value_or(friction.static_friction);
  friction.tangential_stiffness = s.tangential_stiffness_N_per_m.value_or(friction.tangential_stiffness);
  require_at_most(friction.dynamic_friction, "force.dynamic_friction", friction.static_friction,
                  "force.static_friction");
  return friction;
}

}  // namespace

std::shared_ptr<const ForceLaw> make_law(const S& s) {
  const Law law = s.law.value_or(Law::foundation);
  const LawKind& chosen = *std::ranges::find(law_kinds(), law, &LawKind::law);
  for (const LawKind& kind : law_kinds())
    for (const Constant& constant : kind.constants) {
      if (&kind != &chosen)
        refuse(s.*constant.value, key_of(constant), chosen.owner,
               "choose " + "force.law"_name + " " + name_or_null(kind.law));
      if (&kind == &chosen && constant.needed) (void)required(s.*constant.value, key_of(constant), chosen.owner);
    }
  return chosen.make(s);
}

std::vector<Setting> law_settings_of(ForceSettings& s) {
  std::vector<Setting> all = {
      choice("force.law", "--law", s.law, "force law; docs/forces.md gives the formulas [foundation]")};
  for (const LawKind& kind : law_kinds())
    for (const Constant& c : kind.constants)
      all.push_back(number(key_of(c), std::string("--") + c.name, s.*c.value, c.range,
                           std::string("law ") + name_or_null(kind.law) + ": " + c.meaning));
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
    refuse(s.handle_torque_scale, "force.handle_torque_scale", "the full wrench",
           "choose " + "force.handle_torque"_name + " thesis");
  config.handle_torque_scale = s.handle_torque_scale.value_or(config.handle_torque_scale);
}

}  // namespace hapticut::settings
