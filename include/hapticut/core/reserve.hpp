// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace hapticut {

/// Takes memory for `count` elements and touches all of it, so that filling the empty vector later meets no page fault,
/// as it may after `std::vector::reserve` alone.
template <class Element>
void reserve_touched(std::vector<Element>& elements, std::size_t count) {
  elements.resize(count);
  elements.clear();
}

}  // namespace hapticut
