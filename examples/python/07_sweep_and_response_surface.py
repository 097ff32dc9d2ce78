# SPDX-License-Identifier: Apache-2.0
"""2 000 drilling runs over feed, speed and material, and a response surface through the results.

    python 07_sweep_and_response_surface.py FOLDER [RUNS]                            # on all processors
    python 07_sweep_and_response_surface.py FOLDER RUNS dask [tcp://scheduler:8786]  # on a cluster of dask
    mpiexec -n 65 python -m mpi4py.futures 07_sweep_and_response_surface.py FOLDER RUNS mpi

All three give the same table. A second start computes only the runs that FOLDER does not have yet."""
import sys
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import hapticut
from hapticut.units import mm, ms

RADIUS = 0.6 * mm
MATERIALS = ("enamel", "dentin", "cortical_bone", "trabecular_bone")


def drill(parameters: dict[str, Any], rng: np.random.Generator) -> dict[str, float]:
    """Steady thrust and torque of a flat burr, from 0.15 to 0.3 mm depth."""
    material = hapticut.find_preset(parameters["material"])
    box = hapticut.Box([-0.8 * mm, -0.8 * mm, -0.5 * mm], [0.8 * mm, 0.8 * mm, 0])
    block = hapticut.build_block(box, 0.05 * mm, material)
    head = hapticut.FlatHead(RADIUS, 1 * mm, hapticut.FlatRule.bottom_only)
    tool = hapticut.Tool(head, spindle=hapticut.Spindle(parameters["speed"]))
    n = int(round(0.3 * mm / (parameters["feed"] * ms)))
    hand = np.zeros((n, 3))
    hand[:, :2] = rng.uniform(-0.02 * mm, 0.02 * mm, 2)  # where the burr touches down
    hand[:, 2] = -0.3 * mm * np.arange(1, n + 1) / n
    simulation = hapticut.Simulation(block, tool)
    trace = simulation.run(hapticut.Pose.from_translation(hand), np.zeros((n, 6)), 1 * ms)[n // 2:]
    return {"thrust": trace["force"][:, 2].mean(), "torque": -trace["torque"][:, 2].mean()}


def executor_of(name: str = "processes", *address: str) -> Any:
    """The executor of the runs; None is a pool of processes."""
    if name == "dask":
        from dask.distributed import Client
        return Client(*address).get_executor()
    if name == "mpi":
        from mpi4py.futures import MPIPoolExecutor
        return MPIPoolExecutor()
    return None


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    design = hapticut.sweep.latin_hypercube(runs // len(MATERIALS), {"feed": (1e-3, 4e-3), "speed": (2e3, 2e4, "log")},
                                            seed=1)
    space = [{**point, "material": material} for material in MATERIALS for point in design]
    table = hapticut.sweep(space, drill, executor_of(*sys.argv[3:]), folder / "sweep", seed=1,
                           units={"feed": "m/s", "speed": "rad/s", "thrust": "N", "torque": "N·m"})

    # ln F = a + b ln(feed) + c ln(speed) for each material. The chips of a bur are so thin that their size effect
    # dominates the energy: theory (C35) then gives b = 1/2 and c = -1/2. A constant energy (C20) gives 1 and -1.
    figure, axes = plt.subplots(1, len(MATERIALS), figsize=(14, 3.6), layout="constrained", sharey=True)
    for ax, (material, rows) in zip(axes, table.groupby("material", sort=False)):
        A = np.column_stack([np.ones(len(rows)), np.log(rows["feed"]), np.log(rows["speed"])])
        fit, *_ = np.linalg.lstsq(A, np.log(rows["thrust"]), rcond=None)
        r2 = 1 - np.var(np.log(rows["thrust"]) - A @ fit) / np.var(np.log(rows["thrust"]))
        print(f"{material}: thrust ~ feed^{fit[1]:.2f} speed^{fit[2]:.2f}, R^2 = {r2:.3f}")
        feed, speed = np.meshgrid(np.linspace(1e-3, 4e-3, 40), np.geomspace(2e3, 2e4, 40))
        surface = np.exp(fit[0] + fit[1] * np.log(feed) + fit[2] * np.log(speed))
        lines = ax.contour(feed * 1e3, speed, surface, 8, cmap="viridis")
        ax.clabel(lines, fmt="%.2g N", fontsize=8)
        ax.scatter(rows["feed"] * 1e3, rows["speed"], s=2, color="0.85")
        ax.set(title=f"{material}: thrust", xlabel="feed [mm/s]", yscale="log")
    axes[0].set_ylabel("spindle speed [rad/s]")
    figure.savefig(folder / "response_surface.png", dpi=120)


if __name__ == "__main__":
    main()
