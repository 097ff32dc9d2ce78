// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace hapticut {

/// Reads the header of a PLY file and walks over its data: Assimp waits for ever for a header that never ends and
/// believes any number of elements.
/// @return what is wrong with it, as half a sentence; empty when it is complete
[[nodiscard]] std::string find_ply_damage(const std::string& bytes);

}  // namespace hapticut
