// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Component `analysis`, target hapticut::analysis: tells whether a hand, a device and a force model make a stable
/// loop, in simulated time and without a device. It has the closed loop and the textbook's wall; the maximum stable
/// stiffness, bounces and presses; the library's model, a ball pressed into voxels; and the effect of faults on the
/// hand.

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/analysis/faults.hpp"
#include "hapticut/analysis/pressed_ball.hpp"
#include "hapticut/analysis/stability.hpp"
