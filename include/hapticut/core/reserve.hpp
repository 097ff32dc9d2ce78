// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace hapticut {

/// Reserves memory for `count` elements and touches all of it, so that filling the vector later causes no page fault.
/// `std::vector::reserve` alone does not prevent page faults. The vector is empty afterwards.
template <class Element>
void reserve_touched(std::vector<Element>& elements, std::size_t count) {
  elements.resize(count);
  elements.clear();
}

}  // namespace hapticut
