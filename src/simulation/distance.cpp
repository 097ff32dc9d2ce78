// SPDX-License-Identifier: Apache-2.0
// The distance between the head and what is left of a material.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hapticut/contact/contact.hpp"
#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/tool/head_outline.hpp"
#include "hapticut/workpiece/block_grid.hpp"
#include "simulation/reach.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The search for the voxel of a material that is nearest to the head.
///
/// The gap of a voxel is the distance between the head and the voxel's filled part, which ends at a plane across the
/// direction from the head (VoxelSection), as in the contact of the default law. So the gap is zero where that contact
/// begins. Blocks, rows and voxels whose centre is too far away to be nearer than the best so far are left out.
class NearestVoxel {
 public:
  /// @param material  kEmpty: any
  NearestVoxel(const Workpiece& workpiece, const ToolHead& head, MaterialId material, const Pose& X_VT) noexcept
      : workpiece_(workpiece),
        outline_(head),
        material_(material),
        size_(workpiece.voxel_size()),
        grid_(X_VT.inverse(), size_) {}

  /// [m] The smallest gap, not below 0; kFar if it is more than `limit`.
  [[nodiscard]] double within(const IndexBox& voxels, double limit) noexcept {
    const double beyond = std::nextafter(limit, kFar);
    gap_ = beyond;
    // The block that may be nearest comes first, because it excludes most others.
    double nearest = beyond;
    VoxelIndex first = voxels.min;
    for_each_block_origin(voxels, [&](const VoxelIndex& origin) {
      const double bound = bound_of(origin);
      if (bound >= nearest || !may_contain(workpiece_.block(origin))) return;
      nearest = bound;
      first = origin;
    });
    if (nearest >= beyond) return kFar;
    look_at(first);
    for_each_block_origin(voxels, [&](const VoxelIndex& origin) {
      if (gap_ > 0 && origin != first && bound_of(origin) < gap_) look_at(origin);
    });
    return gap_ < beyond ? std::max(0.0, gap_) : kFar;
  }

 private:
  // [voxels] Bounds on the difference between the gap of a voxel and the distance of the middle of its row or block.
  static constexpr double kOfVoxel = double(kVoxelReach), kOfRow = 3.5 + kOfVoxel,
                          kOfBlock = 3.5 * 1.7320508075688774 + kOfVoxel;

  [[nodiscard]] double distance(const Vec3& p_TQ) const noexcept {
    return outline_.distance(std::sqrt(p_TQ.x() * p_TQ.x() + p_TQ.y() * p_TQ.y()), p_TQ.z());
  }

  /// [m] Lower bound of the gaps of a block's voxels.
  [[nodiscard]] double bound_of(const VoxelIndex& origin) const noexcept {
    const Vec3 middle = grid_.position(origin) + grid_.voxel_steps * Vec3::Constant(3.5);
    return distance(middle) - kOfBlock * size_;
  }

  /// False only if the block certainly has no voxel of the material.
  [[nodiscard]] bool may_contain(const BlockView& block) const noexcept {
    if (block.empty()) return false;
    if (material_ == kEmpty) return true;
    if (block.material == nullptr) return block.uniform_material == material_;
    return std::memchr(block.material, material_, kBlockVoxels) != nullptr;
  }

  void look_at(const VoxelIndex& origin) noexcept {
    const BlockView block = workpiece_.block(origin);
    if (!may_contain(block)) return;
    const Vec3 base = grid_.position(origin), step = grid_.voxel_steps.col(2);
    for (int row = 0; row < kBlockRows; ++row) {
      const Vec3 begin = base + grid_.voxel_steps * Vec3(row >> 3, row & 7, 0);
      if (distance(begin + 3.5 * step) - kOfRow * size_ >= gap_) continue;
      for (int lane = 0; lane < kLanes; ++lane) {
        const int voxel = row * kLanes + lane;
        const MaterialId id = block.material_of(voxel);
        if (id == kEmpty || (material_ != kEmpty && id != material_)) continue;
        const float fill = block.fill_of(voxel);
        if (fill > 0) look_at_voxel(begin + lane * step, double(fill));
      }
    }
  }

  /// @param p_TQ  [m] centre of the voxel
  void look_at_voxel(const Vec3& p_TQ, double fill) noexcept {
    const double rho = std::sqrt(p_TQ.x() * p_TQ.x() + p_TQ.y() * p_TQ.y());
    if (outline_.distance(rho, p_TQ.z()) - kOfVoxel * size_ >= gap_) return;
    const HeadOutline::Place place = outline_.place(rho, p_TQ.z());
    const double radial = place.n_radial / std::max(rho, 1e-12);
    const Vec3 n_V = grid_.voxel_steps.transpose() * Vec3(radial * p_TQ.x(), radial * p_TQ.y(), place.n_axial) / size_;
    const VoxelSection<double> section(std::clamp(n_V.cwiseAbs().maxCoeff(), double(kMinMaxNorm), 1.0),
                                       VoxelSection<double>::kMinStandingWidth);
    gap_ = std::min(gap_, place.distance - size_ * (section.height_of(fill) - section.span() / 2));
  }

  const Workpiece& workpiece_;
  const HeadOutline outline_;
  const MaterialId material_;
  const double size_;  // [m] edge of a voxel
  const GridInHead grid_;
  double gap_ = kFar;  // [m] the smallest so far
};

}  // namespace

double Simulation::distance_to(MaterialId material, const Pose& X_WH, double max_distance) const noexcept {
  const State& s = *state_;
  if (check_input(s.config, X_WH, {}, s.config.min_dt) != StepStatus::ok || std::isnan(max_distance))
    return std::numeric_limits<double>::quiet_NaN();
  const IndexBox& bounds = s.contact_stages.bounds();
  if (bounds.empty() || max_distance < 0) return kFar;
  const double size = s.workpiece.voxel_size();
  const Pose X_VT = s.X_VW * (X_WH * s.tool.X_HT());
  NearestVoxel nearest(s.workpiece, s.tool.head(), material, X_VT);
  // Box by box, each twice as far as the one before: what is near is found without a look at the whole workpiece.
  for (double reach = 2 * kBlockEdge * size;; reach *= 2) {
    const IndexBox voxels =
        reach_of(s.tool.head().bounding_box(), X_VT, size, bounds, reach / size + double(kVoxelReach));
    const bool is_last = reach >= max_distance || (voxels.min == bounds.min && voxels.max == bounds.max);
    const double limit = is_last ? max_distance : reach;
    if (const double found = voxels.empty() ? kFar : nearest.within(voxels, limit); is_last || found < kFar)
      return found;
  }
}

}  // namespace hapticut
