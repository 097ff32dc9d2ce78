// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::bench {

/// Registers the benchmarks of the drawn surface: surface/...
void add_surfaces();

}  // namespace hapticut::bench
