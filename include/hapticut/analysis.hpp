// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Component `analysis`, target hapticut::analysis: whether a hand, a device and a force model make a stable loop, in
/// simulated time and without a device. The closed loop and the textbook's wall; the largest stable stiffness, bounces,
/// presses; the model of the library in it, a ball pressed into voxels; what the hand feels of faults.

#include "hapticut/analysis/closed_loop.hpp"
#include "hapticut/analysis/faults.hpp"
#include "hapticut/analysis/pressed_ball.hpp"
#include "hapticut/analysis/stability.hpp"
