// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openvdb/Types.h>
#include <openvdb/tree/Tree.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/workpiece/workpiece.hpp"
#include "workpiece/undo.hpp"

/// @file
/// The state of a workpiece: three OpenVDB trees and the pool of nodes for cutting.
namespace hapticut {

using MaterialTree = openvdb::tree::Tree4<std::uint8_t, 5, 4, 3>::Type;
using FillTree = openvdb::tree::Tree4<float, 5, 4, 3>::Type;
using CentroidTree = openvdb::tree::Tree4<std::int32_t, 5, 4, 3>::Type;

/// The levels of a tree, from the root: a trunk node spans 4096^3 voxels, a branch node 128^3, a leaf 8^3 (one block).
template <class Tree>
using Trunk = typename Tree::RootNodeType::ChildNodeType;
template <class Tree>
using Branch = typename Trunk<Tree>::ChildNodeType;
template <class Tree>
using Leaf = typename Tree::LeafNodeType;

inline constexpr int kBranchEdge = Branch<MaterialTree>::DIM;  // 128
static_assert(Leaf<MaterialTree>::DIM == kBlockEdge);

inline openvdb::Coord to_coord(const VoxelIndex& index) { return {index[0], index[1], index[2]}; }
inline VoxelIndex to_index(const openvdb::Coord& c) { return {c.x(), c.y(), c.z()}; }
inline int branch_start(int i) { return i & ~(kBranchEdge - 1); }

/// Deletes the nodes of a tree without allocating memory. The destructor of an OpenVDB tree first lists its nodes. If
/// there is no memory for the list, C++ ends the program.
template <class Tree>
void delete_nodes(Tree& tree) noexcept {
  tree.root().clear();
}

/// The trees that store the voxels.
struct VoxelTrees {
  MaterialTree material{kEmpty};  ///< active = not yet empty
  FillTree fill{1.0F};            ///< a leaf only if a voxel of the block is partly filled; elsewhere solid means full
  CentroidTree centroid{0};  ///< packed CentroidOffset; a leaf only at antialiased surfaces; never written by cutting

  ~VoxelTrees() {
    delete_nodes(material);
    delete_nodes(fill);
    delete_nodes(centroid);
  }
};

/// A copy as after writing and reading a file. Cutting leaves two things behind that a file does not have: leaves of
/// fills where no voxel is partly filled, and the materials of emptied voxels. They do not change the workpiece, but a
/// later cut finds its memory in the leaves and not in the pool, and a force is summed in another order.
[[nodiscard]] std::unique_ptr<VoxelTrees> copy_of(const VoxelTrees& trees);

/// A tree for a grid of OpenVDB that is deleted without allocating memory.
template <class Tree, class... Arguments>
std::shared_ptr<Tree> make_tree(const Arguments&... arguments) {
  return std::shared_ptr<Tree>(new Tree(arguments...), [](Tree* tree) {
    delete_nodes(*tree);
    delete tree;
  });
}

/// Removes a node from a reserve and sets its origin to the start of a block or branch.  @pre the reserve is not empty
template <class Node>
Node* acquire_node(std::vector<std::unique_ptr<Node>>& reserve, const openvdb::Coord& at) {
  HAPTICUT_ASSERT(!reserve.empty());
  Node* node = reserve.back().release();
  reserve.pop_back();
  node->setOrigin(at);
  return node;
}

/// Nodes allocated at set-up, so that cutting does not allocate.
struct BlockPool {
  std::vector<std::unique_ptr<Leaf<MaterialTree>>> material_leaves;
  std::vector<std::unique_ptr<Leaf<FillTree>>> fill_leaves;
  std::vector<std::unique_ptr<Branch<FillTree>>> fill_branches;
  std::size_t target = 0;  ///< count of the last reserve_blocks
};

struct Workpiece::State {
  GridFrame frame;
  MaterialTable materials;
  std::unique_ptr<VoxelTrees> trees;  ///< never null
  BlockPool pool;
  std::unique_ptr<UndoJournal> journal;  ///< null: no undo

  /// The branch nodes around the last block that was requested: neighbouring blocks need no search from the root.
  struct BranchCache {
    bool valid = false;
    openvdb::Coord origin;
    Branch<MaterialTree>* material = nullptr;  ///< null: the whole branch is `tile`
    MaterialId tile = kEmpty;
    Branch<FillTree>* fill = nullptr;
    const Branch<CentroidTree>* centroid = nullptr;
  };
  mutable BranchCache cache;

  const BranchCache& branches_at(const openvdb::Coord& block_origin) const noexcept;

  std::uint64_t layout = next_layout();
  /// To be called with each change that Workpiece::layout is about.
  void change_layout() noexcept { layout = next_layout(); }
  static std::uint64_t next_layout() noexcept {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
  }
};

/// Access to the trees for other files of the library.
struct WorkpieceAccess {
  static const VoxelTrees& trees(const Workpiece& workpiece) { return *workpiece.state_->trees; }
  static VoxelTrees& trees(Workpiece& workpiece) {
    workpiece.state_->change_layout();
    return *workpiece.state_->trees;
  }
  static const BlockPool& pool(const Workpiece& workpiece) { return workpiece.state_->pool; }
  static BlockPool& pool(Workpiece& workpiece) { return workpiece.state_->pool; }
  static Workpiece make(const GridFrame& frame, MaterialTable materials, std::unique_ptr<VoxelTrees> trees);
};

}  // namespace hapticut
