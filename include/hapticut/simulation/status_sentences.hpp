// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/simulation/step.hpp"

namespace hapticut {

/// Says what the status of a step means and what to do about it, one sentence for each bit; "" for `ok`. `describe` (in
/// Python `describe_status`) gives the names of the bits.
[[nodiscard]] inline std::string sentences_of(StepStatus status) {
  std::string sentences;
  for (const Named<StepStatus>& bit : names_of(Of<StepStatus>{}))
    if (has_any(status, bit.value)) sentences.append(sentences.empty() ? "" : " ").append(bit.words);
  return sentences;
}

}  // namespace hapticut
