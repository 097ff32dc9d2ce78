# SPDX-License-Identifier: Apache-2.0
"""Functions for sweeps, at the top level of a module, where worker processes find them."""
from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

import numpy as np

import hapticut
from hapticut.units import mm


def drill(parameters, rng):
    """A short plunge; the hand trembles."""
    material = hapticut.find_preset(parameters["material"])
    block = hapticut.build_block(hapticut.Box([-1 * mm, -1 * mm, -1 * mm], [1 * mm, 1 * mm, 0]), 0.1 * mm, material)
    tool = hapticut.Tool(hapticut.SphereHead(0.5 * mm), spindle=hapticut.Spindle(parameters["speed"]))
    simulation = hapticut.Simulation(block, tool, hapticut.SimulationConfig(reference_stiffness=1e15))
    n = 60
    hand = np.zeros((n, 3))
    hand[:, 2] = 0.5 * mm - parameters["feed"] * 1e-3 * np.arange(1, n + 1)
    hand[:, :2] = rng.normal(scale=2e-6, size=(n, 2))
    trace = simulation.run(hapticut.Pose.from_translation(hand), np.zeros((n, 6)), 1e-3)
    return {"peak_force": trace["force"][:, 2].max(), "removed_volume": trace["removed_volume"].sum(),
            "draw": rng.random(), "force": trace["force"]}


def takes_no_step(parameters, rng):
    """One of two runs uses steps of 10 s."""
    block = hapticut.build_block(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3), 0.2 * mm, hapticut.presets.clay())
    simulation = hapticut.Simulation(block, hapticut.Tool(hapticut.SphereHead(0.5 * mm)))
    trace = simulation.run(np.tile(np.eye(4), (3, 1, 1)), np.zeros((3, 6)), parameters["dt"])
    return {"peak_force": trace["force"].max()}


def squares(parameters, rng):
    """Squares x; raises for x = 3."""
    if parameters["x"] == 3:
        raise ValueError("three is\ntoo much")
    return {"square": parameters["x"] ** 2}


def returns_what_cannot_be_kept(parameters, rng):
    if parameters["x"] == 0:
        sys.exit(3)
    return [7, {"y": None}, {"o": np.array([None, 1])}, {3: 1}, {"error": 1}, {"x": 1}, {}][parameters["x"] - 1]


def returns_more_and_more(parameters, rng):
    """Returns arrays of 4-byte numbers, up to 38 kB."""
    return {"values": np.zeros(500 * parameters["x"], dtype=np.float32)}


def returns_traces_of_odd_names(parameters, rng):
    return {name: np.array([parameters["x"], 4]) for name in ("file", "allow_pickle", "a/b", "force.npy")}


def kills_its_process_once(parameters, rng):
    """Kills its process at x = 25, the first time only."""
    mark = Path(parameters["folder"], "killed")
    if parameters["x"] == 25 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    time.sleep(0.01)
    return {"draw": rng.random()}


def kills_its_process(parameters, rng):
    """Kills its process at x = 2, every time."""
    if parameters["x"] == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"draw": rng.random()}


def scaled(parameters, rng, factor=1):
    return {"y": factor * parameters["x"]}


class Scaled:
    def __init__(self, factor):
        self.factor = factor

    def __call__(self, parameters, rng):
        return {"y": self.factor * parameters["x"]}


def takes_long(parameters, rng):
    """Waits. A run that will take long leaves a mark with the id of its process first."""
    if parameters["seconds"] > 1:
        Path(f"worker-{os.getpid()}").touch()
    time.sleep(parameters["seconds"])
    return {"draw": rng.random()}


def steps_of(simulation, poses, velocities):
    """The trace of a run, its last result and the hash of what is left."""
    trace = simulation.run(poses, velocities, 1e-3)
    return trace, simulation.last_result, simulation.workpiece.hash()
