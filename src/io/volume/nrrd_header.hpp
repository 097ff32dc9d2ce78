// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hapticut {

/// What the header of an NRRD file says about its data. Geometry is left to ITK.
struct NrrdHeader {
  std::string fields;  ///< the lines that say nothing about where and how the data are stored
  std::vector<double> sizes;
  std::size_t bytes_per_value = 0;  ///< 0: a type that is not read
  std::string encoding;             ///< raw, gzip, bzip2, ascii, hex
  std::int64_t byte_skip = 0;       ///< negative: counted from the end of the data
  std::int64_t line_skip = 0;
  std::filesystem::path data_file;  ///< the file itself, or the one that it names; empty: several files
  std::uint64_t data_offset = 0;    ///< in data_file
  double unit_mm = 1;               ///< [mm] what its lengths count
};

/// @throws Error when it is not an NRRD header
[[nodiscard]] NrrdHeader parse_nrrd_header(const std::filesystem::path& path);

}  // namespace hapticut
