// SPDX-License-Identifier: Apache-2.0
#include "import/volume/nrrd_header.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <ranges>
#include <sstream>

#include "hapticut/core/errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kMaxNrrdHeader = 1 << 20;
constexpr std::size_t kMaxNrrdLine = 1 << 14;  // [bytes] size of a line; a list of data files has one line for each
constexpr std::size_t kMaxNrrdFiles = 1 << 16;

std::optional<ValueType> type_of_nrrd(std::string_view name) {
  static const std::pair<ValueType, std::vector<std::string_view>> kNames[] = {
      {ValueType::int8, {"signed char", "int8", "int8_t"}},
      {ValueType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {ValueType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {ValueType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {ValueType::int32, {"int", "signed int", "int32", "int32_t"}},
      {ValueType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {ValueType::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
      {ValueType::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {ValueType::float32, {"float"}},
      {ValueType::float64, {"double"}}};
  for (const auto& [type, names] : kNames)
    if (std::ranges::find(names, name) != names.end()) return type;
  return std::nullopt;
}

/// The three spatial axes of a file.
using NrrdAxes = std::array<std::size_t, 3>;

struct NrrdUnit {
  double mm = 1;
  std::string unknown = {};  ///< name of an unknown unit
  bool operator==(const NrrdUnit&) const = default;
};

/// A unit by its common names; an empty name means millimetre.
NrrdUnit unit_named(std::string_view text) {
  // Greek mu has two code points in Unicode and one in Latin-1.
  static constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1},      {"m", 1e3},           {"meter", 1e3},      {"metre", 1e3},       {"cm", 10},
      {"mm", 1},    {"centimeter", 10},   {"centimetre", 10},  {"millimeter", 1},    {"millimetre", 1},
      {"um", 1e-3}, {"micrometer", 1e-3}, {"micron", 1e-3},    {"micrometre", 1e-3}, {"\xc2\xb5m", 1e-3},
      {"nm", 1e-6}, {"nanometer", 1e-6},  {"nanometre", 1e-6}, {"\xce\xbcm", 1e-3},  {"\xb5m", 1e-3}};
  std::string name = lower_case(trimmed(text));
  if (name.size() > 2 && name.ends_with('s')) name.pop_back();
  const double* const mm = found_in(kUnits, name);
  return mm == nullptr ? NrrdUnit{1, std::string(text)} : NrrdUnit{*mm};
}

/// The unit of the spatial axes, e.g. `"mm" "mm" "mm"`.
NrrdUnit unit_of_nrrd(std::string_view list, const NrrdAxes& axes) {
  std::optional<NrrdUnit> unit;
  std::size_t from = 0;
  for (std::size_t axis = 0; (from = list.find_first_not_of(" \t", from)) != std::string_view::npos; ++axis) {
    const bool quoted = list[from] == '"';
    if (quoted) ++from;
    const std::size_t to = std::min(list.find_first_of(quoted ? "\"" : " \t", from), list.size());
    const NrrdUnit this_one = unit_named(list.substr(from, to - from));
    const bool counts = std::find(axes.begin(), axes.end(), axis) != axes.end();
    if (counts && unit && *unit != this_one)
      throw Error("its axes have different units: " + in_quotes(list) + "; save all in mm.");
    if (counts) unit = this_one;
    from = to + 1;
  }
  return unit.value_or(NrrdUnit{});
}

/// Whether the fourth axis of a `space` is time: `left-posterior-superior-time`, `LPST`.
bool has_time(std::string_view space) { return space.ends_with("-time") || (space.size() == 4 && space[3] == 't'); }

/// The axes of `space` in patient axes: x to the left, y to the back, z to the head. A time axis is ignored.
Vec3 signs_of_space(std::string name) {
  if (has_time(name)) name.resize(name.size() == 4 ? 3 : name.find("-time"));
  static const std::pair<std::string_view, Vec3> kSigns[] = {
      {"right-anterior-superior", Vec3(-1, -1, 1)}, {"ras", Vec3(-1, -1, 1)},
      {"left-anterior-superior", Vec3(1, -1, 1)},   {"las", Vec3(1, -1, 1)},
      {"left-posterior-superior", Vec3(1, 1, 1)},   {"lps", Vec3(1, 1, 1)}};
  if (const Vec3* signs = found_in(kSigns, name)) return *signs;
  throw Error("its field 'space' is " + in_quotes(name) +
              ", which does not define left, back and head of the patient; write the matching one of "
              "left-posterior-superior, right-anterior-superior or left-anterior-superior into its header.");
}

/// The fields of a header.
class NrrdFields {
 public:
  explicit NrrdFields(std::string_view bytes) : bytes_(bytes.substr(0, kMaxNrrdHeader)) {
    if (!bytes.starts_with("NRRD000")) throw Error("it is not an NRRD file.");
    bool ended = false;
    while (!ended && at_ < bytes_.size()) {
      const std::string_view line = next_line();
      ended = line.empty();
      add_field(line);
      if (!ended && fields_.contains("data file") && is_list()) {
        read_list();
        ended = true;
      }
    }
    if (!ended && !fields_.contains("data file")) throw Error("its NRRD header has no end.");
  }

  [[nodiscard]] bool has(const char* name) const { return fields_.contains(name); }

  [[nodiscard]] std::string_view get(const char* name) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) throw Error(std::string("its NRRD header has no field '") + name + "'.");
    return found->second;
  }

  [[noreturn]] void fail(const char* name, const std::string& must_be) const {
    throw Error(std::string("its field '") + name + "' is " + in_quotes(get(name)) + "; it must be " + must_be + ".");
  }

  [[nodiscard]] std::int64_t whole(const char* name, std::int64_t otherwise) const {
    if (!has(name)) return otherwise;
    const std::optional<std::int64_t> number = parse_whole(get(name));
    if (!number) fail(name, "a whole number");
    return *number;
  }

  /// Numbers separated by blanks.
  [[nodiscard]] std::vector<double> numbers(const char* name, std::size_t count) const {
    const std::optional<std::vector<double>> numbers = numbers_in(get(name), " \t");
    if (!numbers || numbers->size() != count) fail(name, std::to_string(count) + " numbers");
    return *numbers;
  }

  /// Vectors of three numbers, or of four if the space has time: `(1,0,0) (0,1,0) (0,0,1)`. `none` stands for an axis
  /// without a vector and becomes NaN.
  [[nodiscard]] std::vector<Vec3> vectors(const char* name, std::size_t count) const {
    std::vector<Vec3> found;
    std::string_view text = get(name);
    const bool with_time = has("space") ? has_time(lower_case(get("space"))) : whole("space dimension", 3) == 4;
    const std::string must_be = count == 1 ? "a vector (x,y,z)" : std::to_string(count) + " vectors (x,y,z)";
    while (!text.empty()) {
      const bool none = text.starts_with("none");
      const std::size_t close = none ? 3 : text.find(')');
      if ((!none && text.front() != '(') || close == std::string_view::npos || found.size() == count)
        fail(name, must_be);
      const auto numbers = none ? std::vector<double>(4, std::nan("")) : numbers_in(text.substr(1, close - 1), " \t,");
      if (!numbers || (!none && numbers->size() != (with_time ? 4 : 3))) fail(name, must_be);
      found.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
      text = trimmed(text.substr(close + 1));
    }
    if (found.size() != count) fail(name, must_be);
    return found;
  }

  [[nodiscard]] const std::vector<std::string>& list() const { return list_; }
  /// `LIST`, or `LIST 2` with the dimension of each file.
  [[nodiscard]] bool is_list() const {
    const std::string_view name = get("data file");
    return name == "LIST" || (name.starts_with("LIST ") && parse_whole(trimmed(name.substr(5))).has_value());
  }
  [[nodiscard]] std::size_t end() const { return at_; }

 private:
  std::string_view next_line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    if (end - at_ > kMaxNrrdLine)
      throw Error("a line of its NRRD header is longer than " + std::to_string(kMaxNrrdLine) + " bytes.");
    const std::string_view line = trimmed(bytes_.substr(at_, end - at_));
    at_ = std::min(end + 1, bytes_.size());
    return line;
  }

  void add_field(std::string_view line) {
    if (line.starts_with('#')) return;
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos || line.find(":=") < colon) return;
    static constexpr std::pair<std::string_view, const char*> kOtherNames[] = {{"datafile", "data file"},
                                                                               {"lineskip", "line skip"},
                                                                               {"byteskip", "byte skip"},
                                                                               {"axismins", "axis mins"},
                                                                               {"centers", "centerings"}};
    std::string name = lower_case(line.substr(0, colon));
    if (const char* const* other = found_in(kOtherNames, name)) name = *other;
    if (!fields_.emplace(name, trimmed(line.substr(colon + 2))).second)
      throw Error("its field " + in_quotes(name) + " appears twice.");
  }

  void read_list() {
    while (at_ < bytes_.size() && list_.size() < kMaxNrrdFiles)
      if (const std::string_view line = next_line(); !line.empty()) list_.emplace_back(line);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::map<std::string, std::string_view, std::less<>> fields_;
  std::vector<std::string> list_;
};

/// Whether numbers follow a name with a percent sign. Else the sign is a part of the name.
bool is_numbered(std::string_view data_file) {
  const std::size_t percent = data_file.find('%');
  const std::size_t blank = data_file.find_first_of(" \t", percent);
  return percent != std::string_view::npos && blank != std::string_view::npos &&
         numbers_in(data_file.substr(blank), " \t").has_value();
}

/// `slice%03d.raw 1 30 1`: name, first number, last number, step.
std::vector<std::string> numbered_files(const NrrdFields& fields) {
  constexpr const char* kMustBe = "a name with one %d, its first number, the last one and the step";
  const std::string_view value = fields.get("data file");
  const std::size_t blank = value.find_first_of(" \t", value.find('%'));
  const std::string_view name = value.substr(0, blank);
  const auto numbers = blank == std::string_view::npos ? std::nullopt : numbers_in(value.substr(blank), " \t");
  const std::size_t percent = name.find('%'), d = name.find('d', percent);
  if (!numbers || numbers->size() < 3 || d == std::string_view::npos || name.find('%', percent + 1) < d)
    fields.fail("data file", kMustBe);
  const std::string_view width = name.substr(percent + 1, d - percent - 1);
  const std::optional<std::int64_t> digits = width.empty() ? 0 : parse_whole(width);
  const double first = (*numbers)[0], last = (*numbers)[1], step = (*numbers)[2];
  if (!digits || *digits < 0 || *digits > 9 || !(std::abs(step) >= 1) ||
      !((last - first) / step >= 0 && (last - first) / step < double(kMaxNrrdFiles)) || !(std::abs(first) < 1e9))
    fields.fail("data file", kMustBe);
  std::vector<std::string> files;
  for (int n = 0; n <= int((last - first) / step); ++n) {
    std::string number = std::to_string(std::int64_t(first + n * step));
    if (number.size() < std::size_t(*digits))
      number.insert(0, std::size_t(*digits) - number.size(), width[0] == '0' ? '0' : ' ');
    files.push_back(std::string(name.substr(0, percent)) + number + std::string(name.substr(d + 1)));
  }
  return files;
}

/// The spatial axes: all axes, without those of one sample (time, values), which are removed from the last one.
NrrdAxes axes_of_space(const NrrdFields& fields, std::size_t dimensions) {
  const std::vector<double> sizes = fields.numbers("sizes", dimensions);
  std::vector<Vec3> directions(dimensions, Vec3::Zero());
  if (fields.has("space directions")) directions = fields.vectors("space directions", dimensions);
  std::vector<std::size_t> axes(dimensions);
  std::iota(axes.begin(), axes.end(), 0);
  for (std::size_t n = dimensions; n-- > 0 && axes.size() > 3;)
    if (sizes[n] == 1 && !(directions[n].norm() > 0)) axes.erase(axes.begin() + std::ptrdiff_t(n));
  if (axes.size() != 3)
    throw Error("it has " + std::to_string(dimensions) +
                " dimensions; a volume has three, and further axes may have only one sample. Extract one volume from "
                "it, or combine its slices.");
  if (!fields.has("kinds")) return {axes[0], axes[1], axes[2]};
  std::istringstream kinds{std::string(fields.get("kinds"))};
  std::string kind;
  for (std::size_t n = 0; kinds >> kind; ++n)
    if (std::ranges::find(axes, n) != axes.end() && sizes[n] > 1 && kind != "domain" && kind != "space" &&
        kind != "none" && kind != "???")
      throw Error("its axis " + std::to_string(n + 1) + " is of the kind " + in_quotes(kind) +
                  ", so it is not an axis of a volume: extract one of its " + format_number(sizes[n]) + " parts.");
  return {axes[0], axes[1], axes[2]};
}

FileGeometry geometry_of_nrrd(const NrrdFields& fields, std::size_t dimensions) {
  FileGeometry geometry;
  const NrrdAxes axes = axes_of_space(fields, dimensions);
  const auto three = [&](const char* name) {
    const std::vector<double> numbers = fields.numbers(name, dimensions);
    return Vec3(numbers[axes[0]], numbers[axes[1]], numbers[axes[2]]);
  };
  const Vec3 sizes = three("sizes");
  require_sane_dims({sizes.x(), sizes.y(), sizes.z()});
  for (int axis = 0; axis < 3; ++axis) geometry.dims[std::size_t(axis)] = int(sizes[axis]);
  if (fields.has("space directions")) {
    const Vec3 signs = fields.has("space") ? signs_of_space(lower_case(fields.get("space"))) : Vec3(1, 1, 1);
    const std::vector<Vec3> directions = fields.vectors("space directions", dimensions);
    Mat3 steps;
    for (int axis = 0; axis < 3; ++axis) steps.col(axis) = directions[axes[std::size_t(axis)]].cwiseProduct(signs);
    geometry.set_axes(steps);
    geometry.axes_assumed = !fields.has("space");
    if (fields.has("space origin")) geometry.origin_mm = fields.vectors("space origin", 1)[0].cwiseProduct(signs);
  } else {
    if (fields.has("spacings")) geometry.spacing_mm = three("spacings");
    if (fields.has("axis mins")) {
      geometry.origin_mm = three("axis mins");
      for (int axis = 0; axis < 3; ++axis)
        if (std::isnan(geometry.origin_mm[axis])) geometry.origin_mm[axis] = 0;
      // The minimum of an axis is the edge of its first sample, unless the header says that it is its centre.
      if ((!fields.has("centerings") || fields.get("centerings").find("node") == std::string_view::npos) &&
          is_finite(geometry.spacing_mm))
        geometry.origin_mm += geometry.spacing_mm / 2;
    }
  }
  const bool of_space = fields.has("space units");
  const char* units = of_space ? "space units" : "units";
  const NrrdUnit unit =
      fields.has(units) ? unit_of_nrrd(fields.get(units), of_space ? NrrdAxes{0, 1, 2} : axes) : NrrdUnit{};
  geometry.scale(unit.mm);
  if (geometry.spacing_mm.norm() > 0) geometry.unknown_unit = unit.unknown;
  return geometry;
}

}  // namespace

NrrdHeader parse_nrrd_header(std::string_view bytes) {
  const NrrdFields fields(bytes);
  const std::int64_t dimensions = fields.whole("dimension", 0);
  require_dimensions(double(dimensions), 16);
  NrrdHeader header;
  const std::optional<ValueType> type = type_of_nrrd(lower_case(fields.get("type")));
  if (!type) fields.fail("type", "a type of numbers");
  header.type = *type;
  header.geometry = geometry_of_nrrd(fields, std::size_t(dimensions));
  header.encoding = lower_case(fields.get("encoding"));
  if (header.encoding == "gz") header.encoding = "gzip";
  if (header.encoding == "bz2") header.encoding = "bzip2";
  if (header.encoding == "txt" || header.encoding == "text") header.encoding = "ascii";
  const bool text = header.encoding == "ascii" || header.encoding == "hex";
  if (!text && header.encoding != "raw" && header.encoding != "gzip" && header.encoding != "bzip2")
    fields.fail("encoding", "raw, gzip, bzip2, ascii or hex");
  if (size_of(header.type) > 1 && header.encoding != "ascii") {
    const std::string endian = lower_case(fields.get("endian"));
    if (endian != "little" && endian != "big") fields.fail("endian", "little or big");
    header.big_endian = endian == "big";
  }
  header.byte_skip = fields.whole("byte skip", 0);
  header.line_skip = fields.whole("line skip", 0);
  if (header.line_skip < 0) fields.fail("line skip", "0 or more");
  if (fields.has("data file")) {
    const std::string_view name = fields.get("data file");
    if (fields.is_list())
      header.data_files = fields.list();
    else if (is_numbered(name))
      header.data_files = numbered_files(fields);
    else
      header.data_files = {std::string(name)};
    if (header.data_files.empty() || header.data_files.front().empty())
      fields.fail("data file", "the name of a file, or a list of names");
  }
  header.end = fields.end();
  return header;
}

}  // namespace hapticut
