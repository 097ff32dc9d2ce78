// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/volume_files.hpp"

/// @file
/// DICOM files, element by element.
namespace hapticut::test {

/// Elements by tag, in the order of the format: kind and value, or the items of a sequence.
struct DicomElements {
  std::map<std::uint32_t, std::pair<std::string, std::string>> values;

  DicomElements& set(std::uint32_t tag, const std::string& kind, std::string value) {
    if (value.size() % 2 != 0) value += kind == "UI" ? '\0' : ' ';
    values[tag] = {kind, std::move(value)};
    return *this;
  }
  DicomElements& set_word(std::uint32_t tag, std::uint16_t value) { return set(tag, "US", little(value)); }
  /// @param implicit  for a file without kinds, or an element of unknown kind (UN)
  DicomElements& set_items(std::uint32_t tag, const std::vector<DicomElements>& items, bool implicit = false) {
    std::string bytes;
    for (const DicomElements& item : items) bytes += part(item.bytes(implicit));
    return set(tag, "SQ", bytes);
  }
  /// A compressed picture in parts.
  DicomElements& set_fragments(const std::vector<std::string>& fragments) {
    std::string bytes = part("");
    for (const std::string& fragment : fragments) bytes += part(fragment);
    return set(0x7fe00010, "OB of undefined length", bytes + std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8));
  }

  [[nodiscard]] std::string bytes(bool implicit = false) const {
    std::string all;
    for (const auto& [tag, element] : values) {
      const auto& [kind, value] = element;
      const bool undefined = kind.size() > 2,
                 long_form = undefined || kind == "OB" || kind == "OW" || kind == "SQ" || kind == "UN";
      const auto length = undefined ? 0xffffffffU : std::uint32_t(value.size());
      all += little(std::uint16_t(tag >> 16U)) + little(std::uint16_t(tag)) + (implicit ? "" : kind.substr(0, 2));
      all += implicit    ? little(length)
             : long_form ? std::string(2, '\0') + little(length)
                         : little(std::uint16_t(length));
      all += value;
    }
    return all;
  }

  static std::string part(const std::string& content) {
    return std::string("\xfe\xff\0\xe0", 4) + little(std::uint32_t(content.size())) + content;
  }
};

inline std::string dicom_file(const DicomElements& elements, const std::string& syntax = "1.2.840.10008.1.2.1") {
  DicomElements meta;
  meta.set(0x00020001, "OB", std::string("\0\1", 2)).set(0x00020010, "UI", syntax);
  const std::string bytes = meta.bytes();
  DicomElements length;
  length.set(0x00020000, "UL", little(std::uint32_t(bytes.size())));
  return std::string(128, '\0') + "DICM" + length.bytes() + bytes + elements.bytes(syntax == "1.2.840.10008.1.2");
}

/// A CT picture of 16 bits along the axes of the patient, with pixels of 0.1 mm by 0.2 mm. Its Hounsfield units are the
/// stored values minus 1000.
inline DicomElements dicom_picture(std::uint16_t columns, std::uint16_t rows, const std::vector<std::int16_t>& values) {
  DicomElements e;
  e.set(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2").set(0x0020000e, "UI", "1.2.3.6");
  e.set(0x00280004, "CS", "MONOCHROME2").set(0x00280030, "DS", "0.2\\0.1");
  e.set(0x00281052, "DS", "-1000").set(0x00281053, "DS", "1");
  e.set_word(0x00280002, 1).set_word(0x00280010, rows).set_word(0x00280011, columns);
  e.set_word(0x00280100, 16).set_word(0x00280101, 16).set_word(0x00280102, 15).set_word(0x00280103, 1);
  return e.set(0x7fe00010, "OW", little(values));
}

/// Three numbers to six digits.
inline std::string dicom_numbers(double x, double y, double z) {
  char text[96];
  std::snprintf(text, sizeof text, "%.6g\\%.6g\\%.6g", x, y, z);
  return text;
}

/// A CT picture as one slice of a series.
inline DicomElements dicom_slice(std::uint16_t columns, std::uint16_t rows, double height_mm,
                                 const std::vector<std::int16_t>& values) {
  DicomElements e = dicom_picture(columns, rows, values);
  return e.set(0x00200032, "DS", dicom_numbers(10, 20, height_mm)).set(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
}

/// s0, s1, ... (g++ 12 warns falsely about `"s" + std::to_string(0)`)
template <class Number>
std::string slice_name(Number number) {
  std::string text = "s";
  text += std::to_string(number);
  return text;
}

}  // namespace hapticut::test
