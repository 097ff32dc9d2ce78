# SPDX-License-Identifier: Apache-2.0
"""Heads of dental burs by name and size, shanks, common cutters, and motors."""
from ._export import export
from ._hapticut import (
    Shank as Shank,
    ShankKind as ShankKind,
    SpindleMotor as SpindleMotor,
    christmas_tree_head as christmas_tree_head,
    common_motor as common_motor,
    cylinder_head as cylinder_head,
    max_speed as max_speed,
    flame_head as flame_head,
    inverted_cone_head as inverted_cone_head,
    lips_of as lips_of,
    needle_head as needle_head,
    on_shank as on_shank,
    pear_head as pear_head,
    round_end_cylinder_head as round_end_cylinder_head,
    round_end_tapered_head as round_end_tapered_head,
    round_head as round_head,
    standard_shank as standard_shank,
    tapered_head as tapered_head,
    tooth_rate as tooth_rate,
    twist_drill_head as twist_drill_head,
    usual_cutter as usual_cutter,
    wheel_head as wheel_head,
    with_body as with_body,
)

export(__name__)
