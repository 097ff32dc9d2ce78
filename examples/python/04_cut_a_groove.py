# SPDX-License-Identifier: Apache-2.0
"""Cuts a groove through a layered slab. Plots the force, the removed volume, a section and the remaining surface."""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hapticut
import plots
from hapticut.units import mm, ms, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
box = hapticut.Box([-5 * mm, -2.5 * mm, -3 * mm], [5 * mm, 2.5 * mm, 0])
slab = hapticut.build_layered_slab(box, 0.1 * mm, [hapticut.Layer(hapticut.presets.enamel(), 0.6 * mm),
                                                   hapticut.Layer(hapticut.presets.dentin(), 2.4 * mm)])
tool = hapticut.Tool(hapticut.catalogue.round_end_cylinder_head(1.6 * mm, 4 * mm), hapticut.RayHandle(30 * mm),
                     hapticut.Spindle(200_000 * rpm))
simulation = hapticut.Simulation(slab, tool)

# Down to a depth of 1.2 mm in 0.6 s, then 6 mm along x in 3 s.
down, along = 600, 3000
tip = np.zeros((down + along, 3))
tip[:, 0] = -3 * mm
tip[:down, 2] = -1.2 * mm * np.arange(1, down + 1) / down
tip[down:, 0] += 6 * mm * np.arange(1, along + 1) / along
tip[down:, 2] = -1.2 * mm
hand = tip + [0, 0, 30 * mm]
velocities = np.zeros((len(hand), 6))
velocities[:, :3] = np.gradient(hand, 1 * ms, axis=0)
trace = simulation.run(hapticut.Pose.from_translation(hand), velocities, 1 * ms)

figure, axes = plt.subplots(2, 2, figsize=(12, 7), layout="constrained")
plots.force(trace, axes[0, 0])
plots.removed_volume(simulation, axes[0, 1])
plots.slice_through(simulation.workpiece, axis=1, ax=axes[1, 0])
plots.surface(simulation.workpiece, axes[1, 1])
figure.savefig(folder / "groove.png", dpi=120)
volume = trace["removed_volume"].sum()
print(f"removed {volume * 1e9:.2f} mm^3; the energy ledger is off by {simulation.last_result.energy.closure():.1e}")
