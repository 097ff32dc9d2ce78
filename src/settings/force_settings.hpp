// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/simulation/config.hpp"
#include "settings/given.hpp"
#include "settings/setting.hpp"

namespace hapticut::settings {

/// `[force]` of a settings file: the force law, its constants, and friction.
struct ForceSettings {
  enum class Law { foundation, thesis, contact_mechanics, hertzian_burr, damping_matrix, twist_drill };

  std::optional<Law> law;
  std::tuple<Given<ThesisLaw::Constants>, Given<ContactMechanicsLaw::Constants>, Given<HertzianBurrLaw::Constants>,
             Given<DampingMatrixLaw::Constants>, Given<TwistDrillLaw::Constants>>
      constants;
  // Terms added to the law.
  std::optional<double> static_friction, dynamic_friction, tangential_stiffness_N_per_m;
  bool deep_contact = true;
  std::optional<HandleTorque> handle_torque;
  std::optional<double> handle_torque_scale;
};

constexpr auto names_of(Of<ForceSettings::Law>) {
  using enum ForceSettings::Law;
  return std::array{Named{foundation, "foundation"},
                    Named{thesis, "thesis"},
                    Named{contact_mechanics, "contact_mechanics"},
                    Named{hertzian_burr, "hertzian_burr"},
                    Named{damping_matrix, "damping_matrix"},
                    Named{twist_drill, "twist_drill"}};
}

[[nodiscard]] std::vector<Setting> settings_of(ForceSettings& force);

/// Only the settings of the law and its constants.
[[nodiscard]] std::vector<Setting> law_settings_of(ForceSettings& force);

/// @throws Error when this law lacks a constant, or a constant of another law is set
[[nodiscard]] std::shared_ptr<const ForceLaw> make_law(const ForceSettings& settings);

/// Sets the law, friction, deep contact and the torque at the handle.
/// @throws Error when this law lacks a constant, a constant of another law is set, or a value is out of range
void apply(const ForceSettings& settings, SimulationConfig& config);

}  // namespace hapticut::settings
