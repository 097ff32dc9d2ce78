// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::bench {

/// Benchmarks of the surface that is shown beside the loop: surface/...
void add_surfaces();

}  // namespace hapticut::bench
