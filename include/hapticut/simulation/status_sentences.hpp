// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/simulation/step.hpp"

namespace hapticut {

/// What a step's status means and what to do about it, one sentence for each bit; "" of `ok`. `describe` (in Python
/// `describe_status`) has the names.
[[nodiscard]] inline std::string sentences_of(StepStatus status) {
  std::string sentences;
  for (const Named<StepStatus>& bit : names_of(Of<StepStatus>{}))
    if (has_any(status, bit.value)) sentences.append(sentences.empty() ? "" : " ").append(bit.words);
  return sentences;
}

}  // namespace hapticut
