# SPDX-License-Identifier: Apache-2.0
# Written by write_stubs.py.
from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import os
import pathlib
import typing
__all__: list = ['Arming', 'ArmingOptions', 'ArmingState', 'AxialCutForce', 'AxisMask', 'BodyDescription', 'Bounce', 'BounceTest', 'Box', 'BuildInfo', 'Buzz', 'Calibration', 'ChangedBlock', 'ClosedLoop', 'ClosedLoopConfig', 'Color', 'ColoredMesh', 'ConeHead', 'Contact', 'ContactBench', 'ContactMechanicsLaw', 'ContactProbe', 'ContactTime', 'CoupledResult', 'CouplingEnergy', 'CouplingGains', 'DampingMatrixLaw', 'DeepContact', 'DeltaFilter', 'Device', 'DeviceCapabilities', 'DeviceCommand', 'DeviceFault', 'DeviceModel', 'DeviceOutput', 'DeviceState', 'DeviceTick', 'DrillingTest', 'DryFriction', 'EdgeKind', 'Effects', 'EffectsInput', 'EnergyLedger', 'Error', 'FaultResponse', 'FlatHead', 'FlatRule', 'ForceLaw', 'ForceModel', 'FoundationLaw', 'Grade', 'Gravity', 'GreyRange', 'GreyVolume', 'GridFrame', 'GuardOptions', 'HandModel', 'HandleTorque', 'HeadBox', 'HertzianBurrLaw', 'IndexBox', 'InjectedFault', 'LHandle', 'LabelInterpolation', 'LabelMaterial', 'LabelVolume', 'LatencyHistogram', 'Layer', 'LinearWall', 'LoopSnapshot', 'Material', 'MaterialAmount', 'MaterialTable', 'MeridianSpring', 'MeshImport', 'MeshShell', 'MockDevice', 'MockOptions', 'ModelFactory', 'MolarParameters', 'MouseDevice', 'MouseOptions', 'MoveKey', 'NamedMesh', 'Output', 'OutputChange', 'OutputLimits', 'PassivityController', 'PassivityOptions', 'PictureOptions', 'Plant', 'PlantOptions', 'PlaybackDevice', 'PlaybackRange', 'PoseGate', 'PoseGateOptions', 'PressTest', 'ProbedMotions', 'Profile', 'ProfileEdge', 'ProfileHead', 'Quadrature', 'RawLayout', 'RayHandle', 'RealtimeLoop', 'RealtimeLoopOptions', 'RealtimeOptions', 'RecognizedProfile', 'RecordedEffects', 'Recorder', 'RecorderOptions', 'Recording', 'RecordingInfo', 'RemovalLaw', 'ReplayDifference', 'ReplayReport', 'Requests', 'RunOptions', 'RunReport', 'SafetyEvent', 'SafetyGuard', 'SafetyLog', 'SafetyLogEntry', 'Scene', 'Simulation', 'SimulationConfig', 'SimulationModel', 'SimulationModelOptions', 'SphereHead', 'Spindle', 'SpindleMotor', 'SpindleState', 'Spring', 'StabilitySearch', 'StageTimes', 'StepInput', 'StepResult', 'StepStatus', 'StickSlip', 'ThermalBudget', 'ThermalOptions', 'ThesisLaw', 'ThesisMode', 'Tool', 'ToolHead', 'ToolSnapshot', 'TriangleMesh', 'TwistDrillLaw', 'UnclaimedLabels', 'ValueType', 'VdbImport', 'Vibration', 'VibrationPhase', 'VirtualCoupling', 'VolumeBuildOptions', 'VolumeReadOptions', 'Watchdog', 'WatchdogOptions', 'Workpiece', 'WorkpieceSnapshot', 'WorkpieceSurface', 'WorkspaceMap', 'WorkspaceMapOptions', 'WorstCase', 'Wrench', 'advance', 'axial_cut_force', 'box_around', 'box_of_volume', 'build_block', 'build_body', 'build_from_grey', 'build_from_labels', 'build_from_mesh', 'build_from_shells', 'build_info', 'build_layered_slab', 'build_molar', 'build_sphere', 'calibrate', 'capabilities', 'check_input', 'christmas_tree_head', 'close_gaps', 'colored', 'commands', 'contact_models', 'contact_point', 'count_from', 'count_labels', 'coupling_gains', 'crop_to_box', 'crop_to_samples', 'cylinder_head', 'describe', 'describe_molar', 'device_drivers', 'device_model', 'device_models', 'extract_surface', 'fill_cavities', 'filtered', 'find_preset', 'find_scene', 'flame_head', 'gravity_wrench', 'grey_range', 'growth_limited', 'hand_model', 'hand_models', 'has_any', 'head_in_handle', 'injected_faults', 'inverted_cone_head', 'is_rotation', 'is_stable', 'kBlockEdge', 'kBlockVoxels', 'kEmpty', 'kFastestSpindle', 'kFastestVibration', 'kFullSpinSpeed', 'kMaxMaterials', 'kMaxVolumeSamples', 'kMolarCaries', 'kMolarDentin', 'kMolarEnamel', 'kMolarPulp', 'kMostPlayedSteps', 'kRecordingFormat', 'kRejected', 'kSafetyEvents', 'kSmallestFill', 'kTreeWaist', 'kWithIo', 'keep_largest_component', 'label_range', 'largest_contact_stiffness', 'largest_stable_stiffness', 'least_force_growth', 'load_vdb', 'masked', 'material_color', 'materials_of', 'measure_bounce', 'measure_buzz', 'measure_fault_response', 'mesh_of_revolution', 'most_blocks', 'most_voxels', 'needle_head', 'obeys_the_rules', 'open_device', 'open_mock', 'open_playback', 'orthonormalized', 'output_limits', 'pear_head', 'preset_color', 'preset_names', 'pressed_search', 'profile_from_mesh', 'read_color_slices', 'read_grey_volume', 'read_invesalius_project', 'read_label_volume', 'read_mesh', 'read_raw_grey_volume', 'read_raw_label_volume', 'read_recording', 'replay', 'resample', 'rotation_from_vector', 'round_end_cylinder_head', 'round_end_tapered_head', 'round_head', 'saturated', 'save_vdb', 'scenes', 'scripted_path', 'simulation_of', 'standing_share', 'stiffness_for_accuracy', 'stiffness_for_device', 'tapered_head', 'thesis_handle_torque', 'thesis_mode', 'transport', 'twist_between', 'twist_drill_head', 'unused_label', 'validate', 'vector_from_rotation', 'wheel_head', 'with_spacing', 'write_csv', 'write_npz', 'write_nrrd', 'write_obj', 'write_picture', 'write_ply', 'write_stl']

class Error(RuntimeError):
    ...

class BuildInfo:

    def __repr__(self) -> str:
        ...

    @property
    def commit(self) -> str:
        ...

    @property
    def compiler(self) -> str:
        ...

    @property
    def cpu(self) -> str:
        ...

    @property
    def version(self) -> str:
        ...

class Wrench:

    def __copy__(self) -> Wrench:
        ...

    def __deepcopy__(self, memo: dict) -> Wrench:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, force: numpy.typing.ArrayLike=..., torque: numpy.typing.ArrayLike=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def force(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @force.setter
    def force(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def torque(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @torque.setter
    def torque(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class TriangleMesh:

    def __init__(self, vertices: numpy.typing.NDArray[numpy.float64], triangles: numpy.typing.NDArray[typing.Any]) -> None:
        ...

    def __repr__(self) -> str:
        ...

    @property
    def triangles(self) -> numpy.ndarray:
        ...

    @property
    def vertices(self) -> numpy.ndarray:
        ...

class Color:

    def __copy__(self) -> Color:
        ...

    def __deepcopy__(self, memo: dict) -> Color:
        ...

    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __hash__(self) -> int:
        ...

    def __init__(self, red: typing.SupportsInt | typing.SupportsIndex=255, green: typing.SupportsInt | typing.SupportsIndex=255, blue: typing.SupportsInt | typing.SupportsIndex=255) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def blue(self) -> int:
        ...

    @blue.setter
    def blue(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def green(self) -> int:
        ...

    @green.setter
    def green(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def red(self) -> int:
        ...

    @red.setter
    def red(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class ColoredMesh:

    def __init__(self, mesh: TriangleMesh, colors: collections.abc.Sequence[Color]) -> None:
        ...

    @property
    def colors(self) -> numpy.ndarray:
        ...

    @property
    def mesh(self) -> TriangleMesh:
        ...

class GreyVolume:

    def __init__(self, values: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, X_WG: numpy.typing.ArrayLike=...) -> None:
        ...

    def position(self, i: typing.SupportsInt | typing.SupportsIndex, j: typing.SupportsInt | typing.SupportsIndex, k: typing.SupportsInt | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def X_WG(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def dims(self) -> tuple[int, int, int]:
        ...

    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def values(self) -> numpy.ndarray:
        ...

class LabelVolume:

    def __init__(self, values: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, X_WG: numpy.typing.ArrayLike=...) -> None:
        ...

    def position(self, i: typing.SupportsInt | typing.SupportsIndex, j: typing.SupportsInt | typing.SupportsIndex, k: typing.SupportsInt | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def X_WG(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def dims(self) -> tuple[int, int, int]:
        ...

    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def values(self) -> numpy.ndarray:
        ...

class SphereHead:

    def __copy__(self) -> SphereHead:
        ...

    def __deepcopy__(self, memo: dict) -> SphereHead:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def radius(self) -> float:
        ...

    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ConeHead:

    def __copy__(self) -> ConeHead:
        ...

    def __deepcopy__(self, memo: dict) -> ConeHead:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, half_angle: typing.SupportsFloat | typing.SupportsIndex, height: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def half_angle(self) -> float:
        ...

    @half_angle.setter
    def half_angle(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def height(self) -> float:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class FlatRule:
    __members__: typing.ClassVar[dict[str, FlatRule]]
    both: typing.ClassVar[FlatRule]
    bottom_only: typing.ClassVar[FlatRule]
    nearest: typing.ClassVar[FlatRule]
    side_only: typing.ClassVar[FlatRule]

    @typing.overload
    def __eq__(self, other: FlatRule) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: FlatRule) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class FlatHead:

    def __copy__(self) -> FlatHead:
        ...

    def __deepcopy__(self, memo: dict) -> FlatHead:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex, height: typing.SupportsFloat | typing.SupportsIndex, rule: FlatRule=FlatRule.nearest) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def height(self) -> float:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def radius(self) -> float:
        ...

    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rule(self) -> FlatRule:
        ...

    @rule.setter
    def rule(self, arg0: FlatRule) -> None:
        ...

class EdgeKind:
    __members__: typing.ClassVar[dict[str, EdgeKind]]
    cutting: typing.ClassVar[EdgeKind]
    smooth: typing.ClassVar[EdgeKind]

    @typing.overload
    def __eq__(self, other: EdgeKind) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: EdgeKind) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class ProfileEdge:
    kind: EdgeKind

    def __copy__(self) -> ProfileEdge:
        ...

    def __deepcopy__(self, memo: dict) -> ProfileEdge:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, rho: typing.SupportsFloat | typing.SupportsIndex=0.0, z: typing.SupportsFloat | typing.SupportsIndex=0.0, radius: typing.SupportsFloat | typing.SupportsIndex=0.0, kind: EdgeKind=EdgeKind.cutting) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def radius(self) -> float:
        ...

    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rho(self) -> float:
        ...

    @rho.setter
    def rho(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def z(self) -> float:
        ...

    @z.setter
    def z(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Profile:

    def __copy__(self) -> Profile:
        ...

    def __deepcopy__(self, memo: dict) -> Profile:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, tip: typing.SupportsFloat | typing.SupportsIndex=0.0, edges: collections.abc.Sequence[ProfileEdge]=[]) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def edges(self) -> list[ProfileEdge]:
        ...

    @edges.setter
    def edges(self, arg0: collections.abc.Sequence[ProfileEdge]) -> None:
        ...

    @property
    def tip(self) -> float:
        ...

    @tip.setter
    def tip(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MeridianSpring:

    @property
    def depth(self) -> float:
        ...

    @property
    def n_axial(self) -> float:
        ...

    @property
    def n_radial(self) -> float:
        ...

class ProfileHead:

    def __init__(self, profile: Profile, tolerance: typing.SupportsFloat | typing.SupportsIndex=0.01) -> None:
        ...

    def exact_spring(self, rho: typing.SupportsFloat | typing.SupportsIndex, z: typing.SupportsFloat | typing.SupportsIndex) -> MeridianSpring:
        ...

    @property
    def profile(self) -> Profile:
        ...

    @property
    def reach(self) -> float:
        ...

    @property
    def table_error(self) -> float:
        ...

    @property
    def tolerance(self) -> float:
        ...

    @property
    def volume(self) -> float:
        ...

class HeadBox:

    def __repr__(self) -> str:
        ...

    @property
    def max(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def min(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class Spring:

    @property
    def depth(self) -> float:
        ...

    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class ToolHead:

    def __init__(self, shape: SphereHead | ConeHead | FlatHead | ProfileHead) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def bounding_box(self) -> HeadBox:
        ...

    def description(self) -> str:
        ...

    def largest_radius(self) -> float:
        ...

    def profile(self) -> Profile:
        ...

    def reach(self) -> float:
        ...

    def spring_at(self, p_TQ: numpy.typing.ArrayLike) -> Spring:
        ...

    def volume(self) -> float:
        ...

    @property
    def shape(self) -> SphereHead | ConeHead | FlatHead | ProfileHead:
        ...

class RecognizedProfile:

    @property
    def X_MT(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def deviation(self) -> float:
        ...

    @property
    def profile(self) -> Profile:
        ...

class RayHandle:

    def __copy__(self) -> RayHandle:
        ...

    def __deepcopy__(self, memo: dict) -> RayHandle:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, length: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def length(self) -> float:
        ...

    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class LHandle:

    def __copy__(self) -> LHandle:
        ...

    def __deepcopy__(self, memo: dict) -> LHandle:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, length: typing.SupportsFloat | typing.SupportsIndex=0.0, neck: typing.SupportsFloat | typing.SupportsIndex=0.0, bend: typing.SupportsFloat | typing.SupportsIndex=1.5707963267948966) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def bend(self) -> float:
        ...

    @bend.setter
    def bend(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def length(self) -> float:
        ...

    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def neck(self) -> float:
        ...

    @neck.setter
    def neck(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class HandleTorque:
    __members__: typing.ClassVar[dict[str, HandleTorque]]
    full_wrench: typing.ClassVar[HandleTorque]
    thesis: typing.ClassVar[HandleTorque]

    @typing.overload
    def __eq__(self, other: HandleTorque) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: HandleTorque) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class Spindle:

    def __copy__(self) -> Spindle:
        ...

    def __deepcopy__(self, memo: dict) -> Spindle:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, speed: typing.SupportsFloat | typing.SupportsIndex=0.0, power_limit: typing.SupportsFloat | typing.SupportsIndex=..., acceleration_limit: typing.SupportsFloat | typing.SupportsIndex=..., droop: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def acceleration_limit(self) -> float:
        ...

    @acceleration_limit.setter
    def acceleration_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def droop(self) -> float:
        ...

    @droop.setter
    def droop(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def power_limit(self) -> float:
        ...

    @power_limit.setter
    def power_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def speed(self) -> float:
        ...

    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class SpindleMotor:

    def __init__(self, spindle: Spindle) -> None:
        ...

    def advance(self, torque: typing.SupportsFloat | typing.SupportsIndex, dt: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def halt(self) -> None:
        ...

    def set(self, setting: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def loaded(self) -> bool:
        ...

    @property
    def setting(self) -> float:
        ...

    @property
    def speed(self) -> float:
        ...

class Tool:

    def __init__(self, head: ToolHead, handle: RayHandle | LHandle=..., spindle: Spindle=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    @property
    def X_HT(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def handle(self) -> RayHandle | LHandle:
        ...

    @property
    def head(self) -> ToolHead:
        ...

    @property
    def spindle(self) -> Spindle:
        ...

class Material:

    def __copy__(self) -> Material:
        ...

    def __deepcopy__(self, memo: dict) -> Material:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, name: str='', *, relative_stiffness: typing.SupportsFloat | typing.SupportsIndex=1.0, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, cutting_ratio: typing.SupportsFloat | typing.SupportsIndex=0.5, specific_cutting_energy: typing.SupportsFloat | typing.SupportsIndex=300000000.0, edge_pressure: typing.SupportsFloat | typing.SupportsIndex=0.0, static_friction: typing.SupportsFloat | typing.SupportsIndex=0.3, dynamic_friction: typing.SupportsFloat | typing.SupportsIndex=0.3, tangential_stiffness: typing.SupportsFloat | typing.SupportsIndex=1000.0, density: typing.SupportsFloat | typing.SupportsIndex=1000.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def cutting_ratio(self) -> float:
        ...

    @cutting_ratio.setter
    def cutting_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def density(self) -> float:
        ...

    @density.setter
    def density(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def dynamic_friction(self) -> float:
        ...

    @dynamic_friction.setter
    def dynamic_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def edge_pressure(self) -> float:
        ...

    @edge_pressure.setter
    def edge_pressure(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def name(self) -> str:
        ...

    @name.setter
    def name(self, arg0: str) -> None:
        ...

    @property
    def relative_stiffness(self) -> float:
        ...

    @relative_stiffness.setter
    def relative_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def specific_cutting_energy(self) -> float:
        ...

    @specific_cutting_energy.setter
    def specific_cutting_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def static_friction(self) -> float:
        ...

    @static_friction.setter
    def static_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def tangential_stiffness(self) -> float:
        ...

    @tangential_stiffness.setter
    def tangential_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MaterialTable:

    def __contains__(self, id: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...

    def __getitem__(self, id: typing.SupportsInt | typing.SupportsIndex) -> Material:
        ...

    def __getstate__(self) -> list[Material]:
        ...

    @typing.overload
    def __init__(self) -> None:
        ...

    @typing.overload
    def __init__(self, materials: collections.abc.Sequence[Material]) -> None:
        ...

    def __iter__(self) -> collections.abc.Iterator:
        ...

    def __len__(self) -> int:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: collections.abc.Sequence[Material]) -> None:
        ...

    def add(self, material: Material) -> int:
        ...

    def all(self) -> list[Material]:
        ...

    def contains(self, id: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...

    def id_of(self, name: str) -> int:
        ...

    def size(self) -> int:
        ...

class IndexBox:

    def __copy__(self) -> IndexBox:
        ...

    def __deepcopy__(self, memo: dict) -> IndexBox:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, min: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']=[0, 0, 0], max: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']=[-1, -1, -1]) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    def empty(self) -> bool:
        ...

    def voxels(self) -> int:
        ...

    @property
    def max(self) -> typing.Annotated[list[int], 'FixedSize(3)']:
        ...

    @max.setter
    def max(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> None:
        ...

    @property
    def min(self) -> typing.Annotated[list[int], 'FixedSize(3)']:
        ...

    @min.setter
    def min(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> None:
        ...

class GridFrame:

    def __copy__(self) -> GridFrame:
        ...

    def __deepcopy__(self, memo: dict) -> GridFrame:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex=0.0001, X_WV: numpy.typing.ArrayLike=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    def center(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def X_WV(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_WV.setter
    def X_WV(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def voxel_size(self) -> float:
        ...

    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Box:

    def __copy__(self) -> Box:
        ...

    def __deepcopy__(self, memo: dict) -> Box:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, min: numpy.typing.ArrayLike, max: numpy.typing.ArrayLike) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def max(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @max.setter
    def max(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def min(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @min.setter
    def min(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class MaterialAmount:

    def __repr__(self) -> str:
        ...

    @property
    def mass(self) -> float:
        ...

    @property
    def material(self) -> int:
        ...

    @property
    def volume(self) -> float:
        ...

    @property
    def voxels(self) -> int:
        ...

class WorkpieceSnapshot:
    ...

class Quadrature:
    __members__: typing.ClassVar[dict[str, Quadrature]]
    centroid: typing.ClassVar[Quadrature]
    sub_voxel: typing.ClassVar[Quadrature]
    voxel_center: typing.ClassVar[Quadrature]

    @typing.overload
    def __eq__(self, other: Quadrature) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: Quadrature) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class UnclaimedLabels:
    __members__: typing.ClassVar[dict[str, UnclaimedLabels]]
    leave_out: typing.ClassVar[UnclaimedLabels]
    refuse: typing.ClassVar[UnclaimedLabels]

    @typing.overload
    def __eq__(self, other: UnclaimedLabels) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: UnclaimedLabels) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class VolumeBuildOptions:

    def __copy__(self) -> VolumeBuildOptions:
        ...

    def __deepcopy__(self, memo: dict) -> VolumeBuildOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex=0.0, *, crop_samples: IndexBox | None=None, crop: Box | None=None, antialias: bool=True, subsamples: typing.SupportsInt | typing.SupportsIndex=4) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def antialias(self) -> bool:
        ...

    @antialias.setter
    def antialias(self, arg0: bool) -> None:
        ...

    @property
    def crop(self) -> Box | None:
        ...

    @crop.setter
    def crop(self, arg0: Box | None) -> None:
        ...

    @property
    def crop_samples(self) -> IndexBox | None:
        ...

    @crop_samples.setter
    def crop_samples(self, arg0: IndexBox | None) -> None:
        ...

    @property
    def subsamples(self) -> int:
        ...

    @subsamples.setter
    def subsamples(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def voxel_size(self) -> float:
        ...

    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class GreyRange:
    material: Material

    def __copy__(self) -> GreyRange:
        ...

    def __deepcopy__(self, memo: dict) -> GreyRange:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, from_: typing.SupportsFloat | typing.SupportsIndex, to: typing.SupportsFloat | typing.SupportsIndex, material: Material) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def from_(self) -> float:
        ...

    @from_.setter
    def from_(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def to(self) -> float:
        ...

    @to.setter
    def to(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Grade:

    def __copy__(self) -> Grade:
        ...

    def __deepcopy__(self, memo: dict) -> Grade:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, low: typing.SupportsFloat | typing.SupportsIndex, high: typing.SupportsFloat | typing.SupportsIndex, at_low: Material, at_high: Material, *, steps: typing.SupportsInt | typing.SupportsIndex=128) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def at_high(self) -> Material:
        ...

    @at_high.setter
    def at_high(self, arg0: Material) -> None:
        ...

    @property
    def at_low(self) -> Material:
        ...

    @at_low.setter
    def at_low(self, arg0: Material) -> None:
        ...

    @property
    def high(self) -> float:
        ...

    @high.setter
    def high(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def low(self) -> float:
        ...

    @low.setter
    def low(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def steps(self) -> int:
        ...

    @steps.setter
    def steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class Workpiece:

    @staticmethod
    def from_arrays(material: numpy.ndarray, fill: numpy.ndarray | None, frame: GridFrame, materials: MaterialTable, origin: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']=[0, 0, 0]) -> Workpiece:
        ...

    @staticmethod
    @typing.overload
    def from_intensity(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, ranges: collections.abc.Sequence[GreyRange], X_WG: numpy.typing.ArrayLike=..., options: VolumeBuildOptions=...) -> Workpiece:
        ...

    @staticmethod
    @typing.overload
    def from_intensity(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, ranges: Grade, X_WG: numpy.typing.ArrayLike=..., options: VolumeBuildOptions=...) -> Workpiece:
        ...

    @staticmethod
    def from_labels(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, materials: dict, X_WG: numpy.typing.ArrayLike=..., options: VolumeBuildOptions=..., unclaimed: UnclaimedLabels=UnclaimedLabels.refuse) -> Workpiece:
        ...

    def __copy__(self) -> Workpiece:
        ...

    def __deepcopy__(self, memo: dict) -> Workpiece:
        ...

    def __repr__(self) -> str:
        ...

    def amounts(self) -> list[MaterialAmount]:
        ...

    def bounds(self) -> IndexBox:
        ...

    def centroid_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> numpy.typing.NDArray[numpy.float64]:
        ...

    def clone(self) -> Workpiece:
        ...

    def empty(self) -> bool:
        ...

    def fill_array(self, box: IndexBox | None=None) -> numpy.ndarray:
        ...

    def fill_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> float:
        ...

    def hash(self) -> int:
        ...

    def material_array(self, box: IndexBox | None=None) -> numpy.ndarray:
        ...

    def material_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> int:
        ...

    def memory_bytes(self) -> int:
        ...

    def pool_bytes(self) -> int:
        ...

    def redo_block(self) -> typing.Annotated[list[int], 'FixedSize(3)'] | None:
        ...

    def reserve_blocks(self, count: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def reserve_undo(self, blocks: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def reserved_blocks(self) -> int:
        ...

    def restore(self, snapshot: WorkpieceSnapshot) -> None:
        ...

    def set_mark(self) -> None:
        ...

    def set_materials(self, materials: MaterialTable) -> None:
        ...

    def snapshot(self) -> WorkpieceSnapshot:
        ...

    def solid_voxels(self) -> int:
        ...

    def undo_block(self) -> typing.Annotated[list[int], 'FixedSize(3)'] | None:
        ...

    @property
    def frame(self) -> GridFrame:
        ...

    @property
    def marks(self) -> int:
        ...

    @property
    def materials(self) -> MaterialTable:
        ...

    @property
    def redo_marks(self) -> int:
        ...

    @property
    def undo_blocks(self) -> int:
        ...

    @property
    def voxel_size(self) -> float:
        ...

class WorkpieceSurface:

    @property
    def materials(self) -> numpy.ndarray:
        ...

    @property
    def mesh(self) -> TriangleMesh:
        ...

class BodyDescription:

    def __copy__(self) -> BodyDescription:
        ...

    def __deepcopy__(self, memo: dict) -> BodyDescription:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, box: Box, distance: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsFloat | typing.SupportsIndex], material: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def box(self) -> Box:
        ...

    @box.setter
    def box(self, arg0: Box) -> None:
        ...

    @property
    def distance(self) -> collections.abc.Callable[[numpy.typing.ArrayLike], float]:
        ...

    @distance.setter
    def distance(self, arg0: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...

    @property
    def material(self) -> collections.abc.Callable[[numpy.typing.ArrayLike], int]:
        ...

    @material.setter
    def material(self, arg0: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...

class Layer:
    material: Material

    def __copy__(self) -> Layer:
        ...

    def __deepcopy__(self, memo: dict) -> Layer:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, material: Material, thickness: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def thickness(self) -> float:
        ...

    @thickness.setter
    def thickness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MolarParameters:

    def __copy__(self) -> MolarParameters:
        ...

    def __deepcopy__(self, memo: dict) -> MolarParameters:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, crown_mesiodistal: typing.SupportsFloat | typing.SupportsIndex=0.0111, *, crown_buccolingual: typing.SupportsFloat | typing.SupportsIndex=0.0105, crown_height: typing.SupportsFloat | typing.SupportsIndex=0.0075, cervix_mesiodistal: typing.SupportsFloat | typing.SupportsIndex=0.009, cervix_buccolingual: typing.SupportsFloat | typing.SupportsIndex=0.009, cervical_curvature: typing.SupportsFloat | typing.SupportsIndex=0.001, mesial_root_length: typing.SupportsFloat | typing.SupportsIndex=0.014, distal_root_length: typing.SupportsFloat | typing.SupportsIndex=0.013, furcation_depth: typing.SupportsFloat | typing.SupportsIndex=0.0036, fossa_depth: typing.SupportsFloat | typing.SupportsIndex=0.0028, fissure_depth: typing.SupportsFloat | typing.SupportsIndex=0.00035, fissure_half_width: typing.SupportsFloat | typing.SupportsIndex=0.0004, distal_cusp: bool=True, enamel_at_cusps: typing.SupportsFloat | typing.SupportsIndex=0.0022, enamel_on_walls: typing.SupportsFloat | typing.SupportsIndex=0.0013, enamel_in_fossa: typing.SupportsFloat | typing.SupportsIndex=0.0012, chamber_mesiodistal: typing.SupportsFloat | typing.SupportsIndex=0.0046, chamber_buccolingual: typing.SupportsFloat | typing.SupportsIndex=0.0038, chamber_roof: typing.SupportsFloat | typing.SupportsIndex=0.00064, chamber_height: typing.SupportsFloat | typing.SupportsIndex=0.00157, horn_height: typing.SupportsFloat | typing.SupportsIndex=0.0012, canal_radius: typing.SupportsFloat | typing.SupportsIndex=0.0004, canal_radius_at_apex: typing.SupportsFloat | typing.SupportsIndex=0.0002, apical_dentin: typing.SupportsFloat | typing.SupportsIndex=0.001, caries_depth: typing.SupportsFloat | typing.SupportsIndex=0.0, caries_width: typing.SupportsFloat | typing.SupportsIndex=0.0025) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def apical_dentin(self) -> float:
        ...

    @apical_dentin.setter
    def apical_dentin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def canal_radius(self) -> float:
        ...

    @canal_radius.setter
    def canal_radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def canal_radius_at_apex(self) -> float:
        ...

    @canal_radius_at_apex.setter
    def canal_radius_at_apex(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def caries_depth(self) -> float:
        ...

    @caries_depth.setter
    def caries_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def caries_width(self) -> float:
        ...

    @caries_width.setter
    def caries_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def cervical_curvature(self) -> float:
        ...

    @cervical_curvature.setter
    def cervical_curvature(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def cervix_buccolingual(self) -> float:
        ...

    @cervix_buccolingual.setter
    def cervix_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def cervix_mesiodistal(self) -> float:
        ...

    @cervix_mesiodistal.setter
    def cervix_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def chamber_buccolingual(self) -> float:
        ...

    @chamber_buccolingual.setter
    def chamber_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def chamber_height(self) -> float:
        ...

    @chamber_height.setter
    def chamber_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def chamber_mesiodistal(self) -> float:
        ...

    @chamber_mesiodistal.setter
    def chamber_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def chamber_roof(self) -> float:
        ...

    @chamber_roof.setter
    def chamber_roof(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def crown_buccolingual(self) -> float:
        ...

    @crown_buccolingual.setter
    def crown_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def crown_height(self) -> float:
        ...

    @crown_height.setter
    def crown_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def crown_mesiodistal(self) -> float:
        ...

    @crown_mesiodistal.setter
    def crown_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def distal_cusp(self) -> bool:
        ...

    @distal_cusp.setter
    def distal_cusp(self, arg0: bool) -> None:
        ...

    @property
    def distal_root_length(self) -> float:
        ...

    @distal_root_length.setter
    def distal_root_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def enamel_at_cusps(self) -> float:
        ...

    @enamel_at_cusps.setter
    def enamel_at_cusps(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def enamel_in_fossa(self) -> float:
        ...

    @enamel_in_fossa.setter
    def enamel_in_fossa(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def enamel_on_walls(self) -> float:
        ...

    @enamel_on_walls.setter
    def enamel_on_walls(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def fissure_depth(self) -> float:
        ...

    @fissure_depth.setter
    def fissure_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def fissure_half_width(self) -> float:
        ...

    @fissure_half_width.setter
    def fissure_half_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def fossa_depth(self) -> float:
        ...

    @fossa_depth.setter
    def fossa_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def furcation_depth(self) -> float:
        ...

    @furcation_depth.setter
    def furcation_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def horn_height(self) -> float:
        ...

    @horn_height.setter
    def horn_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def mesial_root_length(self) -> float:
        ...

    @mesial_root_length.setter
    def mesial_root_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MeshShell:

    def __init__(self, mesh: TriangleMesh, material: typing.SupportsInt | typing.SupportsIndex=0) -> None:
        ...

    @property
    def material(self) -> int:
        ...

    @material.setter
    def material(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def mesh(self) -> TriangleMesh:
        ...

class MeshImport:

    def __copy__(self) -> MeshImport:
        ...

    def __deepcopy__(self, memo: dict) -> MeshImport:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex=0.0001, subsamples: typing.SupportsInt | typing.SupportsIndex=8) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def subsamples(self) -> int:
        ...

    @subsamples.setter
    def subsamples(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def voxel_size(self) -> float:
        ...

    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class LabelMaterial:
    material: Material

    def __copy__(self) -> LabelMaterial:
        ...

    def __deepcopy__(self, memo: dict) -> LabelMaterial:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, labels: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], material: Material) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def labels(self) -> list[int]:
        ...

    @labels.setter
    def labels(self, arg0: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...

class RemovalLaw:
    __members__: typing.ClassVar[dict[str, RemovalLaw]]
    constant_energy: typing.ClassVar[RemovalLaw]
    elastic_release: typing.ClassVar[RemovalLaw]
    none: typing.ClassVar[RemovalLaw]

    @typing.overload
    def __eq__(self, other: RemovalLaw) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: RemovalLaw) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class ForceLaw:

    def holds_deep_contact(self) -> bool:
        ...

    def needs_moments(self) -> bool:
        ...

    def require_head(self, head: ToolHead) -> None:
        ...

class FoundationLaw(ForceLaw):
    kAxisSlip: typing.ClassVar[float] = 0.28369998931884766
    kAxisZone: typing.ClassVar[float] = 0.25
    kLargestExponent: typing.ClassVar[float] = 1.0000000150474662e+30
    kLeastEnergyShare: typing.ClassVar[float] = 9.999999974752427e-07
    kSlipRegularization: typing.ClassVar[float] = 0.0010000000474974513
    kSmallestPart: typing.ClassVar[float] = 9.999999974752427e-07

    def __init__(self) -> None:
        ...

class ThesisLaw(ForceLaw):

    class Constants:

        def __copy__(self) -> ThesisLaw.Constants:
            ...

        def __deepcopy__(self, memo: dict) -> ThesisLaw.Constants:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, reference_voxel_size: typing.SupportsFloat | typing.SupportsIndex=0.0001, *, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, spin_torque: typing.SupportsFloat | typing.SupportsIndex=0.3, spin_exponent: typing.SupportsFloat | typing.SupportsIndex=0.0, required_power: typing.SupportsFloat | typing.SupportsIndex=1e-09) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def damping(self) -> float:
            ...

        @damping.setter
        def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def reference_voxel_size(self) -> float:
            ...

        @reference_voxel_size.setter
        def reference_voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def required_power(self) -> float:
            ...

        @required_power.setter
        def required_power(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def spin_exponent(self) -> float:
            ...

        @spin_exponent.setter
        def spin_exponent(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def spin_torque(self) -> float:
            ...

        @spin_torque.setter
        def spin_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

    def __init__(self, constants: ThesisLaw.Constants) -> None:
        ...

    @property
    def constants(self) -> ThesisLaw.Constants:
        ...

class ContactMechanicsLaw(ForceLaw):

    @staticmethod
    def depth_of(head: ToolHead, volume: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def __init__(self, effective_modulus: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def energy(self, head: ToolHead, d: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def force(self, head: ToolHead, d: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

class HertzianBurrLaw(ForceLaw):

    def __init__(self, stiffness: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def energy(self, R: typing.SupportsFloat | typing.SupportsIndex, h: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def force(self, R: typing.SupportsFloat | typing.SupportsIndex, h: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

class DampingMatrixLaw(ForceLaw):

    class Constants:

        def __copy__(self) -> DampingMatrixLaw.Constants:
            ...

        def __deepcopy__(self, memo: dict) -> DampingMatrixLaw.Constants:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, resistance: typing.SupportsFloat | typing.SupportsIndex=100000000.0, friction: typing.SupportsFloat | typing.SupportsIndex=0.3) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def friction(self) -> float:
            ...

        @friction.setter
        def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def resistance(self) -> float:
            ...

        @resistance.setter
        def resistance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

    def __init__(self, constants: DampingMatrixLaw.Constants) -> None:
        ...

class TwistDrillLaw(ForceLaw):

    class Constants:

        def __copy__(self) -> TwistDrillLaw.Constants:
            ...

        def __deepcopy__(self, memo: dict) -> TwistDrillLaw.Constants:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, specific_energy: typing.SupportsFloat | typing.SupportsIndex=100000000.0, largest_feed_per_turn: typing.SupportsFloat | typing.SupportsIndex=0.001) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def largest_feed_per_turn(self) -> float:
            ...

        @largest_feed_per_turn.setter
        def largest_feed_per_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

        @property
        def specific_energy(self) -> float:
            ...

        @specific_energy.setter
        def specific_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

    @staticmethod
    def point_angle(head: ToolHead) -> float:
        ...

    def __init__(self, constants: TwistDrillLaw.Constants) -> None:
        ...

    def thrust(self, diameter: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex, point_angle: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def torque(self, diameter: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

class DryFriction:

    def __copy__(self) -> DryFriction:
        ...

    def __deepcopy__(self, memo: dict) -> DryFriction:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, static_friction: typing.SupportsFloat | typing.SupportsIndex=0.3, dynamic_friction: typing.SupportsFloat | typing.SupportsIndex=0.3, tangential_stiffness: typing.SupportsFloat | typing.SupportsIndex=1000.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def dynamic_friction(self) -> float:
        ...

    @dynamic_friction.setter
    def dynamic_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def static_friction(self) -> float:
        ...

    @static_friction.setter
    def static_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def tangential_stiffness(self) -> float:
        ...

    @tangential_stiffness.setter
    def tangential_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class StickSlip:

    class Outcome:

        @property
        def dissipated(self) -> float:
            ...

        @property
        def force(self) -> numpy.typing.NDArray[numpy.float64]:
            ...

        @property
        def stiffness(self) -> numpy.typing.NDArray[numpy.float64]:
            ...

    def __init__(self) -> None:
        ...

    def move(self, normal_force: numpy.typing.ArrayLike, displacement: numpy.typing.ArrayLike, friction: DryFriction, share: typing.SupportsFloat | typing.SupportsIndex=1.0) -> StickSlip.Outcome:
        ...

    def release(self) -> None:
        ...

    @property
    def anchored(self) -> bool:
        ...

    @property
    def sliding(self) -> bool:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @property
    def stored(self) -> float:
        ...

    @property
    def stretch(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class DeepContact:

    class Outcome:

        @property
        def force(self) -> numpy.typing.NDArray[numpy.float64]:
            ...

        @property
        def released(self) -> float:
            ...

        @property
        def stored(self) -> float:
            ...

        @property
        def stored_before(self) -> float:
            ...
    kDeep: typing.ClassVar[float] = 0.52
    kFree: typing.ClassVar[float] = 0.25

    def __init__(self) -> None:
        ...

    def move(self, start: numpy.typing.ArrayLike, to: numpy.typing.ArrayLike, filled: typing.SupportsFloat | typing.SupportsIndex, normal_force: numpy.typing.ArrayLike, radius: typing.SupportsFloat | typing.SupportsIndex) -> DeepContact.Outcome:
        ...

    def release(self) -> None:
        ...

    def wants_normal_force(self, filled: typing.SupportsFloat | typing.SupportsIndex) -> bool:
        ...

    @property
    def held(self) -> bool:
        ...

    @property
    def normal(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @property
    def stored(self) -> float:
        ...

class DrillingTest:

    def __copy__(self) -> DrillingTest:
        ...

    def __deepcopy__(self, memo: dict) -> DrillingTest:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex, spindle_speed: typing.SupportsFloat | typing.SupportsIndex, feed_speed: typing.SupportsFloat | typing.SupportsIndex, thrust: typing.SupportsFloat | typing.SupportsIndex, torque: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def feed_speed(self) -> float:
        ...

    @feed_speed.setter
    def feed_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def radius(self) -> float:
        ...

    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def spindle_speed(self) -> float:
        ...

    @spindle_speed.setter
    def spindle_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def thrust(self) -> float:
        ...

    @thrust.setter
    def thrust(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def torque(self) -> float:
        ...

    @torque.setter
    def torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Calibration:

    def __copy__(self) -> Calibration:
        ...

    def __deepcopy__(self, memo: dict) -> Calibration:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, specific_cutting_energy: typing.SupportsFloat | typing.SupportsIndex=0.0, *, cutting_ratio: typing.SupportsFloat | typing.SupportsIndex=0.0, edge_pressure: typing.SupportsFloat | typing.SupportsIndex=0.0, edge_identified: bool=False, chip_identified: bool=True, thrust_residual: typing.SupportsFloat | typing.SupportsIndex=0.0, torque_residual: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def chip_identified(self) -> bool:
        ...

    @chip_identified.setter
    def chip_identified(self, arg0: bool) -> None:
        ...

    @property
    def cutting_ratio(self) -> float:
        ...

    @cutting_ratio.setter
    def cutting_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def edge_identified(self) -> bool:
        ...

    @edge_identified.setter
    def edge_identified(self, arg0: bool) -> None:
        ...

    @property
    def edge_pressure(self) -> float:
        ...

    @edge_pressure.setter
    def edge_pressure(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def specific_cutting_energy(self) -> float:
        ...

    @specific_cutting_energy.setter
    def specific_cutting_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def thrust_residual(self) -> float:
        ...

    @thrust_residual.setter
    def thrust_residual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def torque_residual(self) -> float:
        ...

    @torque_residual.setter
    def torque_residual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class AxialCutForce:

    def __repr__(self) -> str:
        ...

    @property
    def thrust(self) -> float:
        ...

    @property
    def torque(self) -> float:
        ...

class Gravity:

    def __copy__(self) -> Gravity:
        ...

    def __deepcopy__(self, memo: dict) -> Gravity:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, mass: typing.SupportsFloat | typing.SupportsIndex=0.0, center_of_mass: numpy.typing.ArrayLike=..., acceleration: numpy.typing.ArrayLike=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def acceleration(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @acceleration.setter
    def acceleration(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def center_of_mass(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @center_of_mass.setter
    def center_of_mass(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def mass(self) -> float:
        ...

    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Vibration:

    def __copy__(self) -> Vibration:
        ...

    def __deepcopy__(self, memo: dict) -> Vibration:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, frequency: typing.SupportsFloat | typing.SupportsIndex=150.0, amplitude: typing.SupportsFloat | typing.SupportsIndex=0.3, amplitude_per_watt: typing.SupportsFloat | typing.SupportsIndex=0.0, largest_amplitude: typing.SupportsFloat | typing.SupportsIndex=0.5) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def amplitude(self) -> float:
        ...

    @amplitude.setter
    def amplitude(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def amplitude_per_watt(self) -> float:
        ...

    @amplitude_per_watt.setter
    def amplitude_per_watt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def frequency(self) -> float:
        ...

    @frequency.setter
    def frequency(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def largest_amplitude(self) -> float:
        ...

    @largest_amplitude.setter
    def largest_amplitude(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class DeltaFilter:

    def __copy__(self) -> DeltaFilter:
        ...

    def __deepcopy__(self, memo: dict) -> DeltaFilter:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, delta: typing.SupportsFloat | typing.SupportsIndex=0.5, epsilon: typing.SupportsFloat | typing.SupportsIndex=0.005) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def delta(self) -> float:
        ...

    @delta.setter
    def delta(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def epsilon(self) -> float:
        ...

    @epsilon.setter
    def epsilon(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class AxisMask:

    def __copy__(self) -> AxisMask:
        ...

    def __deepcopy__(self, memo: dict) -> AxisMask:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, force: typing.Annotated[collections.abc.Sequence[bool], 'FixedSize(3)']=[True, True, True], torque: typing.Annotated[collections.abc.Sequence[bool], 'FixedSize(3)']=[True, True, True]) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def force(self) -> typing.Annotated[list[bool], 'FixedSize(3)']:
        ...

    @force.setter
    def force(self, arg0: typing.Annotated[collections.abc.Sequence[bool], 'FixedSize(3)']) -> None:
        ...

    @property
    def torque(self) -> typing.Annotated[list[bool], 'FixedSize(3)']:
        ...

    @torque.setter
    def torque(self, arg0: typing.Annotated[collections.abc.Sequence[bool], 'FixedSize(3)']) -> None:
        ...

class OutputLimits:

    def __copy__(self) -> OutputLimits:
        ...

    def __deepcopy__(self, memo: dict) -> OutputLimits:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, largest_force: typing.SupportsFloat | typing.SupportsIndex=..., *, largest_torque: typing.SupportsFloat | typing.SupportsIndex=..., force_growth: typing.SupportsFloat | typing.SupportsIndex=..., torque_growth: typing.SupportsFloat | typing.SupportsIndex=..., ramp_time: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def force_growth(self) -> float:
        ...

    @force_growth.setter
    def force_growth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def largest_force(self) -> float:
        ...

    @largest_force.setter
    def largest_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def largest_torque(self) -> float:
        ...

    @largest_torque.setter
    def largest_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def ramp_time(self) -> float:
        ...

    @ramp_time.setter
    def ramp_time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def torque_growth(self) -> float:
        ...

    @torque_growth.setter
    def torque_growth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Effects:

    def __copy__(self) -> Effects:
        ...

    def __deepcopy__(self, memo: dict) -> Effects:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, gravity: Gravity | None=None, *, vibration: Vibration | None=None, delta_filter: DeltaFilter | None=None, enabled: AxisMask=..., limits: OutputLimits=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def delta_filter(self) -> DeltaFilter | None:
        ...

    @delta_filter.setter
    def delta_filter(self, arg0: DeltaFilter | None) -> None:
        ...

    @property
    def enabled(self) -> AxisMask:
        ...

    @enabled.setter
    def enabled(self, arg0: AxisMask) -> None:
        ...

    @property
    def gravity(self) -> Gravity | None:
        ...

    @gravity.setter
    def gravity(self, arg0: Gravity | None) -> None:
        ...

    @property
    def limits(self) -> OutputLimits:
        ...

    @limits.setter
    def limits(self, arg0: OutputLimits) -> None:
        ...

    @property
    def vibration(self) -> Vibration | None:
        ...

    @vibration.setter
    def vibration(self, arg0: Vibration | None) -> None:
        ...

class VibrationPhase:

    def __init__(self) -> None:
        ...

    def advance(self, vibration: Vibration, touching: bool, power: typing.SupportsFloat | typing.SupportsIndex, dt: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

class EffectsInput:

    def __copy__(self) -> EffectsInput:
        ...

    def __deepcopy__(self, memo: dict) -> EffectsInput:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, X_WH: numpy.typing.ArrayLike=..., *, X_WT: numpy.typing.ArrayLike=..., touching: bool=False, power: typing.SupportsFloat | typing.SupportsIndex=0.0, dt: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def X_WH(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_WH.setter
    def X_WH(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def X_WT(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_WT.setter
    def X_WT(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def dt(self) -> float:
        ...

    @dt.setter
    def dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def power(self) -> float:
        ...

    @power.setter
    def power(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def touching(self) -> bool:
        ...

    @touching.setter
    def touching(self, arg0: bool) -> None:
        ...

class Output:

    def __init__(self) -> None:
        ...

    def drop(self) -> None:
        ...

    def give(self, effects: Effects, at: EffectsInput, wrench: Wrench) -> Wrench:
        ...

    def restart(self) -> None:
        ...

    @property
    def given(self) -> Wrench:
        ...

class StepInput:

    def __copy__(self) -> StepInput:
        ...

    def __deepcopy__(self, memo: dict) -> StepInput:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, pose: numpy.typing.ArrayLike=..., velocity: numpy.typing.ArrayLike=..., dt: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def dt(self) -> float:
        ...

    @dt.setter
    def dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def pose(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @pose.setter
    def pose(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @velocity.setter
    def velocity(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class StepStatus:
    __array_ufunc__ = None
    __members__: typing.ClassVar[dict[str, StepStatus]]
    blocks_exhausted: typing.ClassVar[StepStatus]
    blocks_low: typing.ClassVar[StepStatus]
    detail_reduced: typing.ClassVar[StepStatus]
    dt_rejected: typing.ClassVar[StepStatus]
    engaged_layer_thick: typing.ClassVar[StepStatus]
    force_not_finite: typing.ClassVar[StepStatus]
    jump_rejected: typing.ClassVar[StepStatus]
    ok: typing.ClassVar[StepStatus]
    pose_rejected: typing.ClassVar[StepStatus]
    power_limited: typing.ClassVar[StepStatus]
    removed_list_full: typing.ClassVar[StepStatus]
    velocity_rejected: typing.ClassVar[StepStatus]
    vibration_left_out: typing.ClassVar[StepStatus]

    def __and__(self, other: typing.Any) -> typing.Any:
        ...

    @typing.overload
    def __eq__(self, other: StepStatus) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: StepStatus) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __or__(self, other: typing.Any) -> typing.Any:
        ...

    def __rand__(self, other: typing.Any) -> typing.Any:
        ...

    def __repr__(self) -> str:
        ...

    def __ror__(self, other: typing.Any) -> typing.Any:
        ...

    def __rxor__(self, other: typing.Any) -> typing.Any:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    def __xor__(self, other: typing.Any) -> typing.Any:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class Contact:

    def __repr__(self) -> str:
        ...

    @property
    def depth(self) -> float:
        ...

    @property
    def level_of_detail(self) -> int:
        ...

    @property
    def volume(self) -> float:
        ...

    @property
    def voxels(self) -> int:
        ...

class SpindleState:

    def __repr__(self) -> str:
        ...

    @property
    def speed(self) -> float:
        ...

    @property
    def torque(self) -> float:
        ...

class EnergyLedger:

    def __repr__(self) -> str:
        ...

    def closure(self) -> float:
        ...

    def imbalance(self) -> float:
        ...

    @property
    def anchored(self) -> float:
        ...

    @property
    def credited(self) -> float:
        ...

    @property
    def cutting(self) -> float:
        ...

    @property
    def damping(self) -> float:
        ...

    @property
    def elastic(self) -> float:
        ...

    @property
    def entered(self) -> float:
        ...

    @property
    def hand_work(self) -> float:
        ...

    @property
    def motor_work(self) -> float:
        ...

    @property
    def released(self) -> float:
        ...

    @property
    def rubbing(self) -> float:
        ...

    @property
    def sliding(self) -> float:
        ...

class StepResult:

    def __repr__(self) -> str:
        ...

    @property
    def contact(self) -> Contact:
        ...

    @property
    def energy(self) -> EnergyLedger:
        ...

    @property
    def force(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def model(self) -> Wrench:
        ...

    @property
    def removed_materials(self) -> numpy.ndarray:
        ...

    @property
    def removed_volume(self) -> float:
        ...

    @property
    def removed_voxels(self) -> numpy.ndarray:
        ...

    @property
    def spindle(self) -> SpindleState:
        ...

    @property
    def status(self) -> int:
        ...

    @property
    def sub_steps(self) -> int:
        ...

    @property
    def torque(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class ContactProbe:

    def __repr__(self) -> str:
        ...

    @property
    def contact(self) -> Contact:
        ...

    @property
    def sliding(self) -> bool:
        ...

    @property
    def stiffness(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def wrench(self) -> Wrench:
        ...

class ContactTime:
    __members__: typing.ClassVar[dict[str, ContactTime]]
    end: typing.ClassVar[ContactTime]
    middle: typing.ClassVar[ContactTime]

    @typing.overload
    def __eq__(self, other: ContactTime) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: ContactTime) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class ProbedMotions:
    __members__: typing.ClassVar[dict[str, ProbedMotions]]
    all: typing.ClassVar[ProbedMotions]
    translations: typing.ClassVar[ProbedMotions]

    @typing.overload
    def __eq__(self, other: ProbedMotions) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: ProbedMotions) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class SimulationConfig:

    def __copy__(self) -> SimulationConfig:
        ...

    def __deepcopy__(self, memo: dict) -> SimulationConfig:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, reference_stiffness: typing.SupportsFloat | typing.SupportsIndex=10000000000000.0, *, removal: RemovalLaw=RemovalLaw.constant_energy, quadrature: Quadrature=Quadrature.centroid, contact_time: ContactTime=ContactTime.middle, law: ForceLaw | None=None, friction: DryFriction | None=None, deep_contact: bool=True, handle_torque: HandleTorque=HandleTorque.full_wrench, handle_torque_scale: typing.SupportsFloat | typing.SupportsIndex=1.0, effects: Effects=..., update_rate: typing.SupportsFloat | typing.SupportsIndex=1000.0, reserved_blocks: typing.SupportsInt | typing.SupportsIndex=2048, removed_voxel_capacity: typing.SupportsInt | typing.SupportsIndex=0, voxel_budget: typing.SupportsInt | typing.SupportsIndex=0, stage_times: bool=False, shortest_dt: typing.SupportsFloat | typing.SupportsIndex=1e-06, longest_dt: typing.SupportsFloat | typing.SupportsIndex=0.1, longest_sweep: typing.SupportsInt | typing.SupportsIndex=64) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def contact_time(self) -> ContactTime:
        ...

    @contact_time.setter
    def contact_time(self, arg0: ContactTime) -> None:
        ...

    @property
    def deep_contact(self) -> bool:
        ...

    @deep_contact.setter
    def deep_contact(self, arg0: bool) -> None:
        ...

    @property
    def effects(self) -> Effects:
        ...

    @effects.setter
    def effects(self, arg0: Effects) -> None:
        ...

    @property
    def friction(self) -> DryFriction | None:
        ...

    @friction.setter
    def friction(self, arg0: DryFriction | None) -> None:
        ...

    @property
    def handle_torque(self) -> HandleTorque:
        ...

    @handle_torque.setter
    def handle_torque(self, arg0: HandleTorque) -> None:
        ...

    @property
    def handle_torque_scale(self) -> float:
        ...

    @handle_torque_scale.setter
    def handle_torque_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def law(self) -> ForceLaw | None:
        ...

    @law.setter
    def law(self, arg1: ForceLaw | None) -> None:
        ...

    @property
    def longest_dt(self) -> float:
        ...

    @longest_dt.setter
    def longest_dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def longest_sweep(self) -> int:
        ...

    @longest_sweep.setter
    def longest_sweep(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def quadrature(self) -> Quadrature:
        ...

    @quadrature.setter
    def quadrature(self, arg0: Quadrature) -> None:
        ...

    @property
    def reference_stiffness(self) -> float:
        ...

    @reference_stiffness.setter
    def reference_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def removal(self) -> RemovalLaw:
        ...

    @removal.setter
    def removal(self, arg0: RemovalLaw) -> None:
        ...

    @property
    def removed_voxel_capacity(self) -> int:
        ...

    @removed_voxel_capacity.setter
    def removed_voxel_capacity(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def reserved_blocks(self) -> int:
        ...

    @reserved_blocks.setter
    def reserved_blocks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def shortest_dt(self) -> float:
        ...

    @shortest_dt.setter
    def shortest_dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def stage_times(self) -> bool:
        ...

    @stage_times.setter
    def stage_times(self, arg0: bool) -> None:
        ...

    @property
    def update_rate(self) -> float:
        ...

    @update_rate.setter
    def update_rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def voxel_budget(self) -> int:
        ...

    @voxel_budget.setter
    def voxel_budget(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class ThesisMode:

    def __copy__(self) -> ThesisMode:
        ...

    def __deepcopy__(self, memo: dict) -> ThesisMode:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, law: ThesisLaw.Constants=..., *, update_rate: typing.SupportsFloat | typing.SupportsIndex=1000.0, tool_mass: typing.SupportsFloat | typing.SupportsIndex=0.0, center_of_mass: numpy.typing.ArrayLike=..., handle_torque_scale: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def center_of_mass(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @center_of_mass.setter
    def center_of_mass(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def handle_torque_scale(self) -> float:
        ...

    @handle_torque_scale.setter
    def handle_torque_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def law(self) -> ThesisLaw.Constants:
        ...

    @law.setter
    def law(self, arg0: ThesisLaw.Constants) -> None:
        ...

    @property
    def tool_mass(self) -> float:
        ...

    @tool_mass.setter
    def tool_mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def update_rate(self) -> float:
        ...

    @update_rate.setter
    def update_rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class StageTimes:

    def __repr__(self) -> str:
        ...

    @property
    def add_friction(self) -> float:
        ...

    @property
    def book_energy(self) -> float:
        ...

    @property
    def check_input(self) -> float:
        ...

    @property
    def find_blocks(self) -> float:
        ...

    @property
    def give_output(self) -> float:
        ...

    @property
    def hold_deep_contact(self) -> float:
        ...

    @property
    def plan_sub_step(self) -> float:
        ...

    @property
    def plan_sweep(self) -> float:
        ...

    @property
    def press_and_cut(self) -> float:
        ...

    @property
    def remove_emptied(self) -> float:
        ...

    @property
    def transport_to_handle(self) -> float:
        ...

class WorstCase:

    def __repr__(self) -> str:
        ...

    @property
    def blocks(self) -> int:
        ...

    @property
    def level_of_detail(self) -> int:
        ...

    @property
    def sub_steps(self) -> int:
        ...

    @property
    def voxels(self) -> int:
        ...

class Simulation:

    def __init__(self, workpiece: Workpiece, tool: Tool, config: SimulationConfig=...) -> None:
        ...

    def changed_blocks(self) -> tuple[numpy.ndarray, bool]:
        ...

    def halt_spindle(self) -> None:
        ...

    def probe(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex, motions: ProbedMotions=...) -> ContactProbe:
        ...

    def redo(self, most: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...

    def reserve_blocks(self, count: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def reserve_undo(self, blocks: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def reset(self, workpiece: Workpiece) -> None:
        ...

    def restore(self, snapshot: WorkpieceSnapshot) -> None:
        ...

    def run(self, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> numpy.ndarray:
        ...

    def set_effects(self, effects: Effects) -> None:
        ...

    def set_friction(self, friction: DryFriction | None) -> None:
        ...

    def set_materials(self, materials: MaterialTable) -> None:
        ...

    def set_removal(self, removal: RemovalLaw) -> None:
        ...

    def set_spindle_speed(self, speed: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def set_tool(self, tool: Tool) -> None:
        ...

    def set_undo_mark(self) -> None:
        ...

    def snapshot(self) -> WorkpieceSnapshot:
        ...

    def step(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> StepResult:
        ...

    def undo(self, most: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...

    def worst_case(self) -> WorstCase:
        ...

    @property
    def config(self) -> SimulationConfig:
        ...

    @property
    def last_input(self) -> StepInput:
        ...

    @property
    def last_result(self) -> StepResult:
        ...

    @property
    def redo_marks(self) -> int:
        ...

    @property
    def removed_in_run(self) -> numpy.ndarray:
        ...

    @property
    def removed_volume_by_material(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def spindle_setting(self) -> float:
        ...

    @property
    def stage_times(self) -> StageTimes:
        ...

    @property
    def steps(self) -> int:
        ...

    @property
    def tool(self) -> Tool:
        ...

    @property
    def undo_marks(self) -> int:
        ...

    @property
    def workpiece(self) -> Workpiece:
        ...

    @property
    def workpiece_exchanges(self) -> int:
        ...

class Scene:

    def input(self, tick: typing.SupportsInt | typing.SupportsIndex) -> StepInput:
        ...

    def make(self) -> Simulation:
        ...

    @property
    def description(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

class VdbImport:

    class Kind:
        __members__: typing.ClassVar[dict[str, VdbImport.Kind]]
        fog_volume: typing.ClassVar[VdbImport.Kind]
        from_class: typing.ClassVar[VdbImport.Kind]
        level_set: typing.ClassVar[VdbImport.Kind]

        @typing.overload
        def __eq__(self, other: VdbImport.Kind) -> bool:
            ...

        @typing.overload
        def __eq__(self, other: typing.Any) -> bool:
            ...

        def __getstate__(self) -> int:
            ...

        def __hash__(self) -> int:
            ...

        def __index__(self) -> int:
            ...

        def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __int__(self) -> int:
            ...

        @typing.overload
        def __ne__(self, other: VdbImport.Kind) -> bool:
            ...

        @typing.overload
        def __ne__(self, other: typing.Any) -> bool:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __str__(self) -> str:
            ...

        @property
        def name(self) -> str:
            ...

        @property
        def value(self) -> int:
            ...

    def __init__(self, material: Material, grid: str='', unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0, kind: VdbImport.Kind=VdbImport.Kind.from_class) -> None:
        ...

    @property
    def grid(self) -> str:
        ...

    @grid.setter
    def grid(self, arg0: str) -> None:
        ...

    @property
    def kind(self) -> VdbImport.Kind:
        ...

    @kind.setter
    def kind(self, arg0: VdbImport.Kind) -> None:
        ...

    @property
    def material(self) -> Material:
        ...

    @material.setter
    def material(self, arg0: Material) -> None:
        ...

    @property
    def unit_mm(self) -> float:
        ...

    @unit_mm.setter
    def unit_mm(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class NamedMesh:

    @property
    def mesh(self) -> TriangleMesh:
        ...

    @property
    def name(self) -> str:
        ...

class PictureOptions:
    background: Color

    def __copy__(self) -> PictureOptions:
        ...

    def __deepcopy__(self, memo: dict) -> PictureOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, width: typing.SupportsInt | typing.SupportsIndex=1200, *, height: typing.SupportsInt | typing.SupportsIndex=900, view_direction: numpy.typing.ArrayLike=..., up: numpy.typing.ArrayLike=..., background: Color=..., scale_bar: bool=True) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def height(self) -> int:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def scale_bar(self) -> bool:
        ...

    @scale_bar.setter
    def scale_bar(self, arg0: bool) -> None:
        ...

    @property
    def up(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @up.setter
    def up(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def view_direction(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @view_direction.setter
    def view_direction(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def width(self) -> int:
        ...

    @width.setter
    def width(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class VolumeReadOptions:

    def __copy__(self) -> VolumeReadOptions:
        ...

    def __deepcopy__(self, memo: dict) -> VolumeReadOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, spacing: numpy.typing.ArrayLike | None=None, dicom_series: str='') -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def dicom_series(self) -> str:
        ...

    @dicom_series.setter
    def dicom_series(self, arg0: str) -> None:
        ...

    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64] | None:
        ...

    @spacing.setter
    def spacing(self, arg0: numpy.typing.ArrayLike | None) -> None:
        ...

class ValueType:
    __members__: typing.ClassVar[dict[str, ValueType]]
    float32: typing.ClassVar[ValueType]
    float64: typing.ClassVar[ValueType]
    int16: typing.ClassVar[ValueType]
    int32: typing.ClassVar[ValueType]
    int64: typing.ClassVar[ValueType]
    int8: typing.ClassVar[ValueType]
    uint16: typing.ClassVar[ValueType]
    uint32: typing.ClassVar[ValueType]
    uint64: typing.ClassVar[ValueType]
    uint8: typing.ClassVar[ValueType]

    @typing.overload
    def __eq__(self, other: ValueType) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: ValueType) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class RawLayout:
    big_endian: bool
    type: ValueType

    def __copy__(self) -> RawLayout:
        ...

    def __deepcopy__(self, memo: dict) -> RawLayout:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, dims: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']=[0, 0, 0], *, spacing: numpy.typing.ArrayLike=..., type: ValueType=ValueType.uint8, big_endian: bool=False, skip: typing.SupportsInt | typing.SupportsIndex=0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def dims(self) -> typing.Annotated[list[int], 'FixedSize(3)']:
        ...

    @dims.setter
    def dims(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], 'FixedSize(3)']) -> None:
        ...

    @property
    def skip(self) -> int:
        ...

    @skip.setter
    def skip(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @spacing.setter
    def spacing(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class LabelInterpolation:
    __members__: typing.ClassVar[dict[str, LabelInterpolation]]
    nearest: typing.ClassVar[LabelInterpolation]
    smooth: typing.ClassVar[LabelInterpolation]

    @typing.overload
    def __eq__(self, other: LabelInterpolation) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: LabelInterpolation) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class DeviceFault:
    __members__: typing.ClassVar[dict[str, DeviceFault]]
    disconnected: typing.ClassVar[DeviceFault]
    driver_error: typing.ClassVar[DeviceFault]
    force_limit: typing.ClassVar[DeviceFault]
    motors_warm: typing.ClassVar[DeviceFault]
    none: typing.ClassVar[DeviceFault]
    overloaded: typing.ClassVar[DeviceFault]
    speed_limit: typing.ClassVar[DeviceFault]
    switched_off: typing.ClassVar[DeviceFault]
    uncalibrated: typing.ClassVar[DeviceFault]

    @typing.overload
    def __eq__(self, other: DeviceFault) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: DeviceFault) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class DeviceCapabilities:

    def __copy__(self) -> DeviceCapabilities:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceCapabilities:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, model: str='', *, vendor: str='', serial_number: str='', driver_version: str='', input_degrees_of_freedom: typing.SupportsInt | typing.SupportsIndex=6, output_degrees_of_freedom: typing.SupportsInt | typing.SupportsIndex=0, peak_force: typing.SupportsFloat | typing.SupportsIndex=0.0, continuous_force: typing.SupportsFloat | typing.SupportsIndex=0.0, peak_torque: typing.SupportsFloat | typing.SupportsIndex=0.0, continuous_torque: typing.SupportsFloat | typing.SupportsIndex=0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, rotational_stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, position_resolution: typing.SupportsFloat | typing.SupportsIndex=0.0, workspace_low: numpy.typing.ArrayLike=..., workspace_high: numpy.typing.ArrayLike=..., rate: typing.SupportsFloat | typing.SupportsIndex=1000.0, hard_realtime: bool=True) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def continuous_force(self) -> float:
        ...

    @continuous_force.setter
    def continuous_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def continuous_torque(self) -> float:
        ...

    @continuous_torque.setter
    def continuous_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def driver_version(self) -> str:
        ...

    @driver_version.setter
    def driver_version(self, arg0: str) -> None:
        ...

    @property
    def hard_realtime(self) -> bool:
        ...

    @hard_realtime.setter
    def hard_realtime(self, arg0: bool) -> None:
        ...

    @property
    def input_degrees_of_freedom(self) -> int:
        ...

    @input_degrees_of_freedom.setter
    def input_degrees_of_freedom(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def model(self) -> str:
        ...

    @model.setter
    def model(self, arg0: str) -> None:
        ...

    @property
    def output_degrees_of_freedom(self) -> int:
        ...

    @output_degrees_of_freedom.setter
    def output_degrees_of_freedom(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def peak_force(self) -> float:
        ...

    @peak_force.setter
    def peak_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def peak_torque(self) -> float:
        ...

    @peak_torque.setter
    def peak_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def position_resolution(self) -> float:
        ...

    @position_resolution.setter
    def position_resolution(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rate(self) -> float:
        ...

    @rate.setter
    def rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rotational_stiffness(self) -> float:
        ...

    @rotational_stiffness.setter
    def rotational_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def serial_number(self) -> str:
        ...

    @serial_number.setter
    def serial_number(self, arg0: str) -> None:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def vendor(self) -> str:
        ...

    @vendor.setter
    def vendor(self, arg0: str) -> None:
        ...

    @property
    def workspace_high(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @workspace_high.setter
    def workspace_high(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def workspace_low(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @workspace_low.setter
    def workspace_low(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class DeviceState:

    def __copy__(self) -> DeviceState:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceState:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, X_BS: numpy.typing.ArrayLike=..., *, velocity: numpy.typing.ArrayLike=..., buttons: typing.SupportsInt | typing.SupportsIndex=0, time: typing.SupportsFloat | typing.SupportsIndex=0.0, sequence: typing.SupportsInt | typing.SupportsIndex=0, epoch: typing.SupportsInt | typing.SupportsIndex=0, temperature: typing.SupportsFloat | typing.SupportsIndex=0.0, valid: bool=True, fault: DeviceFault=DeviceFault.none) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    def pressed(self, button: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...

    @property
    def X_BS(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_BS.setter
    def X_BS(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def buttons(self) -> int:
        ...

    @buttons.setter
    def buttons(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def epoch(self) -> int:
        ...

    @epoch.setter
    def epoch(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def fault(self) -> DeviceFault:
        ...

    @fault.setter
    def fault(self, arg0: DeviceFault) -> None:
        ...

    @property
    def sequence(self) -> int:
        ...

    @sequence.setter
    def sequence(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def temperature(self) -> float:
        ...

    @temperature.setter
    def temperature(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def time(self) -> float:
        ...

    @time.setter
    def time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def valid(self) -> bool:
        ...

    @valid.setter
    def valid(self, arg0: bool) -> None:
        ...

    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @velocity.setter
    def velocity(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

class DeviceCommand:

    def __copy__(self) -> DeviceCommand:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceCommand:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, wrench: Wrench=..., stop: bool=False) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def stop(self) -> bool:
        ...

    @stop.setter
    def stop(self, arg0: bool) -> None:
        ...

    @property
    def wrench(self) -> Wrench:
        ...

    @wrench.setter
    def wrench(self, arg0: Wrench) -> None:
        ...

class OutputChange:
    __array_ufunc__ = None
    __members__: typing.ClassVar[dict[str, OutputChange]]
    by_driver: typing.ClassVar[OutputChange]
    cooled: typing.ClassVar[OutputChange]
    damped: typing.ClassVar[OutputChange]
    held_back: typing.ClassVar[OutputChange]
    no_actuator: typing.ClassVar[OutputChange]
    none: typing.ClassVar[OutputChange]
    not_finite: typing.ClassVar[OutputChange]
    ramped: typing.ClassVar[OutputChange]
    saturated: typing.ClassVar[OutputChange]
    slew_limited: typing.ClassVar[OutputChange]

    def __and__(self, other: typing.Any) -> typing.Any:
        ...

    @typing.overload
    def __eq__(self, other: OutputChange) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: OutputChange) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __or__(self, other: typing.Any) -> typing.Any:
        ...

    def __rand__(self, other: typing.Any) -> typing.Any:
        ...

    def __repr__(self) -> str:
        ...

    def __ror__(self, other: typing.Any) -> typing.Any:
        ...

    def __rxor__(self, other: typing.Any) -> typing.Any:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    def __xor__(self, other: typing.Any) -> typing.Any:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class DeviceOutput:

    def __copy__(self) -> DeviceOutput:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceOutput:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, commanded: Wrench=..., applied: Wrench=..., changes: typing.SupportsInt | typing.SupportsIndex=0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def applied(self) -> Wrench:
        ...

    @applied.setter
    def applied(self, arg0: Wrench) -> None:
        ...

    @property
    def changes(self) -> int:
        ...

    @changes.setter
    def changes(self, arg1: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def commanded(self) -> Wrench:
        ...

    @commanded.setter
    def commanded(self, arg0: Wrench) -> None:
        ...

class ArmingState:
    __members__: typing.ClassVar[dict[str, ArmingState]]
    armed: typing.ClassVar[ArmingState]
    fault: typing.ClassVar[ArmingState]
    off: typing.ClassVar[ArmingState]
    on: typing.ClassVar[ArmingState]
    ramp: typing.ClassVar[ArmingState]
    wait_free: typing.ClassVar[ArmingState]

    @typing.overload
    def __eq__(self, other: ArmingState) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: ArmingState) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class SafetyEvent:
    __members__: typing.ClassVar[dict[str, SafetyEvent]]
    armed: typing.ClassVar[SafetyEvent]
    continuous_limited: typing.ClassVar[SafetyEvent]
    device_fault: typing.ClassVar[SafetyEvent]
    emergency_stop: typing.ClassVar[SafetyEvent]
    engaged: typing.ClassVar[SafetyEvent]
    exception: typing.ClassVar[SafetyEvent]
    fading_in: typing.ClassVar[SafetyEvent]
    fault: typing.ClassVar[SafetyEvent]
    fault_reset: typing.ClassVar[SafetyEvent]
    force_not_finite: typing.ClassVar[SafetyEvent]
    late_wake_up: typing.ClassVar[SafetyEvent]
    model_swapped: typing.ClassVar[SafetyEvent]
    motors_warm: typing.ClassVar[SafetyEvent]
    passivity: typing.ClassVar[SafetyEvent]
    paused: typing.ClassVar[SafetyEvent]
    pose_frozen: typing.ClassVar[SafetyEvent]
    pose_jump: typing.ClassVar[SafetyEvent]
    pose_not_a_rotation: typing.ClassVar[SafetyEvent]
    pose_not_finite: typing.ClassVar[SafetyEvent]
    pose_outside_workspace: typing.ClassVar[SafetyEvent]
    pose_turn_jump: typing.ClassVar[SafetyEvent]
    pose_units: typing.ClassVar[SafetyEvent]
    reading_invalid: typing.ClassVar[SafetyEvent]
    reading_stale: typing.ClassVar[SafetyEvent]
    recalibrated: typing.ClassVar[SafetyEvent]
    reclutched: typing.ClassVar[SafetyEvent]
    saturated: typing.ClassVar[SafetyEvent]
    slew_limited: typing.ClassVar[SafetyEvent]
    start_inside: typing.ClassVar[SafetyEvent]
    waiting_free: typing.ClassVar[SafetyEvent]
    watchdog_fading: typing.ClassVar[SafetyEvent]
    watchdog_fault: typing.ClassVar[SafetyEvent]
    watchdog_late: typing.ClassVar[SafetyEvent]

    @typing.overload
    def __eq__(self, other: SafetyEvent) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: SafetyEvent) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class SafetyLogEntry:

    @property
    def event(self) -> SafetyEvent:
        ...

    @property
    def sequence(self) -> int:
        ...

    @property
    def time(self) -> float:
        ...

    @property
    def value(self) -> float:
        ...

class SafetyLog:

    def __init__(self) -> None:
        ...

    def begin_tick(self, time: typing.SupportsFloat | typing.SupportsIndex, sequence: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def count(self, event: SafetyEvent) -> int:
        ...

    def drain(self) -> list[SafetyLogEntry]:
        ...

    def note(self, event: SafetyEvent, value: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def report(self, event: SafetyEvent, value: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    @property
    def dropped(self) -> int:
        ...

class Requests:

    def __init__(self) -> None:
        ...

    def emergency_stop(self) -> None:
        ...

    def forget_stop(self) -> None:
        ...

    def interrupt(self, reason: SafetyEvent) -> None:
        ...

    def reset_fault(self) -> None:
        ...

    def stop(self) -> None:
        ...

    def take_interruption(self) -> SafetyEvent:
        ...

    def take_reset(self) -> bool:
        ...

    @property
    def emergency(self) -> bool:
        ...

    @property
    def reset_wanted(self) -> bool:
        ...

    @property
    def stop_wanted(self) -> bool:
        ...

class PoseGateOptions:

    def __copy__(self) -> PoseGateOptions:
        ...

    def __deepcopy__(self, memo: dict) -> PoseGateOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, fastest: typing.SupportsFloat | typing.SupportsIndex=2.0, *, fastest_turn: typing.SupportsFloat | typing.SupportsIndex=30.0, workspace_margin: typing.SupportsFloat | typing.SupportsIndex=0.05, rotation_tolerance: typing.SupportsFloat | typing.SupportsIndex=0.001, hold_ticks: typing.SupportsInt | typing.SupportsIndex=20, frozen_ticks: typing.SupportsInt | typing.SupportsIndex=30, frozen_turn: typing.SupportsFloat | typing.SupportsIndex=0.1, frozen_speed: typing.SupportsFloat | typing.SupportsIndex=0.005) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def fastest(self) -> float:
        ...

    @fastest.setter
    def fastest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def fastest_turn(self) -> float:
        ...

    @fastest_turn.setter
    def fastest_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def frozen_speed(self) -> float:
        ...

    @frozen_speed.setter
    def frozen_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def frozen_ticks(self) -> int:
        ...

    @frozen_ticks.setter
    def frozen_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def frozen_turn(self) -> float:
        ...

    @frozen_turn.setter
    def frozen_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def hold_ticks(self) -> int:
        ...

    @hold_ticks.setter
    def hold_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def rotation_tolerance(self) -> float:
        ...

    @rotation_tolerance.setter
    def rotation_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def workspace_margin(self) -> float:
        ...

    @workspace_margin.setter
    def workspace_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ArmingOptions:

    def __copy__(self) -> ArmingOptions:
        ...

    def __deepcopy__(self, memo: dict) -> ArmingOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, valid_ticks: typing.SupportsInt | typing.SupportsIndex=10, *, free_force: typing.SupportsFloat | typing.SupportsIndex=0.2, free_torque: typing.SupportsFloat | typing.SupportsIndex=0.02, free_ticks: typing.SupportsInt | typing.SupportsIndex=4, ramp: typing.SupportsFloat | typing.SupportsIndex=1.5, short_ramp: typing.SupportsFloat | typing.SupportsIndex=0.25) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def free_force(self) -> float:
        ...

    @free_force.setter
    def free_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def free_ticks(self) -> int:
        ...

    @free_ticks.setter
    def free_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def free_torque(self) -> float:
        ...

    @free_torque.setter
    def free_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def ramp(self) -> float:
        ...

    @ramp.setter
    def ramp(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def short_ramp(self) -> float:
        ...

    @short_ramp.setter
    def short_ramp(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def valid_ticks(self) -> int:
        ...

    @valid_ticks.setter
    def valid_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class PassivityOptions:
    enabled: bool

    def __copy__(self) -> PassivityOptions:
        ...

    def __deepcopy__(self, memo: dict) -> PassivityOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, enabled: bool=True, *, credit: typing.SupportsFloat | typing.SupportsIndex=0.005, allowance: typing.SupportsFloat | typing.SupportsIndex=0.0, greatest: typing.SupportsFloat | typing.SupportsIndex=0.0, greatest_damping: typing.SupportsFloat | typing.SupportsIndex=0.0, slowest: typing.SupportsFloat | typing.SupportsIndex=1e-06, free: typing.SupportsFloat | typing.SupportsIndex=0.001, delay: typing.SupportsInt | typing.SupportsIndex=0, free_ticks: typing.SupportsInt | typing.SupportsIndex=20) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def allowance(self) -> float:
        ...

    @allowance.setter
    def allowance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def credit(self) -> float:
        ...

    @credit.setter
    def credit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def delay(self) -> int:
        ...

    @delay.setter
    def delay(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def free(self) -> float:
        ...

    @free.setter
    def free(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def free_ticks(self) -> int:
        ...

    @free_ticks.setter
    def free_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def greatest(self) -> float:
        ...

    @greatest.setter
    def greatest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def greatest_damping(self) -> float:
        ...

    @greatest_damping.setter
    def greatest_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def slowest(self) -> float:
        ...

    @slowest.setter
    def slowest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ThermalOptions:

    def __copy__(self) -> ThermalOptions:
        ...

    def __deepcopy__(self, memo: dict) -> ThermalOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, time_constant: typing.SupportsFloat | typing.SupportsIndex=60.0, *, warm: typing.SupportsFloat | typing.SupportsIndex=1.0, cool: typing.SupportsFloat | typing.SupportsIndex=0.8, hot: typing.SupportsFloat | typing.SupportsIndex=0.7, cold: typing.SupportsFloat | typing.SupportsIndex=0.5, rate: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def cold(self) -> float:
        ...

    @cold.setter
    def cold(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def cool(self) -> float:
        ...

    @cool.setter
    def cool(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def hot(self) -> float:
        ...

    @hot.setter
    def hot(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rate(self) -> float:
        ...

    @rate.setter
    def rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def time_constant(self) -> float:
        ...

    @time_constant.setter
    def time_constant(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def warm(self) -> float:
        ...

    @warm.setter
    def warm(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class WatchdogOptions:

    def __copy__(self) -> WatchdogOptions:
        ...

    def __deepcopy__(self, memo: dict) -> WatchdogOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, period: typing.SupportsFloat | typing.SupportsIndex=0.001, *, late_ticks: typing.SupportsInt | typing.SupportsIndex=3, fade_ticks: typing.SupportsInt | typing.SupportsIndex=10, fade: typing.SupportsFloat | typing.SupportsIndex=0.03, fault_ticks: typing.SupportsInt | typing.SupportsIndex=50, latch: bool=False) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def fade(self) -> float:
        ...

    @fade.setter
    def fade(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def fade_ticks(self) -> int:
        ...

    @fade_ticks.setter
    def fade_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def fault_ticks(self) -> int:
        ...

    @fault_ticks.setter
    def fault_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def latch(self) -> bool:
        ...

    @latch.setter
    def latch(self, arg0: bool) -> None:
        ...

    @property
    def late_ticks(self) -> int:
        ...

    @late_ticks.setter
    def late_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class GuardOptions:
    arming: ArmingOptions
    gate: PoseGateOptions
    passivity: PassivityOptions
    thermal: ThermalOptions
    watchdog: WatchdogOptions

    def __copy__(self) -> GuardOptions:
        ...

    def __deepcopy__(self, memo: dict) -> GuardOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, gate: PoseGateOptions=..., *, arming: ArmingOptions=..., passivity: PassivityOptions=..., thermal: ThermalOptions=..., watchdog: WatchdogOptions=..., period: typing.SupportsFloat | typing.SupportsIndex=0.001, greatest_force: typing.SupportsFloat | typing.SupportsIndex=0.0, greatest_torque: typing.SupportsFloat | typing.SupportsIndex=0.0, slew: typing.SupportsFloat | typing.SupportsIndex=0.0, torque_slew: typing.SupportsFloat | typing.SupportsIndex=0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, fastest_contact: typing.SupportsFloat | typing.SupportsIndex=0.5, ramp_damping: typing.SupportsFloat | typing.SupportsIndex=-1.0, late: typing.SupportsFloat | typing.SupportsIndex=0.005, pause: typing.SupportsFloat | typing.SupportsIndex=0.02, not_finite_ticks: typing.SupportsInt | typing.SupportsIndex=3) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def fastest_contact(self) -> float:
        ...

    @fastest_contact.setter
    def fastest_contact(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def greatest_force(self) -> float:
        ...

    @greatest_force.setter
    def greatest_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def greatest_torque(self) -> float:
        ...

    @greatest_torque.setter
    def greatest_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def late(self) -> float:
        ...

    @late.setter
    def late(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def not_finite_ticks(self) -> int:
        ...

    @not_finite_ticks.setter
    def not_finite_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def pause(self) -> float:
        ...

    @pause.setter
    def pause(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def ramp_damping(self) -> float:
        ...

    @ramp_damping.setter
    def ramp_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def slew(self) -> float:
        ...

    @slew.setter
    def slew(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def torque_slew(self) -> float:
        ...

    @torque_slew.setter
    def torque_slew(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class SafetyGuard:

    def __init__(self, capabilities: DeviceCapabilities, options: GuardOptions=...) -> None:
        ...

    def admit(self, reading: DeviceState) -> DeviceState:
        ...

    def applied(self, wrench: Wrench) -> None:
        ...

    def count(self, event: SafetyEvent) -> int:
        ...

    def drain_log(self) -> list[SafetyLogEntry]:
        ...

    def release(self, commanded: Wrench) -> Wrench:
        ...

    def report_exception(self) -> None:
        ...

    def report_silence(self, verdict: Watchdog.Verdict, share: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def start(self) -> None:
        ...

    def stop(self) -> None:
        ...

    @property
    def greatest_force(self) -> float:
        ...

    @property
    def heartbeat(self) -> int:
        ...

    @property
    def log(self) -> SafetyLog:
        ...

    @property
    def output(self) -> DeviceOutput:
        ...

    @property
    def requests(self) -> Requests:
        ...

    @property
    def slew(self) -> float:
        ...

    @property
    def state(self) -> ArmingState:
        ...

class RealtimeOptions:

    def __copy__(self) -> RealtimeOptions:
        ...

    def __deepcopy__(self, memo: dict) -> RealtimeOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, priority: typing.SupportsInt | typing.SupportsIndex=80, *, lock_memory: bool=True, flush_denormals: bool=True, cpu: typing.SupportsInt | typing.SupportsIndex=-1, stack: typing.SupportsInt | typing.SupportsIndex=262144) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def cpu(self) -> int:
        ...

    @cpu.setter
    def cpu(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def flush_denormals(self) -> bool:
        ...

    @flush_denormals.setter
    def flush_denormals(self, arg0: bool) -> None:
        ...

    @property
    def lock_memory(self) -> bool:
        ...

    @lock_memory.setter
    def lock_memory(self, arg0: bool) -> None:
        ...

    @property
    def priority(self) -> int:
        ...

    @priority.setter
    def priority(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def stack(self) -> int:
        ...

    @stack.setter
    def stack(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class LatencyHistogram:
    kBucketWidth: typing.ClassVar[float] = 1e-06
    kBuckets: typing.ClassVar[int] = 2000

    def __init__(self) -> None:
        ...

    def add(self, seconds: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def quantile(self, share: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    @property
    def buckets(self) -> numpy.typing.NDArray[numpy.uint64]:
        ...

    @property
    def count(self) -> int:
        ...

    @property
    def longer(self) -> int:
        ...

    @property
    def max(self) -> float:
        ...

    @property
    def mean(self) -> float:
        ...

    @property
    def min(self) -> float:
        ...

class PoseGate:

    class Verdict:
        __members__: typing.ClassVar[dict[str, PoseGate.Verdict]]
        accepted: typing.ClassVar[PoseGate.Verdict]
        held: typing.ClassVar[PoseGate.Verdict]
        lost: typing.ClassVar[PoseGate.Verdict]

        @typing.overload
        def __eq__(self, other: PoseGate.Verdict) -> bool:
            ...

        @typing.overload
        def __eq__(self, other: typing.Any) -> bool:
            ...

        def __getstate__(self) -> int:
            ...

        def __hash__(self) -> int:
            ...

        def __index__(self) -> int:
            ...

        def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __int__(self) -> int:
            ...

        @typing.overload
        def __ne__(self, other: PoseGate.Verdict) -> bool:
            ...

        @typing.overload
        def __ne__(self, other: typing.Any) -> bool:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __str__(self) -> str:
            ...

        @property
        def name(self) -> str:
            ...

        @property
        def value(self) -> int:
            ...

    def __init__(self, capabilities: DeviceCapabilities, options: PoseGateOptions=...) -> None:
        ...

    def check(self, reading: DeviceState, dt: typing.SupportsFloat | typing.SupportsIndex, log: SafetyLog) -> PoseGate.Verdict:
        ...

    def restart(self) -> None:
        ...

    @property
    def state(self) -> DeviceState:
        ...

class Arming:

    def __init__(self, options: ArmingOptions=...) -> None:
        ...

    def fail(self, log: SafetyLog, value: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def interrupt(self, reason: SafetyEvent, short_ramp: bool, log: SafetyLog, value: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def reset(self, log: SafetyLog) -> None:
        ...

    def start(self, log: SafetyLog) -> None:
        ...

    def stop(self) -> None:
        ...

    def tick(self, dt: typing.SupportsFloat | typing.SupportsIndex, reading_ok: bool, force: typing.SupportsFloat | typing.SupportsIndex, torque: typing.SupportsFloat | typing.SupportsIndex, log: SafetyLog) -> float:
        ...

    @property
    def state(self) -> ArmingState:
        ...

class PassivityController:

    def __init__(self, options: PassivityOptions, greatest: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def control(self, force: numpy.typing.ArrayLike, applied: numpy.typing.ArrayLike, motion: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        ...

    def restart(self) -> None:
        ...

    @property
    def stored(self) -> float:
        ...

    @property
    def taken(self) -> float:
        ...

class ThermalBudget:

    def __init__(self, peak: typing.SupportsFloat | typing.SupportsIndex, continuous: typing.SupportsFloat | typing.SupportsIndex, options: ThermalOptions=...) -> None:
        ...

    def tick(self, force: typing.SupportsFloat | typing.SupportsIndex, temperature: typing.SupportsFloat | typing.SupportsIndex, dt: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def is_limiting(self) -> bool:
        ...

    @property
    def limit(self) -> float:
        ...

class Watchdog:

    class Verdict:
        __members__: typing.ClassVar[dict[str, Watchdog.Verdict]]
        alive: typing.ClassVar[Watchdog.Verdict]
        dead: typing.ClassVar[Watchdog.Verdict]
        fading: typing.ClassVar[Watchdog.Verdict]
        late: typing.ClassVar[Watchdog.Verdict]

        @typing.overload
        def __eq__(self, other: Watchdog.Verdict) -> bool:
            ...

        @typing.overload
        def __eq__(self, other: typing.Any) -> bool:
            ...

        def __getstate__(self) -> int:
            ...

        def __hash__(self) -> int:
            ...

        def __index__(self) -> int:
            ...

        def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __int__(self) -> int:
            ...

        @typing.overload
        def __ne__(self, other: Watchdog.Verdict) -> bool:
            ...

        @typing.overload
        def __ne__(self, other: typing.Any) -> bool:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
            ...

        def __str__(self) -> str:
            ...

        @property
        def name(self) -> str:
            ...

        @property
        def value(self) -> int:
            ...

    def __init__(self, options: WatchdogOptions=...) -> None:
        ...

    def scale(self, seconds_without: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def verdict(self, seconds_without: typing.SupportsFloat | typing.SupportsIndex) -> Watchdog.Verdict:
        ...

    @property
    def options(self) -> WatchdogOptions:
        ...

class CouplingGains:

    def __copy__(self) -> CouplingGains:
        ...

    def __deepcopy__(self, memo: dict) -> CouplingGains:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, mass: typing.SupportsFloat | typing.SupportsIndex=0.05, *, stiffness: typing.SupportsFloat | typing.SupportsIndex=700.0, damping: typing.SupportsFloat | typing.SupportsIndex=12.0, largest_force: typing.SupportsFloat | typing.SupportsIndex=..., angular_stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, angular_damping: typing.SupportsFloat | typing.SupportsIndex=0.0, inertia: typing.SupportsFloat | typing.SupportsIndex=2e-05, newton_steps: typing.SupportsInt | typing.SupportsIndex=5) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def angular_damping(self) -> float:
        ...

    @angular_damping.setter
    def angular_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def angular_stiffness(self) -> float:
        ...

    @angular_stiffness.setter
    def angular_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def inertia(self) -> float:
        ...

    @inertia.setter
    def inertia(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def largest_force(self) -> float:
        ...

    @largest_force.setter
    def largest_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def mass(self) -> float:
        ...

    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def newton_steps(self) -> int:
        ...

    @newton_steps.setter
    def newton_steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class CouplingEnergy:

    def __repr__(self) -> str:
        ...

    def closure(self) -> float:
        ...

    def imbalance(self) -> float:
        ...

    @property
    def damper(self) -> float:
        ...

    @property
    def hand_work(self) -> float:
        ...

    @property
    def implicit(self) -> float:
        ...

    @property
    def kinetic(self) -> float:
        ...

    @property
    def spring(self) -> float:
        ...

    @property
    def tool_work(self) -> float:
        ...

class CoupledResult:

    @property
    def X_WH(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def changed_blocks(self) -> tuple[numpy.ndarray, bool]:
        ...

    @property
    def coupling(self) -> Wrench:
        ...

    @property
    def energy(self) -> CouplingEnergy:
        ...

    @property
    def hand(self) -> Wrench:
        ...

    @property
    def newton_steps(self) -> int:
        ...

    @property
    def parts(self) -> int:
        ...

    @property
    def removed_materials(self) -> numpy.ndarray:
        ...

    @property
    def removed_volume(self) -> float:
        ...

    @property
    def removed_voxels(self) -> numpy.ndarray:
        ...

    @property
    def status(self) -> int:
        ...

    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class VirtualCoupling:

    def __init__(self, simulation: Simulation, gains: CouplingGains=...) -> None:
        ...

    def release(self) -> None:
        ...

    def run(self, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> numpy.ndarray:
        ...

    def step(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> CoupledResult:
        ...

    @property
    def gains(self) -> CouplingGains:
        ...

    @property
    def last_result(self) -> CoupledResult:
        ...

    @property
    def simulation(self) -> Simulation:
        ...

class DeviceModel:

    def __copy__(self) -> DeviceModel:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceModel:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, name: str='', *, mass: typing.SupportsFloat | typing.SupportsIndex=0.0, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, dry_friction: typing.SupportsFloat | typing.SupportsIndex=0.0, encoder_step: typing.SupportsFloat | typing.SupportsIndex=0.0, peak_force: typing.SupportsFloat | typing.SupportsIndex=0.0, continuous_force: typing.SupportsFloat | typing.SupportsIndex=0.0, rendered_stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, rendered_damping: typing.SupportsFloat | typing.SupportsIndex=0.0, rotational_inertia: typing.SupportsFloat | typing.SupportsIndex=2e-05, rotational_damping: typing.SupportsFloat | typing.SupportsIndex=0.0002, peak_torque: typing.SupportsFloat | typing.SupportsIndex=0.0, workspace_half_width: typing.SupportsFloat | typing.SupportsIndex=0.08) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def continuous_force(self) -> float:
        ...

    @continuous_force.setter
    def continuous_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def dry_friction(self) -> float:
        ...

    @dry_friction.setter
    def dry_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def encoder_step(self) -> float:
        ...

    @encoder_step.setter
    def encoder_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def mass(self) -> float:
        ...

    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def name(self) -> str:
        ...

    @name.setter
    def name(self, arg1: str) -> None:
        ...

    @property
    def peak_force(self) -> float:
        ...

    @peak_force.setter
    def peak_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def peak_torque(self) -> float:
        ...

    @peak_torque.setter
    def peak_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rendered_damping(self) -> float:
        ...

    @rendered_damping.setter
    def rendered_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rendered_stiffness(self) -> float:
        ...

    @rendered_stiffness.setter
    def rendered_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rotational_damping(self) -> float:
        ...

    @rotational_damping.setter
    def rotational_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rotational_inertia(self) -> float:
        ...

    @rotational_inertia.setter
    def rotational_inertia(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def workspace_half_width(self) -> float:
        ...

    @workspace_half_width.setter
    def workspace_half_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class HandModel:

    def __copy__(self) -> HandModel:
        ...

    def __deepcopy__(self, memo: dict) -> HandModel:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, name: str='', *, mass: typing.SupportsFloat | typing.SupportsIndex=0.0, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, pad_stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, pad_damping: typing.SupportsFloat | typing.SupportsIndex=0.0, inertia: typing.SupportsFloat | typing.SupportsIndex=0.0, angular_damping: typing.SupportsFloat | typing.SupportsIndex=0.0, angular_stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def angular_damping(self) -> float:
        ...

    @angular_damping.setter
    def angular_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def angular_stiffness(self) -> float:
        ...

    @angular_stiffness.setter
    def angular_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def inertia(self) -> float:
        ...

    @inertia.setter
    def inertia(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def mass(self) -> float:
        ...

    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def name(self) -> str:
        ...

    @name.setter
    def name(self, arg1: str) -> None:
        ...

    @property
    def pad_damping(self) -> float:
        ...

    @pad_damping.setter
    def pad_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def pad_stiffness(self) -> float:
        ...

    @pad_stiffness.setter
    def pad_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class RunOptions:

    def __copy__(self) -> RunOptions:
        ...

    def __deepcopy__(self, memo: dict) -> RunOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, seconds: typing.SupportsFloat | typing.SupportsIndex=0.0, *, simulated_time: bool=False, stop_on_signals: bool=True, stop_on_crash: bool=False, realtime: RealtimeOptions=..., guard: GuardOptions=...) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def guard(self) -> GuardOptions:
        ...

    @guard.setter
    def guard(self, arg0: GuardOptions) -> None:
        ...

    @property
    def realtime(self) -> RealtimeOptions:
        ...

    @realtime.setter
    def realtime(self, arg0: RealtimeOptions) -> None:
        ...

    @property
    def seconds(self) -> float:
        ...

    @seconds.setter
    def seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def simulated_time(self) -> bool:
        ...

    @simulated_time.setter
    def simulated_time(self, arg0: bool) -> None:
        ...

    @property
    def stop_on_crash(self) -> bool:
        ...

    @stop_on_crash.setter
    def stop_on_crash(self, arg0: bool) -> None:
        ...

    @property
    def stop_on_signals(self) -> bool:
        ...

    @stop_on_signals.setter
    def stop_on_signals(self, arg0: bool) -> None:
        ...

class RunReport:

    def __repr__(self) -> str:
        ...

    @property
    def compute(self) -> LatencyHistogram:
        ...

    @property
    def end(self) -> str:
        ...

    @property
    def events(self) -> dict:
        ...

    @property
    def fault(self) -> DeviceFault:
        ...

    @property
    def guard(self) -> ArmingState:
        ...

    @property
    def log(self) -> list[SafetyLogEntry]:
        ...

    @property
    def missed(self) -> int:
        ...

    @property
    def ticks(self) -> int:
        ...

    @property
    def wake_up(self) -> LatencyHistogram:
        ...

    @property
    def warnings(self) -> list[str]:
        ...

class Device:

    def count(self, event: SafetyEvent) -> int:
        ...

    def drain_log(self) -> list[SafetyLogEntry]:
        ...

    def emergency_stop(self) -> None:
        ...

    def interrupt(self, reason: SafetyEvent) -> None:
        ...

    def reset_fault(self) -> None:
        ...

    def run(self, callback: collections.abc.Callable[[DeviceState], DeviceCommand], options: RunOptions=...) -> RunReport:
        ...

    def stop(self) -> None:
        ...

    @property
    def arming(self) -> ArmingState:
        ...

    @property
    def capabilities(self) -> DeviceCapabilities:
        ...

    @property
    def is_running(self) -> bool:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def output(self) -> DeviceOutput:
        ...

    @property
    def requests(self) -> Requests:
        ...

    @property
    def state(self) -> DeviceState:
        ...

class MockOptions:

    def __copy__(self) -> MockOptions:
        ...

    def __deepcopy__(self, memo: dict) -> MockOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, path: collections.abc.Callable[[float], numpy.typing.ArrayLike] | None=None, *, device: DeviceModel=..., hand: HandModel=..., rigid: bool=True, dry_friction: bool=True, encoder: bool=True, velocity_filter: typing.SupportsFloat | typing.SupportsIndex=100.0, period: typing.SupportsFloat | typing.SupportsIndex=0.001, end: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def device(self) -> DeviceModel:
        ...

    @device.setter
    def device(self, arg0: DeviceModel) -> None:
        ...

    @property
    def dry_friction(self) -> bool:
        ...

    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...

    @property
    def encoder(self) -> bool:
        ...

    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...

    @property
    def end(self) -> float:
        ...

    @end.setter
    def end(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def hand(self) -> HandModel:
        ...

    @hand.setter
    def hand(self, arg0: HandModel) -> None:
        ...

    @property
    def path(self) -> collections.abc.Callable[[typing.SupportsFloat | typing.SupportsIndex], numpy.typing.NDArray[numpy.float64]] | None:
        ...

    @path.setter
    def path(self, arg1: collections.abc.Callable[[float], numpy.typing.ArrayLike] | None) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rigid(self) -> bool:
        ...

    @rigid.setter
    def rigid(self, arg0: bool) -> None:
        ...

    @property
    def velocity_filter(self) -> float:
        ...

    @velocity_filter.setter
    def velocity_filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MockDevice(Device):

    def __init__(self, options: MockOptions, name: str='mock') -> None:
        ...

    @property
    def plant(self) -> Plant:
        ...

class PlaybackDevice(Device):

    def __init__(self, readings: collections.abc.Sequence[DeviceState], capabilities: DeviceCapabilities=..., name: str='playback') -> None:
        ...

    def __len__(self) -> int:
        ...

    def size(self) -> int:
        ...

class MoveKey:
    __members__: typing.ClassVar[dict[str, MoveKey]]
    away: typing.ClassVar[MoveKey]
    down: typing.ClassVar[MoveKey]
    left: typing.ClassVar[MoveKey]
    nearer: typing.ClassVar[MoveKey]
    right: typing.ClassVar[MoveKey]
    turn_left: typing.ClassVar[MoveKey]
    turn_right: typing.ClassVar[MoveKey]
    up: typing.ClassVar[MoveKey]

    @typing.overload
    def __eq__(self, other: MoveKey) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: MoveKey) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class MouseOptions:

    def __copy__(self) -> MouseOptions:
        ...

    def __deepcopy__(self, memo: dict) -> MouseOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, per_pixel: typing.SupportsFloat | typing.SupportsIndex=5e-05, *, per_notch: typing.SupportsFloat | typing.SupportsIndex=0.0005, key_speed: typing.SupportsFloat | typing.SupportsIndex=0.02, key_turn: typing.SupportsFloat | typing.SupportsIndex=1.0, reach: typing.SupportsFloat | typing.SupportsIndex=0.08, fastest: typing.SupportsFloat | typing.SupportsIndex=0.3, device: str='touch', hand: str='firm') -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def device(self) -> str:
        ...

    @device.setter
    def device(self, arg1: str) -> None:
        ...

    @property
    def fastest(self) -> float:
        ...

    @fastest.setter
    def fastest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def hand(self) -> str:
        ...

    @hand.setter
    def hand(self, arg1: str) -> None:
        ...

    @property
    def key_speed(self) -> float:
        ...

    @key_speed.setter
    def key_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def key_turn(self) -> float:
        ...

    @key_turn.setter
    def key_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def per_notch(self) -> float:
        ...

    @per_notch.setter
    def per_notch(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def per_pixel(self) -> float:
        ...

    @per_pixel.setter
    def per_pixel(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def reach(self) -> float:
        ...

    @reach.setter
    def reach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class MouseDevice(Device):

    def __init__(self, options: MouseOptions=...) -> None:
        ...

    def button(self, number: typing.SupportsInt | typing.SupportsIndex, pressed: bool) -> None:
        ...

    def key(self, key: MoveKey, pressed: bool) -> None:
        ...

    def pointer_moved(self, dx: typing.SupportsFloat | typing.SupportsIndex, dy: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    def wheel_turned(self, notches: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def set_point(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class WorkspaceMapOptions:

    def __copy__(self) -> WorkspaceMapOptions:
        ...

    def __deepcopy__(self, memo: dict) -> WorkspaceMapOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, X_WB: numpy.typing.ArrayLike=..., *, scale: typing.SupportsFloat | typing.SupportsIndex=1.0, force_scale: typing.SupportsFloat | typing.SupportsIndex=1.0, torque_scale: typing.SupportsFloat | typing.SupportsIndex=1.0, X_SH: numpy.typing.ArrayLike=..., orientation: bool=True) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def X_SH(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_SH.setter
    def X_SH(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def X_WB(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @X_WB.setter
    def X_WB(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def force_scale(self) -> float:
        ...

    @force_scale.setter
    def force_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def orientation(self) -> bool:
        ...

    @orientation.setter
    def orientation(self, arg0: bool) -> None:
        ...

    @property
    def scale(self) -> float:
        ...

    @scale.setter
    def scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def torque_scale(self) -> float:
        ...

    @torque_scale.setter
    def torque_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class WorkspaceMap:

    def __init__(self, options: WorkspaceMapOptions=...) -> None:
        ...

    def engage(self, X_BS: numpy.typing.ArrayLike) -> None:
        ...

    def felt_stiffness(self, world: typing.SupportsFloat | typing.SupportsIndex) -> float:
        ...

    def place(self, X_BS: numpy.typing.ArrayLike, X_WH: numpy.typing.ArrayLike) -> None:
        ...

    def release(self, X_BS: numpy.typing.ArrayLike) -> None:
        ...

    def set_scale(self, scale: typing.SupportsFloat | typing.SupportsIndex, X_BS: numpy.typing.ArrayLike) -> bool:
        ...

    def to_device(self, X_BS: numpy.typing.ArrayLike, tool: Wrench) -> Wrench:
        ...

    @typing.overload
    def to_world(self, X_BS: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @typing.overload
    def to_world(self, X_BS: numpy.typing.ArrayLike, stylus: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def engaged(self) -> bool:
        ...

    @property
    def scale(self) -> float:
        ...

class PlantOptions:

    def __copy__(self) -> PlantOptions:
        ...

    def __deepcopy__(self, memo: dict) -> PlantOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, period: typing.SupportsFloat | typing.SupportsIndex=0.001, *, fine_step: typing.SupportsFloat | typing.SupportsIndex=2e-05, dry_friction: bool=False, encoder: bool=False, rotation: bool=False) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def dry_friction(self) -> bool:
        ...

    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...

    @property
    def encoder(self) -> bool:
        ...

    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...

    @property
    def fine_step(self) -> float:
        ...

    @fine_step.setter
    def fine_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rotation(self) -> bool:
        ...

    @rotation.setter
    def rotation(self, arg0: bool) -> None:
        ...

class Plant:

    def __init__(self, device: DeviceModel, hand: HandModel, options: PlantOptions=...) -> None:
        ...

    def advance(self, wrench: Wrench) -> None:
        ...

    def creep(self, wrench: Wrench) -> None:
        ...

    def reset(self, X_BS: numpy.typing.ArrayLike) -> None:
        ...

    def set_target(self, X_BS: numpy.typing.ArrayLike) -> None:
        ...

    def set_velocity(self, velocity: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def device(self) -> DeviceModel:
        ...

    @property
    def hand(self) -> HandModel:
        ...

    @property
    def kinetic_energy(self) -> float:
        ...

    @property
    def measured_pose(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def options(self) -> PlantOptions:
        ...

    @property
    def pose(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def target(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

class LinearWall:

    def __call__(self, state: DeviceState) -> Wrench:
        ...

    def __init__(self, stiffness: typing.SupportsFloat | typing.SupportsIndex=0.0, damping: typing.SupportsFloat | typing.SupportsIndex=0.0, filter: typing.SupportsFloat | typing.SupportsIndex=0.0, one_sided: bool=True, height: typing.SupportsFloat | typing.SupportsIndex=0.0, period: typing.SupportsFloat | typing.SupportsIndex=0.001) -> None:
        ...

    @property
    def damping(self) -> float:
        ...

    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def filter(self) -> float:
        ...

    @filter.setter
    def filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def height(self) -> float:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def one_sided(self) -> bool:
        ...

    @one_sided.setter
    def one_sided(self, arg0: bool) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def stiffness(self) -> float:
        ...

    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ClosedLoopConfig:
    device: DeviceModel
    hand: HandModel

    def __copy__(self) -> ClosedLoopConfig:
        ...

    def __deepcopy__(self, memo: dict) -> ClosedLoopConfig:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, device: DeviceModel=..., *, hand: HandModel=..., delay: typing.SupportsInt | typing.SupportsIndex=0, period: typing.SupportsFloat | typing.SupportsIndex=0.001, dry_friction: bool=False, encoder: bool=False, saturation: bool=False, rotation: bool=False, velocity_filter: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def delay(self) -> int:
        ...

    @delay.setter
    def delay(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def dry_friction(self) -> bool:
        ...

    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...

    @property
    def encoder(self) -> bool:
        ...

    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...

    @property
    def period(self) -> float:
        ...

    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def rotation(self) -> bool:
        ...

    @rotation.setter
    def rotation(self, arg0: bool) -> None:
        ...

    @property
    def saturation(self) -> bool:
        ...

    @saturation.setter
    def saturation(self, arg0: bool) -> None:
        ...

    @property
    def velocity_filter(self) -> float:
        ...

    @velocity_filter.setter
    def velocity_filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ClosedLoop:

    def __init__(self, config: ClosedLoopConfig) -> None:
        ...

    def miss_tick(self, scale: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
        ...

    def read(self) -> DeviceState:
        ...

    def reset(self, X_BS: numpy.typing.ArrayLike) -> None:
        ...

    def tick(self, model: collections.abc.Callable[[DeviceState], Wrench]) -> None:
        ...

    @typing.overload
    def write(self, wrench: Wrench) -> None:
        ...

    @typing.overload
    def write(self, wrench: Wrench, observer: collections.abc.Callable[[Plant, Wrench], None]) -> None:
        ...

    @property
    def applied(self) -> Wrench:
        ...

    @property
    def config(self) -> ClosedLoopConfig:
        ...

    @property
    def device_dissipation(self) -> float:
        ...

    @property
    def generated_energy(self) -> float:
        ...

    @property
    def plant(self) -> Plant:
        ...

class StabilitySearch:

    def __copy__(self) -> StabilitySearch:
        ...

    def __deepcopy__(self, memo: dict) -> StabilitySearch:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, start: numpy.typing.ArrayLike=..., *, target: numpy.typing.ArrayLike=..., settle: typing.SupportsFloat | typing.SupportsIndex=0.0, nudge: typing.SupportsFloat | typing.SupportsIndex=0.0001, window: typing.SupportsFloat | typing.SupportsIndex=1.0, windows: typing.SupportsInt | typing.SupportsIndex=4, low: typing.SupportsFloat | typing.SupportsIndex=5.0, high: typing.SupportsFloat | typing.SupportsIndex=1000000.0, coarse_factor: typing.SupportsFloat | typing.SupportsIndex=1.15, tolerance: typing.SupportsFloat | typing.SupportsIndex=0.001, forgotten: typing.SupportsFloat | typing.SupportsIndex=1e-09) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def coarse_factor(self) -> float:
        ...

    @coarse_factor.setter
    def coarse_factor(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def forgotten(self) -> float:
        ...

    @forgotten.setter
    def forgotten(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def high(self) -> float:
        ...

    @high.setter
    def high(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def low(self) -> float:
        ...

    @low.setter
    def low(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def nudge(self) -> float:
        ...

    @nudge.setter
    def nudge(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def settle(self) -> float:
        ...

    @settle.setter
    def settle(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def start(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @start.setter
    def start(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def target(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @target.setter
    def target(self, arg0: numpy.typing.ArrayLike) -> None:
        ...

    @property
    def tolerance(self) -> float:
        ...

    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def window(self) -> float:
        ...

    @window.setter
    def window(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def windows(self) -> int:
        ...

    @windows.setter
    def windows(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class Bounce:

    def __repr__(self) -> str:
        ...

    @property
    def generated_energy(self) -> float:
        ...

    @property
    def mean_restitution(self) -> float:
        ...

    @property
    def peak_force(self) -> float:
        ...

    @property
    def penetration(self) -> float:
        ...

    @property
    def restitution(self) -> float:
        ...

class BounceTest:

    def __copy__(self) -> BounceTest:
        ...

    def __deepcopy__(self, memo: dict) -> BounceTest:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, height: typing.SupportsFloat | typing.SupportsIndex=0.0, speed: typing.SupportsFloat | typing.SupportsIndex=0.1, phases: typing.SupportsInt | typing.SupportsIndex=40, time_limit: typing.SupportsFloat | typing.SupportsIndex=0.4) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def height(self) -> float:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def phases(self) -> int:
        ...

    @phases.setter
    def phases(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def speed(self) -> float:
        ...

    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def time_limit(self) -> float:
        ...

    @time_limit.setter
    def time_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class Buzz:

    def __repr__(self) -> str:
        ...

    def buzzes(self) -> bool:
        ...

    @property
    def force_peak_to_peak(self) -> float:
        ...

    @property
    def frequency(self) -> float:
        ...

    @property
    def generated_power(self) -> float:
        ...

    @property
    def greatest_force(self) -> float:
        ...

    @property
    def position_rms(self) -> float:
        ...

class PressTest:

    def __copy__(self) -> PressTest:
        ...

    def __deepcopy__(self, memo: dict) -> PressTest:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, height: typing.SupportsFloat | typing.SupportsIndex=0.0, *, depth: typing.SupportsFloat | typing.SupportsIndex=0.01, speed: typing.SupportsFloat | typing.SupportsIndex=0.05, approach: typing.SupportsFloat | typing.SupportsIndex=0.0, seconds: typing.SupportsFloat | typing.SupportsIndex=4.0, measured: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def approach(self) -> float:
        ...

    @approach.setter
    def approach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def depth(self) -> float:
        ...

    @depth.setter
    def depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def height(self) -> float:
        ...

    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def measured(self) -> float:
        ...

    @measured.setter
    def measured(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def seconds(self) -> float:
        ...

    @seconds.setter
    def seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def speed(self) -> float:
        ...

    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class ForceModel:

    def __call__(self, state: DeviceState) -> Wrench:
        ...

class ModelFactory:

    def __call__(self, stiffness: typing.SupportsFloat | typing.SupportsIndex) -> ForceModel:
        ...

class ContactBench:

    def __copy__(self) -> ContactBench:
        ...

    def __deepcopy__(self, memo: dict) -> ContactBench:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex=0.001, voxel_size: typing.SupportsFloat | typing.SupportsIndex=0.0001, coupling: CouplingGains | None=None) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def coupling(self) -> CouplingGains | None:
        ...

    @coupling.setter
    def coupling(self, arg0: CouplingGains | None) -> None:
        ...

    @property
    def radius(self) -> float:
        ...

    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def voxel_size(self) -> float:
        ...

    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

class InjectedFault:
    __members__: typing.ClassVar[dict[str, InjectedFault]]
    buried_5mm: typing.ClassVar[InjectedFault]
    calibration_jump: typing.ClassVar[InjectedFault]
    emergency_stop: typing.ClassVar[InjectedFault]
    force_x1000: typing.ClassVar[InjectedFault]
    frozen_pose: typing.ClassVar[InjectedFault]
    jump_30mm: typing.ClassVar[InjectedFault]
    missed_1: typing.ClassVar[InjectedFault]
    missed_100: typing.ClassVar[InjectedFault]
    missed_20: typing.ClassVar[InjectedFault]
    missed_5: typing.ClassVar[InjectedFault]
    nan_force: typing.ClassVar[InjectedFault]
    nan_pose: typing.ClassVar[InjectedFault]
    reclutch: typing.ClassVar[InjectedFault]
    stale_reading: typing.ClassVar[InjectedFault]
    units_x1000: typing.ClassVar[InjectedFault]
    unplugged: typing.ClassVar[InjectedFault]

    @typing.overload
    def __eq__(self, other: InjectedFault) -> bool:
        ...

    @typing.overload
    def __eq__(self, other: typing.Any) -> bool:
        ...

    def __getstate__(self) -> int:
        ...

    def __hash__(self) -> int:
        ...

    def __index__(self) -> int:
        ...

    def __init__(self, value: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __int__(self) -> int:
        ...

    @typing.overload
    def __ne__(self, other: InjectedFault) -> bool:
        ...

    @typing.overload
    def __ne__(self, other: typing.Any) -> bool:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, state: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    def __str__(self) -> str:
        ...

    @property
    def name(self) -> str:
        ...

    @property
    def value(self) -> int:
        ...

class FaultResponse:

    def __repr__(self) -> str:
        ...

    @property
    def end(self) -> ArmingState:
        ...

    @property
    def greatest_force(self) -> float:
        ...

    @property
    def greatest_growth(self) -> float:
        ...

    @property
    def oldest_force(self) -> float:
        ...

    @property
    def time_to_zero(self) -> float:
        ...

class PlaybackRange:

    def __copy__(self) -> PlaybackRange:
        ...

    def __deepcopy__(self, memo: dict) -> PlaybackRange:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, first: typing.SupportsInt | typing.SupportsIndex=0, count: typing.SupportsInt | typing.SupportsIndex=18446744073709551615) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def count(self) -> int:
        ...

    @count.setter
    def count(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def first(self) -> int:
        ...

    @first.setter
    def first(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class DeviceTick:

    def __copy__(self) -> DeviceTick:
        ...

    def __deepcopy__(self, memo: dict) -> DeviceTick:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, state: DeviceState=..., output: DeviceOutput=..., arming: ArmingState=ArmingState.off) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def arming(self) -> ArmingState:
        ...

    @arming.setter
    def arming(self, arg0: ArmingState) -> None:
        ...

    @property
    def output(self) -> DeviceOutput:
        ...

    @output.setter
    def output(self, arg0: DeviceOutput) -> None:
        ...

    @property
    def state(self) -> DeviceState:
        ...

    @state.setter
    def state(self, arg0: DeviceState) -> None:
        ...

class RecorderOptions:

    def __copy__(self) -> RecorderOptions:
        ...

    def __deepcopy__(self, memo: dict) -> RecorderOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, device: str='', *, note: str='', capabilities: DeviceCapabilities=..., steps: typing.SupportsInt | typing.SupportsIndex=8192, flush_period: typing.SupportsFloat | typing.SupportsIndex=0.2, wait_when_full: bool=False, workpiece_file: str='') -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def capabilities(self) -> DeviceCapabilities:
        ...

    @capabilities.setter
    def capabilities(self, arg0: DeviceCapabilities) -> None:
        ...

    @property
    def device(self) -> str:
        ...

    @device.setter
    def device(self, arg0: str) -> None:
        ...

    @property
    def flush_period(self) -> float:
        ...

    @flush_period.setter
    def flush_period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...

    @property
    def note(self) -> str:
        ...

    @note.setter
    def note(self, arg0: str) -> None:
        ...

    @property
    def steps(self) -> int:
        ...

    @steps.setter
    def steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def wait_when_full(self) -> bool:
        ...

    @wait_when_full.setter
    def wait_when_full(self, arg0: bool) -> None:
        ...

    @property
    def workpiece_file(self) -> str:
        ...

    @workpiece_file.setter
    def workpiece_file(self, arg1: str) -> None:
        ...

class Recorder:

    def __enter__(self) -> typing.Any:
        ...

    def __exit__(self, type: typing.Any, value: typing.Any, traceback: typing.Any) -> None:
        ...

    def __init__(self, path: os.PathLike | str | bytes, simulation: Simulation, options: RecorderOptions=..., driven_by: typing.Any=None) -> None:
        ...

    def close(self) -> None:
        ...

    def run(self, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> numpy.ndarray:
        ...

    def set_device_tick(self, tick: DeviceTick) -> None:
        ...

    def step(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex, device: DeviceTick | None=None) -> StepResult:
        ...

    @property
    def failed(self) -> bool:
        ...

    @property
    def lost(self) -> int:
        ...

    @property
    def recorded(self) -> int:
        ...

class RecordingInfo:

    def __repr__(self) -> str:
        ...

    @property
    def begun(self) -> str:
        ...

    @property
    def closed(self) -> bool:
        ...

    @property
    def commit(self) -> str:
        ...

    @property
    def compiler(self) -> str:
        ...

    @property
    def cpu(self) -> str:
        ...

    @property
    def device(self) -> str:
        ...

    @property
    def format(self) -> int:
        ...

    @property
    def lost(self) -> int:
        ...

    @property
    def note(self) -> str:
        ...

    @property
    def remarks(self) -> list[str]:
        ...

    @property
    def version(self) -> str:
        ...

    @property
    def workpiece_hash_at_end(self) -> int | None:
        ...

class RecordedEffects:

    def __repr__(self) -> str:
        ...

    @property
    def effects(self) -> Effects:
        ...

    @property
    def first_step(self) -> int:
        ...

class Recording:

    def __len__(self) -> int:
        ...

    def read(self, first: typing.SupportsInt | typing.SupportsIndex=0, count: typing.SupportsInt | typing.SupportsIndex | None=None) -> dict:
        ...

    def workpiece(self) -> Workpiece:
        ...

    @property
    def capabilities(self) -> DeviceCapabilities:
        ...

    @property
    def config(self) -> SimulationConfig:
        ...

    @property
    def default_law(self) -> bool:
        ...

    @property
    def effects(self) -> list[RecordedEffects]:
        ...

    @property
    def has_device(self) -> bool:
        ...

    @property
    def info(self) -> RecordingInfo:
        ...

    @property
    def path(self) -> pathlib.Path:
        ...

    @property
    def tool(self) -> Tool:
        ...

class ReplayDifference:

    def __repr__(self) -> str:
        ...

    @property
    def column(self) -> str:
        ...

    @property
    def element(self) -> int:
        ...

    @property
    def recorded(self) -> float:
        ...

    @property
    def replayed(self) -> float:
        ...

    @property
    def step(self) -> int:
        ...

class ReplayReport:

    def __repr__(self) -> str:
        ...

    @property
    def first_difference(self) -> ReplayDifference | None:
        ...

    @property
    def identical(self) -> bool:
        ...

    @property
    def largest_force_difference(self) -> float:
        ...

    @property
    def left_out(self) -> int:
        ...

    @property
    def steps(self) -> int:
        ...

    @property
    def workpiece_hash(self) -> int:
        ...

class commands:

    class SetSpindleSpeed:

        def __copy__(self) -> commands.SetSpindleSpeed:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetSpindleSpeed:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, speed: typing.SupportsFloat | typing.SupportsIndex=0.0) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def speed(self) -> float:
            ...

        @speed.setter
        def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

    class OpenClutch:

        def __init__(self) -> None:
            ...

        def __repr__(self) -> str:
            ...

    class CloseClutch:

        def __init__(self) -> None:
            ...

        def __repr__(self) -> str:
            ...

    class SetScale:

        def __copy__(self) -> commands.SetScale:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetScale:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, scale: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def scale(self) -> float:
            ...

        @scale.setter
        def scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...

    class SetUndoMark:

        def __init__(self) -> None:
            ...

        def __repr__(self) -> str:
            ...

    class Undo:

        def __init__(self) -> None:
            ...

        def __repr__(self) -> str:
            ...

    class Redo:

        def __init__(self) -> None:
            ...

        def __repr__(self) -> str:
            ...

    class SetFriction:

        def __copy__(self) -> commands.SetFriction:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetFriction:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, friction: DryFriction | None=None) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def friction(self) -> DryFriction | None:
            ...

        @friction.setter
        def friction(self, arg0: DryFriction | None) -> None:
            ...

    class SetEffects:
        effects: Effects

        def __copy__(self) -> commands.SetEffects:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetEffects:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, effects: Effects=...) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

    class SetForceMask:
        enabled: AxisMask

        def __copy__(self) -> commands.SetForceMask:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetForceMask:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, enabled: AxisMask=...) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

    class SetRemoval:

        def __copy__(self) -> commands.SetRemoval:
            ...

        def __deepcopy__(self, memo: dict) -> commands.SetRemoval:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, removal: RemovalLaw=RemovalLaw.none) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def removal(self) -> RemovalLaw:
            ...

        @removal.setter
        def removal(self, arg1: RemovalLaw) -> None:
            ...

    class HoldForce:

        def __copy__(self) -> commands.HoldForce:
            ...

        def __deepcopy__(self, memo: dict) -> commands.HoldForce:
            ...

        def __getstate__(self) -> tuple:
            ...

        def __init__(self, hold: bool=True) -> None:
            ...

        def __repr__(self) -> str:
            ...

        def __setstate__(self, arg0: tuple) -> None:
            ...

        @property
        def hold(self) -> bool:
            ...

        @hold.setter
        def hold(self, arg0: bool) -> None:
            ...

    class SetTool:

        def __init__(self, tool: Tool, voxel_size: typing.SupportsFloat | typing.SupportsIndex, config: SimulationConfig) -> None:
            ...

    class SetMaterials:

        def __init__(self, materials: MaterialTable, config: SimulationConfig) -> None:
            ...

    class ExchangeWorkpiece:

        def __init__(self, workpiece: Workpiece, tool: Tool, config: SimulationConfig) -> None:
            ...

        @property
        def bounds(self) -> IndexBox:
            ...

class ToolSnapshot:

    def __repr__(self) -> str:
        ...

    @property
    def contact_depth(self) -> float:
        ...

    @property
    def contact_voxels(self) -> int:
        ...

    @property
    def force(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def force_held(self) -> bool:
        ...

    @property
    def redo_marks(self) -> int:
        ...

    @property
    def redoing(self) -> bool:
        ...

    @property
    def removed_volume(self) -> float:
        ...

    @property
    def seen(self) -> int:
        ...

    @property
    def spindle_speed(self) -> float:
        ...

    @property
    def status(self) -> int:
        ...

    @property
    def steps(self) -> int:
        ...

    @property
    def torque(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def undo_marks(self) -> int:
        ...

    @property
    def undoing(self) -> bool:
        ...

    @property
    def workpiece(self) -> int:
        ...

class LoopSnapshot:

    def __repr__(self) -> str:
        ...

    @property
    def X_WT(self) -> numpy.typing.NDArray[numpy.float64]:
        ...

    @property
    def arming(self) -> ArmingState:
        ...

    @property
    def blocks_outside(self) -> int:
        ...

    @property
    def blocks_waiting(self) -> int:
        ...

    @property
    def commands_dropped(self) -> int:
        ...

    @property
    def commands_refused(self) -> int:
        ...

    @property
    def device(self) -> DeviceState:
        ...

    @property
    def output(self) -> DeviceOutput:
        ...

    @property
    def tick(self) -> int:
        ...

    @property
    def tool(self) -> ToolSnapshot:
        ...

class ChangedBlock:

    @property
    def fill(self) -> numpy.ndarray:
        ...

    @property
    def material(self) -> numpy.ndarray:
        ...

    @property
    def origin(self) -> typing.Annotated[list[int], 'FixedSize(3)']:
        ...

    @property
    def version(self) -> int:
        ...

    @property
    def workpiece(self) -> int:
        ...

class SimulationModelOptions:

    def __copy__(self) -> SimulationModelOptions:
        ...

    def __deepcopy__(self, memo: dict) -> SimulationModelOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, map: WorkspaceMapOptions=..., *, coupling: CouplingGains | None=None, spindle_needs_force: bool=True, undo_blocks: typing.SupportsInt | typing.SupportsIndex=0, undo_blocks_per_tick: typing.SupportsInt | typing.SupportsIndex=64) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def coupling(self) -> CouplingGains | None:
        ...

    @coupling.setter
    def coupling(self, arg0: CouplingGains | None) -> None:
        ...

    @property
    def map(self) -> WorkspaceMapOptions:
        ...

    @map.setter
    def map(self, arg0: WorkspaceMapOptions) -> None:
        ...

    @property
    def spindle_needs_force(self) -> bool:
        ...

    @spindle_needs_force.setter
    def spindle_needs_force(self, arg0: bool) -> None:
        ...

    @property
    def undo_blocks(self) -> int:
        ...

    @undo_blocks.setter
    def undo_blocks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def undo_blocks_per_tick(self) -> int:
        ...

    @undo_blocks_per_tick.setter
    def undo_blocks_per_tick(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

class SimulationModel:

    def __init__(self, simulation: Simulation, device: Device, options: SimulationModelOptions=...) -> None:
        ...

    def prepare_materials(self, materials: MaterialTable) -> commands.SetMaterials:
        ...

    def prepare_tool(self, tool: Tool) -> commands.SetTool:
        ...

    def prepare_workpiece(self, workpiece: Workpiece, tool: Tool) -> commands.ExchangeWorkpiece:
        ...

    @property
    def region(self) -> IndexBox:
        ...

class RealtimeLoopOptions:
    run: RunOptions

    def __copy__(self) -> RealtimeLoopOptions:
        ...

    def __deepcopy__(self, memo: dict) -> RealtimeLoopOptions:
        ...

    def __getstate__(self) -> tuple:
        ...

    def __init__(self, run: RunOptions=..., region: IndexBox=..., block_capacity: typing.SupportsInt | typing.SupportsIndex=256, blocks_per_tick: typing.SupportsInt | typing.SupportsIndex=16) -> None:
        ...

    def __repr__(self) -> str:
        ...

    def __setstate__(self, arg0: tuple) -> None:
        ...

    @property
    def block_capacity(self) -> int:
        ...

    @block_capacity.setter
    def block_capacity(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def blocks_per_tick(self) -> int:
        ...

    @blocks_per_tick.setter
    def blocks_per_tick(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...

    @property
    def region(self) -> IndexBox:
        ...

    @region.setter
    def region(self, arg0: IndexBox) -> None:
        ...

class RealtimeLoop:
    kCommands: typing.ClassVar[int] = 256

    def __init__(self, model: typing.Any, options: RealtimeLoopOptions=...) -> None:
        ...

    def latest(self) -> LoopSnapshot:
        ...

    def receive(self) -> ChangedBlock | None:
        ...

    def send(self, command: typing.Any) -> bool:
        ...

    def start(self) -> None:
        ...

    def stop(self) -> RunReport:
        ...

    def wait(self) -> RunReport:
        ...

    @property
    def is_running(self) -> bool:
        ...

    @property
    def requests(self) -> Requests:
        ...

def _loop_in_cpp(simulation: Simulation, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> float:
    ...

def advance(from_: numpy.typing.ArrayLike, twist: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    ...

def axial_cut_force(constants: Calibration, radius: typing.SupportsFloat | typing.SupportsIndex, spindle_speed: typing.SupportsFloat | typing.SupportsIndex, feed_speed: typing.SupportsFloat | typing.SupportsIndex) -> AxialCutForce:
    ...

@typing.overload
def box_around(volume: LabelVolume, labels: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex]=[], margin: typing.SupportsFloat | typing.SupportsIndex=0.0) -> IndexBox:
    ...

@typing.overload
def box_around(volume: GreyVolume, threshold: typing.SupportsFloat | typing.SupportsIndex, margin: typing.SupportsFloat | typing.SupportsIndex=0.0) -> IndexBox:
    ...

@typing.overload
def box_of_volume(volume: GreyVolume) -> Box:
    ...

@typing.overload
def box_of_volume(volume: LabelVolume) -> Box:
    ...

def build_block(box: Box, voxel_size: typing.SupportsFloat | typing.SupportsIndex, material: Material) -> Workpiece:
    ...

def build_body(body: BodyDescription, voxel_size: typing.SupportsFloat | typing.SupportsIndex, materials: MaterialTable, subsamples: typing.SupportsInt | typing.SupportsIndex=8) -> Workpiece:
    ...

@typing.overload
def build_from_grey(volume: GreyVolume, ranges: collections.abc.Sequence[GreyRange], options: VolumeBuildOptions=...) -> Workpiece:
    ...

@typing.overload
def build_from_grey(volume: GreyVolume, grade: Grade, options: VolumeBuildOptions=...) -> Workpiece:
    ...

def build_from_labels(volume: LabelVolume, materials: collections.abc.Sequence[LabelMaterial], options: VolumeBuildOptions=..., unclaimed: UnclaimedLabels=UnclaimedLabels.refuse) -> Workpiece:
    ...

def build_from_mesh(mesh: TriangleMesh, material: Material, options: MeshImport=...) -> Workpiece:
    ...

def build_from_shells(shells: collections.abc.Sequence[MeshShell], materials: MaterialTable, options: MeshImport=...) -> Workpiece:
    ...

def build_info() -> BuildInfo:
    ...

def build_layered_slab(box: Box, voxel_size: typing.SupportsFloat | typing.SupportsIndex, layers: collections.abc.Sequence[Layer]) -> Workpiece:
    ...

def build_molar(voxel_size: typing.SupportsFloat | typing.SupportsIndex, parameters: MolarParameters=...) -> Workpiece:
    ...

def build_sphere(center: numpy.typing.ArrayLike, radius: typing.SupportsFloat | typing.SupportsIndex, voxel_size: typing.SupportsFloat | typing.SupportsIndex, material: Material) -> Workpiece:
    ...

def calibrate(tests: collections.abc.Sequence[DrillingTest]) -> Calibration:
    ...

def capabilities(model: DeviceModel) -> DeviceCapabilities:
    ...

def check_input(config: SimulationConfig, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> int:
    ...

def christmas_tree_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, tiers: typing.SupportsInt | typing.SupportsIndex) -> ToolHead:
    ...

def close_gaps(volume: LabelVolume, radius: typing.SupportsFloat | typing.SupportsIndex, label: typing.SupportsInt | typing.SupportsIndex) -> LabelVolume:
    ...

def colored(surface: WorkpieceSurface, materials: MaterialTable) -> ColoredMesh:
    ...

def contact_models(bench: ContactBench) -> ModelFactory:
    ...

def contact_point(head: ToolHead, wrench_T: Wrench) -> numpy.typing.NDArray[numpy.float64]:
    ...

def count_from(volume: GreyVolume, threshold: typing.SupportsFloat | typing.SupportsIndex) -> int:
    ...

@typing.overload
def count_labels(volume: LabelVolume) -> dict[int, int]:
    ...

@typing.overload
def count_labels(volume: GreyVolume, most: typing.SupportsInt | typing.SupportsIndex=64) -> dict[int, int]:
    ...

def coupling_gains(device: DeviceCapabilities, mass: typing.SupportsFloat | typing.SupportsIndex=0.05) -> CouplingGains:
    ...

@typing.overload
def crop_to_box(volume: GreyVolume, box: Box) -> GreyVolume:
    ...

@typing.overload
def crop_to_box(volume: LabelVolume, box: Box) -> LabelVolume:
    ...

@typing.overload
def crop_to_samples(volume: GreyVolume, samples: IndexBox) -> GreyVolume:
    ...

@typing.overload
def crop_to_samples(volume: LabelVolume, samples: IndexBox) -> LabelVolume:
    ...

def cylinder_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

@typing.overload
def describe(fault: DeviceFault) -> str:
    ...

@typing.overload
def describe(changes: typing.SupportsInt | typing.SupportsIndex) -> str:
    ...

@typing.overload
def describe(entry: SafetyLogEntry) -> str:
    ...

def describe_molar(parameters: MolarParameters=...) -> BodyDescription:
    ...

def device_drivers() -> list:
    ...

def device_model(name: str) -> DeviceModel:
    ...

def device_models() -> list[DeviceModel]:
    ...

@typing.overload
def extract_surface(workpiece: Workpiece) -> WorkpieceSurface:
    ...

@typing.overload
def extract_surface(workpiece: Workpiece, material: typing.SupportsInt | typing.SupportsIndex) -> TriangleMesh:
    ...

def fill_cavities(volume: LabelVolume, label: typing.SupportsInt | typing.SupportsIndex) -> LabelVolume:
    ...

def filtered(filter: DeltaFilter, previous: numpy.typing.ArrayLike, calculated: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

def find_preset(name: str) -> Material:
    ...

def find_scene(name: str) -> Scene:
    ...

def flame_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex, widest_height: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def gravity_wrench(gravity: Gravity, R_WH: numpy.typing.ArrayLike) -> Wrench:
    ...

def grey_range(volume: GreyVolume) -> typing.Annotated[list[float], 'FixedSize(2)']:
    ...

def growth_limited(previous: numpy.typing.ArrayLike, target: numpy.typing.ArrayLike, longest_growth: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    ...

def hand_model(name: str) -> HandModel:
    ...

def hand_models() -> list[HandModel]:
    ...

@typing.overload
def has_any(status: typing.SupportsInt | typing.SupportsIndex, bits: StepStatus) -> bool:
    ...

@typing.overload
def has_any(changes: typing.SupportsInt | typing.SupportsIndex, bits: OutputChange) -> bool:
    ...

def head_in_handle(handle: RayHandle | LHandle) -> numpy.typing.NDArray[numpy.float64]:
    ...

def injected_faults() -> list[InjectedFault]:
    ...

def inverted_cone_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def is_rotation(m: numpy.typing.ArrayLike, tolerance: typing.SupportsFloat | typing.SupportsIndex) -> bool:
    ...

def is_stable(config: ClosedLoopConfig, factory: ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, search: StabilitySearch=...) -> bool:
    ...

@typing.overload
def keep_largest_component(volume: LabelVolume) -> LabelVolume:
    ...

@typing.overload
def keep_largest_component(volume: GreyVolume, threshold: typing.SupportsFloat | typing.SupportsIndex) -> GreyVolume:
    ...

def label_range(volume: GreyVolume, from_: typing.SupportsFloat | typing.SupportsIndex, to: typing.SupportsFloat | typing.SupportsIndex, label: typing.SupportsInt | typing.SupportsIndex=1) -> LabelVolume:
    ...

def largest_contact_stiffness(head: ToolHead) -> float:
    ...

def largest_stable_stiffness(config: ClosedLoopConfig, factory: ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], search: StabilitySearch=...) -> float:
    ...

def least_force_growth(stiffness: typing.SupportsFloat | typing.SupportsIndex, speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
    ...

@typing.overload
def load_vdb(path: os.PathLike | str | bytes) -> Workpiece:
    ...

@typing.overload
def load_vdb(path: os.PathLike | str | bytes, options: VdbImport) -> Workpiece:
    ...

def masked(mask: AxisMask, wrench: Wrench) -> Wrench:
    ...

def material_color(name: str) -> Color:
    ...

def materials_of(grade: Grade) -> list[Material]:
    ...

def measure_bounce(config: ClosedLoopConfig, factory: ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, test: BounceTest=...) -> Bounce:
    ...

def measure_buzz(config: ClosedLoopConfig, factory: ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, test: PressTest=...) -> Buzz:
    ...

def measure_fault_response(config: ClosedLoopConfig, factory: ModelFactory | collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, options: GuardOptions, fault: InjectedFault, height: typing.SupportsFloat | typing.SupportsIndex=0.0) -> FaultResponse:
    ...

def mesh_of_revolution(profile: Profile, sides: typing.SupportsInt | typing.SupportsIndex) -> TriangleMesh:
    ...

def most_blocks(head: ToolHead, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> int:
    ...

def most_voxels(head: ToolHead, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> int:
    ...

def needle_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def obeys_the_rules(response: FaultResponse, guard: SafetyGuard, period: typing.SupportsFloat | typing.SupportsIndex) -> bool:
    ...

def open_device(name: str) -> Device:
    ...

def open_mock(text: str) -> MockDevice:
    ...

def open_playback(recording: os.PathLike | str | bytes, range: PlaybackRange=...) -> PlaybackDevice:
    ...

def orthonormalized(m: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

def output_limits(device: DeviceCapabilities, fastest_contact: typing.SupportsFloat | typing.SupportsIndex=0.5) -> OutputLimits:
    ...

def pear_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def preset_color(name: str) -> Color:
    ...

def preset_names() -> list[str]:
    ...

def pressed_search(bench: ContactBench) -> StabilitySearch:
    ...

def profile_from_mesh(mesh: TriangleMesh, towards_shank: numpy.typing.ArrayLike=..., tolerance: typing.SupportsFloat | typing.SupportsIndex=0.02) -> RecognizedProfile:
    ...

def read_color_slices(folder: os.PathLike | str | bytes, label_of: dict, spacing: numpy.typing.ArrayLike) -> LabelVolume:
    ...

def read_grey_volume(path: os.PathLike | str | bytes, options: VolumeReadOptions=...) -> GreyVolume:
    ...

def read_invesalius_project(path: os.PathLike | str | bytes) -> GreyVolume:
    ...

def read_label_volume(path: os.PathLike | str | bytes, options: VolumeReadOptions=...) -> LabelVolume:
    ...

def read_mesh(path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> list[NamedMesh]:
    ...

def read_raw_grey_volume(path: os.PathLike | str | bytes, layout: RawLayout) -> GreyVolume:
    ...

def read_raw_label_volume(path: os.PathLike | str | bytes, layout: RawLayout) -> LabelVolume:
    ...

def read_recording(path: os.PathLike | str | bytes) -> Recording:
    ...

def replay(recording: Recording, law: ForceLaw | None=None, progress: collections.abc.Callable[[int], None] | None=None) -> ReplayReport:
    ...

@typing.overload
def resample(volume: GreyVolume, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> GreyVolume:
    ...

@typing.overload
def resample(volume: LabelVolume, voxel_size: typing.SupportsFloat | typing.SupportsIndex, interpolation: LabelInterpolation=LabelInterpolation.nearest) -> LabelVolume:
    ...

def rotation_from_vector(v: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

def round_end_cylinder_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def round_end_tapered_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def round_head(diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def saturated(v: numpy.typing.ArrayLike, longest: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    ...

def save_vdb(workpiece: Workpiece, path: os.PathLike | str | bytes) -> None:
    ...

def scenes() -> list[Scene]:
    ...

def scripted_path(name: str) -> collections.abc.Callable[[typing.SupportsFloat | typing.SupportsIndex], numpy.typing.NDArray[numpy.float64]]:
    ...

def simulation_of(recording: Recording, law: ForceLaw | None=None) -> Simulation:
    ...

def standing_share(spin: typing.SupportsFloat | typing.SupportsIndex, radius: typing.SupportsFloat | typing.SupportsIndex) -> float:
    ...

def stiffness_for_accuracy(head: ToolHead, material: Material, spindle_speed: typing.SupportsFloat | typing.SupportsIndex, feed_speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
    ...

def stiffness_for_device(head: ToolHead, device_stiffness: typing.SupportsFloat | typing.SupportsIndex) -> float:
    ...

def tapered_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

def thesis_handle_torque(handle: RayHandle | LHandle, force_H: numpy.typing.ArrayLike, spin: typing.SupportsFloat | typing.SupportsIndex, zeta: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    ...

def thesis_mode(mode: ThesisMode | None=None) -> SimulationConfig:
    ...

@typing.overload
def transport(wrench_P: Wrench, p_QP: numpy.typing.ArrayLike) -> Wrench:
    ...

@typing.overload
def transport(twist_P: numpy.typing.ArrayLike, p_PQ: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

@typing.overload
def transport(stiffness_T: numpy.typing.ArrayLike, R_WT: numpy.typing.ArrayLike, p_HoTo_W: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

def twist_between(from_: numpy.typing.ArrayLike, to: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    ...

def twist_drill_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, point_angle: typing.SupportsFloat | typing.SupportsIndex=2.059488517353309) -> ToolHead:
    ...

def unused_label(volume: LabelVolume) -> int:
    ...

@typing.overload
def validate(spindle: Spindle) -> None:
    ...

@typing.overload
def validate(material: Material) -> None:
    ...

@typing.overload
def validate(parameters: MolarParameters) -> None:
    ...

@typing.overload
def validate(friction: DryFriction) -> None:
    ...

@typing.overload
def validate(gravity: Gravity) -> None:
    ...

@typing.overload
def validate(filter: DeltaFilter) -> None:
    ...

@typing.overload
def validate(limits: OutputLimits) -> None:
    ...

@typing.overload
def validate(vibration: Vibration, update_rate: typing.SupportsFloat | typing.SupportsIndex) -> None:
    ...

@typing.overload
def validate(effects: Effects, update_rate: typing.SupportsFloat | typing.SupportsIndex) -> None:
    ...

@typing.overload
def validate(config: SimulationConfig) -> None:
    ...

@typing.overload
def validate(gains: CouplingGains) -> None:
    ...

def vector_from_rotation(rotation: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    ...

def wheel_head(diameter: typing.SupportsFloat | typing.SupportsIndex, thickness: typing.SupportsFloat | typing.SupportsIndex, shank_diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    ...

@typing.overload
def with_spacing(volume: GreyVolume, spacing: numpy.typing.ArrayLike) -> GreyVolume:
    ...

@typing.overload
def with_spacing(volume: LabelVolume, spacing: numpy.typing.ArrayLike) -> LabelVolume:
    ...

def write_csv(recording: Recording, path: os.PathLike | str | bytes) -> None:
    ...

def write_npz(recording: Recording, path: os.PathLike | str | bytes) -> None:
    ...

@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, volume: GreyVolume) -> None:
    ...

@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, volume: LabelVolume) -> None:
    ...

@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, workpiece: Workpiece) -> None:
    ...

@typing.overload
def write_obj(mesh: TriangleMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
    ...

@typing.overload
def write_obj(objects: collections.abc.Sequence[NamedMesh], path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
    ...

def write_picture(meshes: collections.abc.Sequence[ColoredMesh], options: PictureOptions, path: os.PathLike | str | bytes) -> None:
    ...

@typing.overload
def write_ply(mesh: TriangleMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
    ...

@typing.overload
def write_ply(mesh: ColoredMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
    ...

def write_stl(mesh: TriangleMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex=1.0) -> None:
    ...
_pybind11_version: str = '3.1'
kBlockEdge: int = 8
kBlockVoxels: int = 512
kEmpty: int = 0
kFastestSpindle: float = 1000000.0
kFastestVibration: float = 0.45
kFullSpinSpeed: float = 0.01
kMaxMaterials: int = 255
kMaxVolumeSamples: int = 2147483648
kMolarCaries: int = 4
kMolarDentin: int = 2
kMolarEnamel: int = 1
kMolarPulp: int = 3
kMostPlayedSteps: int = 10000000
kRecordingFormat: int = 2
kRejected: int = 15
kSafetyEvents: int = 33
kSmallestFill: float = 0.0010000000474974513
kTreeWaist: float = 0.6
kWithIo: bool = True
