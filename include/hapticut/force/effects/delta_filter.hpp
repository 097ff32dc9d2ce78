// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/core/description.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"

namespace hapticut {

/// The force filter of the thesis (Table 6.1), for comparison with it: the default is the slew limit.
///
///     |F_previous - F_calculated| > delta:  F = F_previous + epsilon along the difference;  otherwise F = F_calculated
///
/// The table adds the number epsilon to a vector. As a step along the difference vector it keeps its direction and does
/// not run away when the force is released. It still lags: it changes by epsilon a step whatever the rate, 3 N in half
/// a second. The torque is formed from the filtered force, as if the filter took the difference away at the head
/// (6.2.5: "due to the output net force and cutting operation").
struct DeltaFilter {
  double delta = 0.5;      ///< [N] maximum force change per step that passes unchanged
  double epsilon = 0.005;  ///< [N] force change per step when the calculated one is larger; not more than delta
};

constexpr auto fields_of(Of<DeltaFilter>) {
  return std::tuple{
      field("delta", &DeltaFilter::delta, "N", Range::positive(),
            "maximum force change per step that passes unchanged"),
      field("epsilon", &DeltaFilter::epsilon, "N", Range::positive(),
            "force change per step when the calculated one is larger; not more than delta"),
  };
}

/// @throws Error naming the field, its value and the allowed range
inline void validate(const DeltaFilter& filter) {
  require_fields_within(filter, "DeltaFilter::");
  if (filter.epsilon > filter.delta)
    throw Error("DeltaFilter::epsilon"_name + " = " + format_number(filter.epsilon, filter.delta) +
                " N; must not exceed delta = " + format_number(filter.delta, filter.epsilon) +
                " N, or the force would overshoot. Lower it, or raise delta.");
}

/// @realtime no allocation, no lock; O(1)
[[nodiscard]] inline Vec3 filtered(const DeltaFilter& filter, const Vec3& previous, const Vec3& calculated) {
  const Vec3 difference = calculated - previous;
  const double length = difference.norm();
  return length > filter.delta ? Vec3(previous + difference * (filter.epsilon / length)) : calculated;
}

}  // namespace hapticut
