// SPDX-License-Identifier: Apache-2.0
// Heads of the catalogue and of profiles on the command line.
#include <cmath>

#include "hapticut/core/errors.hpp"
#include "hapticut/tool/catalogue.hpp"
#include "settings/setting.hpp"
#include "support/program.hpp"
#ifdef HAPTICUT_HAS_IMPORT
#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/tool/mesh_of_revolution.hpp"
#endif

namespace hapticut::cli_heads_test {
namespace {

using test::write_bytes;

class HeadSettings : public test::Program {
 protected:
  static constexpr const char* kBone = "--workpiece block --size_mm 6,6,3 --material cortical_bone --voxel_mm 0.2 ";
  static constexpr const char* kPlunge =
      " --spindle_rpm 30000 --path line --from_mm 3,3,3.1 --to_mm 3,3,2.1 --feed_mm_per_s "
      "10 ";

  nlohmann::json plunge(const std::string& head) { return drill(kBone + head + kPlunge); }

  void expect_failure(const std::string& head, const std::vector<std::string>& words) {
    expect_refused("drill " + (kBone + head) + kPlunge, words);
  }
};

TEST_F(HeadSettings, EveryHeadOfTheCatalogueIsPressedIn) {
  for (const HeadShape& shape : head_shapes()) {
    std::string head = "--head " + std::string(shape.name);
    for (const HeadShape::Dimension& dimension : shape.dimensions) {
      const settings::ShownUnit shown = settings::shown_unit(dimension.what.unit);
      head += " --" + std::string(dimension.what.name) + (shown.name.empty() ? "" : "_" + shown.name) + " " +
              format_number(dimension.usual / shown.factor);
    }
    EXPECT_GT(plunge(head)["force_N"]["max"], 1e-3) << head;
  }
  EXPECT_GT(plunge("--head twist_drill --diameter_mm 2 --length_mm 5")["force_N"]["max"], 1e-3);
}

TEST_F(HeadSettings, ARoundHeadIsASphereOfHalfTheDiameter) {
  const nlohmann::json sphere = plunge("--head sphere --radius_mm 0.7");
  const nlohmann::json round = plunge("--head round --diameter_mm 1.4");
  EXPECT_EQ(sphere["removed_volume_mm3"], round["removed_volume_mm3"]);
  EXPECT_EQ(sphere["force_N"], round["force_N"]);
}

TEST_F(HeadSettings, AProfileFromAFileIsThatHead) {
  // The tip need not be at 0: heights are relative to it.
  write_bytes(folder / "ball.csv",
              "# a ball\nz_mm, rho_mm, radius_mm, kind\n-5, 0, 0, cutting\n-3.6, 0, 0.7, cutting\n");
  const nlohmann::json sphere = plunge("--head sphere --radius_mm 0.7");
  const nlohmann::json profile = plunge("--head profile --profile " + path("ball.csv"));
  const double removed = sphere["removed_volume_mm3"]["total"], force = sphere["force_N"]["max"];
  EXPECT_NEAR(profile["removed_volume_mm3"]["total"], removed, 1e-4 * removed);
  EXPECT_NEAR(profile["force_N"]["max"], force, 1e-3 * force);
}

TEST_F(HeadSettings, SmoothEdgesOfAProfileDoNotCut) {
  write_bytes(folder / "drill.csv", "rho_mm,z_mm,kind\n0,0,cutting\n1,0.6,cutting\n1,5,smooth\n0,5,smooth\n");
  write_bytes(folder / "idle.csv", "rho_mm,z_mm,kind\n0,0,cutting\n1,0.6,smooth\n1,5,cutting\n0,5,smooth\n");
  const double cut = plunge("--head profile --profile " + path("drill.csv"))["removed_volume_mm3"]["total"];
  const double rubbed = plunge("--head profile --profile " + path("idle.csv"))["removed_volume_mm3"]["total"];
  EXPECT_GT(cut, 0.1);
  EXPECT_GT(rubbed, 0.1);
  EXPECT_GT(std::abs(rubbed - cut), 0.01);
}

#ifdef HAPTICUT_HAS_IMPORT
TEST_F(HeadSettings, AProfileFromAMeshIsThatHead) {
  using units::mm;
  write_stl(mesh_of_revolution(round_end_cylinder_head(1.2 * mm, 4 * mm).profile(), 60), folder / "bur.stl");
  const nlohmann::json head = plunge("--head round_end_cylinder --diameter_mm 1.2 --length_mm 4");
  const nlohmann::json mesh = plunge("--head profile --profile " + path("bur.stl"));
  const double removed = head["removed_volume_mm3"]["total"], force = head["force_N"]["max"];
  EXPECT_NEAR(mesh["removed_volume_mm3"]["total"], removed, 0.01 * removed);
  EXPECT_NEAR(mesh["force_N"]["max"], force, 0.01 * force);
}
#endif

TEST_F(HeadSettings, ThatAreMissingOrDoNotBelongAreNamed) {
  expect_failure("--head flame --diameter_mm 1", {"--length_mm is missing", "a flame needs it"});
  expect_failure("--head christmas_tree --diameter_mm 1 --length_mm 2", {"--tiers is missing"});
  expect_failure("--head round --diameter_mm 1 --radius_mm 1",
                 {"--radius_mm = 1; must be left out, because a round head has none", "--head sphere or flat"});
  expect_failure("--head round --diameter_mm 1 --tiers 2", {"--tiers = 2; must be left out", "--head christmas_tree"});
  expect_failure("--head round --diameter_mm 1 --flat_rule both",
                 {"--flat_rule is set; must be left out", "--head flat"});
  expect_failure("--head round --diameter_mm 1 --profile x.csv",
                 {"--profile = \"x.csv\"; must be left out", "--head profile"});
  expect_failure("--head profile", {"--profile is missing"});
  expect_failure("--head tapered --tip_diameter_mm 2 --diameter_mm 1 --length_mm 3", {"tip_diameter = 2 mm", "less"});
}

// The content of the lines: see text_files_test.cpp.
TEST_F(HeadSettings, ABadProfileFileIsNamed) {
  expect_failure("--head profile --profile " + path("none.csv"), {"none.csv", "cannot be read"});
  write_bytes(folder / "p.csv", "rho_mm,z_mm\n0,0\n1,0\n1,2\n");
  expect_failure("--head profile --profile " + path("p.csv"), {"p.csv", "not closed"});
}

}  // namespace
}  // namespace hapticut::cli_heads_test
