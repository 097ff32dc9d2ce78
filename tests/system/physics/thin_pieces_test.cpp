// SPDX-License-Identifier: Apache-2.0
// Cuts that leave or touch pieces thinner than a voxel: sheets, and grooves that
// cross.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "hapticut/closed_forms.hpp"

namespace hapticut::thin_pieces_test {
namespace {

namespace forms = closed_forms;
using namespace test;
using units::deg;
using units::kPi;
using units::mm;

// A sheet of 0.3 to 2 voxels costs as much as the same volume of a block, in any orientation: the motor gives u V, and
// the hand the thrust of C20 along its thickness.
TEST(ThinPieces, ASheetThinnerThanAVoxelCostsWhatItsVolumeDoes) {
  for (const double thickness : {0.03 * mm, 0.08 * mm, 0.2 * mm})
    for (const double tilt : {0.0, 10.0, 45.0}) {
      const Mat3 R = Eigen::AngleAxisd(tilt * deg, Vec3::UnitY()).toRotationMatrix();
      const Vec3 normal = R.col(2), middle = Vec3(0.013, 0.021, 0) * mm + 0.37 * kVoxel * normal;
      Workpiece sheet = body({Vec3::Constant(-2 * mm), Vec3::Constant(2 * mm)}, kVoxel, plain_material(),
                             [&](const Vec3& p) { return std::abs(normal.dot(p - middle)) - thickness / 2; });
      Simulation simulation(std::move(sheet), tool_of(FlatHead{kRadius, 8 * mm, FlatRule::bottom_only}, kSpin));
      const double above = 0.2 * mm, path = thickness + 3 * above;
      (void)feed(simulation, middle + normal * (thickness / 2 + above), -normal * kFeed, path, kTick, 0.5, R);
      const EnergyLedger& energy = simulation.last_result().energy;
      const double volume = kPi * kRadius * kRadius * thickness;
      const double thrust = forms::axial_cutting_force_of_a_flat_head({3e8, 0.5, kSpin, kFeed}, kRadius);
      SCOPED_TRACE(std::to_string(thickness / mm) + " mm at " + std::to_string(tilt) + " deg");
      EXPECT_NEAR(energy.motor_work / (3e8 * volume), 1, 0.01);
      EXPECT_NEAR(energy.hand_work / (thrust * thickness), 1, 0.02);
      EXPECT_LT(unbooked(energy), 1e-6);
      EXPECT_EQ(simulation.workpiece().material_at({0, 0, 0}), kEmpty);
    }
}

// Two grooves of a ball remove the union of the swept volumes, and each costs the energy of its own removal.
TEST(ThinPieces, CrossingGroovesTakeAwayTheUnionOfTheirSweeps) {
  const double depth = 0.4 * kRadius, height = kRadius - depth, half = 2.2 * mm;
  for (const double angle : {0.0, 29.0}) {
    const Mat3 R = Eigen::AngleAxisd(angle * deg, Vec3::UnitZ()).toRotationMatrix();
    Simulation simulation(plain_block(3.5 * mm, 1 * mm), tool_of(SphereHead{kRadius}, kSpin));
    double removed = 0;
    for (const Vec3& along : {Vec3::UnitX().eval(), Vec3::UnitY().eval()}) {
      const double before = simulation.last_result().energy.cutting;
      const Vec3 start = R * (Vec3(0, 0, height) - half * along), up(0, 0, 2 * kRadius), fast(0, 0, 20 * mm);
      (void)step_to(simulation, start + up);
      (void)feed(simulation, start + up, -fast, up.z(), kTick);
      (void)feed(simulation, start, R * along * kFeed, 2 * half, kTick);
      (void)feed(simulation, start + R * along * 2 * half, fast, up.z(), kTick);
      removed = simulation.last_result().energy.cutting / 3e8;
      EXPECT_GT(simulation.last_result().energy.cutting, before);
    }
    // Sums the columns of the union. Each column is cut to the deeper of the two balls.
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
    EXPECT_LT(unbooked(simulation.last_result().energy), 1e-6);
  }
}

}  // namespace
}  // namespace hapticut::thin_pieces_test
