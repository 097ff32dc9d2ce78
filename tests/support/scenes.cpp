// SPDX-License-Identifier: Apache-2.0
#include "support/scenes.hpp"

#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"

namespace hapticut::test {
namespace {

using units::deg;
using units::kPi;
using units::mm;

constexpr double kTick = 1e-3;  // [s]

Material bone_like(const char* name, double energy, double edge_pressure) {
  Material material;
  material.name = name;
  material.cutting_ratio = 0.5;
  material.specific_cutting_energy = energy;
  material.edge_pressure = edge_pressure;
  material.damping = 1;
  return material;
}

/// A straight motion along -z at 2 mm/s from just above the surface z = 0. It starts again after 4 s.
StepInput plunge(int tick) {
  const double depth = 0.002 * mm * (tick % 4000 + 1) - 0.05 * mm;
  return {Pose::from_translation(Vec3(0.0293, 0.0113, 0) * mm - Vec3(0, 0, depth)),
          {Vec3(0, 0, -2 * mm), Vec3::Zero()},
          kTick};
}

Scene axial_flat() {
  return {"axial_flat", "A flat head of 1 mm radius plunges into a block at 2 mm/s.",
          [] {
            return Simulation(
                build_block({Vec3(-2, -2, -9) * mm, Vec3(2, 2, 0) * mm}, 0.1 * mm, bone_like("bone", 3e8, 1e5)),
                Tool(FlatHead{1 * mm, 5 * mm}, RayHandle{20 * mm}, Spindle{2000 * units::rad_per_s}));
          },
          [](int tick) {
            StepInput input = plunge(tick);
            input.X_WH.translation.z() += 20 * mm;
            return input;
          }};
}

Scene cone_layers() {
  return {"cone_layers", "A 30 degree cone plunges through two layers of different material.",
          [] {
            return Simulation(
                build_layered_slab({Vec3(-4, -4, -6) * mm, Vec3(4, 4, 0) * mm}, 0.1 * mm,
                                   {{bone_like("hard", 1e9, 0), 1.05 * mm}, {bone_like("soft", 1e8, 0), 5 * mm}}),
                Tool(ConeHead{30 * deg, 3 * mm}, RayHandle{0}, Spindle{4000 * units::rad_per_s}));
          },
          [](int tick) { return plunge(tick % 3000); }};
}

/// A ball on an angled handpiece that cuts a circular groove, tilted by 20 degrees, while the wrist wobbles.
Scene circular_groove() {
  static const LHandle handle{100 * mm, 15 * mm, 70 * deg};
  return {"circular_groove", "A ball of 1.5 mm radius on an angled handpiece cuts a deepening circular groove.",
          [] {
            return Simulation(
                build_block({Vec3(-6, -6, -6) * mm, Vec3(6, 6, 0) * mm}, 0.1 * mm, bone_like("bone", 1e8, 1e5)),
                Tool(SphereHead{1.5 * mm}, handle, Spindle{-3000 * units::rad_per_s}));
          },
          [](int tick) {
            // The head's path is prescribed; the handle follows from it.
            const Pose X_HT = head_in_handle(handle);
            const auto head_pose = [](double t) {
              const double angle = 2 * kPi * t / 4;
              const Vec3 center(2.5 * mm * std::cos(angle), 2.5 * mm * std::sin(angle),
                                1.5 * mm - 0.1 * mm * std::min(t, 20.0));
              return Pose{rotation_from_vector(Vec3(20 * deg, 5 * deg * std::sin(3 * t), 0)), center};
            };
            const double t = kTick * (tick + 1);
            const Pose X_HT_inverse = X_HT.inverse();
            const Pose before = head_pose(t - kTick) * X_HT_inverse;
            const Pose after = head_pose(t) * X_HT_inverse;
            return StepInput{after, twist_between(before, after, kTick), kTick};
          }};
}

/// Workload W2 of the benchmarks with voxels of 0.1 mm: the ball moves down to 1.5 R at 2 mm/s, then sideways back and
/// forth.
Scene deep_ball() {
  return {"deep_ball", "A ball of 2 mm radius plunges 3 mm into a block at 2 mm/s, then moves sideways back and forth.",
          [] {
            return Simulation(build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, 0.1 * mm, bone_like("bone", 1e8, 0)),
                              Tool(SphereHead{2 * mm}, RayHandle{0}, Spindle{3000 * units::rad_per_s}));
          },
          [](int tick) {
            const auto at = [](int n) {
              const double s = 0.002 * mm * n;
              const double depth = std::min(s, 3 * mm);
              const double beyond = std::fmod(s - depth, 4 * mm);
              const double aside = beyond < 2 * mm ? beyond : 4 * mm - beyond;
              return Vec3(Vec3(20.013 * mm + aside, 20.007 * mm, 22 * mm - depth));
            };
            const Vec3 before = at(tick), after = at(tick + 1);
            return StepInput{Pose::from_translation(after), {(after - before) / kTick, Vec3::Zero()}, kTick};
          }};
}

Scene probing() {
  return {"probing", "A standing ball of 1 mm radius presses into a sphere and slides over it.",
          [] {
            return Simulation(build_sphere(Vec3::Zero(), 4 * mm, 0.1 * mm, bone_like("bone", 1e8, 0)),
                              Tool(SphereHead{1 * mm}, RayHandle{10 * mm}));
          },
          [](int tick) {
            const auto at = [](double t) {
              const double angle = 0.5 * std::sin(t);
              const double r = 4.8 * mm + 0.1 * mm * std::cos(7 * t);
              return Vec3(Vec3(r * std::sin(angle), 0, r * std::cos(angle) + 10 * mm));
            };
            const Vec3 before = at(kTick * tick), after = at(kTick * (tick + 1));
            return StepInput{Pose::from_translation(after), {(after - before) / kTick, Vec3::Zero()}, kTick};
          }};
}

/// Strokes of 20 mm at up to 0.5 m/s: every step is swept in sub-steps.
Scene fast_strokes() {
  return {"fast_strokes", "A ball of 1 mm radius strokes through soft material at up to 0.5 m/s.",
          [] {
            Material clay = bone_like("clay", 1e5, 0);
            return Simulation(build_block({Vec3(-12, -3, -3) * mm, Vec3(12, 3, 0) * mm}, 0.1 * mm, clay),
                              Tool(SphereHead{1 * mm}, RayHandle{0}, Spindle{5000 * units::rad_per_s}));
          },
          [](int tick) {
            const auto at = [](double t) {
              return Vec3(Vec3(10 * mm * std::sin(50 * t), 1.5 * mm * std::sin(0.7 * t),
                               0.5 * mm - 0.1 * mm * std::min(t, 10.0)));
            };
            const Vec3 before = at(kTick * tick), after = at(kTick * (tick + 1));
            return StepInput{Pose::from_translation(after), {(after - before) / kTick, Vec3::Zero()}, kTick};
          }};
}

}  // namespace

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {axial_flat(), cone_layers(), circular_groove(),
                                         deep_ball(),  probing(),     fast_strokes()};
  return all;
}

const Scene& find_scene(const std::string& name) {
  std::string known;
  for (const Scene& scene : scenes()) {
    if (scene.name == name) return scene;
    known += (known.empty() ? "" : ", ") + scene.name;
  }
  throw Error("there is no scene '" + name + "'; there are: " + known + ".");
}

}  // namespace hapticut::test
