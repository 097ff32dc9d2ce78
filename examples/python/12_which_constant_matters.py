# SPDX-License-Identifier: Apache-2.0
"""Which constant of a preset decides the force of a drill and the rate of a bur: each number at both ends of its
published range, the others typical.

    python 12_which_constant_matters.py [FOLDER]"""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hapticut
from hapticut.units import mm, ms, rpm

NUMBERS = ("specific_cutting_energy", "share", "edge_length", "size_length", "cutting_ratio")


def plunge(material: hapticut.Material, head: hapticut.ToolHead, speed: float, feed: float) -> float:
    """Mean thrust [N] on a head that is fed [m/s] 0.4 mm along its axis, at the end."""
    box = hapticut.Box([-1.4 * mm, -1.4 * mm, -1.6 * mm], [1.4 * mm, 1.4 * mm, 0])
    assert material.cutter is not None  # of a hard material
    tool = hapticut.Tool(head, spindle=hapticut.Spindle(speed), cutter=hapticut.Cutter(kind=material.cutter))
    simulation = hapticut.Simulation(hapticut.build_block(box, 0.1 * mm, material), tool)
    n = int(1.4 * mm / (feed * ms))
    hand = np.zeros((n, 3))
    hand[:, 2] = -tool.head.tip() - 1.4 * mm * np.arange(1, n + 1) / n
    trace = simulation.run(hapticut.Pose.from_translation(hand), np.zeros((n, 6)), 1 * ms)
    return float(trace["force"][-n // 5:, 2].mean())


def spread(material: hapticut.Material, head: hapticut.ToolHead, speed: float,
           feed: float) -> "dict[str, tuple[float, float, float]]":
    """Thrust with each number at its low end, typical and high end."""
    def thrust(of: hapticut.Material) -> float:
        return plunge(of, head, speed, feed)

    typical, found = thrust(material), {}
    for number in NUMBERS:
        try:
            low, high = (material.with_(end, number) for end in (hapticut.Estimate.low, hapticut.Estimate.high))
        except hapticut.Error:  # this pair does not have the number
            continue
        found[number] = thrust(low), typical, thrust(high)
    return dict(sorted(found.items(), key=lambda item: abs(np.log(item[1][2] / item[1][0]))))


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    kind = hapticut.CutterKind
    cases = {
        "drill of 2 mm in cortical bone, 1500 rpm, 0.5 mm/s": spread(
            hapticut.presets.cortical_bone(kind.twist_drill), hapticut.catalogue.twist_drill_head(2 * mm, 12 * mm),
            1500 * rpm, 0.5e-3),
        "carbide bur of 2 mm in enamel, 300000 rpm, 0.5 mm/s": spread(
            hapticut.presets.enamel(kind.carbide_bur), hapticut.ToolHead(hapticut.SphereHead(1 * mm)),
            300000 * rpm, 0.5e-3)}
    figure, axes = plt.subplots(1, len(cases), figsize=(12, 3.4), layout="constrained")
    for ax, (name, found) in zip(axes, cases.items()):
        for row, (number, (low, typical, high)) in enumerate(found.items()):
            ax.barh(row, high - low, left=low, color="#2471a3")
            ax.plot([typical, typical], [row - 0.4, row + 0.4], color="#c0392b")
        ax.set(title=name, xlabel="thrust [N]", yticks=range(len(found)), yticklabels=list(found))
        most = list(found)[-1]
        print(f"{name}: {most} matters most, {min(found[most][::2]):.2g} ... {max(found[most][::2]):.2g} N")
    figure.savefig(folder / "which_constant_matters.png", dpi=120)


if __name__ == "__main__":
    main()
