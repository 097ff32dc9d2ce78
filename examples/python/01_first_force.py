# SPDX-License-Identifier: Apache-2.0
import hapticut, numpy as np
from hapticut.units import mm, ms, rpm
box = hapticut.Box([-3 * mm, -3 * mm, -4 * mm], [3 * mm, 3 * mm, 0])
bone = hapticut.build_block(box, 0.1 * mm, hapticut.presets.cortical_bone())
burr = hapticut.Tool(hapticut.SphereHead(1.5 * mm), hapticut.RayHandle(20 * mm), hapticut.common_spindle(40000 * rpm))
simulation = hapticut.Simulation(bone, burr)
heights = (1.5 + 20) * mm - 0.002 * mm * np.arange(1, 1001)  # the hand: one second downwards at 2 mm/s
poses = hapticut.Pose.from_translation(np.outer(heights, [0, 0, 1]))
trace = simulation.run(poses, np.tile([0, 0, -2 * mm, 0, 0, 0], (1000, 1)), 1 * ms)
print(trace["force"][249::250, 2], "N;", len(simulation.removed_in_run), "voxels removed")
