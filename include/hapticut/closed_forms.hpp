// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Results of the model in closed form: C1 ... C45 of docs/model.md, one function each, in its order. `hapticut
/// validate` and the tests compare the library with them, and the tests in tests/unit/closed_forms compare them with
/// integrals of the model's equations.
///
/// They do not call the library; like hapticut::physics they are headers that need only Eigen. Everything is in SI;
/// forces and torques act on the tool. Unless stated otherwise, the material is the half space z < 0, the head is
/// upright with its axis along z, and `depth` is that of its lowest point below the surface. In steady cuts the spindle
/// turns about +z, and the feed is along +x or -z. They are limits for an engaged layer (C34) that is thin compared
/// with the head, and for a feed that is slow compared with the rim.

#include "hapticut/closed_forms/other_laws.hpp"
#include "hapticut/closed_forms/standing_head.hpp"
#include "hapticut/closed_forms/steady_cut.hpp"
#include "hapticut/closed_forms/texture.hpp"
