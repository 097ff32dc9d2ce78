/* SPDX-License-Identifier: Apache-2.0 */
/* Every field of every struct of the interface, for layout.c and the test that compares it with C++. */
#ifndef HAPTICUT_TESTS_LAYOUT_H
#define HAPTICUT_TESTS_LAYOUT_H

#include <stddef.h>

#include "hapticut/c/hapticut.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The name of a struct with its size, or of a field with its offset, in bytes. */
typedef void (*layout_user)(const char* name, size_t bytes);

void layout_in_c(layout_user use);

#define F(field) use(#field, offsetof(type, field));
#define STRUCT(name, fields)  \
  {                           \
    typedef name type;        \
    use(#name, sizeof(type)); \
    fields                    \
  }

/* clang-format off */
static inline void every_layout(layout_user use) {
  STRUCT(hapticut_pose, F(position) F(rotation))
  STRUCT(hapticut_simulation_options, F(struct_size) F(for_coupling) F(undo_blocks))
  STRUCT(hapticut_scene_info, F(struct_size) F(materials) F(rate) F(voxel_size) F(box_min) F(box_max) F(X_WV)
    F(X_HT) F(head_min) F(head_max) F(spindle_speed) F(path_duration) F(flutes) F(unused))
  STRUCT(hapticut_material_info, F(struct_size) F(unused) F(removed_volume) F(volume) F(name)
    F(detached_volume))
  STRUCT(hapticut_step_input, F(struct_size) F(unused) F(X_WH) F(linear_velocity) F(angular_velocity) F(dt))
  STRUCT(hapticut_step_result, F(struct_size) F(status) F(force) F(torque) F(removed_volume) F(removed_voxels)
    F(spindle_speed) F(spindle_torque) F(contact_depth) F(contact_volume) F(contact_voxels) F(sub_steps) F(X_WH)
    F(contact_point_W) F(contact_normal_W) F(contact_area) F(contact_pressure) F(first_touched) F(load_to_cut))
  STRUCT(hapticut_ray_hit, F(struct_size) F(material) F(distance) F(point_W) F(normal_W))
  STRUCT(hapticut_probe_result, F(struct_size) F(contact_voxels) F(force) F(torque) F(stiffness) F(contact_depth))
  STRUCT(hapticut_energy_ledger, F(struct_size) F(unused) F(hand_work) F(motor_work) F(elastic) F(cutting)
    F(crushed) F(released) F(damping) F(rubbing) F(anchored) F(sliding) F(credited) F(entered) F(imbalance)
    F(turnover))
  STRUCT(hapticut_coupling_gains, F(struct_size) F(unused) F(stiffness) F(damping) F(mass) F(max_force)
    F(angular_stiffness) F(angular_damping) F(inertia) F(max_torque))
  STRUCT(hapticut_device_info, F(struct_size) F(input_degrees_of_freedom) F(output_degrees_of_freedom) F(unused)
    F(rate) F(peak_force) F(continuous_force) F(peak_torque) F(stiffness) F(damping) F(workspace_min)
    F(workspace_max) F(model) F(serial_number))
  STRUCT(hapticut_loop_options, F(struct_size) F(coupling) F(seconds) F(scale) F(up) F(has_X_WB) F(X_WB)
    F(stiffness) F(simulated_time) F(ordinary_priority) F(lock_memory) F(stop_on_signals) F(stop_on_crash)
    F(unused))
  STRUCT(hapticut_loop_state, F(struct_size) F(status) F(tick) F(arming) F(fault) F(flags) F(buttons)
    F(output_changes) F(status_seen) F(time) F(X_BS) F(X_WT) F(force) F(torque) F(applied_force) F(applied_torque)
    F(spindle_speed) F(removed_volume) F(dissipated) F(power) F(removal_rate) F(contact_depth) F(contact_voxels)
    F(undo_marks) F(redo_marks) F(unused) F(commands_dropped) F(commands_refused) F(contact_point_W) F(touched))
  STRUCT(hapticut_command, F(struct_size) F(kind) F(value))
  STRUCT(hapticut_loop_report, F(struct_size) F(fault) F(ticks) F(missed) F(compute_p99) F(compute_max)
    F(wake_up_p99) F(wake_up_max) F(arming) F(unused) F(end) F(warnings))
  STRUCT(hapticut_vertex, F(position) F(material) F(unused_1) F(normal) F(unused_2))
  STRUCT(hapticut_page, F(struct_size) F(vertex_count) F(index_count) F(origin) F(version) F(vertices) F(indices)
    F(X_WP) F(step) F(ticket))
  STRUCT(hapticut_sound_options, F(struct_size) F(flutes) F(volume) F(half_power))
  STRUCT(hapticut_sound_input, F(struct_size) F(touching) F(spindle_speed) F(power) F(removal_rate))
  STRUCT(hapticut_recording_report, F(struct_size) F(unused) F(recorded) F(lost))
  STRUCT(hapticut_heat_config, F(struct_size) F(voxels_per_cell) F(cutting_share) F(rubbing_share)
    F(body_temperature) F(irrigation) F(water_temperature) F(threshold))
  STRUCT(hapticut_thermal_properties, F(conductivity) F(heat_capacity))
  STRUCT(hapticut_heat_structure_info, F(struct_size) F(material) F(temperature) F(peak) F(time_above) F(cem43)
    F(volume_above))
  STRUCT(hapticut_heat_balance_info, F(struct_size) F(unused) F(brought_in) F(stored) F(chips) F(irrigation)
    F(imbalance))
  STRUCT(hapticut_heat_grid_info, F(struct_size) F(dims) F(cell_size) F(X_WC))
  STRUCT(hapticut_islands_options, F(struct_size) F(has_fixed) F(fixed_min) F(fixed_max) F(min_fill) F(period)
    F(blocks_per_tick))
  STRUCT(hapticut_island_info, F(struct_size) F(unused) F(voxels) F(center_W))
}
/* clang-format on */

#undef F
#undef STRUCT

#ifdef __cplusplus
}
#endif
#endif
