# SPDX-License-Identifier: Apache-2.0
"""Draws a moving picture: a bur mills a cavity into the built-in molar.

    10_moving_picture.py [FOLDER] [FRAMES] [VOXEL_MM]     writes drilling.webp"""
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import hapticut
from hapticut.units import mm, ms, rpm

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
frames = int(sys.argv[2] if len(sys.argv) > 2 else 60)
voxel = float(sys.argv[3] if len(sys.argv) > 3 else 0.1) * mm

head = hapticut.catalogue.round_end_cylinder_head(1.4 * mm, 4 * mm)
tool = hapticut.Tool(head, spindle=hapticut.Spindle(200_000 * rpm))
simulation = hapticut.Simulation(hapticut.build_molar(voxel), tool)

# The tip goes down through the central fossa in 2 s, widens the cavity along a spiral of 5 s, and rises in 1 s.
down, wide, up = 2000, 5000, 1000
phase = np.concatenate([np.zeros(down), np.linspace(0, 6 * np.pi, wide), np.full(up, 6 * np.pi)])
radius = phase / phase[-1] * 1.3 * mm
height = np.concatenate([np.linspace(7.5, 2.8, down), np.full(wide, 2.8), np.linspace(2.8, 9, up)]) * mm
hand = np.column_stack([radius * np.cos(phase), radius * np.sin(phase), height + 0.7 * mm])  # the hand is at To
velocity = np.hstack([np.gradient(hand, 1 * ms, axis=0), np.zeros_like(hand)])

steel = hapticut.Color(150, 155, 165)
edge = hapticut.ProfileEdge
shank = hapticut.Profile(tip=3.3 * mm, edges=[edge(0.7 * mm, 3.3 * mm), edge(0.8 * mm, 4.3 * mm),
                                              edge(0.8 * mm, 9 * mm), edge(0, 9 * mm)])
parts = [hapticut.mesh_of_revolution(profile, 48) for profile in (head.profile(), shank)]
# The camera shows all meshes. Three specks around all places of the tool keep it still.
corners = np.array([[2, 0, 20], [-2, 0, 20], [0, 0, -16]]) * mm
specks = hapticut.TriangleMesh(np.vstack([corners, corners + [1e-9, 0, 0], corners + [0, 1e-9, 0]]),
                               [[n, n + 3, n + 6] for n in range(3)])
camera = hapticut.io.PictureOptions(width=640, height=480, view_direction=[-0.35, 0.6, -1], scale_bar=False)


def moved(mesh: hapticut.TriangleMesh, to: NDArray[np.float64]) -> hapticut.ColoredMesh:
    return hapticut.ColoredMesh(hapticut.TriangleMesh(mesh.vertices + to, mesh.triangles), [steel] * len(mesh.vertices))


pictures, force = [], []
for steps in np.array_split(np.arange(len(hand)), frames):
    trace = simulation.run(hapticut.Pose.from_translation(hand[steps]), velocity[steps], 1 * ms)
    force.append(np.linalg.norm(trace["force"], axis=1).max())
    molar = hapticut.io.colored(hapticut.extract_surface(simulation.workpiece), simulation.workpiece.materials)
    bur = [moved(part, hand[steps[-1]]) for part in parts]
    hapticut.io.write_picture([molar, *bur, moved(specks, np.zeros(3))], camera, folder / "frame.png")
    pictures.append(Image.open(folder / "frame.png").convert("RGB"))
(folder / "frame.png").unlink()
pictures[0].save(folder / "drilling.webp", save_all=True, append_images=pictures[1:], duration=len(hand) // frames,
                 loop=0, quality=75)  # duration: [ms] of a frame
removed = sum(simulation.removed_volume_by_material)
print(f"{frames} frames, max force {max(force):.2f} N, removed {removed / mm**3:.1f} mm^3")
