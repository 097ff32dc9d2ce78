// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Headers for a first program, in groups, in the order in which a program uses them. All of them are part of
/// hapticut::hapticut, the core. Each group lists the other headers of its folder, which are included separately, as
/// are the components: `build/` (scans, meshes, the molar), `surface/`, `heat/`, `sound/`, `io/`, `settings/`,
/// `analysis.hpp`, `view/` and `c/`. `physics.hpp` and `closed_forms.hpp` do not need the library.

// Basics: units, poses, and the version.
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

// A tool: a head on a handle, and its spindle. Other headers: heads of any profile, shanks, heads from meshes.
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/tool.hpp"

// A workpiece: bodies of materials. Other headers: loose pieces, OpenVDB grids.
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/workpiece.hpp"

// The force laws, all of `force/laws/`; the default is FoundationLaw. Other headers: friction, effects.
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/lumped.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"

// The step, and the coupling between hand and tool.
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "hapticut/simulation/thesis_mode.hpp"

// Devices, here simulated ones; each manufacturer's devices have a header in `device/`.
#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"

// The loop: steps in a separate thread, with commands to it and snapshots from it.
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/loop/spindle_interlock.hpp"
