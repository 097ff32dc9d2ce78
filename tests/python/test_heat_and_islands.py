# SPDX-License-Identifier: Apache-2.0
"""Heat and loose pieces."""
from __future__ import annotations

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm


def test_heat_of_a_plunge_is_where_the_tool_is_and_its_balance_closes(simulation, plunge):
    collector = h.heat.HeatCollector(simulation, h.heat.HeatCollectorOptions(pulses=2000))
    config = h.heat.HeatConfig(by_material=[h.heat.ThermalProperties(0.58, 2.6e6)], cutting_share=0.3)
    field = h.heat.HeatField(simulation.workpiece, config)
    assert field.config.by_material[0].conductivity == 0.58 and field.config.irrigation == 0
    for part in (slice(0, 300), slice(300, 600)):  # the second part removes material that the first has heated
        simulation.run(plunge[0][part], plunge[1][part], 1e-3)
        assert field.drain(collector) == pytest.approx(0.3)
        field.advance(0.3)
    balance, bone = field.balance(), field.structures()[0]
    assert balance.brought_in > 0 and abs(balance.imbalance()) < 1e-9 * balance.brought_in
    assert bone.peak >= bone.temperature > 40 and bone.material == 1
    assert balance.stored > 0 and 0 < balance.chips < 0.1 * balance.brought_in  # what chips take is in the share
    assert min(bone.time_above, bone.cem43, bone.volume_above) >= 0
    temperatures = field.temperatures()
    assert temperatures.shape == tuple(field.dims) == field.peaks().shape == field.doses().shape
    place = field.warmest()
    assert place.temperature >= bone.peak and np.linalg.norm(place.p_WQ[:2]) < 1.5 * mm
    warmest = tuple(int(i) for i in np.unravel_index(np.nanargmax(temperatures), temperatures.shape))
    assert field.temperature(warmest) == temperatures[warmest] <= field.peak(warmest)
    assert np.linalg.norm(field.center(warmest)[:2]) < 1.5 * mm
    assert field.dose(warmest) == field.doses()[warmest] > 0
    assert field.cell_size == pytest.approx(0.4 * mm)
    assert field.temperature_at([2.5 * mm, 2.5 * mm, -3.5 * mm]) < bone.temperature
    with pytest.raises(IndexError):
        field.temperature((0, 0, 1000))


def test_heat_is_given_taken_by_water_and_counted(block):
    field = h.heat.HeatField(block)
    field.add_heat([0, 0, -2 * mm], 0.1)
    field.add_cutting_heat(0.05)  # the heat waits, because no voxel was removed
    field.set_irrigation(3000.0)
    field.update(block, np.zeros((1, 3), dtype=np.int32))
    field.advance(1.0)
    assert field.balance().brought_in == pytest.approx(0.1) and field.balance().irrigation != 0
    assert h.heat.cem43(44, 60) == 2
    with pytest.raises(h.Error, match="voxels_per_cell"):
        h.heat.HeatField(block, h.heat.HeatConfig(voxels_per_cell=3))


def test_thermal_properties_belong_to_the_name_of_a_material():
    known = {row.material: row for row in h.heat.known_thermal_properties()}
    assert h.heat.thermal_properties_of("dentin").conductivity == known["dentin"].properties.conductivity == 0.58
    assert h.heat.thermal_properties_of("wood").heat_capacity == known["cortical_bone"].properties.heat_capacity
    assert known["pulp"].source == "as water"


def test_pulses_and_blocks_can_be_taken_one_by_one(simulation, plunge):
    collector = h.heat.HeatCollector(simulation)
    field = h.heat.HeatField(simulation.workpiece)
    assert collector.receive() is None and collector.receive_block() is None
    simulation.run(*plunge, 1e-3)
    pulse, block = collector.receive(), collector.receive_block()
    assert isinstance(pulse, h.heat.HeatPulse) and pulse.dt == 1e-3 and pulse.p_WQ.shape == (3,)
    assert min(pulse.cut, pulse.rubbed, pulse.rubbed_in_cut, pulse.radius) >= 0
    field.update(block)
    point = h.heat.touching_point(h.SphereHead(1 * mm), h.Wrench([0, 0, 2.0], np.zeros(3)))
    assert point == pytest.approx([0, 0, -1 * mm], abs=1e-8)


def bar_cut_through():
    """A bar of 0.8 mm x 0.8 mm x 6 mm, cut through by a ball at a height of 4 mm."""
    material = h.presets.cortical_bone()
    bar = h.build_block(h.Box([-0.4 * mm, -0.4 * mm, 0], [0.4 * mm, 0.4 * mm, 6 * mm]), 0.1 * mm, material)
    simulation = h.Simulation(bar, h.Tool(h.SphereHead(0.6 * mm), h.RayHandle(0), h.Spindle(3000.0)))
    finder = h.islands.IslandFinder(simulation.workpiece, h.islands.IslandOptions())
    for tick in range(1, 1001):
        pose = h.Pose.from_translation([-2 * mm + 4e-6 * tick, 0, 4 * mm])
        simulation.step(pose, np.array([4 * mm, 0, 0, 0, 0, 0]), 1e-3)
        finder.update(simulation.workpiece, simulation.changed_blocks()[0])
    return simulation, finder


def test_a_piece_that_was_cut_loose_is_found_and_leaves():
    simulation, finder = bar_cut_through()
    [island] = finder.find()
    [same] = h.islands.find_islands(simulation.workpiece)
    assert island.voxels == same.voxels == len(island.indices) and island.min_fill == 0.05
    assert island.indices.dtype == np.int32 and island.indices[:, 2].min() > 40
    removal = h.islands.IslandRemoval(island)
    while not h.islands.remove_island(simulation, removal, 4):
        assert removal.checked > 0
    assert removal.is_over and not removal.joined and removal.removed > 0 and removal.island.voxels == island.voxels
    assert simulation.detached_volume_by_material.sum() == pytest.approx(island.voxels * (0.1 * mm) ** 3, rel=0.05)
    assert h.islands.find_islands(simulation.workpiece) == []
    with pytest.raises(h.Error, match="origins"):
        finder.update(simulation.workpiece, np.zeros(3, dtype=np.int32))


def test_a_block_of_a_loop_tells_the_finder(simulation, plunge):
    collector = h.heat.HeatCollector(simulation)
    finder = h.islands.IslandFinder(simulation.workpiece)
    simulation.run(*plunge, 1e-3)
    while (block := collector.receive_block()) is not None:
        finder.update(block)
    assert finder.find() == []


def test_a_model_lets_islands_leave_where_it_is_asked_to(simulation):
    device = h.device.MockDevice(h.device.MockOptions(device=h.device.device_model("touch")))
    gains = h.coupling_gains(h.device.capabilities(h.device.device_model("touch")))
    watch = h.islands.IslandWatchOptions(period=5e-3, blocks=h.loop.ChangeFeedOptions(block_capacity=100))
    coupled = h.Simulation(h.build_block(h.Box([0, 0, 0], [2 * mm] * 3), 0.1 * mm, h.presets.cortical_bone()),
                           simulation.tool, h.SimulationConfig(contact_time=h.ContactTime.end))
    model = h.loop.SimulationModel(coupled, device, h.loop.SimulationModelOptions(coupling=gains), watch)
    assert model.removed_islands() == [] and model.island_fault is None
    loop = h.loop.RealtimeLoop(model, h.loop.RealtimeLoopOptions(run=h.device.RunOptions(seconds=0.05, simulated_time=True)))
    loop.start()
    loop.wait()
    assert model.island_count == 0


def test_heat_that_is_no_heat_and_blocks_of_another_workpiece_are_refused(block):
    field = h.heat.HeatField(block)
    bad = [([0, 0, np.nan], 1.0, 0.0), ([0, 0, -mm], np.nan, 0.0), ([0, 0, -mm], -1.0, 0.0), ([0, 0, -mm], 1.0, -mm)]
    for point, heat, radius in bad:
        with pytest.raises(h.Error, match="HeatField.add_heat"):
            field.add_heat(point, heat, radius)
    with pytest.raises(h.Error, match="HeatField.add_cutting_heat"):
        field.add_cutting_heat(np.nan)
    assert field.balance().brought_in == 0
    other = h.build_block(h.Box([-mm] * 3, [mm] * 3), 0.2 * mm, h.presets.dentin())
    with pytest.raises(h.Error, match="another workpiece"):
        field.update(other, np.zeros((1, 3), np.int32))


def test_a_collector_that_is_deleted_makes_room_for_the_next(simulation):
    for _ in range(20):
        del_me = h.heat.HeatCollector(simulation)
        del del_me
