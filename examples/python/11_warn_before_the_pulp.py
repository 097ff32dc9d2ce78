# SPDX-License-Identifier: Apache-2.0
"""Drills into a molar, and watches how much dentin is left above the pulp: docs/other-scenes.md."""
import numpy as np

import hapticut
from hapticut.units import mm, ms, rpm

tooth = hapticut.build_molar(0.1 * mm)
names = [material.name for material in tooth.materials.all()]
tool = hapticut.Tool(hapticut.catalogue.round_head(1.2 * mm), hapticut.RayHandle(20 * mm),
                     hapticut.Spindle(200_000 * rpm))
simulation = hapticut.Simulation(tooth, tool)

# A ray straight down into the fossa gives the place, and the way to the pulp.
above, down = np.array([0, 0, 12 * mm]), np.array([0.0, 0, -1])
surface = tooth.first_hit(above, down)
pulp = tooth.first_hit(above, down, material="pulp")
assert surface is not None and pulp is not None  # None: the ray misses
print(f"{names[surface.material - 1]} at z = {surface.point_W[2] / mm:.2f} mm, "
      f"pulp {(pulp.distance - surface.distance) / mm:.2f} mm below")

# Down by 2 mm/s, in runs of 0.1 s, until the head is 0.5 mm from the pulp.
hand = surface.point_W + [0, 0, 21 * mm]
velocities = np.tile([0, 0, -2 * mm, 0, 0, 0], (100, 1))
while True:
    places = hand - np.outer(np.arange(1, 101) * ms, [0, 0, 2 * mm])
    left = simulation.distance_to("pulp", hapticut.Pose.from_translation(places[-1]))
    if left < 0.5 * mm:
        break
    simulation.run(hapticut.Pose.from_translation(places), velocities, 1 * ms)
    hand = places[-1]

for material in sorted(simulation.touched):
    print(f"{names[material - 1]} first touched after {simulation.first_touch_by_material[material]} ms")
left = simulation.distance_to("pulp", hapticut.Pose.from_translation(hand))
print(f"stopped {left / mm:.2f} mm from the pulp, after {simulation.steps} ms")

# The thinnest wall between the cavity and the pulp, by rays in all directions of the lower half.
rng = np.random.default_rng(1)
directions = rng.normal(size=(500, 3))
directions[:, 2] = -abs(directions[:, 2])
center = np.tile(hand - [0, 0, 20 * mm], (500, 1))
walls = simulation.workpiece.first_hits(center, directions, 5 * mm)
pulps = simulation.workpiece.first_hits(center, directions, 5 * mm, material="pulp")
met = np.isfinite(pulps["distance"])
wall = (pulps["distance"] - walls["distance"])[met].min()
print(f"thinnest wall that {met.sum()} rays found: {wall / mm:.2f} mm")
