# SPDX-License-Identifier: Apache-2.0
"""A mock device held by a simulated hand drills a block; what went in is recorded and run again: the same bits."""
import sys
from pathlib import Path

import numpy as np

import hapticut
from hapticut import plot
from hapticut.units import mm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
box = hapticut.Box([-12 * mm, -12 * mm, -8 * mm], [12 * mm, 12 * mm, 0])
block = hapticut.build_block(box, 0.25 * mm, hapticut.presets.clay())
tool = hapticut.Tool(hapticut.SphereHead(2 * mm), spindle=hapticut.Spindle(3000.0))
# The device is driven directly, so the foundation may not be stiffer than it can render.
config = hapticut.SimulationConfig(reference_stiffness=hapticut.stiffness_for_device(tool.head, 600.0))
simulation = hapticut.Simulation(block, tool, config)
device = hapticut.open_device("mock:spiral,device=touch,hand=nominal")
poses, velocities, forces = [], [], []


def tick(state):
    """One millisecond: from the reading to the force."""
    poses.append(state.X_BS)
    velocities.append(state.velocity)
    result = simulation.step(state.X_BS, state.velocity, 1e-3)
    forces.append(result.force)
    return hapticut.DeviceCommand(hapticut.Wrench(result.force, result.torque))


report = device.run(tick, hapticut.RunOptions(seconds=4, simulated_time=True))
np.savez(folder / "recording.npz", poses=np.array(poses), velocities=np.array(velocities), forces=np.array(forces))

recording = np.load(folder / "recording.npz")
again = hapticut.Simulation(block, tool, config)
trace = again.run(recording["poses"], recording["velocities"], 1e-3)
same = np.array_equal(trace["force"], recording["forces"]) and again.workpiece.hash() == simulation.workpiece.hash()
print(f"{report.ticks} ticks ({report.end}); the replay is {'identical, bit by bit' if same else 'DIFFERENT'}")
plot.force(trace).figure.savefig(folder / "replay.png", dpi=120)
sys.exit(0 if same else 1)
