# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
from pathlib import Path

os.environ.setdefault("MPLBACKEND", "Agg")

import hapticut  # noqa: E402
import numpy as np  # noqa: E402
import pytest  # noqa: E402
from hapticut.units import mm, rpm  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]


@pytest.fixture
def block() -> hapticut.Workpiece:
    """6 x 6 x 4 mm of cortical bone, its upper face at z = 0."""
    box = hapticut.Box(np.array([-3.0, -3.0, -4.0]) * mm, np.array([3.0, 3.0, 0.0]) * mm)
    return hapticut.build_block(box, 0.1 * mm, hapticut.presets.cortical_bone())


@pytest.fixture
def tool() -> hapticut.Tool:
    """A ball of 1.5 mm on a straight handle of 20 mm, turning at 40 000 rpm."""
    return hapticut.Tool(hapticut.SphereHead(1.5 * mm), hapticut.RayHandle(20 * mm), hapticut.Spindle(40000 * rpm))


@pytest.fixture
def simulation(block: hapticut.Workpiece, tool: hapticut.Tool) -> hapticut.Simulation:
    return hapticut.Simulation(block, tool, hapticut.SimulationConfig(reference_stiffness=1e16))


@pytest.fixture
def plunge() -> tuple[np.ndarray, np.ndarray]:
    """Poses and velocities of a plunge into the block: 600 ms downwards at 2 mm/s."""
    ticks = np.arange(1, 601)
    hand = np.zeros((len(ticks), 3))
    hand[:, 2] = (1.5 + 20) * mm - 0.002 * mm * (ticks - 50)  # first in free air
    velocities = np.zeros((len(ticks), 6))
    velocities[:, 2] = -2 * mm
    return hapticut.Pose.from_translation(hand), velocities
