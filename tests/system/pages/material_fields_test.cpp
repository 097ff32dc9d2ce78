// SPDX-License-Identifier: Apache-2.0
// Each described field of a material survives settings, grades, .vdb files and recordings. A forgotten field would come
// out with its default.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "settings/material_settings.hpp"
#include "support/temporary_folder.hpp"
#ifdef HAPTICUT_HAS_IO
#include "hapticut/io/recording/recorder.hpp"
#include "hapticut/io/recording/recording.hpp"
#endif

namespace hapticut::material_fields_test {
namespace {

/// Every number differs from the default of its field and from the numbers of other fields. Twice the number is within
/// the range of the field, because a grade ends there.
Material unusual() {
  Material material;
  material.name = "unusual";
  material.cutter = CutterKind::twist_drill;
  int n = 0;
  for_each_number<Material>([&](const auto& field) {
    const double base = material.*field.member;
    const bool is_pressure = std::string(field.unit) == "Pa";
    const double start = base > 0 ? base : is_pressure ? 1e6 : 0.125;
    material.*field.member = std::min(start, 0.125 * field.range.high) * (1 + 0.125 * ++n);
  });
  if (material.static_friction < material.dynamic_friction)
    std::swap(material.static_friction, material.dynamic_friction);
  return material;
}

void expect_same(const Material& found, const std::string& where) {
  const Material expected = unusual();
  for_each_field<Material>([&](const auto& field) {
    EXPECT_EQ(found.*field.member, expected.*field.member) << field.name << " was lost by " << where;
  });
}

Workpiece unusual_block() { return build_block({Vec3(-1e-3, -1e-3, -1e-3), Vec3(1e-3, 1e-3, 0)}, 2e-4, unusual()); }

TEST(MaterialFields, AllDifferFromTheirDefaultsHere) {
  EXPECT_NO_THROW(validate(unusual()));
  ASSERT_LE(kNumbersOf<Material>, 24U) << "a factor of 1 + n/8, twice, may exceed a range";
  for_each_number<Material>(
      [&](const auto& field) { EXPECT_NE(unusual().*field.member, Material{}.*field.member) << field.name; });
}

TEST(MaterialFields, AreAllSettings) {
  settings::MaterialChanges changes;
  std::vector<settings::Setting> settings = changes.setting().open_table("unusual");
  std::size_t n = 0;
  ASSERT_EQ(settings.at(n).key, "based_on");
  ASSERT_TRUE(settings.at(n++).assign(std::string("enamel")));
  for_each_number<Material>([&](const auto& field) {
    ASSERT_LT(n, settings.size());
    EXPECT_EQ(settings[n].key.rfind(field.name, 0), 0U) << settings[n].key;
    EXPECT_EQ(settings[n].meaning, field.text);
    EXPECT_FALSE(settings[n].assign(-1.0)) << field.name;
    EXPECT_TRUE(settings[n++].assign(unusual().*field.member)) << field.name;
  });
  ASSERT_EQ(settings.at(n).key, "cutter");
  EXPECT_TRUE(settings.at(n++).assign(std::string(name_or_null(*unusual().cutter))));
  EXPECT_EQ(n, settings.size());
  expect_same(changes.find("unusual"), "the settings");
}

TEST(MaterialFields, AreAllGraded) {
  Grade grade{.low = 0, .high = 1, .at_low = unusual(), .at_high = unusual(), .steps = 1};
  for_each_number<Material>([&](const auto& field) { grade.at_high.*field.member *= 2; });
  const Material middle = materials_of(grade).at(0);
  for_each_number<Material>([&](const auto& field) {
    // The grade is linear in their products with u: Grade.CutsLinearlyBetweenItsEnds.
    if (field.member == &Material::edge_length || field.member == &Material::size_length) {
      EXPECT_GT(middle.*field.member, unusual().*field.member) << field.name;
      return;
    }
    EXPECT_EQ(middle.*field.member, 1.5 * (unusual().*field.member)) << field.name << " was lost by the grade";
  });
  EXPECT_EQ(middle.cutter, CutterKind::twist_drill);
}

TEST(MaterialFields, AreAllInVdbFiles) {
  const test::TemporaryFolder folder;
  save_vdb(unusual_block(), folder / "a.vdb");
  expect_same(load_vdb(folder / "a.vdb").materials()[1], "the .vdb file");
}

#ifdef HAPTICUT_HAS_IO
TEST(MaterialFields, AreAllInRecordings) {
  const test::TemporaryFolder folder;
  Simulation simulation(unusual_block(), Tool(SphereHead{1e-3}), {});
  Recorder recorder(folder / "a.h5", simulation);
  recorder.step({Pose::from_translation(Vec3(0, 0, 2e-3)), {}, 1e-3});
  recorder.close();
  const Recording recording = read_recording(folder / "a.h5");
  expect_same(recording.workpiece().materials()[1], "the recording");
}
#endif

}  // namespace
}  // namespace hapticut::material_fields_test
