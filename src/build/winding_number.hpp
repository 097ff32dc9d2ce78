// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hapticut/core/mesh.hpp"

namespace hapticut {

/// The number of times that a surface winds around a point: 1 inside a closed surface, 0 outside, and in between near
/// holes. The set "more than one half" closes small holes by the smoothest surface.
///
///     w(q) = 1/(4 pi) sum over triangles of the solid angle under which q sees them
///
/// Triangles far from q are not visited one by one: a tree stores, for each group of triangles, the first two terms of
/// the expansion of the sum about the centre of the group (after Barill, Dickson, Schmidt, Levin and Jacobson 2018,
/// "Fast winding numbers for soups and clouds"; here with the first and second moments of the area vectors).
class WindingNumber {
 public:
  using Triangle = std::array<Vec3, 3>;

  /// If the whole surface is inside out, it is flipped.
  explicit WindingNumber(const TriangleMesh& mesh);

  /// Whether the surface was inside out, and has been flipped.
  [[nodiscard]] bool is_turned() const { return turned_; }

  /// @return [1], within about 0.02 of the exact value
  [[nodiscard]] double at(const Vec3& point) const;

  /// Appends the triangles whose bounding boxes touch a box, in a fixed order.
  void append_touching(const Vec3& min, const Vec3& max, std::vector<const Triangle*>& found) const;

 private:
  struct Node {
    Vec3 min, max;               // [m] bounding box
    Vec3 center;                 // [m] mean of the centroids, weighted by area
    double radius;               // [m] largest distance of a vertex from the centre
    Vec3 dipole;                 // [m^2] sum of area vectors
    Mat3 quadrupole;             // [m^3] sum of (triangle's centroid - centre) (area vector)^T, symmetrised
    std::uint32_t first, count;  // range in triangles_, for a leaf; count 0 otherwise
    std::uint32_t second_child;  // the first child is the next node
  };
  void build(std::uint32_t first, std::uint32_t count);
  /// Visits the nodes from the root; visits the children of a node if `descends(node)` returns true.
  template <class Descends>
  void descend(const Descends& descends) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
  bool turned_ = false;
};

}  // namespace hapticut
