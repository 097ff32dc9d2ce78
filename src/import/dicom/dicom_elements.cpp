// SPDX-License-Identifier: Apache-2.0
#include "import/dicom/dicom_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "hapticut/core/errors.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kPreamble = 128;
constexpr std::string_view kFirstElement("\2\0\0\0UL\4\0", 8);  // start of files without a preamble
constexpr std::string_view kImplicit = "1.2.840.10008.1.2", kExplicit = "1.2.840.10008.1.2.1";  // transfer syntaxes
constexpr std::uint32_t kUndefined = 0xffffffff;  // length of elements that end with a delimiter
constexpr int kMaxDepth = 16;                     // sequences within sequences
constexpr std::uint32_t kItem = dicom_tag(0xfffe, 0xe000), kItemEnd = dicom_tag(0xfffe, 0xe00d),
                        kSequenceEnd = dicom_tag(0xfffe, 0xe0dd), kMediaClass = dicom_tag(2, 2),
                        kTransferSyntax = dicom_tag(2, 0x10), kFloats = dicom_tag(0x7fe0, 8),
                        kDoubles = dicom_tag(0x7fe0, 9), kPixelData = dicom_tag(0x7fe0, 0x10);

/// Whether an element is kept: identity, kind and position of a picture, and the format of its values.
bool is_kept(std::uint32_t tag) {
  constexpr std::uint32_t kOther[] = {dicom_tag(8, 8), dicom_tag(8, 0x16), dicom_tag(0x18, 0x88),
                                      dicom_tag(0x3004, 0xc)};
  const std::uint32_t group = tag >> 16U;
  return group == 0x20 || group == 0x28 || std::find(std::begin(kOther), std::end(kOther), tag) != std::end(kOther);
}

/// Functional groups (shared and per frame) and their content: position and direction of the plane, spacing, scale of
/// the values, elements that a converter found in single slices; and the table of values.
bool is_kept_sequence(std::uint32_t tag) {
  constexpr std::uint32_t kKept[] = {dicom_tag(0x5200, 0x9229), dicom_tag(0x5200, 0x9230), dicom_tag(0x20, 0x9113),
                                     dicom_tag(0x20, 0x9116),   dicom_tag(0x28, 0x9110),   dicom_tag(0x28, 0x9145),
                                     dicom_tag(0x20, 0x9170),   dicom_tag(0x20, 0x9171),   dicom_tag(0x28, 0x3000)};
  return std::find(std::begin(kKept), std::end(kKept), tag) != std::end(kKept);
}

/// Old files have neither preamble nor meta header. They begin with the length, character set, kind or identity of the
/// picture.
/// @return the transfer syntax, derived from the first element; empty when it is not such a file
std::string_view syntax_without_header(std::string_view bytes) {
  constexpr unsigned char kFirst[] = {0x00, 0x05, 0x08, 0x16, 0x18};
  if (bytes.size() < kPreamble + 4 || !bytes.starts_with(std::string_view("\10\0", 2)) || bytes[3] != 0) return {};
  if (std::find(std::begin(kFirst), std::end(kFirst), static_cast<unsigned char>(bytes[2])) == std::end(kFirst))
    return {};
  const std::string_view kind = bytes.substr(4, 2);
  if (kind == "UL" || kind == "CS" || kind == "UI") return kExplicit;
  return bytes[6] == 0 && bytes[7] == 0 ? kImplicit : std::string_view();  // less than 64 kB
}

class DicomWalker {
 public:
  explicit DicomWalker(std::string_view bytes) : bytes_(bytes), in_(bytes) {
    file_.syntax = syntax_without_header(bytes);
    if (!bytes.starts_with(kFirstElement) && file_.syntax.empty()) in_.skip(kPreamble + 4);
  }

  DicomFile walk_file() {
    while (in_.left() >= 8 && bytes_.substr(in_.position(), 2) == std::string_view("\2\0", 2)) {
      const Element e = read_element();
      const std::string_view value = read(e.length);
      const std::string_view text = value.substr(0, value.find_last_not_of(std::string_view(" \0", 2)) + 1);
      if (e.tag == kTransferSyntax) file_.syntax = text;
      if (e.tag == kMediaClass) file_.media_class = text;
    }
    if (!file_.syntax.starts_with("1.2.840.10008.1.2")) fail("it does not name the format of its values.");
    if (file_.syntax == "1.2.840.10008.1.2.1.99") fail("its elements are compressed; save it without compression.");
    explicit_ = file_.syntax != kImplicit;
    file_.big_endian = big_endian_ = file_.syntax == "1.2.840.10008.1.2.2";
    walk_elements(bytes_.size(), false, 0, &file_.data);
    if (!file_.has_picture) return std::move(file_);
    const bool plain = file_.syntax == kImplicit || file_.syntax == kExplicit || big_endian_;
    if (plain == file_.compressed) fail("its picture is not stored as its transfer syntax says.");
    return std::move(file_);
  }

 private:
  struct Element {
    std::uint32_t tag;
    std::string_view kind;  // two letters; empty when the file does not tell
    std::uint32_t length;
  };

  [[noreturn]] static void fail(const std::string& reason) { throw Error(reason); }
  [[noreturn]] static void fail_cut() { fail("it is damaged or truncated. Get a complete copy."); }

  std::string_view read(std::size_t count) { return in_.read(count); }

  template <class Number>
  Number read_number() {
    return in_.read<Number>(big_endian_);
  }

  std::uint32_t read_tag() {
    const auto group = read_number<std::uint16_t>();
    return dicom_tag(group, read_number<std::uint16_t>());
  }

  Element read_element() {
    constexpr std::string_view kShort = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";
    constexpr std::string_view kLong = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    Element e = {read_tag(), {}, 0};
    if (!explicit_ || e.tag >> 16U == 0xfffe) {
      e.length = read_number<std::uint32_t>();
      return e;
    }
    e.kind = read(2);
    const bool letters = std::all_of(e.kind.begin(), e.kind.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    if (letters && kLong.find(e.kind) != std::string_view::npos) {
      in_.skip(2);
      e.length = read_number<std::uint32_t>();
    } else if (letters && kShort.find(e.kind) != std::string_view::npos) {
      e.length = read_number<std::uint16_t>();
    } else {
      fail(
          "one of its elements has an unknown kind: it is damaged, or not stored in the transfer syntax that it names "
          "(" +
          std::string(file_.syntax) + "). Get another copy.");
    }
    return e;
  }

  /// @param delimited  true: ends at a delimiter instead of at `end`
  /// @param item       receives the elements; may be null
  void walk_elements(std::size_t end, bool delimited, int depth, DicomItem* item) {
    if (depth > kMaxDepth) fail("its sequences are nested too deeply.");
    std::uint32_t before = 0;
    while (in_.position() < end) {
      const Element e = read_element();
      if (delimited && e.tag == kItemEnd) return;
      if (e.tag <= before)
        fail("its elements are not in order: it is damaged, or not stored in the transfer syntax that it names (" +
             std::string(file_.syntax) + "). Get another copy.");
      before = e.tag;
      // If the file does not mark sequences, an undefined length or the tag identifies them.
      const bool unsaid = e.kind.empty() || e.kind == "UN";
      const bool sequence = e.kind == "SQ" || (unsaid && (e.length == kUndefined || is_kept_sequence(e.tag)));
      if (depth == 0 && (e.tag == kFloats || e.tag == kDoubles))
        fail(
            "its values are not whole numbers (Float Pixel Data), which is not supported; save it with whole numbers.");
      if (e.tag == kPixelData && depth == 0) return walk_picture(e);
      if (e.tag == kPixelData && e.length == kUndefined)
        walk_fragments(nullptr);
      else if (sequence)
        walk_items(e, depth, item != nullptr && is_kept_sequence(e.tag) ? &item->sequences[e.tag] : nullptr);
      else if (const std::string_view value = read(e.length); item != nullptr && is_kept(e.tag))
        item->values[e.tag] = value;
    }
    if (delimited || in_.position() != end) fail_cut();
  }

  void walk_items(const Element& e, int depth, std::vector<DicomItem>* items) {
    const bool delimited = e.length == kUndefined, was_explicit = explicit_;
    if (!delimited && e.length > in_.left()) fail_cut();
    if (e.kind == "UN") explicit_ = false;  // the elements of such a sequence have no kind either
    const std::size_t end = delimited ? bytes_.size() : in_.position() + e.length;
    for (bool ended = false; !ended;) {
      if (in_.position() >= end) {
        if (delimited) fail_cut();
        break;
      }
      const std::uint32_t at = read_tag();
      const auto length = read_number<std::uint32_t>();
      ended = delimited && at == kSequenceEnd;
      if (ended) break;
      if (at != kItem) fail("one of its sequences is damaged. Get a complete copy.");
      if (length != kUndefined && length > end - in_.position()) fail_cut();
      DicomItem* item = items != nullptr ? &items->emplace_back() : nullptr;
      walk_elements(length == kUndefined ? end : in_.position() + length, length == kUndefined, depth + 1, item);
    }
    explicit_ = was_explicit;
  }

  void walk_picture(const Element& e) {
    file_.has_picture = true;
    file_.compressed = e.length == kUndefined;
    file_.words = e.kind == "OW";
    if (file_.compressed)
      walk_fragments(&file_.fragments);
    else
      file_.picture = read(e.length);
    if (file_.fragments.empty()) return;
    file_.offsets = file_.fragments.front();
    file_.fragments.erase(file_.fragments.begin());
  }

  /// Compressed values.
  void walk_fragments(std::vector<std::string_view>* fragments) {
    for (;;) {
      const std::uint32_t at = read_tag();
      const auto length = read_number<std::uint32_t>();
      if (at == kSequenceEnd) return;
      if (at != kItem) fail("its compressed values are damaged. Get a complete copy.");
      const std::string_view fragment = read(length);
      if (fragments != nullptr) fragments->push_back(fragment);
    }
  }

  std::string_view bytes_;
  ByteReader in_;
  bool explicit_ = true, big_endian_ = false;
  DicomFile file_;
};

}  // namespace

bool DicomItem::has(std::uint32_t tag) const { return values.contains(tag); }

std::string DicomItem::text(std::uint32_t tag) const {
  const auto found = values.find(tag);
  if (found == values.end()) return {};
  std::string_view value = found->second;
  value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
  return std::string(value.substr(0, value.find_last_not_of(std::string_view(" \0", 2)) + 1));
}

std::vector<double> DicomItem::numbers(std::uint32_t tag, std::size_t count, const char* name) const {
  const std::string value = text(tag);
  if (value.empty()) return {};
  const std::optional<std::vector<double>> found = numbers_in(value, "\\ ");
  if (!found || found->size() != count ||
      !std::all_of(found->begin(), found->end(), [](double number) { return std::isfinite(number); }))
    throw Error(std::string("its ") + name + " is " + in_quotes(value) + "; there must be " + std::to_string(count) +
                (count == 1 ? " number" : " numbers") +
                (value.find(',') == std::string::npos ? "." : ", with decimal points."));
  return *found;
}

const DicomItem* DicomItem::item(std::uint32_t tag) const {
  const auto found = sequences.find(tag);
  return found == sequences.end() || found->second.size() != 1 ? nullptr : &found->second.front();
}

int DicomFile::number(std::uint32_t tag, const char* name) const {
  const auto found = data.values.find(tag);
  if (found == data.values.end() || found->second.size() != 2)
    throw Error(std::string("its ") + name + " is missing or not one number.");
  return number_in<std::uint16_t>(found->second, big_endian);
}

bool begins_like_dicom(std::string_view bytes) {
  return bytes.starts_with(kFirstElement) || (bytes.size() >= kPreamble + 4 && bytes.substr(kPreamble, 4) == "DICM") ||
         !syntax_without_header(bytes).empty();
}

DicomFile parse_dicom(std::string_view bytes) {
  if (!begins_like_dicom(bytes)) throw Error("it is not a DICOM file.");
  return DicomWalker(bytes).walk_file();
}

}  // namespace hapticut
