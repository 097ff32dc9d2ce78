// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "import/mesh/mesh_extensions.hpp"

/// @file
/// Recognizes files that have the extension of a mesh and contain something else.
namespace hapticut {

/// What a file is, and what to do, if its first bytes show another kind of file than its extension: "it is a ZIP
/// archive ...". Empty when they do not.
/// @param head  the first bytes of the file, 1000 or all
/// @param size  [bytes] of the file: a binary STL file shows itself only by its size
/// @param own   format of its extension
[[nodiscard]] std::string kind_unlike_extension(std::string_view head, std::uintmax_t size, const MeshFormat& own);

}  // namespace hapticut
