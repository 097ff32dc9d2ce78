# SPDX-License-Identifier: Apache-2.0
"""What a hand feels beside the mean force: spectra of the force of a mastoid bur in four materials, with the grain of
the material and the passing teeth.

    python 13_texture.py [FOLDER]"""
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hapticut
from hapticut.units import mm, ms, rpm

KIND = hapticut.CutterKind.mastoid_cutting_bur
SPEED, FEED, WAY = 1500 * rpm, 10 * mm, 16 * mm  # [rad/s], [m/s], [m]
LIPS = 8


def groove(material: hapticut.Material) -> np.ndarray:
    """Force [N] along the feed at each millisecond, of a ball of 4 mm that mills a groove of 1 mm."""
    box = hapticut.Box([-2 * mm, -3 * mm, -3 * mm], [WAY + 4 * mm, 3 * mm, 0])
    head = hapticut.ToolHead(hapticut.SphereHead(2 * mm))
    tool = hapticut.Tool(head, spindle=hapticut.Spindle(SPEED), cutter=hapticut.Cutter(kind=KIND))
    config = hapticut.SimulationConfig(grain=True, effects=hapticut.effects.Effects(teeth=hapticut.effects.ToothPassing()))
    simulation = hapticut.Simulation(hapticut.build_block(box, 0.2 * mm, material), tool, config)
    n = int(WAY / (FEED * ms))
    hand = np.zeros((n, 3))
    hand[:, 0], hand[:, 2] = WAY * np.arange(1, n + 1) / n, 1 * mm
    velocity = np.zeros((n, 6))
    velocity[:, 0] = FEED
    trace = simulation.run(hapticut.Pose.from_translation(hand), velocity, 1 * ms)
    return np.asarray(-trace["force"][n // 8:, 0])


def spectrum(force: np.ndarray) -> "tuple[np.ndarray, np.ndarray]":
    """Frequencies [Hz], and the amplitude spectral density over the mean force [1/sqrt(Hz)]."""
    varying = (force / force.mean() - 1) * np.hanning(len(force))
    power = np.abs(np.fft.rfft(varying)) ** 2 * 2 * ms / np.sum(np.hanning(len(force)) ** 2)
    return np.fft.rfftfreq(len(force), 1 * ms), np.sqrt(power)


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    figure, axes = plt.subplots(2, 2, figsize=(11, 5.5), sharex=True, sharey=True, layout="constrained")
    for ax, name in zip(axes.flat, ("enamel", "dentin", "cortical_bone", "trabecular_bone")):
        force = groove(hapticut.find_preset(name, KIND))
        frequency, density = spectrum(force)
        ax.loglog(frequency[1:], density[1:], color="#2471a3", linewidth=0.8)
        turns = SPEED / (2 * np.pi)
        for line, what in ((turns, "turn"), (LIPS * turns, "tooth")):
            ax.axvline(line, color="#c0392b", linewidth=0.6, linestyle=":")
            ax.text(line, 0.2, what, rotation=90, va="top", ha="right", fontsize=8)
        ax.set(title=f"{name}: {force.mean():.2g} N, varies by {100 * force.std() / force.mean():.0f} %",
               ylim=(1e-5, 0.3))
        print(f"{name}: {force.mean():.2g} N, varies by {100 * force.std() / force.mean():.0f} %")
    figure.supxlabel("frequency [Hz]")
    figure.supylabel("variation [1/sqrt(Hz)]")
    figure.savefig(folder / "texture.png", dpi=120)


if __name__ == "__main__":
    main()
