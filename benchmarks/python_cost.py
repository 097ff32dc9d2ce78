#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The cost of Python: Simulation.run compared with a loop in C++, one call of step, and the import.

    python benchmarks/python_cost.py [--json FILE]

Needs an installed hapticut. Times are processor times of the thread, the minimum of several repetitions.
"""
import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import hapticut
from hapticut.units import mm, ms, rpm

REPETITIONS = 15
STEPS = 1000


def plunge(above=0.0):
    """The first second of the README example, or a second of the same motion above the bone."""
    box = hapticut.Box([-3 * mm, -3 * mm, -4 * mm], [3 * mm, 3 * mm, 0])
    bone = hapticut.build_block(box, 0.1 * mm, hapticut.presets.cortical_bone())
    tool = hapticut.Tool(hapticut.SphereHead(1.5 * mm), hapticut.RayHandle(20 * mm), hapticut.Spindle(40000 * rpm))
    simulation = hapticut.Simulation(bone, tool, hapticut.SimulationConfig(reference_stiffness=1e14))
    heights = (1.5 + 20) * mm + above - 0.002 * mm * np.arange(1, STEPS + 1)
    poses = hapticut.Pose.from_translation(np.outer(heights, [0, 0, 1]))
    return simulation, poses, np.tile([0, 0, -2 * mm, 0, 0, 0], (STEPS, 1))


def cost_of(function, above=0.0):
    """[s] per step, minimum of several plunges."""
    times = []
    for _ in range(REPETITIONS):
        simulation, poses, velocities = plunge(above)
        begin = time.thread_time()
        function(simulation, poses, velocities)
        times.append(time.thread_time() - begin)
    return min(times) / STEPS


def run(simulation, poses, velocities):
    simulation.run(poses, velocities, 1 * ms)


def in_cpp(simulation, poses, velocities):
    hapticut._hapticut._loop_in_cpp(simulation, poses, velocities, 1 * ms)


def step_by_step(simulation, poses, velocities):
    step = simulation.step
    for pose, velocity in zip(poses, velocities):
        step(pose, velocity, 1e-3)


def python_alone(simulation, poses, velocities):
    for pose, velocity in zip(poses, velocities):
        pass


def seconds_to_import():
    """[s] of processor time for `import hapticut` after numpy was imported."""
    code = "import numpy, time; begin = time.process_time(); import hapticut; print(time.process_time() - begin)"
    return min(float(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True).stdout)
               for _ in range(5))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", type=Path, help="also write the numbers to a file")
    arguments = parser.parse_args()

    cpp, python = cost_of(in_cpp), cost_of(run)
    report = {"step_in_cpp_us": cpp * 1e6, "step_in_run_us": python * 1e6, "run_over_cpp": python / cpp}
    free = cost_of(in_cpp, above=10 * mm)
    call = cost_of(step_by_step, above=10 * mm) - cost_of(python_alone, above=10 * mm)
    report |= {"overhead_of_step_us": (call - free) * 1e6, "import_s": seconds_to_import()}
    report["build"] = {name: getattr(hapticut.build_info(), name) for name in ("version", "commit", "compiler", "cpu")}
    text = json.dumps(report, indent=2)
    print(text)
    if arguments.json:
        arguments.json.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
