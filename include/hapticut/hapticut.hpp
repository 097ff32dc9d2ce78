// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// What a first program needs, by groups in the order in which it needs them. All of it is hapticut::hapticut, the
/// core. Each group says what else its folder has; a file of that is included on its own, and so are the components:
/// `build/` (scans, meshes, the molar), `surface/`, `heat/`, `sound/`, `io/`, `settings/`, `analysis.hpp`, `view/`
/// and `c/`. `physics.hpp` and `closed_forms.hpp` are what stands without a library.

// Words: millimetres and revolutions per minute, poses, which version this is.
#include "hapticut/core/build_info.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

// A tool: a head on a handle, and the spindle that turns it. Also there: heads of any profile, shanks, heads from
// meshes.
#include "hapticut/tool/catalogue.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/tool.hpp"

// A workpiece: bodies of materials. Also there: loose pieces, grids of OpenVDB.
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/workpiece.hpp"

// The force: every law to choose from, all of `force/laws/`. The default, FoundationLaw, needs no choice. Also there:
// friction, effects.
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/lumped.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"

// The step, and the coupling that holds the tool for the hand.
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/simulation/status_sentences.hpp"
#include "hapticut/simulation/thesis_mode.hpp"

// A device behind its guard, here simulated ones; those of makers have a header each in `device/`.
#include "hapticut/device/device.hpp"
#include "hapticut/device/simulated/mock.hpp"
#include "hapticut/device/simulated/mouse.hpp"

// The loop: the steps in a thread of their own, with commands to it and snapshots from it.
#include "hapticut/loop/realtime_loop.hpp"
#include "hapticut/loop/simulation_model.hpp"
#include "hapticut/loop/spindle_interlock.hpp"
