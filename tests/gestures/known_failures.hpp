// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "gestures/report.hpp"

namespace hapticut::gestures {

/// A demand that the library does not meet yet.
struct KnownFailure {
  std::string_view gesture, demand;  // as in Row
  std::string_view reason;           // one line
  std::string_view seen;             // when it was put on the list
};

/// In the order of the gestures. What is on the list fails in a scene at least, and what is not does not: tests.
[[nodiscard]] std::span<const KnownFailure> known_failures();

/// Why a row is not met; empty where it is, or where that is not known.
[[nodiscard]] std::string_view known_reason(const Row& row);

}  // namespace hapticut::gestures
