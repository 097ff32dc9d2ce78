# SPDX-License-Identifier: Apache-2.0
"""Structs of C++ in Python: made with keywords, read, changed, compared, copied, pickled and printed."""
from __future__ import annotations

import copy
import inspect
import pickle

import numpy as np
import pytest

import hapticut as h
from hapticut.units import mm

core = h._hapticut


def use_attributes(thing):
    """Reads every attribute of an object; a failing getter fails the test."""
    return {name: getattr(thing, name) for name in dir(thing) if not name.startswith("_")}


def classes(owner=core):
    """All classes of the module, including nested ones."""
    for _, cls in inspect.getmembers(owner, inspect.isclass):
        if cls.__module__.startswith("hapticut") and cls is not owner:
            yield cls
            yield from classes(cls)


# Objects whose constructors have required arguments.
GIVEN = [h.calibration.DrillingTest(1.25 * mm, 100.0, 1e-3, thrust=20.0, torque=0.04),
         h.GreyRange(1.0, 2.0, h.presets.clay()), h.Layer(h.presets.clay(), 1 * mm),
         h.Grade(1.0, 2.0, h.presets.clay(), h.presets.pulp(), steps=3),
         h.LabelMaterial([1, 2], h.presets.clay()), h.MeshShell(h.TriangleMesh(np.eye(3), np.array([[0, 1, 2]])), 1),
         h.SphereHead(1 * mm), h.ConeHead(0.5, 1 * mm), h.FlatHead(1 * mm, 2 * mm), h.io.VdbImport(h.presets.clay()),
         h.BodyDescription(h.Box([0] * 3, [1 * mm] * 3), lambda p: 1.0, lambda p: 1),
         h.Box([0] * 3, [1 * mm] * 3)]


# Classes with fields that only their constructor sets.
READ_ONLY = {"LatencyHistogram", "MeshShell"}


def test_every_struct_is_made_with_its_defaults_copied_changed_and_printed():
    things = list(GIVEN)
    for cls in classes():
        try:
            things.append(cls())
        except TypeError:
            pass  # needs arguments, or is only made by the library
    assert len(things) > 75
    for thing in things:
        cls, name = type(thing), type(thing).__name__
        values = use_attributes(thing)
        assert name in repr(thing) or "object" in repr(thing)
        for attribute, value in values.items():
            if getattr(getattr(cls, attribute), "fset", None):
                setattr(thing, attribute, value)  # a read value can be written
            elif "__setstate__" in vars(cls) and not callable(value):
                assert name in READ_ONLY, f"{name}.{attribute}"
        if not hasattr(cls, "__setstate__"):
            continue
        if name not in ("MockOptions", "BodyDescription") and "object at" not in repr(thing):  # hold functions
            assert repr(pickle.loads(pickle.dumps(thing))) == repr(copy.deepcopy(thing)) == repr(copy.copy(thing))


def test_everything_that_a_simulation_tells_can_be_read(simulation, plunge):
    simulation.run(*plunge, 1e-3)
    values = use_attributes(simulation)
    assert values["steps"] == 600 and values["spindle_setting"] == values["tool"].spindle.speed
    assert values["config"].reference_stiffness == 1e16 and values["removed_volume_by_material"].sum() > 0
    given = values["last_input"]
    assert np.array_equal(given.X_WH, plunge[0][-1]) and np.array_equal(given.V_WH, plunge[1][-1])
    last = simulation.last_result
    assert last.contact.depth > 0 and all(np.isfinite(term) for term in use_attributes(last.energy).values()
                                          if isinstance(term, float))
    assert last.energy.imbalance() == pytest.approx(0, abs=1e-3 * last.energy.cutting)  # single precision in the loop
    assert use_attributes(simulation.stage_times)["check_input"] == 0
    worst = simulation.worst_case()
    assert worst.blocks * h.kBlockVoxels >= worst.voxels >= last.contact.voxels


def test_no_method_takes_none_for_its_object():
    """pybind11 passes None as a null pointer; module.cpp marks the object of every method as not None."""
    refused = 0
    for cls in classes():
        for name, value in vars(cls).items():
            method = value.fget if isinstance(value, property) else value
            if not name.startswith("_") and inspect.isroutine(method) and not isinstance(method, staticmethod):
                with pytest.raises(TypeError):
                    method(None)
                refused += 1
    assert refused > 1000


def test_enumerations_have_the_names_of_cpp():
    assert h.StepStatus.jump_rejected | h.StepStatus.dt_rejected == 0b1100
    assert 0b1100 & h.StepStatus.dt_rejected == 4 and h.StepStatus.ok ^ 3 == 3
    assert h.kRejected == 15 and not h.has_any(0, h.StepStatus.pose_rejected)
    assert h.device.describe(int(h.device.OutputChange.ramped)).strip()
    assert h.device.describe(h.device.DeviceFault.disconnected).strip()
    assert h.has_any(int(h.device.OutputChange.cooled), h.device.OutputChange.cooled)
    assert not h.has_any(0, h.device.OutputChange.cooled)
    assert h.ContactTime.middle != h.ContactTime.end and h.RemovalLaw.none != h.RemovalLaw.elastic_release
    assert h.SimulationConfig().quadrature in h.Quadrature.__members__.values()
    assert h.SimulationConfig().handle_torque == h.HandleTorque.full_wrench
    for cls in classes():
        if hasattr(cls, "__members__"):
            assert cls.__members__, cls


def test_colors_and_meshes():
    red = h.Color(255, 0, 0)
    assert red == h.Color(255, 0, 0) != h.Color(0, 255, 0) and red != "red" and hash(red) == 0xFF0000
    mesh = h.TriangleMesh(np.eye(3), np.array([[0, 1, 2]]))
    colored = h.ColoredMesh(mesh, [red] * 3)
    assert colored.colors.tolist() == [[255, 0, 0]] * 3 and len(colored.mesh.vertices) == 3
