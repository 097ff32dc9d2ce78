// SPDX-License-Identifier: Apache-2.0
// Pieces that were cut loose leave a simulation.
#include "hapticut/simulation/simulation.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {

bool Simulation::remove_voxels(const BlockVoxels& removed) noexcept {
  State& s = *state_;
  const BlockView before = s.workpiece.block(removed.origin);
  const BlockVoxels taken = {removed.origin, removed.voxels & before.solid_voxels()};
  if (taken.voxels.empty()) return true;
  ByMaterial<double> volume = {};
  taken.voxels.for_each(
      [&](int voxel) { volume[before.material_of(voxel)] += double(before.fill_of(voxel)) * s.voxel_volume; });
  if (before.fill != nullptr)
    s.workpiece.remember(before);
  else if (s.workpiece.writable_fill(removed.origin) == nullptr)
    return false;
  s.workpiece.forget_redo();
  s.workpiece.empty_voxels(removed.origin, taken.voxels);
  s.contact_stages.list_change(removed.origin);
  for (std::size_t id = 0; id < volume.size(); ++id) s.island_volume[id] += volume[id];
  for (StepObserver* observer : s.observers.all()) observer->on_removal(taken);
  return true;
}

bool Simulation::remove_island(IslandRemoval& removal, std::size_t most) noexcept {
  const std::size_t blocks = removal.island.blocks.size();
  std::size_t done = 0;
  do {  // one at least, or a caller that asks for 0 would never arrive
    if (removal.checked == 0) removal.exchange = workpiece_exchanges();
    if (removal.exchange != workpiece_exchanges()) removal.joined = true;
    if (removal.is_over()) return true;
    if (removal.checked < blocks) {
      if (!is_loose(removal.island, removal.checked++, workpiece())) removal.joined = true;
    } else {
      if (!remove_voxels(with_skin(removal.island, removal.removed, workpiece()))) return false;
      ++removal.removed;
    }
  } while (++done < most);
  return removal.is_over();
}

const ByMaterial<double>& Simulation::island_volume_by_material() const noexcept { return state_->island_volume; }

}  // namespace hapticut
