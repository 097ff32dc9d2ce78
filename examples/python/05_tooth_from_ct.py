# SPDX-License-Identifier: Apache-2.0
"""Builds a tooth from CT grey values and drills it. Thresholds turn grey values into labels, and labels into materials.

The example needs no file: it computes the grey values from the built-in molar. With a file, use
`hapticut.io.read_grey_volume("scan.nrrd").values`."""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from scipy.ndimage import gaussian_filter, maximum_filter

import hapticut
import plots
from hapticut.units import mm, ms, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
molar = hapticut.build_molar(0.2 * mm)
rng = np.random.default_rng(1)
hounsfield = np.array([-1000.0, 2600.0, 1500.0, 40.0])[np.pad(molar.material_array(), 4)]
ct = (gaussian_filter(hounsfield, 0.6) + rng.normal(scale=40, size=hounsfield.shape)).astype(np.int16)

# A scanner blurs edges: between enamel and air the values pass through those of dentin. So each sample that is not air
# gets the label of the densest tissue beside it.
labels = np.where(ct > 600, np.where(maximum_filter(ct, 3) > 2050, 2, 1), 0).astype(np.uint8)
materials = {1: hapticut.presets.dentin(), 2: hapticut.presets.enamel()}
tooth = hapticut.Workpiece.from_labels(labels, [0.2 * mm] * 3, materials)
for amount, material in zip(tooth.amounts(), tooth.materials):
    print(f"{material.name}: {amount.volume * 1e9:.0f} mm^3, {amount.mass * 1e3:.2f} g")

# The burr comes down on the middle of the chewing surface, 2.5 mm in 1.25 s.
bounds = tooth.bounds()
middle = [(low + high) // 2 for low, high in zip(bounds.min, bounds.max)]
column = tooth.fill_array(hapticut.IndexBox([middle[0], middle[1], 0], [middle[0], middle[1], bounds.max[2]]))
surface = tooth.frame.center([middle[0], middle[1], int(np.flatnonzero(column[0, 0] > 0.5)[-1])])
burr = hapticut.Tool(hapticut.catalogue.round_head(1.8 * mm), spindle=hapticut.Spindle(150_000 * rpm))
simulation = hapticut.Simulation(tooth, burr)
n = 1250
hand = np.tile(surface + [0, 0, 1.1 * mm], (n, 1))
hand[:, 2] -= 2.5 * mm * np.arange(1, n + 1) / n
trace = simulation.run(hapticut.Pose.from_translation(hand), np.tile([0, 0, -2 * mm, 0, 0, 0], (n, 1)), 1 * ms)
print(f"max force {trace['force'][:, 2].max():.2f} N, removed {trace['removed_volume'].sum() * 1e9:.1f} mm^3")
plots.slice_through(simulation.workpiece, axis=1, index=middle[1])
plt.savefig(folder / "tooth_section.png", dpi=120)
plots.surface(simulation.workpiece, elevation=55)
plt.savefig(folder / "tooth.png", dpi=120)
