// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "import/volume/formats.hpp"
#include "import/volume/unpack.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

/// The header of a MetaImage file, up to the name of its data file.
struct MetaHeader {
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0;  ///< [bytes] position of the data in the same file

  [[nodiscard]] std::string get(const std::string& name, const std::string& otherwise) const {
    const auto found = fields.find(name);
    return found == fields.end() ? otherwise : found->second;
  }
  [[nodiscard]] bool is_true(const std::string& name) const {
    const std::string value = get(name, "False");
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
};

// ITK's parser of this format prints to stderr on damaged headers and stops the program on some files that are no
// headers. The format is a list of `name = value`, so it is parsed here.

bool is_local(std::string_view data_file) {
  return data_file == "LOCAL" || data_file == "Local" || data_file == "local";
}

/// Whether the values are in the files of a list that follows, or in numbered files: `v%03d.raw 1 30 1`. Else a name
/// may contain a percent sign, blanks and numbers.
bool is_several_files(std::string_view data_file) {
  if (data_file == "LIST" || data_file.starts_with("LIST ")) return true;
  const std::size_t percent = data_file.find('%'), d = data_file.find('d', percent),
                    blank = data_file.find_first_of(" \t", d);
  if (percent == std::string_view::npos || d == std::string_view::npos || blank == std::string_view::npos) return false;
  const std::string_view width = data_file.substr(percent + 1, d - percent - 1);
  const std::optional<std::vector<double>> numbers = numbers_in(data_file.substr(blank), " \t");
  return width.find_first_not_of("0123456789") == std::string_view::npos && numbers && numbers->size() >= 2;
}

/// Reads the lines of the header: up to the line before the values, or to the end of a header whose values are in
/// another file.
MetaHeader parse_meta_header(std::string_view bytes) {
  constexpr std::size_t kMaxHeader = 1 << 20;  // [bytes]
  const std::string_view text = bytes.substr(0, kMaxHeader);
  MetaHeader header;
  while (header.end < text.size()) {
    const std::size_t end = std::min(text.find('\n', header.end), text.size());
    if (end == text.size() && text.size() < bytes.size()) break;
    const std::string_view line = trimmed(text.substr(header.end, end - header.end));
    header.end = std::min(end + 1, text.size());
    if (line.empty()) continue;
    const bool plain =
        std::all_of(line.begin(), line.end(), [](unsigned char k) { return k == '\t' || (k >= 32 && k != 127); });
    const std::size_t equals = line.find_first_of("=:");
    if (!plain || equals == std::string_view::npos || equals == 0)
      throw Error("it is not a MetaImage file, or its header is damaged at " + in_quotes(line) + ".");
    const std::string name(trimmed(line.substr(0, equals)));
    const std::string& value = header.fields[name] = trimmed(line.substr(equals + 1));
    // A list is followed by file names; it is refused later.
    if (name == "ElementDataFile" && (is_local(value) || is_several_files(value))) return header;
  }
  if (text.size() < bytes.size()) throw Error("its header is longer than " + std::to_string(kMaxHeader) + " bytes.");
  if (!header.fields.contains("ElementDataFile"))
    throw Error("it is not a MetaImage file, or its header is truncated: it has no ElementDataFile.");
  return header;
}

ValueType type_of_meta(const std::string& name) {
  using enum ValueType;
  static constexpr std::pair<std::string_view, ValueType> kTypes[] = {
      {"MET_UCHAR", uint8},     {"MET_CHAR", int8},     {"MET_USHORT", uint16}, {"MET_SHORT", int16},
      {"MET_UINT", uint32},     {"MET_INT", int32},     {"MET_FLOAT", float32}, {"MET_ULONG_LONG", uint64},
      {"MET_LONG_LONG", int64}, {"MET_DOUBLE", float64}};
  if (const ValueType* type = found_in(kTypes, name)) return *type;
  throw Error("its values are of type " + in_quotes(name) +
              ", which is not supported; save them as MET_SHORT, MET_INT or MET_FLOAT.");
}

/// The numbers of a field with several possible names; `otherwise` when it is absent.
std::vector<double> numbers(const MetaHeader& header, const std::vector<std::string>& names,
                            std::vector<double> otherwise) {
  for (const std::string& name : names) {
    const auto found = header.fields.find(name);
    if (found == header.fields.end()) continue;
    const std::optional<std::vector<double>> given = numbers_in(found->second, " \t");
    if (!given || given->size() != otherwise.size())
      throw Error("its field '" + name + "' is " + in_quotes(found->second) + "; it must be " +
                  std::to_string(otherwise.size()) + " numbers.");
    return *given;
  }
  return otherwise;
}

/// Each row of the file's matrix is the direction of one axis. Axes after the third have one sample.
FileGeometry geometry_in(const MetaHeader& header, std::size_t dimensions) {
  const auto dims = numbers(header, {"DimSize"}, std::vector<double>(dimensions, 0));
  require_sane_dims({dims[0], dims[1], dims[2]});
  for (std::size_t axis = 3; axis < dimensions; ++axis) require_one_volume(dims[axis]);
  constexpr std::pair<std::string_view, double> kUnits[] = {{"mm", 1}, {"um", 1e-3}, {"cm", 10}, {"m", 1000}};  // [mm]
  const std::string unit = header.get("DistanceUnits", "mm");
  const double* const unit_mm = found_in(kUnits, unit);
  if (unit_mm == nullptr)
    throw Error("its field 'DistanceUnits' is " + in_quotes(unit) + "; it must be mm, um, cm or m.");
  const std::vector<double> zeros(dimensions, 0);
  const auto spacing = numbers(header, {"ElementSpacing", "ElementSize"}, zeros);
  const auto origin = numbers(header, {"Offset", "Position", "Origin"}, zeros);
  std::vector<double> identity(dimensions * dimensions, 0);
  for (std::size_t axis = 0; axis < dimensions; ++axis) identity[(dimensions + 1) * axis] = 1;
  const auto matrix = numbers(header, {"TransformMatrix", "Orientation", "Rotation"}, identity);
  FileGeometry geometry;
  for (unsigned axis = 0; axis < 3; ++axis) {
    geometry.dims[axis] = int(dims[axis]);
    geometry.spacing_mm[axis] = spacing[axis];
    geometry.origin_mm[axis] = origin[axis];
    for (unsigned row = 0; row < 3; ++row) geometry.direction(row, axis) = matrix[dimensions * axis + row];
  }
  geometry.scale(*unit_mm);
  return geometry;
}

/// [bytes] Offset of the values in a separate file; -1: the values are at its end.
std::int64_t header_size(const MetaHeader& header, bool local) {
  const std::string text = header.get("HeaderSize", "0");
  const std::optional<std::int64_t> skip = parse_whole(text);
  if (!skip || *skip < -1 || (local && *skip > 0))
    throw Error("its field 'HeaderSize' is " + in_quotes(text) + "; it must be a number of bytes, or -1" +
                (local ? ", and 0 where the values follow in the same file." : "."));
  if (*skip != 0 && header.is_true("CompressedData"))
    throw Error("its field 'HeaderSize' is " + in_quotes(text) + "; with compressed data it must be 0.");
  return *skip;
}

void read_values(const MetaHeader& header, std::string_view bytes, const DataFile& data_file, RawImage& image) {
  const std::string name = header.get("ElementDataFile", "");
  const bool local = is_local(name);
  const std::string elsewhere = local ? std::string() : data_file(name);
  const std::string_view data = local ? bytes.substr(header.end) : std::string_view(elsewhere);
  const std::int64_t skip = header_size(header, local);
  const std::uint64_t count = image.needed();
  const bool compressed = header.is_true("CompressedData");
  require_bytes(double(count), double(data.size()) - double(std::max<std::int64_t>(skip, 0)),
                compressed ? kDeflate : kNotCompressed);
  if (!compressed && skip != -1)
    require_no_more(std::uint64_t(skip) + count, data, count / std::uint64_t(image.geometry.dims[2]), local);
  if (compressed)
    image.bytes = unpack_gzip(data, count);
  else
    image.bytes = data.substr(skip == -1 ? data.size() - count : std::size_t(skip), count);
  if (image.bytes.size() != count) throw Error("its compressed data are damaged or truncated. Get a complete copy.");
  if (header.is_true("BinaryDataByteOrderMSB") || header.is_true("ElementByteOrderMSB")) swap_bytes(image);
}

}  // namespace

RawImage parse_meta_image(std::string_view bytes, const DataFile& data_file) {
  const MetaHeader header = parse_meta_header(bytes);
  const std::int64_t dimensions = parse_whole(header.get("NDims", "0")).value_or(0);
  require_dimensions(double(dimensions), 10);
  const std::string channels = header.get("ElementNumberOfChannels", "1");
  if (channels != "1") throw Error("it has " + in_quotes(channels) + " values per sample; a volume has one.");
  if (numbers(header, {"ElementToIntensityFunctionSlope"}, {1}) != std::vector<double>{1} ||
      numbers(header, {"ElementToIntensityFunctionOffset"}, {0}) != std::vector<double>{0})
    throw Error("its values have a scale (ElementToIntensityFunctionSlope); save the scaled values.");
  const ValueType type = type_of_meta(header.get("ElementType", "none"));
  const std::string data = header.get("ElementDataFile", "");
  if (data.empty()) throw Error("its field 'ElementDataFile' is empty; it must be LOCAL or the name of a file.");
  if (is_several_files(data)) throw Error("its data are in several files; save them as one.");
  if (header.fields.count("BinaryData") != 0 && !header.is_true("BinaryData"))
    throw Error("its data are text; save them as binary data.");

  RawImage image;
  image.geometry = geometry_in(header, std::size_t(dimensions));
  image.type = type;
  read_values(header, bytes, data_file, image);
  return image;
}

}  // namespace hapticut
