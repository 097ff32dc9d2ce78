# SPDX-License-Identifier: Apache-2.0
"""Computes u and kappa from a published drilling test, simulates the test, and predicts another spindle speed.

Orelaja et al. 2020, J Healthc Eng 8817422, table 6: bovine bone, drill of 2.5 mm, 1000 rpm, 20.07 N and 41.2 N mm. The
summary that we used gives no feed: 0.1 mm per revolution is assumed, and u is proportional to 1/feed. We have no
measurement at another speed, so the prediction is compared with the closed form (C20)."""
import numpy as np

import hapticut
from hapticut.calibration import ChipTerm, DrillingTest, axial_cut_force, calibrate
from hapticut.units import N_mm, mm, ms, rpm

RADIUS, SPEED = 1.25 * mm, 1000 * rpm
FEED = 0.1 * mm * SPEED / (2 * np.pi)  # [m/s]
test = DrillingTest(RADIUS, SPEED, FEED, thrust=20.07, torque=41.2 * N_mm)
found = calibrate([test], ChipTerm.edge_pressure)  # one test cannot determine the edge pressure: it becomes 0
print(f"u = {found.specific_cutting_energy / 1e9:.3f} GJ/m^3, kappa = {found.cutting_ratio:.2f} "
      "(the flutes of a drill rub: a burr has a smaller kappa)")
bone = hapticut.Material("bovine bone", cutting_ratio=found.cutting_ratio, edge_pressure=found.edge_pressure,
                         specific_cutting_energy=found.specific_cutting_energy)
head = hapticut.ToolHead(hapticut.FlatHead(RADIUS, 4 * mm, hapticut.FlatRule.bottom_only))


def simulate(speed: float, feed: float) -> tuple[float, float]:
    """Steady thrust [N] and torque [N·m], from 0.6 to 0.9 mm depth."""
    box = hapticut.Box([-1.6 * mm, -1.6 * mm, -1.2 * mm], [1.6 * mm, 1.6 * mm, 0])
    block = hapticut.build_block(box, 0.05 * mm, bone)
    simulation = hapticut.Simulation(block, hapticut.Tool(head, spindle=hapticut.Spindle(speed)))
    n = round(0.9 * mm / (feed * ms))
    hand = np.outer(-feed * ms * np.arange(1, n + 1), [0, 0, 1]) + [0.007 * mm, 0.011 * mm, 0]
    trace = simulation.run(hapticut.Pose.from_translation(hand), np.zeros((n, 6)), 1 * ms)[2 * n // 3:]
    return trace["force"][:, 2].mean(), -trace["torque"][:, 2].mean()


for name, speed in (("measured at 1000 rpm", SPEED), ("predicted at 2000 rpm", 2 * SPEED)):
    thrust, torque = simulate(speed, FEED)
    theory = axial_cut_force(found, RADIUS, speed, FEED)
    print(f"{name}: simulation {thrust:.2f} N, {torque / N_mm:.1f} N mm; closed form {theory.thrust:.2f} N, "
          f"{theory.torque / N_mm:.1f} N mm")
