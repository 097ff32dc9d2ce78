// SPDX-License-Identifier: Apache-2.0
// The voxels as a texture of your own renderer, block by block. docs/other-scenes.md.
#include <cmath>
#include <cstdint>
#include <hapticut/hapticut.hpp>
#include <iostream>
#include <vector>

using namespace hapticut;
using namespace hapticut::units;

/// In double precision for both: single precision may round a half the other way.
std::uint8_t texel_of(double fill) { return std::uint8_t(std::lround(255 * fill)); }

/// A copy of the voxels in the layout of a 3D texture with two bytes for each texel: material and fill. `put` is the
/// place of your glTexSubImage3D, vkCmdCopyBufferToImage ... of 8 x 8 x 8 texels.
struct Texture {
  explicit Texture(const IndexBox& voxels) : blocks(voxels) {
    texels.resize(2 * kBlockVoxels * std::size_t(blocks.count()));
  }
  void put(const ChangedBlock& block) {
    for (int n = 0; n < kBlockVoxels; ++n) {
      std::uint8_t* texel = at(voxel_at(block.origin, n));
      texel[0] = block.material[std::size_t(n)];
      texel[1] = texel_of(block.fill[std::size_t(n)]);
    }
  }
  std::uint8_t* at(const VoxelIndex& voxel) {  // x is the fastest index, as in a texture
    std::size_t place = 0;
    for (const std::size_t axis : {2U, 1U, 0U})
      place = place * std::size_t(kBlockEdge * blocks.dims()[axis]) + std::size_t(voxel[axis] - blocks.first()[axis]);
    return texels.data() + 2 * place;
  }
  BlockGrid blocks;
  std::vector<std::uint8_t> texels;
};

int main() {
  const Box box{Vec3(-6, -6, -4) * mm, Vec3(6, 6, 0) * mm};
  Simulation simulation(build_layered_slab(box, 0.1 * mm, {{presets::enamel(), 1 * mm}, {presets::dentin(), 3 * mm}}),
                        Tool(SphereHead{0.8 * mm}, RayHandle{0}, common_spindle(40000 * rpm)));
  Texture texture(simulation.first_bounds());
  ChangeFeed feed(simulation);
  std::size_t first = 0, later = 0;
  ChangedBlock block;

  feed.send_all();  // at the start, and whenever the texture was lost
  while (feed.waiting() > 0) {
    feed.tick(256, 0);
    for (; feed.receive(block); ++first) texture.put(block);
  }
  for (int n = 0; n < 1000; ++n) {  // 1 kHz; `receive` may be called in the thread that draws
    const double x = 2 * mm * std::sin(0.01 * n);
    const Pose X_WH = Pose::from_translation(Vec3(x, 0, 1 * mm - 2 * mm * n / 1000));
    simulation.step(X_WH, {Vec3(20 * mm * std::cos(0.01 * n), 0, -2 * mm), Vec3::Zero()}, 1 * ms);
    for (; feed.receive(block); ++later) texture.put(block);
  }
  while (feed.waiting() > 0) {  // what the last steps have changed
    feed.tick(256, 0);
    for (; feed.receive(block); ++later) texture.put(block);
  }

  std::size_t wrong = 0, voxels = 0;
  for_each_voxel(simulation.first_bounds(), [&](const VoxelIndex& voxel) {
    const std::uint8_t* texel = texture.at(voxel);
    wrong += texel[0] != simulation.workpiece().material_at(voxel) ||
             texel[1] != texel_of(simulation.workpiece().fill_at(voxel));
    ++voxels;
  });
  std::cout << first << " blocks at the start, " << later << " in 1000 steps; " << wrong << " of " << voxels
            << " texels are wrong\n";
}
