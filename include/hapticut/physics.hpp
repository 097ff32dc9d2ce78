// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Component `physics`, target hapticut::physics: the arithmetic of the force for programs that bring voxels of their
/// own. The samples of a block, the laws on them, what a cut takes away, their resultant, friction, the handle, the
/// spindle, effects. Headers that need Eigen and nothing else; nothing of ours is linked. What they give on paper is in
/// closed_forms.hpp.
///
///     sample_contact -> ForceLaw::evaluate -> sum_resultant -> find_changes         block by block
///
/// Of these headers and of those they include, hapticut::hapticut is needed for ProfileHead's constructor and
/// exact_spring alone: the table of a profile is compiled. So are the heads of tool/catalogue.hpp, meshes of profiles,
/// the calibration of drilling tests and the presets of materials, which are not named here.

#include "hapticut/core/decay.hpp"
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
#include "hapticut/workpiece/block.hpp"
#include "hapticut/workpiece/block_mask.hpp"
#include "hapticut/workpiece/changes.hpp"
#include "hapticut/workpiece/contact.hpp"
#include "hapticut/workpiece/cut_voxel.hpp"
#include "hapticut/workpiece/material.hpp"
//
#include "hapticut/force/contact_materials.hpp"
#include "hapticut/force/contact_stiffness.hpp"
#include "hapticut/force/deep_contact.hpp"
#include "hapticut/force/effects/axis_mask.hpp"
#include "hapticut/force/effects/delta_filter.hpp"
#include "hapticut/force/effects/gravity.hpp"
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
