// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// The elements of a DICOM file. The library that other programs read them with ends the whole program where an element
/// is cut short, of an unknown kind or missing, so they are read here; it only unpacks compressed pictures, in a
/// program of its own.
namespace hapticut {

/// Group and element of a tag as one number.
constexpr std::uint32_t dicom_tag(std::uint16_t group, std::uint16_t element) {
  return std::uint32_t(group) << 16U | element;
}

/// Elements of one level: those that say what a picture shows and where it lies.
struct DicomItem {
  std::map<std::uint32_t, std::string_view> values;
  std::map<std::uint32_t, std::vector<DicomItem>> sequences;

  [[nodiscard]] bool has(std::uint32_t tag) const;

  /// Without the blanks and zeros that fill a text; empty where there is none.
  [[nodiscard]] std::string text(std::uint32_t tag) const;

  /// Decimal numbers between backslashes.
  /// @param name  of the element, for the message
  /// @return empty where the element is absent or empty
  /// @throws Error where the text is not `count` finite numbers
  [[nodiscard]] std::vector<double> numbers(std::uint32_t tag, std::size_t count, const char* name) const;

  /// The only item of a sequence, or nothing.
  [[nodiscard]] const DicomItem* item(std::uint32_t tag) const;
};

/// A file, as views into its bytes.
struct DicomFile {
  DicomItem data;
  std::string syntax;  ///< how elements and picture are stored: a Transfer Syntax UID
  bool big_endian = false;
  bool compressed = false;
  bool words = false;                       ///< the picture is one of 16-bit words, which matters in big-endian files
  std::string_view picture;                 ///< where it is not compressed
  std::string_view offsets;                 ///< table of a compressed picture; may be empty
  std::vector<std::string_view> fragments;  ///< of a compressed picture

  /// A number of 16 bits.
  /// @throws Error where the element is absent or no such number
  [[nodiscard]] int number(std::uint32_t tag, const char* name) const;
};

/// Whether a file that begins like this is one of DICOM, with the preamble of 128 bytes or without.
[[nodiscard]] bool begins_like_dicom(std::string_view bytes);

/// Goes through a file from element to element, to its end.
/// @param bytes  the whole file; it must outlive the result
/// @throws Error a sentence that begins with "it" or "its", when the file is damaged, cut short, of a kind that is not
///         read, or without a picture
[[nodiscard]] DicomFile parse_dicom(std::string_view bytes);

/// The file has no picture: a directory, a report, a plan.
inline constexpr const char* kNoDicomPicture = "it holds no picture";

}  // namespace hapticut
