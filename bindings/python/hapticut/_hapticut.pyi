# SPDX-License-Identifier: Apache-2.0
# Written by write_stubs.py.
"""
The compiled part of hapticut.
"""
from __future__ import annotations
import collections.abc
import numpy
import numpy.typing
import os
import pathlib
import typing
__all__: list = ['ArmingOptions', 'ArmingState', 'AxialCutForce', 'AxisMask', 'BodyDescription', 'Bounce', 'BounceTest', 'Box', 'BuildInfo', 'Buzz', 'Calibration', 'ClosedLoop', 'ClosedLoopConfig', 'Color', 'ColoredMesh', 'ConeHead', 'Contact', 'ContactMechanicsLaw', 'DampingMatrixLaw', 'DeepContact', 'DeltaFilter', 'DepthAndDirection', 'Device', 'DeviceCapabilities', 'DeviceCommand', 'DeviceFault', 'DeviceModel', 'DeviceOutput', 'DeviceState', 'DrillingTest', 'DryFriction', 'EdgeKind', 'Effects', 'EffectsInput', 'EnergyLedger', 'Error', 'FaultResponse', 'FlatHead', 'FlatRule', 'ForceLaw', 'FoundationLaw', 'Grade', 'Gravity', 'GreyRange', 'GreyVolume', 'GridFrame', 'GuardOptions', 'HandModel', 'HandleTorque', 'HeadBox', 'HertzianBurrLaw', 'IndexBox', 'InjectedFault', 'LHandle', 'LabelInterpolation', 'LabelMaterial', 'LabelVolume', 'LatencyHistogram', 'Layer', 'LinearWall', 'Material', 'MaterialAmount', 'MaterialTable', 'MeshImport', 'MeshShell', 'MockDevice', 'MockOptions', 'MolarParameters', 'MouseDevice', 'MouseOptions', 'MoveKey', 'NamedMesh', 'Output', 'OutputLimit', 'OutputLimits', 'PassivityOptions', 'PictureOptions', 'Plant', 'PlantOptions', 'PoseGateOptions', 'PressTest', 'Profile', 'ProfileEdge', 'ProfileHead', 'Quadrature', 'RawLayout', 'RayHandle', 'RealtimeOptions', 'RecognizedProfile', 'RecordedEffects', 'Recorder', 'RecorderOptions', 'Recording', 'RecordingInfo', 'RemovalLaw', 'ReplayDifference', 'ReplayReport', 'RunOptions', 'RunReport', 'SafetyEvent', 'SafetyGuard', 'SafetyLogEntry', 'Scene', 'Simulation', 'SimulationConfig', 'SphereHead', 'Spindle', 'SpindleMotor', 'SpindleState', 'StabilitySearch', 'StageTimes', 'StepInput', 'StepResult', 'StepStatus', 'StickSlip', 'ThermalOptions', 'ThesisLaw', 'Tool', 'ToolHead', 'TriangleMesh', 'TwistDrillLaw', 'UnclaimedLabels', 'ValueType', 'VdbImport', 'Vibration', 'VolumeBuildOptions', 'VolumeReadOptions', 'WatchdogOptions', 'Workpiece', 'WorkpieceSnapshot', 'WorkpieceSurface', 'WorkspaceMap', 'WorkspaceMapOptions', 'WorstCase', 'Wrench', 'advance', 'axial_cut_force', 'bounce', 'box_around', 'build_block', 'build_body', 'build_from_grey', 'build_from_labels', 'build_from_mesh', 'build_from_shells', 'build_info', 'build_layered_slab', 'build_molar', 'build_sphere', 'calibrate', 'capabilities', 'christmas_tree_head', 'close_gaps', 'colored', 'contact_point', 'crop', 'cylinder_head', 'describe', 'describe_molar', 'device_drivers', 'device_model', 'device_models', 'extract_surface', 'fill_cavities', 'filtered', 'find_preset', 'find_scene', 'flame_head', 'gravity_wrench', 'growth_limited', 'hand_model', 'hand_models', 'has', 'head_in_handle', 'injected_faults', 'inverted_cone_head', 'is_rotation', 'is_stable', 'kFastestVibration', 'kFullSpinSpeed', 'kMaxVolumeSamples', 'kMolarCaries', 'kMolarDentin', 'kMolarEnamel', 'kMolarPulp', 'kRecordingFormat', 'kRejected', 'kWithIo', 'keep_largest_component', 'label_range', 'largest_contact_stiffness', 'largest_stable_stiffness', 'least_force_growth', 'load_vdb', 'masked', 'material_color', 'materials_of', 'mesh_of_revolution', 'most_blocks', 'most_voxels', 'needle_head', 'obeys_the_rules', 'open_device', 'open_mock', 'orthonormalized', 'pear_head', 'preset_color', 'preset_names', 'press', 'profile_from_mesh', 'read_colour_slices', 'read_grey_volume', 'read_invesalius_project', 'read_label_volume', 'read_mesh', 'read_raw_grey_volume', 'read_raw_label_volume', 'read_recording', 'replay', 'resample', 'respond', 'rotation_from_vector', 'round_end_cylinder_head', 'round_end_tapered_head', 'round_head', 'saturated', 'save_vdb', 'scenes', 'scripted_path', 'simulation_of', 'standing_share', 'stiffness_for_accuracy', 'stiffness_for_device', 'tapered_head', 'thesis_handle_torque', 'transport', 'twist_between', 'twist_drill_head', 'validate', 'vector_from_rotation', 'wheel_head', 'with_spacing', 'write_csv', 'write_npz', 'write_nrrd', 'write_picture', 'write_ply', 'write_stl']
class Error(RuntimeError):
    """
    Something that was asked for cannot be done. The message says what was given, what is allowed and what to do.
    """
class BuildInfo:
    """
    Which library this is and what it runs on: reports carry it, so that a number can be traced to a build.
    """
    def __repr__(self) -> str:
        ...
    @property
    def commit(self) -> str:
        """
        git commit it was built from, with "-dirty" when files had been changed; "" outside git
        """
    @property
    def compiler(self) -> str:
        """
        name and version, e.g. "GNU 12.2.0"
        """
    @property
    def cpu(self) -> str:
        """
        model name of the processor it runs on now; "unknown" where the system does not tell
        """
    @property
    def version(self) -> str:
        """
        of the compiled library, e.g. "0.1.0"; HAPTICUT_VERSION is that of the headers
        """
class Wrench:
    """
    Force and torque about a named point, acting on the tool.
    """
    def __copy__(self) -> Wrench:
        ...
    def __deepcopy__(self, memo: dict) -> Wrench:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, force: numpy.typing.ArrayLike = ..., torque: numpy.typing.ArrayLike = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def force(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [N]
        """
    @force.setter
    def force(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def torque(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [N·m]
        """
    @torque.setter
    def torque(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class TriangleMesh:
    """
    A triangle mesh: surfaces that come from files, and the surface of what is left of a workpiece.
    """
    def __init__(self, vertices: numpy.typing.NDArray[numpy.float64], triangles: numpy.typing.NDArray[typing.Any]) -> None:
        """
        Copies vertices (n, 3) float64 [m] and triangles (m, 3) of whole numbers.
        """
    def __repr__(self) -> str:
        ...
    @property
    def triangles(self) -> numpy.ndarray:
        """
        (m, 3) uint32: indices of vertices, counter-clockwise seen from outside; read-only, looks into the mesh.
        """
    @property
    def vertices(self) -> numpy.ndarray:
        """
        (n, 3) [m] in W; read-only, looks into the mesh.
        """
class Color:
    """
    A colour as files hold it: sRGB, 8 bits each.
    """
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
    def __init__(self, red: typing.SupportsInt | typing.SupportsIndex = 255, green: typing.SupportsInt | typing.SupportsIndex = 255, blue: typing.SupportsInt | typing.SupportsIndex = 255) -> None:
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
    """
    A triangle mesh with a colour per vertex.
    """
    def __init__(self, mesh: TriangleMesh, colors: collections.abc.Sequence[Color]) -> None:
        ...
    @property
    def colors(self) -> numpy.ndarray:
        """
        (n, 3) uint8: red, green, blue of every vertex; read-only.
        """
    @property
    def mesh(self) -> TriangleMesh:
        """
        The surface.
        """
class GreyVolume:
    """
    Grey values, e.g. Hounsfield units.

    Values on a regular grid, x fastest. Sample (i, j, k) is the centre of a voxel and lies at
    ``X_WG * (i * spacing.x, j * spacing.y, k * spacing.z)``; the voxel reaches half a spacing to each side.
    """
    def __init__(self, values: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, X_WG: numpy.typing.ArrayLike = ...) -> None:
        """
        Copies an array of shape (nx, ny, nz), in any memory order; values[i, j, k] is sample (i, j, k).
        """
    def position(self, i: typing.SupportsInt | typing.SupportsIndex, j: typing.SupportsInt | typing.SupportsIndex, k: typing.SupportsInt | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] (3,) of a sample, in W.
        """
    @property
    def X_WG(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the grid: position of sample (0,0,0) and directions of its axes
        """
    @property
    def dims(self) -> tuple[int, int, int]:
        """
        number of samples along x, y, z
        """
    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] distance of neighbouring samples along x, y, z
        """
    @property
    def values(self) -> numpy.ndarray:
        """
        (nx, ny, nz) read-only; values[i, j, k] is sample (i, j, k). Looks into the volume: nothing is copied.
        """
class LabelVolume:
    """
    Labels; 0 is empty by convention.

    Values on a regular grid, x fastest. Sample (i, j, k) is the centre of a voxel and lies at
    ``X_WG * (i * spacing.x, j * spacing.y, k * spacing.z)``; the voxel reaches half a spacing to each side.
    """
    def __init__(self, values: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, X_WG: numpy.typing.ArrayLike = ...) -> None:
        """
        Copies an array of shape (nx, ny, nz), in any memory order; values[i, j, k] is sample (i, j, k).
        """
    def position(self, i: typing.SupportsInt | typing.SupportsIndex, j: typing.SupportsInt | typing.SupportsIndex, k: typing.SupportsInt | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] (3,) of a sample, in W.
        """
    @property
    def X_WG(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the grid: position of sample (0,0,0) and directions of its axes
        """
    @property
    def dims(self) -> tuple[int, int, int]:
        """
        number of samples along x, y, z
        """
    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] distance of neighbouring samples along x, y, z
        """
    @property
    def values(self) -> numpy.ndarray:
        """
        (nx, ny, nz) read-only; values[i, j, k] is sample (i, j, k). Looks into the volume: nothing is copied.
        """
class SphereHead:
    """
    A ball. Frame origin = centre = spring centre.  ``w = R - |x|``, ``n = x/|x|``.
    """
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
        """
        [m] > 0
        """
    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ConeHead:
    """
    A cone standing on its apex. Frame origin = apex.  ``w = z sin(a) - rho cos(a)``, ``n = (cos(a) radial, -sin(a)
    axial)``. The base disk at z = height carries no spring.
    """
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
        """
        [rad] between axis and generatrix, 0 < half_angle < pi/2
        """
    @half_angle.setter
    def half_angle(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def height(self) -> float:
        """
        [m] > 0
        """
    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class FlatRule:
    """
    How a flat head chooses between its bottom disk and its side wall.

    Members:

      nearest : the surface with the smaller depth: continuous and conservative (default)

      bottom_only : ``w = z``, pushing along the axis

      side_only : ``w = R - rho``, pushing away from the axis

      both : the sum of the two springs
    """
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
    """
    A cylinder with a cutting bottom disk at z = 0 and a cutting side wall. Frame origin = centre of the bottom disk.
    """
    def __copy__(self) -> FlatHead:
        ...
    def __deepcopy__(self, memo: dict) -> FlatHead:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, radius: typing.SupportsFloat | typing.SupportsIndex, height: typing.SupportsFloat | typing.SupportsIndex, rule: FlatRule = FlatRule.nearest) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def height(self) -> float:
        """
        [m] > 0
        """
    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        [m] > 0
        """
    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rule(self) -> FlatRule:
        """
        which surface carries the spring
        """
    @rule.setter
    def rule(self, arg0: FlatRule) -> None:
        ...
class EdgeKind:
    """
    What an edge of a profile does.

    Members:

      cutting : carries springs and cuts

      smooth : safe-sided or shank: only bounds the head
    """
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
    """
    One edge of a meridian, from the end of the edge before it.
    """
    kind: EdgeKind
    def __copy__(self) -> ProfileEdge:
        ...
    def __deepcopy__(self, memo: dict) -> ProfileEdge:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, rho: typing.SupportsFloat | typing.SupportsIndex = 0.0, z: typing.SupportsFloat | typing.SupportsIndex = 0.0, radius: typing.SupportsFloat | typing.SupportsIndex = 0.0, kind: EdgeKind = EdgeKind.cutting) -> None:
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
        """
        [m] end: distance from the axis, >= 0
        """
    @rho.setter
    def rho(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def z(self) -> float:
        """
        [m] end: height
        """
    @z.setter
    def z(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Profile:
    """
    The meridian of a body of revolution, in the tool frame: from its tip on the axis outwards, up and back to the axis
    on the shank's side, with the body to the left.

          z ^
            +-----+       edges: tip -> (R, 0) -> (R, H) -> (0, H)
            |     |
            |     |
        tip +-----+--> rho
    """
    def __copy__(self) -> Profile:
        ...
    def __deepcopy__(self, memo: dict) -> Profile:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, tip: typing.SupportsFloat | typing.SupportsIndex = 0.0, edges: collections.abc.Sequence[ProfileEdge] = []) -> None:
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
        """
        [m] z of the starting point, at rho = 0
        """
    @tip.setter
    def tip(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ProfileHead:
    """
    A head of any profile of revolution.

    The depth of a point inside the head is its distance from the nearest cutting surface, ``w = min |x - s|``, and the
    direction is that from the point to it.

    Where a cutting edge meets a smooth one, the cutting surface is taken to go on as it ends, if that leads out of the
    body: a straight edge from which the body turns away goes on as its line, an arc about a centre on the axis or
    beyond goes on as its circle. So a ConeHead and a FlatHead are profiles too, and a ball may carry a neck; what lies
    beyond the continued surface has no spring. Any other edge ends where it ends, and its end is the nearest point of
    what lies behind.
    """
    def __init__(self, profile: Profile, tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.01) -> None:
        """
        Parameters
        ----------
        tolerance
            [1] bound on the error of depths, relative to the smaller of largest radius and height, in
            1e-4 ... 0.1; only the points where three edges are equally near have any error

        Raises
        ------
        Error
            When the profile is not closed, crosses its axis or itself, runs the wrong way round, has an edge of no length, an arc whose radius cannot span its ends, or no cutting edge
        """
    @property
    def profile(self) -> Profile:
        """
        The meridian.
        """
    @property
    def reach(self) -> float:
        """
        [m] greatest distance from the frame's origin, exact
        """
    @property
    def table_error(self) -> float:
        """
        [m] Bound on the error of depths: the depth given at a point is the exact one within this, or the exact one of a
        point within this distance. From 289 points of each cell that may have an error, and what can lie between them.
        """
    @property
    def volume(self) -> float:
        """
        [m^3] inside the profile, exact (Pappus)
        """
class HeadBox:
    """
    Extent of a head in its own frame T.
    """
    def __repr__(self) -> str:
        ...
    @property
    def max(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m]
        """
    @property
    def min(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m]
        """
class DepthAndDirection:
    """
    [m] depth and unit direction at one point of T, for tests and set-up code.
    """
    @property
    def depth(self) -> float:
        """
        [m] <= 0 outside the head
        """
    @property
    def direction(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [1] from the local spring centre through the point
        """
class ToolHead:
    """
    The cutting head of a tool: any shape, asked for many points at once.
    """
    def __init__(self, shape: SphereHead | ConeHead | FlatHead | ProfileHead) -> None:
        """
        Raises
        ------
        Error
            When a dimension is not positive or an angle not between 0 and pi/2
        """
    def __repr__(self) -> str:
        ...
    def bounding_box(self) -> HeadBox:
        """
        The smallest axis-aligned box around the head, in T, exact.
        """
    def depth_at(self, p_TQ: numpy.typing.ArrayLike) -> DepthAndDirection:
        """
        [m] depth and unit direction at one point of T, for tests and set-up code.
        """
    def largest_radius(self) -> float:
        """
        [m] largest radius of the head about its axis: sphere and flat R, cone the base radius, profile the largest rho.
        """
    def profile(self) -> Profile:
        """
        The outline as a meridian of lines and arcs. The two surfaces of a flat head are drawn as its rule uses them.
        """
    def reach(self) -> float:
        """
        [m] radius of the ball about the frame's origin that contains the head, exact.
        """
    def volume(self) -> float:
        """
        [m^3] volume of the head, exact.
        """
    @property
    def shape(self) -> SphereHead | ConeHead | FlatHead | ProfileHead:
        """
        SphereHead, ConeHead, FlatHead or ProfileHead.
        """
class RecognizedProfile:
    """
    A profile found in a mesh.
    """
    @property
    def X_MT(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the head's frame in the frame of the mesh: origin at the tip, +z to the shank
        """
    @property
    def deviation(self) -> float:
        """
        [m] greatest distance found between the mesh and the body of the profile
        """
    @property
    def profile(self) -> Profile:
        """
        tip at z = 0; all edges cut but a flat last one, the shank's side
        """
class RayHandle:
    """
    A straight handpiece (thesis 5.11): the head sits on the axis of the stylus.

            z_H ^  o  Ho  where the hand feels
                |  |
                |  |  length
                |  |
            z_T ^  o  To  origin of the tool head; its tip points down
    """
    def __copy__(self) -> RayHandle:
        ...
    def __deepcopy__(self, memo: dict) -> RayHandle:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, length: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def length(self) -> float:
        """
        [m] >= 0 from Ho to To, along -z_H
        """
    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class LHandle:
    """
    An angled handpiece (thesis 5.12-5.14), such as a dental contra-angle: the head's axis is bent away from the stylus.

            z_H ^  o  Ho
                |  |
                |  |  length
                |  |
                E  o-----o  To      elbow E = -length z_H
                    neck             To = E - neck z_T
                                     z_T = z_H turned by ``bend`` about y_H  (bend = 0: straight; pi/2: z_T = x_H)
    """
    def __copy__(self) -> LHandle:
        ...
    def __deepcopy__(self, memo: dict) -> LHandle:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, length: typing.SupportsFloat | typing.SupportsIndex = 0.0, neck: typing.SupportsFloat | typing.SupportsIndex = 0.0, bend: typing.SupportsFloat | typing.SupportsIndex = 1.5707963267948966) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def bend(self) -> float:
        """
        [rad] between z_H and z_T, about y_H, in [-pi, pi]
        """
    @bend.setter
    def bend(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def length(self) -> float:
        """
        [m] >= 0 from Ho to the elbow, along -z_H
        """
    @length.setter
    def length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def neck(self) -> float:
        """
        [m] >= 0 from the elbow to To, along -z_T
        """
    @neck.setter
    def neck(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class HandleTorque:
    """
    How force and torque at the head are felt at the handle.

    Members:

      full_wrench : exactly: T_Ho = T_To + (To - Ho) x F (default)

      thesis : as the thesis prints it, eqs. 5.11-5.14: see ``thesis_handle_torque``
    """
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
    """
    The motor that turns the head.
    """
    def __copy__(self) -> Spindle:
        ...
    def __deepcopy__(self, memo: dict) -> Spindle:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, speed: typing.SupportsFloat | typing.SupportsIndex = 0.0, power_limit: typing.SupportsFloat | typing.SupportsIndex = ..., acceleration_limit: typing.SupportsFloat | typing.SupportsIndex = ..., droop: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
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
        """
        [rad/(s N·m)] >= 0 speed lost per load torque, as of an air turbine
        """
    @droop.setter
    def droop(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def power_limit(self) -> float:
        """
        [W] > 0; above it the spindle slows down
        """
    @power_limit.setter
    def power_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def speed(self) -> float:
        """
        [rad/s] signed about +z of T; 0: the spindle stands and nothing is cut
        """
    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class SpindleMotor:
    """
    The speed of a spindle from one step to the next: its setting, reached on a ramp, less what the load takes.

        sustained = min(|setting| - droop M, power_limit / M)      M: the load torque, where it brakes
        speed     = sign(setting) min(sustained, ramped)           ramped: from the last speed, |slope| <= acceleration

    The load slows the spindle down at once; recovering from it takes the ramp. Turning the other way ramps through
    zero.
    """
    def __init__(self, spindle: Spindle) -> None:
        ...
    def advance(self, torque: typing.SupportsFloat | typing.SupportsIndex, dt: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        The step of duration dt is over, in which the motor had to deliver ``torque``.

        Parameters
        ----------
        torque
            [N·m] about +z; a load that brakes has the sign of the speed
        dt
            [s]

        Notes
        -----
        Real time: no allocation, no lock; O(1)
        """
    def set(self, setting: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Asks for a speed. Reached at once without an acceleration limit.
        """
    @property
    def loaded(self) -> bool:
        """
        the load holds it below its ramp and its setting
        """
    @property
    def setting(self) -> float:
        """
        [rad/s] asked for
        """
    @property
    def speed(self) -> float:
        """
        [rad/s] of the coming step
        """
class Tool:
    """
    What the hand holds: a head on a handle, turned by a spindle. An immutable description, checked when it is made.
    """
    def __init__(self, head: ToolHead, handle: RayHandle | LHandle = ..., spindle: Spindle = ...) -> None:
        """
        Raises
        ------
        Error
            When a dimension of the head or handle, the speed or the power limit is out of range
        """
    def __repr__(self) -> str:
        ...
    @property
    def X_HT(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the head in the handle frame
        """
    @property
    def handle(self) -> RayHandle | LHandle:
        """
        RayHandle or LHandle.
        """
    @property
    def head(self) -> ToolHead:
        """
        The cutting head.
        """
    @property
    def spindle(self) -> Spindle:
        """
        The motor.
        """
class Material:
    """
    What a workpiece is made of. Constants of cutting belong to this material together with this kind of tool.
    """
    def __copy__(self) -> Material:
        ...
    def __deepcopy__(self, memo: dict) -> Material:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, name: str = '', *, relative_stiffness: typing.SupportsFloat | typing.SupportsIndex = 1.0, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, cutting_ratio: typing.SupportsFloat | typing.SupportsIndex = 0.5, specific_cutting_energy: typing.SupportsFloat | typing.SupportsIndex = 300000000.0, edge_pressure: typing.SupportsFloat | typing.SupportsIndex = 0.0, static_friction: typing.SupportsFloat | typing.SupportsIndex = 0.3, dynamic_friction: typing.SupportsFloat | typing.SupportsIndex = 0.3, tangential_stiffness: typing.SupportsFloat | typing.SupportsIndex = 1000.0, density: typing.SupportsFloat | typing.SupportsIndex = 1000.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def cutting_ratio(self) -> float:
        """
        [1] >= 0 kappa, tangential over normal force of the spinning head
        """
    @cutting_ratio.setter
    def cutting_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def damping(self) -> float:
        """
        [s/m] >= 0 Hunt-Crossley factor chi
        """
    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def density(self) -> float:
        """
        [kg/m^3] > 0
        """
    @density.setter
    def density(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def dynamic_friction(self) -> float:
        """
        [1] >= 0
        """
    @dynamic_friction.setter
    def dynamic_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def edge_pressure(self) -> float:
        """
        [Pa] >= 0 p_e, below which nothing is cut
        """
    @edge_pressure.setter
    def edge_pressure(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def name(self) -> str:
        """
        unique within a workpiece, not empty
        """
    @name.setter
    def name(self, arg0: str) -> None:
        ...
    @property
    def relative_stiffness(self) -> float:
        """
        [1] > 0; the foundation stiffness is this times the simulation's reference
        """
    @relative_stiffness.setter
    def relative_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def specific_cutting_energy(self) -> float:
        """
        [J/m^3] > 0 u
        """
    @specific_cutting_energy.setter
    def specific_cutting_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def static_friction(self) -> float:
        """
        [1] >= dynamic_friction; of the standing spindle
        """
    @static_friction.setter
    def static_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def tangential_stiffness(self) -> float:
        """
        [N/m] > 0 of the sticking anchor
        """
    @tangential_stiffness.setter
    def tangential_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class MaterialTable:
    """
    The materials of a workpiece, by id.
    """
    def __contains__(self, id: typing.SupportsInt | typing.SupportsIndex) -> bool:
        ...
    def __getitem__(self, id: typing.SupportsInt | typing.SupportsIndex) -> Material:
        """
        The material of an id.

        Raises
        ------
        Error
            When there is no such id.
        """
    def __getstate__(self) -> list[Material]:
        ...
    @typing.overload
    def __init__(self) -> None:
        ...
    @typing.overload
    def __init__(self, materials: collections.abc.Sequence[Material]) -> None:
        """
        Raises
        ------
        Error
            When a material is invalid, a name appears twice, or there are more than 255
        """
    def __iter__(self) -> collections.abc.Iterator:
        ...
    def __len__(self) -> int:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: collections.abc.Sequence[Material]) -> None:
        ...
    def add(self, material: Material) -> int:
        """
        Adds a material and returns its id: 1 for the first.

        Raises
        ------
        Error
            As above
        """
    def all(self) -> list[Material]:
        """
        In the order of their ids, from 1.
        """
    def contains(self, id: typing.SupportsInt | typing.SupportsIndex) -> bool:
        """
        Whether there is a material of this id.
        """
    def id_of(self, name: str) -> int:
        """
        Raises
        ------
        Error
            When there is no such name
        """
    def size(self) -> int:
        """
        How many there are.
        """
class IndexBox:
    """
    A box of voxels, both ends included.
    """
    def __copy__(self) -> IndexBox:
        ...
    def __deepcopy__(self, memo: dict) -> IndexBox:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, min: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [0, 0, 0], max: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [-1, -1, -1]) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    def empty(self) -> bool:
        """
        Whether there is no voxel in it.
        """
    def voxels(self) -> int:
        """
        How many voxels there are in it.
        """
    @property
    def max(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        ...
    @max.setter
    def max(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        ...
    @property
    def min(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        ...
    @min.setter
    def min(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        ...
class GridFrame:
    """
    How the voxel grid lies in the world: voxel (i, j, k) is centred at ``X_WV * (voxel_size * (i, j, k))``.
    """
    def __copy__(self) -> GridFrame:
        ...
    def __deepcopy__(self, memo: dict) -> GridFrame:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex = 0.0001, X_WV: numpy.typing.ArrayLike = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    def center(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] (3,) of a voxel, in W.
        """
    @property
    def X_WV(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the grid: position of the centre of voxel (0,0,0) and directions of its axes
        """
    @X_WV.setter
    def X_WV(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def voxel_size(self) -> float:
        """
        [m] edge of a voxel
        """
    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Box:
    """
    An axis-aligned box in W.
    """
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
        """
        [m]
        """
    @max.setter
    def max(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def min(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m]
        """
    @min.setter
    def min(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class MaterialAmount:
    """
    Volume and mass of one material of a workpiece.
    """
    def __repr__(self) -> str:
        ...
    @property
    def mass(self) -> float:
        """
        [kg]
        """
    @property
    def material(self) -> int:
        ...
    @property
    def volume(self) -> float:
        """
        [m^3] partly filled voxels counted by their fraction
        """
    @property
    def voxels(self) -> int:
        """
        not yet empty
        """
class WorkpieceSnapshot:
    """
    A frozen copy of the state of a workpiece, to return to. Cheap to copy; shares its memory.
    """
class Quadrature:
    """
    Where in a partly filled voxel its force is taken.

    Members:

      centroid : at the centroid of the part that was filled when the workpiece was built (default)

      voxel_center : at the voxel's centre: as exact in the mean, but the force ripples on surfaces along the grid
    """
    __members__: typing.ClassVar[dict[str, Quadrature]]
    centroid: typing.ClassVar[Quadrature]
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
    """
    What to do with a label that no material claims. Label 0 is always empty unless claimed.

    Members:

      refuse : throw an Error that names them

      leave_out : leave them empty
    """
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
    """
    """
    def __copy__(self) -> VolumeBuildOptions:
        ...
    def __deepcopy__(self, memo: dict) -> VolumeBuildOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex = 0.0, *, crop_samples: IndexBox | None = None, crop: Box | None = None, antialias: bool = True, subsamples: typing.SupportsInt | typing.SupportsIndex = 4) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def antialias(self) -> bool:
        """
        false: a voxel is full or empty, as its centre says
        """
    @antialias.setter
    def antialias(self, arg0: bool) -> None:
        ...
    @property
    def crop(self) -> Box | None:
        """
        Keep only voxels that the smallest grid-aligned box around this box of W touches.
        """
    @crop.setter
    def crop(self, arg0: Box | None) -> None:
        ...
    @property
    def crop_samples(self) -> IndexBox | None:
        """
        Samples to use, both ends included; nothing: all. Voxels keep the indices they would have without the crop.
        """
    @crop_samples.setter
    def crop_samples(self, arg0: IndexBox | None) -> None:
        ...
    @property
    def subsamples(self) -> int:
        """
        1 ... 16 points per edge of a voxel that the surface cuts; more where samples are finer
        """
    @subsamples.setter
    def subsamples(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def voxel_size(self) -> float:
        """
        [m] 0: the smallest spacing of the volume
        """
    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class GreyRange:
    """
    Grey values ``from <= value < to`` are this material.
    """
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
        """
        grey value; may be -infinity
        """
    @from_.setter
    def from_(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def to(self) -> float:
        """
        grey value; may be +infinity
        """
    @to.setter
    def to(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Grade:
    """
    A material whose constants change linearly with the grey value, e.g. bone over Hounsfield units.

    A voxel names one of 255 materials, so the grade is cut into ``steps`` equal pieces and each piece gets the constants
    of its middle: no constant is further from the exact one than |at_high - at_low| / (2 * steps). With the default
    that is 0.4 % of the difference between the ends, below what is known of any of these constants.
    """
    def __copy__(self) -> Grade:
        ...
    def __deepcopy__(self, memo: dict) -> Grade:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, low: typing.SupportsFloat | typing.SupportsIndex, high: typing.SupportsFloat | typing.SupportsIndex, at_low: Material, at_high: Material, *, steps: typing.SupportsInt | typing.SupportsIndex = 128) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def at_high(self) -> Material:
        """
        constants at ``high``
        """
    @at_high.setter
    def at_high(self, arg0: Material) -> None:
        ...
    @property
    def at_low(self) -> Material:
        """
        constants at ``low``; its name begins the names of the pieces
        """
    @at_low.setter
    def at_low(self, arg0: Material) -> None:
        ...
    @property
    def high(self) -> float:
        """
        grey value of ``at_high``; above it nothing changes any more
        """
    @high.setter
    def high(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def low(self) -> float:
        """
        grey value where the body begins; below is empty
        """
    @low.setter
    def low(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def steps(self) -> int:
        """
        1 ... 200
        """
    @steps.setter
    def steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Workpiece:
    """
    What is cut: a sparse OpenVDB grid of material ids and, only where a voxel is partly filled, of filled fractions.

    Homogeneous interiors are stored as tiles and cost no memory per voxel. Cutting turns tiles into blocks; the blocks
    come from a pool that ``reserve_blocks`` fills beforehand, so that cutting never allocates. Blocks that become empty
    go back to the pool.

    A workpiece moves but does not copy by accident: use ``clone``. Not thread-safe; a simulation owns its workpiece.
    """
    @staticmethod
    def from_arrays(material: numpy.ndarray, fill: numpy.ndarray | None, frame: GridFrame, materials: MaterialTable, origin: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [0, 0, 0]) -> Workpiece:
        """
        A workpiece from its voxels: what material_array and fill_array give, but for the centroids.

        Parameters
        ----------
        material
            (nx, ny, nz) uint8 ids, 0 where there is nothing.
        fill
            (nx, ny, nz) filled fractions 0 ... 1, or None: all full.
        frame
            voxel size and pose.
        materials
            the table that the ids refer to.
        origin
            index of the first voxel.

        Raises
        ------
        Error
            When shapes or types do not fit, or an id or a fill is out of range.
        """
    @staticmethod
    @typing.overload
    def from_intensity(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, ranges: collections.abc.Sequence[GreyRange], X_WG: numpy.typing.ArrayLike = ..., options: VolumeBuildOptions = ...) -> Workpiece:
        """
        A workpiece from grey values: what no range covers is empty.

        Parameters
        ----------
        array
            (nx, ny, nz) of any real dtype, any memory order: array[i, j, k] is sample (i, j, k).
        spacing
            [m] (3,) distance of neighbouring samples along x, y, z.
        ranges
            GreyRange list, or one Grade for a material whose constants change with the grey value.
        X_WG
            (4, 4) pose of the grid.
        options
            voxel size, crop and antialiasing.

        Raises
        ------
        Error
            When the array, the spacing or the ranges do not fit; see build_from_grey.
        """
    @staticmethod
    @typing.overload
    def from_intensity(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, ranges: Grade, X_WG: numpy.typing.ArrayLike = ..., options: VolumeBuildOptions = ...) -> Workpiece:
        ...
    @staticmethod
    def from_labels(array: numpy.typing.NDArray[typing.Any], spacing: numpy.typing.ArrayLike, materials: dict, X_WG: numpy.typing.ArrayLike = ..., options: VolumeBuildOptions = ..., unclaimed: UnclaimedLabels = UnclaimedLabels.refuse) -> Workpiece:
        """
        A workpiece from a segmentation.

        Parameters
        ----------
        array
            (nx, ny, nz) of a whole-number dtype, any memory order: array[i, j, k] is the label of sample
            (i, j, k). An array that was read as [z, y, x] is given as array.T.
        spacing
            [m] (3,) distance of neighbouring samples along x, y, z.
        materials
            dict from a label, or a tuple of labels, to its Material; ids follow its order.
        X_WG
            (4, 4) pose of the grid: position of sample (0, 0, 0) and directions of its axes.
        options
            voxel size, crop and antialiasing.
        unclaimed
            what to do with a label that no material claims; label 0 is always empty unless claimed.

        Raises
        ------
        Error
            When the array, the spacing or the labels do not fit; see build_from_labels.
        """
    def __copy__(self) -> Workpiece:
        ...
    def __deepcopy__(self, memo: dict) -> Workpiece:
        ...
    def __repr__(self) -> str:
        ...
    def amounts(self) -> list[MaterialAmount]:
        """
        one entry per material of the table
        """
    def bounds(self) -> IndexBox:
        """
        smallest box around all voxels that are not empty
        """
    def centroid_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> numpy.typing.NDArray[numpy.float64]:
        """
        [voxel edges] (3,) from a voxel's centre to the centroid of its filled part.
        """
    def clone(self) -> Workpiece:
        """
        a deep copy with an empty pool
        """
    def empty(self) -> bool:
        """
        nothing left at all
        """
    def fill_array(self, box: IndexBox | None = None) -> numpy.ndarray:
        """
        (nx, ny, nz) float32: the filled fraction of every voxel of a box; without a box, of bounds().
        """
    def fill_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> float:
        """
        [1] 0 outside
        """
    def hash(self) -> int:
        """
        A number that depends on every voxel's material and fill, bit by bit: equal states have equal hashes.
        """
    def material_array(self, box: IndexBox | None = None) -> numpy.ndarray:
        """
        (nx, ny, nz) uint8: the material of every voxel of a box, 0 where it is empty; without a box, of bounds().
        """
    def material_at(self, index: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> int:
        """
        kEmpty outside
        """
    def memory_bytes(self) -> int:
        """
        of the trees, without the pool
        """
    def pool_bytes(self) -> int:
        """
        of the blocks held ready for cutting
        """
    def reserve_blocks(self, count: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Set-up only: holds memory ready for ``count`` blocks to become partly cut.
        """
    def reserved_blocks(self) -> int:
        """
        blocks still in the pool
        """
    def restore(self, snapshot: WorkpieceSnapshot) -> None:
        """
        Raises
        ------
        Error
            When the snapshot is empty
        """
    def set_materials(self, materials: MaterialTable) -> None:
        """
        Changes the constants of the materials, not what is where.

        Raises
        ------
        Error
            When there are not as many materials as before
        """
    def snapshot(self) -> WorkpieceSnapshot:
        """
        A frozen copy of the state, to return to. Cheap to copy; shares memory.
        """
    def solid_voxels(self) -> int:
        """
        voxels that are not yet empty
        """
    @property
    def frame(self) -> GridFrame:
        """
        How the voxel grid lies in the world: voxel (i, j, k) is centred at ``X_WV * (voxel_size * (i, j, k))``.
        """
    @property
    def materials(self) -> MaterialTable:
        """
        A copy of the table; see set_materials.
        """
    @property
    def voxel_size(self) -> float:
        """
        [m]
        """
class WorkpieceSurface:
    """
    The surface of a workpiece and what it is made of.
    """
    @property
    def materials(self) -> numpy.ndarray:
        """
        (n,) uint8 of each vertex: the material of the voxel nearest to it that is not empty; read-only.
        """
    @property
    def mesh(self) -> TriangleMesh:
        """
        closed; [m] in W; counter-clockwise seen from outside
        """
class BodyDescription:
    """
    A body described by functions of the position in W.
    """
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
        """
        contains the whole body
        """
    @box.setter
    def box(self, arg0: Box) -> None:
        ...
    @property
    def distance(self) -> collections.abc.Callable[[numpy.typing.ArrayLike], float]:
        """
        [m] negative inside, positive outside; must not change faster than the position does (a distance, or a bound of
        it).
        """
    @distance.setter
    def distance(self, arg0: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsFloat | typing.SupportsIndex]) -> None:
        ...
    @property
    def material(self) -> collections.abc.Callable[[numpy.typing.ArrayLike], int]:
        """
        Material at a point inside. Called from several threads at once.
        """
    @material.setter
    def material(self, arg0: collections.abc.Callable[[numpy.typing.NDArray[numpy.float64]], typing.SupportsInt | typing.SupportsIndex]) -> None:
        ...
class Layer:
    """
    A block made of horizontal layers, from the top down.
    """
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
        """
        [m] > 0
        """
    @thickness.setter
    def thickness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class MolarParameters:
    """
    Sizes of the molar. The defaults are an average tooth. Sources: [L] Lee et al. 2016, J Dent Sci 11 (casts of 141
    teeth); [W] the customary table of tooth dimensions in textbooks of dental anatomy (Wheeler), from memory; [D]
    Deutsch & Musikant 2004, J Endod 30:388 (100 lower molars); [H] Harris et al. 2013, J Endod 39 (22 lower first
    molars); [A] assumption.
    """
    def __copy__(self) -> MolarParameters:
        ...
    def __deepcopy__(self, memo: dict) -> MolarParameters:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, crown_mesiodistal: typing.SupportsFloat | typing.SupportsIndex = 0.0111, *, crown_buccolingual: typing.SupportsFloat | typing.SupportsIndex = 0.0105, crown_height: typing.SupportsFloat | typing.SupportsIndex = 0.0075, cervix_mesiodistal: typing.SupportsFloat | typing.SupportsIndex = 0.009, cervix_buccolingual: typing.SupportsFloat | typing.SupportsIndex = 0.009, cervical_curvature: typing.SupportsFloat | typing.SupportsIndex = 0.001, mesial_root_length: typing.SupportsFloat | typing.SupportsIndex = 0.014, distal_root_length: typing.SupportsFloat | typing.SupportsIndex = 0.013, furcation_depth: typing.SupportsFloat | typing.SupportsIndex = 0.0036, fossa_depth: typing.SupportsFloat | typing.SupportsIndex = 0.0028, fissure_depth: typing.SupportsFloat | typing.SupportsIndex = 0.00035, fissure_half_width: typing.SupportsFloat | typing.SupportsIndex = 0.0004, distal_cusp: bool = True, enamel_at_cusps: typing.SupportsFloat | typing.SupportsIndex = 0.0022, enamel_on_walls: typing.SupportsFloat | typing.SupportsIndex = 0.0013, enamel_in_fossa: typing.SupportsFloat | typing.SupportsIndex = 0.0012, chamber_mesiodistal: typing.SupportsFloat | typing.SupportsIndex = 0.0046, chamber_buccolingual: typing.SupportsFloat | typing.SupportsIndex = 0.0038, chamber_roof: typing.SupportsFloat | typing.SupportsIndex = 0.00064, chamber_height: typing.SupportsFloat | typing.SupportsIndex = 0.00157, horn_height: typing.SupportsFloat | typing.SupportsIndex = 0.0012, canal_radius: typing.SupportsFloat | typing.SupportsIndex = 0.0004, canal_radius_at_apex: typing.SupportsFloat | typing.SupportsIndex = 0.0002, apical_dentin: typing.SupportsFloat | typing.SupportsIndex = 0.001, caries_depth: typing.SupportsFloat | typing.SupportsIndex = 0.0, caries_width: typing.SupportsFloat | typing.SupportsIndex = 0.0025) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def apical_dentin(self) -> float:
        """
        [m] 0.6 ... 3 mm between the end of a canal and the apex: closed; [A]
        """
    @apical_dentin.setter
    def apical_dentin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def canal_radius(self) -> float:
        """
        [m] 0.2 ... 0.6 mm, at the orifices of the root canals; [A]
        """
    @canal_radius.setter
    def canal_radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def canal_radius_at_apex(self) -> float:
        """
        [m] 0.1 mm ... canal_radius; [A]
        """
    @canal_radius_at_apex.setter
    def canal_radius_at_apex(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def caries_depth(self) -> float:
        """
        [m] 0 (none) ... 5 mm, a lesion under the central fossa
        """
    @caries_depth.setter
    def caries_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def caries_width(self) -> float:
        """
        [m] 0.5 ... 6 mm, its diameter along x and y
        """
    @caries_width.setter
    def caries_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def cervical_curvature(self) -> float:
        """
        [m] 0 ... 2 mm, rise of the junction on the mesial side; [W] 1 mm
        """
    @cervical_curvature.setter
    def cervical_curvature(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def cervix_buccolingual(self) -> float:
        """
        [m] 6.5 mm ... crown_buccolingual; [W] 9 mm
        """
    @cervix_buccolingual.setter
    def cervix_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def cervix_mesiodistal(self) -> float:
        """
        [m] 6.5 mm ... crown_mesiodistal, width of the neck; [W] 9 mm
        """
    @cervix_mesiodistal.setter
    def cervix_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def chamber_buccolingual(self) -> float:
        """
        [m] 2 ... 6 mm; [H] mesial orifices 1.4 ... 3 mm apart
        """
    @chamber_buccolingual.setter
    def chamber_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def chamber_height(self) -> float:
        """
        [m] 1 ... 3 mm; [D] 1.57 +- 0.68 mm
        """
    @chamber_height.setter
    def chamber_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def chamber_mesiodistal(self) -> float:
        """
        [m] 2 ... 6 mm, pulp chamber; [H] orifices 4.4 mm apart
        """
    @chamber_mesiodistal.setter
    def chamber_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def chamber_roof(self) -> float:
        """
        [m] -1 ... 2 mm above the junction; [D] 6.36 mm below a cusp of 7 mm
        """
    @chamber_roof.setter
    def chamber_roof(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def crown_buccolingual(self) -> float:
        """
        [m] 8 ... 15 mm, greatest width along y; [L] 10.47 +- 0.27 mm
        """
    @crown_buccolingual.setter
    def crown_buccolingual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def crown_height(self) -> float:
        """
        [m] 5 ... 10 mm, junction to the tip of the highest cusp; [W] 7.5 mm
        """
    @crown_height.setter
    def crown_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def crown_mesiodistal(self) -> float:
        """
        [m] 8 ... 15 mm, greatest width along x; [L] 11.13 +- 0.40 mm
        """
    @crown_mesiodistal.setter
    def crown_mesiodistal(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def distal_cusp(self) -> bool:
        """
        five cusps as on most lower first molars, or four
        """
    @distal_cusp.setter
    def distal_cusp(self, arg0: bool) -> None:
        ...
    @property
    def distal_root_length(self) -> float:
        """
        [m] 8 ... 20 mm; [W] a little shorter than the mesial root
        """
    @distal_root_length.setter
    def distal_root_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def enamel_at_cusps(self) -> float:
        """
        [m] 1.2 ... 3 mm, tip of a cusp to the dentin horn under it; [A]
        """
    @enamel_at_cusps.setter
    def enamel_at_cusps(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def enamel_in_fossa(self) -> float:
        """
        [m] 0.5 ... 2 mm, under the central fossa; [A]
        """
    @enamel_in_fossa.setter
    def enamel_in_fossa(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def enamel_on_walls(self) -> float:
        """
        [m] 0.5 ... 2 mm, thickest on the sides; zero at the junction; [A]
        """
    @enamel_on_walls.setter
    def enamel_on_walls(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fissure_depth(self) -> float:
        """
        [m] 0 ... 0.8 mm; [A]
        """
    @fissure_depth.setter
    def fissure_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fissure_half_width(self) -> float:
        """
        [m] 0.1 ... 1 mm; [A]
        """
    @fissure_half_width.setter
    def fissure_half_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fossa_depth(self) -> float:
        """
        [m] 1 ... 3.5 mm, highest cusp to the middle of the central fossa; [A]
        """
    @fossa_depth.setter
    def fossa_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def furcation_depth(self) -> float:
        """
        [m] 2 ... 5 mm, junction to the roof between the roots; [W] 3, [D] about 4
        """
    @furcation_depth.setter
    def furcation_depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def horn_height(self) -> float:
        """
        [m] 0 ... 2 mm, pulp horns above the roof; [A]
        """
    @horn_height.setter
    def horn_height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mesial_root_length(self) -> float:
        """
        [m] 8 ... 20 mm, junction to apex; [W] 14 mm
        """
    @mesial_root_length.setter
    def mesial_root_length(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class MeshShell:
    """
    A closed surface and what it is filled with.
    """
    def __init__(self, mesh: TriangleMesh, material: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        ...
    @property
    def material(self) -> int:
        """
        of what it encloses; kEmpty makes a cavity of it
        """
    @material.setter
    def material(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def mesh(self) -> TriangleMesh:
        """
        [m] in W; small holes are closed, inside-out surfaces turned round
        """
class MeshImport:
    """
    How surfaces become voxels.
    """
    def __copy__(self) -> MeshImport:
        ...
    def __deepcopy__(self, memo: dict) -> MeshImport:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, voxel_size: typing.SupportsFloat | typing.SupportsIndex = 0.0001, subsamples: typing.SupportsInt | typing.SupportsIndex = 8) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def subsamples(self) -> int:
        """
        points per voxel edge in the voxels that a surface cuts, 1 ... 16
        """
    @subsamples.setter
    def subsamples(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def voxel_size(self) -> float:
        """
        [m]
        """
    @voxel_size.setter
    def voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class LabelMaterial:
    """
    Labels that are one material.
    """
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
    """
    Whether and by which energy balance the spinning head takes material away.

    Members:

      none : nothing is cut: probing, or pure force rendering

      constant_energy : law A (default): every removed volume costs its specific cutting energy

      elastic_release : law G: the elastic energy of removed material pays a part of it
    """
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
    """
    A force law: from the samples inside the head to the force on the tool and to what is left of each voxel.

    It works in the 1 kHz loop, so a law of one's own is a class in C++; Python chooses one and its constants.
    """
    def needs_moments(self) -> bool:
        """
        Whether the blocks are gone over once before, to give ``lump`` and ``HeadMotion::whole`` the whole contact.
        """
    def require_head(self, head: ToolHead) -> None:
        """
        Called once, at set-up.

        Raises
        ------
        Error
            When the law has no formula for this head; the message names those that it has
        """
class FoundationLaw(ForceLaw):
    """
    The default law: a volumetric elastic foundation that the spinning head cuts by the power it delivers.

    For every sample of depth w, fill phi and direction n, with the slip v_t tangential to the cutting surface:

        f = k_v phi w l^3 max(0, 1 + chi w_dot)                    normal force, Hunt-Crossley damped
        g = -f n - kappa f v_t / sqrt(|v_t|^2 + v_eps^2)           force on the tool; second term only when spinning
        phi <- phi exp(-x),  x = kappa k_v w max(0, 1 + chi w_dot) s dt / u     where w > w0 and the spindle turns

    and the force uses the mean of phi over the sub-step, phi (1 - e^-x)/x, so that the tangential work of a cut sample
    is u l^3 times the fill that it loses, exactly, for any step. Law G replaces u by max(u - k_v w^2/2, 1e-6 u). Along
    the path w_dot = (V + Omega x r) . n; the damping factor takes w_dot from the device's own velocity.

    After the thesis's spring model (Uener 2007, eqs. 5.5-5.8, 5.15-5.16), with its dependence on voxel size and step
    repaired; see docs/decisions/0003-removal-and-ledger.md.
    """
    def __init__(self) -> None:
        ...
class ThesisLaw(ForceLaw):
    """
    The model of the thesis as printed (Uener 2007, eqs. 5.5-5.8, 5.15, 5.16), to reproduce it and to compare with it.

    For every voxel i inside the head, whole or partly filled, of depth w, direction n and material stiffness k_i:

        F_i   = -k_i l w_i n_i - b V                                        spring and damper of one voxel
        F     = Sum F_i,   T = Sum (X_i - To) x F_i + T_spin z
        T_spin = -lambda sgn(omega) (|omega|/omega_0)^m R Sum k_i l w_i     omega_0 = 1 rad/s
        P_i   = lambda (|omega|/omega_0)^m R k_i l w_i |omega|              power generated at the voxel
        voxel i is removed, whole and in this step, iff  P_i >= c k_i       power required

    What is a reading: the repulsive sign (as printed the springs pull the tool in); the arm X_i - To (along the spring,
    as printed, the torque is zero, D3); everything about the second lines of 5.6-5.8, of which only a constant lambda,
    a power of the spindle's speed and a cross product survived; the required power, "related to the stiffness", as
    proportional to it. V is the velocity of the head as the device gives it, R the largest radius of the head.

    k_i = k_v l0^2 of the material's k_v = relative stiffness times SimulationConfig::reference_stiffness, so that
    thesis and default model agree at the voxel size l0; at any other they do not: the sums grow as l^-2 and, for the
    damper, l^-3 under refinement (D1, D2). Removal costs no energy (D7): the ledger books the springs' energy of
    removed voxels as released, the spin torque's work as rubbing, the damper's as damping, which a turning handpiece
    can make negative.
    """
    class Constants:
        """
        """
        def __copy__(self) -> ThesisLaw.Constants:
            ...
        def __deepcopy__(self, memo: dict) -> ThesisLaw.Constants:
            ...
        def __getstate__(self) -> tuple:
            ...
        def __init__(self, reference_voxel_size: typing.SupportsFloat | typing.SupportsIndex = 0.0001, *, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, spin_torque: typing.SupportsFloat | typing.SupportsIndex = 0.3, spin_exponent: typing.SupportsFloat | typing.SupportsIndex = 0.0, required_power: typing.SupportsFloat | typing.SupportsIndex = 1e-09) -> None:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, arg0: tuple) -> None:
            ...
        @property
        def damping(self) -> float:
            """
            [N·s/m] >= 0 of one voxel, b
            """
        @damping.setter
        def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def reference_voxel_size(self) -> float:
            """
            [m] > 0, l0
            """
        @reference_voxel_size.setter
        def reference_voxel_size(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def required_power(self) -> float:
            """
            [W/(N/m^2)] >= 0, c: power to remove a voxel over its stiffness
            """
        @required_power.setter
        def required_power(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def spin_exponent(self) -> float:
            """
            [1] m
            """
        @spin_exponent.setter
        def spin_exponent(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def spin_torque(self) -> float:
            """
            [1] >= 0, lambda
            """
        @spin_torque.setter
        def spin_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
    def __init__(self, constants: ThesisLaw.Constants) -> None:
        """
        Raises
        ------
        Error
            Naming the constant, its value and the allowed range
        """
    @property
    def constants(self) -> ThesisLaw.Constants:
        """
        As given.
        """
class ContactMechanicsLaw(ForceLaw):
    """
    A rigid punch on an elastic half space (thesis Table 5.1; Boussinesq, Hertz, Sneddon 1965), at depth d:

        flat    F = 2 R E* d                        U = R E* d^2
        sphere  F = 4/3 E* sqrt(R) d^1.5            U = 8/15 E* sqrt(R) d^2.5
        cone    F = 2/pi E* tan(alpha) d^2          U = 2/(3 pi) E* tan(alpha) d^3      alpha: half-apex angle

    E* = E/(1 - nu^2). All pressed at a right angle onto a flat surface: the limit of this law, and the reason that the
    thesis gives for not using it. d is the depth at which a half space would fill the same volume of the head, along
    the mean direction into the material, so that any contact gives a force, and a perpendicular one exactly that of the
    table. A spinning head rubs under F with the materials' cutting ratio and cuts by the power of that.
    """
    @staticmethod
    def depth_of(head: ToolHead, volume: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [m] depth at which a half space fills this volume [m^3] of a head, tip first; at most the height of the head.
        """
    def __init__(self, effective_modulus: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Parameters
        ----------
        effective_modulus
            [Pa] > 0, E* = E/(1 - nu^2)

        Raises
        ------
        Error
            When it is not positive
        """
    def energy(self, head: ToolHead, d: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [J] at depth d [m].
        """
    def force(self, head: ToolHead, d: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [N] at depth d [m].
        """
class HertzianBurrLaw(ForceLaw):
    """
    A round burr whose contact is Hertz's (Agus, Giachetti, Gobbetti, Zanetti, Zorcolo: Mastoidectomy simulation with
    combined visual and haptic feedback, 2002; [1], [2] of the thesis).

    The burr of radius R knows the bone by two sums over the voxels inside it, of which the depth h and the direction n
    of an equivalent flat surface follow:

        M0 = Sum rho_i = pi R^3 (h/R)^2 (1 - h/3R),   M1 = Sum rho_i r_i = |M1| n
        F_e = -C1 R^2 (h/R)^1.5 n                       elastic force on the burr
        F_mu: Coulomb friction of F_e along the slip of the surface, ratio kappa of the materials
        mass flux = alpha mu P omega r                  power of the friction over the cost of a volume: 1/alpha = u

    The original spreads the flux like Hertz's pressure over the contact; here it is spread like depth times slip, the
    removal that all laws of the library share. Its total is the same.
    """
    def __init__(self, stiffness: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Parameters
        ----------
        stiffness
            [Pa] > 0, C1

        Raises
        ------
        Error
            When it is not positive
        """
    def energy(self, R: typing.SupportsFloat | typing.SupportsIndex, h: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [J] the same integrated over h.
        """
    def force(self, R: typing.SupportsFloat | typing.SupportsIndex, h: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [N] at depth h [m] of a burr of radius R [m].
        """
class DampingMatrixLaw(ForceLaw):
    """
    Resistance to the motion of a spinning head (thesis 5.1, 5.2, after its [15]): a viscous force and a part of it
    turned across by the spin.

        F = -M V,   M = m (I + mu [omega_hat]x),   m = K_alpha K_beta K_omega K_eps F(H, L)

    The K are the factors that the source tabulates for the head, the material, the speed and the layer; they enter as
    one product, ``resistance``, and F(H, L), its "function for the contact area", is that area: the filled volume in the
    head over its greatest depth. The force needs motion: at rest there is none, and a surface does not push back. It
    does no work but -m |V|^2, which cuts while the spindle turns. Any head.
    """
    class Constants:
        """
        """
        def __copy__(self) -> DampingMatrixLaw.Constants:
            ...
        def __deepcopy__(self, memo: dict) -> DampingMatrixLaw.Constants:
            ...
        def __getstate__(self) -> tuple:
            ...
        def __init__(self, resistance: typing.SupportsFloat | typing.SupportsIndex = 100000000.0, friction: typing.SupportsFloat | typing.SupportsIndex = 0.3) -> None:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, arg0: tuple) -> None:
            ...
        @property
        def friction(self) -> float:
            """
            [1] >= 0, mu
            """
        @friction.setter
        def friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def resistance(self) -> float:
            """
            [N·s/m^3] > 0: the product of the K
            """
        @resistance.setter
        def resistance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
    def __init__(self, constants: DampingMatrixLaw.Constants) -> None:
        """
        Raises
        ------
        Error
            Naming the constant, its value and the allowed range
        """
class TwistDrillLaw(ForceLaw):
    """
    A twist drill that chips bone (Allotta, Belmonte, Bosio, Dario 1996; [33] of the thesis).

        F = K_s a (D/2) sin(beta/2),   M = K_s a D^2/8,   a = 2 pi v_f/|omega|

    D is the diameter of the drill where it is in material, beta its point angle, v_f the speed at which it is fed
    towards its tip. M turns against the spin, F pushes back along the axis; retreating, or standing, there is neither.
    M omega = K_s pi D^2/4 v_f: exactly what removing the fed volume costs, if K_s is the material's u. F v_f is lost to
    friction. This is the steady state of the default law with kappa = 1/sin(beta/2) and p_e = 0 (C31).

    A cone is a drill of point angle twice its half angle, a flat head one of 180 degrees.
    """
    class Constants:
        """
        """
        def __copy__(self) -> TwistDrillLaw.Constants:
            ...
        def __deepcopy__(self, memo: dict) -> TwistDrillLaw.Constants:
            ...
        def __getstate__(self) -> tuple:
            ...
        def __init__(self, specific_energy: typing.SupportsFloat | typing.SupportsIndex = 100000000.0, largest_feed_per_turn: typing.SupportsFloat | typing.SupportsIndex = 0.001) -> None:
            ...
        def __repr__(self) -> str:
            ...
        def __setstate__(self, arg0: tuple) -> None:
            ...
        @property
        def largest_feed_per_turn(self) -> float:
            """
            [m] > 0; a is cut off there, where the spindle turns too slowly to chip
            """
        @largest_feed_per_turn.setter
        def largest_feed_per_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
        @property
        def specific_energy(self) -> float:
            """
            [J/m^3] > 0, K_s
            """
        @specific_energy.setter
        def specific_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
            ...
    @staticmethod
    def point_angle(head: ToolHead) -> float:
        """
        [rad]
        """
    def __init__(self, constants: TwistDrillLaw.Constants) -> None:
        """
        Raises
        ------
        Error
            Naming the constant, its value and the allowed range
        """
    def thrust(self, diameter: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex, point_angle: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [N] of a drill of diameter D [m] and point angle [rad] at feed per turn a [m].
        """
    def torque(self, diameter: typing.SupportsFloat | typing.SupportsIndex, a: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [N·m]
        """
class DryFriction:
    """
    Dry friction between the standing head and the material.
    """
    def __copy__(self) -> DryFriction:
        ...
    def __deepcopy__(self, memo: dict) -> DryFriction:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, static_friction: typing.SupportsFloat | typing.SupportsIndex = 0.3, dynamic_friction: typing.SupportsFloat | typing.SupportsIndex = 0.3, tangential_stiffness: typing.SupportsFloat | typing.SupportsIndex = 1000.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def dynamic_friction(self) -> float:
        """
        [1] >= 0, mu_d
        """
    @dynamic_friction.setter
    def dynamic_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def static_friction(self) -> float:
        """
        [1] >= dynamic_friction, mu_s
        """
    @static_friction.setter
    def static_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def tangential_stiffness(self) -> float:
        """
        [N/m] > 0 of the sticking anchor, k_t
        """
    @tangential_stiffness.setter
    def tangential_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class StickSlip:
    """
    Stick and slip: an elastic anchor that the tool drags over the material.

    The anchor S lies in the workpiece, ``stretch = S - x`` is its distance from the contact point x of the tool, and the
    force on the tool is ``k_t stretch``, in the plane normal to the summed normal force N. While it sticks, S stays. When
    ``k_t |stretch|`` would exceed ``mu_s |N|`` it slides: S is dragged along so that the force is ``mu_d |N|``, until the
    force falls below that. No contact, no anchor. The force never leaves the cone ``mu_s |N|``.

    A sub-step that sticks returns its mean force, so that the work is exactly what the anchor stores; everything else
    is dissipation, and never negative (C17).
    """
    class Outcome:
        """
        What a motion of the contact point gave.
        """
        @property
        def dissipated(self) -> float:
            """
            [J] >= 0
            """
        @property
        def force(self) -> numpy.typing.NDArray[numpy.float64]:
            """
            [N] on the tool at the contact point
            """
    def __init__(self) -> None:
        ...
    def move(self, normal_force: numpy.typing.ArrayLike, displacement: numpy.typing.ArrayLike, friction: DryFriction, share: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> StickSlip.Outcome:
        """
        Moves the contact point of the tool.

        Parameters
        ----------
        normal_force
            [N] summed normal force on the tool
        displacement
            [m] of the tool's contact point over the material, in the same axes
        share
            [1] of the coefficients in force: see ``standing_share``

        Notes
        -----
        Real time: no allocation, no lock
        """
    def release(self) -> None:
        """
        Lets go of the anchor.
        """
    @property
    def anchored(self) -> bool:
        """
        there is contact
        """
    @property
    def sliding(self) -> bool:
        """
        It slides.
        """
    @property
    def stored(self) -> float:
        """
        [J] energy of the anchor.
        """
    @property
    def stretch(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] from the contact point to the anchor
        """
class DeepContact:
    """
    Keeps a ball that was pushed beyond its radius from popping through (D15).

    The springs of a ball push away from its centre, so those beyond the centre help it in: the force of a half space
    peaks at depth R, falls, and vanishes when the ball is buried. Once more than half of the ball is filled, the
    direction n that it last pushed in is frozen, and the ball is tied to that place by a spring along n:

        F = -K s n,   s = (To - p) . n > 0        p: where To was then

    with K = 1.05 * 16/9 |F_last|/R, a little more than the steepest fall of the springs' force (C2), so that the sum
    never falls as the ball goes deeper. The spring has an energy, K s^2/2, and does no work on a closed path. It lets
    go where the ball comes back to p, and yields where material leaves the ball (it is cut, or a wall breaks): K then
    falls with the filled share of the ball, to nothing at a quarter. A ball that never touched a surface before it was
    buried has no direction to be pushed in, and feels the springs alone.
    """
    class Outcome:
        """
        What a motion of the ball gave.
        """
        @property
        def force(self) -> numpy.typing.NDArray[numpy.float64]:
            """
            [N] on the ball at its centre
            """
        @property
        def released(self) -> float:
            """
            [J] >= 0, lost where the spring yielded or let go
            """
        @property
        def stored(self) -> float:
            """
            [J]
            """
        @property
        def stored_before(self) -> float:
            """
            [J]
            """
    def __init__(self) -> None:
        ...
    def move(self, start: numpy.typing.ArrayLike, to: numpy.typing.ArrayLike, filled: typing.SupportsFloat | typing.SupportsIndex, normal_force: numpy.typing.ArrayLike, radius: typing.SupportsFloat | typing.SupportsIndex) -> DeepContact.Outcome:
        """
        The ball has moved on a straight way.

        Parameters
        ----------
        from, to
            [m] its centre, in W
        filled
            [1] share of the ball that is filled, in the middle of the way
        normal_force
            [N] of the springs on the ball, there, in W
        radius
            [m]

        Notes
        -----
        Real time: no allocation, no lock; O(1)
        """
    def release(self) -> None:
        """
        Lets go.
        """
    @property
    def held(self) -> bool:
        """
        the spring acts
        """
    @property
    def stored(self) -> float:
        """
        [J]
        """
class DrillingTest:
    """
    One drilling test: a head of radius R fed along its axis into material, at full diameter.
    """
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
        """
        [m/s] > 0
        """
    @feed_speed.setter
    def feed_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def radius(self) -> float:
        """
        [m] > 0
        """
    @radius.setter
    def radius(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def spindle_speed(self) -> float:
        """
        [rad/s] not 0
        """
    @spindle_speed.setter
    def spindle_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def thrust(self) -> float:
        """
        [N] > 0, steady
        """
    @thrust.setter
    def thrust(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def torque(self) -> float:
        """
        [N·m] > 0, steady
        """
    @torque.setter
    def torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Calibration:
    """
    The constants of a material with a kind of tool that explain drilling tests.
    """
    def __copy__(self) -> Calibration:
        ...
    def __deepcopy__(self, memo: dict) -> Calibration:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, specific_cutting_energy: typing.SupportsFloat | typing.SupportsIndex = 0.0, *, cutting_ratio: typing.SupportsFloat | typing.SupportsIndex = 0.0, edge_pressure: typing.SupportsFloat | typing.SupportsIndex = 0.0, edge_identified: bool = False, thrust_residual: typing.SupportsFloat | typing.SupportsIndex = 0.0, torque_residual: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def cutting_ratio(self) -> float:
        """
        [1] kappa
        """
    @cutting_ratio.setter
    def cutting_ratio(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def edge_identified(self) -> bool:
        """
        The tests differ enough in feed per turn and radius to tell edge from chip; otherwise p_e was taken as 0.
        """
    @edge_identified.setter
    def edge_identified(self, arg0: bool) -> None:
        ...
    @property
    def edge_pressure(self) -> float:
        """
        [Pa] p_e
        """
    @edge_pressure.setter
    def edge_pressure(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def specific_cutting_energy(self) -> float:
        """
        [J/m^3] u
        """
    @specific_cutting_energy.setter
    def specific_cutting_energy(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def thrust_residual(self) -> float:
        """
        [1] root mean square of (model - measured)/measured
        """
    @thrust_residual.setter
    def thrust_residual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def torque_residual(self) -> float:
        """
        [1]
        """
    @torque_residual.setter
    def torque_residual(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class AxialCutForce:
    """
    Steady thrust and torque of a flat head fed axially (C22).
    """
    def __repr__(self) -> str:
        ...
    @property
    def thrust(self) -> float:
        """
        [N]      pi R^2 p_e + 2 pi R u v_f/(kappa omega)
        """
    @property
    def torque(self) -> float:
        """
        [N·m]    (2 pi/3) kappa p_e R^3 + u pi R^2 v_f/omega
        """
class Gravity:
    """
    The weight of the virtual tool (thesis 5.9). The device's own stylus has a weight already: give the difference.

        F = m g,   T = (p_com - Ho) x F   about the handle's origin
    """
    def __copy__(self) -> Gravity:
        ...
    def __deepcopy__(self, memo: dict) -> Gravity:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, mass: typing.SupportsFloat | typing.SupportsIndex = 0.0, center_of_mass: numpy.typing.ArrayLike = ..., acceleration: numpy.typing.ArrayLike = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def acceleration(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m/s^2] in W: which way is down
        """
    @acceleration.setter
    def acceleration(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def center_of_mass(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] from Ho, in the handle's frame H
        """
    @center_of_mass.setter
    def center_of_mass(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def mass(self) -> float:
        """
        [kg] >= 0
        """
    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Vibration:
    """
    The vibration that the hand feels along the spindle's axis while the spinning head touches material (thesis 5.10).

        F = A sin(phase),  phase advances by 2 pi f dt a step
        A = min(amplitude + amplitude_per_watt P, largest_amplitude),   P: power of the spindle

    The thesis's sin(f t) shakes at f/2pi, and at 500 Hz sampled with 1 kHz sin(2 pi f t) is zero at every sample:
    hence the phase that is accumulated, and the bound on the frequency (D9).
    """
    def __copy__(self) -> Vibration:
        ...
    def __deepcopy__(self, memo: dict) -> Vibration:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, frequency: typing.SupportsFloat | typing.SupportsIndex = 150.0, amplitude: typing.SupportsFloat | typing.SupportsIndex = 0.3, amplitude_per_watt: typing.SupportsFloat | typing.SupportsIndex = 0.0, largest_amplitude: typing.SupportsFloat | typing.SupportsIndex = 0.5) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def amplitude(self) -> float:
        """
        [N] >= 0
        """
    @amplitude.setter
    def amplitude(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def amplitude_per_watt(self) -> float:
        """
        [N/W] >= 0
        """
    @amplitude_per_watt.setter
    def amplitude_per_watt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def frequency(self) -> float:
        """
        [Hz] > 0, below 0.45 of the update rate
        """
    @frequency.setter
    def frequency(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def largest_amplitude(self) -> float:
        """
        [N] >= amplitude
        """
    @largest_amplitude.setter
    def largest_amplitude(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class DeltaFilter:
    """
    The force filter of the thesis (Table 6.1), for comparison with it: the default is the slew limit.

        |F_previous - F_calculated| > delta:  F = F_previous + epsilon along the difference;  otherwise F = F_calculated

    The table adds the number epsilon to a vector; read as a step along the difference vector it keeps its direction and
    does not run away when the force is released. It still lags: epsilon a step whatever the rate, 3 N in half a second.
    """
    def __copy__(self) -> DeltaFilter:
        ...
    def __deepcopy__(self, memo: dict) -> DeltaFilter:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, delta: typing.SupportsFloat | typing.SupportsIndex = 0.5, epsilon: typing.SupportsFloat | typing.SupportsIndex = 0.005) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def delta(self) -> float:
        """
        [N] >= 0, largest change that passes unfiltered
        """
    @delta.setter
    def delta(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def epsilon(self) -> float:
        """
        [N] > 0, change per step otherwise; not more than delta
        """
    @epsilon.setter
    def epsilon(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class AxisMask:
    """
    Which components of the output are on (thesis Table 6.2, "Force & Torque Outputs"), in the axes of W.
    """
    def __copy__(self) -> AxisMask:
        ...
    def __deepcopy__(self, memo: dict) -> AxisMask:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, force: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"] = [True, True, True], torque: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"] = [True, True, True]) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def force(self) -> typing.Annotated[list[bool], "FixedSize(3)"]:
        ...
    @force.setter
    def force(self, arg0: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"]) -> None:
        ...
    @property
    def torque(self) -> typing.Annotated[list[bool], "FixedSize(3)"]:
        ...
    @torque.setter
    def torque(self, arg0: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"]) -> None:
        ...
class OutputLimits:
    """
    What the output may be and how fast it may grow. All unlimited by default: set them to what the device can do.
    """
    def __copy__(self) -> OutputLimits:
        ...
    def __deepcopy__(self, memo: dict) -> OutputLimits:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, largest_force: typing.SupportsFloat | typing.SupportsIndex = ..., *, largest_torque: typing.SupportsFloat | typing.SupportsIndex = ..., force_growth: typing.SupportsFloat | typing.SupportsIndex = ..., torque_growth: typing.SupportsFloat | typing.SupportsIndex = ..., ramp_time: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def force_growth(self) -> float:
        """
        [N/s] > 0; see least_force_growth
        """
    @force_growth.setter
    def force_growth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def largest_force(self) -> float:
        """
        [N] > 0
        """
    @largest_force.setter
    def largest_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def largest_torque(self) -> float:
        """
        [N·m] > 0
        """
    @largest_torque.setter
    def largest_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def ramp_time(self) -> float:
        """
        [s] >= 0 in which the output grows to its full size after the start, a jump or a reset
        """
    @ramp_time.setter
    def ramp_time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def torque_growth(self) -> float:
        """
        [N·m/s] > 0
        """
    @torque_growth.setter
    def torque_growth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Effects:
    """
    All effects, off by default.
    """
    delta_filter: DeltaFilter | None
    enabled: AxisMask
    gravity: Gravity | None
    limits: OutputLimits
    vibration: Vibration | None
    def __copy__(self) -> Effects:
        ...
    def __deepcopy__(self, memo: dict) -> Effects:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, gravity: Gravity | None = None, *, vibration: Vibration | None = None, delta_filter: DeltaFilter | None = None, enabled: AxisMask = ..., limits: OutputLimits = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
class EffectsInput:
    """
    What the effects need to know of a step.
    """
    def __copy__(self) -> EffectsInput:
        ...
    def __deepcopy__(self, memo: dict) -> EffectsInput:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, X_WH: numpy.typing.ArrayLike = ..., *, X_WT: numpy.typing.ArrayLike = ..., touching: bool = False, power: typing.SupportsFloat | typing.SupportsIndex = 0.0, dt: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def X_WH(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        of the handle
        """
    @X_WH.setter
    def X_WH(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def X_WT(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        of the head
        """
    @X_WT.setter
    def X_WT(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def dt(self) -> float:
        """
        [s]
        """
    @dt.setter
    def dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def power(self) -> float:
        """
        [W] of the spindle
        """
    @power.setter
    def power(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def touching(self) -> bool:
        """
        the head spins in material
        """
    @touching.setter
    def touching(self, arg0: bool) -> None:
        ...
class Output:
    """
    The effects from step to step, in their order: gravity, vibration, delta filter and mask; then, always last,
    saturation, growth limit and start-up ramp. What must come between, such as passivity control, acts on what
    ``add_effects`` returns.
    """
    def __init__(self) -> None:
        ...
    def add_effects(self, effects: Effects, at: EffectsInput, wrench: Wrench) -> Wrench:
        """
        Parameters
        ----------
        wrench
            about Ho, in W: force and torque of the model

        Returns
        -------
        about Ho, in W

        Notes
        -----
        Real time: no allocation, no lock; O(1)
        """
    def drop(self) -> None:
        """
        No output in this step: growth starts from zero again.
        """
    def limit(self, limits: OutputLimits, wrench: Wrench, dt: typing.SupportsFloat | typing.SupportsIndex) -> Wrench:
        """
        Saturation, growth limit and start-up ramp.
        """
    def restart(self) -> None:
        """
        The ramp starts again.
        """
class SimulationConfig:
    """
    How a simulation computes. Every field has a default that works; all are checked when the simulation is made.
    """
    handle_torque: HandleTorque
    quadrature: Quadrature
    removal: RemovalLaw
    def __copy__(self) -> SimulationConfig:
        ...
    def __deepcopy__(self, memo: dict) -> SimulationConfig:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, reference_stiffness: typing.SupportsFloat | typing.SupportsIndex = 10000000000000.0, *, removal: RemovalLaw = RemovalLaw.constant_energy, quadrature: Quadrature = Quadrature.centroid, law: ForceLaw | None = None, friction: DryFriction | None = None, deep_contact: bool = True, handle_torque: HandleTorque = HandleTorque.full_wrench, handle_torque_scale: typing.SupportsFloat | typing.SupportsIndex = 1.0, effects: Effects = ..., update_rate: typing.SupportsFloat | typing.SupportsIndex = 1000.0, reserved_blocks: typing.SupportsInt | typing.SupportsIndex = 2048, removed_voxel_capacity: typing.SupportsInt | typing.SupportsIndex = 0, voxel_budget: typing.SupportsInt | typing.SupportsIndex = 0, stage_times: bool = False, shortest_dt: typing.SupportsFloat | typing.SupportsIndex = 1e-06, longest_dt: typing.SupportsFloat | typing.SupportsIndex = 0.1, longest_sweep: typing.SupportsInt | typing.SupportsIndex = 64) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def deep_contact(self) -> bool:
        """
        a ball pushed beyond its radius keeps pushing back; see force/deep_contact.hpp
        """
    @deep_contact.setter
    def deep_contact(self, arg0: bool) -> None:
        ...
    @property
    def effects(self) -> Effects:
        """
        What is added to the model's force, and what the output is limited to.
        """
    @effects.setter
    def effects(self, arg0: Effects) -> None:
        ...
    @property
    def friction(self) -> DryFriction | None:
        """
        Dry friction of the standing head, the same everywhere; empty: each material's own.
        """
    @friction.setter
    def friction(self, arg0: DryFriction | None) -> None:
        ...
    @property
    def handle_torque_scale(self) -> float:
        """
        [1] finite: zeta of HandleTorque::thesis; no part of the full wrench
        """
    @handle_torque_scale.setter
    def handle_torque_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def law(self) -> ForceLaw | None:
        """
        The force law; null: FoundationLaw.
        """
    @law.setter
    def law(self, arg1: ForceLaw | None) -> None:
        ...
    @property
    def longest_dt(self) -> float:
        """
        [s]
        """
    @longest_dt.setter
    def longest_dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def longest_sweep(self) -> int:
        """
        A step that moves the head by more than half a voxel is cut into equal sub-steps; one that needs more than this
        many is a jump, not a motion, and is rejected.
        """
    @longest_sweep.setter
    def longest_sweep(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reference_stiffness(self) -> float:
        """
        [N/m^4] > 0, k_v of a material of relative stiffness 1. A regularisation, not a material constant: cutting forces
        do not depend on it while the engaged layer is thin. See force/stiffness.hpp for the bounds that accuracy and a
        directly driven device put on it.
        """
    @reference_stiffness.setter
    def reference_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def removed_voxel_capacity(self) -> int:
        """
        Longest list of removed voxels of one step; 0: as many as the head holds. Voxels beyond it are removed all the
        same.
        """
    @removed_voxel_capacity.setter
    def removed_voxel_capacity(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def reserved_blocks(self) -> int:
        """
        Blocks (8^3 voxels) that may become partly cut before ``Simulation::reserve_blocks`` has to be called again; about
        2.8 kB each. A cavity needs about two per patch of 8 x 8 voxels of its wall.
        """
    @reserved_blocks.setter
    def reserved_blocks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def shortest_dt(self) -> float:
        """
        [s] steps outside shortest_dt ... longest_dt are rejected
        """
    @shortest_dt.setter
    def shortest_dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stage_times(self) -> bool:
        """
        measure Simulation::stage_times
        """
    @stage_times.setter
    def stage_times(self, arg0: bool) -> None:
        ...
    @property
    def update_rate(self) -> float:
        """
        [Hz] > 0 at which the step will be called; only the vibration's check needs it
        """
    @update_rate.setter
    def update_rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def voxel_budget(self) -> int:
        """
        Most voxels that one sub-step may evaluate; 0: no limit. Where the head touches more, only every second (third
        ...) strip of 16 voxels is evaluated in a sub-step, in turn, and counts twice (three times ...): the deadline
        holds, the force is that of a coarser quadrature (below 7 % off, the just noticeable difference, for up to four
        turns while the head touches some thousand voxels), and StepStatus::detail_reduced says so. Only with the default
        law.
        """
    @voxel_budget.setter
    def voxel_budget(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class StepStatus:
    """
    What a step has to report, as bits; 0 = nothing. Each says what happened to the output, and the cure.

    Members:

      ok :

      pose_rejected : The pose held a number that is not finite, or no rotation. No force, workpiece untouched.
    Cure: check the device's matrix; re-orthonormalise it (``orthonormalized``) when it is only inexact.

      velocity_rejected : The velocity held a number that is not finite. No force, workpiece untouched. Cure: check the velocity estimate.

      dt_rejected : dt was not within SimulationConfig::shortest_dt ... longest_dt. No force, workpiece untouched.
    Cure: pass the seconds since the last call; after a pause call with a fresh pose and the nominal period.

      jump_rejected : The head moved farther than SimulationConfig::longest_sweep half voxels: a jump, not a motion. No force, workpiece
    untouched; the next step starts from this pose. Cure: bring the hand back smoothly, or raise longest_sweep.

      blocks_low : A quarter of the reserved blocks or fewer are left. Output unaffected. Cure: Simulation::reserve_blocks soon.

      blocks_exhausted : Some material was felt but not cut, because no reserved block was left. Cure: Simulation::reserve_blocks, outside
    the step; raise SimulationConfig::reserved_blocks.

      removed_list_full : More voxels were emptied than the list holds; they are gone and their volume is counted, but not all are listed.
    Cure: raise SimulationConfig::removed_voxel_capacity.

      power_limited : The spindle ran slower than its set speed, because the cut asked for more than its power limit.

      engaged_layer_thick : The spindle cuts with material deeper than a tenth of the head's radius below the cutting surface: the foundation
    is too soft for the feed, and forces come out low. Cure: raise SimulationConfig::reference_stiffness (with a
    virtual coupling, where a device must not feel it directly), or feed slower.

      vibration_left_out : The step was too long for the vibration's frequency, which was left out. Cure: call the step at
    SimulationConfig::update_rate, or lower Vibration::frequency.

      detail_reduced : The head touched more voxels than SimulationConfig::voxel_budget: only a part of them was evaluated, in turn with
    the others. Cure: larger voxels, a smaller head, or a larger budget.
    """
    __array_ufunc__ = None
    __members__: typing.ClassVar[dict[str, StepStatus]]
    blocks_exhausted: typing.ClassVar[StepStatus]
    blocks_low: typing.ClassVar[StepStatus]
    detail_reduced: typing.ClassVar[StepStatus]
    dt_rejected: typing.ClassVar[StepStatus]
    engaged_layer_thick: typing.ClassVar[StepStatus]
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
    """
    The material that the head touches, at the middle of the last sub-step.
    """
    def __repr__(self) -> str:
        ...
    @property
    def depth(self) -> float:
        """
        [m] greatest depth below the cutting surface
        """
    @property
    def volume(self) -> float:
        """
        [m^3] their filled volume
        """
    @property
    def voxels(self) -> int:
        """
        voxels inside the head that are not empty
        """
class SpindleState:
    """
    The spindle during the step.
    """
    def __repr__(self) -> str:
        ...
    @property
    def speed(self) -> float:
        """
        [rad/s] signed about +z of T
        """
    @property
    def torque(self) -> float:
        """
        [N·m] that the motor delivers, positive when it drives the spin
        """
class EnergyLedger:
    """
    Where the work went (model: energy ledger). Everything is accumulated since construction, but ``elastic`` and
    ``anchored``, which are the energies stored at the end of the last step. All in [J]; all losses are never negative.

        hand_work + motor_work + entered + credited
            = elastic + cutting + released + damping + rubbing + anchored + sliding
    """
    def __repr__(self) -> str:
        ...
    def closure(self) -> float:
        """
        [1] imbalance relative to what was turned over; 0 before any work.
        """
    def imbalance(self) -> float:
        """
        [J] what the right side lacks; 0 when the ledger closes.
        """
    @property
    def anchored(self) -> float:
        """
        stored in the anchor of dry friction now
        """
    @property
    def credited(self) -> float:
        """
        cutting energy of the last thousandth of a voxel, which is taken away without work
        """
    @property
    def cutting(self) -> float:
        """
        specific cutting energy times removed volume
        """
    @property
    def damping(self) -> float:
        """
        Hunt-Crossley damping
        """
    @property
    def elastic(self) -> float:
        """
        stored in the foundation now
        """
    @property
    def entered(self) -> float:
        """
        Elastic energy of material that came under the cutting surface without having been pressed there, less that of
        material that left it still pressed: where the tool appears out of nowhere, and where material passes a face
        behind which the depth does not begin at zero (the side of FlatRule::bottom_only, the base of a cone). Else zero
        within the error of the quadrature.
        """
    @property
    def hand_work(self) -> float:
        """
        work done by the hand on the tool
        """
    @property
    def motor_work(self) -> float:
        """
        work done by the spindle motor on the tool
        """
    @property
    def released(self) -> float:
        """
        elastic energy of removed material that did not help cutting
        """
    @property
    def rubbing(self) -> float:
        """
        tangential work where nothing is cut: below the edge pressure, or with removal off
        """
    @property
    def sliding(self) -> float:
        """
        dissipated by dry friction of the standing head
        """
class StepResult:
    """
    What one step returns. It owns what it holds and stays as it is when further steps are made.
    """
    def __repr__(self) -> str:
        ...
    @property
    def contact(self) -> Contact:
        """
        what the head touches
        """
    @property
    def energy(self) -> EnergyLedger:
        """
        accumulated since construction
        """
    @property
    def force(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [N] on the tool, what the hand feels, in W
        """
    @property
    def model(self) -> Wrench:
        """
        about Ho, in W: force and torque before effects and limits; mean over the step
        """
    @property
    def removed_materials(self) -> numpy.ndarray:
        """
        (n,) uint8: what each of the removed voxels was made of; read-only.
        """
    @property
    def removed_volume(self) -> float:
        """
        [m^3] taken away by this call, partly emptied voxels included
        """
    @property
    def removed_voxels(self) -> numpy.ndarray:
        """
        (n, 3) int32: indices of the voxels that this step emptied; read-only.
        """
    @property
    def spindle(self) -> SpindleState:
        """
        speed and torque of this step
        """
    @property
    def status(self) -> int:
        """
        Bits of StepStatus; 0 = nothing to report.
        """
    @property
    def sub_steps(self) -> int:
        """
        0 when the input was rejected
        """
    @property
    def torque(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [N·m] on the tool about Ho, in W
        """
class StageTimes:
    """
    [s] Wall time of the stages of one step, summed over its sub-steps; each is named like its stage (docs/step.md). All
    zero unless SimulationConfig::stage_times is set.
    """
    def __repr__(self) -> str:
        ...
    @property
    def add_effects(self) -> float:
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
    def evaluate_contact(self) -> float:
        ...
    @property
    def find_blocks(self) -> float:
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
    def remove_material(self) -> float:
        ...
    @property
    def transport_to_handle(self) -> float:
        ...
class WorstCase:
    """
    The most that a step may have to do, known at set-up: the work of a step is proportional to the voxels it evaluates.
    """
    def __repr__(self) -> str:
        ...
    @property
    def blocks(self) -> int:
        """
        blocks looked at in one sub-step
        """
    @property
    def level_of_detail(self) -> int:
        """
        1: every voxel in every sub-step; n: an n-th of them in turn
        """
    @property
    def sub_steps(self) -> int:
        """
        of the longest sweep that is not rejected
        """
    @property
    def voxels(self) -> int:
        """
        voxels evaluated in one sub-step, level of detail considered
        """
class Simulation:
    """
    A tool that a hand moves through a workpiece: the 1 kHz call and what it works on.

    Not thread-safe: one thread calls ``step``; everything else is called between steps.
    """
    def __init__(self, workpiece: Workpiece, tool: Tool, config: SimulationConfig = ...) -> None:
        """
        Works on a copy of the workpiece, and reserves all memory that cutting will need.

        Raises
        ------
        Error
            When the configuration is invalid, the workpiece is empty, or the head thinner than a voxel.
        """
    def changed_blocks(self) -> tuple[numpy.typing.NDArray[numpy.int32], bool]:
        """
        What the last step has changed: (n, 3) int32 first voxels of blocks, and whether that is all of them.
        """
    def reserve_blocks(self, count: typing.SupportsInt | typing.SupportsIndex) -> None:
        """
        Fills the pool of the workpiece up to ``count`` blocks.
        """
    def reset(self, workpiece: Workpiece) -> None:
        """
        Starts again with a copy of another workpiece: tool position, energies and removed volumes are forgotten.

        Raises
        ------
        Error
            When the workpiece is empty, or the head thinner than a voxel.
        """
    def restore(self, snapshot: WorkpieceSnapshot) -> None:
        """
        puts the workpiece back; the tool starts afresh
        """
    def run(self, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> numpy.ndarray:
        """
        Makes a step for every row, without the interpreter lock.

        Parameters
        ----------
        poses
            (n, 4, 4) float64, C-contiguous: X_WH at the end of each step.
        velocities
            (n, 6) float64, C-contiguous: [m/s] of Ho, then [rad/s], in W.
        dt
            [s] one number, or (n,) float64.

        Returns
        -------
        numpy.ndarray
            (n,) structured; the fields are those of StepResult: `trace["force"]` is (n, 3),
            `trace["energy"]["cutting"]` (n,); removed_voxels is their number, see removed_in_run; `time` [s] is
            that since the beginning of the run.

        Raises
        ------
        Error
            When an array has another shape or type, or holds a number that is not finite; nothing was simulated then.
            Whatever else is wrong with an input is reported by `status`, as step does.
        """
    def set_effects(self, effects: Effects) -> None:
        """
        Sets what is added to the model's force and what limits it, for the following steps.

        Raises
        ------
        Error
            Naming the field, its value and the allowed range; then nothing has changed
        """
    def set_spindle_speed(self, speed: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Sets the spindle's speed for the following steps; with Spindle::acceleration_limit it is reached on a ramp.

        Raises
        ------
        Error
            When it is not finite
        """
    def snapshot(self) -> WorkpieceSnapshot:
        """
        of the workpiece, to undo to
        """
    def step(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> StepResult:
        """
        Moves the tool to a pose, returns the force and torque on the hand, and takes away what the spindle cuts on the
        way.

        The head moves from where it was at the end of the last step to ``pose`` with constant velocity; in the first step
        it comes from ``pose - velocity * dt``.

        Parameters
        ----------
        pose
            X_WH, pose of the handle at the end of the step
        velocity
            [m/s] of Ho and [rad/s], in W, as the device estimates it; it drives the damping only, cutting
            and
            energies follow the poses
        dt
            [s] since the last call

        Returns
        -------
        a reference that stays valid; its contents are those of the last call

        Notes
        -----
        Real time: no allocation, no lock, no exception, no printing; same input, same bits. O(voxels inside the head)
        """
    def worst_case(self) -> WorstCase:
        """
        What a step may have to do at most.
        """
    @property
    def config(self) -> SimulationConfig:
        """
        As given; a copy.
        """
    @property
    def last_result(self) -> StepResult:
        """
        The result of the last step.
        """
    @property
    def removed_in_run(self) -> numpy.ndarray:
        """
        (n,) structured: step, index (3,) and material of every voxel that the last run emptied.
        """
    @property
    def removed_volume_by_material(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m^3] (256,) taken away since construction or reset, by material id.
        """
    @property
    def spindle_setting(self) -> float:
        """
        [rad/s] that was asked of the spindle last; while it ramps or is loaded its speed is StepResult::spindle.
        """
    @property
    def stage_times(self) -> StageTimes:
        """
        Of the last step; see SimulationConfig::stage_times.
        """
    @property
    def steps(self) -> int:
        """
        Calls of ``step`` since construction or ``reset``.
        """
    @property
    def tool(self) -> Tool:
        """
        As given.
        """
    @property
    def workpiece(self) -> Workpiece:
        """
        What is left: a look at it, not a copy. It cannot be changed from there.
        """
    @property
    def workpiece_exchanges(self) -> int:
        """
        How often ``restore`` and ``reset`` have exchanged the workpiece.
        """
class StepInput:
    """
    What the hand does in one step.
    """
    def __copy__(self) -> StepInput:
        ...
    def __deepcopy__(self, memo: dict) -> StepInput:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, pose: numpy.typing.ArrayLike = ..., velocity: numpy.typing.ArrayLike = ..., dt: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def dt(self) -> float:
        """
        [s]
        """
    @dt.setter
    def dt(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pose(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        X_WH at the end of the step
        """
    @pose.setter
    def pose(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        of Ho, in W
        """
    @velocity.setter
    def velocity(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class Scene:
    """
    A workpiece, a tool and a motion.
    """
    def input(self, tick: typing.SupportsInt | typing.SupportsIndex) -> StepInput:
        """
        what the hand does in step ``tick`` = 0, 1, 2 ...; endless
        """
    def make(self) -> Simulation:
        """
        builds it anew each time
        """
    @property
    def description(self) -> str:
        """
        one sentence
        """
    @property
    def name(self) -> str:
        """
        What find_scene is asked for.
        """
class VdbImport:
    """
    How a ``.vdb`` file of another program becomes a workpiece.
    """
    class Kind:
        """
        what its values mean

        Members:

          from_class :

          level_set :

          fog_volume :
        """
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
    def __init__(self, material: Material, grid: str = '', unit_mm: typing.SupportsFloat | typing.SupportsIndex = 1.0, kind: VdbImport.Kind = VdbImport.Kind.from_class) -> None:
        ...
    @property
    def grid(self) -> str:
        """
        name of the float grid; empty: the only float grid of the file
        """
    @grid.setter
    def grid(self, arg0: str) -> None:
        ...
    @property
    def kind(self) -> VdbImport.Kind:
        """
        What the grid's values mean.
        """
    @kind.setter
    def kind(self, arg0: VdbImport.Kind) -> None:
        ...
    @property
    def material(self) -> Material:
        """
        of everything inside
        """
    @material.setter
    def material(self, arg0: Material) -> None:
        ...
    @property
    def unit_mm(self) -> float:
        """
        [mm] length of one world unit of the file
        """
    @unit_mm.setter
    def unit_mm(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class NamedMesh:
    """
    One object of a mesh file.
    """
    @property
    def mesh(self) -> TriangleMesh:
        """
        The surface, in metres.
        """
    @property
    def name(self) -> str:
        """
        as in the file; may be empty
        """
class PictureOptions:
    """
    How a picture is taken. The camera is orthographic and frames all meshes.
    """
    background: Color
    def __copy__(self) -> PictureOptions:
        ...
    def __deepcopy__(self, memo: dict) -> PictureOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, width: typing.SupportsInt | typing.SupportsIndex = 1200, *, height: typing.SupportsInt | typing.SupportsIndex = 900, view_direction: numpy.typing.ArrayLike = ..., up: numpy.typing.ArrayLike = ..., background: Color = ..., scale_bar: bool = True) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def height(self) -> int:
        """
        [pixels] 16 ... 8192
        """
    @height.setter
    def height(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def scale_bar(self) -> bool:
        """
        a bar of 1, 2 or 5 times a power of ten millimetres, named below the picture's corner
        """
    @scale_bar.setter
    def scale_bar(self, arg0: bool) -> None:
        ...
    @property
    def up(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        points upwards in the picture; not along view_direction
        """
    @up.setter
    def up(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def view_direction(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        from the camera into the scene; any length > 0
        """
    @view_direction.setter
    def view_direction(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def width(self) -> int:
        """
        [pixels] 16 ... 8192
        """
    @width.setter
    def width(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class VolumeReadOptions:
    """
    """
    def __copy__(self) -> VolumeReadOptions:
        ...
    def __deepcopy__(self, memo: dict) -> VolumeReadOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, spacing: numpy.typing.ArrayLike | None = None, dicom_series: str = '') -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def dicom_series(self) -> str:
        """
        Series Instance UID, needed where a DICOM folder holds several series.
        """
    @dicom_series.setter
    def dicom_series(self, arg0: str) -> None:
        ...
    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64] | None:
        """
        [m] replaces the spacing of the file; needed where the file has none (PNG and TIFF slices).
        """
    @spacing.setter
    def spacing(self, arg0: numpy.typing.ArrayLike | None) -> None:
        ...
class ValueType:
    """
    How a file without a header stores its values.

    Members:

      uint8 :

      int8 :

      uint16 :

      int16 :

      uint32 :

      int32 :

      uint64 :

      int64 :

      float32 :

      float64 :
    """
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
    """
    What a headerless file does not say itself.
    """
    big_endian: bool
    type: ValueType
    def __copy__(self) -> RawLayout:
        ...
    def __deepcopy__(self, memo: dict) -> RawLayout:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, dims: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"] = [0, 0, 0], *, spacing: numpy.typing.ArrayLike = ..., type: ValueType = ValueType.uint8, big_endian: bool = False, skip: typing.SupportsInt | typing.SupportsIndex = 0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def dims(self) -> typing.Annotated[list[int], "FixedSize(3)"]:
        """
        number of samples along x (fastest), y, z
        """
    @dims.setter
    def dims(self, arg0: typing.Annotated[collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex], "FixedSize(3)"]) -> None:
        ...
    @property
    def skip(self) -> int:
        """
        bytes before the first value
        """
    @skip.setter
    def skip(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def spacing(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m]
        """
    @spacing.setter
    def spacing(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class LabelInterpolation:
    """
    Members:

      nearest : the label of the nearest sample: steps stay steps

      smooth : the label with the largest share in a Gaussian of half a spacing: rounds steps
    """
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
    """
    Why a device cannot be trusted, or cannot be driven, right now.

    Members:

      none :

      disconnected : it stopped answering: cable, power, permission. Ends the run

      uncalibrated : its position means nothing until it is calibrated or docked. No force

      motors_warm : the motors are too hot. The driver reduces or stops the force until they cool

      force_limit : the driver refused a force or its change as too large, and restarts its output gently

      speed_limit : the driver saw a motion that is too fast, and restarts its output gently

      overloaded : the servo loop took longer than its period

      driver_error : the driver refused a call that it should not refuse. Ends the run
    """
    __members__: typing.ClassVar[dict[str, DeviceFault]]
    disconnected: typing.ClassVar[DeviceFault]
    driver_error: typing.ClassVar[DeviceFault]
    force_limit: typing.ClassVar[DeviceFault]
    motors_warm: typing.ClassVar[DeviceFault]
    none: typing.ClassVar[DeviceFault]
    overloaded: typing.ClassVar[DeviceFault]
    speed_limit: typing.ClassVar[DeviceFault]
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
    """
    What a device can measure and render. Zero means that it has none or that nobody knows; a reason is in the
    documentation of the adapter.
    """
    def __copy__(self) -> DeviceCapabilities:
        ...
    def __deepcopy__(self, memo: dict) -> DeviceCapabilities:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, model: str = '', *, vendor: str = '', serial_number: str = '', driver_version: str = '', input_degrees_of_freedom: typing.SupportsInt | typing.SupportsIndex = 6, output_degrees_of_freedom: typing.SupportsInt | typing.SupportsIndex = 0, peak_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, continuous_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, peak_torque: typing.SupportsFloat | typing.SupportsIndex = 0.0, continuous_torque: typing.SupportsFloat | typing.SupportsIndex = 0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, rotational_stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, position_resolution: typing.SupportsFloat | typing.SupportsIndex = 0.0, workspace_low: numpy.typing.ArrayLike = ..., workspace_high: numpy.typing.ArrayLike = ..., rate: typing.SupportsFloat | typing.SupportsIndex = 1000.0, hard_realtime: bool = True) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def continuous_force(self) -> float:
        """
        [N] that the motors bear for ever
        """
    @continuous_force.setter
    def continuous_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def continuous_torque(self) -> float:
        """
        [N·m]
        """
    @continuous_torque.setter
    def continuous_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def damping(self) -> float:
        """
        [N·s/m] greatest that the maker promises to be stable
        """
    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def driver_version(self) -> str:
        """
        as the driver spells it
        """
    @driver_version.setter
    def driver_version(self, arg0: str) -> None:
        ...
    @property
    def hard_realtime(self) -> bool:
        """
        false where the transport gives no promise (TCP, a window toolkit)
        """
    @hard_realtime.setter
    def hard_realtime(self, arg0: bool) -> None:
        ...
    @property
    def input_degrees_of_freedom(self) -> int:
        """
        3: position, 6: position and orientation
        """
    @input_degrees_of_freedom.setter
    def input_degrees_of_freedom(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def model(self) -> str:
        """
        as the driver spells it
        """
    @model.setter
    def model(self, arg0: str) -> None:
        ...
    @property
    def output_degrees_of_freedom(self) -> int:
        """
        0: no force, 3: force, 6: force and torque
        """
    @output_degrees_of_freedom.setter
    def output_degrees_of_freedom(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def peak_force(self) -> float:
        """
        [N]
        """
    @peak_force.setter
    def peak_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def peak_torque(self) -> float:
        """
        [N·m]
        """
    @peak_torque.setter
    def peak_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def position_resolution(self) -> float:
        """
        [m]
        """
    @position_resolution.setter
    def position_resolution(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rate(self) -> float:
        """
        [Hz] of its servo loop
        """
    @rate.setter
    def rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rotational_stiffness(self) -> float:
        """
        [N·m/rad]
        """
    @rotational_stiffness.setter
    def rotational_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def serial_number(self) -> str:
        """
        as the driver spells it
        """
    @serial_number.setter
    def serial_number(self, arg0: str) -> None:
        ...
    @property
    def stiffness(self) -> float:
        """
        [N/m] greatest that the maker promises to be stable
        """
    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def vendor(self) -> str:
        """
        as the driver spells it
        """
    @vendor.setter
    def vendor(self, arg0: str) -> None:
        ...
    @property
    def workspace_high(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] the opposite corner; equal to workspace_low when unknown
        """
    @workspace_high.setter
    def workspace_high(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def workspace_low(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        [m] corner of the largest box the stylus can reach, in B
        """
    @workspace_low.setter
    def workspace_low(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class DeviceState:
    """
    One reading of a device.
    """
    fault: DeviceFault
    def __copy__(self) -> DeviceState:
        ...
    def __deepcopy__(self, memo: dict) -> DeviceState:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, X_BS: numpy.typing.ArrayLike = ..., *, velocity: numpy.typing.ArrayLike = ..., buttons: typing.SupportsInt | typing.SupportsIndex = 0, time: typing.SupportsFloat | typing.SupportsIndex = 0.0, sequence: typing.SupportsInt | typing.SupportsIndex = 0, epoch: typing.SupportsInt | typing.SupportsIndex = 0, temperature: typing.SupportsFloat | typing.SupportsIndex = 0.0, valid: bool = True, fault: DeviceFault = DeviceFault.none) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    def pressed(self, button: typing.SupportsInt | typing.SupportsIndex) -> bool:
        """
        Whether a button is pressed.
        """
    @property
    def X_BS(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the stylus in the base
        """
    @X_BS.setter
    def X_BS(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def buttons(self) -> int:
        """
        bit n: button n is pressed
        """
    @buttons.setter
    def buttons(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def epoch(self) -> int:
        """
        changes when poses before and after do not compare: calibration, reconnection
        """
    @epoch.setter
    def epoch(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def sequence(self) -> int:
        """
        grows by one with every new reading; the same number twice is the same reading
        """
    @sequence.setter
    def sequence(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def temperature(self) -> float:
        """
        [1] of the hottest motor, 0 cold ... 1 too hot; 0 when not measured
        """
    @temperature.setter
    def temperature(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def time(self) -> float:
        """
        [s] of the reading, from the device's own clock, since the run began
        """
    @time.setter
    def time(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def valid(self) -> bool:
        """
        false: the pose means nothing
        """
    @valid.setter
    def valid(self, arg0: bool) -> None:
        ...
    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        of the stylus point, in B; an estimate, smoothed and therefore late
        """
    @velocity.setter
    def velocity(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
class DeviceCommand:
    """
    What the user's code wants of the device until its next call.
    """
    def __copy__(self) -> DeviceCommand:
        ...
    def __deepcopy__(self, memo: dict) -> DeviceCommand:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, wrench: Wrench = ..., stop: bool = False) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def stop(self) -> bool:
        """
        end the run after this tick
        """
    @stop.setter
    def stop(self, arg0: bool) -> None:
        ...
    @property
    def wrench(self) -> Wrench:
        """
        [N], [N·m] on the stylus, torque about the stylus point, in B
        """
    @wrench.setter
    def wrench(self, arg0: Wrench) -> None:
        ...
class OutputLimit:
    """
    What was done to a commanded wrench before it reached the motors, as bits.

    Members:

      none :

      held_back : not yet armed, or in the fault state: no force

      ramped : the force is being faded in

      saturated : longer than the device's peak, shortened without turning it

      slew_limited : grew faster than allowed

      cooled : shortened to let the motors cool

      damped : the passivity controller took energy out

      not_finite : the commanded wrench was not finite

      no_actuator : the device has no motors for the torque, or for any of it

      by_driver : the driver applied something else than it was given
    """
    __array_ufunc__ = None
    __members__: typing.ClassVar[dict[str, OutputLimit]]
    by_driver: typing.ClassVar[OutputLimit]
    cooled: typing.ClassVar[OutputLimit]
    damped: typing.ClassVar[OutputLimit]
    held_back: typing.ClassVar[OutputLimit]
    no_actuator: typing.ClassVar[OutputLimit]
    none: typing.ClassVar[OutputLimit]
    not_finite: typing.ClassVar[OutputLimit]
    ramped: typing.ClassVar[OutputLimit]
    saturated: typing.ClassVar[OutputLimit]
    slew_limited: typing.ClassVar[OutputLimit]
    def __and__(self, other: typing.Any) -> typing.Any:
        ...
    @typing.overload
    def __eq__(self, other: OutputLimit) -> bool:
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
    def __ne__(self, other: OutputLimit) -> bool:
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
    """
    The two sides of the last tick's output.
    """
    @property
    def applied(self) -> Wrench:
        """
        what the motors got
        """
    @property
    def commanded(self) -> Wrench:
        """
        what the user's code asked for
        """
    @property
    def limits(self) -> int:
        """
        Bits of OutputLimit: why they differ.
        """
class ArmingState:
    """
    Whether a force is allowed.

    Members:

      off : before the run and after it: no force

      armed : the run has begun; waiting for valid readings: no force

      wait_free : waiting until the model asks for no force, that is until the tool touches nothing: no force

      ramp : the force is faded in

      on : the full force

      fault : latched until reset: no force
    """
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
    """
    What the safety pipeline can have to say. Names are those of the enumerators.

    Members:

      pose_not_finite : a reading held a number that is not finite; the last good pose is held

      pose_not_a_rotation : a reading's rotation was none; the last good pose is held

      pose_outside_workspace : a reading was outside of what the device can reach; the last good pose is held

      pose_jump : a reading was farther away than a hand can move; the last good pose is held

      pose_turn_jump : a reading was turned more than a hand can turn; the last good pose is held

      pose_frozen : the position stands still bit by bit while the stylus turns or reports a speed

      pose_units : positions of a size that suggests other units than metres

      reading_invalid : the driver itself calls its reading invalid

      reading_stale : the driver returned the same reading again

      armed : the device is ready; waiting for valid readings

      waiting_free : waiting until the tool touches nothing

      start_inside : the tool began inside the material; no force until it is pulled out

      fading_in : free: the force is allowed, and faded in

      engaged : the full force is allowed

      fault : latched; no force until ``reset``

      fault_reset : somebody reset the fault

      recalibrated : poses before and after do not compare: calibration or reconnection

      reclutched : the mapping between hand and tool changed

      model_swapped : the workpiece or the tool was exchanged

      late_wake_up : a tick came more than 5 ms late

      paused : a tick came more than 20 ms late: a debugger, a suspended machine

      force_not_finite : the model's wrench was not finite

      passivity : the passivity controller took energy out

      saturated : the wrench was longer than the device's peak

      slew_limited : the wrench grew faster than allowed

      continuous_limited : the motors would become too warm

      motors_warm : the device reports warm motors

      device_fault : the device reports a fault; the value is its number

      watchdog_late : the model did not answer for 3 ticks

      watchdog_fading : ... for 10 ticks: its last force is faded out

      watchdog_fault : ... for 50 ticks

      exception : the user's code threw

      emergency_stop : somebody pulled the emergency stop
    """
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
    """
    One entry: an event that began.
    """
    @property
    def event(self) -> SafetyEvent:
        """
        What began.
        """
    @property
    def sequence(self) -> int:
        """
        of the reading
        """
    @property
    def time(self) -> float:
        """
        [s] of the reading
        """
    @property
    def value(self) -> float:
        """
        what was measured, in the unit of the event: metres, newtons, seconds, or a number
        """
class PoseGateOptions:
    """
    What a reading must be to be believed.
    """
    def __copy__(self) -> PoseGateOptions:
        ...
    def __deepcopy__(self, memo: dict) -> PoseGateOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, fastest: typing.SupportsFloat | typing.SupportsIndex = 2.0, *, fastest_turn: typing.SupportsFloat | typing.SupportsIndex = 30.0, workspace_margin: typing.SupportsFloat | typing.SupportsIndex = 0.05, rotation_tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.001, hold_ticks: typing.SupportsInt | typing.SupportsIndex = 20, frozen_ticks: typing.SupportsInt | typing.SupportsIndex = 40, frozen_turn: typing.SupportsFloat | typing.SupportsIndex = 0.1, frozen_speed: typing.SupportsFloat | typing.SupportsIndex = 0.005) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def fastest(self) -> float:
        """
        [m/s] > 0; a hand with a stylus reaches 1 to 2
        """
    @fastest.setter
    def fastest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fastest_turn(self) -> float:
        """
        [rad/s] > 0
        """
    @fastest_turn.setter
    def fastest_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def frozen_speed(self) -> float:
        """
        [m/s] reported speed that contradicts a position that stands still
        """
    @frozen_speed.setter
    def frozen_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def frozen_ticks(self) -> int:
        """
        ticks of a position that stands still bit by bit while others move
        """
    @frozen_ticks.setter
    def frozen_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def frozen_turn(self) -> float:
        """
        [rad] within 0.1 s that contradict a position that stands still
        """
    @frozen_turn.setter
    def frozen_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def hold_ticks(self) -> int:
        """
        bad readings in a row after which the gate gives up
        """
    @hold_ticks.setter
    def hold_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def rotation_tolerance(self) -> float:
        """
        [1] of the entries of R R^T - 1; inexact ones are made exact
        """
    @rotation_tolerance.setter
    def rotation_tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def workspace_margin(self) -> float:
        """
        [m] beyond the device's own box that is still believed
        """
    @workspace_margin.setter
    def workspace_margin(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ArmingOptions:
    """
    When a force is allowed, and how it begins.
    """
    def __copy__(self) -> ArmingOptions:
        ...
    def __deepcopy__(self, memo: dict) -> ArmingOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, valid_ticks: typing.SupportsInt | typing.SupportsIndex = 10, *, free_force: typing.SupportsFloat | typing.SupportsIndex = 0.2, free_torque: typing.SupportsFloat | typing.SupportsIndex = 0.02, free_ticks: typing.SupportsInt | typing.SupportsIndex = 4, ramp: typing.SupportsFloat | typing.SupportsIndex = 1.5, short_ramp: typing.SupportsFloat | typing.SupportsIndex = 0.25) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def free_force(self) -> float:
        """
        [N] below which the tool counts as free
        """
    @free_force.setter
    def free_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def free_ticks(self) -> int:
        """
        [ticks] in a row that the tool must be free
        """
    @free_ticks.setter
    def free_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def free_torque(self) -> float:
        """
        [N·m]
        """
    @free_torque.setter
    def free_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def ramp(self) -> float:
        """
        [s] over which the first force is faded in
        """
    @ramp.setter
    def ramp(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def short_ramp(self) -> float:
        """
        [s] after a late tick, a clutch or another interruption that everybody knows of
        """
    @short_ramp.setter
    def short_ramp(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def valid_ticks(self) -> int:
        """
        [ticks] of accepted readings in a row before the device counts as ready
        """
    @valid_ticks.setter
    def valid_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class PassivityOptions:
    """
    How the passivity controller watches. Energies in [J], for the translation; the rotation has its own instance.
    """
    enabled: bool
    def __copy__(self) -> PassivityOptions:
        ...
    def __deepcopy__(self, memo: dict) -> PassivityOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, enabled: bool = True, *, credit: typing.SupportsFloat | typing.SupportsIndex = 0.005, allowance: typing.SupportsFloat | typing.SupportsIndex = 0.0, greatest: typing.SupportsFloat | typing.SupportsIndex = 0.0, greatest_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, slowest: typing.SupportsFloat | typing.SupportsIndex = 1e-06, free: typing.SupportsFloat | typing.SupportsIndex = 0.001, delay: typing.SupportsInt | typing.SupportsIndex = 0, free_ticks: typing.SupportsInt | typing.SupportsIndex = 20) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def allowance(self) -> float:
        """
        [J] that the model may generate, for a device whose own friction takes it
        """
    @allowance.setter
    def allowance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def credit(self) -> float:
        """
        [J] that the model may have absorbed and give back later: more is forgotten
        """
    @credit.setter
    def credit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def delay(self) -> int:
        """
        [ticks] 0 ... 8 between a written force and the one that acts, beyond the hold
        """
    @delay.setter
    def delay(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def free(self) -> float:
        """
        [N or N·m] a shorter force counts as none
        """
    @free.setter
    def free(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def free_ticks(self) -> int:
        """
        without a force after which the account is closed
        """
    @free_ticks.setter
    def free_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def greatest(self) -> float:
        """
        [N or N·m] of the damping; 0: the device's peak
        """
    @greatest.setter
    def greatest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def greatest_damping(self) -> float:
        """
        [N·s/m or N·m·s/rad] of the damping at most; 0: no bound. Without one, a force of any size answers the smallest
        motion. SafetyGuard fills in what the device can render.
        """
    @greatest_damping.setter
    def greatest_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def slowest(self) -> float:
        """
        [m/s or rad/s] below which nothing is damped
        """
    @slowest.setter
    def slowest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ThermalOptions:
    """
    When the motors count as too warm.
    """
    def __copy__(self) -> ThermalOptions:
        ...
    def __deepcopy__(self, memo: dict) -> ThermalOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, time_constant: typing.SupportsFloat | typing.SupportsIndex = 60.0, *, warm: typing.SupportsFloat | typing.SupportsIndex = 1.0, cool: typing.SupportsFloat | typing.SupportsIndex = 0.8, hot: typing.SupportsFloat | typing.SupportsIndex = 0.7, cold: typing.SupportsFloat | typing.SupportsIndex = 0.5, rate: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def cold(self) -> float:
        """
        [1] at which it may grow again
        """
    @cold.setter
    def cold(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def cool(self) -> float:
        """
        [1] at which it may grow again
        """
    @cool.setter
    def cool(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def hot(self) -> float:
        """
        [1] of a measured temperature at which the force is reduced
        """
    @hot.setter
    def hot(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rate(self) -> float:
        """
        [1/s] at which the limit shrinks and grows: 0.001 a tick at 1 kHz
        """
    @rate.setter
    def rate(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def time_constant(self) -> float:
        """
        [s] > 0 over which the mean of the squared force is taken
        """
    @time_constant.setter
    def time_constant(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def warm(self) -> float:
        """
        [1] of the continuous force squared at which the force is reduced
        """
    @warm.setter
    def warm(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class WatchdogOptions:
    """
    How long a force may live without a new one.
    """
    def __copy__(self) -> WatchdogOptions:
        ...
    def __deepcopy__(self, memo: dict) -> WatchdogOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, period: typing.SupportsFloat | typing.SupportsIndex = 0.001, *, late_ticks: typing.SupportsInt | typing.SupportsIndex = 3, fade_ticks: typing.SupportsInt | typing.SupportsIndex = 10, fade: typing.SupportsFloat | typing.SupportsIndex = 0.03, fault_ticks: typing.SupportsInt | typing.SupportsIndex = 50) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def fade(self) -> float:
        """
        [s] of the fading
        """
    @fade.setter
    def fade(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def fade_ticks(self) -> int:
        """
        after which the last force is faded out
        """
    @fade_ticks.setter
    def fade_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def fault_ticks(self) -> int:
        """
        after which it is a fault
        """
    @fault_ticks.setter
    def fault_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def late_ticks(self) -> int:
        """
        after which it is reported
        """
    @late_ticks.setter
    def late_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s] > 0 of a tick
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class GuardOptions:
    """
    The settings of every stage of the safety pipeline. The defaults suit a device of its capabilities.
    """
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
    def __init__(self, gate: PoseGateOptions = ..., *, arming: ArmingOptions = ..., passivity: PassivityOptions = ..., thermal: ThermalOptions = ..., watchdog: WatchdogOptions = ..., period: typing.SupportsFloat | typing.SupportsIndex = 0.001, greatest_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, greatest_torque: typing.SupportsFloat | typing.SupportsIndex = 0.0, slew: typing.SupportsFloat | typing.SupportsIndex = 0.0, torque_slew: typing.SupportsFloat | typing.SupportsIndex = 0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, fastest_contact: typing.SupportsFloat | typing.SupportsIndex = 0.5, ramp_damping: typing.SupportsFloat | typing.SupportsIndex = -1.0, late: typing.SupportsFloat | typing.SupportsIndex = 0.005, pause: typing.SupportsFloat | typing.SupportsIndex = 0.02, not_finite_ticks: typing.SupportsInt | typing.SupportsIndex = 3) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def fastest_contact(self) -> float:
        """
        [m/s] at which a surface is met
        """
    @fastest_contact.setter
    def fastest_contact(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def greatest_force(self) -> float:
        """
        [N] of the output; 0: the device's peak; never more than it
        """
    @greatest_force.setter
    def greatest_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def greatest_torque(self) -> float:
        """
        [N·m] of the output; 0: the device's peak; never more than it
        """
    @greatest_torque.setter
    def greatest_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def late(self) -> float:
        """
        [s] a tick that comes later than this needs a free tool again
        """
    @late.setter
    def late(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def not_finite_ticks(self) -> int:
        """
        [ticks] in a row of a wrench that is not finite before the fault
        """
    @not_finite_ticks.setter
    def not_finite_ticks(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def pause(self) -> float:
        """
        [s] ... and, later than this, the long fade-in
        """
    @pause.setter
    def pause(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s] > 0 of a tick
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def ramp_damping(self) -> float:
        """
        [N·s/m] while the force fades in; < 0: a fifth of what the device promises
        """
    @ramp_damping.setter
    def ramp_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def slew(self) -> float:
        """
        [N/s] by which the force may grow; 0: 1.25 x stiffness x fastest_contact
        """
    @slew.setter
    def slew(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stiffness(self) -> float:
        """
        [N/m] that the device feels, scales included; 0: what the device promises
        """
    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def torque_slew(self) -> float:
        """
        [N·m/s]; 0: as long to the peak as for the force
        """
    @torque_slew.setter
    def torque_slew(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class SafetyGuard:
    """
    The safety pipeline between a device and whatever computes its force. Always on; every stage can only take force
    away (or, damping, oppose the motion).

    Per tick: ``admit`` the reading, compute with what it returns, ``release`` the wrench. Its stages, in order: time and
    missed ticks, pose gate, arming, finite check, passivity, saturation, thermal budget, growth-only slew limit,
    fade-in, last finite check.

    ``admit``, ``release`` and ``applied`` belong to the thread of the loop; the rest may be called from any thread.
    """
    def __init__(self, capabilities: DeviceCapabilities, options: GuardOptions = ...) -> None:
        """
        Raises
        ------
        Error
            When an option is out of range, or the slew limit would make the contact active
        """
    def admit(self, reading: DeviceState) -> DeviceState:
        """
        Judges a reading and returns the one to compute with: ``valid`` is false when there is none, its velocity zero when
        the pose is held.

        Notes
        -----
        Real time: no allocation, no lock
        """
    def applied(self, wrench: Wrench) -> None:
        """
        What the device did render, when that is something else than ``release`` returned.
        """
    def count(self, event: SafetyEvent) -> int:
        """
        How many ticks reported the event.
        """
    def drain_log(self) -> list[SafetyLogEntry]:
        """
        Takes the entries out of the log, oldest first.
        """
    def emergency_stop(self) -> None:
        """
        No force from the next tick on, until ``reset``.
        """
    def interrupt(self, reason: SafetyEvent) -> None:
        """
        Asks to wait until the tool is free: to be called when the mapping from hand to tool has changed (``reclutched``) or
        another workpiece or tool is in place (``model_swapped``).
        """
    def release(self, commanded: Wrench) -> Wrench:
        """
        Turns the wrench that the model asks for into the one that the device may render.

        Notes
        -----
        Real time: no allocation, no lock
        """
    def reset(self) -> None:
        """
        Asks to leave the fault state; the tool must then be free before there is a force again.
        """
    def start(self) -> None:
        """
        Begins a run: armed, nothing remembered.
        """
    def stop(self) -> None:
        """
        Ends a run: no force from here on.
        """
    @property
    def greatest_force(self) -> float:
        """
        [N] in force
        """
    @property
    def output(self) -> DeviceOutput:
        """
        Both sides of the last tick.
        """
    @property
    def slew(self) -> float:
        """
        [N/s] in force
        """
    @property
    def state(self) -> ArmingState:
        """
        Whether a force is allowed.
        """
class RealtimeOptions:
    """
    How a thread is made fit for a 1 kHz loop.
    """
    def __copy__(self) -> RealtimeOptions:
        ...
    def __deepcopy__(self, memo: dict) -> RealtimeOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, priority: typing.SupportsInt | typing.SupportsIndex = 80, *, lock_memory: bool = True, flush_denormals: bool = True, cpu: typing.SupportsInt | typing.SupportsIndex = -1, stack: typing.SupportsInt | typing.SupportsIndex = 262144) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def cpu(self) -> int:
        """
        the only processor that the thread may use; -1: any
        """
    @cpu.setter
    def cpu(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def flush_denormals(self) -> bool:
        """
        numbers below 1e-308 count as zero: they are slow and mean nothing here
        """
    @flush_denormals.setter
    def flush_denormals(self, arg0: bool) -> None:
        ...
    @property
    def lock_memory(self) -> bool:
        """
        keep the process in memory, and let malloc give nothing back
        """
    @lock_memory.setter
    def lock_memory(self, arg0: bool) -> None:
        ...
    @property
    def priority(self) -> int:
        """
        [1 ... 99] of SCHED_FIFO; 0: leave the scheduler as it is
        """
    @priority.setter
    def priority(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def stack(self) -> int:
        """
        [bytes] of the stack that are touched in advance
        """
    @stack.setter
    def stack(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class LatencyHistogram:
    """
    How often a duration was seen, in buckets of 1 us up to 2 ms, and what was longer.

    Notes
    -----
    Real time: adding allocates nothing, takes no lock
    """
    def __init__(self) -> None:
        ...
    def add(self, seconds: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        Parameters
        ----------
        seconds
            [s] >= 0; what is not a number counts as longer than all buckets
        """
    def quantile(self, share: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [s] the upper edge of the bucket below which a share of all durations lies; the maximum where that is among the
        longer ones.

        Parameters
        ----------
        share
            [1] 0 ... 1
        """
    @property
    def buckets(self) -> numpy.typing.NDArray[numpy.uint64]:
        """
        (2000,) uint64: how many durations fell into each bucket of 1 us.
        """
    @property
    def count(self) -> int:
        """
        How many durations were added.
        """
    @property
    def longer(self) -> int:
        """
        than all buckets
        """
    @property
    def max(self) -> float:
        """
        [s]
        """
    @property
    def mean(self) -> float:
        """
        [s]
        """
    @property
    def min(self) -> float:
        """
        [s]
        """
class DeviceModel:
    """
    A device as mechanics sees it, the same along every axis: an apparent mass at the tip with viscous and dry friction,
    read through an encoder.
    """
    def __copy__(self) -> DeviceModel:
        ...
    def __deepcopy__(self, memo: dict) -> DeviceModel:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, name: str = '', *, mass: typing.SupportsFloat | typing.SupportsIndex = 0.0, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, dry_friction: typing.SupportsFloat | typing.SupportsIndex = 0.0, encoder_step: typing.SupportsFloat | typing.SupportsIndex = 0.0, peak_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, continuous_force: typing.SupportsFloat | typing.SupportsIndex = 0.0, rendered_stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, rendered_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, rotational_inertia: typing.SupportsFloat | typing.SupportsIndex = 2e-05, rotational_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0002, peak_torque: typing.SupportsFloat | typing.SupportsIndex = 0.0, workspace_half_width: typing.SupportsFloat | typing.SupportsIndex = 0.08) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def continuous_force(self) -> float:
        """
        [N]
        """
    @continuous_force.setter
    def continuous_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def damping(self) -> float:
        """
        [N·s/m]
        """
    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def dry_friction(self) -> float:
        """
        [N] Coulomb
        """
    @dry_friction.setter
    def dry_friction(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def encoder_step(self) -> float:
        """
        [m]
        """
    @encoder_step.setter
    def encoder_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mass(self) -> float:
        """
        [kg] apparent at the tip
        """
    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def name(self) -> str:
        """
        what ``device_model`` is asked for
        """
    @name.setter
    def name(self, arg1: str) -> None:
        ...
    @property
    def peak_force(self) -> float:
        """
        [N]
        """
    @peak_force.setter
    def peak_force(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def peak_torque(self) -> float:
        """
        [N·m] 0: the gimbal has no motors
        """
    @peak_torque.setter
    def peak_torque(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rendered_damping(self) -> float:
        """
        [N·s/m] greatest that it is said to render
        """
    @rendered_damping.setter
    def rendered_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rendered_stiffness(self) -> float:
        """
        [N/m] greatest that it is said to render
        """
    @rendered_stiffness.setter
    def rendered_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rotational_damping(self) -> float:
        """
        [N·m·s/rad]
        """
    @rotational_damping.setter
    def rotational_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rotational_inertia(self) -> float:
        """
        [kg·m^2] of the gimbal
        """
    @rotational_inertia.setter
    def rotational_inertia(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def workspace_half_width(self) -> float:
        """
        [m] of the cube around the origin
        """
    @workspace_half_width.setter
    def workspace_half_width(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class HandModel:
    """
    A hand: a mass on a spring and a damper to where it wants to be. Bonded to the stylus (``pad_stiffness`` 0), or behind
    the soft pad of the fingers.
    """
    def __copy__(self) -> HandModel:
        ...
    def __deepcopy__(self, memo: dict) -> HandModel:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, name: str = '', *, mass: typing.SupportsFloat | typing.SupportsIndex = 0.0, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, pad_stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, pad_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, inertia: typing.SupportsFloat | typing.SupportsIndex = 0.0, angular_damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, angular_stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def angular_damping(self) -> float:
        """
        [N·m·s/rad]
        """
    @angular_damping.setter
    def angular_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def angular_stiffness(self) -> float:
        """
        [N·m/rad] towards the orientation of the set point
        """
    @angular_stiffness.setter
    def angular_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def damping(self) -> float:
        """
        [N·s/m]
        """
    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def inertia(self) -> float:
        """
        [kg·m^2] that the fingers add to the gimbal
        """
    @inertia.setter
    def inertia(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def mass(self) -> float:
        """
        [kg]
        """
    @mass.setter
    def mass(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def name(self) -> str:
        """
        what ``hand_model`` is asked for
        """
    @name.setter
    def name(self, arg1: str) -> None:
        ...
    @property
    def pad_damping(self) -> float:
        """
        [N·s/m]
        """
    @pad_damping.setter
    def pad_damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def pad_stiffness(self) -> float:
        """
        [N/m] between stylus and hand; 0: bonded
        """
    @pad_stiffness.setter
    def pad_stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stiffness(self) -> float:
        """
        [N/m] towards the set point
        """
    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class RunOptions:
    """
    How a run goes.
    """
    def __copy__(self) -> RunOptions:
        ...
    def __deepcopy__(self, memo: dict) -> RunOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, seconds: typing.SupportsFloat | typing.SupportsIndex = 0.0, *, simulated_time: bool = False, stop_on_signals: bool = True, realtime: RealtimeOptions = ..., guard: GuardOptions = ...) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def guard(self) -> GuardOptions:
        """
        the safety pipeline; it cannot be switched off
        """
    @guard.setter
    def guard(self, arg0: GuardOptions) -> None:
        ...
    @property
    def realtime(self) -> RealtimeOptions:
        """
        for devices whose loop runs in our thread
        """
    @realtime.setter
    def realtime(self, arg0: RealtimeOptions) -> None:
        ...
    @property
    def seconds(self) -> float:
        """
        [s] of device time after which it ends; 0: when it is stopped
        """
    @seconds.setter
    def seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def simulated_time(self) -> bool:
        """
        devices that are simulated: as fast as the callback allows, with exact periods
        """
    @simulated_time.setter
    def simulated_time(self, arg0: bool) -> None:
        ...
    @property
    def stop_on_signals(self) -> bool:
        """
        SIGINT, SIGTERM and SIGHUP end the run without force, then act as they would
        """
    @stop_on_signals.setter
    def stop_on_signals(self, arg0: bool) -> None:
        ...
class RunReport:
    """
    What a run was like.
    """
    def __repr__(self) -> str:
        ...
    @property
    def compute(self) -> LatencyHistogram:
        """
        the callback and the guard
        """
    @property
    def end(self) -> str:
        """
        why it ended, in words
        """
    @property
    def events(self) -> dict:
        """
        dict from the name of a SafetyEvent to the number of ticks that reported it.
        """
    @property
    def fault(self) -> DeviceFault:
        """
        that ended it
        """
    @property
    def guard(self) -> ArmingState:
        """
        the state of the guard when it ended
        """
    @property
    def log(self) -> list[SafetyLogEntry]:
        """
        entries that nobody took during the run
        """
    @property
    def missed(self) -> int:
        """
        ticks that were skipped because the loop was late
        """
    @property
    def ticks(self) -> int:
        ...
    @property
    def wake_up(self) -> LatencyHistogram:
        """
        how late the ticks began; of a driver's own loop: deviation of the period
        """
    @property
    def warnings(self) -> list[str]:
        """
        what was not permitted, and what the driver complained about
        """
class Device:
    """
    A haptic device, or something that stands for one.

    ``run`` drives the loop. Where the driver has its own servo thread (OpenHaptics) the callback runs there; for all
    other devices it runs in the thread that called ``run``. The callback cannot tell the difference, and the safety guard
    stands between it and the motors in both.

    ``run`` belongs to one thread; everything else may be called from any thread, also while it runs.
    """
    def count(self, event: SafetyEvent) -> int:
        """
        How many ticks of the run reported an event.
        """
    def drain_log(self) -> list[SafetyLogEntry]:
        """
        Takes the entries of the safety log; empty before the first run.
        """
    def emergency_stop(self) -> None:
        """
        No force from the next tick on, until ``reset_fault``. The run goes on. Safe in a signal handler.
        """
    def interrupt(self, reason: SafetyEvent) -> None:
        """
        Asks the guard to wait until the tool is free, because something changed under the hand.

        Parameters
        ----------
        reason
            reclutched or model_swapped
        """
    def reset_fault(self) -> None:
        """
        Asks the guard to leave its fault state. The tool must then be free before there is a force again.
        """
    def run(self, callback: collections.abc.Callable[[DeviceState], DeviceCommand], options: RunOptions = ...) -> RunReport:
        """
        Runs until ``stop``, until the callback asks for it, until RunOptions::seconds are over, or until the device is
        lost. The motors have got a zero force before it returns, whatever happens.

        Raises
        ------
        Error
            When an option is out of range or the device cannot be started, and what the callback threw
        """
    def stop(self) -> None:
        """
        Ends the run after fading the force out. Safe in a signal handler.
        """
    @property
    def arming(self) -> ArmingState:
        """
        Whether a force is allowed.
        """
    @property
    def capabilities(self) -> DeviceCapabilities:
        """
        What it can measure and render.
        """
    @property
    def is_running(self) -> bool:
        """
        Whether a run is under way.
        """
    @property
    def name(self) -> str:
        """
        what it was opened as
        """
    @property
    def output(self) -> DeviceOutput:
        """
        What was commanded and what was applied in the last tick, and why they differ.
        """
    @property
    def state(self) -> DeviceState:
        """
        The last reading that the guard let through.
        """
class MockOptions:
    """
    What a mock device is made of.
    """
    def __copy__(self) -> MockOptions:
        ...
    def __deepcopy__(self, memo: dict) -> MockOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, path: collections.abc.Callable[[float], numpy.typing.ArrayLike] | None = None, *, device: DeviceModel = ..., hand: HandModel = ..., rigid: bool = True, dry_friction: bool = True, encoder: bool = True, velocity_filter: typing.SupportsFloat | typing.SupportsIndex = 100.0, period: typing.SupportsFloat | typing.SupportsIndex = 0.001, end: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def device(self) -> DeviceModel:
        """
        see device_model
        """
    @device.setter
    def device(self, arg0: DeviceModel) -> None:
        ...
    @property
    def dry_friction(self) -> bool:
        """
        of the device, when not rigid
        """
    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...
    @property
    def encoder(self) -> bool:
        """
        positions in steps of the encoder, when not rigid
        """
    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...
    @property
    def end(self) -> float:
        """
        [s] after which there are no more readings; 0: never
        """
    @end.setter
    def end(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def hand(self) -> HandModel:
        """
        see hand_model
        """
    @hand.setter
    def hand(self, arg0: HandModel) -> None:
        ...
    @property
    def path(self) -> collections.abc.Callable[[typing.SupportsFloat | typing.SupportsIndex], numpy.typing.NDArray[numpy.float64]] | None:
        """
        null: rest
        """
    @path.setter
    def path(self, arg1: collections.abc.Callable[[float], numpy.typing.ArrayLike] | None) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s] of simulated time per tick
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rigid(self) -> bool:
        """
        true: the stylus is on the path whatever the force; false: force and hand move it
        """
    @rigid.setter
    def rigid(self, arg0: bool) -> None:
        ...
    @property
    def velocity_filter(self) -> float:
        """
        [Hz] of the reported velocity
        """
    @velocity_filter.setter
    def velocity_filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class MockDevice(Device):
    """
    A device that is not there: it follows a script, held by a simulated hand that its force can move. The motion knows
    no wall clock: the n-th reading is that of n periods, so every run gives the same readings for the same forces.
    """
    def __init__(self, options: MockOptions, name: str = 'mock') -> None:
        """
        Raises
        ------
        Error
            When an option is out of range
        """
class MoveKey:
    """
    Keys that move a mouse device, in the base frame: +x right, +y up, +z towards the user.

    Members:

      left :

      right :

      down :

      up :

      away :

      nearer :

      turn_left :

      turn_right :
    """
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
    """
    How pointer and keys move the hand.
    """
    def __copy__(self) -> MouseOptions:
        ...
    def __deepcopy__(self, memo: dict) -> MouseOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, per_pixel: typing.SupportsFloat | typing.SupportsIndex = 5e-05, *, per_notch: typing.SupportsFloat | typing.SupportsIndex = 0.0005, key_speed: typing.SupportsFloat | typing.SupportsIndex = 0.02, key_turn: typing.SupportsFloat | typing.SupportsIndex = 1.0, reach: typing.SupportsFloat | typing.SupportsIndex = 0.08, fastest: typing.SupportsFloat | typing.SupportsIndex = 0.3, device: str = 'touch', hand: str = 'firm') -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def device(self) -> str:
        """
        mechanics of the simulated device, see device_model
        """
    @device.setter
    def device(self, arg1: str) -> None:
        ...
    @property
    def fastest(self) -> float:
        """
        [m/s] of the set point: a pointer jumps, a hand does not
        """
    @fastest.setter
    def fastest(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def hand(self) -> str:
        """
        and of the hand, see hand_model
        """
    @hand.setter
    def hand(self, arg1: str) -> None:
        ...
    @property
    def key_speed(self) -> float:
        """
        [m/s] while a key is held
        """
    @key_speed.setter
    def key_speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def key_turn(self) -> float:
        """
        [rad/s] about z while a key is held
        """
    @key_turn.setter
    def key_turn(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def per_notch(self) -> float:
        """
        [m] along z per notch of the wheel; forwards goes away from the user
        """
    @per_notch.setter
    def per_notch(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def per_pixel(self) -> float:
        """
        [m] of the hand per pixel of the pointer
        """
    @per_pixel.setter
    def per_pixel(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def reach(self) -> float:
        """
        [m] half the edge of the cube that the hand stays in
        """
    @reach.setter
    def reach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class MouseDevice(Device):
    """
    A device for people without one: pointer, wheel, buttons and keys of any window toolkit move the set point of a
    simulated hand, and the force pushes that hand as it would push a real one. Nobody feels it, but tool and set point
    part where the material resists.

    The events may come from any thread. Positions are relative to the point where the run began.
    """
    def __init__(self, options: MouseOptions = ...) -> None:
        """
        Raises
        ------
        Error
            When an option is out of range
        """
    def button(self, number: typing.SupportsInt | typing.SupportsIndex, pressed: bool) -> None:
        """
        A button, 0 ... 31, was pressed or let go.
        """
    def key(self, key: MoveKey, pressed: bool) -> None:
        """
        A key was pressed or let go.
        """
    def pointer_moved(self, dx: typing.SupportsFloat | typing.SupportsIndex, dy: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        The pointer moved by so many pixels, y downwards as windows count.
        """
    def wheel_turned(self, notches: typing.SupportsFloat | typing.SupportsIndex) -> None:
        """
        The wheel turned by so many notches, forwards positive.
        """
    @property
    def set_point(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        Where the hand wants to be: for a second cursor. Any thread.
        """
class WorkspaceMapOptions:
    """
    How the hand's space lies in the world.
    """
    def __copy__(self) -> WorkspaceMapOptions:
        ...
    def __deepcopy__(self, memo: dict) -> WorkspaceMapOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, X_WB: numpy.typing.ArrayLike = ..., *, scale: typing.SupportsFloat | typing.SupportsIndex = 1.0, force_scale: typing.SupportsFloat | typing.SupportsIndex = 1.0, torque_scale: typing.SupportsFloat | typing.SupportsIndex = 1.0, X_SH: numpy.typing.ArrayLike = ..., orientation: bool = True) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def X_SH(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the tool's handle in the stylus frame; its lever is not scaled
        """
    @X_SH.setter
    def X_SH(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def X_WB(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        pose of the device's base in the world: where its origin is, where it looks
        """
    @X_WB.setter
    def X_WB(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def force_scale(self) -> float:
        """
        [1] > 0, newtons at the hand per newton in the world; ``scale`` preserves power
        """
    @force_scale.setter
    def force_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def orientation(self) -> bool:
        """
        false for devices of three degrees of freedom: the tool keeps its orientation
        """
    @orientation.setter
    def orientation(self, arg0: bool) -> None:
        ...
    @property
    def scale(self) -> float:
        """
        [1] > 0, metres in the world per metre of the hand
        """
    @scale.setter
    def scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def torque_scale(self) -> float:
        """
        [1] > 0, the same for torques; 1 preserves power
        """
    @torque_scale.setter
    def torque_scale(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class WorkspaceMap:
    """
    Takes poses from a device to the world and forces back, with a scale and a clutch.

    Frames: B base of the device, S stylus, W world, H handle of the tool.

        p_WS = p_home + s R_WB (p_BS - p_latch)
        R_WS = R_WB (R_BS R_latch^T) R_WB^T R_home
        X_WH = X_WS X_SH

    Home and latch are the poses of stylus in world and base when the clutch was engaged last, so that engaging moves
    nothing (the scale acts on translations only). While the clutch is open the tool stays where it is and the hand
    feels nothing.

    The stiffness that the device feels is ``scale x force_scale x`` that of the world: check that one against its limits.
    After every change of the map the guard must wait until the tool is free: ``Device::interrupt(reclutched)``.

    Notes
    -----
    Real time: no allocation, no lock, but for the constructor
    """
    def __init__(self, options: WorkspaceMapOptions = ...) -> None:
        """
        Raises
        ------
        Error
            When a scale is not a finite number > 0 or the rotation is none
        """
    def engage(self, X_BS: numpy.typing.ArrayLike) -> None:
        """
        Closes the clutch where the hand is now; nothing moves.
        """
    def felt_stiffness(self, world: typing.SupportsFloat | typing.SupportsIndex) -> float:
        """
        [N/m] that the hand feels of a stiffness in the world.
        """
    def place(self, X_BS: numpy.typing.ArrayLike, X_WH: numpy.typing.ArrayLike) -> None:
        """
        Moves the tool to a pose in the world; the hand stays where it is.
        """
    def release(self, X_BS: numpy.typing.ArrayLike) -> None:
        """
        Opens the clutch: from now on the tool stays at its pose.
        """
    def set_scale(self, scale: typing.SupportsFloat | typing.SupportsIndex, X_BS: numpy.typing.ArrayLike) -> bool:
        """
        Another scale from here on; nothing moves.

        Returns
        -------
        false, and nothing changes, when it is not a finite number > 0
        """
    def to_device(self, X_BS: numpy.typing.ArrayLike, tool: Wrench) -> Wrench:
        """
        The wrench on the stylus about its point, in B, of a wrench on the tool about Ho, in W.
        """
    @typing.overload
    def to_world(self, X_BS: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """
        X_WH, the pose of the handle.
        """
    @typing.overload
    def to_world(self, X_BS: numpy.typing.ArrayLike, stylus: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """
        Velocity of the handle point Ho, in W.
        """
    @property
    def engaged(self) -> bool:
        """
        Whether the clutch is closed.
        """
    @property
    def scale(self) -> float:
        """
        [1] > 0, metres in the world per metre of the hand
        """
class PlantOptions:
    """
    What of the mechanics is simulated.
    """
    def __copy__(self) -> PlantOptions:
        ...
    def __deepcopy__(self, memo: dict) -> PlantOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, period: typing.SupportsFloat | typing.SupportsIndex = 0.001, *, fine_step: typing.SupportsFloat | typing.SupportsIndex = 2e-05, dry_friction: bool = False, encoder: bool = False, rotation: bool = False) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def dry_friction(self) -> bool:
        """
        Coulomb friction of the device; integrated with steps of 10 us instead of exactly
        """
    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...
    @property
    def encoder(self) -> bool:
        """
        the position is read in steps of the encoder
        """
    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...
    @property
    def fine_step(self) -> float:
        """
        [s] of ``creep``
        """
    @fine_step.setter
    def fine_step(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s] > 0 for which a force is held: one tick of the servo loop
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rotation(self) -> bool:
        """
        the gimbal turns under torque; otherwise it follows the set point
        """
    @rotation.setter
    def rotation(self, arg0: bool) -> None:
        ...
class Plant:
    """
    A device in a hand, moved by the force it renders: the mechanics of the closed-loop bench and of the mock device.

    Per axis, with x the tip, x_h the hand and x_0 the set point that the hand wants to reach:

        m x'' = F - b x' - f_c sign(x') + pad,     m_h x_h'' = -pad - b_h x_h' + k_h (x_0 - x_h)

    where the hand is bonded to the tip (x_h = x, masses add) when the pad has no stiffness. Without dry friction a tick
    is exact for a force held over it (matrix exponential), so the only error of a stability limit is that of the
    search.

    Notes
    -----
    Real time: no allocation after construction
    """
    def __init__(self, device: DeviceModel, hand: HandModel, options: PlantOptions = ...) -> None:
        """
        Raises
        ------
        Error
            When a number is not finite or out of range
        """
    def advance(self, wrench: Wrench) -> None:
        """
        One period with a wrench held on the stylus.

        Parameters
        ----------
        wrench
            [N], [N·m] in B
        """
    def creep(self, wrench: Wrench) -> None:
        """
        One fine step, for events within a tick.
        """
    def reset(self, X_BS: numpy.typing.ArrayLike) -> None:
        """
        At rest at a pose, which also becomes the set point.
        """
    def set_target(self, X_BS: numpy.typing.ArrayLike) -> None:
        """
        Where the hand wants to be.
        """
    def set_velocity(self, velocity: numpy.typing.ArrayLike) -> None:
        """
        Gives tip and hand a velocity.

        Parameters
        ----------
        velocity
            [m/s] in B
        """
    @property
    def device(self) -> DeviceModel:
        """
        As given.
        """
    @property
    def hand(self) -> HandModel:
        """
        As given.
        """
    @property
    def kinetic_energy(self) -> float:
        """
        [J] of the translation of tip and hand
        """
    @property
    def measured_pose(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (4, 4) as the encoders read it.
        """
    @property
    def options(self) -> PlantOptions:
        """
        As given.
        """
    @property
    def pose(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (4, 4) exact.
        """
    @property
    def target(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (4, 4) where the hand wants to be.
        """
    @property
    def velocity(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        (6,) exact.
        """
class LinearWall:
    """
    A virtual wall that fills z < ``height``: ``F = -K p - B p'`` along z with p the penetration, never pulling.
    The reference model of the bench, for which stability limits are known in closed form.
    """
    def __call__(self, state: DeviceState) -> Wrench:
        """
        The wrench for a reading.
        """
    def __init__(self, stiffness: typing.SupportsFloat | typing.SupportsIndex = 0.0, damping: typing.SupportsFloat | typing.SupportsIndex = 0.0, filter: typing.SupportsFloat | typing.SupportsIndex = 0.0, one_sided: bool = True, height: typing.SupportsFloat | typing.SupportsIndex = 0.0, period: typing.SupportsFloat | typing.SupportsIndex = 0.001) -> None:
        ...
    @property
    def damping(self) -> float:
        """
        [N·s/m] B, on the backward difference of the position
        """
    @damping.setter
    def damping(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def filter(self) -> float:
        """
        [Hz] cut-off of the low-pass behind that difference; 0: none
        """
    @filter.setter
    def filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def height(self) -> float:
        """
        [m]
        """
    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def one_sided(self) -> bool:
        """
        false: it also pulls, so that it is linear
        """
    @one_sided.setter
    def one_sided(self, arg0: bool) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s]
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def stiffness(self) -> float:
        """
        [N/m] K
        """
    @stiffness.setter
    def stiffness(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ClosedLoopConfig:
    """
    What the bench is made of.
    """
    device: DeviceModel
    hand: HandModel
    def __copy__(self) -> ClosedLoopConfig:
        ...
    def __deepcopy__(self, memo: dict) -> ClosedLoopConfig:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, device: DeviceModel = ..., *, hand: HandModel = ..., delay: typing.SupportsInt | typing.SupportsIndex = 0, period: typing.SupportsFloat | typing.SupportsIndex = 0.001, dry_friction: bool = False, encoder: bool = False, saturation: bool = False, rotation: bool = False, velocity_filter: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def delay(self) -> int:
        """
        [ticks] >= 0, <= 8, between a force and the tick that applies it, beyond the hold
        """
    @delay.setter
    def delay(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def dry_friction(self) -> bool:
        """
        Coulomb friction of the device
        """
    @dry_friction.setter
    def dry_friction(self, arg0: bool) -> None:
        ...
    @property
    def encoder(self) -> bool:
        """
        positions in steps of the encoder
        """
    @encoder.setter
    def encoder(self, arg0: bool) -> None:
        ...
    @property
    def period(self) -> float:
        """
        [s]
        """
    @period.setter
    def period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def rotation(self) -> bool:
        """
        the gimbal turns under torque
        """
    @rotation.setter
    def rotation(self, arg0: bool) -> None:
        ...
    @property
    def saturation(self) -> bool:
        """
        the device renders no more than its peak force
        """
    @saturation.setter
    def saturation(self, arg0: bool) -> None:
        ...
    @property
    def velocity_filter(self) -> float:
        """
        [Hz] of the velocity in the readings, as drivers have one; 0: plain difference
        """
    @velocity_filter.setter
    def velocity_filter(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class ClosedLoop:
    """
    The loop: read, compute, hold the force for one period, and so on. Deterministic; knows no clock.
    """
    def __init__(self, config: ClosedLoopConfig) -> None:
        """
        Raises
        ------
        Error
            When a number is out of range
        """
    def miss_tick(self, scale: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
        """
        A tick without a word from the model: the device holds the last wrench, or the share of it that a watchdog allows.
        """
    def read(self) -> DeviceState:
        """
        What the device reads now.
        """
    def reset(self, X_BS: numpy.typing.ArrayLike) -> None:
        """
        At rest at a pose, with no force under way.
        """
    def tick(self, model: collections.abc.Callable[[DeviceState], Wrench]) -> None:
        """
        One tick: reads, asks the model, and writes.
        """
    def write(self, wrench: Wrench) -> None:
        """
        Accepts the wrench for the last reading, and moves device and hand by one period.
        """
    @property
    def applied(self) -> Wrench:
        """
        during the last period
        """
    @property
    def config(self) -> ClosedLoopConfig:
        """
        As given.
        """
    @property
    def device_dissipation(self) -> float:
        """
        [J] that the viscous friction of the device alone has taken since the reset.
        """
    @property
    def generated_energy(self) -> float:
        """
        [J] that the rendered force has put into device and hand since the reset; exact, because the force is held:
        ``E += F(n) (x(n+1) - x(n)) + tau(n) log(R(n+1) R(n)^T)``.
        """
    @property
    def plant(self) -> Plant:
        """
        Device and hand.
        """
class StabilitySearch:
    """
    Where a search for a stability limit begins and how it looks.
    """
    def __copy__(self) -> StabilitySearch:
        ...
    def __deepcopy__(self, memo: dict) -> StabilitySearch:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, start: numpy.typing.ArrayLike = ..., *, target: numpy.typing.ArrayLike = ..., settle: typing.SupportsFloat | typing.SupportsIndex = 0.0, nudge: typing.SupportsFloat | typing.SupportsIndex = 0.0001, window: typing.SupportsFloat | typing.SupportsIndex = 1.0, windows: typing.SupportsInt | typing.SupportsIndex = 4, low: typing.SupportsFloat | typing.SupportsIndex = 5.0, high: typing.SupportsFloat | typing.SupportsIndex = 1000000.0, coarse_factor: typing.SupportsFloat | typing.SupportsIndex = 1.15, tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.001) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def coarse_factor(self) -> float:
        """
        of the scan for the first unstable value
        """
    @coarse_factor.setter
    def coarse_factor(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def high(self) -> float:
        """
        where the limit is looked for
        """
    @high.setter
    def high(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def low(self) -> float:
        """
        where the limit is looked for
        """
    @low.setter
    def low(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def nudge(self) -> float:
        """
        [m/s] along -z, small enough that the model answers linearly
        """
    @nudge.setter
    def nudge(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def settle(self) -> float:
        """
        [s] before the nudge
        """
    @settle.setter
    def settle(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def start(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        X_BS at rest
        """
    @start.setter
    def start(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def target(self) -> numpy.typing.NDArray[numpy.float64]:
        """
        set point of the hand
        """
    @target.setter
    def target(self, arg0: numpy.typing.ArrayLike) -> None:
        ...
    @property
    def tolerance(self) -> float:
        """
        [1] relative, of the result
        """
    @tolerance.setter
    def tolerance(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def window(self) -> float:
        """
        [s] longer than a swing of the slowest mode
        """
    @window.setter
    def window(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def windows(self) -> int:
        """
        a loop whose swing grows from the last window but one to the last is unstable
        """
    @windows.setter
    def windows(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
class Bounce:
    """
    What became of a free flight into the material.
    """
    def __repr__(self) -> str:
        ...
    @property
    def generated_energy(self) -> float:
        """
        [J] that the model put in during a contact, worst over the phases
        """
    @property
    def mean_restitution(self) -> float:
        """
        [1] mean over the entry phases
        """
    @property
    def peak_force(self) -> float:
        """
        [N] greatest
        """
    @property
    def penetration(self) -> float:
        """
        [m] greatest
        """
    @property
    def restitution(self) -> float:
        """
        [1] speed out by speed in, worst over the entry phases; 0: it stayed
        """
class BounceTest:
    """
    A bounce test: the device flies along -z into the surface z = ``height`` at a given speed, with ``phases`` different
    moments of the entry between two ticks.
    """
    def __copy__(self) -> BounceTest:
        ...
    def __deepcopy__(self, memo: dict) -> BounceTest:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, height: typing.SupportsFloat | typing.SupportsIndex = 0.0, speed: typing.SupportsFloat | typing.SupportsIndex = 0.1, phases: typing.SupportsInt | typing.SupportsIndex = 40, time_limit: typing.SupportsFloat | typing.SupportsIndex = 0.4) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def height(self) -> float:
        """
        [m]
        """
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
        """
        [m/s]
        """
    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def time_limit(self) -> float:
        """
        [s]
        """
    @time_limit.setter
    def time_limit(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class Buzz:
    """
    How a hand feels that presses steadily.
    """
    def __repr__(self) -> str:
        ...
    def buzzes(self) -> bool:
        """
        rms > 50 um, or force > 0.3 N p-p, or > 5 mW
        """
    @property
    def force_peak_to_peak(self) -> float:
        """
        [N] along z
        """
    @property
    def frequency(self) -> float:
        """
        [Hz] half the rate of its crossings of the mean
        """
    @property
    def generated_power(self) -> float:
        """
        [W] mean that the model puts in
        """
    @property
    def greatest_force(self) -> float:
        """
        [N] over the whole run
        """
    @property
    def position_rms(self) -> float:
        """
        [m] of the tip about its mean, along z
        """
class PressTest:
    """
    A press test: the hand flies in and then wants to be ``depth`` below the surface z = ``height``.
    """
    def __copy__(self) -> PressTest:
        ...
    def __deepcopy__(self, memo: dict) -> PressTest:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, height: typing.SupportsFloat | typing.SupportsIndex = 0.0, *, depth: typing.SupportsFloat | typing.SupportsIndex = 0.01, speed: typing.SupportsFloat | typing.SupportsIndex = 0.05, approach: typing.SupportsFloat | typing.SupportsIndex = 0.0, seconds: typing.SupportsFloat | typing.SupportsIndex = 4.0, measured: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def approach(self) -> float:
        """
        [s] that the hand waits 2 mm above the surface before it presses
        """
    @approach.setter
    def approach(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def depth(self) -> float:
        """
        [m]
        """
    @depth.setter
    def depth(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def height(self) -> float:
        """
        [m]
        """
    @height.setter
    def height(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def measured(self) -> float:
        """
        [s] at its end
        """
    @measured.setter
    def measured(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def seconds(self) -> float:
        """
        [s] of the run
        """
    @seconds.setter
    def seconds(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def speed(self) -> float:
        """
        [m/s] of the approach
        """
    @speed.setter
    def speed(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
class InjectedFault:
    """
    What can go wrong between a hand and a model, as the bench makes it go wrong.

    Members:

      nan_pose : readings become not-a-number

      frozen_pose : the position stops changing while the driver goes on reporting a speed

      stale_reading : the driver returns its last reading for ever

      jump_30mm : readings jump 30 mm into the material and stay there

      missed_1 : the model misses this many ticks, while the device holds the last force

      missed_5 : the same

      missed_20 : the same

      missed_100 : the same

      buried_5mm : the run begins 5 mm inside the material

      reclutch : the mapping from hand to tool moves the tool 5 mm into the material, and says so

      calibration_jump : a calibration moves the readings 5 mm into the material

      units_x1000 : readings come in millimetres

      force_x1000 : the model's force comes in millinewtons

      nan_force : the model's force becomes not-a-number

      unplugged : the device stops answering

      emergency_stop : somebody pulls it
    """
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
    """
    What the hand felt of a fault.
    """
    def __repr__(self) -> str:
        ...
    @property
    def end(self) -> ArmingState:
        """
        of the guard, 0.5 s after the fault
        """
    @property
    def greatest_force(self) -> float:
        """
        [N] from the fault on
        """
    @property
    def greatest_growth(self) -> float:
        """
        [N] in one tick from the fault on, along any direction but back
        """
    @property
    def oldest_force(self) -> float:
        """
        [s] age of the last good reading behind any force that was felt
        """
    @property
    def time_to_zero(self) -> float:
        """
        [s] from the fault to the first tick without force; < 0: the force went on
        """
class RecorderOptions:
    """
    How a recording is made.
    """
    def __copy__(self) -> RecorderOptions:
        ...
    def __deepcopy__(self, memo: dict) -> RecorderOptions:
        ...
    def __getstate__(self) -> tuple:
        ...
    def __init__(self, device: str = '', *, note: str = '', steps: typing.SupportsInt | typing.SupportsIndex = 8192, flush_period: typing.SupportsFloat | typing.SupportsIndex = 0.2, wait_when_full: bool = False, workpiece_file: str = '') -> None:
        ...
    def __repr__(self) -> str:
        ...
    def __setstate__(self, arg0: tuple) -> None:
        ...
    @property
    def device(self) -> str:
        """
        name of the device that the steps come from; empty: none, and no columns for it
        """
    @device.setter
    def device(self, arg0: str) -> None:
        ...
    @property
    def flush_period(self) -> float:
        """
        [s] in 0.01 ... 0.5; a process that is killed loses this, and what it takes to write
        """
    @flush_period.setter
    def flush_period(self, arg0: typing.SupportsFloat | typing.SupportsIndex) -> None:
        ...
    @property
    def note(self) -> str:
        """
        anything
        """
    @note.setter
    def note(self, arg0: str) -> None:
        ...
    @property
    def steps(self) -> int:
        """
        that the memory between loop and disk holds, about 1.3 kB each
        """
    @steps.setter
    def steps(self, arg0: typing.SupportsInt | typing.SupportsIndex) -> None:
        ...
    @property
    def wait_when_full(self) -> bool:
        """
        Where the memory is full: true waits for the disk, for simulations that nobody feels; false loses the step and
        says so in the recording, for loops.
        """
    @wait_when_full.setter
    def wait_when_full(self, arg0: bool) -> None:
        ...
    @property
    def workpiece_file(self) -> str:
        """
        File that the initial workpiece was loaded from, by ``load_vdb``. The recording then holds its name and a hash
        instead of its content. Empty: the recording holds the workpiece.
        """
    @workpiece_file.setter
    def workpiece_file(self, arg1: str) -> None:
        ...
class Recorder:
    """
    Records the steps of a simulation: the loop puts each into a bounded memory without lock, and a thread of the
    recorder's own writes it to an HDF5 file. The file is in order at any moment: a process that is killed loses the
    last fraction of a second, not the recording.

    ``step`` belongs to one thread; the rest may be called from any.
    """
    def __enter__(self) -> typing.Any:
        ...
    def __exit__(self, type: typing.Any, value: typing.Any, traceback: typing.Any) -> None:
        ...
    def __init__(self, path: os.PathLike | str | bytes, simulation: Simulation, options: RecorderOptions = ...) -> None:
        """
        Writes what there is before the first step, and replaces what was at ``path``.

        Parameters
        ----------
        simulation
            that has made no step yet, or was just reset; it must stay where it is until the end

        Raises
        ------
        Error
            When the simulation has made steps, an option is out of range, or the file cannot be written
        """
    def close(self) -> None:
        """
        Writes what is left, and the hash of the workpiece, and ends the recording.

        Raises
        ------
        Error
            When something could not be written, also earlier
        """
    def run(self, poses: numpy.typing.NDArray[numpy.float64], velocities: numpy.typing.NDArray[numpy.float64], dt: float | numpy.typing.NDArray[numpy.float64]) -> numpy.ndarray:
        """
        Makes a step for every row and records it; see Simulation.run. A run is quicker than the disk: set
        RecorderOptions.wait_when_full, or steps will be lost.
        """
    def step(self, pose: numpy.typing.ArrayLike, velocity: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> StepResult:
        """
        Makes a step of the simulation and records it.
        """
    @property
    def failed(self) -> bool:
        """
        the disk is full, or the like: ``close`` says what
        """
    @property
    def lost(self) -> int:
        """
        steps that found the memory full or came after the end
        """
    @property
    def recorded(self) -> int:
        """
        steps that were taken over
        """
class RecordingInfo:
    """
    Who made a recording, and how it ended.
    """
    def __repr__(self) -> str:
        ...
    @property
    def begun(self) -> str:
        """
        when, as 2026-01-31T23:59:59Z
        """
    @property
    def closed(self) -> bool:
        """
        false: the program ended before it could finish; the last moment is missing
        """
    @property
    def commit(self) -> str:
        """
        of the program that recorded: see BuildInfo
        """
    @property
    def compiler(self) -> str:
        """
        of the program that recorded: see BuildInfo
        """
    @property
    def cpu(self) -> str:
        """
        of the program that recorded: see BuildInfo
        """
    @property
    def device(self) -> str:
        """
        that the steps came from; empty: none
        """
    @property
    def format(self) -> int:
        ...
    @property
    def lost(self) -> int:
        """
        steps that found the recorder's memory full; a replay ends before the first
        """
    @property
    def note(self) -> str:
        """
        of whoever recorded
        """
    @property
    def remarks(self) -> list[str]:
        """
        what a reader should know: lost steps, an end without an end, in sentences
        """
    @property
    def version(self) -> str:
        """
        of the program that recorded: see BuildInfo
        """
    @property
    def workpiece_hash_at_end(self) -> int | None:
        """
        Workpiece::hash, only when closed
        """
class RecordedEffects:
    """
    A change of the effects between two steps.
    """
    def __repr__(self) -> str:
        ...
    @property
    def effects(self) -> Effects:
        ...
    @property
    def first_step(self) -> int:
        """
        number of the first step that they were in force
        """
class Recording:
    """
    A recording that is open for reading; steps are read from the disk when they are asked for. Also one that is still
    being written: what is there so far.
    """
    def __len__(self) -> int:
        ...
    def read(self, first: typing.SupportsInt | typing.SupportsIndex = 0, count: typing.SupportsInt | typing.SupportsIndex | None = None) -> dict:
        """
        The steps from one on, all of them without a count: a dict of poses (n, 4, 4), velocities (n, 6) and dt (n,),
        as Simulation.run takes them, and trace, as it returns them.
        """
    def workpiece(self) -> Workpiece:
        """
        The workpiece before the first step: out of the recording, or out of the file that it names.

        Raises
        ------
        Error
            When that file is missing, or is not what was recorded
        """
    @property
    def config(self) -> SimulationConfig:
        """
        without the law
        """
    @property
    def default_law(self) -> bool:
        """
        whether the force law was the library's own, FoundationLaw
        """
    @property
    def effects(self) -> list[RecordedEffects]:
        """
        the first entry belongs to step 0
        """
    @property
    def has_device(self) -> bool:
        """
        whether the steps have a device's side
        """
    @property
    def info(self) -> RecordingInfo:
        """
        Who made it, and how it ended.
        """
    @property
    def path(self) -> pathlib.Path:
        """
        Of the file.
        """
    @property
    def tool(self) -> Tool:
        """
        That made the steps.
        """
class ReplayDifference:
    """
    Where a replay leaves its recording.
    """
    def __repr__(self) -> str:
        ...
    @property
    def column(self) -> str:
        """
        of the recording, or "workpiece" for its hash at the end
        """
    @property
    def element(self) -> int:
        """
        of the column, counted through its rows
        """
    @property
    def recorded(self) -> float:
        ...
    @property
    def replayed(self) -> float:
        ...
    @property
    def step(self) -> int:
        """
        number of the step
        """
class ReplayReport:
    """
    What came of a replay.
    """
    def __repr__(self) -> str:
        ...
    @property
    def first_difference(self) -> ReplayDifference | None:
        ...
    @property
    def identical(self) -> bool:
        """
        every bit of every result, and of the workpiece at the end where it is known
        """
    @property
    def largest_force_difference(self) -> float:
        """
        [N] over all steps
        """
    @property
    def left_out(self) -> int:
        """
        recorded steps after the first lost one, which cannot be made again
        """
    @property
    def steps(self) -> int:
        """
        that were made again
        """
    @property
    def workpiece_hash(self) -> int:
        ...
def advance(from_: numpy.typing.ArrayLike, twist: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    """
    The pose after moving with a constant twist of the body's origin for ``dt`` seconds.
    """
def axial_cut_force(constants: Calibration, radius: typing.SupportsFloat | typing.SupportsIndex, spindle_speed: typing.SupportsFloat | typing.SupportsIndex, feed_speed: typing.SupportsFloat | typing.SupportsIndex) -> AxialCutForce:
    """
    Steady thrust and torque of a flat head fed axially (C22).
    """
def bounce(config: ClosedLoopConfig, factory: collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, test: BounceTest = ...) -> Bounce:
    """
    What becomes of a free flight into the material.
    """
@typing.overload
def box_around(volume: LabelVolume, labels: collections.abc.Sequence[typing.SupportsInt | typing.SupportsIndex] = [], margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> IndexBox:
    """
    The smallest box around all samples with one of these labels (none given: with any label but 0).

    Parameters
    ----------
    margin
        [m] the box grows by this much to every side, within the volume

    Raises
    ------
    Error
        When there is no such sample
    """
@typing.overload
def box_around(volume: GreyVolume, threshold: typing.SupportsFloat | typing.SupportsIndex, margin: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> IndexBox:
    """
    The smallest box around all samples with at least this grey value.
    """
def build_block(box: Box, voxel_size: typing.SupportsFloat | typing.SupportsIndex, material: Material) -> Workpiece:
    """
    A solid block. Voxel (i, j, k) is centred at ``min + ((i+.5) h, (j+.5) h, (k+.5) h)``; a last row of voxels that the
    block fills only partly is filled by that fraction.
    """
def build_body(body: BodyDescription, voxel_size: typing.SupportsFloat | typing.SupportsIndex, materials: MaterialTable, subsamples: typing.SupportsInt | typing.SupportsIndex = 8) -> Workpiece:
    """
    Builds any body described by functions.

    Parameters
    ----------
    subsamples
        rows per voxel edge added up in a voxel that the surface cuts, 1 ... 32; a face along the grid is
        exact from 2 on; 1: voxels are full when their centre is inside, and empty otherwise

    Raises
    ------
    Error
        When the voxel size is not positive, the box is empty or not finite, or there would be too many voxels
    """
@typing.overload
def build_from_grey(volume: GreyVolume, ranges: collections.abc.Sequence[GreyRange], options: VolumeBuildOptions = ...) -> Workpiece:
    """
    Builds a workpiece from grey values; what no range covers is empty. Material ids follow the order of the list.

    A scanner blurs: between a dense material and air the values pass through every range in between. Choose ranges, or
    label the volume first, with that in mind.

    Raises
    ------
    Error
        When the volume is not consistent or has values that are not finite, a range is empty or overlaps another, or there would be too many voxels
    """
@typing.overload
def build_from_grey(volume: GreyVolume, grade: Grade, options: VolumeBuildOptions = ...) -> Workpiece:
    """
    Builds a workpiece of one graded material.

    Raises
    ------
    Error
        As above
    """
def build_from_labels(volume: LabelVolume, materials: collections.abc.Sequence[LabelMaterial], options: VolumeBuildOptions = ..., unclaimed: UnclaimedLabels = UnclaimedLabels.refuse) -> Workpiece:
    """
    Builds a workpiece from a segmentation. Material ids follow the order of the list.

    With isotropic spacing and a voxel of that size, voxel (i, j, k) is sample (i, j, k) and full: volumes are exact.
    Otherwise each label's membership is interpolated, the body reaches to where the memberships of its labels sum to
    one half, and a point inside is of the material with the largest membership.

    Raises
    ------
    Error
        When the volume is not consistent, a label is claimed twice or by nobody, or there would be too many voxels
    """
def build_from_mesh(mesh: TriangleMesh, material: Material, options: MeshImport = ...) -> Workpiece:
    """
    The same for one surface of one material.
    """
def build_from_shells(shells: collections.abc.Sequence[MeshShell], materials: MaterialTable, options: MeshImport = ...) -> Workpiece:
    """
    A workpiece from nested surfaces, e.g. enamel, dentin, pulp. Where several enclose a point, **the last one of the
    list wins**, so list them from the outside in. Voxels that a surface cuts get the filled fraction and its centroid
    by subsampling, and the material with the largest share.

    Inside is where the generalised winding number of a surface exceeds one half (Jacobson, Kavan and Sorkine-Hornung
    2013): right for closed surfaces, also when they overlap or intersect themselves, and robust to holes.

    Raises
    ------
    Error
        When there is no shell, a vertex is not finite, an index is out of range, a material is not in the table, a shell encloses nothing or is too open to say what is inside, or there would be too many voxels
    """
def build_info() -> BuildInfo:
    """
    Which library this is and what it runs on.
    """
def build_layered_slab(box: Box, voxel_size: typing.SupportsFloat | typing.SupportsIndex, layers: collections.abc.Sequence[Layer]) -> Workpiece:
    """
    Parameters
    ----------
    top
        upper face and horizontal extent: layers go down from ``box.max.z``; below the last one there is nothing,
        and the box's own lower face cuts what would reach beyond it
    """
def build_molar(voxel_size: typing.SupportsFloat | typing.SupportsIndex, parameters: MolarParameters = ...) -> Workpiece:
    """
    The molar as voxels, made of the presets enamel, dentin, pulp and, with a lesion, caries. The same parameters give
    the same bits.

    Raises
    ------
    Error
        As ``validate``, and when the voxel size is not positive
    """
def build_sphere(center: numpy.typing.ArrayLike, radius: typing.SupportsFloat | typing.SupportsIndex, voxel_size: typing.SupportsFloat | typing.SupportsIndex, material: Material) -> Workpiece:
    """
    A ball.
    """
def calibrate(tests: collections.abc.Sequence[DrillingTest]) -> Calibration:
    """
    Fits u, kappa and p_e to drilling tests by least squares of the relative errors of thrust and torque.

    For a given kappa both are linear in u and p_e, neither of which may be negative; kappa is searched. One test, or
    several at the same feed per turn over radius, cannot tell edge from chip: then p_e = 0.

    Raises
    ------
    Error
        When there is no test, or a number of one is out of its range
    """
def capabilities(model: DeviceModel) -> DeviceCapabilities:
    """
    What such a device would say about itself.
    """
def christmas_tree_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, tiers: typing.SupportsInt | typing.SupportsIndex) -> ToolHead:
    """
    Cones on top of each other, each growing from ``kTreeWaist`` of the rim below: the X'mas cutter of the thesis.

    Parameters
    ----------
    tiers
        1 ... 20 cones of the same height; the rim of the last has the full diameter
    """
def close_gaps(volume: LabelVolume, radius: typing.SupportsFloat | typing.SupportsIndex, label: typing.SupportsInt | typing.SupportsIndex) -> LabelVolume:
    """
    Gives a label to every sample of 0 that no ball of this radius reaches without touching the body (a morphological
    closing): holes and slits narrower than the ball, e.g. the root canals that join a pulp chamber with the outside.

    Parameters
    ----------
    radius
        [m]

    Raises
    ------
    Error
        When all samples are 0
    """
def colored(surface: WorkpieceSurface, materials: MaterialTable) -> ColoredMesh:
    """
    A surface in the colours of its materials.
    """
def contact_point(head: ToolHead, wrench_T: Wrench) -> numpy.typing.NDArray[numpy.float64]:
    """
    Where the summed normal force leaves the head: the point of its surface on the line of action of a wrench, on the
    side of the material. Dry friction acts there.

    The line of action of a force F with torque T about To passes through ``F x T / |F|^2`` along F. The part of T along F
    has no line of action and is left out.

    Parameters
    ----------
    wrench_T
        normal force on the tool and its torque about To, in T; the force is not zero

    Returns
    -------
    [m] in T; the point of the line nearest to To where the line misses the head

    Notes
    -----
    Real time: no allocation, no lock; about a hundred evaluations of the head's depth
    """
@typing.overload
def crop(volume: GreyVolume, samples: IndexBox) -> GreyVolume:
    """
    The samples of a box; what of it reaches beyond the volume is left out.

    Raises
    ------
    Error
        When nothing is left
    """
@typing.overload
def crop(volume: LabelVolume, samples: IndexBox) -> LabelVolume:
    ...
def cylinder_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A cylinder with a flat end (straight fissure).
    """
@typing.overload
def describe(fault: DeviceFault) -> str:
    """
    An entry in words: time, name and value.
    """
@typing.overload
def describe(limits: typing.SupportsInt | typing.SupportsIndex) -> str:
    """
    The bits of OutputLimit in words, separated by commas.
    """
@typing.overload
def describe(entry: SafetyLogEntry) -> str:
    """
    An entry in words: time, name and value.
    """
def describe_molar(parameters: MolarParameters = ...) -> BodyDescription:
    """
    The molar as functions of the position, for ``build_body``.

    Raises
    ------
    Error
        As ``validate``
    """
def device_drivers() -> list:
    """
    The kinds of devices there are, usable or not: dicts of scheme, usage and missing (empty, or what to install).
    """
def device_model(name: str) -> DeviceModel:
    """
    The preset of that name.

    Raises
    ------
    Error
        That lists the names there are
    """
def device_models() -> list[DeviceModel]:
    """
    The presets ``touch``, ``premium15``, ``premium6dof`` and ``omega``: published data where there are any; the omega is a
    guess of its class (docs/devices.md).
    """
@typing.overload
def extract_surface(workpiece: Workpiece) -> WorkpieceSurface:
    """
    The surface of what is left: where the filled fraction, interpolated between voxel centres, is one half. Partly
    filled voxels make it smooth (a plane comes out plane, whatever its direction; a ball's volume is right to second
    order in the voxel size); enclosed cavities have surfaces too.

    Returns
    -------
    an empty mesh when nothing is left
    """
@typing.overload
def extract_surface(workpiece: Workpiece, material: typing.SupportsInt | typing.SupportsIndex) -> TriangleMesh:
    """
    The surface of one material alone, as if the others were empty.

    Raises
    ------
    Error
        When there is no such material in the table
    """
def fill_cavities(volume: LabelVolume, label: typing.SupportsInt | typing.SupportsIndex) -> LabelVolume:
    """
    Gives a label to every cavity: samples of 0 from which no path over faces leads to the border of the volume.
    """
def filtered(filter: DeltaFilter, previous: numpy.typing.ArrayLike, calculated: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """
    Notes
    -----
    Real time: no allocation, no lock; O(1)
    """
def find_preset(name: str) -> Material:
    """
    A preset by its name, as it is written on a command line or in a settings file.

    Raises
    ------
    Error
        Listing the known names
    """
def find_scene(name: str) -> Scene:
    """
    Raises
    ------
    Error
        When there is none of that name; the message lists those there are
    """
def flame_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex, widest_height: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A pointed arch up to the widest place, and a gentler arch from there to the neck.

    Parameters
    ----------
    widest_height
        height of the widest place above the tip; at least half of the diameter
    """
def gravity_wrench(gravity: Gravity, R_WH: numpy.typing.ArrayLike) -> Wrench:
    """
    Parameters
    ----------
    R_WH
        orientation of the handle

    Returns
    -------
    about Ho, in W

    Notes
    -----
    Real time: no allocation, no lock; O(1)
    """
def growth_limited(previous: numpy.typing.ArrayLike, target: numpy.typing.ArrayLike, longest_growth: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    """
    From the last output towards a target: release is immediate, growth takes its time.

    The output first shrinks along its own direction to the foot of the target on it, at once; from there it moves
    straight towards the target, by at most ``longest_growth``. So its direction of change is constant, it is never larger
    than the larger of the two, and a target of zero is reached at once (C18). A limit on shrinking would make a wall
    active.

    Parameters
    ----------
    longest_growth
        rate times dt, in the unit of the vectors

    Notes
    -----
    Real time: no allocation, no lock; O(1)
    """
def hand_model(name: str) -> HandModel:
    """
    The preset of that name.

    Raises
    ------
    Error
        That lists the names there are
    """
def hand_models() -> list[HandModel]:
    """
    The presets ``released``, ``light``, ``nominal``, ``firm``, and with the pad of the fingers ``light-pad``, ``nominal-pad``,
    ``firm-pad``.
    """
def has(status: typing.SupportsInt | typing.SupportsIndex, bits: StepStatus) -> bool:
    """
    Whether any of the given bits is set.
    """
def head_in_handle(handle: RayHandle | LHandle) -> numpy.typing.NDArray[numpy.float64]:
    """
    Pose of the tool head T in the handle frame H.

    Raises
    ------
    Error
        When a length is negative or not finite, or the bend is outside [-pi, pi]
    """
def injected_faults() -> list[InjectedFault]:
    """
    All of them.
    """
def inverted_cone_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A truncated cone whose wide end is the tip: undercuts.
    """
def is_rotation(m: numpy.typing.ArrayLike, tolerance: typing.SupportsFloat | typing.SupportsIndex) -> bool:
    """
    Whether a matrix is a rotation: orthonormal within ``tolerance`` and right-handed.
    """
def is_stable(config: ClosedLoopConfig, factory: collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, search: StabilitySearch = ...) -> bool:
    """
    Whether a small nudge dies out: the difference of two runs, one nudged and one not, shrinks.
    """
def keep_largest_component(volume: LabelVolume) -> LabelVolume:
    """
    Keeps the largest of the bodies made of samples that are not 0 and touch by a face; the rest becomes 0.

    Raises
    ------
    Error
        When all samples are 0
    """
def label_range(volume: GreyVolume, from_: typing.SupportsFloat | typing.SupportsIndex, to: typing.SupportsFloat | typing.SupportsIndex, label: typing.SupportsInt | typing.SupportsIndex = 1) -> LabelVolume:
    """
    Labels samples whose grey value is ``from <= value < to``; the others are 0.
    """
def largest_contact_stiffness(head: ToolHead) -> float:
    """
    The greatest contact stiffness of a head pressed into a flat solid of unit k_v, along its axis or sideways:
    ``max dF/dd``, by the pressure identity (C11) on a plane that moves through the head. For a sphere ``(4 pi/27) R^3``
    (C2).

    Returns
    -------
    [m^3] to be multiplied by k_v; relative error below 1 %
    """
def largest_stable_stiffness(config: ClosedLoopConfig, factory: collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], search: StabilitySearch = ...) -> float:
    """
    The lowest stiffness at which the loop begins to be unstable; ``search.high`` when it is stable throughout, 0 when
    already ``search.low`` is unstable.

    For a linear wall and a released device without delay this is K = 2 b / T (Colgate and Schenkel), with a delay t_d
    and small K it is b / (T/2 + t_d) (Gil et al.).
    """
def least_force_growth(stiffness: typing.SupportsFloat | typing.SupportsIndex, speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
    """
    [N/s] the least growth that does not turn a wall of stiffness K, met at speed v, into a source of energy:
    1.25 K v.

    Parameters
    ----------
    stiffness
        [N/m] that the device renders
    speed
        [m/s] fastest that the hand moves into it
    """
@typing.overload
def load_vdb(path: os.PathLike | str | bytes) -> Workpiece:
    """
    Reads what ``save_vdb`` wrote, bit by bit. A grid that another program has moved or scaled since keeps its new place.

    Raises
    ------
    Error
        When the file is missing, damaged, of another kind or was not written by hapticut
    """
@typing.overload
def load_vdb(path: os.PathLike | str | bytes, options: VdbImport) -> Workpiece:
    """
    Reads a level set or fog volume that another program wrote.

    Raises
    ------
    Error
        When the file is missing or damaged, there is no such float grid, or it does not describe a solid
    """
def masked(mask: AxisMask, wrench: Wrench) -> Wrench:
    """
    Notes
    -----
    Real time: no allocation, no lock; O(1)
    """
def material_color(name: str) -> Color:
    """
    A colour for a material by its name (enamel, dentin, pulp, bone ...); other names get one of a fixed palette.
    """
def materials_of(grade: Grade) -> list[Material]:
    """
    The materials of a grade, from low to high, named "<name of at_low> 1/<steps>" and so on.

    Raises
    ------
    Error
        When the grade is not valid
    """
def mesh_of_revolution(profile: Profile, sides: typing.SupportsInt | typing.SupportsIndex) -> TriangleMesh:
    """
    The closed surface of a profile, its vertices on the surface.

    Parameters
    ----------
    sides
        3 ... 10000 facets around the axis; arcs are divided as finely
    """
def most_blocks(head: ToolHead, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> int:
    """
    Upper bound on the blocks that a head in any pose can touch.

    Parameters
    ----------
    voxel_size
        [m] > 0
    """
def most_voxels(head: ToolHead, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> int:
    """
    Upper bound on the voxels that a head in any pose can touch: those whose cube may meet it.

    Parameters
    ----------
    voxel_size
        [m] > 0
    """
def needle_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A slender pointed cone.
    """
def obeys_the_rules(response: FaultResponse, guard: SafetyGuard, period: typing.SupportsFloat | typing.SupportsIndex) -> bool:
    """
    The rules that no fault may break: never more than the device's peak, no growth above the slew limit, no force older
    than 50 ms.
    """
def open_device(name: str) -> Device:
    """
    Opens a device by its name: "mock:spiral", "mouse", "openhaptics", "openhaptics:Left Device".

    Raises
    ------
    Error
        That says what was asked for, what there is, and what to install
    """
def open_mock(text: str) -> MockDevice:
    """
    "mock:PATH", or "mock:PATH,device=touch,hand=nominal,seconds=10"; without a hand the mock is rigid.
    """
def orthonormalized(m: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """
    The rotation nearest to an almost orthonormal matrix (one step of Newton's polar iteration per pass).
    """
def pear_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, neck_diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A ball at the tip, narrowing in a straight line from where it is touched to the neck.
    """
def preset_color(name: str) -> tuple[int, int, int]:
    """
    A colour to show a preset in: red, green, blue, 0 ... 255 (sRGB). A matter of taste, without a source.

    Raises
    ------
    Error
        Listing the known names
    """
def preset_names() -> list[str]:
    """
    The names that find_preset knows.
    """
def press(config: ClosedLoopConfig, factory: collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, test: PressTest = ...) -> Buzz:
    """
    How a hand feels that presses steadily.
    """
def profile_from_mesh(mesh: TriangleMesh, towards_shank: numpy.typing.ArrayLike = ..., tolerance: typing.SupportsFloat | typing.SupportsIndex = 0.02) -> RecognizedProfile:
    """
    Recognises a closed mesh as a body of revolution: its axis (the line about which a rotation moves the surface along
    itself: least squares over the facets), its meridian (a cut from the axis to the axis, moved out to the vertices,
    which lie on the surface while facets lie below it), and the straight lines and arcs of that.

    Parameters
    ----------
    towards_shank
        in the frame of the mesh: which end of the axis is the shank's, and the axis of a ball
    tolerance
        [1] of the largest radius, 1e-4 ... 0.1: by how much the mesh may be off

    Raises
    ------
    Error
        When the mesh is empty or open, when its axis does not pass through it once, or when it is not a body of revolution; the message says how far it is off
    """
def read_colour_slices(folder: os.PathLike | str | bytes, label_of: dict, spacing: numpy.typing.ArrayLike) -> LabelVolume:
    """
    Reads labels from a folder of colour slices: each listed colour is a label, every other one is 0. Pixels that are
    not wholly opaque are 0 too: partly transparent ones are noise of a drawing program.

    Parameters
    ----------
    spacing
        [m] of the pixels and the slices

    Raises
    ------
    Error
        Also when none of the colours occurs

    label_of is a dict from (red, green, blue) to a label.
    """
def read_grey_volume(path: os.PathLike | str | bytes, options: VolumeReadOptions = ...) -> GreyVolume:
    """
    Reads grey values.

    Parameters
    ----------
    path
        a file: NRRD (.nrrd, .nhdr), NIfTI (.nii, .nii.gz), MetaImage (.mhd, .mha), multi-frame DICOM (.dcm),
        or InVesalius (.inv3); or a folder: one DICOM series, or PNG or TIFF slices, ordered by the numbers in
        their names. The spacing of a DICOM series is the distance of its slices, not their thickness.
    """
def read_invesalius_project(path: os.PathLike | str | bytes) -> GreyVolume:
    """
    Reads the grey values of a project of the program InVesalius (.inv3). A project has no pose: the first sample is at
    the origin.
    """
def read_label_volume(path: os.PathLike | str | bytes, options: VolumeReadOptions = ...) -> LabelVolume:
    """
    Reads labels: the same formats; every value must be a whole number, 0 ... 65535.
    """
def read_mesh(path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> list[NamedMesh]:
    """
    Reads an OBJ, STL, PLY or OFF file. Each object (OBJ: ``o`` or ``g``, STL: ``solid``) is a mesh of its own; vertices at
    the same place are one vertex, triangles without area are dropped, polygons are cut into triangles.

    Parameters
    ----------
    unit_mm
        [mm] length of one unit of the file

    Raises
    ------
    Error
        That names the file when it is missing, damaged, of another kind, holds no triangle, has a coordinate that is not finite or a face without enough corners, or is more than 100 m long
    """
def read_raw_grey_volume(path: os.PathLike | str | bytes, layout: RawLayout) -> GreyVolume:
    """
    Reads grey values from a file without a header.
    """
def read_raw_label_volume(path: os.PathLike | str | bytes, layout: RawLayout) -> LabelVolume:
    """
    Reads labels from a file without a header.
    """
def read_recording(path: os.PathLike | str | bytes) -> Recording:
    """
    Opens a recording.

    Raises
    ------
    Error
        When the file is missing, damaged, no recording, of a newer format, or lacks something
    """
def replay(recording: Recording, law: ForceLaw | None = None, progress: collections.abc.Callable[[int], None] | None = None) -> ReplayReport:
    """
    Makes all steps of a recording again and compares them bit by bit with what was recorded.

    Raises
    ------
    Error
        When the recording cannot be read, its workpiece is missing, or it needs a law that was not given
    """
@typing.overload
def resample(volume: GreyVolume, voxel_size: typing.SupportsFloat | typing.SupportsIndex) -> GreyVolume:
    """
    The same volume with cubic samples of another size: linear between samples, mean over samples where the new ones are
    larger. The lower corner of the volume stays where it is.

    Parameters
    ----------
    voxel_size
        [m]
    """
@typing.overload
def resample(volume: LabelVolume, voxel_size: typing.SupportsFloat | typing.SupportsIndex, interpolation: LabelInterpolation = LabelInterpolation.nearest) -> LabelVolume:
    """
    The same volume with cubic samples of another size.
    """
def respond(config: ClosedLoopConfig, factory: collections.abc.Callable[[float], collections.abc.Callable[[DeviceState], Wrench]], stiffness: typing.SupportsFloat | typing.SupportsIndex, options: GuardOptions, fault: InjectedFault, height: typing.SupportsFloat | typing.SupportsIndex = 0.0) -> FaultResponse:
    """
    Presses into the surface z = ``height`` while stroking sideways, lets the fault happen, and watches for half a second.
    The guard and its watchdog stand between the model and the device, as in a run.
    """
def rotation_from_vector(v: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """
    Rotation by |v| about v (the exponential map of SO(3)).

    Parameters
    ----------
    v
        [rad]
    """
def round_end_cylinder_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A cylinder with a half ball as its end. @param length  of the whole, at least half of the diameter
    """
def round_end_tapered_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A truncated cone that ends in a ball, which its wall touches without an edge. @param tip_diameter  of the ball
    """
def round_head(diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A ball.
    """
def saturated(v: numpy.typing.ArrayLike, longest: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    """
    The vector, shortened to a length: its direction is kept.

    Notes
    -----
    Real time: no allocation, no lock; O(1)
    """
def save_vdb(workpiece: Workpiece, path: os.PathLike | str | bytes) -> None:
    """
    Writes a workpiece without loss; uniform regions stay tiles, so a solid block needs kilobytes. What was at ``path``
    before stays until the new file is complete.

    Raises
    ------
    Error
        When the file cannot be written completely
    """
def scenes() -> list[Scene]:
    """
    All scenes, in a fixed order.
    """
def scripted_path(name: str) -> collections.abc.Callable[[typing.SupportsFloat | typing.SupportsIndex], numpy.typing.NDArray[numpy.float64]]:
    """
    The paths that have a name.

    ``rest``   stays at the origin
    ``press``  goes down (-z) from 5 mm to -5 mm in 2 s, and stays
    ``line``   the same, then to and fro along x over 20 mm
    ``circle`` the same, then round a circle of 8 mm radius in the xy plane
    ``spiral`` the same, then a spiral that grows from 0 to 8 mm radius and shrinks again, 1 mm deeper every 10 s

    Raises
    ------
    Error
        That lists the names there are
    """
def simulation_of(recording: Recording, law: ForceLaw | None = None) -> Simulation:
    """
    The simulation of a recording before its first step.

    Raises
    ------
    Error
        As above
    """
def standing_share(spin: typing.SupportsFloat | typing.SupportsIndex, radius: typing.SupportsFloat | typing.SupportsIndex) -> float:
    """
    How much of the friction is that of a standing head: 1 while the spindle stands, 0 from a rim speed of
    ``kFullSpinSpeed`` on, and a smooth step between.

    The hand-over: while it is between 0 and 1, dry friction acts with this share of its coefficients and the cutting
    ratio with the rest of its own, so that starting and stopping the spindle changes the force continuously.

    Parameters
    ----------
    spin
        [rad/s]
    radius
        [m] largest radius of the head
    """
def stiffness_for_accuracy(head: ToolHead, material: Material, spindle_speed: typing.SupportsFloat | typing.SupportsIndex, feed_speed: typing.SupportsFloat | typing.SupportsIndex) -> float:
    """
    The k_v from which on the engaged layer of a steady cut is thinner than a tenth of the head's radius:
    ``200 u v_f / (kappa omega R^3)``. Below it cutting forces come out low.

    Parameters
    ----------
    material
        u and kappa are used; kappa must be > 0
    spindle_speed
        [rad/s] not 0
    feed_speed
        [m/s] > 0

    Returns
    -------
    [N/m^4]

    Raises
    ------
    Error
        When one of them is out of range
    """
def stiffness_for_device(head: ToolHead, device_stiffness: typing.SupportsFloat | typing.SupportsIndex) -> float:
    """
    The greatest k_v that a directly driven device can render stably: ``K_max / largest_contact_stiffness(head)``.

    Parameters
    ----------
    device_stiffness
        [N/m] K_max > 0, the stiffest wall the device renders

    Returns
    -------
    [N/m^4] for a material of relative stiffness 1

    Raises
    ------
    Error
        When the device stiffness is not positive
    """
def tapered_head(tip_diameter: typing.SupportsFloat | typing.SupportsIndex, diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A truncated cone with a flat end, narrower at the tip (tapered fissure).
    """
def thesis_handle_torque(handle: RayHandle | LHandle, force_H: numpy.typing.ArrayLike, spin: typing.SupportsFloat | typing.SupportsIndex, zeta: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    """
    The torque of the thesis's handles (5.11-5.14), for comparison with it.

        ray:  roll about z_H:  T_res               pitch = yaw = 0
        L:    T = zeta (To - Ho) x F  +  zeta sin(bend) T_res o,   o = (To - Ho)/|To - Ho|

    with T_res the torque about the spindle's axis. The thesis writes the first term as the two components of the force
    across the offset times its length (pitch and roll), the second as the yaw, about the offset; which angle beta is,
    only its figure showed: read here as the bend of the handle. An L whose head sits on Ho has no offset and no torque.

    Parameters
    ----------
    force_H
        [N] on the tool, in the axes of H
    spin
        [N·m] T_res about +z of T
    zeta
        [1] the thesis's constant

    Returns
    -------
    [N·m] about Ho, in the axes of H
    """
@typing.overload
def transport(wrench_P: Wrench, p_QP: numpy.typing.ArrayLike) -> Wrench:
    """
    The same force felt at another point: the torque gains ``p_QP x force``, so that power ``F·V + T·Omega`` is unchanged
    (C19).

    Parameters
    ----------
    wrench_P
        the wrench about P
    p_QP
        [m] the vector from the new point Q to the old one P, in the frame of the wrench
    """
@typing.overload
def transport(twist_P: numpy.typing.ArrayLike, p_PQ: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """
    The velocity of another point Q of the same body.

    Parameters
    ----------
    twist_P
        the twist at P
    p_PQ
        [m] the vector from P to Q, in the frame of the twist
    """
def twist_between(from_: numpy.typing.ArrayLike, to: numpy.typing.ArrayLike, dt: typing.SupportsFloat | typing.SupportsIndex) -> numpy.typing.NDArray[numpy.float64]:
    """
    The constant twist of the body's origin that takes pose ``from`` to pose ``to`` in time ``dt``.
    """
def twist_drill_head(diameter: typing.SupportsFloat | typing.SupportsIndex, length: typing.SupportsFloat | typing.SupportsIndex, point_angle: typing.SupportsFloat | typing.SupportsIndex = 2.059488517353309) -> ToolHead:
    """
    A twist drill: only the cone of its point cuts, its side is smooth.

    Parameters
    ----------
    point_angle
        full angle of the point, less than pi; 118 degrees for a common drill
    length
        of the whole, more than that of the point
    """
@typing.overload
def validate(spindle: Spindle) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(material: Material) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(parameters: MolarParameters) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(friction: DryFriction) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(gravity: Gravity) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(filter: DeltaFilter) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(limits: OutputLimits) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(vibration: Vibration, update_rate: typing.SupportsFloat | typing.SupportsIndex) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(effects: Effects, update_rate: typing.SupportsFloat | typing.SupportsIndex) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
@typing.overload
def validate(config: SimulationConfig) -> None:
    """
    Raises
    ------
    Error
        Naming the field, its value and the allowed range
    """
def vector_from_rotation(rotation: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
    """
    The rotation vector of a rotation matrix (the logarithm of SO(3)).

    Returns
    -------
    [rad], length in [0, pi]
    """
def wheel_head(diameter: typing.SupportsFloat | typing.SupportsIndex, thickness: typing.SupportsFloat | typing.SupportsIndex, shank_diameter: typing.SupportsFloat | typing.SupportsIndex) -> ToolHead:
    """
    A disk that cuts with its rim and both faces; the face on the shank's side only outside of the shank.
    """
@typing.overload
def with_spacing(volume: GreyVolume, spacing: numpy.typing.ArrayLike) -> GreyVolume:
    """
    The same samples at another distance: for files whose header does not know. The first sample stays where it is.

    Parameters
    ----------
    spacing
        [m]
    """
@typing.overload
def with_spacing(volume: LabelVolume, spacing: numpy.typing.ArrayLike) -> LabelVolume:
    ...
def write_csv(recording: Recording, path: os.PathLike | str | bytes) -> None:
    """
    Writes the steps as text, a line a step, with the names of the columns on top and all digits.

    Raises
    ------
    Error
        When the recording cannot be read or the file cannot be written
    """
def write_npz(recording: Recording, path: os.PathLike | str | bytes) -> None:
    """
    Writes the steps as a NumPy archive (.npz): one array a column, of the names and shapes of the recording.

    Raises
    ------
    Error
        As above
    """
@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, volume: GreyVolume) -> None:
    """
    Writes a compressed NRRD file in millimetres. The file appears under its name only when it is complete.

    Raises
    ------
    Error
        When the volume is not consistent or the file cannot be written; what was there before remains
    """
@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, volume: LabelVolume) -> None:
    ...
@typing.overload
def write_nrrd(path: os.PathLike | str | bytes, workpiece: Workpiece) -> None:
    """
    Writes material ids under ``path`` and filled fractions under the name with ``_density`` before the extension.
    """
def write_picture(meshes: collections.abc.Sequence[ColoredMesh], options: PictureOptions, path: os.PathLike | str | bytes) -> None:
    """
    Writes a PNG picture: smooth shading, light from the upper left of the camera, 4x antialiasing. What was at ``path``
    before stays until the new file is complete.

    Raises
    ------
    Error
        When an option is out of range, there is nothing to show, a vertex is not finite, colours are missing or the file cannot be written completely
    """
@typing.overload
def write_ply(mesh: TriangleMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
    """
    Writes a binary PLY file, in units of ``unit_mm``.

    Raises
    ------
    Error
        As above
    """
@typing.overload
def write_ply(mesh: ColoredMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
    """
    Writes a binary PLY file with a colour per vertex.

    Raises
    ------
    Error
        As above, and when colours are missing
    """
def write_stl(mesh: TriangleMesh, path: os.PathLike | str | bytes, unit_mm: typing.SupportsFloat | typing.SupportsIndex = 1.0) -> None:
    """
    Writes a binary STL file, in units of ``unit_mm``. What was at ``path`` before stays until the new file is complete.

    Raises
    ------
    Error
        When the file cannot be written completely
    """
_pybind11_version: str = '3.1'
kFastestVibration: float = 0.45
kFullSpinSpeed: float = 0.01
kMaxVolumeSamples: int = 2147483648
kMolarCaries: int = 4
kMolarDentin: int = 2
kMolarEnamel: int = 1
kMolarPulp: int = 3
kRecordingFormat: int = 1
kRejected: int = 15
kWithIo: bool = True
