# SPDX-License-Identifier: Apache-2.0
"""Plots show the numbers that they are given, on the axes that they are given."""
from __future__ import annotations

import numpy as np
import pytest

import hapticut
from hapticut.units import mm

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
from hapticut import plot  # noqa: E402


@pytest.fixture(autouse=True)
def close():
    yield
    import matplotlib.pyplot as plt

    plt.close("all")


def test_force_and_torque_are_drawn_in_newtons_and_millinewton_metres(simulation, plunge):
    import matplotlib.pyplot as plt

    trace = simulation.run(*plunge, 1e-3)
    mine = plt.subplots()[1]
    assert plot.force(trace, mine) is mine
    x, y, z, length = (line.get_ydata() for line in mine.get_lines())
    assert np.array_equal(z, trace["force"][:, 2]) and np.allclose(length, np.linalg.norm(trace["force"], axis=1))
    assert np.array_equal(plot.torque(trace).get_lines()[2].get_ydata(), trace["torque"][:, 2] * 1e3)
    assert "[N]" in mine.get_ylabel() and "[s]" in mine.get_xlabel()


@pytest.mark.parametrize("draw", [plot.force, plot.torque])
def test_a_trace_of_one_step_is_seen_and_one_of_none_is_refused(draw, simulation, plunge):
    poses, velocities = plunge
    one = draw(simulation.run(poses[:1], velocities[:1], 1e-3))
    assert all(line.get_marker() == "o" for line in one.get_lines())
    with pytest.raises(hapticut.Error, match="holds no step"):
        draw(simulation.run(poses[:0], velocities[:0], 1e-3))
    with pytest.raises(hapticut.Error, match="what Simulation.run returned"):
        draw(np.zeros(3))


def test_nothing_removed_is_a_bar_of_no_length(simulation):
    ax = plot.removed_volume(simulation)
    assert [bar.get_width() for bar in ax.patches] == [0] and ax.get_xlim() == (0, 1)


def test_removed_volumes_are_bars_in_cubic_millimetres(simulation, plunge):
    trace = simulation.run(*plunge, 1e-3)
    [bar] = plot.removed_volume(simulation).patches
    assert bar.get_width() == pytest.approx(trace["removed_volume"].sum() * 1e9)


def test_latency_counts_what_misses_the_deadline():
    times = np.full(1000, 50e-6)
    times[:7] = 1.5e-3
    histogram = hapticut.loop.LatencyHistogram()
    for seconds in times:
        histogram.add(seconds)
    for given in (times, histogram):
        texts = [text.get_text() for text in plot.latency(given).get_legend().get_texts()]
        assert any("7 of 1000 later" in text for text in texts), texts
        assert any(text.startswith("median 5") for text in texts)
    with pytest.raises(hapticut.Error, match="empty"):
        plot.latency(hapticut.loop.LatencyHistogram())
    for wrong in ([np.nan], [-1e-3], []):
        with pytest.raises(hapticut.Error, match="finite"):
            plot.latency(np.array(wrong))
    with pytest.raises(hapticut.Error, match="deadline = 0"):
        plot.latency(times, deadline=0)
    assert sum(bar.get_height() for bar in plot.latency(np.zeros((2, 3))).patches) == 6


def test_latency_shows_what_is_longer_than_the_buckets_of_a_histogram():
    histogram = hapticut.loop.LatencyHistogram()
    for seconds in (50e-6, 60e-6, 5e-3):
        histogram.add(seconds)
    ax = plot.latency(histogram)
    [last] = [bar for bar in ax.patches if bar.get_x() <= 5000 < bar.get_x() + bar.get_width()]
    assert last.get_height() == 1 and "1 of 3 later" in ax.get_legend().get_texts()[0].get_text()
    assert "0 of 3 later" in plot.latency(histogram, deadline=6e-3).get_legend().get_texts()[0].get_text()
    with pytest.raises(hapticut.Error, match="does not tell apart"):
        plot.latency(histogram, deadline=3e-3)


def test_a_sweep_matrix_has_a_cell_for_each_pair():
    pd = pytest.importorskip("pandas", reason="pandas is not installed")
    rows = [{"feed": feed, "speed": speed, "force": feed * 10 / speed, "error": ""} for feed in (1, 2, 3)
            for speed in (1, 2)]
    table = pd.DataFrame([*rows, {"feed": 1, "speed": 1, "force": 1e9, "error": "failed"}])
    table.attrs["units"] = {"force": "N"}
    ax = plot.sweep_matrix(table, "feed", "speed", "force")
    assert ax.collections[0].get_array().reshape(2, 3).tolist() == [[10, 20, 30], [5, 10, 15]]
    assert [text.get_text() for text in ax.texts][:3] == ["10", "20", "30"]
    with pytest.raises(hapticut.Error, match="no column 'torque'"):
        plot.sweep_matrix(table, "feed", "speed", "torque")
    with pytest.raises(hapticut.Error, match="two columns"):
        plot.sweep_matrix(table, "feed", "feed", "force")
    with pytest.raises(hapticut.Error, match="does not hold numbers"):
        plot.sweep_matrix(table, "feed", "speed", "error")


def test_a_large_sweep_matrix_has_room_for_its_labels():
    pd = pytest.importorskip("pandas", reason="pandas is not installed")
    table = pd.DataFrame([{"feed": feed, "speed": speed, "force": feed} for feed in np.linspace(1e-3, 4e-3, 30)
                          for speed in np.geomspace(100, 1e4, 40)])
    ax = plot.sweep_matrix(table, "feed", "speed", "force")
    ax.figure.canvas.draw()
    for labels in (ax.get_xticklabels(), ax.get_yticklabels()):
        boxes = [label.get_window_extent() for label in labels]
        assert len(boxes) > 4 and not any(a.overlaps(b) for a, b in zip(boxes, boxes[1:]))


def test_a_slice_shows_the_materials_of_a_layer():
    top = hapticut.Layer(hapticut.presets.enamel(), 0.5 * mm)
    slab = hapticut.build_layered_slab(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3), 0.1 * mm,
                                       [top, hapticut.Layer(hapticut.presets.dentin(), 1.5 * mm)])
    ax = plot.slice_through(slab, axis=0)
    picture = ax.get_images()[0].get_array()
    assert picture.shape == (20, 20, 3)
    enamel, dentin = plot.colors_of(["enamel", "dentin"])
    assert np.allclose(picture[-1], enamel) and np.allclose(picture[0], dentin)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["enamel", "dentin"]
    with pytest.raises(hapticut.Error, match="axis = 3"):
        plot.slice_through(slab, axis=3)


def test_every_material_has_a_color_of_its_own():
    names = [f"m{number}" for number in range(20)] + hapticut.preset_names()
    assert len(set(plot.colors_of(names))) == len(names)


def test_what_is_cut_away_wholly_is_said():
    crumb = hapticut.build_block(hapticut.Box([-0.2 * mm] * 3, [0.2 * mm] * 3), 0.2 * mm, hapticut.presets.clay())
    tool = hapticut.Tool(hapticut.SphereHead(2 * mm), spindle=hapticut.Spindle(5e4))
    simulation = hapticut.Simulation(crumb, tool, hapticut.SimulationConfig(reference_stiffness=1e16))
    down = np.outer(np.linspace(2.3 * mm, 0, 300), [0, 0, 1])
    simulation.run(hapticut.Pose.from_translation(down), np.zeros((300, 6)), 1e-3)
    assert simulation.workpiece.empty()
    for draw in (plot.slice_through, plot.surface):
        with pytest.raises(hapticut.Error, match="nothing is left"):
            draw(simulation.workpiece)


def test_a_surface_is_drawn_from_the_back_to_the_front(block):
    ax = plot.surface(block)
    [collection] = [c for c in ax.collections if len(c.get_paths()) > 100]
    assert len(collection.get_paths()) < len(hapticut.extract_surface(block).mesh.triangles)  # the back is not drawn
    assert any("mm" in text.get_text() for text in ax.texts)
