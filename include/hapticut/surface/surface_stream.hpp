// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "hapticut/surface/surface_page.hpp"
#include "hapticut/workpiece/workpiece.hpp"

namespace hapticut {

/// The surface of a workpiece that is being cut, page by page, computed beside the loop.
///
/// It has its own copy of the blocks, so neither thread waits. The meshing thread passes it changed blocks as it
/// receives them (`RealtimeLoop::receive`, `ChangeFeed::receive`), and gets the changed pages. Only blocks that share a
/// changed sample are meshed again. The pages are byte by byte those of a new stream of the present workpiece, whatever
/// the history of the blocks.
///
/// Naive surface nets (Gibson, MICCAI 1998): one vertex in each cell of eight samples, at the mean of the points where
/// the filled fraction passes one half along the cell's edges; one quadrilateral across each such edge. Where two
/// pieces touch along an edge, diagonally from voxel to voxel, four triangles meet in it; else two. Normals are the
/// gradient of the fills by a stencil of 3 x 3 x 3 like that of Youngs (1984), interpolated to the vertex.
///
/// Memory: 4 bytes for each block of the bounds, 1.5 kB for each block that is not uniform, 12 bytes for each vertex
/// and 2 for each index. That is 4 kB for a block that a smooth surface crosses, and never more than 29 kB.
/// `memory_bytes` returns the total.
///
/// Not thread-safe: one thread calls it.
class SurfaceStream {
 public:
  /// All pages with a surface are waiting. O(blocks); pages are meshed when `next_page` returns them.
  /// @throws Error when the workpiece spans more than 2^28 blocks
  explicit SurfaceStream(const Workpiece& workpiece);
  ~SurfaceStream();
  SurfaceStream(SurfaceStream&&) noexcept;
  SurfaceStream& operator=(SurfaceStream&&) noexcept;

  /// Updates a block to its present content.
  /// @param origin          its first voxel
  /// @param material, fill  [512] as of ChangedBlock
  /// @return false, with nothing changed, when it is outside the initial bounds of the workpiece
  bool update(const VoxelIndex& origin, const MaterialId* material, const float* fill);

  /// Updates blocks of a workpiece that a step has changed.
  /// @return false when one of them is outside the initial bounds
  bool update(const Workpiece& workpiece, std::span<const VoxelIndex> origins);

  /// Meshes and returns the waiting page that is nearest to the focus (`look_at`). A page whose surface did not change
  /// is skipped.
  /// @param page  overwritten; its memory is used again
  /// @return false when no page is waiting
  bool next_page(SurfacePage& page);

  /// Sets the focus, whose surroundings come first; by default the middle of the workpiece.
  /// @param p_WQ  [m] finite
  /// @throws Error when it is not finite
  void look_at(const Vec3& p_WQ);

  /// Makes all pages with a surface wait again, for another viewer.
  void resend();

  [[nodiscard]] const GridFrame& frame() const;
  [[nodiscard]] std::size_t waiting() const;          ///< pages that may have changed; 0: all were returned
  [[nodiscard]] std::uint64_t blocks_meshed() const;  ///< since the beginning
  [[nodiscard]] std::size_t memory_bytes() const;     ///< size of the copy and the meshes; O(pages)

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hapticut
