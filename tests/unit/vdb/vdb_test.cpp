// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/vdb/vdb.hpp"

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <random>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/openvdb.hpp"
#include "support/named_material.hpp"
#include "support/no_disk_space.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_data.hpp"

namespace hapticut::vdb_test {
namespace {

using test::named;
using test::TemporaryFolder;
using units::mm;
using units::mm3;

/// Two materials with odd numbers, a rotated frame, antialiased surfaces, and a hole cut through a tile.
Workpiece intricate_workpiece() {
  Material hard = named("hard");
  hard.relative_stiffness = 1.0 / 3;
  hard.damping = 0.1;
  hard.specific_cutting_energy = 2.7e9;
  hard.edge_pressure = 1e6 / 7;
  hard.static_friction = 0.37;
  hard.density = 2950.3;
  hard.cutter = CutterKind::fine_diamond;
  GridFrame frame{0.1 * mm / 3, {rotation_from_vector({0.3, -0.2, 0.7}), Vec3(1, -2, 3) * mm / 7}};
  Workpiece workpiece = Workpiece::from_blocks(
      {{-40, -40, -40}, {39, 39, 39}}, frame, MaterialTable({hard, named("soft")}),
      [](const VoxelIndex& origin, BlockContent& content) {
        for (int n = 0; n < kBlockVoxels; ++n) {
          const VoxelIndex at = voxel_at(origin, n);
          const Vec3 p(at[0], at[1], at[2]);
          const double depth = 35.3 - p.norm();
          content.material[n] = p.z() > 0 ? 1 : 2;
          content.fill[n] = float(std::clamp(depth + 0.5, 0.0, 1.0));
          const bool partial = content.fill[n] > 0 && content.fill[n] < 1;
          content.centroid[n] = partial ? CentroidOffset::from_offset(-0.3 * p.normalized()) : CentroidOffset{};
        }
        return BlockKind::mixed();
      });
  workpiece.reserve_blocks(1);
  float* fill = workpiece.writable_fill({0, 0, 0});
  EXPECT_NE(fill, nullptr);
  fill[17] = 1.0F / 3;
  const BlockMask emptied = {{0, 0xff, 0, 0, 0, 0, 0, 1}};
  workpiece.empty_voxels({0, 0, 0}, emptied);
  return workpiece;
}

TEST(Vdb, AWorkpieceComesBackBitByBit) {
  const TemporaryFolder folder;
  const Workpiece saved = intricate_workpiece();
  save_vdb(saved, folder / "a.vdb");
  const Workpiece loaded = load_vdb(folder / "a.vdb");

  EXPECT_EQ(loaded.hash(), saved.hash());
  EXPECT_EQ(loaded.solid_voxels(), saved.solid_voxels());
  EXPECT_EQ(loaded.voxel_size(), saved.voxel_size());
  EXPECT_EQ(loaded.frame().X_WV.rotation, saved.frame().X_WV.rotation);
  EXPECT_EQ(loaded.frame().X_WV.translation, saved.frame().X_WV.translation);
  ASSERT_EQ(loaded.materials().size(), 2);
  for (MaterialId id = 1; id <= 2; ++id) {
    const Material& a = saved.materials()[id];
    const Material& b = loaded.materials()[id];
    for_each_field<Material>([&](const auto& field) { EXPECT_EQ(a.*field.member, b.*field.member) << field.name; });
  }
  int with_centroid = 0;
  saved.for_each_block([&](const BlockView& block) {
    for (int n = 0; n < kBlockVoxels; ++n) {
      const VoxelIndex at = voxel_at(block.origin, n);
      ASSERT_EQ(loaded.centroid_at(at), saved.centroid_at(at));
      with_centroid += saved.centroid_at(at) == CentroidOffset{} ? 0 : 1;
    }
  });
  EXPECT_GT(with_centroid, 1000);
}

TEST(Vdb, ALoadedWorkpieceCanBeCut) {
  const TemporaryFolder folder;
  save_vdb(intricate_workpiece(), folder / "a.vdb");
  Workpiece loaded = load_vdb(folder / "a.vdb");
  loaded.reserve_blocks(2);
  ASSERT_NE(loaded.writable_fill({8, 8, 8}), nullptr);
  const BlockMask emptied = {{1, 0, 0, 0, 0, 0, 0, 0}};
  const std::int64_t before = loaded.solid_voxels();
  loaded.empty_voxels({8, 8, 8}, emptied);
  EXPECT_EQ(loaded.solid_voxels(), before - 1);
}

TEST(Vdb, ASolidBlockOf256MillionVoxelsNeedsKilobytes) {
  const TemporaryFolder folder;
  const Workpiece block = build_block({Vec3::Zero(), Vec3(40, 40, 20) * mm}, 0.05 * mm, named("clay"));
  save_vdb(block, folder / "block.vdb");
  EXPECT_LT(std::filesystem::file_size(folder / "block.vdb"), 400'000U);
  const Workpiece loaded = load_vdb(folder / "block.vdb");
  EXPECT_EQ(loaded.solid_voxels(), block.solid_voxels());
  EXPECT_LE(loaded.memory_bytes(), block.memory_bytes() * 2);
}

TEST(Vdb, VoxelsOfTenMicrometresCanBeSaved) {
  const TemporaryFolder folder;
  const Workpiece ball = build_sphere(Vec3::Zero(), 0.1 * mm, 0.01 * mm, named("clay"));
  save_vdb(ball, folder / "ball.vdb");
  EXPECT_EQ(load_vdb(folder / "ball.vdb").hash(), ball.hash());
}

TEST(Vdb, OtherProgramsReadDensityMaterialAndTransform) {
  if (std::system("vdb_print -h > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the program vdb_print (Debian package libopenvdb-tools)";
  const TemporaryFolder folder;
  save_vdb(build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, 0.1 * mm, named("clay")), folder / "ball.vdb");
  const std::string command =
      "vdb_print -m " + (folder / "ball.vdb").string() + " > " + (folder / "out.txt").string() + " 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string text = test::read_bytes(folder / "out.txt");
  for (const char* expected : {"density      float", "material     int32", "centroid     int32", "class: fog volume",
                               "voxel size: 0.1", "hapticut_material_1_name: clay"})
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " is missing in:\n" << text;
}

TEST(Vdb, PythonReadsTheSameDensityAndPlace) {
  if (std::system("/usr/bin/python3 -c 'import pyopenvdb, numpy' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the Python module pyopenvdb (Debian packages python3-openvdb and python3-numpy)";
  const TemporaryFolder folder;
  const Workpiece ball = build_sphere(Vec3(1, 2, 3) * mm, 2 * mm, 0.1 * mm, named("clay"));
  save_vdb(ball, folder / "ball.vdb");
  test::write_bytes(folder / "check.py", R"(
import sys
import pyopenvdb as vdb
density = vdb.read(sys.argv[1], 'density')  # Debian's pyopenvdb is built without int32 grids: not 'material'
volume = sum(v.value * v.count for v in density.citerOnValues()) * density.transform.voxelVolume()
world = density.transform.indexToWorld((0, 0, 0))
print(repr(volume), density.activeVoxelCount(), *(repr(x) for x in world))
)");
  const std::string command = "/usr/bin/python3 " + (folder / "check.py").string() + " " +
                              (folder / "ball.vdb").string() + " > " + (folder / "out.txt").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream out(folder / "out.txt");
  double volume_mm3 = 0;
  std::int64_t voxels = 0;
  Vec3 first;
  ASSERT_TRUE(out >> volume_mm3 >> voxels >> first.x() >> first.y() >> first.z());
  const double kSingleSum = 1e-6;  // the fractions are single precision, the sums double
  EXPECT_NEAR(volume_mm3, ball.amounts()[0].volume / mm3, kSingleSum * volume_mm3);
  EXPECT_EQ(voxels, ball.solid_voxels());
  EXPECT_LT((first * mm - ball.frame().center({0, 0, 0})).norm(), 1e-12);
}

TEST(Vdb, AFileThatIsCutOffAnywhereIsRefused) {
  const TemporaryFolder folder;
  save_vdb(build_sphere(Vec3::Zero(), 1 * mm, 0.1 * mm, named("clay")), folder / "a.vdb");
  const std::string bytes = test::read_bytes(folder / "a.vdb");
  for (std::size_t part = 0; part < 97; ++part) {
    test::write_bytes(folder / "cut.vdb", bytes.substr(0, bytes.size() * part / 97));
    EXPECT_THROW((void)load_vdb(folder / "cut.vdb"), Error) << "at " << part << "/97";
  }
  test::write_bytes(folder / "cut.vdb", bytes.substr(0, bytes.size() - 1));
  EXPECT_THROW((void)load_vdb(folder / "cut.vdb"), Error);
}

TEST(Vdb, AFileOfAnotherFormatIsRefusedNamingItsReader) {
  const TemporaryFolder folder;
  save_vdb(build_sphere(Vec3::Zero(), 1 * mm, 0.2 * mm, named("clay")), folder / "a.vdb");
  for (const int format : {1, 3}) {
    openvdb::io::File file((folder / "a.vdb").string());
    file.open();
    const openvdb::GridPtrVecPtr grids = file.getGrids();
    for (const auto& grid : *grids)
      if (grid->getName() == "material") grid->insertMeta("hapticut_format", openvdb::Int32Metadata(format));
    openvdb::io::File((folder / "b.vdb").string()).write(*grids);
    const std::string error = test::refusal([&] { return load_vdb(folder / "b.vdb"); });
    test::expect_part(error, "format " + std::to_string(format));
    test::expect_part(error, "Use the version that wrote it");
  }
}

TEST(Vdb, RandomBytesAndOtherFilesAreRefused) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::string bytes(std::size_t(round * 100), ' ');
    for (char& c : bytes) c = char(random());
    test::write_bytes(folder / "random.vdb", bytes);
    EXPECT_THROW((void)load_vdb(folder / "random.vdb"), Error);
  }
  test::expect_refused([&] { return load_vdb(folder / "missing.vdb"); }, "missing.vdb");
  test::expect_refused([&] { return load_vdb(folder / "."); }, "folder");
}

TEST(Vdb, AFullDiskIsReportedAndTheOldFileStays) {
  const TemporaryFolder folder;
  const Workpiece old_one = build_sphere(Vec3::Zero(), 1 * mm, 0.1 * mm, named("clay"));
  save_vdb(old_one, folder / "a.vdb");
  for (const rlim_t bytes : {0, 100, 1000, 5000}) {
    const test::NoDiskSpace no_space(bytes);
    test::expect_refused([&] { save_vdb(intricate_workpiece(), folder / "a.vdb"); }, "a.vdb");
  }
  EXPECT_EQ(load_vdb(folder / "a.vdb").hash(), old_one.hash());
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(Vdb, AFailureToWriteIsReported) {
  const TemporaryFolder folder;
  const Workpiece ball = build_sphere(Vec3::Zero(), 1 * mm, 0.2 * mm, named("clay"));
  EXPECT_THROW(save_vdb(ball, folder / "no" / "such" / "folder.vdb"), Error);
  test::expect_refused([&] { save_vdb(ball, "/dev/full"); }, "not a regular file");
  EXPECT_THROW(save_vdb(ball, folder / "."), Error);
  if (::geteuid() == 0) return;  // root may write anywhere
  std::filesystem::create_directory(folder / "locked");
  ::chmod((folder / "locked").c_str(), 0555);
  test::expect_refused([&] { save_vdb(ball, folder / "locked" / "a.vdb"); }, "ermission");
}

TEST(Vdb, ALevelSetOfAnotherProgramGivesItsBall) {
  HAPTICUT_NEEDS_DATA("vdb/sphere.vdb");
  VdbImport import{named("clay"), "", 1, VdbImport::Kind::from_class};
  const Workpiece ball = load_vdb(test::data_path("vdb/sphere.vdb"), import);
  EXPECT_NEAR(ball.voxel_size(), 0.05 * mm, 1e-12);
  // The grid is a ball of radius 3 mm; its half-float distances give the volume to 1e-3.
  EXPECT_NEAR(ball.amounts()[0].volume / mm3, 4.0 / 3 * units::kPi * 27, 1e-3 * 113.1);
  EXPECT_EQ(ball.fill_at({0, 0, 0}), 1.0);
  EXPECT_EQ(ball.fill_at({61, 0, 0}), 0.0);
}

TEST(Vdb, AFogVolumeOfAnotherProgramKeepsItsPlace) {
  const TemporaryFolder folder;
  const Workpiece ball = build_sphere(Vec3(1, 2, 3) * mm, 1 * mm, 0.1 * mm, named("bone"));
  openvdb::initialize();
  openvdb::io::File file((folder / "ball.vdb").string());
  file.write({density_grid(ball, 1e-3)});
  file.close();
  const Workpiece fog = load_vdb(folder / "ball.vdb", {named("clay"), "density"});
  EXPECT_EQ(fog.solid_voxels(), ball.solid_voxels());
  EXPECT_LT((fog.frame().center({5, 6, 7}) - ball.frame().center({5, 6, 7})).norm(), 1e-12);
}

TEST(Vdb, AFileWithItsOwnMaterialsIsNotImportedAsOneMaterial) {
  const TemporaryFolder folder;
  save_vdb(build_sphere(Vec3::Zero(), 1 * mm, 0.1 * mm, named("bone")), folder / "ball.vdb");
  test::expect_refused(
      [&] {
        return load_vdb(folder / "ball.vdb", {named("clay"), "density"});
      },
      {"ball.vdb", "hapticut wrote it, with its own materials"});
}

TEST(Vdb, AFogVolumeOfAnythingButFractionsIsRefused) {
  HAPTICUT_NEEDS_DATA("vdb/smoke.vdb");  // densities up to 5.7
  test::expect_refused(
      [] {
        return load_vdb(test::data_path("vdb/smoke.vdb"), {named("smoke"), "density"});
      },
      "but values of a fog volume are filled fractions, 0 to 1. Scale the values");
}

TEST(Vdb, UnsuitableGridsAreRefusedWithTheCure) {
  openvdb::initialize();
  const TemporaryFolder folder;
  const auto refused = [&](const openvdb::GridPtrVec& grids, const std::string& grid, const std::string& part) {
    openvdb::io::File file((folder / "a.vdb").string());
    file.write(grids);
    file.close();
    test::expect_refused([&] { return load_vdb(folder / "a.vdb", {named("clay"), grid}); }, part);
  };
  const auto exact = openvdb::DoubleGrid::create();
  exact->setName("exact");
  refused({exact}, "", "it has 'exact' (double). Save a level set or fog volume with values of type float in it.");
  const auto one = openvdb::FloatGrid::create(), twin = openvdb::FloatGrid::create();
  one->setName("ls");
  twin->setName("ls");
  for (const char* name : {"", "ls", "other"}) refused({one, twin}, name, "Give its float grids different names");
  twin->setName("other");
  refused({one, twin}, "", "there is more than one float grid in it; it has 'ls' (float), 'other' (float). Name a");
}

TEST(Vdb, FilesOfTheWrongKindAreRefusedWithTheirContents) {
  HAPTICUT_NEEDS_DATA("vdb/sphere_points.vdb");
  const auto path = test::data_path("vdb/sphere_points.vdb");
  test::expect_refused([&] { return load_vdb(path); }, "'points'");
  test::expect_refused([&] { return load_vdb(path, {named("clay")}); }, "'points'");
  const auto sphere = test::data_path("vdb/sphere.vdb");
  test::expect_refused([&] { return load_vdb(sphere); }, "'ls_sphere'");
  test::expect_refused([&] { return load_vdb(sphere, {named("clay"), "other"}); }, "'other'");
}

}  // namespace
}  // namespace hapticut::vdb_test
