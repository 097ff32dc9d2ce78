# SPDX-License-Identifier: Apache-2.0
"""Pictures of runs, workpieces and sweeps with matplotlib. Every function draws on the axes it is given, or on new
ones, and returns them; nothing is shown or saved here."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _hapticut as core
from ._export import export

try:
    import matplotlib.pyplot as plt
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Patch
except ImportError:
    raise core.Error("plots need matplotlib: pip install 'hapticut[plot]'.") from None

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

__all__ = ["colors_of", "force", "latency", "removed_volume", "slice_through", "surface", "sweep_matrix", "torque"]

AXIS_COLORS = ("#c0392b", "#1e8449", "#2471a3")  # x, y, z
INK = "#2c3e50"


def _axes(ax: Optional[Axes], **size: Any) -> Axes:
    if ax is not None:
        return ax
    created: Axes = plt.subplots(layout="constrained", **size)[1]
    return created


def _finish(ax: Axes, x: str, y: str, title: str = "") -> None:
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title)
    ax.spines[["top", "right"]].set_visible(False)
    ax.grid(alpha=0.25, linewidth=0.6)


def _three_components(ax: Optional[Axes], trace: NDArray[Any], field: str, factor: float, label: str) -> Axes:
    names = getattr(getattr(trace, "dtype", None), "names", None) or ()
    if "time" not in names or field not in names:
        raise core.Error(f"the trace has no fields time and {field}; give what Simulation.run returned.")
    if len(trace) == 0:
        raise core.Error("the trace holds no step, so there is nothing to draw.")
    ax = _axes(ax, figsize=(7, 3.2))
    time = trace["time"]
    values = trace[field] * factor
    marker = "o" if len(trace) == 1 else None  # a line of one point would not be seen
    for axis, (name, color) in enumerate(zip("xyz", AXIS_COLORS)):
        ax.plot(time, values[:, axis], color=color, linewidth=1.1, marker=marker, label=name)
    # Behind the others and wider: it often coincides with one of them.
    ax.plot(time, np.linalg.norm(values, axis=1), color=INK, linewidth=3.5, marker=marker, markersize=10, alpha=0.3,
            zorder=1.5, label="length")
    _finish(ax, "time [s]", label)
    ax.legend(ncols=4, frameon=False, loc="best")
    return ax


def force(trace: NDArray[Any], ax: Optional[Axes] = None) -> Axes:
    """What the hand feels over time, by axis of W.

    Parameters
    ----------
    trace
        From `Simulation.run`.
    """
    return _three_components(ax, trace, "force", 1.0, "force on the tool [N]")


def torque(trace: NDArray[Any], ax: Optional[Axes] = None) -> Axes:
    """The torque about the handle's point over time, by axis of W."""
    return _three_components(ax, trace, "torque", 1e3, "torque about Ho [N mm]")


def colors_of(names: Sequence[str]) -> list[tuple[float, ...]]:
    """A colour for each material of a table: that of the preset, or the next one of a palette of 20."""
    known = core.preset_names()
    pairs = plt.get_cmap("tab20")  # of a dark colour and a pale one
    palette = [pairs(n)[:3] for n in (*range(0, 20, 2), *range(1, 20, 2))]
    others = [name for name in names if name not in known]
    presets = {name: core.preset_color(name) for name in names if name in known}
    return [tuple(c / 255 for c in (presets[name].red, presets[name].green, presets[name].blue)) if name in presets
            else palette[others.index(name) % len(palette)] for name in names]


def removed_volume(simulation: core.Simulation, ax: Optional[Axes] = None) -> Axes:
    """The volume taken away so far, by material."""
    ax = _axes(ax, figsize=(6, 3.2))
    names = [material.name for material in simulation.workpiece.materials.all()]
    volumes = simulation.removed_volume_by_material[1 : len(names) + 1] * 1e9
    bars = ax.barh(names, volumes, color=colors_of(names), edgecolor=INK, linewidth=0.6)
    ax.bar_label(bars, fmt=" %.3g", color=INK)
    ax.invert_yaxis()
    ax.set_xlim(0, 1.15 * volumes.max() or 1)
    _finish(ax, "removed volume [mm³]", "")
    ax.grid(axis="y", visible=False)
    return ax


def latency(times: Union[core.LatencyHistogram, NDArray[np.float64]], ax: Optional[Axes] = None,
            deadline: float = 1e-3) -> Axes:
    """How long steps took, against the deadline.

    Parameters
    ----------
    times
        [s] (n,), or a histogram of a run of a device.
    deadline
        [s] drawn as a line; what lies beyond it is counted in the legend.
    """
    if not 0 < deadline < np.inf:
        raise core.Error(f"deadline = {deadline} s; must be > 0 and finite.")
    if isinstance(times, core.LatencyHistogram):
        if times.count == 0:
            raise core.Error("the histogram is empty; nothing was measured.")
        width = core.LatencyHistogram.kBucketWidth
        reach = width * len(times.buckets)
        if times.longer > 0 and reach < deadline <= times.max:
            raise core.Error(f"deadline = {deadline} s; the histogram does not tell apart what is longer than {reach} s.")
        # What is longer than all buckets is drawn where the longest was.
        values = np.append(width * (0.5 + np.arange(len(times.buckets))), times.max)
        weights = np.append(times.buckets, times.longer).astype(float)
        typical, p99 = times.quantile(0.5), times.quantile(0.99)
    else:
        values = np.ravel(np.asarray(times, dtype=float))
        if values.size == 0 or not (np.isfinite(values) & (values >= 0)).all():
            raise core.Error("times must hold at least one number, and only finite ones that are not negative.")
        weights = np.ones(values.size)
        typical, p99 = float(np.median(values)), float(np.quantile(values, 0.99))
    ax = _axes(ax, figsize=(7, 3.2))
    misses, total = int(weights[values > deadline].sum()), int(weights.sum())
    shown = np.maximum(values[weights > 0] * 1e6, 0.1)  # the axis is logarithmic
    bins = np.geomspace(shown.min() * 0.9, max(shown.max(), deadline * 1e6) * 1.2, 80)
    ax.hist(shown, bins=bins.tolist(), weights=weights[weights > 0], color="#5d8aa8")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_ylim(bottom=0.7)
    ax.axvline(deadline * 1e6, color=AXIS_COLORS[0], linewidth=1.5,
               label=f"deadline {deadline * 1e3:g} ms: {misses} of {total} later")
    ax.axvline(typical * 1e6, color=INK, linestyle="--", linewidth=1, label=f"median {typical * 1e6:.3g} µs")
    ax.axvline(p99 * 1e6, color=INK, linestyle=":", linewidth=1.2, label=f"99 % {p99 * 1e6:.3g} µs")
    _finish(ax, "time of a step [µs]", "steps")
    ax.legend(frameon=False, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    return ax


def sweep_matrix(table: pd.DataFrame, x: str, y: str, value: str, ax: Optional[Axes] = None,
                 units: Optional[Mapping[str, str]] = None) -> Axes:
    """One result over two parameters of a grid, as coloured cells; the mean where there are several runs in one.

    Parameters
    ----------
    table
        From `hapticut.sweep`; runs with an error are left out.
    x, y, value
        Names of columns.
    """
    for name in (x, y, value):
        if name not in table.columns:
            raise core.Error(f"the table has no column {name!r}; it has {list(table.columns)}.")
    if x == y:
        raise core.Error(f"x and y are both {x!r}; a matrix needs two columns.")
    if table[value].dtype.kind not in "biuf":
        raise core.Error(f"column {value!r} does not hold numbers.")
    good = table[table["error"].fillna("") == ""] if "error" in table.columns else table
    cells = good.pivot_table(index=y, columns=x, values=value, aggfunc="mean")
    if cells.size == 0:
        raise core.Error("there is no run without an error to draw.")
    ax = _axes(ax, figsize=(6, 4))
    image = ax.pcolormesh(np.arange(cells.shape[1] + 1), np.arange(cells.shape[0] + 1), cells.to_numpy(dtype=float),
                          cmap="viridis", edgecolors="white" if cells.size <= 100 else "face", linewidth=0.5)
    known = {**table.attrs.get("units", {}), **(units or {})}

    def label(name: str) -> str:
        return f"{name} [{known[name]}]" if name in known else name

    def ticks(values: Sequence[Any], most: int) -> tuple[list[float], list[str]]:
        numbers = all(isinstance(v, (int, float)) for v in values)
        every = -(-len(values) // most) if numbers else 1  # so few that they do not touch
        return ([at + 0.5 for at in range(0, len(values), every)],
                [f"{v:.4g}" if numbers else str(v) for v in values[::every]])

    ax.set_xticks(*ticks(cells.columns.tolist(), 5))
    ax.set_yticks(*ticks(cells.index.tolist(), 16))
    if sum(len(label.get_text()) for label in ax.get_xticklabels()) > 48:
        ax.tick_params(axis="x", rotation=30)
    ax.set_xlabel(label(x))
    ax.set_ylabel(label(y))
    if cells.size <= 100:
        middle = sum(image.get_clim()) / 2  # of the colours: darker ones get white digits
        for (row, column), number in np.ndenumerate(cells.to_numpy(dtype=float)):
            if np.isfinite(number):
                ax.text(column + 0.5, row + 0.5, f"{number:.3g}", ha="center", va="center", fontsize=8,
                        color="white" if number < middle else "black")
    ax.figure.colorbar(image, ax=ax, label=label(value))
    return ax


def slice_through(workpiece: core.Workpiece, axis: int = 1, index: Optional[int] = None,
                  ax: Optional[Axes] = None) -> Axes:
    """The materials in one layer of voxels, paler where voxels are partly cut.

    Parameters
    ----------
    axis
        0, 1 or 2: the grid's axis across the layer.
    index
        Of the layer; None: in the middle.
    """
    if axis not in (0, 1, 2):
        raise core.Error(f"axis = {axis}; must be 0, 1 or 2.")
    if workpiece.empty():
        raise core.Error("nothing is left of the workpiece, so there is no layer to draw.")
    ax = _axes(ax, figsize=(6, 4.5))
    bounds = workpiece.bounds()
    if index is None:
        index = (bounds.min[axis] + bounds.max[axis]) // 2
    low, high = list(bounds.min), list(bounds.max)
    low[axis] = high[axis] = index
    box = core.IndexBox(min=low, max=high)
    material = workpiece.material_array(box).squeeze(axis)
    fill = workpiece.fill_array(box).squeeze(axis)
    table = workpiece.materials.all()
    colors = np.array([(1.0, 1.0, 1.0), *colors_of([entry.name for entry in table])])
    picture = 1 + fill[..., None] * (colors[material] - 1)
    across, up = [a for a in range(3) if a != axis]
    mm = workpiece.voxel_size * 1e3
    extent = ((low[across] - 0.5) * mm, (high[across] + 0.5) * mm, (low[up] - 0.5) * mm, (high[up] + 0.5) * mm)
    ax.imshow(np.swapaxes(picture, 0, 1), origin="lower", extent=extent, interpolation="nearest")
    ax.set_xlabel(f"{'ijk'[across]} of the grid [mm]")
    ax.set_ylabel(f"{'ijk'[up]} of the grid [mm]")
    ax.set_title(f"layer {'ijk'[axis]} = {index}")
    present = np.unique(material[fill > 0])
    ax.legend(handles=[Patch(facecolor=colors[n], edgecolor=INK, linewidth=0.5, label=table[n - 1].name)
                       for n in present if n > 0], frameon=False, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return ax


def surface(workpiece: core.Workpiece, ax: Optional[Axes] = None, elevation: float = 35.0,
            azimuth: float = -60.0) -> Axes:
    """What is left of a workpiece, seen from outside in the colours of its materials.

    Parameters
    ----------
    elevation, azimuth
        [deg] of the camera above the xy plane of W, and about z.
    """
    ax = _axes(ax, figsize=(6, 5))
    found = core.extract_surface(workpiece)
    triangles = found.mesh.triangles
    if len(triangles) == 0:
        raise core.Error("nothing is left of the workpiece, so there is no surface to draw.")
    vertices = found.mesh.vertices * 1e3
    colors = np.array([(0.8, 0.8, 0.8), *colors_of([entry.name for entry in workpiece.materials.all()])])
    el, az = np.radians([elevation, azimuth])
    towards = np.array([np.cos(el) * np.cos(az), np.cos(el) * np.sin(az), np.sin(el)])  # the camera
    right = np.array([-np.sin(az), np.cos(az), 0.0])
    up = np.cross(towards, right)
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    facing = (normals @ towards) > 0
    seen = facing & (lengths > 0)
    corners, normals = corners[seen], normals[seen] / lengths[seen, None]
    order = np.argsort(corners.mean(axis=1) @ towards)  # the farthest first: the painter's way
    light = 0.8 * towards - 0.35 * right + 0.5 * up
    shade = 0.45 + 0.55 * np.clip(normals @ (light / np.linalg.norm(light)), 0, 1)
    base = colors[np.median(found.materials[triangles[seen]], axis=1).astype(int)]
    flat = np.stack([corners @ right, corners @ up], axis=-1)
    shown = np.clip(base * shade[:, None], 0, 1)[order]
    ax.add_collection(PolyCollection(list(flat[order]), facecolors=shown, edgecolors=shown, linewidths=0.3,
                                     rasterized=True))
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.axis("off")
    low, high = ax.get_xlim()
    bar = 10 ** np.floor(np.log10((high - low) / 3))
    bottom = ax.get_ylim()[0]
    ax.plot([low, low + bar], [bottom, bottom], color=INK, linewidth=2, solid_capstyle="butt")
    ax.text(low, bottom, f"{bar:g} mm", ha="left", va="bottom", color=INK, fontsize=9)
    return ax


export(__name__)
