// SPDX-License-Identifier: Apache-2.0
// Heads of any profile in the step: a profile of a ball, a cone or a flat head has the same force and cut as the head
// itself.
#include <gtest/gtest.h>

#include "experiments/setup/cutting.hpp"
#include "experiments/setup/random_pose.hpp"
#include "experiments/setup/static_contact.hpp"

namespace hapticut::profile_head_test {
namespace {

using test::rest_ok_at;
using test::static_config;
using units::deg;
using units::mm;

struct Twins {
  Twins(const char* a_name, const ToolHead& head)
      : name(a_name), analytic(head), profile(ProfileHead(head.profile())) {}
  const char* name;
  ToolHead analytic;
  ToolHead profile;
};

void PrintTo(const Twins& twins, std::ostream* out) { *out << twins.name; }

class ProfileTwin : public testing::TestWithParam<Twins> {};

// Depths agree to single precision, so forces, sums over thousands of voxels, agree better than this.
constexpr double kSinglePrecision = 2e-6;
// A voxel may have its centre beyond the sharp rim of a cone's base and a part inside. Cone and profile give different
// distances for such a centre. Around the whole rim the effect is 5e-5 of the force and 2.3e-3 of the volume.
constexpr double kBeyondSharpRims = 1e-4, kVolumeBeyondSharpRims = 3e-3;

TEST_P(ProfileTwin, FeelsTheSameForceAndTorque) {
  const Box block = {Vec3(-2.5, -2.5, -2.5) * mm, Vec3(2.5, 2.5, 0) * mm};
  const Workpiece workpiece = test::box_at_phase(block, 0.08 * mm, test::phase(2));
  const Handle handle = LHandle{4 * mm, 2 * mm, 0.8};
  Simulation with_analytic(workpiece.clone(), Tool(GetParam().analytic, handle), static_config());
  Simulation with_profile(workpiece.clone(), Tool(GetParam().profile, handle), static_config());
  const bool sharp = std::holds_alternative<ConeHead>(GetParam().analytic.shape());
  const double tolerance = sharp ? kBeyondSharpRims : kSinglePrecision;
  test::RandomPoses random(12);
  const HeadBox box = GetParam().analytic.bounding_box();
  int touching = 0;
  for (int n = 0; n < 50; ++n) {
    const Mat3 R_WT = random.rotation();
    const Pose X_WT = {R_WT, random.vector(0.8 * mm) - R_WT * Vec3(0.5 * (box.min + box.max))};
    const Pose X_WH = X_WT * with_analytic.tool().X_HT().inverse();
    const StepResult a = rest_ok_at(with_analytic, X_WH);
    const StepResult p = rest_ok_at(with_profile, X_WH);
    touching += a.contact.voxels > 100;
    const double scale = test::kStiffness * a.contact.volume * a.contact.depth;
    EXPECT_LE((p.force - a.force).norm(), tolerance * scale);
    EXPECT_LE((p.torque - a.torque).norm(), tolerance * scale * 5 * mm);
    EXPECT_NEAR(p.contact.volume, a.contact.volume, (sharp ? kVolumeBeyondSharpRims : 1e-4) * a.contact.volume);
    EXPECT_NEAR(p.contact.depth, a.contact.depth, kSinglePrecision * mm);
  }
  EXPECT_GT(touching, 30);
}

TEST_P(ProfileTwin, CutsTheSame) {
  const Box block = {Vec3(-2, -1.5, -1.5) * mm, Vec3(2, 1.5, 0) * mm};
  const Workpiece workpiece = build_block(block, test::kVoxel, test::plain_material());
  const SimulationConfig config = test::on_foundation(1e13);
  Simulation with_analytic(workpiece.clone(), test::tool_of(GetParam().analytic, test::kSpin), config);
  Simulation with_profile(workpiece.clone(), test::tool_of(GetParam().profile, test::kSpin), config);
  double removed_analytic = 0, removed_profile = 0, max_force = 0, worst = 0;
  for (int n = 0; n < 150; ++n) {
    const double t = n / 150.0, low = GetParam().analytic.bounding_box().min.z();
    const Pose pose = {rotation_from_vector(Vec3(0.2 * t, 0.3 * t, 0)),
                       Vec3(-0.5 + t, 0.11, 0.1 - 0.7 * std::min(1.0, 2 * t)) * mm - Vec3(0, 0, low)};
    const StepResult& a = with_analytic.step(pose, {}, 1e-3);
    const StepResult& p = with_profile.step(pose, {}, 1e-3);
    removed_analytic += a.removed_volume;
    removed_profile += p.removed_volume;
    max_force = std::max(max_force, a.force.norm());
    worst = std::max(worst, (a.force - p.force).norm());
  }
  EXPECT_GT(removed_analytic, 1e-12);
  EXPECT_NEAR(removed_profile / removed_analytic, 1, 3e-4);  // beyond an edge the table also rounds depths outside
  // Single voxels whose depth rounds to one or the other side of a threshold may be cut a step earlier.
  EXPECT_LT(worst, 1e-3 * max_force);
}

INSTANTIATE_TEST_SUITE_P(Heads, ProfileTwin,
                         testing::Values(Twins("Ball", SphereHead{0.8 * mm}),
                                         Twins("Cone", ConeHead{35 * deg, 1.3 * mm}),
                                         Twins("Flat", FlatHead{0.8 * mm, 1.4 * mm})),
                         [](const auto& twin) { return std::string(twin.param.name); });

}  // namespace
}  // namespace hapticut::profile_head_test
