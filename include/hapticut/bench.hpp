// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Component `bench`, target hapticut::bench: what measures the library. Fixed scenes; a device, a hand and a wall in a
/// closed loop; the contact behind a coupling; faults of a device; the table of stability; the closed forms of the
/// model.

#include "hapticut/bench/closed_forms.hpp"
#include "hapticut/bench/closed_loop.hpp"
#include "hapticut/bench/contact_bench.hpp"
#include "hapticut/bench/fault_bench.hpp"
#include "hapticut/bench/scenes.hpp"
#include "hapticut/bench/stability.hpp"
