# SPDX-License-Identifier: Apache-2.0
"""A mock device drills a block, and a recorder writes each step to a file. The replay of the file gives the same bits."""
import sys
from pathlib import Path

import matplotlib.pyplot as plt

import hapticut
import plots
from hapticut import io
from hapticut.device import DeviceCommand, DeviceState, RunOptions, open_device
from hapticut.loop import SpindleInterlock
from hapticut.units import mm, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
box = hapticut.Box([-12 * mm, -12 * mm, -8 * mm], [12 * mm, 12 * mm, 0])
block = hapticut.build_block(box, 0.25 * mm, hapticut.presets.clay())
tool = hapticut.Tool(hapticut.SphereHead(2 * mm), spindle=hapticut.Spindle(30_000 * rpm))
# Without a coupling the foundation must not be stiffer than the device can render.
config = hapticut.SimulationConfig(reference_stiffness=hapticut.stiffness_for_device(tool.head, 600.0))
simulation = hapticut.Simulation(block, tool, config)
device = open_device("mock:spiral,device=touch,hand=nominal")
interlock = SpindleInterlock()
file = folder / "recording.h5"

# A mock runs faster than the disk writes, so it must wait. A real device must never wait.
options = io.RecorderOptions(wait_when_full=True)
with io.Recorder(file, simulation, options, driven_by=device):
    def tick(state: DeviceState) -> DeviceCommand:
        """Computes the force of one millisecond from a reading."""
        interlock.update(simulation, device.arming)  # stops the spindle while the guard withholds the force
        result = simulation.step(state.X_BS, state.velocity, 1e-3)
        return DeviceCommand(hapticut.Wrench(result.force, result.torque))

    report = device.run(tick, RunOptions(seconds=4, simulated_time=True))

recording = io.read_recording(file)
replay = io.replay(recording)
print(f"{report.ticks} ticks ({report.end}), {file.stat().st_size / 1e6:.1f} MB; the replay of {replay.steps} steps is "
      f"{'identical, bit by bit' if replay.identical else f'different: {replay.first_difference}'}")
plots.force(recording.read()["trace"])
plt.savefig(folder / "replay.png", dpi=120)
sys.exit(0 if replay.identical else 1)
