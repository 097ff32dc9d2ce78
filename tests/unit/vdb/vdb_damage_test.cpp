// SPDX-License-Identifier: Apache-2.0
// Damaged .vdb files: whichever byte is wrong, the result is a workpiece or an Error.
#include <gtest/gtest.h>

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <cstring>
#include <random>
#include <sstream>

#include "hapticut/core/units.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/named_material.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"
#include "support/test_data.hpp"

namespace hapticut::vdb_damage_test {
namespace {

using test::TemporaryFolder;
using units::mm;

enum class Answer { workpiece, refused };

/// Reads bytes as a hapticut file or a file of another program; any result but a workpiece or an Error ends the test.
Answer answer_to(const std::string& bytes, const TemporaryFolder& folder, const VdbImport* import = nullptr) {
  test::write_bytes(folder / "a.vdb", bytes);
  const std::string refusal = test::refusal([&] {
    const Workpiece loaded = import == nullptr ? load_vdb(folder / "a.vdb") : load_vdb(folder / "a.vdb", *import);
    EXPECT_GE(loaded.solid_voxels(), 0);
  });
  if (refusal.empty()) return Answer::workpiece;
  test::expect_part(refusal, "a.vdb");
  return Answer::refused;
}

std::string small_file(const TemporaryFolder& folder) {
  save_vdb(build_sphere(Vec3::Zero(), 1 * mm, 0.2 * mm, test::named("clay")), folder / "small.vdb");
  return test::read_bytes(folder / "small.vdb");
}

/// Files like those of other programs: a level set of half floats or of another encoding, with unrelated grids.
std::string foreign_file(std::uint32_t compression, bool half, bool with_others) {
  openvdb::initialize();
  auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(1.0F, openvdb::Vec3f(0, 0, 0), 0.2F);
  grid->setName("ball");
  grid->setGridClass(openvdb::GRID_UNKNOWN);  // OpenVDB does not compress level sets
  grid->setSaveFloatAsHalf(half);
  openvdb::GridPtrVec grids{grid};
  if (with_others) {
    auto velocity = openvdb::Vec3SGrid::create();
    velocity->setName("velocity");
    velocity->tree().setValue({1, 2, 3}, openvdb::Vec3s(1, 2, 3));
    auto mask = openvdb::BoolGrid::create();
    mask->setName("mask");
    mask->tree().setValue({1, 2, 3}, true);
    grids.insert(grids.begin(), velocity);
    grids.push_back(mask);
  }
  class Archive : public openvdb::io::Stream {
   public:
    void write_to(std::ostream& stream, const openvdb::GridCPtrVec& list) const {
      openvdb::io::Archive::write(stream, list, /*seekable=*/true);
    }
  } archive;
  archive.setCompression(compression);
  std::ostringstream stream;
  archive.write_to(stream, openvdb::GridCPtrVec(grids.begin(), grids.end()));
  return stream.str();
}

VdbImport the_ball() { return {test::named("clay"), "ball", 1, VdbImport::Kind::level_set}; }

/// The bytes from `begin` to the nodes of the next grid: names, metadata, and last the transform.
std::size_t end_of_head(const std::string& bytes, std::size_t begin) {
  return bytes.find("UniformScale", begin) + std::strlen("UniformScaleTranslateMap") + 6 * 3 * sizeof(double);
}

/// Damages each byte of a part of the file in several ways.  @return number of files that were refused
int flip_every_byte(const std::string& bytes, std::size_t begin, std::size_t end, const TemporaryFolder& folder) {
  std::mt19937 random(1);
  int refused = 0;
  for (std::size_t at = begin; at < end; ++at)
    for (const int flip : {0xff, int(random() % 254 + 1)}) {
      std::string wrong = bytes;
      wrong[at] = char(wrong[at] ^ flip);
      refused += answer_to(wrong, folder) == Answer::refused ? 1 : 0;
    }
  return refused;
}

TEST(DamagedVdb, EveryWrongByteOfItsHeadGivesAWorkpieceOrAnError) {
  const TemporaryFolder folder;
  const std::string bytes = small_file(folder);
  const std::size_t head = end_of_head(bytes, 0);
  ASSERT_GT(head, 400U);
  ASSERT_LT(head, 1500U);
  // Most lengths and names matter; numbers, the unique id and unused entries do not.
  EXPECT_GT(flip_every_byte(bytes, 0, head, folder), int(head) / 2);
}

TEST(DamagedVdb, EveryWrongByteOfItsMaterialTableGivesAWorkpieceOrAnError) {
  const TemporaryFolder folder;
  const std::string bytes = small_file(folder);
  const std::size_t begin = bytes.find("material", end_of_head(bytes, 0)) - sizeof(std::int32_t);
  const std::size_t end = end_of_head(bytes, begin);
  ASSERT_GT(end - begin, 1000U);
  ASSERT_LT(end - begin, 3000U);
  EXPECT_GT(flip_every_byte(bytes, begin, end, folder), int(end - begin) / 2);
}

TEST(DamagedVdb, WrongBytesAnywhereGiveAWorkpieceOrAnError) {
  const TemporaryFolder folder;
  const std::string bytes = small_file(folder);
  std::mt19937 random(2);
  for (int round = 0; round < 1500; ++round) {
    std::string wrong = bytes;
    for (int n = 0; n <= round % 3; ++n) wrong[random() % wrong.size()] = char(random());
    (void)answer_to(wrong, folder);
  }
}

TEST(DamagedVdb, EveryLengthOfItsHeadIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = small_file(folder);
  for (std::size_t length = 0; length < end_of_head(bytes, 0); ++length)
    ASSERT_EQ(answer_to(bytes.substr(0, length), folder), Answer::refused) << length << " bytes";
}

class ForeignVdb : public testing::TestWithParam<std::uint32_t> {};

TEST_P(ForeignVdb, IsReadInEveryEncodingAndNeverHurtsWhenDamaged) {
  const TemporaryFolder folder;
  for (const bool half : {false, true}) {
    const std::string bytes = foreign_file(GetParam(), half, /*with_others=*/true);
    const VdbImport import = the_ball();
    ASSERT_EQ(answer_to(bytes, folder, &import), Answer::workpiece);
    std::mt19937 random(3);
    const bool small = (GetParam() & openvdb::io::COMPRESS_ACTIVE_MASK) != 0;
    for (int round = 0; round < (small ? 300 : 30); ++round) {
      std::string wrong = bytes;
      wrong[random() % wrong.size()] = char(random());
      (void)answer_to(wrong, folder, &import);
    }
    for (int part = 0; part < 30; ++part)
      EXPECT_EQ(answer_to(bytes.substr(0, bytes.size() * std::size_t(part) / 30), folder, &import), Answer::refused);
  }
}

INSTANTIATE_TEST_SUITE_P(Encodings, ForeignVdb, testing::Values(0U, 1U, 2U, 3U, 4U, 6U),
                         [](const auto& encoding) { return "Flags" + std::to_string(encoding.param); });

TEST(DamagedVdb, LengthsBeyondTheFileAreNotBelieved) {
  const TemporaryFolder folder;
  const std::string bytes = foreign_file(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK, false, false);
  const VdbImport import = the_ball();
  // The length of the first compressed chunk is the 8 bytes before the first zlib header.
  const std::size_t chunk = bytes.find("\x78\x9c", end_of_head(bytes, 0));
  ASSERT_NE(chunk, std::string::npos);
  for (const std::int64_t length :
       {std::int64_t(-1) << 62, std::int64_t(-1) << 40, std::int64_t(-1000), std::int64_t(0), std::int64_t(1) << 40}) {
    std::string wrong = bytes;
    std::memcpy(wrong.data() + chunk - 8, &length, sizeof length);
    EXPECT_EQ(answer_to(wrong, folder, &import), Answer::refused) << length;
  }
}

/// Positions of chunks compressed by Blosc: 8 bytes of length, then a header of 16 bytes that ends with the length.
std::vector<std::size_t> packed_chunks(const std::string& bytes) {
  constexpr std::size_t kLength = 8, kLengthInHead = 12, kHead = 16;
  std::vector<std::size_t> places;
  for (std::size_t at = 0; at + kLength + kHead <= bytes.size(); ++at) {
    std::int64_t length = 0;
    std::uint32_t in_head = 0;
    std::memcpy(&length, bytes.data() + at, sizeof length);
    std::memcpy(&in_head, bytes.data() + at + kLength + kLengthInHead, sizeof in_head);
    const bool version = bytes[at + kLength] == 2;
    if (version && length > std::int64_t(kHead) && length == std::int64_t(in_head)) places.push_back(at + kLength);
  }
  return places;
}

// OpenVDB refuses such values too, but leaks the memory of the node, so the reader must refuse them first.
TEST(DamagedVdb, ValuesOfANodeThatCannotBeUnpackedAreRefusedBeforeOpenVdb) {
  const TemporaryFolder folder;
  save_vdb(build_block({Vec3::Zero(), Vec3::Constant(3 * mm)}, 0.15 * mm, test::named("clay")), folder / "a.vdb");
  const std::string bytes = test::read_bytes(folder / "a.vdb");
  const std::vector<std::size_t> chunks = packed_chunks(bytes);
  ASSERT_FALSE(chunks.empty());
  int in_nodes = 0;
  for (const std::size_t chunk : chunks) {
    std::string wrong = bytes;
    wrong[chunk] = 99;  // version of Blosc
    test::write_bytes(folder / "a.vdb", wrong);
    const std::string refusal = test::refusal([&] { return load_vdb(folder / "a.vdb"); });
    EXPECT_NE(refusal, "") << chunk;
    if (refusal.find("compressed values cannot be unpacked") != std::string::npos) ++in_nodes;
  }
  EXPECT_GT(in_nodes, 0);
}

}  // namespace
}  // namespace hapticut::vdb_damage_test
