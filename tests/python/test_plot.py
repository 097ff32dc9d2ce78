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


def test_removed_volumes_are_bars_in_cubic_millimetres(simulation, plunge):
    trace = simulation.run(*plunge, 1e-3)
    [bar] = plot.removed_volume(simulation).patches
    assert bar.get_width() == pytest.approx(trace["removed_volume"].sum() * 1e9)


def test_latency_counts_what_misses_the_deadline():
    times = np.full(1000, 50e-6)
    times[:7] = 1.5e-3
    histogram = hapticut.LatencyHistogram()
    for seconds in times:
        histogram.add(seconds)
    for given in (times, histogram):
        texts = [text.get_text() for text in plot.latency(given).get_legend().get_texts()]
        assert any("7 of 1000 later" in text for text in texts), texts
        assert any(text.startswith("median 5") for text in texts)
    with pytest.raises(hapticut.Error, match="empty"):
        plot.latency(hapticut.LatencyHistogram())
    with pytest.raises(hapticut.Error, match="finite"):
        plot.latency(np.array([np.nan]))


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


def test_a_slice_shows_the_materials_of_a_layer():
    top = hapticut.Layer(hapticut.presets.enamel(), 0.5 * mm)
    slab = hapticut.build_layered_slab(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3), 0.1 * mm,
                                       [top, hapticut.Layer(hapticut.presets.dentin(), 1.5 * mm)])
    ax = plot.slice_through(slab, axis=0)
    picture = ax.get_images()[0].get_array()
    assert picture.shape == (20, 20, 3)
    assert np.allclose(picture[-1], plot.color_of("enamel")) and np.allclose(picture[0], plot.color_of("dentin"))
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["enamel", "dentin"]
    with pytest.raises(hapticut.Error, match="axis = 3"):
        plot.slice_through(slab, axis=3)


def test_a_surface_is_drawn_from_the_back_to_the_front(block):
    ax = plot.surface(block)
    [collection] = [c for c in ax.collections if len(c.get_paths()) > 100]
    assert len(collection.get_paths()) < len(hapticut.extract_surface(block).mesh.triangles)  # the back is not drawn
    assert any("mm" in text.get_text() for text in ax.texts)
