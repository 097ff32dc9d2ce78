// SPDX-License-Identifier: Apache-2.0
#include "workpiece/reserved_nodes.hpp"

#include <algorithm>

#include "workpiece/state.hpp"

namespace hapticut {

ReservedNodes reserved_nodes(const Workpiece& workpiece) {
  const BlockPool& pool = WorkpieceAccess::pool(workpiece);
  return {pool.material_leaves.size(), pool.fill_leaves.size(), pool.fill_branches.size(), pool.target};
}

void set_reserved_nodes(Workpiece& workpiece, const ReservedNodes& nodes) {
  workpiece.reserve_blocks(std::max({nodes.material_leaves, nodes.fill_leaves, nodes.target}));
  BlockPool& pool = WorkpieceAccess::pool(workpiece);
  const auto shrink = [](auto& free, std::size_t count) { free.resize(std::min(free.size(), count)); };
  shrink(pool.material_leaves, nodes.material_leaves);
  shrink(pool.fill_leaves, nodes.fill_leaves);
  shrink(pool.fill_branches, nodes.fill_branches);
  pool.target = nodes.target;
}

}  // namespace hapticut
