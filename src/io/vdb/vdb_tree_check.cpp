// SPDX-License-Identifier: Apache-2.0
#include <openvdb/io/Compression.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <sstream>

#include "io/vdb/vdb_check.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kValueSize = 4;           // [bytes] of a float and of an int32
constexpr std::uint64_t kUpper = 32 * 32 * 32;  // entries of a node of the upper level
constexpr std::uint64_t kLower = 16 * 16 * 16;  // and of the lower level
constexpr std::uint64_t kLeaf = 8 * 8 * 8;      // voxels of a leaf
constexpr std::int32_t kUpperEdge = 4096;       // [voxels] of a node of the upper level
constexpr std::int32_t kFarthest = 1 << 30;     // [voxels] leaves room for sums of indices
constexpr std::size_t kMinBytesOfBlosc = 16;    // length of its header

/// A bit per entry of a node.
class Mask {
 public:
  Mask(ByteReader& in, std::uint64_t entries) : bytes_(in.take(entries / 8)) {}

  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t on = 0;
    for (std::size_t at = 0; at < bytes_.size(); at += 8) on += std::uint64_t(std::popcount(word(at)));
    return on;
  }
  [[nodiscard]] bool overlaps(const Mask& other) const {
    for (std::size_t at = 0; at < bytes_.size(); at += 8)
      if ((word(at) & other.word(at)) != 0) return true;
    return false;
  }

 private:
  [[nodiscard]] std::uint64_t word(std::size_t at) const {
    std::uint64_t bits;
    std::memcpy(&bits, bytes_.data() + at, sizeof bits);
    return bits;
  }

  std::string_view bytes_;
};

class TreeWalk {
 public:
  TreeWalk(ByteReader& in, const VdbStorage& storage) : in_(in), storage_(storage) {}

  void walk() {
    if (in_.take<std::int32_t>() != 1) damaged_vdb("tree has an unknown number of buffers");
    in_.take(kValueSize);  // background
    const auto tiles = in_.take<std::uint32_t>();
    const auto children = in_.take<std::uint32_t>();
    for (std::uint32_t n = 0; n < tiles; ++n) {
      take_origin();
      in_.take(kValueSize);
      if (in_.take<std::uint8_t>() > 1) damaged_vdb("tree has a region that is neither on nor off");
    }
    std::array<std::int32_t, 3> last{};
    for (std::uint32_t n = 0; n < children; ++n) {
      const auto origin = take_origin();
      // OpenVDB reads the nodes in the order of the file, but their values in the order of their places.
      if (n > 0 && origin <= last) damaged_vdb("tree is not in order");
      last = origin;
      walk_upper();
    }
    for (std::uint64_t n = 0; n < leaves_; ++n) {
      const Mask values(in_, kLeaf);
      walk_values(kLeaf, values);
    }
  }

 private:
  std::array<std::int32_t, 3> take_origin() {
    std::array<std::int32_t, 3> origin{};
    for (auto& coordinate : origin) {
      coordinate = in_.take<std::int32_t>();
      if (coordinate % kUpperEdge != 0 || coordinate < -kFarthest || coordinate > kFarthest)
        damaged_vdb("tree has a region at an impossible place");
    }
    return origin;
  }

  /// @return number of its children
  std::uint64_t walk_node(std::uint64_t entries) {
    const Mask children(in_, entries);
    const Mask values(in_, entries);
    if (children.overlaps(values)) damaged_vdb("tree has a node that is a region as well");
    walk_values(entries, values);
    return children.count();
  }

  void walk_upper() {
    const std::uint64_t children = walk_node(kUpper);
    for (std::uint64_t n = 0; n < children; ++n) {
      const std::uint64_t leaves = walk_node(kLower);
      in_.take(leaves * kLeaf / 8);
      leaves_ += leaves;
    }
  }

  void walk_values(std::uint64_t entries, const Mask& active) {
    using namespace openvdb::io;
    const int kind = in_.take<std::uint8_t>();
    if (kind > NO_MASK_AND_ALL_VALS) damaged_vdb("values have an unknown encoding");
    if (kind == NO_MASK_AND_ONE_INACTIVE_VAL || kind == MASK_AND_ONE_INACTIVE_VAL) in_.take(kValueSize);
    if (kind == MASK_AND_TWO_INACTIVE_VALS) in_.take(2 * kValueSize);
    if (kind == MASK_AND_NO_INACTIVE_VALS || kind == MASK_AND_ONE_INACTIVE_VAL || kind == MASK_AND_TWO_INACTIVE_VALS)
      in_.take(entries / 8);
    const bool all = (storage_.compression & COMPRESS_ACTIVE_MASK) == 0 || kind == NO_MASK_AND_ALL_VALS;
    const std::uint64_t count = all ? entries : active.count();
    if (storage_.half && count == 0) return;
    walk_chunk(count * (storage_.half ? 2 : kValueSize), entries != kLeaf);
  }

  /// @param size     [bytes] when it is not compressed
  /// @param in_node  false: in a leaf
  void walk_chunk(std::uint64_t size, bool in_node) {
    using namespace openvdb::io;
    const bool blosc = (storage_.compression & COMPRESS_BLOSC) != 0;
    if (!blosc && (storage_.compression & COMPRESS_ZIP) == 0) {
      in_.take(size);
      return;
    }
    const auto length = in_.take<std::int64_t>();  // negative: not compressed
    if (length <= 0) {
      if (std::uint64_t(0) - std::uint64_t(length) != size) damaged_vdb("values have an impossible length");
      in_.take(size);
      return;
    }
    const std::string_view packed = in_.take(std::uint64_t(length));
    if (blosc) check_head_of_blosc(packed, size);
    if (in_node) unpack(packed, size, blosc);
  }

  /// Versions and flags; bytes after and before decompression, between them the size of a block.
  static void check_head_of_blosc(std::string_view packed, std::uint64_t size) {
    if (packed.size() < kMinBytesOfBlosc) damaged_vdb("compressed values are too short");
    ByteReader head(packed);
    head.take(4);
    const auto unpacked_bytes = head.take<std::uint32_t>();
    head.take(4);
    const auto packed_bytes = head.take<std::uint32_t>();
    if (unpacked_bytes != size || packed_bytes != packed.size())
      damaged_vdb("compressed values have an impossible length");
  }

  /// OpenVDB loses the memory of a node whose values it cannot unpack, 270 kB each time; that of a leaf it does not.
  static void unpack(std::string_view packed, std::uint64_t size, bool blosc) {
    const auto length = std::int64_t(packed.size());
    std::string chunk(reinterpret_cast<const char*>(&length), sizeof length);
    std::istringstream stream(chunk.append(packed), std::ios_base::binary);
    std::string values(size, '\0');
    try {
      (blosc ? openvdb::io::bloscFromStream : openvdb::io::unzipFromStream)(stream, values.data(), values.size());
    } catch (const openvdb::Exception&) {
      damaged_vdb("compressed values cannot be unpacked");
    }
  }

  ByteReader& in_;
  VdbStorage storage_;
  std::uint64_t leaves_ = 0;
};

}  // namespace

void check_vdb_tree(ByteReader& in, const VdbStorage& storage) { TreeWalk(in, storage).walk(); }

}  // namespace hapticut
