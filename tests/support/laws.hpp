// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <typeindex>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/tool/catalogue.hpp"

/// @file
/// Every force law of the library, with a head that it has formulas for.
namespace hapticut::test {

struct NamedLaw {
  std::string name;
  std::shared_ptr<const ForceLaw> law;
  ToolHead head;
  bool always_loses = true;  // false: a spinning head may gain energy from one of its terms
};

/// The type of a law, whatever its constants.
inline std::type_index type_of(const ForceLaw& law) { return typeid(law); }

inline void PrintTo(const NamedLaw& named, std::ostream* out) { *out << named.name; }

inline std::vector<NamedLaw> all_laws() {
  using units::deg;
  using units::mm;
  const SphereHead ball{0.8 * mm};
  const ConeHead cone{40 * deg, 1.5 * mm};
  const FlatHead flat{0.8 * mm, 2 * mm};
  ThesisLaw::Constants thesis;
  thesis.cutting_speed = 2000 * units::rad_per_s;
  thesis.cutting_force = ThesisLaw::cutting_force_for(0.05 * mm, 0.8 * mm, 0.1 * mm);
  ThesisLaw::Constants damped_thesis = thesis;
  damped_thesis.damping = 1e-4;  // follows the hand and not the slip of the surface (D10)
  return {{"Foundation", std::make_shared<FoundationLaw>(), ball},
          {"FoundationOnACone", std::make_shared<FoundationLaw>(), cone},
          {"Thesis", std::make_shared<ThesisLaw>(thesis), ball},
          {"ThesisWithItsDamper", std::make_shared<ThesisLaw>(damped_thesis), ball, false},
          {"ThesisOnAFlat", std::make_shared<ThesisLaw>(thesis), flat},
          {"ContactMechanics", std::make_shared<ContactMechanicsLaw>(2e6), ball},
          {"ContactMechanicsOnACone", std::make_shared<ContactMechanicsLaw>(2e6), cone},
          {"ContactMechanicsOnAFlat", std::make_shared<ContactMechanicsLaw>(2e6), flat},
          {"HertzianBurr", std::make_shared<HertzianBurrLaw>(3e6), ball},
          {"DampingMatrix", std::make_shared<DampingMatrixLaw>(DampingMatrixLaw::Constants{3e8, 0.3}), ball},
          {"TwistDrill", std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{3e8}), cone},
          {"TwistDrillOnAFlat", std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{3e8}), flat},
          {"TwistDrillOfTheCatalogue", std::make_shared<TwistDrillLaw>(TwistDrillLaw::Constants{3e8}),
           twist_drill_head(1.6 * mm, 4 * mm)}};
}

}  // namespace hapticut::test
