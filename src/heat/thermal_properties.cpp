// SPDX-License-Identifier: Apache-2.0
#include "hapticut/heat/thermal_properties.hpp"

#include <algorithm>
#include <array>

namespace hapticut {
namespace {

constexpr ThermalProperties kCortical = {0.55, 2.5e6}, kTrabecular = {0.29, 3.1e6};

constexpr std::array kKnown = {
    KnownThermalProperties{"cortical_bone", kCortical,
                           "k: Davidson and James, Med Eng Phys 22 (2000) 741 (bovine, 0.53 ... 0.58); rho c: 2000 "
                           "kg/m^3 times 1260 J/(kg K)"},
    KnownThermalProperties{"trabecular_bone", kTrabecular,
                           "Clattenburg, Cohen, Conner and Cook, J Biomed Mater Res 9 (1975) 169 (bovine, with its "
                           "marrow)"},
    KnownThermalProperties{
        "dentin", {0.58, 3.1e6}, "Brown, Dewey and Jacobs, J Dent Res 49 (1970) 752: k, and diffusivity 1.9e-7 m^2/s"},
    KnownThermalProperties{"enamel", {0.93, 2e6}, "likewise; diffusivity 4.7e-7 m^2/s"},
    KnownThermalProperties{"pulp", {0.6, 4.2e6}, "as water"},
    KnownThermalProperties{"caries", {0.58, 3.1e6}, "as dentin (assumed)"},
    KnownThermalProperties{
        "amalgam",
        {23, 2.4e6},
        "k: Craig and Peyton, J Dent Res 40 (1961) 411; rho c: 11600 kg/m^3 times 210 J/(kg K) (handbook values)"},
    KnownThermalProperties{"bone_d1", kCortical, "as cortical_bone (assumed)"},
    KnownThermalProperties{"bone_d2", kTrabecular, "as trabecular_bone (assumed)"},
    KnownThermalProperties{"bone_d3", kTrabecular, "as trabecular_bone (assumed)"},
    KnownThermalProperties{"bone_d4", kTrabecular, "as trabecular_bone (assumed)"},
    KnownThermalProperties{"bone_d5", kTrabecular, "as trabecular_bone (assumed)"},
    KnownThermalProperties{"clay", {0.7, 2e6}, "assumed, between oil and stone"},
};

}  // namespace

std::span<const KnownThermalProperties> known_thermal_properties() { return kKnown; }

ThermalProperties thermal_properties_of(std::string_view material) noexcept {
  const auto found = std::ranges::find(kKnown, material, &KnownThermalProperties::material);
  return found == kKnown.end() ? ThermalProperties{} : found->properties;
}

}  // namespace hapticut
