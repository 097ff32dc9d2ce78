// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Component `physics`, target hapticut::physics: the arithmetic of the force, for programs that have their own voxels.
/// Samples of a block, force laws, changes by a cut, resultant, friction, handle, spindle, effects. These headers need
/// only Eigen and link nothing of the library. closed_forms.hpp has their results in closed form.
///
///     sample_contact -> ForceLaw::evaluate -> sum_resultant -> find_changes         block by block
///
/// Only ProfileHead's constructor and exact_spring, whose table is compiled, and Material::with need
/// hapticut::hapticut. The heads of tool/catalogue.hpp, meshes of profiles, the calibration of drilling tests and the
/// presets of materials are compiled too, so they are not included here.

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
//
#include "hapticut/tool/handle.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/tool/motors.hpp"
#include "hapticut/tool/shapes.hpp"
#include "hapticut/tool/spindle.hpp"
#include "hapticut/tool/tool.hpp"
//
#include "hapticut/contact/changes.hpp"
#include "hapticut/contact/contact.hpp"
#include "hapticut/contact/cut_voxel.hpp"
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/block_mask.hpp"
#include "hapticut/workpiece/material.hpp"
//
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/effects/axis_mask.hpp"
#include "hapticut/force/effects/delta_filter.hpp"
#include "hapticut/force/effects/gravity.hpp"
#include "hapticut/force/effects/output_limits.hpp"
#include "hapticut/force/effects/vibration.hpp"
#include "hapticut/force/friction.hpp"
#include "hapticut/force/law.hpp"
#include "hapticut/force/laws/contact_mechanics.hpp"
#include "hapticut/force/laws/damping_matrix.hpp"
#include "hapticut/force/laws/foundation.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/force/laws/lumped.hpp"
#include "hapticut/force/laws/thesis.hpp"
#include "hapticut/force/laws/twist_drill.hpp"
#include "hapticut/force/limit_surface.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/force/spread_friction.hpp"
#include "hapticut/force/stiffness.hpp"
#include "hapticut/force/whole_contact.hpp"
