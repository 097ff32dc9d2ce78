# SPDX-License-Identifier: Apache-2.0
"""Plots of runs and workpieces, for the other examples and for you to copy. Each function draws on the given axes, or
on new ones, and returns the axes."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib import collections, patches
from matplotlib.axes import Axes
from numpy.typing import NDArray

import hapticut
from hapticut.units import mm


def colors_of(workpiece: hapticut.Workpiece) -> NDArray[np.float64]:
    """Colours (n + 1, 3) by material id: white for air, the colour of the preset, else one of a palette."""
    presets = {name: hapticut.preset_color(name) for name in hapticut.preset_names()}
    colors = [presets.get(material.name) for material in workpiece.materials.all()]
    return np.array([(1, 1, 1), *((c.red / 255, c.green / 255, c.blue / 255) if c else plt.cm.tab20(n % 20)[:3]
                                  for n, c in enumerate(colors))])


def force(trace: NDArray[np.void], ax: "Axes | None" = None) -> Axes:
    """Plots the force on the tool over time, for each axis of W. `trace` is the return value of `Simulation.run`."""
    ax = ax or plt.subplots(layout="constrained")[1]
    for axis, color in enumerate(("#c0392b", "#1e8449", "#2471a3")):
        ax.plot(trace["time"], trace["force"][:, axis], color=color, label="xyz"[axis])
    ax.plot(trace["time"], np.linalg.norm(trace["force"], axis=1), color="0.3", linewidth=4, alpha=0.3, label="length")
    ax.set(xlabel="time [s]", ylabel="force on the tool [N]")
    ax.legend(ncols=4)
    return ax


def removed_volume(simulation: hapticut.Simulation, ax: "Axes | None" = None) -> Axes:
    """Plots the removed volume of each material."""
    ax = ax or plt.subplots(layout="constrained")[1]
    names = [material.name for material in simulation.workpiece.materials.all()]
    volumes = simulation.removed_volume_by_material[1 : len(names) + 1] / mm**3
    ax.bar_label(ax.barh(names, volumes, color=colors_of(simulation.workpiece)[1:], edgecolor="0.3"), fmt=" %.3g")
    ax.set(xlabel="removed volume [mm³]", xmargin=0.15)
    return ax


def slice_through(workpiece: hapticut.Workpiece, axis: int, index: "int | None" = None,
                  ax: "Axes | None" = None) -> Axes:
    """Plots the materials in one layer of voxels, by default the middle one. Partly cut voxels are paler."""
    ax, colors = ax or plt.subplots(layout="constrained")[1], colors_of(workpiece)
    low, high = list(workpiece.bounds().min), list(workpiece.bounds().max)
    low[axis] = high[axis] = (low[axis] + high[axis]) // 2 if index is None else index
    box = hapticut.IndexBox(min=low, max=high)
    material, fill = workpiece.material_array(box).squeeze(axis), workpiece.fill_array(box).squeeze(axis)
    across, up = (a for a in range(3) if a != axis)
    left, right, bottom, top = (edge * workpiece.voxel_size / mm for a in (across, up)
                                for edge in (low[a] - 0.5, high[a] + 0.5))
    picture = 1 + fill[..., None] * (colors[material] - 1)
    ax.imshow(picture.swapaxes(0, 1), origin="lower", extent=(left, right, bottom, top), interpolation="nearest")
    ax.set(xlabel=f"{'ijk'[across]} [mm]", ylabel=f"{'ijk'[up]} [mm]", title=f"layer {'ijk'[axis]} = {low[axis]}")
    ax.legend(handles=[patches.Patch(facecolor=colors[n], edgecolor="0.3", label=workpiece.materials[int(n)].name)
                       for n in np.unique(material[fill > 0])], loc="center left", bbox_to_anchor=(1.01, 0.5))
    return ax


def surface(workpiece: hapticut.Workpiece, ax: "Axes | None" = None, elevation: float = 35.0,
            azimuth: float = -60.0) -> Axes:
    """Plots the surface of a workpiece in mm, seen from a camera at `elevation` and `azimuth` [deg]."""
    ax = ax or plt.subplots(layout="constrained")[1]
    found, (el, az) = hapticut.extract_surface(workpiece), np.radians([elevation, azimuth])
    towards = np.array([np.cos(el) * np.cos(az), np.cos(el) * np.sin(az), np.sin(el)])  # the camera
    right = np.array([-np.sin(az), np.cos(az), 0.0])
    corners = found.mesh.vertices[found.mesh.triangles] / mm
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    seen = np.flatnonzero(normals @ towards > 0)
    seen = seen[np.argsort(corners[seen].mean(axis=1) @ towards)]  # farthest first
    slopes = normals[seen] @ (0.8 * towards - 0.35 * right + 0.5 * np.cross(towards, right))
    shades = 0.45 + 0.55 * np.clip(slopes / np.linalg.norm(normals[seen], axis=1), 0, 1)
    materials = np.median(found.materials[found.mesh.triangles[seen]], axis=1).astype(int)
    colors = colors_of(workpiece)[materials] * shades[:, None]
    flat = np.stack([corners[seen] @ right, corners[seen] @ np.cross(towards, right)], axis=-1)
    ax.add_collection(collections.PolyCollection(list(flat), facecolors=colors, edgecolors=colors, linewidths=0.3))
    ax.axis("equal")
    return ax
