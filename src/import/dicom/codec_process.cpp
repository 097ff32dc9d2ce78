// SPDX-License-Identifier: Apache-2.0
#include "import/dicom/codec_process.hpp"

#include "io/byte_reader.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t(1) << 29U;  // [bytes] for the program and its codecs
constexpr std::uint64_t kCopiesOfAFrame = 16;               // copies of a frame that codecs keep, in wider numbers
constexpr std::uint64_t kSecondsOfAFrame = 15;              // [s] limit of processor time

void append_element(std::string& bytes, std::uint32_t tag, const char* kind, std::string value) {
  if (value.size() % 2 != 0) value += kind == std::string_view("UI") ? '\0' : ' ';
  append_bytes_of(bytes, std::uint16_t(tag >> 16U));
  append_bytes_of(bytes, std::uint16_t(tag));
  bytes += kind;
  append_bytes_of(bytes, std::uint16_t(value.size()));
  bytes += value;
}

void append_number(std::string& bytes, std::uint32_t tag, int number) {
  append_element(bytes, tag, "US", {char(number), char(number >> 8)});
}

/// A file with one frame and only the elements that a codec needs, so no other element can confuse it.
std::string one_frame_file(const DicomFile& file, const DicomPicture& picture, std::string_view packed) {
  constexpr const char* kClass = "1.2.840.10008.5.1.4.1.1.7";
  std::string meta;
  append_element(meta, dicom_tag(2, 2), "UI", kClass);
  append_element(meta, dicom_tag(2, 3), "UI", "1.2");
  append_element(meta, dicom_tag(2, 0x10), "UI", file.syntax);
  std::string bytes = std::string(128, '\0') + "DICM";
  append_element(bytes, dicom_tag(2, 0), "UL", {char(meta.size()), 0, 0, 0});
  bytes += meta;
  append_element(bytes, dicom_tag(8, 0x16), "UI", kClass);
  append_element(bytes, dicom_tag(8, 0x18), "UI", "1.2");
  append_number(bytes, dicom_tag(0x28, 2), 1);
  append_element(bytes, dicom_tag(0x28, 4), "CS", "MONOCHROME2");
  append_number(bytes, dicom_tag(0x28, 0x10), picture.geometry.dims[1]);
  append_number(bytes, dicom_tag(0x28, 0x11), picture.geometry.dims[0]);
  append_number(bytes, dicom_tag(0x28, 0x100), picture.allocated);
  append_number(bytes, dicom_tag(0x28, 0x101), picture.stored);
  append_number(bytes, dicom_tag(0x28, 0x102), picture.high);
  append_number(bytes, dicom_tag(0x28, 0x103), picture.has_sign ? 1 : 0);
  bytes += std::string("\xe0\x7f\x10\0OB\0\0\xff\xff\xff\xff", 12);
  const auto append_item = [&](std::uint16_t element, std::string_view content) {
    append_bytes_of(bytes, std::uint16_t(0xfffe));
    append_bytes_of(bytes, element);
    append_bytes_of(bytes, std::uint32_t(content.size()));
    bytes += content;
  };
  append_item(0xe000, "");
  append_item(0xe000, packed);
  append_item(0xe0dd, "");
  return bytes;
}

std::string name_of_compression(const std::string& syntax) {
  const std::string jpeg = "1.2.840.10008.1.2.4.";
  if (syntax.starts_with(jpeg + "8")) return "JPEG-LS";
  if (syntax.starts_with(jpeg + "9")) return "JPEG 2000";
  if (syntax.starts_with(jpeg) && syntax.size() == jpeg.size() + 2) return "JPEG";
  throw Error("its picture has an unsupported compression (" + syntax + "); save it uncompressed.");
}

}  // namespace

std::string CodecProcess::operator()(const DicomFile& file, const DicomPicture& picture, std::string_view packed) {
  const std::string compression = name_of_compression(file.syntax);
  if (compression == "JPEG 2000" && !packed.empty()) require_jpeg_2000_of(packed, picture);
  process_.start();
  const std::string request = one_frame_file(file, picture, packed);
  seconds_ += kSecondsOfAFrame;
  std::optional<ChildProcess::Answer> answer =
      process_.ask(request, {kMemory + kCopiesOfAFrame * picture.frame_bytes() + 4 * request.size(), seconds_},
                   picture.frame_bytes());
  if (answer && answer->result == Reply::Result::done && answer->content.size() == picture.frame_bytes())
    return std::move(answer->content);
  process_.stop();
  seconds_ = 0;
  throw Error("its values, compressed by " + compression +
              ", cannot be unpacked; they are damaged or of an unsupported kind. Get a complete copy, or save the file "
              "uncompressed.");
}

}  // namespace hapticut
