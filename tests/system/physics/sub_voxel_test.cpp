// SPDX-License-Identifier: Apache-2.0
// Quadrature::sub_voxel on surfaces inclined to the grid and with heads of profiles, and its refusals. Cuts with it are
// rows of `hapticut validate` (docs/decisions/0009-cut-voxels.md).
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/force/laws/hertzian_burr.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "support/profiles.hpp"
#include "support/refusal.hpp"

namespace hapticut::sub_voxel_test {
namespace {

using namespace test;
using units::mm;

// The table of a profile must also describe the surface just outside the profile. The side of the second profile has
// two pieces, which gives three curves, so its table needs cells. The tables of the other two have one rule everywhere.
TEST(SubVoxel, AProfilePressesAsTheShapeThatItDraws) {
  struct Case {
    ToolHead profile, shape;
    double tip;  // [m] from the shape's origin to its lowest point, minus that of the profile
  };
  const double height = 3 * mm;
  const Profile in_pieces = {0,
                             {{kRadius, 0}, {kRadius, 0.2 * mm}, {kRadius, height}, {0, height, 0, EdgeKind::smooth}}};
  ASSERT_EQ(ProfileHead(in_pieces).table().everywhere, 0U);
  for (const Case& c : {Case{ProfileHead(flat_profile(kRadius, height)), FlatHead{kRadius, height}, 0},
                        Case{ProfileHead(in_pieces), FlatHead{kRadius, height}, 0},
                        Case{round_end_cylinder_head(2 * kRadius, height), SphereHead{kRadius}, kRadius}}) {
    const double bottom = c.profile.bounding_box().min.z();
    const auto force_of = [&](const ToolHead& head, double lowest) {
      Simulation simulation(
          build_block({Vec3(-1.63, -1.57, -1.2) * mm, Vec3(1.6, 1.6, 0) * mm}, kVoxel, plain_material()), Tool(head),
          static_config());
      return rest_ok_at(simulation, Pose::from_translation({0, 0, -0.36 * mm - lowest})).force.z();
    };
    EXPECT_NEAR(force_of(c.profile, bottom) / force_of(c.shape, -c.tip), 1, 0.005);
  }
}

TEST(SubVoxel, RefusesWhatItCannotDo) {
  SimulationConfig config = on_foundation(1e15);
  const auto simulate = [&] { Simulation simulation(plain_block(), tool_of(SphereHead{kRadius}, kSpin), config); };
  EXPECT_EQ(refusal(simulate), "");
  config.quadrature = Quadrature::centroid;
  expect_refused(simulate, {"points are for other laws"});
  config.quadrature = Quadrature::sub_voxel;
  config.law = std::make_shared<HertzianBurrLaw>(1e6);
  expect_refused(simulate, {"Choose automatic or centroid"});
  config.law = nullptr;
  expect_refused(simulate, {"SimulationConfig::law is null"});
}

}  // namespace
}  // namespace hapticut::sub_voxel_test
