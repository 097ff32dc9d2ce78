// SPDX-License-Identifier: Apache-2.0
// A ball pressed into layers and into graded stiffness: C10 and C12.
#include <algorithm>
#include <cmath>

#include "experiments/convergence.hpp"
#include "experiments/vocabulary.hpp"

namespace hapticut::experiments {
namespace pressed_layers {

constexpr double kCoarsest = 0.1 * mm, kDepth = 0.7 * kR, kThickness = 0.267 * kR;
const Vec3 kCenter(0, 0, kR - kDepth);

double force_at(Workpiece workpiece) {
  Simulation simulation(std::move(workpiece), Tool(SphereHead{kR}), static_config());
  return rest_ok_at(simulation, kCenter).force.z();
}

/// [N] Force by C10. @param second  [1] relative stiffness below the first layer; 0: air
double expected_force(double second, double thickness = kThickness) {
  return forms::layered_cap_force(kStiffness, second * kStiffness, thickness, kR, kDepth);
}

/// @param on_grid  the layers meet on a face of the voxels
Convergence into_layers(double second, bool on_grid) {
  return converge(kCoarsest, [&](double l, const Vec3& phase) {
    Vec3 p = phase;
    if (on_grid) p.z() = -kThickness / l;
    Box box = half_space(kR, kDepth, l);
    if (second == 0) box.min.z() = -kThickness;
    return force_at(box_at_phase(box, l, p, materials_of_stiffness({1, second == 0 ? 1 : second}),
                                 [&](const Vec3& q) { return MaterialId(q.z() > -kThickness ? 1 : 2); })) /
               expected_force(second) -
           1;
  });
}

/// The library's slab starts at the box's lower corner, so the layers meet on a face of voxels, 16 voxels above it.
double force_of_slab(double thickness) {
  Material hard, soft;
  hard.name = "hard", soft.name = "soft", soft.relative_stiffness = 0.2;
  const double l = 0.025 * mm, side = 1.1 * kR;
  const Box box = {Vec3(-side - 0.3 * l, -side - 0.6 * l, -thickness - 32 * l), Vec3(side, side, 0)};
  return force_at(build_layered_slab(box, l, {{hard, thickness}, {soft, 2 * kR}}));
}

std::vector<Check> layers() {
  // The errors of C1 do not cancel where the stiffness changes: 0.33 (l/d)^2.
  Refined on_face("C10", "ball through a layer that ends on a face of the voxels, force", kSecondOrder, "0.4 (l/d)^2");
  on_face.add(into_layers(0.2, true), second_order(0.4, kDepth));
  // A voxel has one material, so the interface is off by up to half a voxel: l/4 root mean square, times the change of
  // stiffness.
  Refined inside("C10 inside voxels", "ball through a layer that ends inside voxels, force", 1,
                 "0.8 l/d, a voxel has one material", {0.3, "of twelve phases"});
  inside.add(into_layers(0.2, false), [](double l) { return 0.8 * l / kDepth; });
  // At the plate's lower face the material lies on the near side, as in C1 beyond R.
  const double below = kR - kDepth + kThickness;
  const double near_side = kPi / 3 * below * (kR - below) * kStiffness;
  Refined breakthrough("C10 breakthrough", "ball through a plate", kSecondOrder,
                       "1.2 of the error by the fills at the lower face");
  breakthrough.add(into_layers(0, false),
                   second_order(1.2 * near_side * kThickness * kThickness / expected_force(0), kThickness));
  const double thickness = 0.2675 * kR;
  constexpr Tolerance kVoxels = {1e-3, "voxels of d/28"};
  const Check slab = {
      "C10 slab", "layers built by the library", "N", expected_force(0.2, thickness), force_of_slab(thickness),
      kVoxels};
  return joined({on_face.checks(), inside.checks(), breakthrough.checks(), {slab}});
}

/// k_v = kStiffness (1 + slope . p) for p in the half space.
double relative_stiffness(const Vec3& slope, const Vec3& p) { return 1 + slope.dot(p); }

/// @param slope  [1/m]
template <class Press>
Convergence into_grade(const Vec3& slope, const Press& press) {
  const Vec3 expected = forms::graded_cap_force(kStiffness, kStiffness * slope, kR, kDepth);
  return converge(kCoarsest, [&](double l, const Vec3& phase) {
    Simulation simulation(press(l, phase), Tool(SphereHead{kR}), static_config());
    return (rest_ok_at(simulation, kCenter).force - expected).norm() / expected.norm();
  });
}

/// One material for each layer of voxels, with the stiffness of the grade at the middle of the layer.
Convergence into_depth_grade() {
  const Vec3 slope(0, 0, -2 / mm);
  return into_grade(slope, [&](double l, const Vec3& phase) {
    std::vector<double> stiffnesses;
    const double first_face = (phase.z() - 1) * l;  // the lower face of the partly filled layer
    stiffnesses.push_back(relative_stiffness(slope, Vec3(0, 0, first_face / 2)));
    for (int layer = 0; first_face - layer * l > -kDepth - 3 * l; ++layer)
      stiffnesses.push_back(relative_stiffness(slope, Vec3(0, 0, first_face - (layer + 0.5) * l)));
    return box_at_phase(half_space(kR, kDepth, l), l, phase, materials_of_stiffness(stiffnesses),
                        [&](const Vec3& p) { return MaterialId(1 + std::max(0, int((first_face - p.z()) / l + 1))); });
  });
}

/// A full table of materials, in equal steps of stiffness from 0 to 3. The error of half a step, 0.006, has both signs
/// all over the contact, so it averages out.
Convergence into_side_grade() {
  const Vec3 slope(0.6 / mm, -0.3 / mm, -0.5 / mm);
  constexpr int kSteps = kMaxMaterials;
  std::vector<double> stiffnesses;
  stiffnesses.reserve(kSteps);
  for (int i = 0; i < kSteps; ++i) stiffnesses.push_back(3 * (i + 0.5) / kSteps);
  return into_grade(slope, [&](double l, const Vec3& phase) {
    return box_at_phase(half_space(kR, kDepth, l), l, phase, materials_of_stiffness(stiffnesses), [&](const Vec3& p) {
      const int step = int(relative_stiffness(slope, p) / 3 * kSteps);
      return MaterialId(1 + std::clamp(step, 0, kSteps - 1));
    });
  });
}

std::vector<Check> grades() {
  Refined down("C12", "stiffness that grows with depth, force vector", kSecondOrder, "0.5 (l/d)^2");
  down.add(into_depth_grade(), second_order(0.5, kDepth));
  // A full voxel has the stiffness of its centre and lacks -l^2/12 of grad(k) . grad(w n): 0.19 (l/d)^2 with the fills
  // of C1.
  Refined aside("C12 sideways", "stiffness that grows sideways too", kSecondOrder, "0.21 (l/d)^2");
  aside.add(into_side_grade(), second_order(0.21, kDepth));
  return joined({down.checks(), aside.checks()});
}

}  // namespace pressed_layers

std::vector<Experiment> layer_experiments() {
  return {// Proves: layers and grades.
          {"layers", pressed_layers::layers},
          // Proves: layers and grades.
          {"graded stiffness", pressed_layers::grades}};
}

}  // namespace hapticut::experiments
