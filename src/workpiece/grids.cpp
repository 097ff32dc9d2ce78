// SPDX-License-Identifier: Apache-2.0
#include "workpiece/grids.hpp"

#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/openvdb.hpp"
#include "workpiece/state.hpp"

namespace hapticut {

openvdb::math::Transform::Ptr transform_of(const GridFrame& frame, double unit) {
  // OpenVDB multiplies row vectors from the left: row i is the edge of a voxel along axis i.
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      matrix(row, column) = frame.voxel_size / unit * frame.X_WV.rotation(column, row);
      matrix(3, column) = frame.X_WV.translation[column] / unit;
    }
  try {
    return openvdb::math::Transform::createLinearTransform(matrix);
  } catch (const openvdb::ArithmeticError&) {
    throw Error("a voxel size of " + format_number(frame.voxel_size / unit) +
                " world units is too small for an OpenVDB transform, which needs at least 1.5e-5; choose a smaller "
                "unit.");
  }
}

GridFrame frame_of(const openvdb::math::Transform& transform, double unit) {
  require_positive(unit, "length of one world unit of the grid [m]");
  if (!transform.isLinear())
    throw Error("the grid's transform is not linear (a frustum); resample the grid to cubic voxels first.");
  openvdb::Mat4d matrix;
  try {
    matrix = transform.baseMap()->getAffineMap()->getMat4();
  } catch (const openvdb::ArithmeticError&) {
    throw Error("the grid's transform cannot be inverted; resample the grid to cubic voxels first.");
  }
  Mat3 edges;  // column i: edge of a voxel along axis i
  Vec3 translation;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      edges(column, row) = matrix(row, column);
      translation[column] = matrix(3, column);
    }
  const double size = edges.col(0).norm();
  if (!edges.allFinite() || !translation.allFinite() || !(size > 0) || !is_rotation(edges / size, 1e-5))
    throw Error(
        "the grid's transform is not a rotation with one voxel size (its voxels are not cubes, or it is mirrored); "
        "resample the grid to cubic voxels first.");
  return {size * unit, {orthonormalized(edges / size), translation * unit}};
}

openvdb::FloatGrid::Ptr density_grid(const Workpiece& workpiece, double unit) {
  require_positive(unit, "length of one world unit of the grid [m]");
  const VoxelTrees& trees = WorkpieceAccess::trees(workpiece);
  auto tree = make_tree<openvdb::FloatTree>(trees.material, 0.0F, 1.0F, openvdb::TopologyCopy());
  for (auto fill = trees.fill.cbeginLeaf(); fill; ++fill) {
    auto* leaf = tree->probeLeaf(fill->origin());
    if (leaf == nullptr) continue;
    for (auto voxel = leaf->beginValueOn(); voxel; ++voxel) voxel.setValue(fill->getValue(voxel.pos()));
  }
  auto grid = openvdb::FloatGrid::create(tree);
  grid->setTransform(transform_of(workpiece.frame(), unit));
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->setName("density");
  return grid;
}

openvdb::Int32Grid::Ptr material_grid(const Workpiece& workpiece, double unit) {
  require_positive(unit, "length of one world unit of the grid [m]");
  auto tree = make_tree<openvdb::Int32Tree>(WorkpieceAccess::trees(workpiece).material);
  // Voxels that were cut away keep their material with an inactive bit; the grid must show them as outside.
  for (auto leaf = tree->beginLeaf(); leaf; ++leaf)
    for (auto voxel = leaf->beginValueOff(); voxel; ++voxel) voxel.setValue(kEmpty);
  auto grid = openvdb::Int32Grid::create(tree);
  grid->setTransform(transform_of(workpiece.frame(), unit));
  grid->setName("material");
  return grid;
}

}  // namespace hapticut
