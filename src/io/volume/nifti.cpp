// SPDX-License-Identifier: Apache-2.0
#include <itkNiftiImageIO.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <memory>

#include "io/file_errors.hpp"
#include "io/volume/formats.hpp"
#include "io/volume/itk_image.hpp"

namespace hapticut {
namespace {

/// The fields of a NIfTI-1 or NIfTI-2 header that say how large it is.
struct NiftiSize {
  std::array<double, 8> dim{};  ///< number of dimensions, then their sizes
  double bytes_per_value = 0;
  double data_offset = 0;
};

template <class Number>
Number number_at(const std::array<char, 540>& header, std::size_t offset, bool swapped) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), header.data() + offset, sizeof(Number));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(Number));
  return number;
}

/// 0: not a type that is read.
double bytes_of_datatype(int code) {
  switch (code) {
    case 2:    // uint8
    case 256:  // int8
      return 1;
    case 4:    // int16
    case 512:  // uint16
      return 2;
    case 8:    // int32
    case 16:   // float32
    case 768:  // uint32
      return 4;
    case 64:    // float64
    case 1024:  // int64
    case 1280:  // uint64
      return 8;
    default:
      return 0;
  }
}

NiftiSize size_in_header(const std::filesystem::path& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) cannot_read(path, "it cannot be opened.");
  std::array<char, 540> header{};
  const int count = gzread(file.get(), header.data(), unsigned(header.size()));
  if (count < 348) cannot_read(path, "it is too short for a NIfTI header, or its compression is damaged.");
  for (const bool swapped : {false, true}) {
    NiftiSize size;
    const auto magic = number_at<std::int32_t>(header, 0, swapped);
    if (magic == 348) {
      for (std::size_t n = 0; n < 8; ++n) size.dim[n] = number_at<std::int16_t>(header, 40 + 2 * n, swapped);
      size.bytes_per_value = bytes_of_datatype(number_at<std::int16_t>(header, 70, swapped));
      size.data_offset = double(number_at<float>(header, 108, swapped));
      return size;
    }
    if (magic == 540 && count == 540) {
      size.bytes_per_value = bytes_of_datatype(number_at<std::int16_t>(header, 12, swapped));
      for (std::size_t n = 0; n < 8; ++n) size.dim[n] = double(number_at<std::int64_t>(header, 16 + 8 * n, swapped));
      size.data_offset = double(number_at<std::int64_t>(header, 168, swapped));
      return size;
    }
  }
  cannot_read(path, "it is not a NIfTI file.");
}

bool is_deflated(const std::filesystem::path& path) { return first_bytes(path, 2) == "\x1f\x8b"; }

/// Reads a compressed file through to its end, so that a damaged one is not taken for a complete one.
void require_complete(const std::filesystem::path& path, double needed) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  std::vector<char> buffer(1U << 20U);
  double total = 0;
  for (int count = 1; count > 0;) {
    count = file ? gzread(file.get(), buffer.data(), unsigned(buffer.size())) : -1;
    if (count < 0) cannot_read(path, "its compressed data are damaged or cut short.");
    total += count;
  }
  if (total < needed) cannot_read(path, "it is cut short.");
}

}  // namespace

RawImage read_nifti(const std::filesystem::path& path) {
  const auto file_size = double(readable_size(path));
  const NiftiSize size = size_in_header(path);
  if (!(size.dim[0] >= 3 && size.dim[0] <= 7))
    cannot_read(path, "it has " + format_number(size.dim[0]) + " dimensions; a volume has three.");
  require_sane_dims(path, {size.dim[1], size.dim[2], size.dim[3]});
  for (std::size_t n = 4; n <= std::size_t(size.dim[0]); ++n)
    if (size.dim[n] > 1)
      cannot_read(path, "it has " + format_number(size.dim[n]) +
                            " volumes or values per sample; take one volume out of it first.");
  if (size.bytes_per_value == 0)
    cannot_read(path, "its values are of a type that is not read; save it as grey values or labels.");
  const double needed = size.data_offset + size.dim[1] * size.dim[2] * size.dim[3] * size.bytes_per_value;
  const bool deflated = is_deflated(path);
  require_bytes(path, needed, file_size, deflated ? kDeflate : kNotCompressed);
  const auto io = itk::NiftiImageIO::New();
  RawImage image = read_itk_image(*io, path);
  if (deflated) require_complete(path, needed);
  return image;
}

}  // namespace hapticut
