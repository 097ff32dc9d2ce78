/* SPDX-License-Identifier: Apache-2.0 */
/* A bur drills into bone, dry and under water: the highest temperatures, and those below the hole. */
#include <hapticut/c/hapticut.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const char scene[] =
    "[workpiece]\n"
    "source = 'block'\n" /* one corner at the origin of the world */
    "size_mm = [6, 6, 4]\n"
    "voxel_mm = 0.1\n"
    "material = 'cortical_bone'\n"
    "[tool]\n"
    "head = 'sphere'\n"
    "radius_mm = 1\n"
    "handle = 'ray'\n"
    "handle_length_mm = 20\n"
    "spindle_rpm = 10000\n"
    "[simulation]\n"
    "remove_loose_pieces = true\n"; /* or hapticut_islands_open, which counts them */

static void must(int code) {
  if (code >= 0) return;
  fprintf(stderr, "%s\n", hapticut_last_error());
  exit(1);
}

static void drill(const char* name, double irrigation) {
  const double below[3] = {3e-3, 3e-3, 2e-3}; /* 0.8 mm below the hole */
  hapticut_step_input input = {.struct_size = sizeof input};
  hapticut_step_result result = {.struct_size = sizeof result};
  hapticut_heat_config config = {.struct_size = sizeof config};
  hapticut_heat_structure_info bone = {.struct_size = sizeof bone};
  hapticut_heat_balance_info balance = {.struct_size = sizeof balance};
  hapticut_simulation simulation;
  hapticut_heat heat;
  double temperature;
  int tick;

  must(hapticut_simulation_from_toml(scene, NULL, &simulation));
  config.irrigation = irrigation;
  must(hapticut_heat_open(simulation, &config, NULL, 0, &heat));
  input.X_WH.rotation[0] = input.X_WH.rotation[4] = input.X_WH.rotation[8] = 1; /* upright */
  input.X_WH.position[0] = input.X_WH.position[1] = 3e-3;
  input.linear_velocity[2] = -0.2e-3;
  input.dt = 1e-3;
  for (tick = 1; tick <= 6000; ++tick) { /* six seconds at 1 kHz */
    input.X_WH.position[2] = 4e-3 + 1e-3 + 20e-3 - 0.2e-6 * tick;
    must(hapticut_step(simulation, &input, &result));
    if (tick % 40 == 0) must(hapticut_heat_update(heat, NULL)); /* in a loop, another thread does this */
  }
  must(hapticut_heat_structure(heat, 1, &bone));
  must(hapticut_heat_balance(heat, &balance));
  must(hapticut_heat_temperature_at(heat, below, &temperature));
  printf(
      "%s: bone reached %.0f deg C, was above 47 for %.1f s; %.1f deg C below the hole; %.2f J stored, %.2f J to the "
      "water\n",
      name, bone.peak, bone.time_above, temperature, balance.stored, balance.irrigation);
  must(hapticut_release(heat));
  must(hapticut_release(simulation));
}

int main(void) {
  drill("dry", 0);
  drill("water at 23 deg C", 3000);
  return 0;
}
