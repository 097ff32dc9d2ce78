// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Reads the elements of a DICOM file. ITK's DICOM library ends the whole program when an element is truncated, of an
/// unknown kind or missing. So the elements are read here; that library only unpacks compressed pictures, in a child
/// process.
namespace hapticut {

/// Group and element of a tag in one number.
constexpr std::uint32_t dicom_tag(std::uint16_t group, std::uint16_t element) {
  return std::uint32_t(group) << 16U | element;
}

/// The kept elements of one level: kind and position of a picture.
struct DicomItem {
  std::map<std::uint32_t, std::string_view> values;
  std::map<std::uint32_t, std::vector<DicomItem>> sequences;

  [[nodiscard]] bool has(std::uint32_t tag) const;

  /// Text of an element without trailing blanks and zeros; empty when the element is absent.
  [[nodiscard]] std::string text(std::uint32_t tag) const;

  /// Decimal numbers separated by backslashes.
  /// @param name  name of the element, for the message
  /// @return empty when the element is absent or empty
  /// @throws Error unless the text is `count` finite numbers
  [[nodiscard]] std::vector<double> numbers(std::uint32_t tag, std::size_t count, const char* name) const;

  /// The only item of a sequence; null when there is none or more than one.
  [[nodiscard]] const DicomItem* item(std::uint32_t tag) const;
};

/// A DICOM file, as views into its bytes.
struct DicomFile {
  DicomItem data;
  std::string syntax;  ///< format of elements and picture: a Transfer Syntax UID
  bool big_endian = false;
  bool has_picture = false;  ///< false: a directory, a report, a plan, or a file that was cut before its picture
  std::string media_class;   ///< kind of the file by its meta header (Media Storage SOP Class UID); may be empty
  bool compressed = false;
  bool words = false;                       ///< the picture has 16-bit words, which matters in big-endian files
  std::string_view picture;                 ///< the values, when not compressed
  std::string_view offsets;                 ///< table of offsets of a compressed picture; may be empty
  std::vector<std::string_view> fragments;  ///< parts of a compressed picture

  /// A 16-bit number.
  /// @throws Error when the element is absent or not such a number
  [[nodiscard]] int number(std::uint32_t tag, const char* name) const;
};

/// Whether the bytes are the beginning of a DICOM file, with or without the preamble of 128 bytes.
[[nodiscard]] bool begins_like_dicom(std::string_view bytes);

/// Reads a file element by element, to the end of its picture. What follows is not read: writers pad files with zeros.
/// @param bytes  the whole file; it must outlive the result
/// @throws Error without the name of the file, when the file is damaged, truncated or of an unsupported kind
[[nodiscard]] DicomFile parse_dicom(std::string_view bytes);

}  // namespace hapticut
