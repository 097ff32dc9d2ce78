// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gestures/report.hpp"

namespace hapticut::gestures {

/// docs/gestures.md, of the rows of all gestures at all sizes of voxels.
[[nodiscard]] std::string page_of(const std::vector<Row>& rows);

/// The lines of a page without what was seen, and what follows from it: its last digits depend on the processor.
[[nodiscard]] std::vector<std::string> lasting_lines(const std::string& page);

}  // namespace hapticut::gestures
