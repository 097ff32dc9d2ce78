// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "hapticut/workpiece/workpiece.hpp"

/// @file
/// The pool of a workpiece, so that a copy of a simulation reports the same free blocks.
namespace hapticut {

/// Number of free nodes of each kind, and the last count that was asked for.
struct ReservedNodes {
  std::size_t material_leaves = 0, fill_leaves = 0, fill_branches = 0, target = 0;
};

[[nodiscard]] ReservedNodes reserved_nodes(const Workpiece& workpiece);
void set_reserved_nodes(Workpiece& workpiece, const ReservedNodes& nodes);

}  // namespace hapticut
