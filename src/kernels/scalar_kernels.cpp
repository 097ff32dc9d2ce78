// SPDX-License-Identifier: Apache-2.0
// What runs where Highway is not available: the scalar reference itself.
#include "hapticut/force/laws/foundation.hpp"
#include "kernels/kernels.hpp"

namespace hapticut::kernels {

void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept {
  head.visit_springs<float>(
      [&](const auto& springs) { hapticut::sample_contact(springs, block, grid, quadrature, out); });
}

LawTotals evaluate_foundation(const HeadMotion& motion, const ContactMaterials& materials,
                              ContactBlock& block) noexcept {
  return FoundationLaw::evaluate_scalar(motion, materials, block);
}

void sum_resultant(const ContactBlock& block, Resultant& total) noexcept { hapticut::sum_resultant(block, total); }

}  // namespace hapticut::kernels
