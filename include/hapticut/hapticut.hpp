// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Everything of hapticut; the order is the order to read it in. `workpiece/openvdb.hpp`, the door to OpenVDB, and
/// `io/`, which is an optional component, are included on their own.

#include "hapticut/core/build_info.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/mesh.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/core/volume.hpp"
//
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/tool/profile.hpp"
#include "hapticut/tool/profile_table.hpp"
#include "hapticut/tool/shapes.hpp"
#include "hapticut/tool/spindle.hpp"
#include "hapticut/tool/tool.hpp"
//
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "hapticut/workpiece/material.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "hapticut/workpiece/mesh_builder.hpp"
#include "hapticut/workpiece/molar.hpp"
#include "hapticut/workpiece/removal.hpp"
#include "hapticut/workpiece/surface.hpp"
#include "hapticut/workpiece/volume_builders.hpp"
#include "hapticut/workpiece/workpiece.hpp"
//
#include "hapticut/force/contact_point.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/force/stiffness.hpp"
//
#include "hapticut/simulation/config.hpp"
#include "hapticut/simulation/energy.hpp"
#include "hapticut/simulation/scenes.hpp"
#include "hapticut/simulation/simulation.hpp"
#include "hapticut/simulation/step.hpp"
//
#include "hapticut/device/arming.hpp"
#include "hapticut/device/closed_loop.hpp"
#include "hapticut/device/device_models.hpp"
#include "hapticut/device/fault_bench.hpp"
#include "hapticut/device/guard.hpp"
#include "hapticut/device/output_limits.hpp"
#include "hapticut/device/passivity.hpp"
#include "hapticut/device/plant.hpp"
#include "hapticut/device/pose_gate.hpp"
#include "hapticut/device/safety_log.hpp"
#include "hapticut/device/stability.hpp"
#include "hapticut/device/state.hpp"
#include "hapticut/device/thermal_budget.hpp"
#include "hapticut/device/watchdog.hpp"
