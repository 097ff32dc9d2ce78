// SPDX-License-Identifier: Apache-2.0
#include <openvdb/io/Compression.h>

#include <array>
#include <bit>
#include <sstream>

#include "io/vdb/vdb_check.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kValueSize = 4;             // [bytes] size of a float and of an int32
constexpr std::uint64_t kUpper = 32 * 32 * 32;    // entries of a node of the upper level
constexpr std::uint64_t kLower = 16 * 16 * 16;    // entries of a node of the lower level
constexpr std::uint64_t kLeaf = 8 * 8 * 8;        // voxels of a leaf
constexpr std::int32_t kUpperEdge = 4096;         // [voxels] edge of a node of the upper level
constexpr std::int32_t kMaxCoordinate = 1 << 30;  // [voxels] keeps sums of indices in range
constexpr std::size_t kMinBytesOfBlosc = 16;      // length of its header

/// A bit per entry of a node.
class Mask {
 public:
  Mask(ByteReader& in, std::uint64_t entries) : bytes_(in.read(entries / 8)) {}

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
  [[nodiscard]] std::uint64_t word(std::size_t at) const { return number_in<std::uint64_t>(bytes_.substr(at)); }

  std::string_view bytes_;
};

class TreeWalk {
 public:
  TreeWalk(ByteReader& in, const VdbStorage& storage) : in_(in), storage_(storage) {}

  void walk() {
    if (in_.read<std::int32_t>() != 1) damaged_vdb("tree has an unknown number of buffers");
    in_.skip(kValueSize);  // background
    const auto tiles = in_.read<std::uint32_t>();
    const auto children = in_.read<std::uint32_t>();
    for (std::uint32_t n = 0; n < tiles; ++n) {
      read_origin();
      in_.skip(kValueSize);
      if (in_.read<std::uint8_t>() > 1) damaged_vdb("tree has a region that is neither on nor off");
    }
    std::array<std::int32_t, 3> last{};
    for (std::uint32_t n = 0; n < children; ++n) {
      const auto origin = read_origin();
      // OpenVDB reads the nodes in file order, but their values in the order of their positions.
      if (n > 0 && origin <= last) damaged_vdb("tree is not in order");
      last = origin;
      walk_upper();
    }
    for (std::uint64_t n = 0; n < leaves_; ++n) {
      const Mask values(in_, kLeaf);
      walk_values(kLeaf, values);
    }
  }

  /// [bytes] Size of the nodes in memory.
  [[nodiscard]] std::uint64_t memory() const {
    constexpr std::uint64_t kOfEntry = 8;   // a value or a pointer, in a node
    constexpr std::uint64_t kOfLeaf = 256;  // besides its values
    constexpr std::uint64_t kMaskOfLeaf = 64;
    return leaves_ * (kLeaf * kValueSize + kMaskOfLeaf + kOfLeaf) + lower_ * kLower * kOfEntry +
           upper_ * kUpper * kOfEntry;
  }

 private:
  std::array<std::int32_t, 3> read_origin() {
    std::array<std::int32_t, 3> origin{};
    for (auto& coordinate : origin) {
      coordinate = in_.read<std::int32_t>();
      if (coordinate % kUpperEdge != 0 || coordinate < -kMaxCoordinate || coordinate > kMaxCoordinate)
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
    ++upper_;
    lower_ += children;
    for (std::uint64_t n = 0; n < children; ++n) {
      const std::uint64_t leaves = walk_node(kLower);
      in_.skip(leaves * kLeaf / 8);
      leaves_ += leaves;
    }
  }

  void walk_values(std::uint64_t entries, const Mask& active) {
    using namespace openvdb::io;
    const int kind = in_.read<std::uint8_t>();
    if (kind > NO_MASK_AND_ALL_VALS) damaged_vdb("values have an unknown encoding");
    constexpr std::size_t kInactiveValues[] = {0, 0, 1, 0, 1, 2, 0};  // in the order of these kinds
    in_.skip(kInactiveValues[kind] * kValueSize);
    if (kind >= MASK_AND_NO_INACTIVE_VALS && kind <= MASK_AND_TWO_INACTIVE_VALS) in_.skip(entries / 8);
    const bool all = (storage_.compression & COMPRESS_ACTIVE_MASK) == 0 || kind == NO_MASK_AND_ALL_VALS;
    const std::uint64_t count = all ? entries : active.count();
    if (storage_.half && count == 0) return;
    walk_chunk(count * (storage_.half ? 2 : kValueSize), entries != kLeaf);
  }

  /// @param size     [bytes] uncompressed
  /// @param in_node  true: node, false: leaf
  void walk_chunk(std::uint64_t size, bool in_node) {
    using namespace openvdb::io;
    const bool blosc = (storage_.compression & COMPRESS_BLOSC) != 0;
    if (!blosc && (storage_.compression & COMPRESS_ZIP) == 0) {
      in_.skip(size);
      return;
    }
    const auto length = in_.read<std::int64_t>();  // negative: uncompressed
    if (length <= 0) {
      if (std::uint64_t(0) - std::uint64_t(length) != size) damaged_vdb("values have an impossible length");
      in_.skip(size);
      return;
    }
    const std::string_view packed = in_.read(std::uint64_t(length));
    if (blosc) check_head_of_blosc(packed, size);
    if (in_node) unpack(packed, size, blosc);
  }

  /// Header: versions and flags, uncompressed size, block size, compressed size.
  static void check_head_of_blosc(std::string_view packed, std::uint64_t size) {
    if (packed.size() < kMinBytesOfBlosc) damaged_vdb("compressed values are too short");
    ByteReader head(packed);
    head.skip(4);
    const auto unpacked_bytes = head.read<std::uint32_t>();
    head.skip(4);
    const auto packed_bytes = head.read<std::uint32_t>();
    if (unpacked_bytes != size || packed_bytes != packed.size())
      damaged_vdb("compressed values have an impossible length");
  }

  /// OpenVDB leaks 270 kB for each node whose values it cannot unpack; leaves do not leak.
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
  std::uint64_t leaves_ = 0, lower_ = 0, upper_ = 0;  // nodes
};

}  // namespace

std::uint64_t check_vdb_tree(ByteReader& in, const VdbStorage& storage) {
  TreeWalk tree(in, storage);
  tree.walk();
  return tree.memory();
}

}  // namespace hapticut
