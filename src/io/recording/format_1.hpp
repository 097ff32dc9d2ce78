// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// @file
/// What recordings of format 1 hold. Later ones say it themselves, so this list never changes.
namespace hapticut {

struct GroupOfFormat1 {
  std::string_view name, fields;
};

inline constexpr GroupOfFormat1 kGroupsOfFormat1[] = {
    {"simulation",
     "reference_stiffness,removal,quadrature,contact_time,deep_contact,handle_torque,"
     "handle_torque_scale,update_rate,reserved_blocks,removed_voxel_capacity,voxel_budget,"
     "stage_times,shortest_dt,longest_dt,longest_sweep,law_is_default,friction_is_given"},
    {"tool",
     "head,handle,handle_length,spindle_speed,spindle_power_limit,spindle_acceleration_limit,"
     "spindle_droop"},
    {"materials",
     "count,relative_stiffness,damping,cutting_ratio,specific_cutting_energy,edge_pressure,"
     "static_friction,dynamic_friction,tangential_stiffness,density"},
    {"device",
     "model,vendor,serial_number,driver_version,input_degrees_of_freedom,output_degrees_of_freedom,"
     "peak_force,continuous_force,peak_torque,continuous_torque,stiffness,rotational_stiffness,"
     "damping,position_resolution,workspace_low_x,workspace_low_y,workspace_low_z,workspace_high_x,"
     "workspace_high_y,workspace_high_z,rate,hard_realtime"},
    {"steps",
     "number,time,pose_rotation,pose_translation,velocity_linear,velocity_angular,dt,"
     "spindle_setting,reserved_blocks,free_blocks,force,torque,model_force,model_torque,"
     "removed_volume,removed_voxels,removed_voxels_hash,contact_voxels,contact_volume,contact_depth,"
     "energy_hand_work,energy_motor_work,energy_elastic,energy_cutting,energy_released,"
     "energy_damping,energy_rubbing,energy_anchored,energy_sliding,energy_credited,energy_entered,"
     "spindle_speed,spindle_torque,sub_steps,status,device_rotation,device_translation,"
     "device_velocity_linear,device_velocity_angular,device_buttons,device_time,device_sequence,"
     "device_epoch,device_temperature,device_valid,device_fault,commanded_force,commanded_torque,"
     "applied_force,applied_torque,output_limits,arming"},
};

/// Empty for a group that is not among them.
[[nodiscard]] constexpr std::string_view fields_of_format_1(std::string_view group) {
  for (const GroupOfFormat1& one : kGroupsOfFormat1)
    if (one.name == group) return one.fields;
  return {};
}

}  // namespace hapticut
