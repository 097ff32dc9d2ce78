// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace hapticut {

inline constexpr std::size_t kStlHeader = 84;    ///< bytes of a binary STL file before its triangles
inline constexpr std::size_t kStlTriangle = 50;  ///< bytes of one triangle: normal, three vertices, two unused bytes

}  // namespace hapticut
