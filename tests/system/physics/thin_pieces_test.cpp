// SPDX-License-Identifier: Apache-2.0
// Cuts that leave or meet pieces thinner than a voxel: sheets, and grooves that cross.
#include <gtest/gtest.h>

#include "hapticut/closed_forms.hpp"
#include "support/cutting.hpp"

namespace hapticut::thin_pieces_test {
namespace {

namespace forms = closed_forms;
using test::plain_material;
using units::deg;
using units::kPi;
using units::mm;

constexpr double kRadius = 1 * mm;
constexpr double kVoxel = 0.1 * mm;
constexpr double kFeed = 2 * mm;  // [m/s]
constexpr double kSpin = 2000;    // [rad/s]

// A sheet of three tenths to two voxels costs as much as its volume does in a block, whichever way it lies in the grid:
// motor u V, and the hand the thrust of C20 along its thickness.
TEST(ThinPieces, ASheetThinnerThanAVoxelCostsWhatItsVolumeDoes) {
  for (const double thickness : {0.03 * mm, 0.08 * mm, 0.2 * mm})
    for (const double tilt : {0.0, 10.0, 45.0}) {
      const Mat3 R = Eigen::AngleAxisd(tilt * deg, Vec3::UnitY()).toRotationMatrix();
      const Vec3 normal = R.col(2), middle = Vec3(0.013, 0.021, 0) * mm + 0.37 * kVoxel * normal;
      const BodyDescription sheet = {{Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)},
                                     [&](const Vec3& p) { return std::abs(normal.dot(p - middle)) - thickness / 2; },
                                     [](const Vec3&) { return MaterialId(1); }};
      Simulation simulation(
          build_body(sheet, kVoxel, MaterialTable({plain_material()})),
          Tool(FlatHead{kRadius, 8 * mm, FlatRule::bottom_only}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}));
      const double above = 0.2 * mm, way = thickness + 3 * above;
      (void)test::feed(simulation, middle + normal * (thickness / 2 + above), -normal * kFeed, way, 1e-3, 1, R);
      const EnergyLedger& energy = simulation.last_result().energy;
      const double volume = kPi * kRadius * kRadius * thickness;
      const double thrust = forms::axial_cutting_force_of_a_flat_head({3e8, 0.5, kSpin, kFeed}, kRadius);
      SCOPED_TRACE(std::to_string(thickness / mm) + " mm at " + std::to_string(tilt) + " deg");
      EXPECT_NEAR(energy.motor_work / (3e8 * volume), 1, 0.01);
      EXPECT_NEAR(energy.hand_work / (thrust * thickness), 1, 0.02);
      EXPECT_LT(test::unbooked(energy), 1e-6);
      EXPECT_EQ(simulation.workpiece().material_at({0, 0, 0}), kEmpty);
    }
}

// Two grooves of a ball take away the union of what it sweeps, and each costs what it takes away.
TEST(ThinPieces, CrossingGroovesTakeAwayTheUnionOfTheirSweeps) {
  const double depth = 0.4 * kRadius, height = kRadius - depth, half = 2.2 * mm;
  for (const double angle : {0.0, 29.0}) {
    const Mat3 R = Eigen::AngleAxisd(angle * deg, Vec3::UnitZ()).toRotationMatrix();
    Simulation simulation(build_block({Vec3(-3.5, -3.5, -1) * mm, Vec3(3.5, 3.5, 0) * mm}, kVoxel, plain_material()),
                          Tool(SphereHead{kRadius}, RayHandle{0}, Spindle{kSpin * units::rad_per_s}));
    double removed = 0;
    for (const Vec3& along : {Vec3::UnitX().eval(), Vec3::UnitY().eval()}) {
      const double before = simulation.last_result().energy.cutting;
      const Vec3 start = R * (Vec3(0, 0, height) - half * along);
      (void)simulation.step(Pose::from_translation(start + Vec3(0, 0, 2 * kRadius)), {}, 1e-3);
      const Vec3 up(0, 0, 20 * mm);
      (void)test::feed(simulation, start + Vec3(0, 0, 2 * kRadius), -up, 2 * kRadius, 1e-3, 1);
      (void)test::feed(simulation, start, R * along * kFeed, 2 * half, 1e-3, 1);
      (void)test::feed(simulation, start + R * along * 2 * half, up, 2 * kRadius, 1e-3, 1);
      removed = simulation.last_result().energy.cutting / 3e8;
      EXPECT_GT(simulation.last_result().energy.cutting, before);
    }
    // By columns of the union: each is cut to the deeper of two balls.
    const auto depth_at = [&](double across, double along) {
      const double beyond = std::max(0.0, std::abs(along) - half), r2 = across * across + beyond * beyond;
      return r2 < kRadius * kRadius ? std::max(0.0, std::sqrt(kRadius * kRadius - r2) - height) : 0.0;
    };
    double expected = 0;
    const double cell = 0.01 * mm;
    for (double x = -3.4 * mm; x < 3.4 * mm; x += cell)
      for (double y = -3.4 * mm; y < 3.4 * mm; y += cell)
        expected += cell * cell * std::max(depth_at(x, y), depth_at(y, x));
    SCOPED_TRACE(std::to_string(angle) + " deg");
    EXPECT_NEAR(removed / expected, 1, 0.02);
    EXPECT_LT(test::unbooked(simulation.last_result().energy), 1e-6);
  }
}

}  // namespace
}  // namespace hapticut::thin_pieces_test
