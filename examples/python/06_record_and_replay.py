# SPDX-License-Identifier: Apache-2.0
"""A mock device held by a simulated hand drills a block; every step goes into a file, and is made again from the file
alone: the same bits."""
import sys
from pathlib import Path

import hapticut
import plots
from hapticut import io
from hapticut.device import DeviceCommand, RunOptions, open_device
from hapticut.loop import SpindleInterlock
from hapticut.units import mm, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
box = hapticut.Box([-12 * mm, -12 * mm, -8 * mm], [12 * mm, 12 * mm, 0])
block = hapticut.build_block(box, 0.25 * mm, hapticut.presets.clay())
tool = hapticut.Tool(hapticut.SphereHead(2 * mm), spindle=hapticut.Spindle(30_000 * rpm))
# The device is driven directly, so the foundation may not be stiffer than it can render.
config = hapticut.SimulationConfig(reference_stiffness=hapticut.stiffness_for_device(tool.head, 600.0))
simulation = hapticut.Simulation(block, tool, config)
device = open_device("mock:spiral,device=touch,hand=nominal")
interlock = SpindleInterlock()
file = folder / "recording.h5"

# A mock is quicker than the disk; a real device may not wait, and need not.
options = io.RecorderOptions(wait_when_full=True)
with io.Recorder(file, simulation, options, driven_by=device):
    def tick(state):
        """One millisecond: from the reading to the force."""
        interlock.update(simulation, device.arming)  # nothing is cut that the hand does not feel
        result = simulation.step(state.X_BS, state.velocity, 1e-3)
        return DeviceCommand(hapticut.Wrench(result.force, result.torque))

    report = device.run(tick, RunOptions(seconds=4, simulated_time=True))

recording = io.read_recording(file)
replay = io.replay(recording)
print(f"{report.ticks} ticks ({report.end}), {file.stat().st_size / 1e6:.1f} MB; the replay of {replay.steps} steps is "
      f"{'identical, bit by bit' if replay.identical else f'different: {replay.first_difference}'}")
plots.force(recording.read()["trace"]).figure.savefig(folder / "replay.png", dpi=120)
sys.exit(0 if replay.identical else 1)
