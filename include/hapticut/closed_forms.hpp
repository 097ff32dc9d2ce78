// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// What the model gives where it can be worked out on paper: the closed forms C1 ... C42 of docs/model.md, one function
/// each, in its order. `hapticut validate` and the tests hold the library against them, and the tests in
/// tests/unit/closed_forms hold them against integrals of the model's equations.
///
/// They do not call the library: like hapticut::physics they are headers that need Eigen. Everything is in SI; forces
/// and torques act on the tool. Where nothing else is said, the material is the half space z < 0, the head stands
/// upright, its axis along z, and `depth` is that of its lowest point below the surface. Steady cuts turn about +z and
/// are fed along +x or -z; they are limits of an engaged layer (C34) that is thin against the head, and of a feed that
/// is slow against the rim.

#include "hapticut/closed_forms/other_laws.hpp"
#include "hapticut/closed_forms/standing_head.hpp"
#include "hapticut/closed_forms/steady_cut.hpp"
