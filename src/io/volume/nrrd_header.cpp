// SPDX-License-Identifier: Apache-2.0
#include "io/volume/nrrd_header.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>

#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kMaxHeaderBytes = std::size_t(1) << 20U;

std::string trimmed(std::string text) {
  text.erase(0, std::min(text.find_first_not_of(" \t\r"), text.size()));
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text;
}

std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> kBytes = {{"signed char", 1},
                                                            {"int8", 1},
                                                            {"int8_t", 1},
                                                            {"uchar", 1},
                                                            {"unsigned char", 1},
                                                            {"uint8", 1},
                                                            {"uint8_t", 1},
                                                            {"short", 2},
                                                            {"short int", 2},
                                                            {"signed short", 2},
                                                            {"signed short int", 2},
                                                            {"int16", 2},
                                                            {"int16_t", 2},
                                                            {"ushort", 2},
                                                            {"unsigned short", 2},
                                                            {"unsigned short int", 2},
                                                            {"uint16", 2},
                                                            {"uint16_t", 2},
                                                            {"int", 4},
                                                            {"signed int", 4},
                                                            {"int32", 4},
                                                            {"int32_t", 4},
                                                            {"uint", 4},
                                                            {"unsigned int", 4},
                                                            {"uint32", 4},
                                                            {"uint32_t", 4},
                                                            {"longlong", 8},
                                                            {"long long", 8},
                                                            {"long long int", 8},
                                                            {"signed long long", 8},
                                                            {"signed long long int", 8},
                                                            {"int64", 8},
                                                            {"int64_t", 8},
                                                            {"ulonglong", 8},
                                                            {"unsigned long long", 8},
                                                            {"unsigned long long int", 8},
                                                            {"uint64", 8},
                                                            {"uint64_t", 8},
                                                            {"float", 4},
                                                            {"double", 8}};
  const auto found = kBytes.find(type);
  return found == kBytes.end() ? 0 : found->second;
}

std::string encoding_of(const std::string& name) {
  if (name == "gz") return "gzip";
  if (name == "bz2") return "bzip2";
  if (name == "txt" || name == "text") return "ascii";
  return name;
}

/// The unit that every axis has, e.g. `"mm" "mm" "mm"`; what is empty or unknown counts as millimetres.
std::optional<double> unit_of(const std::string& list) {
  static const std::map<std::string, double> kUnits = {{"m", 1e3},   {"meter", 1e3}, {"cm", 10},       {"mm", 1},
                                                       {"um", 1e-3}, {"µm", 1e-3},   {"micron", 1e-3}, {"nm", 1e-6}};
  std::optional<double> unit;
  std::size_t from = list.find('"');
  while (from != std::string::npos) {
    const std::size_t to = list.find('"', from + 1);
    if (to == std::string::npos) break;
    const auto known = kUnits.find(list.substr(from + 1, to - from - 1));
    const double this_one = known == kUnits.end() ? 1 : known->second;
    if (unit && *unit != this_one) return std::nullopt;
    unit = this_one;
    from = list.find('"', to + 1);
  }
  return unit.value_or(1);
}

std::int64_t integer(const std::filesystem::path& path, const std::string& field, const std::string& value) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc{} || end != value.data() + value.size())
    cannot_read(path, "its field '" + field + "' is '" + value + "', which is not a whole number.");
  return number;
}

void take_field(const std::filesystem::path& path, const std::string& name, const std::string& value,
                NrrdHeader& header, bool& kept) {
  kept = false;
  if (name == "byte skip" || name == "byteskip") {
    header.byte_skip = integer(path, name, value);
  } else if (name == "line skip" || name == "lineskip") {
    header.line_skip = integer(path, name, value);
  } else if (name == "encoding") {
    header.encoding = value;
    std::transform(value.begin(), value.end(), header.encoding.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    header.encoding = encoding_of(header.encoding);
  } else if (name == "data file" || name == "datafile") {
    const bool several = value.rfind("LIST", 0) == 0 || value.find('%') != std::string::npos;
    header.data_file = several ? std::filesystem::path() : path.parent_path() / value;
  } else {
    kept = true;
    if (name == "type") header.bytes_per_value = bytes_of(value);
    if (name == "sizes") {
      std::istringstream sizes(value);
      for (double size = 0; sizes >> size;) header.sizes.push_back(size);
    }
    if (name == "space units" || name == "units") {
      const auto unit = unit_of(value);
      if (!unit) cannot_read(path, "its axes have different units: " + value + ".");
      header.unit_mm = *unit;
    }
  }
}

}  // namespace

NrrdHeader parse_nrrd_header(const std::filesystem::path& path) {
  const std::string text = first_bytes(path, kMaxHeaderBytes);
  if (text.rfind("NRRD000", 0) != 0) cannot_read(path, "it is not an NRRD file.");
  NrrdHeader header;
  header.data_file = path;
  bool attached = true, ended = false;
  std::size_t from = 0;
  while (!ended && from < text.size()) {
    std::size_t to = text.find('\n', from);
    if (to == std::string::npos) to = text.size();
    const std::string line = trimmed(text.substr(from, to - from));
    from = std::min(to + 1, text.size());
    ended = line.empty();
    const std::size_t colon = line.find(": ");
    const bool field = line[0] != '#' && colon != std::string::npos && line.find(":=") > colon;
    bool kept = true;
    if (field) {
      const std::string name = line.substr(0, colon);
      attached &= name != "data file" && name != "datafile";
      take_field(path, name, trimmed(line.substr(colon + 2)), header, kept);
    }
    if (kept && !ended) header.fields += line + "\n";
  }
  if (attached && !ended) cannot_read(path, "its NRRD header has no end.");
  if (header.sizes.empty()) cannot_read(path, "its NRRD header has no field 'sizes'.");
  if (attached) header.data_offset = from;
  return header;
}

}  // namespace hapticut
