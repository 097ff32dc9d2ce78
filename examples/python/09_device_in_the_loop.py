# SPDX-License-Identifier: Apache-2.0
"""A device cuts bone through a virtual coupling in the real-time loop. This thread reads states and changed blocks.

    09_device_in_the_loop.py [FOLDER [DEVICE]]     mock:spiral,hand=nominal; replay:FILE; ... (docs/devices.md)
"""
import sys
import time

import numpy as np

import hapticut
from hapticut.device import RunOptions, open_device
from hapticut.loop import (RealtimeLoop, RealtimeLoopOptions, SimulationModel, SimulationModelOptions,
                           WorkspaceMapOptions, commands)
from hapticut.units import mm, mm3, rpm

name = sys.argv[2] if len(sys.argv) > 2 else "mock:spiral,hand=nominal"
is_mock = name.startswith("mock:")
device = open_device(name)

box = hapticut.Box([-15 * mm, -15 * mm, -10 * mm], [15 * mm, 15 * mm, 0])
config = hapticut.SimulationConfig(contact_time=hapticut.ContactTime.end)  # a coupling needs it
simulation = hapticut.Simulation(hapticut.build_block(box, 0.25 * mm, hapticut.presets.cortical_bone()),
                                 hapticut.Tool(hapticut.SphereHead(1.5 * mm), spindle=hapticut.Spindle(30000 * rpm)),
                                 config)

X_WB = np.eye(4)
X_WB[2, 3] = 1.5 * mm  # the ball touches the bone when the stylus is at its origin
if not is_mock:
    X_WB[:3, :3] = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]  # a device's y axis points up, the world's z axis does
options = SimulationModelOptions(map=WorkspaceMapOptions(X_WB=X_WB),
                                 coupling=hapticut.coupling_gains(device.capabilities), undo_blocks=4096)
model = SimulationModel(simulation, device, options)

run = RunOptions(seconds=6, simulated_time=is_mock)  # a mock needs no real time
loop = RealtimeLoop(model, RealtimeLoopOptions(run=run, region=model.region))
loop.send(commands.SetUndoMark())
loop.start()
blocks = 0
while loop.is_running:
    tool_pose = loop.latest().X_WT  # draw the tool here
    while loop.receive() is not None:  # redraw these blocks
        blocks += 1
    time.sleep(0.016)
report = loop.wait()
print(f"{report.ticks} ticks ({report.end}), guard {report.arming.name}, removed "
      f"{simulation.removed_volume_by_material[1] / mm3:.4f} mm^3, at most {loop.latest().max_applied:.2f} N, "
      f"{blocks} changed blocks")

while not simulation.undo(64):  # between runs; while the loop runs: loop.send(commands.Undo())
    pass
print(f"undone: {simulation.workpiece.amounts()[0].volume / mm3:.0f} mm^3 of bone again")
