// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "hapticut/surface/surface_page.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// The surface of a workpiece that is being cut, page by page, beside the loop.
///
/// It has its own copy of the blocks, so that neither thread waits: the thread that meshes gives it changed blocks as
/// it receives them (`RealtimeLoop::receive`, `ChangeFeed::receive`), and takes the pages that have become others. Only
/// blocks that share a changed sample are meshed again. Whatever way the blocks have gone, the pages are byte by byte
/// those of a stream that is made of the workpiece as it is now.
///
/// Naive surface nets (Gibson, MICCAI 1998): one vertex in each cell of eight samples, at the mean of the points where
/// the filled fraction passes one half along the cell's edges; one quadrilateral across each such edge. Where two
/// pieces touch along an edge, diagonally from voxel to voxel, four triangles meet in it; else two. Normals are the
/// gradient of the fills by a stencil of 3 x 3 x 3 like that of Youngs (1984), interpolated to the vertex.
///
/// Memory: 4 bytes for each block of the bounds, 1.5 kB for one that is not uniform, 12 bytes a vertex and 2 an index;
/// so 4 kB for a block that a smooth surface crosses, and never more than 29 kB. `memory_bytes` tells.
///
/// Not thread-safe: one thread calls it.
class SurfaceStream {
 public:
  /// All pages with a surface wait to be taken. O(blocks); pages are meshed when they are taken.
  /// @throws Error when the workpiece spans more than 2^28 blocks
  explicit SurfaceStream(const Workpiece& workpiece);
  ~SurfaceStream();
  SurfaceStream(SurfaceStream&&) noexcept;
  SurfaceStream& operator=(SurfaceStream&&) noexcept;

  /// A block as it is now.
  /// @param origin          of its first voxel
  /// @param material, fill  [512] as of ChangedBlock
  /// @return false, and nothing has changed, when it lies outside of the bounds that the workpiece had in the beginning
  bool update(const VoxelIndex& origin, const MaterialId* material, const float* fill);

  /// The same for blocks of a workpiece, those that a step has changed.
  /// @return false when one of them lies outside
  bool update(const Workpiece& workpiece, std::span<const VoxelIndex> origins);

  /// Takes the page that waits nearest to the point looked at, meshed as it is now. A page whose surface came out as
  /// before is left out.
  /// @param page  overwritten; its memory is used again
  /// @return false when none waits
  bool next_page(SurfacePage& page);

  /// The point whose surroundings come first; without a call, the middle of the workpiece.
  /// @param p_WQ  [m] finite
  /// @throws Error when it is not finite
  void look_at(const Vec3& p_WQ);

  /// All pages that have a surface wait again: for another one who looks on.
  void resend();

  [[nodiscard]] const GridFrame& frame() const;
  [[nodiscard]] std::size_t waiting() const;          ///< pages that may have become others; none: all were taken
  [[nodiscard]] std::uint64_t blocks_meshed() const;  ///< since the beginning
  [[nodiscard]] std::size_t memory_bytes() const;     ///< of the copy and the meshes; O(pages)

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
