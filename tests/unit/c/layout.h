// SPDX-License-Identifier: Apache-2.0
/* Every field of every struct of the interface, for layout.c and the test that compares it with C++. */
#ifndef HAPTICUT_TESTS_LAYOUT_H
#define HAPTICUT_TESTS_LAYOUT_H

#include <stddef.h>

#include "hapticut/c/hapticut.h"

struct layout {
  const char* name;
  size_t offset; /* [bytes] of a field; for the name of a struct its size */
};

/* clang-format off */
#define HAPTICUT_LAYOUT(STRUCT, FIELD) \
  STRUCT(hapticut_pose) FIELD(hapticut_pose, position) FIELD(hapticut_pose, rotation) \
  STRUCT(hapticut_simulation_options) FIELD(hapticut_simulation_options, struct_size) \
    FIELD(hapticut_simulation_options, for_coupling) FIELD(hapticut_simulation_options, undo_blocks) \
  STRUCT(hapticut_scene_info) FIELD(hapticut_scene_info, struct_size) FIELD(hapticut_scene_info, materials) \
    FIELD(hapticut_scene_info, rate) FIELD(hapticut_scene_info, voxel_size) FIELD(hapticut_scene_info, box_min) \
    FIELD(hapticut_scene_info, box_max) FIELD(hapticut_scene_info, X_WV) FIELD(hapticut_scene_info, X_HT) \
    FIELD(hapticut_scene_info, head_min) FIELD(hapticut_scene_info, head_max) \
    FIELD(hapticut_scene_info, spindle_speed) FIELD(hapticut_scene_info, path_duration) \
    FIELD(hapticut_scene_info, flutes) FIELD(hapticut_scene_info, unused) \
  STRUCT(hapticut_material_info) FIELD(hapticut_material_info, struct_size) FIELD(hapticut_material_info, unused) \
    FIELD(hapticut_material_info, removed_volume) FIELD(hapticut_material_info, volume) \
    FIELD(hapticut_material_info, name) \
  STRUCT(hapticut_step_input) FIELD(hapticut_step_input, struct_size) FIELD(hapticut_step_input, unused) \
    FIELD(hapticut_step_input, X_WH) FIELD(hapticut_step_input, linear_velocity) \
    FIELD(hapticut_step_input, angular_velocity) FIELD(hapticut_step_input, dt) \
  STRUCT(hapticut_step_result) FIELD(hapticut_step_result, struct_size) FIELD(hapticut_step_result, status) \
    FIELD(hapticut_step_result, force) FIELD(hapticut_step_result, torque) \
    FIELD(hapticut_step_result, removed_volume) FIELD(hapticut_step_result, removed_voxels) \
    FIELD(hapticut_step_result, spindle_speed) FIELD(hapticut_step_result, spindle_torque) \
    FIELD(hapticut_step_result, contact_depth) FIELD(hapticut_step_result, contact_volume) \
    FIELD(hapticut_step_result, contact_voxels) FIELD(hapticut_step_result, sub_steps) \
    FIELD(hapticut_step_result, X_WH) FIELD(hapticut_step_result, contact_point_W) \
    FIELD(hapticut_step_result, contact_normal_W) FIELD(hapticut_step_result, contact_area) \
    FIELD(hapticut_step_result, contact_pressure) FIELD(hapticut_step_result, first_touched) \
  STRUCT(hapticut_ray_hit) FIELD(hapticut_ray_hit, struct_size) FIELD(hapticut_ray_hit, material) \
    FIELD(hapticut_ray_hit, distance) FIELD(hapticut_ray_hit, point_W) FIELD(hapticut_ray_hit, normal_W) \
  STRUCT(hapticut_probe_result) FIELD(hapticut_probe_result, struct_size) \
    FIELD(hapticut_probe_result, contact_voxels) FIELD(hapticut_probe_result, force) \
    FIELD(hapticut_probe_result, torque) FIELD(hapticut_probe_result, stiffness) \
    FIELD(hapticut_probe_result, contact_depth) \
  STRUCT(hapticut_energy_ledger) FIELD(hapticut_energy_ledger, struct_size) FIELD(hapticut_energy_ledger, unused) \
    FIELD(hapticut_energy_ledger, hand_work) FIELD(hapticut_energy_ledger, motor_work) \
    FIELD(hapticut_energy_ledger, elastic) FIELD(hapticut_energy_ledger, cutting) \
    FIELD(hapticut_energy_ledger, crushed) FIELD(hapticut_energy_ledger, released) \
    FIELD(hapticut_energy_ledger, damping) FIELD(hapticut_energy_ledger, rubbing) \
    FIELD(hapticut_energy_ledger, anchored) FIELD(hapticut_energy_ledger, sliding) \
    FIELD(hapticut_energy_ledger, credited) FIELD(hapticut_energy_ledger, entered) \
    FIELD(hapticut_energy_ledger, imbalance) FIELD(hapticut_energy_ledger, turnover) \
  STRUCT(hapticut_coupling_gains) FIELD(hapticut_coupling_gains, struct_size) \
    FIELD(hapticut_coupling_gains, unused) FIELD(hapticut_coupling_gains, stiffness) \
    FIELD(hapticut_coupling_gains, damping) FIELD(hapticut_coupling_gains, mass) \
    FIELD(hapticut_coupling_gains, max_force) FIELD(hapticut_coupling_gains, angular_stiffness) \
    FIELD(hapticut_coupling_gains, angular_damping) FIELD(hapticut_coupling_gains, inertia) \
    FIELD(hapticut_coupling_gains, max_torque) \
  STRUCT(hapticut_device_info) FIELD(hapticut_device_info, struct_size) \
    FIELD(hapticut_device_info, input_degrees_of_freedom) FIELD(hapticut_device_info, output_degrees_of_freedom) \
    FIELD(hapticut_device_info, unused) FIELD(hapticut_device_info, rate) FIELD(hapticut_device_info, peak_force) \
    FIELD(hapticut_device_info, continuous_force) FIELD(hapticut_device_info, peak_torque) \
    FIELD(hapticut_device_info, stiffness) FIELD(hapticut_device_info, damping) \
    FIELD(hapticut_device_info, workspace_min) FIELD(hapticut_device_info, workspace_max) \
    FIELD(hapticut_device_info, model) FIELD(hapticut_device_info, serial_number) \
  STRUCT(hapticut_loop_options) FIELD(hapticut_loop_options, struct_size) FIELD(hapticut_loop_options, coupling) \
    FIELD(hapticut_loop_options, seconds) FIELD(hapticut_loop_options, scale) FIELD(hapticut_loop_options, up) \
    FIELD(hapticut_loop_options, has_X_WB) FIELD(hapticut_loop_options, X_WB) \
    FIELD(hapticut_loop_options, stiffness) FIELD(hapticut_loop_options, simulated_time) \
    FIELD(hapticut_loop_options, ordinary_priority) FIELD(hapticut_loop_options, lock_memory) \
    FIELD(hapticut_loop_options, stop_on_signals) FIELD(hapticut_loop_options, stop_on_crash) \
    FIELD(hapticut_loop_options, unused) \
  STRUCT(hapticut_loop_state) FIELD(hapticut_loop_state, struct_size) FIELD(hapticut_loop_state, status) \
    FIELD(hapticut_loop_state, tick) FIELD(hapticut_loop_state, arming) FIELD(hapticut_loop_state, fault) \
    FIELD(hapticut_loop_state, flags) FIELD(hapticut_loop_state, buttons) \
    FIELD(hapticut_loop_state, output_changes) FIELD(hapticut_loop_state, status_seen) \
    FIELD(hapticut_loop_state, time) FIELD(hapticut_loop_state, X_BS) FIELD(hapticut_loop_state, X_WT) \
    FIELD(hapticut_loop_state, force) FIELD(hapticut_loop_state, torque) FIELD(hapticut_loop_state, applied_force) \
    FIELD(hapticut_loop_state, applied_torque) FIELD(hapticut_loop_state, spindle_speed) \
    FIELD(hapticut_loop_state, removed_volume) FIELD(hapticut_loop_state, dissipated) \
    FIELD(hapticut_loop_state, power) FIELD(hapticut_loop_state, removal_rate) \
    FIELD(hapticut_loop_state, contact_depth) FIELD(hapticut_loop_state, contact_voxels) \
    FIELD(hapticut_loop_state, undo_marks) FIELD(hapticut_loop_state, redo_marks) \
    FIELD(hapticut_loop_state, unused) FIELD(hapticut_loop_state, commands_dropped) \
    FIELD(hapticut_loop_state, commands_refused) FIELD(hapticut_loop_state, contact_point_W) \
    FIELD(hapticut_loop_state, touched) \
  STRUCT(hapticut_command) FIELD(hapticut_command, struct_size) FIELD(hapticut_command, kind) \
    FIELD(hapticut_command, value) \
  STRUCT(hapticut_loop_report) FIELD(hapticut_loop_report, struct_size) FIELD(hapticut_loop_report, fault) \
    FIELD(hapticut_loop_report, ticks) FIELD(hapticut_loop_report, missed) FIELD(hapticut_loop_report, compute_p99) \
    FIELD(hapticut_loop_report, compute_max) FIELD(hapticut_loop_report, wake_up_p99) \
    FIELD(hapticut_loop_report, wake_up_max) FIELD(hapticut_loop_report, arming) \
    FIELD(hapticut_loop_report, unused) FIELD(hapticut_loop_report, end) FIELD(hapticut_loop_report, warnings) \
  STRUCT(hapticut_vertex) FIELD(hapticut_vertex, position) FIELD(hapticut_vertex, material) \
    FIELD(hapticut_vertex, unused_1) FIELD(hapticut_vertex, normal) FIELD(hapticut_vertex, unused_2) \
  STRUCT(hapticut_page) FIELD(hapticut_page, struct_size) FIELD(hapticut_page, vertex_count) \
    FIELD(hapticut_page, index_count) FIELD(hapticut_page, origin) FIELD(hapticut_page, version) \
    FIELD(hapticut_page, vertices) FIELD(hapticut_page, indices) FIELD(hapticut_page, X_WP) \
    FIELD(hapticut_page, step) FIELD(hapticut_page, ticket) \
  STRUCT(hapticut_sound_options) FIELD(hapticut_sound_options, struct_size) FIELD(hapticut_sound_options, flutes) \
    FIELD(hapticut_sound_options, volume) FIELD(hapticut_sound_options, half_power) \
  STRUCT(hapticut_sound_input) FIELD(hapticut_sound_input, struct_size) FIELD(hapticut_sound_input, touching) \
    FIELD(hapticut_sound_input, spindle_speed) FIELD(hapticut_sound_input, power) \
    FIELD(hapticut_sound_input, removal_rate) \
  STRUCT(hapticut_recording_report) FIELD(hapticut_recording_report, struct_size) \
    FIELD(hapticut_recording_report, unused) FIELD(hapticut_recording_report, recorded) \
    FIELD(hapticut_recording_report, lost)
/* clang-format on */

#define HAPTICUT_LAYOUT_OF(type) {#type, sizeof(type)},
#define HAPTICUT_LAYOUT_AT(type, field) {#type "." #field, offsetof(type, field)},

#ifdef __cplusplus
extern "C" {
#endif
extern const struct layout layout_in_c[];
extern const size_t layouts_in_c;
#ifdef __cplusplus
}
#endif
#endif
