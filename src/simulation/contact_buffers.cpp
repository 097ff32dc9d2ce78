// SPDX-License-Identifier: Apache-2.0
// Buffers of ContactStages, sized for a head and its voxels.
#include <algorithm>
#include <utility>

#include "hapticut/core/reserve.hpp"
#include "simulation/contact_stages.hpp"

namespace hapticut {
namespace {

constexpr int kListedSubSteps = 64;  // whose changed blocks all fit the list, before duplicates are dropped

/// [m] Height up to which the point of a head is thinner than its voxels; below the whole head when its end is at least
/// as wide as it is high there, as that of a ball.
double thin_up_to(const ToolHead& head, double voxel_size) {
  constexpr double kThin = 0.75, kStep = 0.125;  // [voxels] radius, and heights that are tried
  const HeadBox box = head.bounding_box();
  const double bottom = box.min.z();
  double top = bottom;
  while (top < box.max.z() && head.spring_at({kThin * voxel_size, 0, top}).depth <= 0) top += kStep * voxel_size;
  return top - bottom > (kThin + kStep) * voxel_size ? top : bottom - voxel_size;
}

WorstCase worst_case_of(std::size_t max_voxels, std::size_t max_blocks, const SimulationConfig& config) noexcept {
  const std::size_t budget = config.voxel_budget == 0 ? max_voxels : config.voxel_budget;
  const std::size_t levels = (max_voxels + budget - 1) / budget;
  return {max_blocks, std::min(max_voxels, budget), config.max_sweep, int(levels), 1};
}

}  // namespace

ContactStages::Buffers::Buffers(const ToolHead& head, double voxel_size, const SimulationConfig& config)
    : max_voxels(hapticut::max_voxels(head, voxel_size)),
      max_blocks(hapticut::max_blocks(head, voxel_size)),
      near(max_blocks, max_voxels),
      thin_up_to(hapticut::thin_up_to(head, voxel_size)) {
  reserve_touched(emptied, max_blocks);
  reserve_touched(changed, max_blocks * std::size_t(std::min(config.max_sweep, kListedSubSteps)));
}

void ContactStages::exchange_buffers(Buffers& buffers) noexcept {
  forget_changes();
  emptied_.clear();
  near_.forget();
  std::swap(max_voxels_, buffers.max_voxels);
  std::swap(max_blocks_, buffers.max_blocks);
  std::swap(thin_up_to_, buffers.thin_up_to);
  std::swap(changed_, buffers.changed);
  std::swap(near_, buffers.near);
  std::swap(emptied_, buffers.emptied);
  subset_ = 0;
}

WorstCase ContactStages::Buffers::worst_case(const SimulationConfig& config) const noexcept {
  return worst_case_of(max_voxels, max_blocks, config);
}

WorstCase ContactStages::worst_case(const SimulationConfig& config) const noexcept {
  return worst_case_of(max_voxels_, max_blocks_, config);
}

}  // namespace hapticut
