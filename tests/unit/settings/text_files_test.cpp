// SPDX-License-Identifier: Apache-2.0
// Poses and profiles as text: what their files say, and where they are wrong.
#include <gtest/gtest.h>

#include <string>

#include "hapticut/core/errors.hpp"
#include "settings/pose_file.hpp"
#include "settings/profile_file.hpp"

namespace hapticut::text_files_test {
namespace {

template <class Read>
std::string refusal_of(const Read& read, const std::string& text) {
  try {
    (void)read(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const auto kReadPoses = [](const std::string& text) {
  return settings::poses_of_text(text, "a.csv", Mat3::Identity());
};
const auto kReadProfile = [](const std::string& text) { return settings::profile_of_text(text, "a.csv"); };

TEST(PosesOfText, AreThoseOfTheLines) {
  const auto poses = kReadPoses(
      "\xEF\xBB\xBF# of a hand\r\nt_s, x_mm,y_mm,z_mm,qw,qx,qy,qz\r\n0,1,2,3,1,0,0,0\r\n\r\n0.5,4,5,6,0,0,0,1\r\n");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[1].t, 0.5);
  EXPECT_TRUE(poses[1].pose.translation.isApprox(Vec3(4e-3, 5e-3, 6e-3)));
  EXPECT_TRUE(poses[1].pose.rotation.isApprox(Vec3(-1, -1, 1).asDiagonal().toDenseMatrix()));
}

TEST(PosesOfText, SayTheLineThatIsWrong) {
  const std::string names = "t_s,x_mm,y_mm,z_mm\n";
  EXPECT_TRUE(refusal_of(kReadPoses, "").starts_with("a.csv:0: "));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "0,0,0,0\n1,nan,0,0\n").starts_with("a.csv:3: x_mm = \"nan\""));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "0,0,0\n").starts_with("a.csv:2: 3 values"));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "1,0,0,0\n0,0,0,0\n").starts_with("a.csv:3: t_s = 0"));
}

TEST(ProfileOfText, HasItsTipAtZero) {
  const Profile profile = kReadProfile("z_mm,rho_mm,kind\n1,0,cutting\n1.5,0.75,smooth\n");
  ASSERT_EQ(profile.edges.size(), 1U);
  EXPECT_EQ(profile.tip, 0);
  EXPECT_NEAR(profile.edges[0].z, 0.5e-3, 1e-15);
  EXPECT_EQ(profile.edges[0].kind, EdgeKind::smooth);
}

TEST(ProfileOfText, SaysTheLineThatIsWrong) {
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm,color\n").starts_with("a.csv:1: there is no column color"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n0,0\n1,x\n").starts_with("a.csv:3: 'x' is not a number"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n0,nan\n").starts_with("a.csv:2: 'nan' is not a number"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n1,0\n").starts_with("a.csv:2: rho_mm = 1"));
}

}  // namespace
}  // namespace hapticut::text_files_test
