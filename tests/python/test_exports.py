# SPDX-License-Identifier: Apache-2.0
"""Each compiled name is in the list of exactly one module of bindings/python/hapticut, and its ``__module__`` is that
module. Bound types of the folders in ROOMS are in the module of their folder."""
from __future__ import annotations

import importlib
import inspect
import pickle
import pydoc
import re
import subprocess
import sys
from collections import Counter

import pytest

import hapticut
from conftest import REPOSITORY

core = hapticut._hapticut
MODULES = [hapticut, *(module for name, module in vars(hapticut).items()
                       if inspect.ismodule(module) and name in hapticut.__all__)]  # all but sweep
COMPILED = {name for name in dir(core) if not name.startswith("_")}
NAMES = [name for name in dir(hapticut) if name in COMPILED or name == "Pose"]
ROOMS = ("analysis", "device", "io", "loop", "safety")  # C++ folders that are also Python modules
# Names whose Python module differs from their C++ folder.
MOVED = {"LabelInterpolation",
         # What a device reports and can do: in C++ the guard comes before devices, in Python they are of the device.
         "DeviceCapabilities", "DeviceCommand", "DeviceFault", "DeviceOutput", "DeviceState", "ModelContact",
         "OutputChange"}


def test_every_compiled_name_is_in_one_module():
    places = Counter(name for module in MODULES for name in module.__all__)
    assert not {name for name, count in places.items() if count > 1}
    assert not COMPILED - set(places), "import these in hapticut/__init__.py or in the submodule where they belong"


def test_the_modules_hold_what_they_offer_and_show_nothing_else():
    for module in [*MODULES, importlib.import_module("hapticut.sweep")]:
        names = [name for name in dir(module) if not name.startswith("__")]
        assert names == sorted(module.__all__), module.__name__
        assert not [name for name in names if name.startswith("_") or not hasattr(module, name)], module.__name__
        assert COMPILED.isdisjoint(vars(module).keys() - set(names) - {"Error", "Material", "find_preset"})
    everything: dict[str, object] = {}
    exec("from hapticut import *", everything)
    assert everything.keys() - {"__builtins__"} == set(hapticut.__all__)


def test_the_first_module_can_be_looked_over():
    assert {"Box", "Simulation", "SimulationConfig", "SphereHead", "Tool", "Workpiece", "build_block"} < set(NAMES)
    assert 100 <= len(NAMES) <= 130, "names that few programs need belong in a submodule"


@pytest.mark.parametrize("room", ROOMS)
def test_what_is_a_folder_in_cpp_is_a_module_in_python(room):
    headers = "\n".join(path.read_text("utf-8") for path in (REPOSITORY / "include" / "hapticut" / room).rglob("*.hpp"))
    types = COMPILED & set(re.findall(r"^(?:struct|class|enum class) (?:alignas\(\w+\) )?(\w+)\b(?!;)", headers, re.M))
    assert types and not [name for name in types - MOVED if name not in getattr(hapticut, room).__all__]


def classes(owner=core):
    for thing in vars(owner).values():
        if inspect.isclass(thing) and thing.__module__.startswith("hapticut") and thing is not owner:
            yield thing
            yield from classes(thing)


def test_classes_say_where_they_are_imported_from_and_are_pickled_by_it():
    found = list(classes())
    assert len(found) > 150 and not [cls for cls in found if cls.__module__ == core.__name__]
    for cls in found:
        assert pickle.loads(pickle.dumps(cls)) is cls
    assert repr(hapticut.loop.commands.Undo) == "<class 'hapticut.loop.commands.Undo'>"
    with pytest.raises(hapticut.Error) as caught:
        hapticut.find_preset("cheese")
    assert type(caught.value).__module__ == "hapticut"


def test_functions_say_where_they_are_imported_from():
    for module in MODULES:
        for name in COMPILED & set(module.__all__):
            if inspect.isroutine(thing := getattr(module, name)):
                assert thing.__module__ == module.__name__, name


LOOK = """
import pickle, pydoc, hapticut
assert pickle.loads(pickle.dumps(hapticut.build_block)) is hapticut.build_block
print(pydoc.plain(pydoc.render_doc(hapticut.build_block)), pydoc.plain(pydoc.render_doc(hapticut.analysis.ClosedLoop)))
try:
    hapticut.build_block(3)
except TypeError as error:
    print(error)
"""


def test_help_and_errors_speak_of_names_that_can_be_imported():
    printed = subprocess.run([sys.executable, "-c", LOOK], check=True, capture_output=True, text=True).stdout
    assert "in module hapticut\n" in printed and "in module hapticut.analysis\n" in printed
    assert printed.count("build_block(box: Box, voxel_size: ") == 1 and "1. (box: Box, " in printed
    assert "hapticut._hapticut." not in printed.replace("hapticut._hapticut.kWithIo", "")
    page = pydoc.plain(pydoc.render_doc(hapticut))
    assert "class Workpiece" in page and "hapticut._hapticut" not in page and "ClosedLoop" not in page


def test_a_name_that_is_elsewhere_is_said_where():
    for module, name, place in ((hapticut, "open_device", "hapticut.device.open_device"),
                                (hapticut, "SafetyGuard", "hapticut.safety.SafetyGuard"),
                                (hapticut.analysis, "Simulation", "hapticut.Simulation")):
        with pytest.raises(AttributeError, match=f"has no attribute '{name}'; it is {place}$"):
            getattr(module, name)
    with pytest.raises(AttributeError, match="'cheese'$"):
        hapticut.safety.cheese


WITHOUT_FILES = """
import importlib, sys, types
sys.modules["hapticut"] = alone = types.ModuleType("hapticut")
alone.__path__ = [sys.argv[1]]
core = importlib.import_module("hapticut._hapticut")
for name in sys.argv[2:]:
    delattr(core, name)
core.__all__ = [name for name in core.__all__ if name not in sys.argv[2:]]
core.kWithIo = False
del sys.modules["hapticut"]
import hapticut
print(hapticut.io.__all__, hasattr(hapticut.volume, "crop_to_box"))
hapticut.io.read_mesh
"""


def test_a_build_without_file_formats_offers_what_it_has_and_says_what_it_lacks():
    lacks = [*sorted(set(hapticut.io.__all__) - {"VdbImport", "kWithIo", "load_vdb", "save_vdb"}), "DeviceTick",
             "LabelInterpolation", "close_gaps", "resample"]
    done = subprocess.run([sys.executable, "-c", WITHOUT_FILES, hapticut.__path__[0], *lacks], capture_output=True,
                          text=True)
    assert done.stdout == "['VdbImport', 'kWithIo', 'load_vdb', 'save_vdb'] True\n", done.stderr
    assert "no attribute 'read_mesh'; this build has no file formats but .vdb (HAPTICUT_WITH_IMPORT was off" in done.stderr


def test_type_checkers_see_the_lists(tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed")
    offered = [f"{module.__name__}.{name}" for module in MODULES for name in module.__all__]
    script = tmp_path / "script.py"
    script.write_text("import hapticut\n" + "\n".join(offered) + "\nhapticut.ClosedLoop\nhapticut.safety.cheese\n"
                      "from hapticut import SafetyGuard\nreveal_type(hapticut.device.open_device)\n", encoding="utf-8")
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--config-file",
                           str(REPOSITORY / "pyproject.toml"), str(script)], cwd=tmp_path, capture_output=True, text=True)
    found = [line.split(": ", 1)[1] for line in done.stdout.splitlines() if ": note:" in line or ": error:" in line]
    assert len(found) == 4, done.stdout
    assert '"ClosedLoop"' in found[0] and '"cheese"' in found[1] and '"SafetyGuard"' in found[2]
    assert "-> hapticut._hapticut.Device" in found[3]
