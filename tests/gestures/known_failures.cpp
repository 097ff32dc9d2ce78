// SPDX-License-Identifier: Apache-2.0
// The demands on gestures that the library does not meet. docs/validation.md names them for users.
#include "gestures/known_failures.hpp"

#include <array>

namespace hapticut::gestures {
namespace {

constexpr std::string_view kPoint =
    "a point or ridge thinner than a voxel is met or missed, and its springs turn within a voxel";
constexpr std::string_view kGroove = "the groove is a fifth of a voxel deep";

constexpr auto kKnown = std::to_array<KnownFailure>({
    {"G14", "indents", kPoint,
     "needle, flame at 0.2 mm 1.04, 1.29 of the bound; edges of a christmas tree 1.08 ... 1.58"},
    {"G42", "volume", kGroove, "3.0 % of 2 %, ball 1.6 mm in enamel at 0.2 mm"},
    {"G45", "sinks", kPoint, "0.33 mm of 0.2, 0.24 mm, at 0.2 mm"},
    {"G45", "hole that is left", kPoint, "0 ... 0.08 of 0.006 ... 0.1"},
    {"G45", "invariant 1", kPoint, "entered 1.5 ... 36 %, unexplained by the coupling up to 18 %"},
    {"G45", "invariant 7", kPoint, "0.331 and 0.257 mm, 0.286 and 0.248 mm"},
});

}  // namespace

std::span<const KnownFailure> known_failures() { return kKnown; }

std::string_view known_reason(const Row& row) {
  if (row.is_met) return {};
  for (const KnownFailure& failure : kKnown)
    if (failure.gesture == row.gesture && failure.demand == row.demand) return failure.reason;
  return {};
}

}  // namespace hapticut::gestures
