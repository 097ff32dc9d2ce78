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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// What spreadsheets of other countries make of one path, and what people make of it by hand.
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
    ASSERT_NO_THROW(poses = kReadPoses(text)) << text << refusal_of(kReadPoses, text);
    ASSERT_EQ(poses.size(), path.size()) << text;
    for (std::size_t n = 0; n < path.size(); ++n) {
      EXPECT_EQ(poses[n].t, path[n].t) << text;
      EXPECT_EQ(poses[n].pose.translation, path[n].pose.translation) << text;
    }
  }
}

TEST(PosesOfText, AreNotGuessedWhereACommaMayMeanTwoThings) {
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(refusal_of(kReadPoses, text).find(part), std::string::npos) << refusal_of(kReadPoses, text);
  };
  expect("t_s,x_mm,y_mm,z_mm\n0,\"1,234\",0,0\n",
         "a.csv:2: \"1,234\" may have a decimal comma, or one that marks thou");
  EXPECT_EQ(kReadPoses("t_s,x_mm,y_mm,z_mm\n0,\"0,234\",0,0\n\"0,5\",\"1,5\",0,0\n")[1].t, 0.5);
  const std::string thousands = "t_s;x_mm;y_mm;z_mm\n0;0;0;0\n1;-1,005;0;0\n2;3,000;0;0\n";
  for (const char* separator : {";", "\t", "  "})
    expect(replaced(thousands, ";", separator),
           "a.csv:3: \"-1,005\" may have a decimal comma, or one that marks thousands; write -1,0050, or -1005.");
  expect(replaced(thousands, ",", "."), "a.csv:3: \"-1.005\" may have a decimal point, or one that marks thousands");
  EXPECT_DOUBLE_EQ(kReadPoses(replaced(replaced(thousands, ",", "."), ";", "\t"))[2].pose.translation.x(), 3e-3);
  for (const char* decimal : {"0,000", "3,0000", "1234,000", "3,0", "03,000"})  // one number tells of all
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
  const std::string names = "t_s,x_mm,y_mm,z_mm\n";
  EXPECT_TRUE(refusal_of(kReadPoses, "").starts_with("a.csv:0: "));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "0,0,0,0\n1,nan,0,0\n").starts_with("a.csv:3: x_mm = \"nan\""));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "0,0,0\n").starts_with("a.csv:2: 3 values"));
  EXPECT_TRUE(refusal_of(kReadPoses, names + "1,0,0,0\n0,0,0,0\n").starts_with("a.csv:3: t_s = 0"));
}

TEST(TextFiles, NameEachColumnOnce) {
  const std::string path = "t_s,x_mm,y_mm,z_mm,x_mm\n0,1,2,3,4\n1,1,2,3,4\n",
                    profile = "rho_mm,z_mm,z_mm\n0,0,0\n1,1,1\n";
  EXPECT_NE(refusal_of(kReadPoses, path).find("a.csv:1: the column x_mm is named twice"), std::string::npos)
      << refusal_of(kReadPoses, path);
  EXPECT_NE(refusal_of(kReadProfile, profile).find("z_mm is named twice"), std::string::npos);
  EXPECT_EQ(refusal_of(kReadPoses, "t_s,x_mm,y_mm,z_mm,,\n0,1,2,3,,\n1,1,2,3,,\n"), "");
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
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm,color\n").starts_with("a.csv:1: there is no column color"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n0,0\n1,x\n").starts_with("a.csv:3: 'x' is not a number"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n0,nan\n").starts_with("a.csv:2: 'nan' is not a number"));
  EXPECT_TRUE(refusal_of(kReadProfile, "rho_mm,z_mm\n1,0\n").starts_with("a.csv:2: rho_mm = 1"));
}

}  // namespace
}  // namespace hapticut::text_files_test
