# SPDX-License-Identifier: Apache-2.0
"""The model in closed form: C1 ... C43 of docs/model.md, to plot theory beside a sweep.

SI units; forces and torques act on the tool. Unless a function says otherwise, the material is the half space z < 0 and
the head is upright. Where a function takes numbers only, each may be an array."""
from ._export import export
from ._hapticut import (
    # Standing heads
    cap_force as cap_force,
    cap_stiffness as cap_stiffness,
    max_cap_stiffness as max_cap_stiffness,
    cap_energy as cap_energy,
    cone_force as cone_force,
    flat_bottom_force as flat_bottom_force,
    flat_nearest_force as flat_nearest_force,
    side_wall_force as side_wall_force,
    side_wall_torque as side_wall_torque,
    disk_area_before as disk_area_before,
    edge_force as edge_force,
    edge_torque as edge_torque,
    layered_cap_force as layered_cap_force,
    surface_pressure as surface_pressure,
    ball_damping_force as ball_damping_force,
    flat_bottom_crushing_force as flat_bottom_crushing_force,
    cap_crushing_force as cap_crushing_force,
    pushed_pin_force as pushed_pin_force,
    drag_work as drag_work,
    drag_peak as drag_peak,
    drag_plateau as drag_plateau,
    growth_time as growth_time,
    wrench_on_plane as wrench_on_plane,

    # Steady cuts
    SteadyCut as SteadyCut,
    axial_cutting_force_of_a_flat_head as axial_cutting_force_of_a_flat_head,
    axial_cutting_torque_of_a_flat_head as axial_cutting_torque_of_a_flat_head,
    axial_cutting_force_with_elastic_release as axial_cutting_force_with_elastic_release,
    feed_of_a_flat_head_under as feed_of_a_flat_head_under,
    side_milling_wrench as side_milling_wrench,
    slotting_wrench as slotting_wrench,
    groove_wrench as groove_wrench,
    buried_ball_wrench as buried_ball_wrench,
    ball_plunge_wrench as ball_plunge_wrench,
    cone_plunge_wrench as cone_plunge_wrench,
    axial_chip_wrench as axial_chip_wrench,
    feed_with_chips_under as feed_with_chips_under,
    slotting_chip_wrench as slotting_chip_wrench,
    ball_plunge_chip_wrench as ball_plunge_chip_wrench,
    groove_chip_wrench as groove_chip_wrench,
    cutting_power as cutting_power,
    twist_drill_wrench as twist_drill_wrench,
    torque_over_thrust_of_chips as torque_over_thrust_of_chips,
    torque_over_thrust_of_edges as torque_over_thrust_of_edges,
    step_volume_of_a_flat_head as step_volume_of_a_flat_head,
    step_volume_of_a_cone as step_volume_of_a_cone,
    step_volume_of_a_ball as step_volume_of_a_ball,
    step_force_of_a_flat_head as step_force_of_a_flat_head,
    step_force_of_a_cone as step_force_of_a_cone,
    step_force_of_a_ball as step_force_of_a_ball,
    engaged_layer as engaged_layer,
    stiffness_for_layer as stiffness_for_layer,
    engaged_volume_under_a_flat_head as engaged_volume_under_a_flat_head,
    decaying_volume_under_a_flat_head as decaying_volume_under_a_flat_head,
    wall_left_by_a_pass as wall_left_by_a_pass,

    # Texture
    grain_variation as grain_variation,
    cutting_area_of_a_slot as cutting_area_of_a_slot,
    tooth_passing_variation as tooth_passing_variation,

    # Other laws
    flat_punch_force as flat_punch_force,
    ball_punch_force as ball_punch_force,
    cone_punch_force as cone_punch_force,
    hertzian_burr_force as hertzian_burr_force,
    drooped_speed as drooped_speed,
)

export(__name__)
