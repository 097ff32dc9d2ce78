// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/tool/profile.hpp"

/// @file
/// Meridians with every kind of edge, joint and corner.
namespace hapticut::test {

struct NamedProfile {
  std::string name;
  Profile profile;
};

inline void PrintTo(const NamedProfile& named, std::ostream* out) { *out << named.name; }

inline Profile ball_profile(double radius) { return {-radius, {{0, radius, radius}}}; }

inline Profile flat_profile(double radius, double height) {
  return {0, {{radius, 0}, {radius, height}, {0, height, 0, EdgeKind::smooth}}};
}

inline Profile cone_profile(double half_angle, double height) {
  return {0, {{height * std::tan(half_angle), height}, {0, height, 0, EdgeKind::smooth}}};
}

/// Profiles whose edges all cut, so the depth is exactly the distance to the surface.
inline std::vector<NamedProfile> closed_profiles() {
  using units::mm;
  std::vector<NamedProfile> profiles;
  profiles.push_back({"Ball", ball_profile(0.9 * mm)});
  profiles.push_back({"Capsule", {0, {{0.5 * mm, 0.5 * mm, 0.5 * mm}, {0.5 * mm, 1.7 * mm}, {0, 2.2 * mm, 0.5 * mm}}}});
  profiles.push_back(
      {"RoundedDisc",
       {0, {{0.9 * mm, 0}, {1.1 * mm, 0.2 * mm, 0.2 * mm}, {0.9 * mm, 0.4 * mm, 0.2 * mm}, {0, 0.4 * mm}}}});
  profiles.push_back({"Tree",
                      {0,
                       {{0.4 * mm, 0.7 * mm},
                        {0.25 * mm, 0.8 * mm},
                        {0.6 * mm, 1.3 * mm},
                        {0.45 * mm, 1.4 * mm},
                        {0.8 * mm, 1.9 * mm},
                        {0, 2 * mm}}}});
  profiles.push_back({"Hollow",
                      {0.2 * mm,
                       {{0.5 * mm, 0},
                        {0.9 * mm, 0.4 * mm, 0.4 * mm},
                        {0.7 * mm, 1.6 * mm, -1.1 * mm},
                        {0.3 * mm, 2 * mm},
                        {0, 1.8 * mm}}}});
  return profiles;
}

/// Profiles with smooth edges: shanks, safe sides, a safe tip.
inline std::vector<NamedProfile> profiles_with_smooth_edges() {
  using units::mm;
  constexpr EdgeKind kSmooth = EdgeKind::smooth;
  std::vector<NamedProfile> profiles;
  profiles.push_back({"RoundEnd", {0, {{0.5 * mm, 0.5 * mm, 0.5 * mm}, {0.5 * mm, 2 * mm}, {0, 2 * mm, 0, kSmooth}}}});
  profiles.push_back({"SafeSided", {0, {{0.6 * mm, 0}, {0.6 * mm, 2 * mm, 0, kSmooth}, {0, 2 * mm, 0, kSmooth}}}});
  profiles.push_back(
      {"SafeTip", {0, {{0.3 * mm, 0.1 * mm, 0.5 * mm, kSmooth}, {0.6 * mm, 1.8 * mm}, {0, 2 * mm, 0, kSmooth}}}});
  profiles.push_back(
      {"HalfSafeSide",
       {0, {{0.6 * mm, 0}, {0.6 * mm, 0.9 * mm}, {0.6 * mm, 2 * mm, 0, kSmooth}, {0, 2 * mm, 0, kSmooth}}}});
  profiles.push_back(
      {"RoundedRim",
       {0,
        {{0.9 * mm, 0}, {1.1 * mm, 0.2 * mm, 0.2 * mm}, {0.9 * mm, 0.4 * mm, 0.2 * mm}, {0, 0.4 * mm, 0, kSmooth}}}});
  profiles.push_back({"CutOffBall", {-0.8 * mm, {{0.48 * mm, 0.64 * mm, 0.8 * mm}, {0, 0.64 * mm, 0, kSmooth}}}});
  profiles.push_back({"Neck",
                      {-0.8 * mm,
                       {{0.8 * mm, 0, 0.8 * mm},
                        {0.64 * mm, 0.48 * mm, 0.8 * mm},
                        {0.3 * mm, 0.9 * mm, 0, kSmooth},
                        {0.3 * mm, 1.6 * mm, 0, kSmooth},
                        {0, 1.6 * mm, 0, kSmooth}}}});
  return profiles;
}

inline std::vector<NamedProfile> all_profiles() {
  std::vector<NamedProfile> all = closed_profiles();
  for (NamedProfile& p : profiles_with_smooth_edges()) all.push_back(std::move(p));
  return all;
}

}  // namespace hapticut::test
