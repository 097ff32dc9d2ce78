// SPDX-License-Identifier: Apache-2.0
// Removal of voxels without cutting.
#include "hapticut/simulation/simulation.hpp"
#include "simulation/simulation_state.hpp"

namespace hapticut {

bool Simulation::remove_voxels(const BlockVoxels& removed) noexcept {
  State& s = *state_;
  const BlockView before = s.workpiece.block(removed.origin);
  const BlockVoxels present = {removed.origin, removed.voxels & before.solid_voxels()};
  if (present.voxels.empty()) return true;
  ByMaterial<double> volume = {};
  present.voxels.for_each([&](int voxel) {
    volume[before.material_of(voxel)] += double(before.fill_of(voxel)) * s.contact_stages.voxel_volume();
  });
  if (before.fill != nullptr)
    s.workpiece.remember(before);
  else if (s.workpiece.writable_fill(removed.origin) == nullptr)
    return false;
  s.totals.altered = true;
  s.workpiece.forget_redo();
  s.workpiece.empty_voxels(removed.origin, present.voxels);
  s.contact_stages.list_change(removed.origin);
  for (std::size_t id = 0; id < volume.size(); ++id) s.totals.detached_volume[id] += volume[id];
  for (StepObserver* observer : s.observers.all()) observer->on_removal(present);
  return true;
}

}  // namespace hapticut
