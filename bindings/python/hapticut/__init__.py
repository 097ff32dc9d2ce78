# SPDX-License-Identifier: Apache-2.0
"""The cutting force model for haptic rendering: single steps, runs and sweeps.

The names are those of the C++ library (``docs/python.md`` lists the exceptions). All quantities are in SI units and in
the world frame W, the frame of the workpiece, unless a name says otherwise. Arrays are float64: points ``(n, 3)``,
poses ``(4, 4)`` homogeneous matrices, twists ``(6,)`` linear then angular. Errors raise ``hapticut.Error``, which says
what was given, what is allowed and what to do.

This module builds a workpiece and a tool and moves the tool through the workpiece. The submodules:

``catalogue``, ``presets``, ``units``
    ready-made heads, ready-made materials, factors to SI
``closed_forms``
    the model in closed form, to compare with
``analysis``
    closed loops, stability and faults, without a device
``calibration``, ``effects``
    materials from measurements; effects added to the model's force before a hand feels it
``volume``, ``io``
    scans and their processing; files of volumes, meshes, voxels, recordings and pictures
``device``, ``loop``, ``safety``
    haptic devices, the 1 kHz thread, the guard that protects the hand
``heat``, ``islands``
    temperatures; loose pieces
``surface``, ``sound``
    the surface for drawing, the sound of the drill
``sweep``
    many runs on many processors; imported at first use
"""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from . import (
    analysis as analysis,
    calibration as calibration,
    catalogue as catalogue,
    closed_forms as closed_forms,
    device as device,
    effects as effects,
    heat as heat,
    io as io,
    islands as islands,
    loop as loop,
    presets as presets,
    safety as safety,
    sound as sound,
    surface as surface,
    units as units,
    volume as volume,
)
from ._export import export, where_is
from ._hapticut import (
    # Basic types
    BuildInfo as BuildInfo,
    Color as Color,
    ColoredMesh as ColoredMesh,
    Error as Error,
    TriangleMesh as TriangleMesh,
    Wrench as Wrench,
    advance as advance,
    build_info as build_info,
    is_rotation as is_rotation,
    orthonormalized as orthonormalized,
    rotation_from_vector as rotation_from_vector,
    transport as transport,
    twist_between as twist_between,
    vector_from_rotation as vector_from_rotation,

    # Tool: head, handle, spindle
    ConeHead as ConeHead,
    Cutter as Cutter,
    CutterKind as CutterKind,
    EdgeKind as EdgeKind,
    FlatHead as FlatHead,
    FlatRule as FlatRule,
    HandleTorque as HandleTorque,
    HeadBox as HeadBox,
    LHandle as LHandle,
    MeridianSpring as MeridianSpring,
    MotorKind as MotorKind,
    Profile as Profile,
    ProfileEdge as ProfileEdge,
    ProfileHead as ProfileHead,
    RayHandle as RayHandle,
    Sharpness as Sharpness,
    SphereHead as SphereHead,
    Spindle as Spindle,
    SpindleState as SpindleState,
    Spring as Spring,
    Tool as Tool,
    ToolHead as ToolHead,
    common_spindle as common_spindle,
    head_in_handle as head_in_handle,
    kMaxSpindleSpeed as kMaxSpindleSpeed,
    mesh_of_revolution as mesh_of_revolution,
    thesis_handle_torque as thesis_handle_torque,

    # Workpiece: materials and voxels
    Box as Box,
    Estimate as Estimate,
    GridFrame as GridFrame,
    IndexBox as IndexBox,
    Material as Material,
    MaterialAmount as MaterialAmount,
    MaterialTable as MaterialTable,
    RayHit as RayHit,
    Workpiece as Workpiece,
    WorkpieceSnapshot as WorkpieceSnapshot,
    WorkpieceSurface as WorkpieceSurface,
    extract_surface as extract_surface,
    find_preset as find_preset,
    kBlockEdge as kBlockEdge,
    kBlockVoxels as kBlockVoxels,
    kEmpty as kEmpty,
    kMaxMaterials as kMaxMaterials,
    preset_color as preset_color,
    preset_names as preset_names,

    # Workpiece: built from shapes, meshes and scans
    BodyDescription as BodyDescription,
    Grade as Grade,
    GreyRange as GreyRange,
    LabelMaterial as LabelMaterial,
    Layer as Layer,
    MeshImport as MeshImport,
    MeshShell as MeshShell,
    MolarParameters as MolarParameters,
    UnclaimedLabels as UnclaimedLabels,
    VolumeBuildOptions as VolumeBuildOptions,
    build_block as build_block,
    build_body as build_body,
    build_from_grey as build_from_grey,
    build_from_labels as build_from_labels,
    build_from_mesh as build_from_mesh,
    build_from_shells as build_from_shells,
    build_layered_slab as build_layered_slab,
    build_molar as build_molar,
    build_sphere as build_sphere,
    describe_molar as describe_molar,
    kMolarCaries as kMolarCaries,
    kMolarDentin as kMolarDentin,
    kMolarEnamel as kMolarEnamel,
    kMolarPulp as kMolarPulp,
    materials_of as materials_of,

    # Force: laws, friction, how stiff the foundation is
    ContactMechanicsLaw as ContactMechanicsLaw,
    DampingMatrixLaw as DampingMatrixLaw,
    DryFriction as DryFriction,
    ForceLaw as ForceLaw,
    FoundationLaw as FoundationLaw,
    HertzianBurrLaw as HertzianBurrLaw,
    Quadrature as Quadrature,
    RemovalLaw as RemovalLaw,
    ThesisLaw as ThesisLaw,
    TwistDrillLaw as TwistDrillLaw,
    max_contact_stiffness as max_contact_stiffness,
    stiffness_for_accuracy as stiffness_for_accuracy,
    stiffness_for_head as stiffness_for_head,
    stiffness_for_device as stiffness_for_device,

    # Simulation: one step, and runs of many
    Contact as Contact,
    ContactProbe as ContactProbe,
    ContactTime as ContactTime,
    EnergyLedger as EnergyLedger,
    ProbedMotions as ProbedMotions,
    Simulation as Simulation,
    SimulationConfig as SimulationConfig,
    StageTimes as StageTimes,
    StepInput as StepInput,
    StepResult as StepResult,
    StepStatus as StepStatus,
    ThesisMode as ThesisMode,
    WorstCase as WorstCase,
    check_input as check_input,
    describe_status as describe_status,
    has_any as has_any,
    kRejected as kRejected,
    max_blocks as max_blocks,
    max_voxels as max_voxels,
    thesis_mode as thesis_mode,
    validate as validate,

    # Simulation: coupled to a hand
    CoupledResult as CoupledResult,
    CouplingEnergy as CouplingEnergy,
    CouplingGains as CouplingGains,
    VirtualCoupling as VirtualCoupling,
    coupling_gains as coupling_gains,
)
from ._pose import Pose as Pose

if TYPE_CHECKING or io.kWithIo:
    from ._hapticut import (
        # Tool: heads from meshes
        RecognizedProfile as RecognizedProfile,
        profile_from_mesh as profile_from_mesh,
    )

if TYPE_CHECKING:
    from .sweep import CallableModule

    sweep: CallableModule
else:

    def __getattr__(name: str) -> Any:
        if name == "sweep":
            return importlib.import_module(f"{__name__}.sweep")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{where_is(name)}")


export(__name__, "Pose", "analysis", "calibration", "catalogue", "closed_forms", "device", "effects", "heat", "io",
       "islands", "loop", "presets", "safety", "sound", "surface", "sweep", "units", "volume")
__version__: str = build_info().version
