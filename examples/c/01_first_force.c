/* SPDX-License-Identifier: Apache-2.0 */
/* A ball cuts into bone at 2 mm/s: the first example of the README, in C. */
#include <hapticut/c/hapticut.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

static const char scene[] =
    "[workpiece]\n"
    "source = 'block'\n" /* one corner at the origin of the world */
    "size_mm = [6, 6, 4]\n"
    "voxel_mm = 0.1\n"
    "material = 'cortical_bone'\n"
    "[tool]\n"
    "head = 'sphere'\n"
    "radius_mm = 1.5\n"
    "handle = 'ray'\n"
    "handle_length_mm = 20\n"
    "spindle_rpm = 40000\n";

int main(void) {
  hapticut_simulation simulation;
  hapticut_step_input input = {.struct_size = sizeof input};
  hapticut_step_result result = {.struct_size = sizeof result};
  uint64_t removed = 0; /* voxels */
  int tick;
  if (hapticut_simulation_from_toml(scene, NULL, &simulation) < 0) {
    fprintf(stderr, "%s\n", hapticut_last_error());
    return 1;
  }
  input.X_WH.rotation[0] = input.X_WH.rotation[4] = input.X_WH.rotation[8] = 1; /* upright */
  input.X_WH.position[0] = input.X_WH.position[1] = 3e-3;
  input.linear_velocity[2] = -2e-3;
  input.dt = 1e-3;
  for (tick = 1; tick <= 1000; ++tick) { /* one second at 1 kHz */
    input.X_WH.position[2] = 4e-3 + 1.5e-3 + 20e-3 - 2e-6 * tick;
    if (hapticut_step(simulation, &input, &result) < 0) {
      fprintf(stderr, "%s\n", hapticut_last_error());
      return 1;
    }
    removed += result.removed_voxels;
    if (tick % 250 == 0)
      printf("%d ms: %.6g N, spindle torque %.6g N mm, %llu voxels removed\n", tick, result.force[2],
             1e3 * result.spindle_torque, (unsigned long long)removed);
  }
  return hapticut_release(simulation) == HAPTICUT_OK ? 0 : 1;
}
