/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that needs only the header and the library of the C interface. */
#include <hapticut/c/hapticut.h>
#include <stdio.h>

int main(void) {
  hapticut_simulation simulation;
  hapticut_scene_info info = {.struct_size = sizeof info};
  if (hapticut_abi_version() != HAPTICUT_ABI_VERSION) return 2;
  if (hapticut_simulation_from_toml(
          "[workpiece]\nsource = 'block'\nsize_mm = [2, 2, 1]\nvoxel_mm = 0.2\n"
          "material = 'dentin'\n[tool]\nhead = 'sphere'\nradius_mm = 0.5\nspindle_rpm = 1000\n",
          NULL, &simulation) < 0 ||
      hapticut_scene(simulation, &info) < 0) {
    puts(hapticut_last_error());
    return 1;
  }
  printf("%s: voxels of %g mm\n", hapticut_version(), 1e3 * info.voxel_size);
  return hapticut_release(simulation) == HAPTICUT_OK ? 0 : 1;
}
