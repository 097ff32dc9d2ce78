// SPDX-License-Identifier: Apache-2.0
#include "hapticut/force/laws/foundation.hpp"

#include "kernels/kernels.hpp"

namespace hapticut {

LawTotals FoundationLaw::evaluate(const HeadMotion& motion, const ContactMaterials& materials,
                                  ContactBlock& block) const noexcept {
  return kernels::evaluate_foundation(motion, materials, block);
}

}  // namespace hapticut
