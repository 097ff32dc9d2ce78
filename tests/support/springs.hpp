// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hapticut/tool/head.hpp"

/// @file
/// The spring of a head at a point of its meridian plane.
namespace hapticut::test {

template <class Real = double>
MeridianSpring<Real> spring_at(const ToolHead& head, double rho, double z) {
  return head.visit_springs<Real>(
      [&](const auto& springs) -> MeridianSpring<Real> { return springs.spring(Real(rho), Real(z)); });
}

/// [m] positive inside
inline double margin_at(const ToolHead& head, double rho, double z) {
  return head.visit_springs<double>([&](const auto& springs) -> double { return springs.margin(rho, z); });
}

}  // namespace hapticut::test
