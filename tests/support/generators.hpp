// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/tool.hpp"

/// @file
/// Random inputs for properties. Continuous numbers are drawn as thousandths of their range, so that shrinking works.
namespace hapticut::test {

inline rc::Gen<double> number_between(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1000001), [=](int n) { return low + (high - low) * n / 1e6; });
}

/// Any shape of head of the library, 0.2 to 3 mm large.
inline rc::Gen<ToolHead> arbitrary_head() {
  using units::deg;
  using units::mm;
  return rc::gen::apply(
      [](int kind, double a, double b, double angle) -> ToolHead {
        if (kind == 0) return SphereHead{a};
        if (kind == 1) return ConeHead{angle, b};
        constexpr FlatRule kRules[] = {FlatRule::nearest, FlatRule::bottom_only, FlatRule::side_only, FlatRule::both};
        return FlatHead{a, b, kRules[kind - 2]};
      },
      rc::gen::inRange(0, 6), number_between(0.2 * mm, 3 * mm), number_between(0.2 * mm, 3 * mm),
      number_between(10 * deg, 80 * deg));
}

/// Uniformly distributed rotations, from a seed.
inline rc::Gen<Mat3> arbitrary_rotation() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                      [](std::uint64_t seed) { return RandomPoses(seed).rotation(); });
}

inline rc::Gen<Vec3> arbitrary_vector(double longest) {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                      [=](std::uint64_t seed) { return RandomPoses(seed).vector(longest); });
}

}  // namespace hapticut::test
