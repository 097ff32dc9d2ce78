// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include "experiments/setup/random_pose.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/tool/tool.hpp"
#include "support/usual_heads.hpp"

/// @file
/// Random inputs for properties. Continuous numbers are drawn as thousandths of their range, so that shrinking works.
namespace hapticut::test {

inline rc::Gen<double> number_between(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1000001), [=](int n) { return low + (high - low) * n / 1e6; });
}

/// Any shape of head of the library, 0.2 to 3 mm large. The shapes that are not named here have their usual
/// proportions.
inline rc::Gen<ToolHead> arbitrary_head() {
  using units::deg;
  using units::mm;
  constexpr int kOfKnown = 6;  // kinds
  constexpr auto other_heads = usual_heads<SphereHead, ConeHead, FlatHead>;
  return rc::gen::apply(
      [](int kind, double a, double b, double angle) -> ToolHead {
        if (kind == 0) return SphereHead{a};
        if (kind == 1) return ConeHead{angle, b};
        if (kind >= kOfKnown) return other_heads(b / (2 * mm))[std::size_t(kind - kOfKnown)];
        constexpr FlatRule kRules[] = {FlatRule::nearest, FlatRule::bottom_only, FlatRule::side_only, FlatRule::both};
        return FlatHead{a, b, kRules[kind - 2]};
      },
      rc::gen::inRange(0, kOfKnown + int(other_heads(1).size())), number_between(0.2 * mm, 3 * mm),
      number_between(0.2 * mm, 3 * mm), number_between(10 * deg, 80 * deg));
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
