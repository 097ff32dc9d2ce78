// SPDX-License-Identifier: Apache-2.0
// The quadrature of custom laws in partly filled voxels: convergence of the two choices of points, and whole voxels
// (docs/decisions/0002-quadrature.md).
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/closed_forms.hpp"

namespace hapticut::quadrature_test {
namespace {

using test::kRadius;
using test::kStiffness;
using test::rest_ok_at;
using units::mm;

constexpr double kDepth = 0.3 * mm;
const Vec3 kNormals[] = {Vec3::UnitZ(), Vec3(0.31, -0.52, 0.8).normalized()};
const double kForce = closed_forms::cap_force(kStiffness, kRadius, kDepth);

/// The springs of the default law, evaluated at points.
class PointSprings final : public ForceLaw {
 public:
  LawTotals evaluate(const HeadMotion& m, const ContactMaterials& materials, ContactBlock& b) const noexcept override {
    const float volume = m.voxel_size * m.voxel_size * m.voxel_size;
    for (int i = 0; i < b.lanes(); ++i) {
      const auto n = std::size_t(i);
      const float force = -materials[b.material_of(i)].stiffness * b.fill[n] * b.depth[n] * volume;
      b.force_x[n] = force * b.normal_x[n];
      b.force_y[n] = force * b.normal_y[n];
      b.force_z[n] = force * b.normal_z[n];
      b.fill_after[n] = b.fill[n];
    }
    LawTotals totals;
    totals.may_remove = false;
    return totals;
  }
};

/// Conversion of a half space to voxels.
enum class Surface {
  centroid,  // partly filled voxels, force at the centroid of the filled part
  center,    // partly filled voxels, force at the voxel's centre
  binary     // whole voxels, where the centre is inside
};

/// Mean and spread over the grid phases of the relative error of the force along the normal, for a ball pressed into a
/// half space; in units of (l/d)^2, or of l/d for binary voxels.
struct ErrorConstants {
  double mean, spread;
};

ErrorConstants press(Surface surface, const Vec3& normal, double l) {
  double sum = 0, squares = 0;
  for (int n = 0; n < test::kPhases; ++n) {
    // The plane goes through a point of a voxel that depends on the phase; the ball goes down along its normal.
    const Vec3 through = l * test::phase(n);
    const double half_edge = kRadius + 4 * l;
    const BodyDescription body = {{Vec3::Constant(-half_edge), Vec3::Constant(half_edge)},
                                  [=](const Vec3& p) { return normal.dot(p - through); },
                                  [](const Vec3&) { return MaterialId(1); }};
    const Box box = {body.box.min, Vec3(half_edge, half_edge, 0)};
    const bool upright = normal == Vec3::UnitZ() && surface != Surface::binary;
    const Vec3 on_surface = upright ? Vec3::Zero() : through;
    SimulationConfig config = test::static_config();
    config.law = std::make_shared<PointSprings>();
    config.quadrature = surface == Surface::centroid ? Quadrature::centroid : Quadrature::voxel_center;
    Simulation simulation(
        upright ? test::box_at_phase(box, l, test::phase(n))
                : build_body(body, l, test::materials_of_stiffness({1}), surface == Surface::binary ? 1 : 8),
        Tool(SphereHead{kRadius}), config);
    const double force = rest_ok_at(simulation, Vec3(on_surface + (kRadius - kDepth) * normal)).force.dot(normal);
    const double error = (force / kForce - 1) / std::pow(l / kDepth, surface == Surface::binary ? 1 : 2);
    sum += error;
    squares += error * error;
  }
  const double mean = sum / test::kPhases;
  return {mean, std::sqrt(squares / test::kPhases - mean * mean)};
}

// F''(d) d^2 / F = 12 (2R-3d)/(4R-3d) = 4.26 at d = 0.3 R. The midpoint rule along the normal has an error of -1/24 of
// this: -0.177. The voxel's centre lies (1-f)/2 above the centroid of the filled fraction f, which adds f (1-f)/2 times
// 4.26. The mean of f (1-f)/2 over f is 1/12, so the error becomes +0.177. Its spread is 0.037 * 4.26 = 0.159 where all
// surface voxels have the same f. Where the surface is tilted against the grid, every f occurs at once.
constexpr double kSlope = 12 * (2 * kRadius - 3 * kDepth) / (4 * kRadius - 3 * kDepth);
constexpr double kMidpoint = -kSlope / 24;
constexpr double kTolerance = 0.03;  // error of 12 phases, of a lattice, and of subsampled fills

class Resolution : public testing::TestWithParam<double> {};

TEST_P(Resolution, TheCentroidHasTheErrorOfTheMidpointRuleOnAnySurface) {
  for (const Vec3& normal : kNormals) {
    const ErrorConstants c = press(Surface::centroid, normal, GetParam() * mm);
    EXPECT_NEAR(c.mean, kMidpoint, kTolerance);
    EXPECT_LT(c.spread, kTolerance);
  }
}

TEST_P(Resolution, TheVoxelsCentreHasTheOppositeMeanErrorAndRipplesOnASurfaceAlongTheGrid) {
  const ErrorConstants upright = press(Surface::center, Vec3::UnitZ(), GetParam() * mm);
  EXPECT_NEAR(upright.mean, -kMidpoint, kTolerance);
  EXPECT_NEAR(upright.spread, kSlope * std::sqrt(1.0 / 120 - 1.0 / 144), kTolerance);
  const ErrorConstants tilted = press(Surface::center, kNormals[1], GetParam() * mm);
  EXPECT_NEAR(tilted.mean, -kMidpoint, kTolerance);
  EXPECT_LT(tilted.spread, kTolerance);
}

// Whole voxels put the surface up to half a voxel off: sqrt(1/12) l F'(d)/F = 0.289 * 12 (1-d/R)/(4-3d/R) l/d.
TEST_P(Resolution, WholeVoxelsAreFirstOrderOnASurfaceAlongTheGrid) {
  const ErrorConstants c = press(Surface::binary, Vec3::UnitZ(), GetParam() * mm);
  const double slope = 12 * (1 - kDepth / kRadius) / (4 - 3 * kDepth / kRadius);
  EXPECT_NEAR(std::hypot(c.mean, c.spread), slope / std::sqrt(12), 0.1 * slope);
}

INSTANTIATE_TEST_SUITE_P(Quadrature, Resolution, testing::Values(0.1, 0.05, 0.025), [](const auto& size) {
  return std::to_string(int(size.param * 1000 + 0.5)) + "MicrometreVoxels";
});

/// [1] Energy that enters, of the turnover, while a standing cylinder that is pressed in tilts to and fro by 6 degrees.
double entered_by_tilting(double tilt, double voxel) {
  SimulationConfig config;
  config.contact_time = ContactTime::end;
  Material material = test::plain_material();
  material.static_friction = material.dynamic_friction = 0;
  Simulation simulation(build_block({Vec3(-2, -2, -1) * mm, Vec3(2, 2, 0) * mm}, voxel, material),
                        Tool(cylinder_head(2 * mm, 4 * mm), RayHandle{0}, Spindle{}), config);
  Pose last = Pose::from_translation(Vec3(0, 0, 2 * mm));
  const auto go = [&](double angle, double height) {
    const Pose at{rotation_from_vector(Vec3(0, tilt + angle, 0)), Vec3(0, 0, height + mm * std::sin(tilt))};
    (void)simulation.step(at, twist_between(last, at, test::kTick), test::kTick);
    last = at;
  };
  for (int n = 0; n <= 100; ++n) go(0, 0.02 * mm - 0.06 * mm * n / 100);
  const EnergyLedger pressed = simulation.last_result().energy;
  for (int n = 1; n <= 1500; ++n) go(6 * units::deg * std::sin(2 * units::kPi * n / 1500), -0.04 * mm);
  const EnergyLedger& energy = simulation.last_result().energy;
  return std::abs(energy.entered - pressed.entered) / (energy.turnover - pressed.turnover);
}

// Beside a rim the springs turn from the side to the face. Voxels of a tenth of the radius resolve that.
TEST(Quadrature, EnergyAtARimFallsFasterThanTheVoxel) {
  for (const double tilt : {0.0, 18 * units::deg}) {
    SCOPED_TRACE(tilt / units::deg);
    EXPECT_LT(entered_by_tilting(tilt, 0.2 * mm), 0.02);
    EXPECT_LT(entered_by_tilting(tilt, 0.1 * mm), 0.001);
    EXPECT_LT(entered_by_tilting(tilt, 0.05 * mm), 0.0001);
  }
}

}  // namespace
}  // namespace hapticut::quadrature_test
