// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::bench {

/// Registers the benchmarks of the surface beside the loop: surface/...
void add_surfaces();

}  // namespace hapticut::bench
