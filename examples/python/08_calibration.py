# SPDX-License-Identifier: Apache-2.0
"""Computes u and kappa from a published drilling test, simulates the test, and predicts another spindle speed.

Hillery and Shuaib 1999, recalled (docs/measurements.md): bovine tibia, drill of 3.2 mm, 50 mm/min, 48 N and 14.5 N mm
at 400 rpm, 24 N and 10 N mm at 2000 rpm. One test does not tell the edge length: that of the presets is assumed. Those
drills were worn, so the force falls less with the speed than predicted; both tests together give a longer edge."""
import numpy as np

import hapticut
from hapticut.calibration import Calibration, DrillingTest, advice_on, axial_cut_force, calibrate
from hapticut.units import N_mm, mm, ms, rpm

RADIUS, FEED = 1.6 * mm, 50 / 60 * mm  # [m], [m/s]
slow = DrillingTest(RADIUS, 400 * rpm, FEED, thrust=48, torque=14.5 * N_mm)
fast = DrillingTest(RADIUS, 2000 * rpm, FEED, thrust=24, torque=10 * N_mm)
head = hapticut.ToolHead(hapticut.FlatHead(RADIUS, 4 * mm, hapticut.FlatRule.bottom_only))


def simulate(constants: Calibration, speed: float) -> tuple[float, float]:
    """Steady thrust [N] and torque [N·m], from 0.6 to 0.9 mm depth."""
    bone = hapticut.Material("bovine bone", cutting_ratio=constants.cutting_ratio, edge_length=constants.edge_length,
                             specific_cutting_energy=constants.specific_cutting_energy, cutter=constants.cutter)
    block = hapticut.build_block(hapticut.Box([-2 * mm, -2 * mm, -1.2 * mm], [2 * mm, 2 * mm, 0]), 0.05 * mm, bone)
    drill = hapticut.Tool(head, spindle=hapticut.Spindle(speed), cutter=hapticut.Cutter(constants.cutter))
    simulation = hapticut.Simulation(block, drill)
    n = round(0.9 * mm / (FEED * ms))
    hand = np.outer(-FEED * ms * np.arange(1, n + 1), [0, 0, 1]) + [0.007 * mm, 0.011 * mm, 0]
    trace = simulation.run(hapticut.Pose.from_translation(hand), np.zeros((n, 6)), 1 * ms)[2 * n // 3:]
    return trace["force"][:, 2].mean(), -trace["torque"][:, 2].mean()


for name, tests in (("one test", [slow]), ("both tests", [slow, fast])):
    found = calibrate(tests)
    print(f"{name}: u = {found.specific_cutting_energy / 1e6:.1f} MJ/m^3, kappa = {found.cutting_ratio:.2f}, "
          f"edge length {found.edge_length / 1e-6:.1f} um{' (assumed)' if found.edge_assumed else ''}")
    for measured in (slow, fast):
        thrust, torque = simulate(found, measured.spindle_speed)
        theory = axial_cut_force(found, RADIUS, measured.spindle_speed, FEED)
        print(f"{measured.spindle_speed / rpm:.0f} rpm: simulation {thrust:.2f} N, {torque / N_mm:.2f} N mm; closed "
              f"form {theory.thrust:.2f} N, {theory.torque / N_mm:.2f} N mm; measured {measured.thrust:.2f} N, "
              f"{measured.torque / N_mm:.2f} N mm")
print(advice_on(found))
