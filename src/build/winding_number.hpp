// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// How often a surface winds around a point: 1 inside a closed surface, 0 outside, and in between where the surface has
/// holes, so that "more than one half" closes small holes by the smoothest surface.
///
///     w(q) = 1/(4 pi) sum over triangles of the solid angle under which q sees them
///
/// Triangles far from q are not visited one by one: a tree holds, for each group of triangles, the first two terms of
/// the expansion of the sum about the group's centre (after Barill, Dickson, Schmidt, Levin and Jacobson 2018, "Fast
/// winding numbers for soups and clouds"; here with the first and second moments of the area vectors).
class WindingNumber {
 public:
  using Triangle = std::array<Vec3, 3>;

  /// A surface that is inside out as a whole is turned round.
  explicit WindingNumber(const TriangleMesh& mesh);

  /// @return [1], within about 0.02 of the exact value
  [[nodiscard]] double at(const Vec3& point) const;

  /// Appends the triangles whose bounding boxes touch a box, in a fixed order.
  void append_touching(const Vec3& min, const Vec3& max, std::vector<const Triangle*>& found) const;

 private:
  struct Node {
    Vec3 min, max;               // [m] bounding box
    Vec3 center;                 // [m] of the areas
    double radius;               // [m] largest distance of a vertex from the centre
    Vec3 dipole;                 // [m^2] sum of area vectors
    Mat3 quadrupole;             // [m^3] sum of (triangle's centroid - centre) (area vector)^T, symmetrised
    std::uint32_t first, count;  // of triangles_, for a leaf; count 0 otherwise
    std::uint32_t second_child;  // the first child is the next node
  };
  void build(std::uint32_t first, std::uint32_t count);
  /// From the root to the children of each node of which `goes_on(node)` says so.
  template <class GoesOn>
  void descend(const GoesOn& goes_on) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace hapticut
