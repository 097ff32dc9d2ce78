// SPDX-License-Identifier: Apache-2.0
#include "hapticut/import/mesh/profile_from_mesh.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/tool/mesh_of_revolution.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/setup/random_pose.hpp"
#include "experiments/setup/static_contact.hpp"
#include "hapticut/core/errors.hpp"
#include "support/catalogue_heads.hpp"
#include "support/mesh_measures.hpp"
#include "support/meshes.hpp"
#include "support/profiles.hpp"
#include "support/refusal.hpp"
#include "support/test_data.hpp"

namespace hapticut::profile_from_mesh_test {
namespace {

using test::NamedProfile;
using units::kPi;
using units::mm;

TriangleMesh moved(TriangleMesh mesh, const Pose& X) {
  for (Vec3& v : mesh.vertices) v = X * v;
  return mesh;
}

/// A mesh in which every triangle has separate vertices, as in an STL file, rounded to single precision.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const auto& triangle : mesh.triangles) {
    const auto first = std::uint32_t(out.vertices.size());
    for (const std::uint32_t v : triangle) out.vertices.push_back(mesh.vertices[v].cast<float>().cast<double>());
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

std::vector<NamedProfile> all_shapes() {
  std::vector<NamedProfile> all = test::closed_profiles();
  for (const test::CatalogueHead& head : test::catalogue_heads())
    all.push_back({"catalogue_" + head.name, head.make().profile()});
  return all;
}

class Recognized : public testing::TestWithParam<NamedProfile> {};

TEST_P(Recognized, MeshOfAProfileIsClosedAndHasItsVolume) {
  const int sides = 120;
  const TriangleMesh mesh = mesh_of_revolution(GetParam().profile, sides);
  const test::EdgeCount edges = test::count_edges(mesh);
  EXPECT_TRUE(edges.balanced);
  EXPECT_EQ(edges.more_often, 0U);
  // A polygon of 120 sides has 0.9995 of the area of its circle; arcs lose about as much.
  EXPECT_NEAR(test::signed_volume(mesh) / ProfileHead(GetParam().profile).volume(), 1, 2e-3);
}

TEST_P(Recognized, InAnyPoseWithItsAxisAndDimensions) {
  test::RandomPoses random(21);
  const ProfileHead original(GetParam().profile);
  for (int n = 0; n < 3; ++n) {
    const Pose X = {random.rotation(), random.vector(20 * mm)};
    const TriangleMesh mesh = moved(mesh_of_revolution(GetParam().profile, 72), X);
    const RecognizedProfile found = profile_from_mesh(n == 0 ? mesh : soup(mesh), X.rotation.col(2));
    const ProfileHead head(found.profile, 0.1);
    EXPECT_LT(found.deviation, 0.003 * original.table().radius);
    EXPECT_NEAR(head.volume() / original.volume(), 1, 1e-3);
    EXPECT_NEAR(head.table().radius / original.table().radius, 1, 1e-3);
    EXPECT_LT((found.X_MT.rotation.col(2) - X.rotation.col(2)).norm(), 1e-3);
    EXPECT_LT((found.X_MT.translation - X * Vec3(0, 0, GetParam().profile.tip)).norm(), 1e-3 * original.reach());
  }
}

/// Largest difference of forces over 20 poses in which both heads are pressed in by half of their size, relative to the
/// largest force.
double difference_of_forces(const ToolHead& a, const ToolHead& b, double tip_of_a, double tip_of_b) {
  const double size = std::min(a.max_radius(), a.bounding_box().max.z() - a.bounding_box().min.z());
  const double reach = 1.2 * a.reach();
  const Box block = {Vec3(-reach, -reach, -2 * size), Vec3(reach, reach, 0)};
  const Workpiece workpiece = test::box_at_phase(block, size / 12, test::phase(2));
  Simulation with_a(workpiece.clone(), Tool(a), test::static_config());
  Simulation with_b(workpiece.clone(), Tool(b), test::static_config());
  test::RandomPoses random(3);
  double max_force = 0, worst = 0;
  for (int n = 0; n < 20; ++n) {
    const Mat3 R = rotation_from_vector(random.vector(1.2));
    const Vec3 tip = Vec3(0, 0, -0.5 * size) + random.vector(0.2 * size);
    const StepResult in_a = test::rest_ok_at(with_a, Pose{R, tip - tip_of_a * R.col(2)});
    const StepResult in_b = test::rest_ok_at(with_b, Pose{R, tip - tip_of_b * R.col(2)});
    max_force = std::max(max_force, in_a.force.norm());
    worst = std::max(worst, (in_a.force - in_b.force).norm());
  }
  EXPECT_GT(max_force, 0);
  return worst / max_force;
}

TEST_P(Recognized, FeelsTheForcesOfItsProfileWithinOnePercent) {
  const TriangleMesh mesh = mesh_of_revolution(GetParam().profile, 96);
  const RecognizedProfile found = profile_from_mesh(mesh);
  // The mesh does not tell which edges cut; a flat end on the shank's side counts as smooth.
  Profile original = GetParam().profile;
  const ProfileEdge& last = found.profile.edges.back();
  for (ProfileEdge& e : original.edges) e.kind = EdgeKind::cutting;
  for (std::size_t n = original.edges.size(); n-- > 1;) {
    if (original.edges[n].z != original.edges.back().z || original.edges[n - 1].z != original.edges.back().z) break;
    original.edges[n].kind = last.kind;
  }
  EXPECT_LT(difference_of_forces(ProfileHead(original), ProfileHead(found.profile), original.tip, 0), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Recognized, testing::ValuesIn(all_shapes()),
                         [](const auto& p) { return p.param.name; });

TEST(RecognizedProfile, KeepsArcsAsArcs) {
  const RecognizedProfile found =
      profile_from_mesh(mesh_of_revolution(round_end_cylinder_head(1.2 * mm, 4 * mm).profile(), 60));
  ASSERT_EQ(found.profile.edges.size(), 3U);
  EXPECT_NEAR(found.profile.edges[0].radius, 0.6 * mm, 1e-3 * mm);
  EXPECT_EQ(found.profile.edges[1].radius, 0);
  EXPECT_EQ(found.profile.edges[2].kind, EdgeKind::smooth);
}

TEST(RecognizedProfile, OrientsTheAxisTowardsTheShank) {
  const TriangleMesh mesh = mesh_of_revolution(tapered_head(0.8 * mm, 1.6 * mm, 3 * mm).profile(), 60);
  EXPECT_LT(profile_from_mesh(mesh).profile.edges[0].rho, 0.41 * mm);
  EXPECT_GT(profile_from_mesh(mesh, -Vec3::UnitZ()).profile.edges[0].rho, 0.79 * mm);
}

// --- not a body of revolution ---------------------------------------------------------------------------------------

void expect_no_body_of_revolution(const TriangleMesh& mesh, std::initializer_list<std::string> words) {
  test::expect_refused([&] { (void)profile_from_mesh(mesh); }, words);
}

TEST(RecognizedProfile, SaysHowFarAMeshIsOff) {
  // A square prism: its corners are at sqrt(2) of the distance of its faces, 29 % of the largest radius.
  const TriangleMesh prism = mesh_of_revolution(test::flat_profile(1 * mm, 2 * mm), 4);
  expect_no_body_of_revolution(prism,
                               {"not a body of revolution", "mm off", "% of its radius", "at most 2 %", "more facets"});

  TriangleMesh oval = mesh_of_revolution(test::flat_profile(1 * mm, 2 * mm), 90);
  for (Vec3& v : oval.vertices) v.x() *= 1.2;
  expect_no_body_of_revolution(oval, {"not a body of revolution"});

  // 10 sides are off by 1 - cos(18 degrees) = 4.9 %.
  const TriangleMesh coarse = mesh_of_revolution(test::flat_profile(1 * mm, 2 * mm), 10);
  expect_no_body_of_revolution(coarse, {"not a body of revolution"});
  EXPECT_NO_THROW((void)profile_from_mesh(coarse, Vec3::UnitZ(), 0.06));
}

TEST(RecognizedProfile, RefusesWhatIsNotOneClosedBody) {
  EXPECT_THROW((void)profile_from_mesh({}), Error);
  const TriangleMesh ball = mesh_of_revolution(test::ball_profile(1 * mm), 40);

  TriangleMesh open = ball;
  open.triangles.erase(open.triangles.begin() + 300, open.triangles.begin() + 500);
  expect_no_body_of_revolution(open, {"closed"});

  TriangleMesh cavity = mesh_of_revolution(test::ball_profile(0.5 * mm), 40);
  for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
  expect_no_body_of_revolution(test::joined(ball, cavity), {"4 times", "twice"});

  TriangleMesh broken = ball;
  broken.triangles.push_back({0, 1, 1000000});
  expect_no_body_of_revolution(broken, {"vertex 1000000"});

  TriangleMesh nan = ball;
  nan.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  expect_no_body_of_revolution(nan, {"not finite"});
}

TEST(RecognizedProfile, RefusesADirectionOrToleranceOutOfRange) {
  const TriangleMesh mesh = mesh_of_revolution(test::ball_profile(1 * mm), 40);
  EXPECT_THROW((void)profile_from_mesh(mesh, Vec3::Zero()), Error);
  EXPECT_THROW((void)profile_from_mesh(mesh, Vec3::UnitZ(), 0.0), Error);
  EXPECT_THROW((void)mesh_of_revolution(test::ball_profile(1 * mm), 2), Error);
}

// --- a bur from another program -- -----------------------------------------------------------------------------------

/// The rings of the bur as a profile, from its vertices alone. They are monotone in z, except for the disk at the top.
Profile rings_of(const TriangleMesh& mesh, const Vec3& center) {
  std::vector<Eigen::Vector2d> rings;
  for (const Vec3& v : mesh.vertices) {
    const Eigen::Vector2d x((v - center).head<2>().norm(), v.z());
    const bool known =
        std::any_of(rings.begin(), rings.end(), [&](const auto& r) { return (r - x).norm() < 1e-4 * mm; });
    if (!known) rings.push_back(x);
  }
  double top = 0;
  for (const auto& r : rings) top = std::max(top, r.y());
  std::sort(rings.begin(), rings.end(), [&](const auto& a, const auto& b) {
    if (std::abs(a.y() - b.y()) > 1e-4 * mm) return a.y() < b.y();
    return top - a.y() < 1e-4 * mm ? a.x() > b.x() : a.x() < b.x();
  });
  Profile profile{rings.front().y(), {}};
  for (std::size_t n = 1; n < rings.size(); ++n) profile.edges.push_back({rings[n].x(), rings[n].y()});
  profile.edges.back() = {0, rings.back().y(), 0, EdgeKind::smooth};
  return profile;
}

TEST(RecognizedProfile, TheBurOfTheHandpieceFeelsTheForcesOfItsRingsWithinOnePercent) {
  HAPTICUT_NEEDS_DATA("meshes/burr.stl");
  const TriangleMesh mesh = read_mesh(test::data_path("meshes/burr.stl")).at(0).mesh;
  const RecognizedProfile found = profile_from_mesh(mesh);
  EXPECT_LT(found.deviation, 0.005 * mm);
  EXPECT_LT((found.X_MT.rotation.col(2) - Vec3::UnitZ()).norm(), 1e-4);
  EXPECT_LE(found.profile.edges.size(), 6U);

  const Profile rings = rings_of(mesh, found.X_MT.translation);
  const ProfileHead head(found.profile);
  EXPECT_NEAR(2 * head.table().radius, 1.354 * mm, 1e-3 * mm);
  EXPECT_NEAR(head.table().top, 6.0 * mm, 1e-3 * mm);
  // The mesh has 60 sides: its area is that of a circle times sin(6 degrees)/(6 degrees).
  EXPECT_NEAR(head.volume() / (test::signed_volume(mesh) / (std::sin(kPi / 30) / (kPi / 30))), 1, 2e-3);
  EXPECT_LT(difference_of_forces(ProfileHead(rings), head, rings.tip, 0), 0.01);
}
}  // namespace
}  // namespace hapticut::profile_from_mesh_test
