# SPDX-License-Identifier: Apache-2.0
"""The plots of the examples show the numbers that they receive."""
from __future__ import annotations

import numpy as np
import pytest

import hapticut
from conftest import REPOSITORY
from hapticut.units import mm

plt = pytest.importorskip("matplotlib.pyplot", reason="matplotlib is not installed")


@pytest.fixture
def plots(monkeypatch):
    monkeypatch.syspath_prepend(str(REPOSITORY / "examples" / "python"))
    import plots

    yield plots
    plt.close("all")


def test_forces_and_removed_volumes_are_drawn_in_newtons_and_cubic_millimetres(plots, simulation, plunge):
    trace = simulation.run(*plunge, 1e-3)
    mine = plt.subplots()[1]
    assert plots.force(trace, mine) is mine and "[N]" in mine.get_ylabel()
    x, y, z, length = (line.get_ydata() for line in mine.get_lines())
    assert np.array_equal(z, trace["force"][:, 2]) and np.allclose(length, np.linalg.norm(trace["force"], axis=1))
    [bar] = plots.removed_volume(simulation).patches
    assert bar.get_width() == pytest.approx(trace["removed_volume"].sum() * 1e9)


def test_a_slice_shows_the_materials_of_a_layer(plots):
    layers = [hapticut.Layer(hapticut.presets.enamel(), 0.5 * mm), hapticut.Layer(hapticut.presets.dentin(), 1.5 * mm)]
    slab = hapticut.build_layered_slab(hapticut.Box([-1 * mm] * 3, [1 * mm] * 3), 0.1 * mm, layers)
    ax = plots.slice_through(slab, axis=0)
    picture = ax.get_images()[0].get_array()
    assert picture.shape == (20, 20, 3)
    _, enamel, dentin = plots.colors_of(slab)
    assert np.allclose(picture[-1], enamel) and np.allclose(picture[0], dentin)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["enamel", "dentin"]


def test_a_surface_is_drawn_without_its_back(plots, block):
    [collection] = plots.surface(block).collections
    assert 100 < len(collection.get_paths()) < len(hapticut.extract_surface(block).mesh.triangles)
