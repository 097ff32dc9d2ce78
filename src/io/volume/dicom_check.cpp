// SPDX-License-Identifier: Apache-2.0
#include "io/volume/dicom_check.hpp"

#include <gdcmDicts.h>
#include <gdcmGlobal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>

#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kPreamble = 128;
constexpr std::uint32_t kUndefined = 0xffffffff;  // length of what ends with a delimiter
constexpr int kDeepest = 16;                      // sequences within sequences

constexpr std::uint32_t tag(std::uint16_t group, std::uint16_t element) {
  return std::uint32_t(group) << 16U | element;
}
constexpr std::uint32_t kItem = tag(0xfffe, 0xe000), kItemEnd = tag(0xfffe, 0xe00d), kSequenceEnd = tag(0xfffe, 0xe0dd);
constexpr std::uint32_t kTransferSyntax = tag(2, 0x10), kPixelData = tag(0x7fe0, 0x10);

/// What tells GDCM how many values there are and how they are stored: one 16-bit number each.
struct NumberElement {
  std::uint32_t tag;
  int low, high;  // what it may be
};
constexpr NumberElement kNumbers[] = {
    {tag(0x28, 2), 1, 1},         // samples per pixel: a volume has one
    {tag(0x28, 6), 0, 1},         // planar configuration
    {tag(0x28, 0x10), 1, 65535},  // rows
    {tag(0x28, 0x11), 1, 65535},  // columns
    {tag(0x28, 0x100), 8, 32},    // bits allocated
    {tag(0x28, 0x101), 1, 32},    // bits stored
    {tag(0x28, 0x102), 0, 31},    // high bit
    {tag(0x28, 0x103), 0, 1},     // pixel representation
};

/// Where the values lie and what they mean: decimal numbers as text, so many of them. GDCM goes on with whatever lies
/// in its memory where it cannot read them.
struct TextElement {
  std::uint32_t tag;
  int count;
};
constexpr TextElement kTexts[] = {
    {tag(0x18, 0x50), 1},    // slice thickness
    {tag(0x18, 0x88), 1},    // spacing between slices
    {tag(0x20, 0x32), 3},    // position
    {tag(0x20, 0x37), 6},    // orientation
    {tag(0x28, 0x30), 2},    // pixel spacing
    {tag(0x28, 0x1052), 1},  // rescale intercept
    {tag(0x28, 0x1053), 1},  // rescale slope
};

/// Whether a text is `count` numbers between backslashes.
bool is_numbers(std::string_view text, int count) {
  std::istringstream parts{std::string(text)};
  int found = 0;
  for (std::string part; std::getline(parts, part, '\\'); ++found) {
    std::istringstream words(part.substr(0, part.find_last_not_of(std::string_view(" \0", 2)) + 1));
    words.imbue(std::locale::classic());
    double number = 0;
    if (!(words >> number) || !std::isfinite(number) || words.peek() != std::istringstream::traits_type::eof())
      return false;
  }
  return found == count;
}

class Walker {
 public:
  explicit Walker(std::string_view bytes) : bytes_(bytes), at_(kPreamble + 4) {}

  void walk_file() {
    std::string syntax;
    while (at_ + 8 <= bytes_.size() && bytes_[at_] == 2 && bytes_[at_ + 1] == 0) {
      const Element e = take_element();
      const std::string_view value = take(e.length);
      if (e.tag == kTransferSyntax) syntax = value.substr(0, value.find_last_not_of('\0') + 1);
    }
    if (!syntax.starts_with("1.2.840.10008.1.2")) fail("it does not say how its values are stored");
    if (syntax == "1.2.840.10008.1.2.1.99") fail("its elements are compressed; save it without that");
    explicit_ = syntax != "1.2.840.10008.1.2";
    big_endian_ = syntax == "1.2.840.10008.1.2.2";
    walk_elements(bytes_.size(), false, 0);
    if (!has_pixels_) fail("it holds no picture");
  }

 private:
  struct Element {
    std::uint32_t tag;
    std::string_view kind;  // two letters; empty where the file does not say
    std::uint32_t length;
  };

  [[noreturn]] static void fail(const std::string& reason) { throw Error(reason); }

  std::string_view take(std::size_t count) {
    if (count > bytes_.size() - at_) fail("it is damaged or cut short");
    const std::string_view part = bytes_.substr(at_, count);
    at_ += count;
    return part;
  }

  template <class Number>
  Number take_number() {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), take(sizeof(Number)).data(), sizeof(Number));
    if (big_endian_) std::reverse(raw.begin(), raw.end());
    Number number;
    std::memcpy(&number, raw.data(), sizeof(Number));
    return number;
  }

  std::uint32_t take_tag() {
    const auto group = take_number<std::uint16_t>();
    return tag(group, take_number<std::uint16_t>());
  }

  Element take_element() {
    constexpr std::string_view kShort = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
    constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    Element e = {take_tag(), {}, 0};
    if (!explicit_ || e.tag >> 16U == 0xfffe) {
      e.length = take_number<std::uint32_t>();
      return e;
    }
    e.kind = take(2);
    const bool letters = std::all_of(e.kind.begin(), e.kind.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    if (letters && kLong.find(e.kind) != std::string_view::npos) {
      take(2);
      e.length = take_number<std::uint32_t>();
    } else if (letters && kShort.find(e.kind) != std::string_view::npos) {
      e.length = take_number<std::uint16_t>();
    } else {
      fail("an element of it is of an unknown kind");
    }
    return e;
  }

  /// @param delimited  ends at a delimiter rather than at `end`
  void walk_elements(std::size_t end, bool delimited, int depth) {
    if (depth > kDeepest) fail("its sequences are nested too deeply");
    std::uint32_t before = 0;
    while (at_ < end) {
      const Element e = take_element();
      if (delimited && e.tag == kItemEnd) return;
      if (e.tag <= before) fail("its elements are not in order");
      before = e.tag;
      check_kind(e);
      has_pixels_ |= depth == 0 && e.tag == kPixelData;
      const bool sequence = e.kind == "SQ" || (e.length == kUndefined && (e.kind.empty() || e.kind == "UN"));
      if (e.tag == kPixelData && e.length == kUndefined)
        walk_fragments();
      else if (sequence)
        walk_items(e.length, depth);
      else
        check_value(e, take(e.length));
    }
    if (delimited || at_ != end) fail("it is damaged or cut short");
  }

  void walk_items(std::uint32_t length, int depth) {
    const bool delimited = length == kUndefined;
    if (!delimited && length > bytes_.size() - at_) fail("it is damaged or cut short");
    const std::size_t end = delimited ? bytes_.size() : at_ + length;
    while (at_ < end) {
      const std::uint32_t at = take_tag();
      const auto item_length = take_number<std::uint32_t>();
      if (delimited && at == kSequenceEnd) return;
      if (at != kItem) fail("a sequence of it is damaged");
      if (item_length != kUndefined && item_length > end - at_) fail("it is damaged or cut short");
      walk_elements(item_length == kUndefined ? end : at_ + item_length, item_length == kUndefined, depth + 1);
    }
    if (delimited) fail("it is damaged or cut short");
  }

  /// Compressed values.
  void walk_fragments() {
    for (;;) {
      const std::uint32_t at = take_tag();
      const auto length = take_number<std::uint32_t>();
      if (at == kSequenceEnd) return;
      if (at != kItem) fail("its compressed values are damaged");
      take(length);
    }
  }

  /// A known element must be of its kind: text where text is expected.
  static void check_kind(const Element& e) {
    const bool is_private = (e.tag >> 16U) % 2 != 0;
    if (e.kind.empty() || is_private) return;
    const gdcm::DictEntry& known = gdcm::Global::GetInstance().GetDicts().GetDictEntry(gdcm::Tag(e.tag));
    const gdcm::VR kind = gdcm::VR::GetVRTypeFromFile(std::string(e.kind).c_str());
    if (known.GetVR() != gdcm::VR::INVALID && !known.GetVR().Compatible(kind))
      fail("an element of it is of another kind than it must be");
  }

  void check_value(const Element& e, std::string_view value) const {
    for (const TextElement& expected : kTexts)
      if (e.tag == expected.tag && value.find_first_not_of(std::string_view(" \0", 2)) != std::string_view::npos &&
          !is_numbers(value, expected.count))
        fail("its place, spacing or scale is not in numbers");
    for (const NumberElement& expected : kNumbers) {
      if (e.tag != expected.tag) continue;
      if (value.size() != 2 || (!e.kind.empty() && e.kind != "US")) fail("its size or depth is not a number");
      const int low = static_cast<unsigned char>(value[0]), high = static_cast<unsigned char>(value[1]);
      const int number = big_endian_ ? 256 * low + high : 256 * high + low;
      if (number < expected.low || number > expected.high)
        fail("its size, depth or number of channels is not one of a volume");
    }
  }

  std::string_view bytes_;
  std::size_t at_;
  bool explicit_ = true, big_endian_ = false;
  bool has_pixels_ = false;
};

}  // namespace

bool looks_like_dicom(const std::filesystem::path& path) {
  const std::string start = first_bytes(path, kPreamble + 4);
  return start.size() == kPreamble + 4 && start.ends_with("DICM");
}

void require_sound_dicom(const std::filesystem::path& path) {
  const std::string bytes = first_bytes(path, std::size_t(readable_size(path)));
  if (bytes.size() < kPreamble + 4 || bytes.compare(kPreamble, 4, "DICM") != 0)
    cannot_read(path, "it is not a DICOM file.");
  try {
    Walker(bytes).walk_file();
  } catch (const Error& error) {
    cannot_read(path, std::string(error.what()) + ".");
  }
}

}  // namespace hapticut
