// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "gestures/report.hpp"

namespace hapticut::gestures {

/// A demand that the library does not meet.
struct KnownFailure {
  std::string_view gesture, demand;  // as in Row
  std::string_view reason;           // one line
  std::string_view seen;             // the result when the row was added
};

/// The known failures in the order of the gestures. A test checks that each listed demand fails in at least one scene
/// and that no other demand fails.
[[nodiscard]] std::span<const KnownFailure> known_failures();

/// The reason why a row is not met; empty if it is met or not listed.
[[nodiscard]] std::string_view known_reason(const Row& row);

}  // namespace hapticut::gestures
