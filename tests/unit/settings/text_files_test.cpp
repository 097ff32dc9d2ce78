// SPDX-License-Identifier: Apache-2.0
// Poses and profiles as text: valid files and errors.
#include <gtest/gtest.h>

#include <string>

#include "settings/pose_file.hpp"
#include "settings/profile_file.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::text_files_test {
namespace {

template <class Read>
std::string refusal(const Read& read, const std::string& text) {
  return test::refusal([&] { return read(text); });
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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// One path as written by spreadsheets of other countries and by hand.
TEST(PosesOfText, AreTheSameFromEverySpreadsheet) {
  const std::string plain = "t_s,x_mm,y_mm,z_mm,note\n0,-3,1500,4,a\n0.01,1.125,3e-1,3.98,b\n0.02,+3,3,0.5,c\n";
  const auto path = kReadPoses(plain);
  ASSERT_EQ(path.size(), 3U);
  const std::string semicolons = replaced(plain, ",", ";"),
                    quoted = '"' + replaced(replaced(plain, ",", "\",\""), "\n", "\"\n\"");
  const std::string all_quoted = quoted.substr(0, quoted.size() - 1);
  const std::string german = replaced(semicolons, ".", ",");
  for (const std::string& text :
       {semicolons, replaced(plain, ",", "\t"), replaced(plain, ",", " "), replaced(plain, ",", "   "), german,
        replaced(german, ";", "\t"), replaced(german, "\n", "\r\n"), replaced(german, "\n", "\r"),
        "\xEF\xBB\xBF" + german, replaced(german, ";", "; "), "sep=;\r\n" + german, "# ours\n\n" + german,
        german + ";;;;\n", all_quoted,

        "\xEF\xBB\xBF" + all_quoted, replaced(plain, ",a\n", ",\"1, \"\"2\"\"; 3\"\n"),
        replaced(plain, ",a\n", ",5\" long\n"), german.substr(0, german.size() - 1)}) {
    std::vector<settings::TimedPose> poses;
    ASSERT_NO_THROW(poses = kReadPoses(text)) << text << refusal(kReadPoses, text);
    ASSERT_EQ(poses.size(), path.size()) << text;
    for (std::size_t n = 0; n < path.size(); ++n) {
      EXPECT_EQ(poses[n].t, path[n].t) << text;
      EXPECT_EQ(poses[n].pose.translation, path[n].pose.translation) << text;
    }
  }
}

TEST(PosesOfText, AreNotGuessedWhereACommaMayMeanTwoThings) {
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(refusal(kReadPoses, text).find(part), std::string::npos) << refusal(kReadPoses, text);
  };
  expect("t_s,x_mm,y_mm,z_mm\n0,\"1,234\",0,0\n", "a.csv:2: \"1,234\" may have a decimal comma or a mark for thou");
  EXPECT_EQ(kReadPoses("t_s,x_mm,y_mm,z_mm\n0,\"0,234\",0,0\n\"0,5\",\"1,5\",0,0\n")[1].t, 0.5);
  const std::string thousands = "t_s;x_mm;y_mm;z_mm\n0;0;0;0\n1;-1,005;0;0\n2;3,000;0;0\n";
  for (const char* separator : {";", "\t", "  "})
    expect(replaced(thousands, ";", separator),
           "a.csv:3: \"-1,005\" may have a decimal comma or a mark for thousands; write -1,0050, or -1005.");
  expect(replaced(thousands, ",", "."), "a.csv:3: \"-1.005\" may have a decimal point or a mark for thousands");
  EXPECT_DOUBLE_EQ(kReadPoses(replaced(replaced(thousands, ",", "."), ";", "\t"))[2].pose.translation.x(), 3e-3);
  for (const char* decimal : {"0,000", "3,0000", "1234,000", "3,0", "03,000"})  // a clear number decides for all
    EXPECT_DOUBLE_EQ(kReadPoses(replaced(thousands, "3,000", decimal))[1].pose.translation.x(), -1.005e-3) << decimal;
  expect("t_s;x_mm;y_mm;z_mm\n0;1.5;0;0\n1;1,5;0;0\n", "a.csv:3: some numbers have a decimal point, others a comma");
  expect("t_s;x_mm;y_mm;z_mm\n0;1.234,5;0;0\n", "a.csv:2: x_mm = \"1.234,5\"; must be a number.");
  expect("t_s;x_mm;y_mm;z_mm\n0;1,2,3;0;0\n", "must be a number");
  expect("t_s,x_mm,y_mm,z_mm\n0,01,3,3,3,98\n",
         "Where numbers have a decimal comma, separate the columns by semicolons.");
  expect("t_s|x_mm|y_mm|z_mm\n0|1|0|0\n", "with commas, semicolons or tabs between them");
  expect("t_s,x_mm,y_mm,z_mm\n0,\"1,0,0\n", "a.csv:2: a quotation mark is not closed.");
  expect(std::string("\xFF\xFEt\0_\0", 6), "a.csv:1: the text is in UTF-16; save it in UTF-8.");
}

TEST(PosesOfText, SayTheLineThatIsWrong) {
  const std::string names = "t_s,x_mm,y_mm,z_mm";
  for (const auto& [text, part] : std::vector<std::pair<std::string, const char*>>{
           {"", "0: the file is empty"},
           {"a,b\n1,2\n", "1: the columns t_s, x_mm, y_mm, z_mm are missing"},
           {"t_s,x_mm,y_mm\n", "1: the column z_mm is missing"},
           {names + ",qw,qx,qy\n", "1: the column qz is missing"},
           {names + "\n0,0,0,0\n1,0,0\n", "3: 3 values; there must be 4"},
           {names + "\n0,0,zero,0\n", "2: y_mm = \"zero\"; must be a number"},
           {names + "\n0,0,0,0\n1,nan,0,0\n", "3: x_mm = \"nan\"; must be a number"},
           {names + "\n1,0,0,0\n\n1,0,0,0\n", "4: t_s = 1; times must increase"},
           {names + "\n1,0,0,0\n", "2: there must be at least two poses"},
           {names + ",qw,qx,qy,qz\n0,0,0,0,1,1,0,0\n", "2: the quaternion has length"},
           {names + ",r00,r01,r02,r10,r11,r12,r20,r21,r22\n0,0,0,0,1,0,0,0,1,0,0,0,-1\n",
            "2: r00 ... r22 is not a rotation"}})
    EXPECT_TRUE(refusal(kReadPoses, text).starts_with(std::string("a.csv:") + part)) << refusal(kReadPoses, text);
}

TEST(TextFiles, NameEachColumnOnce) {
  const std::string path = "t_s,x_mm,y_mm,z_mm,x_mm\n0,1,2,3,4\n1,1,2,3,4\n",
                    profile = "rho_mm,z_mm,z_mm\n0,0,0\n1,1,1\n";
  EXPECT_NE(refusal(kReadPoses, path).find("a.csv:1: the column x_mm is named twice"), std::string::npos)
      << refusal(kReadPoses, path);
  EXPECT_NE(refusal(kReadProfile, profile).find("z_mm is named twice"), std::string::npos);
  EXPECT_EQ(refusal(kReadPoses, "t_s,x_mm,y_mm,z_mm,,\n0,1,2,3,,\n1,1,2,3,,\n"), "");
}

TEST(TextFiles, WithoutNamesAreToldThatTheFirstLineNamesTheColumns) {
  for (const char* path : {"0,5,5,6\n1,5,5,4.5\n", "0;5;5;6\n1;5;5;4,5\n", "-1e-3,5.5,+5,6,\n"}) {
    const std::string said = refusal(kReadPoses, path);
    EXPECT_NE(said.find("a.csv:1: the first line has numbers; it must name the columns t_s, x_mm"), std::string::npos)
        << said;
  }
  EXPECT_NE(refusal(kReadProfile, "0,0\n1,1\n").find("it must name the columns rho_mm, z_mm"), std::string::npos);
}

// Another name for the same numbers would make a path of milliseconds a thousand times as long.
TEST(TextFiles, OfAnotherUnitAreNotToldToRenameTheColumn) {
  const std::string said = refusal(kReadPoses, "t_ms,x_mm,y_mm,z_mm\n0,5,5,6\n1,5,5,4.5\n");
  EXPECT_NE(said.find("there is no column t_ms"), std::string::npos) << said;
  EXPECT_NE(said.find("If it is t_s in another unit, convert its numbers."), std::string::npos) << said;
  EXPECT_EQ(said.find("Did you mean"), std::string::npos) << said;
}

TEST(TextFiles, ThatAreNoTextsOfNumbersAreCalledWhatTheyAre) {
  const test::TemporaryFolder folder;
  const auto read = [&] { return settings::read_poses(folder / "p.csv", Mat3::Identity()); };
  test::write_bytes(folder / "p.csv", "<!DOCTYPE html>\n<html></html>\n");
  test::expect_refused(read, "p.csv: it is a web page in place of the file");
  test::write_bytes(folder / "p.csv", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7\nsize 12\n");
  test::expect_refused(read, "p.csv: it is a Git LFS pointer");
  test::write_bytes(folder / "p.csv", "t_s,x_mm,y_mm,z_mm\n0,5,5,6\n1,5,5,4.5\n");
  EXPECT_EQ(read().size(), 2U);
}

// Poses whose rotations have other names: each is refused by name, and read after the cure.
TEST(PosesOfText, RefuseColumnsThatWouldBeLeftOut) {
  const std::string rows = "\n0,1,2,3,0,60,0\n1,1,2,4,0,60,0\n", plain = "t_s,x_mm,y_mm,z_mm";
  for (const auto& [names, part] : std::vector<std::pair<std::string, std::string>>{
           {",roll_deg,pitch_deg,yaw_deg", "there is no column roll_deg; must be one of t_s, x_mm"},
           {",rx_rad,ry_rad,rz_rad", "there is no column rx_rad"},
           {",q_w,q_x,q_y", "there is no column q_w"},
           {",vx,vy,vz", "there is no column vx"},
           {",r0,r1,r2", "Leave it out, or name it comment if it says nothing about the poses."}}) {
    const std::string said = refusal(kReadPoses, plain + names + rows);
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_TRUE(said.starts_with("a.csv:1: ")) << said;
  }
  EXPECT_EQ(refusal(kReadPoses, plain + "\n0,1,2,3\n1,1,2,4\n"), "") << "left out";
  EXPECT_EQ(refusal(kReadPoses, plain + ",comment,,\n0,1,2,3,60,,\n1,1,2,4,60,,\n"), "") << "called a comment";
  EXPECT_NE(refusal(kReadPoses, "t_s,x_mm,y_mm,z\n0,1,2,3\n1,1,2,4\n").find("Did you mean z_mm?"), std::string::npos);
  EXPECT_EQ(refusal(kReadPoses, plain + ",note,Index,frame,status,force_x_N\n0,1,2,3,a,1,1,ok,0\n1,1,2,4,b,2,2,ok,0\n"),
            "");
}

TEST(TextFiles, HaveColumnsInUpperOrLowerCase) {
  const auto lower = kReadPoses("t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n0,1,2,3,0,0,0,1\n1,1,2,4,0,0,0,1\n"),
             upper = kReadPoses("T_S, X_mm,Y_MM,z_mm, QW,QX,Qy,qZ\n0,1,2,3,0,0,0,1\n1,1,2,4,0,0,0,1\n");
  ASSERT_EQ(upper.size(), lower.size());
  EXPECT_EQ(upper[1].pose.rotation, lower[1].pose.rotation);
  EXPECT_EQ(upper[1].pose.translation, lower[1].pose.translation);
  EXPECT_NE(refusal(kReadPoses, "t_s,x_mm,y_mm,z_mm,Z_mm\n0,1,2,3,4\n").find("Z_mm is named twice"), std::string::npos);
  EXPECT_EQ(kReadProfile("Rho_mm,Z_mm\n0,0\n1,1\n").edges.size(), 1U);
}

TEST(ProfileOfText, HasItsTipAtZero) {
  const Profile profile = kReadProfile("z_mm,rho_mm,kind\n1,0,cutting\n1.5,0.75,smooth\n");
  ASSERT_EQ(profile.edges.size(), 1U);
  EXPECT_EQ(profile.tip, 0);
  EXPECT_NEAR(profile.edges[0].z, 0.5e-3, 1e-15);
  EXPECT_EQ(profile.edges[0].kind, EdgeKind::smooth);
}

TEST(ProfileOfText, IsReadFromASpreadsheetOfAnotherCountry) {
  const Profile profile = kReadProfile("z_mm;rho_mm;kind;\r\n1;0;cutting;\r\n1,5;0,75;smooth;\r\n");
  ASSERT_EQ(profile.edges.size(), 1U);
  EXPECT_EQ(profile.edges[0].rho, 0.75 * 1e-3);
}

TEST(ProfileOfText, SaysTheLineThatIsWrong) {
  for (const auto& [text, part] : std::vector<std::pair<const char*, const char*>>{
           {"", "0: the file is empty"},
           {"rho_mm,color\n", "1: there is no column color"},
           {"rho_mm\n", "1: the file needs the columns rho_mm and z_mm."},
           {"rho_mm,z_mm\n0,0\n1\n", "3: 1 values; there must be 2"},
           {"rho_mm,z_mm\n0,0\n1,wide\n", "3: z_mm = \"wide\"; must be a number."},
           {"rho_mm,z_mm\n0,nan\n", "2: z_mm = \"nan\"; must be a number."},
           {"rho_mm,z_mm\n1,0\n1,1\n", "2: rho_mm = 1; must be 0, because the first point is the tip."},
           {"rho_mm,z_mm,kind\n0,0,cutting\n1,1,sharp\n", "3: kind = sharp; must be cutting or smooth."}})
    EXPECT_TRUE(refusal(kReadProfile, text).starts_with(std::string("a.csv:") + part)) << refusal(kReadProfile, text);
}

}  // namespace
}  // namespace hapticut::text_files_test
