// SPDX-License-Identifier: Apache-2.0
#include "surface/block_mesher.hpp"

#include <cmath>

namespace hapticut::surface {
namespace {

constexpr float kHalf = 0.5F;
constexpr int kCorners = kBlockEdge + 2;  // samples -1 ... 8
constexpr int kCells = kBlockEdge + 1;    // -1 ... 7
constexpr std::uint16_t kNoVertex = 0xffff;
constexpr unsigned kOwned = 0x1feU & ((1U << kCorners) - 1U);  // bits of the samples 0 ... 7

/// Which samples are inside: bit z + 1 of [x + 1][y + 1], each -1 ... 8.
using InsideRows = std::array<std::array<std::uint32_t, kCorners>, kCorners>;

InsideRows find_inside(const BlockSamples& samples) {
  InsideRows inside;
  for (int x = 0; x < kCorners; ++x)
    for (int y = 0; y < kCorners; ++y) {
      const float* row = &samples.fill[std::size_t(BlockSamples::at(x - 1, y - 1, -1))];
      std::uint32_t bits = 0;
      for (int z = 0; z < kCorners; ++z) bits |= std::uint32_t(row[z] >= kHalf ? 1 : 0) << z;
      inside[std::size_t(x)][std::size_t(y)] = bits;
    }
  return inside;
}

/// Mean of the points where the fill passes one half along the twelve edges of a cell.
std::array<float, 3> mean_crossing(const std::array<float, 8>& corner) {
  std::array<float, 3> sum = {0, 0, 0};
  float count = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned along = 4U >> axis;  // corner n is at (n >> 2, n >> 1 & 1, n & 1)
    for (unsigned low = 0; low < 8; ++low) {
      if ((low & along) != 0) continue;
      const float a = corner[low], b = corner[low | along];
      if ((a >= kHalf) == (b >= kHalf)) continue;
      for (unsigned other = 0; other < 3; ++other)
        sum[other] += other == axis ? (kHalf - a) / (b - a) : float(low >> (2 - other) & 1);
      count += 1;
    }
  }
  for (float& one : sum) one /= count;
  return sum;
}

/// A stencil like that of Youngs, (-1, 0, 1) along an axis and (1, a, 1) across it, interpolated between both ends of a
/// cell: weights of four samples. Youngs has a = 2; 2.4 halves the mean error on planes, because fills end at 0 and 1
/// (docs/decisions/0014-surface.md).
struct StencilWeights {
  static constexpr float kMiddle = 2.4F;
  std::array<float, 4> slope, smooth;

  explicit StencilWeights(float u)
      : slope{u - 1, -u, 1 - u, u}, smooth{1 - u, kMiddle * (1 - u) + u, (1 - u) + kMiddle * u, u} {}
};

/// Unit normal out of the material.
std::array<float, 3> normal_at(const BlockSamples& samples, const std::array<int, 3>& cell,
                               const std::array<float, 3>& in_cell) {
  const StencilWeights x(in_cell[0]), y(in_cell[1]), z(in_cell[2]);
  std::array<float, 3> sum = {0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    float smooth = 0, along_y = 0, along_z = 0;
    for (int j = 0; j < 4; ++j) {
      const float* row = &samples.fill[std::size_t(BlockSamples::at(cell[0] + i - 1, cell[1] + j - 1, cell[2] - 1))];
      float smooth_row = 0, slope_row = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        smooth_row += z.smooth[k] * row[k];
        slope_row += z.slope[k] * row[k];
      }
      smooth += y.smooth[std::size_t(j)] * smooth_row;
      along_y += y.slope[std::size_t(j)] * smooth_row;
      along_z += y.smooth[std::size_t(j)] * slope_row;
    }
    sum[0] -= x.slope[std::size_t(i)] * smooth;
    sum[1] -= x.smooth[std::size_t(i)] * along_y;
    sum[2] -= x.smooth[std::size_t(i)] * along_z;
  }
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  if (!(length > 1e-6F)) return {0, 0, 1};  // a plate thinner than the stencil sees both of its sides
  return {sum[0] / length, sum[1] / length, sum[2] / length};
}

/// Material of the sample nearest to the vertex, among the cell's corners that are inside.
MaterialId nearest_material(const BlockSamples& samples, const std::array<int, 3>& cell,
                            const std::array<float, 8>& corner, const std::array<float, 3>& in_cell) {
  MaterialId nearest = kEmpty;
  float min_distance = 4;
  for (unsigned n = 0; n < 8; ++n) {
    if (corner[n] < kHalf) continue;
    float distance = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const float d = in_cell[axis] - float(n >> (2 - axis) & 1);
      distance += d * d;
    }
    if (distance >= min_distance) continue;
    min_distance = distance;
    nearest = samples.material[std::size_t(
        BlockSamples::at(cell[0] + int(n >> 2), cell[1] + int(n >> 1 & 1), cell[2] + int(n & 1)))];
  }
  return nearest;
}

NetVertex vertex_of(const BlockSamples& samples, const std::array<int, 3>& cell) {
  std::array<float, 8> corner;
  for (int n = 0; n < 8; ++n)
    corner[std::size_t(n)] =
        samples.fill[std::size_t(BlockSamples::at(cell[0] + (n >> 2), cell[1] + (n >> 1 & 1), cell[2] + (n & 1)))];
  NetVertex vertex;
  vertex.cell = cell;
  vertex.in_cell = mean_crossing(corner);
  vertex.normal = normal_at(samples, cell, vertex.in_cell);
  vertex.material = nearest_material(samples, cell, corner, vertex.in_cell);
  return vertex;
}

/// Makes each vertex of the quadrilaterals once.
class NetBuilder {
 public:
  NetBuilder(const BlockSamples& samples, BlockNet& net) : samples_(samples), net_(net) { numbers_.fill(kNoVertex); }

  /// Adds a quadrilateral across the edge from sample `low` along an axis.
  /// @param leaves  the lower sample is inside
  void add_quad(const std::array<int, 3>& low, unsigned axis, bool leaves) {
    const unsigned b = (axis + 1) % 3, c = (axis + 2) % 3;
    std::array<std::uint16_t, 4> corner;  // counter-clockwise seen against the axis
    for (unsigned n = 0; n < 4; ++n) {
      std::array<int, 3> cell = low;
      if (n == 0 || n == 3) --cell[b];
      if (n < 2) --cell[c];
      corner[leaves ? n : 3 - n] = number_of(cell);
    }
    // Cut along the shorter diagonal, for better shaped triangles and a smoother picture.
    const unsigned first = squared_length(corner[0], corner[2]) <= squared_length(corner[1], corner[3]) ? 0 : 1;
    const auto at = [&](unsigned n) { return corner[(first + n) & 3]; };
    net_.triangles.push_back({at(0), at(1), at(2)});
    net_.triangles.push_back({at(0), at(2), at(3)});
  }

 private:
  std::uint16_t number_of(const std::array<int, 3>& cell) {
    const int at = ((cell[0] + 1) * kCells + cell[1] + 1) * kCells + cell[2] + 1;
    std::uint16_t& number = numbers_[std::size_t(at)];
    if (number == kNoVertex) {
      number = std::uint16_t(net_.vertices.size());
      net_.vertices.push_back(vertex_of(samples_, cell));
    }
    return number;
  }

  [[nodiscard]] float squared_length(std::uint16_t a, std::uint16_t b) const {
    const NetVertex &p = net_.vertices[a], &q = net_.vertices[b];
    float sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float d = float(p.cell[axis] - q.cell[axis]) + (p.in_cell[axis] - q.in_cell[axis]);
      sum += d * d;
    }
    return sum;
  }

  const BlockSamples& samples_;
  BlockNet& net_;
  std::array<std::uint16_t, std::size_t(kCells* kCells* kCells)> numbers_;
};

}  // namespace

void mesh_block(const BlockSamples& samples, BlockNet& net) {
  net.vertices.clear();
  net.triangles.clear();
  const InsideRows inside = find_inside(samples);
  NetBuilder builder(samples, net);
  for (int x = 0; x < kBlockEdge; ++x)
    for (int y = 0; y < kBlockEdge; ++y) {
      const std::size_t i = std::size_t(x) + 1, j = std::size_t(y) + 1;
      const std::uint32_t row = inside[i][j];
      const std::array<std::uint32_t, 3> changes = {(row ^ inside[i + 1][j]) & kOwned,
                                                    (row ^ inside[i][j + 1]) & kOwned, (row ^ row >> 1) & kOwned};
      for (unsigned axis = 0; axis < 3; ++axis)
        for (std::uint32_t bits = changes[axis]; bits != 0; bits &= bits - 1) {
          const int bit = std::countr_zero(bits);
          builder.add_quad({x, y, bit - 1}, axis, (row >> bit & 1) != 0);
        }
    }
}

}  // namespace hapticut::surface
