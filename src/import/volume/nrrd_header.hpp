// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "import/volume/raw_image.hpp"

/// @file
/// The header of an NRRD file: lines of `field: value` up to an empty line.
namespace hapticut {

struct NrrdHeader {
  ValueType type = ValueType::uint8;
  FileGeometry geometry;
  std::string encoding;  ///< raw, gzip, bzip2, ascii, hex
  bool big_endian = false;
  std::int64_t byte_skip = 0;  ///< negative: counted from the end of the data
  std::int64_t line_skip = 0;
  std::vector<std::string>
      data_files;       ///< file names relative to the header, in order of the slowest axis; empty: this file
  std::size_t end = 0;  ///< [bytes] position of the data in the same file
};

/// @param bytes  the beginning of a file
/// @throws Error without the name of the file, when it is not the header of a volume with three axes and one
///         value per sample
[[nodiscard]] NrrdHeader parse_nrrd_header(std::string_view bytes);

}  // namespace hapticut
