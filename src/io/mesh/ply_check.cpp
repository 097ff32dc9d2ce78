// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/ply_check.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>
#include <vector>

namespace hapticut {
namespace {

/// [bytes]; 0: no such type.
std::size_t size_of(const std::string& type) {
  static const std::map<std::string, std::size_t> kSizes = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = kSizes.find(type);
  return found == kSizes.end() ? 0 : found->second;
}

struct Property {
  std::size_t count_size;  // [bytes] of the length of a list; 0 for a single value
  std::size_t value_size;  // [bytes]
};

struct Element {
  std::uint64_t count;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::string damage;
};

void parse_line(const std::string& line, Header& header) {
  std::istringstream words(line);
  std::string key, first, second, third;
  words >> key >> first;
  if (key == "comment" || key == "obj_info" || key.empty() || key == "ply") return;
  if (key == "format") {
    header.format = first;
  } else if (key == "element") {
    Element element{};
    if (!(words >> second) || second.size() > 10 || second.find_first_not_of("0123456789") != std::string::npos) {
      header.damage = "the number of its elements '" + first + "' is not a number";
      return;
    }
    element.count = std::stoull(second);
    header.elements.push_back(element);
  } else if (key == "property" && !header.elements.empty()) {
    const bool list = first == "list";
    if (list) words >> second >> third;
    const Property property{list ? size_of(second) : 0, size_of(list ? third : first)};
    if (property.value_size == 0 || (list && property.count_size == 0))
      header.damage = "its header has the unknown property '" + line + "'";
    header.elements.back().properties.push_back(property);
  } else {
    header.damage = "its header has the unknown line '" + line.substr(0, 60) + "'";
  }
}

/// Goes through the elements of a binary file.  @return whether all of them are there
bool walk(const std::string& bytes, std::size_t at, const Header& header) {
  const bool big = header.format == "binary_big_endian";
  for (const Element& element : header.elements)
    for (std::uint64_t n = 0; n < element.count && !element.properties.empty(); ++n)
      for (const Property& property : element.properties) {
        std::uint64_t length = 1;
        if (property.count_size > 0) {
          if (at + property.count_size > bytes.size()) return false;
          length = 0;
          for (std::size_t k = 0; k < property.count_size; ++k) {
            const std::size_t from = big ? k : property.count_size - 1 - k;
            length = length << 8 | static_cast<unsigned char>(bytes[at + from]);
          }
          at += property.count_size;
        }
        if (length > bytes.size()) return false;
        at += std::size_t(length) * property.value_size;
        if (at > bytes.size()) return false;
      }
  return true;
}

}  // namespace

std::string find_ply_damage(const std::string& bytes) {
  if (bytes.compare(0, 3, "ply") != 0) return "it does not begin like a PLY file";
  Header header;
  std::size_t at = 0;
  bool ended = false;
  while (!ended && at < bytes.size()) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) break;
    std::string line = bytes.substr(at, end - at);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    at = end + 1;
    ended = line == "end_header";
    if (!ended) parse_line(line, header);
    if (!header.damage.empty()) return header.damage;
  }
  if (!ended) return "its header does not end; it was cut off";
  if (header.format == "ascii") {
    std::uint64_t lines = 0;
    for (const Element& element : header.elements) lines += element.count;
    std::uint64_t present = std::uint64_t(std::count(bytes.begin() + std::ptrdiff_t(at), bytes.end(), '\n'));
    if (at < bytes.size() && bytes.back() != '\n') ++present;
    return present < lines ? "it has fewer lines than its header announces; it was cut off" : "";
  }
  if (header.format != "binary_little_endian" && header.format != "binary_big_endian")
    return "its format '" + header.format + "' is unknown";
  return walk(bytes, at, header) ? "" : "it has less data than its header announces; it was cut off";
}

}  // namespace hapticut
