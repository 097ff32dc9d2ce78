// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <map>
#include <sstream>

#include "io/file_errors.hpp"
#include "io/volume/formats.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

/// The header of a MetaImage file, up to the name of its data file.
struct MetaHeader {
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0;  ///< where data in the same file begin

  [[nodiscard]] std::string get(const std::string& name, const std::string& otherwise) const {
    const auto found = fields.find(name);
    return found == fields.end() ? otherwise : found->second;
  }
  [[nodiscard]] bool is_true(const std::string& name) const {
    const std::string value = get(name, "False");
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
};

// ITK reads this format too, but the parser behind it prints to stderr when a header is damaged and stops the program
// on some that are not headers at all. The format is a list of `name = value`, so it is read here.

/// Takes nothing but short lines of plain text.
MetaHeader parse_header(const fs::path& path) {
  constexpr std::size_t kMaxLine = 255, kMaxLines = 200;
  std::ifstream file(path, std::ios::binary);
  MetaHeader header;
  std::string line;
  for (std::size_t count = 0; count < kMaxLines; ++count) {
    line.clear();
    for (char c = 0; line.size() <= kMaxLine && file.get(c);) {
      ++header.end;
      if (c == '\n') break;
      line += c;
    }
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const bool plain =
        std::all_of(line.begin(), line.end(), [](unsigned char k) { return k == '\t' || (k >= 32 && k < 127); });
    const std::size_t equals = line.find('=');
    if (!plain || line.size() > kMaxLine || equals == std::string::npos || equals == 0) break;
    const auto trimmed = [](std::string text) {
      text.erase(0, std::min(text.find_first_not_of(" \t"), text.size()));
      text.erase(text.find_last_not_of(" \t") + 1);
      return text;
    };
    const std::string name = trimmed(line.substr(0, equals));
    header.fields[name] = trimmed(line.substr(equals + 1));
    if (name != "ElementDataFile") continue;
    return header;
  }
  cannot_read(path, "it is not a MetaImage file, or its header is damaged.");
}

ValueType value_type(const fs::path& path, const std::string& name) {
  static const std::map<std::string, ValueType> kTypes = {
      {"MET_UCHAR", ValueType::uint8},       {"MET_CHAR", ValueType::int8},       {"MET_USHORT", ValueType::uint16},
      {"MET_SHORT", ValueType::int16},       {"MET_UINT", ValueType::uint32},     {"MET_INT", ValueType::int32},
      {"MET_ULONG_LONG", ValueType::uint64}, {"MET_LONG_LONG", ValueType::int64}, {"MET_FLOAT", ValueType::float32},
      {"MET_DOUBLE", ValueType::float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) cannot_read(path, "its values are of type '" + name + "', which is not read.");
  return found->second;
}

/// The numbers of a field that has several names; `otherwise` when it is absent.
template <std::size_t kCount>
std::array<double, kCount> numbers(const fs::path& path, const MetaHeader& header,
                                   const std::vector<std::string>& names, std::array<double, kCount> otherwise) {
  for (const std::string& name : names) {
    const auto found = header.fields.find(name);
    if (found == header.fields.end()) continue;
    std::istringstream text(found->second);
    text.imbue(std::locale::classic());
    for (double& number : otherwise)
      if (!(text >> number))
        cannot_read(path, "its field '" + name + "' is '" + found->second + "'; it must be " + std::to_string(kCount) +
                              " numbers.");
    break;
  }
  return otherwise;
}

/// Each row of the file's matrix is the direction of one axis.
FileGeometry geometry_in(const fs::path& path, const MetaHeader& header) {
  const auto dims = numbers<3>(path, header, {"DimSize"}, {0, 0, 0});
  require_sane_dims(path, dims);
  const auto spacing = numbers<3>(path, header, {"ElementSpacing", "ElementSize"}, {1, 1, 1});
  const auto origin = numbers<3>(path, header, {"Offset", "Position", "Origin"}, {0, 0, 0});
  const auto matrix =
      numbers<9>(path, header, {"TransformMatrix", "Orientation", "Rotation"}, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  FileGeometry geometry;
  for (unsigned axis = 0; axis < 3; ++axis) {
    if (dims[axis] != std::floor(dims[axis])) cannot_read(path, "its field 'DimSize' is not three whole numbers.");
    geometry.dims[axis] = int(dims[axis]);
    geometry.spacing_mm[axis] = spacing[axis];
    geometry.origin_mm[axis] = origin[axis];
    for (unsigned row = 0; row < 3; ++row) geometry.direction(row, axis) = matrix[3 * axis + row];
  }
  return geometry;
}

/// Unpacks zlib or gzip data; exactly `image.bytes.size()` bytes must come out.
void inflate(const fs::path& path, const std::string& packed, RawImage& image) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) cannot_read(path, "its data cannot be unpacked.");
  // zlib counts in 32 bits: hand over large data in pieces.
  constexpr std::size_t kPiece = std::size_t(1) << 30U;
  std::size_t in = 0, out = 0;
  int status = Z_OK;
  while (status == Z_OK) {
    const std::size_t give = std::min(kPiece, packed.size() - in), take = std::min(kPiece, image.bytes.size() - out);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data())) + in;  // zlib does not write to it
    stream.next_out = reinterpret_cast<Bytef*>(image.bytes.data()) + out;
    stream.avail_in = uInt(give);
    stream.avail_out = uInt(take);
    status = ::inflate(&stream, Z_NO_FLUSH);
    in += give - stream.avail_in;
    out += take - stream.avail_out;
    if (out == image.bytes.size()) break;
  }
  inflateEnd(&stream);
  if (out != image.bytes.size()) cannot_read(path, "its compressed data are damaged or cut short.");
}

void read_values(const fs::path& path, const MetaHeader& header, RawImage& image) {
  const std::string name = header.get("ElementDataFile", "");
  const bool local = name == "LOCAL" || name == "Local" || name == "local";
  const fs::path data_path = local ? path : path.parent_path() / name;
  const double available = double(readable_size(data_path)) - double(local ? header.end : 0);
  const double needed =
      double(image.geometry.dims[0]) * image.geometry.dims[1] * image.geometry.dims[2] * double(size_of(image.type));
  const bool compressed = header.is_true("CompressedData");
  require_bytes(path, needed, available, compressed ? kDeflate : kNotCompressed);

  std::ifstream file(data_path, std::ios::binary);
  file.seekg(std::streamoff(local ? header.end : 0));
  image.bytes.resize(std::size_t(needed));
  if (compressed) {
    std::string packed{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    inflate(path, packed, image);
  } else {
    const std::string skip = header.get("HeaderSize", "0");
    if (skip == "-1") {
      file.seekg(-std::streamoff(needed), std::ios::end);
    } else {
      file.seekg(std::strtoll(skip.c_str(), nullptr, 10), std::ios::cur);
    }
    file.read(reinterpret_cast<char*>(image.bytes.data()), std::streamsize(image.bytes.size()));
    if (file.gcount() != std::streamsize(image.bytes.size())) cannot_read(path, "it is cut short.");
  }
  if (header.is_true("BinaryDataByteOrderMSB") || header.is_true("ElementByteOrderMSB")) swap_bytes(image);
}

}  // namespace

RawImage read_meta_image(const fs::path& path) {
  (void)readable_size(path);
  const MetaHeader header = parse_header(path);
  const int dimensions = std::atoi(header.get("NDims", "0").c_str());
  if (dimensions != 3)
    cannot_read(path, "it has " + std::to_string(dimensions) +
                          " dimensions; a volume has three. Take one volume out of it, or put its slices together.");
  const std::string channels = header.get("ElementNumberOfChannels", "1");
  if (channels != "1") cannot_read(path, "it has " + channels + " values per sample; a volume has one.");
  const ValueType type = value_type(path, header.get("ElementType", "none"));
  const std::string data = header.get("ElementDataFile", "");
  if (data.empty() || data.rfind("LIST", 0) == 0 || data.find('%') != std::string::npos)
    cannot_read(path, "its data are in several files; save them as one.");
  if (header.fields.count("BinaryData") != 0 && !header.is_true("BinaryData"))
    cannot_read(path, "its data are text; save them as binary data.");

  RawImage image;
  image.geometry = geometry_in(path, header);
  image.type = type;
  read_values(path, header, image);
  return image;
}

}  // namespace hapticut
