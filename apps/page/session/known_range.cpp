// SPDX-License-Identifier: Apache-2.0
#include "page/session/known_range.hpp"

#include <algorithm>

#include "hapticut/core/description.hpp"
#include "hapticut/tool/cutter.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/preset_constants.hpp"

namespace hapticut::apps {

KnownRange known_range(const Material& material, const MaterialNumber& number) {
  KnownRange known;
  if (std::ranges::find(preset_names(), material.name) == preset_names().end()) return known;
  const CutterKind cutter = material.cutter.value_or(CutterKind::carbide_bur);
  std::string_view name;
  for_each_number<Material>([&](const auto& field) {
    if (field.member == number.member) name = field.name;
  });
  const PresetConstant* row = constant_of(material.name, name_or_null(cutter), name);
  if (row == nullptr) return known;
  const Material typical = find_preset(material.name, cutter);
  // A cutting energy is the product of two rows, and both are at the same end.
  const PresetConstant* share = find_constant(material.name, "share");
  const bool has_share = share != nullptr && number.member == &Material::specific_cutting_energy;
  const auto at = [&](Estimate estimate) {
    const Material other = has_share ? typical.with(estimate) : typical.with(estimate, name);
    return other.*number.member / number.factor;
  };
  known = {at(Estimate::low), typical.*number.member / number.factor, at(Estimate::high), std::string(row->source)};
  if (has_share) known.source.append("; times the share of ").append(material.name).append(": ").append(share->source);
  return known;
}

}  // namespace hapticut::apps
