// SPDX-License-Identifier: Apache-2.0
#include "io/vdb/vdb_check.hpp"

#include <openvdb/Grid.h>
#include <openvdb/version.h>

#include <cctype>
#include <utility>

namespace hapticut {
namespace {

constexpr std::uint32_t kOldestFormat = 222;  // format of 2012; older files store nodes differently
constexpr std::string_view kDelayedLoading = "__delayedload";

std::string_view read_string(ByteReader& in) { return in.read(in.read<std::uint32_t>()); }

/// OpenVDB stops at the first invalid character and misreads the rest as the following data.
bool is_unique_id(std::string_view id) {
  for (std::size_t n = 0; n < id.size(); ++n) {
    const bool dash = n == 8 || n == 13 || n == 18 || n == 23;
    if (dash ? id[n] != '-' : std::isxdigit(static_cast<unsigned char>(id[n])) == 0) return false;
  }
  return true;
}

/// @return true when the file has a table of offsets
bool check_header(ByteReader& in) {
  if (in.read<std::int64_t>() != openvdb::OPENVDB_MAGIC) throw Error("it is not a .vdb file.");
  const auto format = in.read<std::uint32_t>();
  // OpenVDB only warns about an unknown format and continues.
  if (format < kOldestFormat || format > openvdb::OPENVDB_FILE_VERSION)
    throw Error("it has version " + std::to_string(format) + " of the OpenVDB format; " +
                std::to_string(kOldestFormat) + " to " + std::to_string(openvdb::OPENVDB_FILE_VERSION) +
                " are supported. Save it again with another version of the program that wrote it.");
  in.skip(8);  // version of the library
  const auto offsets = in.read<std::uint8_t>();
  if (offsets > 1) damaged_vdb("header is unreadable");
  if (!is_unique_id(in.read(36))) damaged_vdb("unique id is unreadable");
  return offsets == 1;
}

/// Checks a list of metadata.
/// @param[in,out] bytes  the file; hints for delayed loading get an unknown type, which OpenVDB skips
/// @return true when real numbers are stored with 16 bits
bool check_metadata(ByteReader& in, std::string& bytes) {
  bool half = false;
  const auto count = in.read<std::uint32_t>();
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::string_view name = read_string(in);
    const std::string type(read_string(in));
    const std::size_t end_of_type = in.position();
    const std::string_view value = read_string(in);
    if (name == openvdb::GridBase::META_SAVE_HALF_FLOAT) {
      if (type != "bool") damaged_vdb("metadata have an entry of the wrong type");
      half = !value.empty() && value[0] != 0;
    }
    if (type == kDelayedLoading) {
      // OpenVDB does not check the lengths inside this entry, and its hints are not needed here.
      bytes[end_of_type - 1] = '_';
    } else if (type != "string" && openvdb::Metadata::isRegisteredType(type)) {
      if (value.size() != openvdb::Metadata::createMetadata(type)->size())
        damaged_vdb("metadata have an entry of the wrong length");
      if (type == "bool" && std::uint8_t(value[0]) > 1)
        damaged_vdb("metadata have an entry that is neither true nor false");
    }
  }
  return half;
}

/// @param nested  whether the map is part of another one
void check_transform(ByteReader& in, bool nested = false) {
  constexpr std::uint64_t kVector = 24, kMatrix = 128;  // [bytes]
  const std::string_view type = read_string(in);
  if (type == "AffineMap" || type == "UnitaryMap")
    in.skip(kMatrix);
  else if (type == "ScaleMap" || type == "UniformScaleMap")
    in.skip(5 * kVector);
  else if (type == "TranslationMap")
    in.skip(kVector);
  else if (type == "ScaleTranslateMap" || type == "UniformScaleTranslateMap")
    in.skip(6 * kVector);
  else if (type == "NonlinearFrustumMap" && !nested) {
    in.skip(2 * kVector + 2 * sizeof(double));
    check_transform(in, true);
  } else
    damaged_vdb("transform is of an unknown kind");
}

/// "Tree_float_5_4_3_HalfFloat" -> "float".
std::string type_of_value(std::string_view type) {
  if (!type.starts_with("Tree_")) return std::string(type);
  type.remove_prefix(5);
  return std::string(type.substr(0, type.find('_')));
}

bool is_usable(std::string_view type) {
  constexpr std::string_view kHalf = "_HalfFloat";
  if (type.ends_with(kHalf)) type.remove_suffix(kHalf.size());
  return type == "Tree_float_5_4_3" || type == "Tree_int32_5_4_3";
}

}  // namespace

std::vector<VdbEntry> check_vdb(std::string& bytes) {
  ByteReader in(bytes);
  const bool has_offsets = check_header(in);
  check_metadata(in, bytes);
  const std::size_t at_count = in.position();
  const auto count = in.read<std::int32_t>();
  if (count < 0) damaged_vdb("number of grids is negative");

  std::vector<VdbEntry> entries;
  std::vector<std::pair<std::size_t, std::size_t>> unusable;  // first byte and end of grids to remove
  for (std::int32_t n = 0; n < count; ++n) {
    const std::size_t begin = in.position();
    const std::string_view name = read_string(in);
    const std::string_view type = read_string(in);
    const bool is_instance = !read_string(in).empty();
    in.skip(2 * sizeof(std::int64_t));  // position of its data
    const auto end = in.read<std::uint64_t>();
    // A repeated grid name has a separator and a number appended.
    entries.push_back({std::string(name.substr(0, name.find('\x1e'))), type_of_value(type), 0});
    if (is_usable(type)) {
      VdbStorage storage;
      storage.compression = in.read<std::uint32_t>();
      storage.half = check_metadata(in, bytes) && entries.back().type == "float";
      check_transform(in);
      if (!is_instance) entries.back().memory = check_vdb_tree(in, storage);
    } else {
      if (!has_offsets)
        throw Error("it has the grid '" + entries.back().name + "' of type '" + entries.back().type +
                    "' and no table of offsets to skip it with; save it without that grid.");
      in.advance_to(end);
      unusable.emplace_back(begin, in.position());
    }
  }
  const auto left = std::int32_t(std::size_t(count) - unusable.size());
  std::memcpy(bytes.data() + at_count, &left, sizeof left);
  for (; !unusable.empty(); unusable.pop_back())  // from the end, so earlier positions stay valid
    bytes.erase(unusable.back().first, unusable.back().second - unusable.back().first);
  return entries;
}

}  // namespace hapticut
