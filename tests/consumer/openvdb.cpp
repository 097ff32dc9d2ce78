// SPDX-License-Identifier: Apache-2.0
// Makes a workpiece from a custom grid.
#include <hapticut/workpiece/openvdb.hpp>

bool use_openvdb() {
  using namespace hapticut;
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(0.0F);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->fill({{0, 0, 0}, {9, 9, 9}}, 1.0F);
  Material bone;
  bone.name = "bone";
  return workpiece_from_grid(*grid, bone).solid_voxels() == 1000;
}
