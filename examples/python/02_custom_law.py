# SPDX-License-Identifier: Apache-2.0
"""Compares the force laws of the library, with constants that you choose: a ball is pressed 0.5 mm into a block.

A new law is a class in C++ (examples/cpp/02_custom_law.cpp), because it runs inside the 1 kHz loop."""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hapticut
from hapticut.units import mm, ms

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
block = hapticut.build_block(hapticut.Box([-3 * mm, -3 * mm, -3 * mm], [3 * mm, 3 * mm, 0]), 0.1 * mm,
                             hapticut.Material("test", relative_stiffness=1.0))
tool = hapticut.Tool(hapticut.SphereHead(1.5 * mm))
depths = np.linspace(0.005, 0.5, 100) * mm
poses = hapticut.Pose.from_translation(np.outer(1.5 * mm - depths, [0, 0, 1]))

laws = {
    "foundation, k = 5e11 N/m^4": (5e11, hapticut.FoundationLaw()),
    "foundation, k = 1e12 N/m^4": (1e12, hapticut.FoundationLaw()),
    "Hertz, E* = 1 MPa": (1e12, hapticut.ContactMechanicsLaw(1e6)),
    "Hertzian burr, C1 = 1 MPa": (1e12, hapticut.HertzianBurrLaw(1e6)),
    "thesis, l0 = 0.1 mm": (1e12, hapticut.ThesisLaw(hapticut.ThesisLaw.Constants(reference_voxel_size=0.1 * mm))),
}
figure, ax = plt.subplots(figsize=(7, 4), layout="constrained")
for name, (stiffness, law) in laws.items():
    simulation = hapticut.Simulation(block, tool, hapticut.SimulationConfig(reference_stiffness=stiffness, law=law))
    force = simulation.run(poses, np.zeros((len(poses), 6)), 1 * ms)["force"][:, 2]
    ax.plot(depths / mm, force, "--" if name.startswith("thesis") else "-", label=name)  # equals the foundation
    print(f"{name}: {force[-1]:.3f} N at 0.5 mm")
ax.set(xlabel="depth [mm]", ylabel="force on the tool [N]")
ax.legend(frameon=False)
ax.grid(alpha=0.25)
figure.savefig(folder / "laws.png", dpi=120)
