// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Headers for a first program, in groups, in the order in which a program uses them, with what each is for. All of
/// them are part of hapticut::hapticut, the core. Each group lists the other headers of its folder, which are included
/// separately, as are the components: `build/` (scans, meshes, the molar), `surface/`, `heat/`, `islands/` (loose
/// pieces), `sound/`, `io/`, `import.hpp` (volumes and meshes of other programs), `settings/`, `analysis.hpp`, `view/`
/// and `c/`. `physics.hpp` and `closed_forms.hpp` do not need the library.

// Basics. Other headers: description.hpp (fields of structs, for tables and files), errors.hpp (Error), mesh.hpp,
// volume.hpp.
#include "hapticut/core/build_info.hpp"  // version(), build_info()
#include "hapticut/core/spatial.hpp"     // Vec3, Mat3, Pose, Twist, Wrench
#include "hapticut/core/units.hpp"       // units::mm, rpm, ...

// A tool: a head on a handle, and its spindle. Other headers: profile.hpp (heads of any profile),
// mesh_of_revolution.hpp, shank.hpp, cutter.hpp (Cutter, CutterKind).
#include "hapticut/tool/catalogue.hpp"  // round_head, tapered_head, ...: heads of burs by their size
#include "hapticut/tool/motors.hpp"     // common_spindle(speed), MotorKind
#include "hapticut/tool/tool.hpp"       // Tool; SphereHead, ConeHead, ...; RayHandle, LHandle; Spindle

// A workpiece: bodies of materials. Other headers: block.hpp, openvdb.hpp (OpenVDB grids). For voxels of your
// own, `contact/`.
#include "hapticut/workpiece/builders.hpp"          // Box, build_block, build_sphere, ...
#include "hapticut/workpiece/material_presets.hpp"  // presets::dentin(), find_preset
#include "hapticut/workpiece/workpiece.hpp"         // Workpiece, Material, MaterialTable

// The force laws, all of `force/laws/`; the default is FoundationLaw. Other headers: law.hpp (ForceLaw, to derive your
// own), stiffness.hpp, calibration.hpp (constants from drilling tests), friction.hpp, `effects/`.
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/lumped.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"

// The step, and the coupling between hand and tool. Other headers: observer.hpp (StepObserver, told of every step).
#include "hapticut/simulation/coupling.hpp"          // VirtualCoupling, CouplingGains
#include "hapticut/simulation/simulation.hpp"        // Simulation, SimulationConfig, StepResult, StepStatus
#include "hapticut/simulation/status_sentences.hpp"  // sentences_of(status)
#include "hapticut/simulation/thesis_mode.hpp"       // the model as the thesis has it

// Devices, here simulated ones; each maker's devices have a header in `device/`. The guard of the hand is in
// `safety/`; devices and loop include it.
#include "hapticut/device/device.hpp"           // Device, DeviceState, DeviceCapabilities
#include "hapticut/device/simulated/mock.hpp"   // MockDevice
#include "hapticut/device/simulated/mouse.hpp"  // MouseDevice

// The loop: steps in a separate thread, with commands to it and snapshots from it. Other headers: change_feed.hpp
// (changed blocks, for a display), workspace_map.hpp (WorkspaceMap, from the device to W).
#include "hapticut/loop/coupling_gains.hpp"     // coupling_gains(device)
#include "hapticut/loop/realtime_loop.hpp"      // RealtimeLoop
#include "hapticut/loop/simulation_model.hpp"   // SimulationModel
#include "hapticut/loop/spindle_interlock.hpp"  // SpindleInterlock, for a loop of your own
