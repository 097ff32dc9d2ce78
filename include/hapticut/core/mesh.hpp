// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "hapticut/core/abi.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// A triangle mesh: a surface from a file, or the surface of a workpiece.
struct TriangleMesh {
  std::vector<Vec3> vertices;                           ///< [m] positions in W
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices, counter-clockwise seen from outside
};

/// A colour as stored in files: sRGB, 8 bits per channel.
struct Color {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
  [[nodiscard]] auto operator<=>(const Color&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

/// A triangle mesh with a colour per vertex.
struct ColoredMesh {
  TriangleMesh mesh;
  std::vector<Color> colors;  ///< one per vertex
};

}  // namespace hapticut
