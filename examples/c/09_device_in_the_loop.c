/* SPDX-License-Identifier: Apache-2.0 */
/* A device cuts bone through a virtual coupling in the real-time loop. This thread reads states and sends commands:
 *   09_device_in_the_loop [DEVICE]     mock:spiral,hand=nominal; replay:FILE; openhaptics; ... (docs/devices.md) */
#include <hapticut/c/hapticut.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char scene[] =
    "[workpiece]\nsource = 'block'\nsize_mm = [30, 30, 10]\nvoxel_mm = 0.25\nmaterial = 'cortical_bone'\n"
    "[tool]\nhead = 'sphere'\nradius_mm = 1.5\nspindle_rpm = 30000\n"
    "[simulation]\nreserved_blocks = 16384\n"; /* the loop cannot allocate blocks between ticks */

static void must(int code) {
  if (code >= 0) return;
  fprintf(stderr, "%s\n", hapticut_last_error());
  exit(1);
}

static void send(hapticut_loop loop, uint32_t kind, double value) {
  hapticut_command command = {.struct_size = sizeof command};
  command.kind = kind;
  command.value = value;
  must(hapticut_loop_send(loop, &command));
}

int main(int argc, char** argv) {
  const char* name = argc > 1 ? argv[1] : "mock:spiral,hand=nominal";
  const int is_mock = strncmp(name, "mock:", 5) == 0;
  hapticut_simulation_options for_a_device = {.struct_size = sizeof for_a_device};
  hapticut_loop_options options = {.struct_size = sizeof options};
  hapticut_loop_state state = {.struct_size = sizeof state};
  hapticut_loop_report report = {.struct_size = sizeof report};
  hapticut_simulation simulation;
  hapticut_device device;
  hapticut_loop loop;
  double max_force = 0, force = 0;
  int running = 1, is_slower = 0;

  for_a_device.for_coupling = 1;
  for_a_device.undo_blocks = 4096;
  must(hapticut_simulation_from_toml(scene, &for_a_device, &simulation));
  must(hapticut_device_open(name, &device));
  options.seconds = 6;
  options.up = is_mock ? HAPTICUT_UP_Z : HAPTICUT_UP_Y;
  options.simulated_time = is_mock ? 1 : 0; /* a mock needs no real time */
  must(hapticut_loop_start(simulation, device, &options, &loop));
  send(loop, HAPTICUT_COMMAND_SET_UNDO_MARK, 0);
  while (running) {
    must(hapticut_loop_is_running(loop, &running));
    must(hapticut_loop_latest(loop, &state)); /* draw the tool at X_WT */
    force = sqrt(state.applied_force[0] * state.applied_force[0] + state.applied_force[1] * state.applied_force[1] +
                 state.applied_force[2] * state.applied_force[2]);
    if (force > max_force) max_force = force;
    if (state.time > 4 && !is_slower && running)
      send(loop, HAPTICUT_COMMAND_SET_SPINDLE_SPEED, 1500), is_slower = 1; /* rad/s */
  }
  must(hapticut_loop_stop(loop, &report));
  printf("%llu ticks (%s), guard %s, removed %.3f mm^3, at most %.2f N seen, spindle %.0f rad/s\n",
         (unsigned long long)report.ticks, report.end, state.arming == HAPTICUT_ARMING_ON ? "on" : "not on",
         1e9 * state.removed_volume, max_force, state.spindle_speed);

  must(hapticut_undo(simulation)); /* between runs; while the loop runs, send HAPTICUT_COMMAND_UNDO */
  {
    hapticut_material_info bone = {.struct_size = sizeof bone};
    must(hapticut_material(simulation, 1, &bone));
    printf("undone: %.0f mm^3 of %s again\n", 1e9 * bone.volume, bone.name);
  }
  must(hapticut_release(loop));
  must(hapticut_release(device));
  must(hapticut_release(simulation));
  return 0;
}
