# SPDX-License-Identifier: Apache-2.0
"""Figures 7.1-7.3 of the thesis: three heads step into a cube. Plots the removed voxels, the force and the torque of
each step, in thesis mode and by the default model."""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import hapticut
from hapticut.units import N_mm, deg, mm, ms, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
SIZE, STEP, STEPS, VOXEL = 0.3 * mm, 0.02 * mm, 14, 0.01 * mm
BOX = hapticut.Box([-0.36 * mm, -0.36 * mm, -0.4 * mm], [0.36 * mm, 0.36 * mm, 0])
CUBE = hapticut.build_block(BOX, VOXEL, hapticut.Material("cube", relative_stiffness=0.4))


def step_down(head: hapticut.ToolHead, thesis: bool) -> NDArray[np.float64]:
    """(steps, 3): voxels removed, force [N] and torque [N mm] of every step."""
    config = hapticut.thesis_mode() if thesis else hapticut.SimulationConfig()
    simulation = hapticut.Simulation(CUBE, hapticut.Tool(head, spindle=hapticut.Spindle(300_000 * rpm)), config)
    still, top = np.zeros(6), -head.bounding_box().min[2]

    def pose_at(depth: float) -> NDArray[np.float64]:
        return hapticut.Pose.from_translation([0.0013 * mm, 0.0021 * mm, top - depth])

    simulation.step(pose_at(0), still, 1 * ms)  # touches the cube
    ticks = 1 if thesis else 20  # a cut of the default model takes time
    rows = []
    for i in range(STEPS):
        results = []
        for tick in range(1, ticks + 1):
            results.append(simulation.step(pose_at(STEP * (i + tick / ticks)), still, 1 * ms))
        rows.append((sum(r.removed_volume for r in results) / VOXEL**3, np.mean([r.force[2] for r in results]),
                     -np.mean([r.torque[2] for r in results]) / N_mm))
    return np.array(rows)


heads = {"sphere": hapticut.ToolHead(hapticut.SphereHead(SIZE)),
         "cone": hapticut.ToolHead(hapticut.ConeHead(45 * deg, SIZE)),
         "flat": hapticut.ToolHead(hapticut.FlatHead(SIZE, SIZE, hapticut.FlatRule.bottom_only))}
figures = [("figure_7_1_voxels", "voxels removed in a step"), ("figure_7_2_force", "cutting force of a step [N]"),
           ("figure_7_3_torque", "cutting torque of a step [N mm]")]
series = {(name, thesis): step_down(head, thesis) for thesis in (True, False) for name, head in heads.items()}
for column, (file, label) in enumerate(figures):
    _, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for ax, thesis in zip(axes, (True, False)):
        for (name, mode), rows in series.items():
            if mode == thesis:
                ax.plot(np.arange(1, STEPS + 1), rows[:, column], marker="o", markersize=3, label=name)
        ax.set(title="model of the thesis" if thesis else "default model", xlabel="step", ylim=(0, None))
        ax.grid(alpha=0.25)
    axes[0].set_ylabel(label)
    axes[1].legend(frameon=False)
    axes[0].figure.savefig(folder / f"{file}.png", dpi=120)
flat, cone = series["flat", True][:, 0], series["cone", True][:, 0]
print(f"flat head: {flat[1]:.0f} ... {flat[-1]:.0f} voxels in every step; cone: {cone[0]:.0f} rising to {cone[-1]:.0f}")
