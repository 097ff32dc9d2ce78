# SPDX-License-Identifier: Apache-2.0
"""The surface for drawing and the sound of the drill."""
from __future__ import annotations

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm, rpm


def pages_of(stream: h.surface.SurfaceStream) -> dict[tuple[int, ...], h.surface.SurfacePage]:
    pages = {}
    while (page := stream.next_page()) is not None:
        pages[tuple(page.origin)] = page
    return pages


def same(a: dict, b: dict) -> bool:
    return a.keys() == b.keys() and all(
        np.array_equal(a[k].vertices, b[k].vertices) and np.array_equal(a[k].indices, b[k].indices) for k in a)


def test_pages_follow_the_steps_and_are_those_of_a_rebuild(simulation, plunge):
    stream = h.surface.SurfaceStream(simulation.workpiece)
    stream.look_at([0, 0, 0])
    assert stream.waiting() > 0
    pages = pages_of(stream)
    meshed = stream.blocks_meshed()
    assert meshed > 0 and stream.waiting() == 0 and stream.memory_bytes() > 1000
    poses, velocities = plunge
    for pose, velocity in zip(poses, velocities):
        simulation.step(pose, velocity, 1e-3)
        assert stream.update(simulation.workpiece, simulation.changed_blocks()[0])
    changed = pages_of(stream)
    assert changed and stream.blocks_meshed() > meshed
    assert all(page.version > max(p.version for p in pages.values()) for page in changed.values())
    pages.update(changed)
    assert same({k: p for k, p in pages.items() if len(p.vertices)}, pages_of(h.surface.SurfaceStream(simulation.workpiece)))
    stream.resend()
    assert stream.waiting() == len([p for p in pages.values() if len(p.vertices)])


def test_a_page_is_arrays_as_a_graphics_card_takes_them(simulation):
    stream = h.surface.SurfaceStream(simulation.workpiece)
    page = next(iter(pages_of(stream).values()))
    assert page.vertices.dtype.itemsize == 12 and page.vertices["position"].shape == (len(page.vertices), 3)
    assert set(page.vertices["material"]) == {1} and page.indices.max() < len(page.vertices)
    positions, normals = page.positions(stream.frame), page.normals(stream.frame)
    steps = (np.array(page.origin) + page.vertices["position"] / 512) * stream.frame.voxel_size
    in_world = steps @ stream.frame.X_WV[:3, :3].T + stream.frame.X_WV[:3, 3]
    assert np.allclose(positions, in_world, atol=1e-12)
    assert np.allclose(np.linalg.norm(normals, axis=1), 1)
    corners = positions[page.indices]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert np.mean(np.sum(faces * normals[page.indices[:, 0]], axis=1) > 0) > 0.95
    SurfacePage = h.surface.SurfacePage
    assert len(page.vertices) <= SurfacePage.kMaxVertices and page.indices.size <= SurfacePage.kMaxIndices
    assert SurfacePage.kEdge == SurfacePage.kBlocks * h.kBlockEdge


def test_the_whole_surface_has_normals():
    ball = h.build_sphere([0, 0, 0], 2 * mm, 0.1 * mm, h.presets.dentin())
    surface = h.extract_surface(ball)
    outwards = surface.mesh.vertices / np.linalg.norm(surface.mesh.vertices, axis=1)[:, None]
    assert np.sum(outwards * surface.normals, axis=1).min() > np.cos(np.radians(3))


def test_a_block_of_a_feed_is_taken_as_it_comes(simulation, plunge):
    collector = h.heat.HeatCollector(simulation)
    stream = h.surface.SurfaceStream(simulation.workpiece)
    pages_of(stream)
    simulation.run(*plunge, 1e-3)
    while (block := collector.receive_block()) is not None:
        assert stream.update(block)
    assert stream.waiting() > 0


def test_the_tone_of_the_drill_is_that_of_its_spindle():
    sound = h.sound.DrillSound(h.sound.SoundOptions(flutes=1, volume=1.0))
    running = h.sound.SoundInput(spindle_speed=60_000 * rpm)
    sound.render(24_000, 48_000, running)
    samples = sound.render(48_000, 48_000, running)
    assert samples.dtype == np.float32 and np.abs(np.fft.rfft(samples)).argmax() == pytest.approx(1000, rel=0.01)
    sound.render(48_000, 48_000, h.sound.SoundInput())
    assert not sound.render(100, 48_000, h.sound.SoundInput()).any()
    with pytest.raises(h.Error, match="volume"):
        h.sound.DrillSound(h.sound.SoundOptions(volume=2.0))


def test_a_listener_hears_the_snapshots_of_a_loop(simulation):
    device = h.device.MockDevice(h.device.MockOptions(device=h.device.device_model("touch")))
    gains = h.coupling_gains(h.device.capabilities(h.device.device_model("touch")))
    coupled = h.Simulation(simulation.workpiece.clone(), simulation.tool,
                           h.SimulationConfig(contact_time=h.ContactTime.end))
    model = h.loop.SimulationModel(coupled, device, h.loop.SimulationModelOptions(coupling=gains))
    loop = h.loop.RealtimeLoop(model, h.loop.RealtimeLoopOptions(run=h.device.RunOptions(seconds=0.05, simulated_time=True)))
    loop.start()
    loop.wait()
    heard = h.sound.LoopListener(1000).listen(loop.latest())
    assert heard.spindle_speed == loop.latest().tool.spindle_speed
    assert heard.power == pytest.approx(loop.latest().tool.dissipated / (loop.latest().tick / 1000), abs=1e-12)
