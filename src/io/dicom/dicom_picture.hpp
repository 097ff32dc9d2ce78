// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/dicom/dicom_elements.hpp"
#include "io/volume/raw_image.hpp"

namespace hapticut {

/// Values that stand for no measurement, but for what lies outside the field of view.
struct DicomPadding {
  double low, high;  ///< as stored, both included
  bool whole_words;  ///< compared with all bits that are allocated: with those stored alone it could not occur
};

/// What the header of a DICOM file says of its picture.
struct DicomPicture {
  FileGeometry geometry;           ///< dims[2] counts the frames; place and direction are those of the lowest
  std::vector<std::size_t> order;  ///< of the frames, from the lowest to the highest; empty: as they are stored
  bool has_place = false;          ///< the origin is that of the file
  int allocated = 16;              ///< [bit] of a stored value
  int stored = 16;                 ///< [bit] of it that count
  int high = 15;                   ///< the highest of them
  bool has_sign = false;
  std::vector<std::pair<double, double>> scale;  ///< slope and intercept, of all frames or of each
  std::vector<std::uint16_t> table;              ///< in place of the scale, from the stored value `table_first`
  double table_first = 0;
  std::vector<std::optional<DicomPadding>> padding;  ///< of all frames or of each
  std::string series;                                ///< Series Instance UID

  [[nodiscard]] std::size_t frame_samples() const {
    return std::size_t(geometry.dims[0]) * std::size_t(geometry.dims[1]);
  }
  [[nodiscard]] std::size_t frame_bytes() const { return frame_samples() * std::size_t(allocated) / 8; }
};

/// Puts planes (slices of a series, frames of a file) one above the other along the normal of the first: sets the
/// origin, the distance and, where positions say it better, the directions.
/// @param places_mm  of the first sample of each, two at least
/// @param planes     what they are, for the message: "slices"
/// @param name       of one of them
/// @return their order from the lowest to the highest
/// @throws Error "its slices ..." when they are not one above the other at equal distances
[[nodiscard]] std::vector<std::size_t> stack_planes(const std::vector<Vec3>& places_mm, const std::string& planes,
                                                    const std::function<std::string(std::size_t)>& name,
                                                    FileGeometry& geometry);

/// Its Series Instance UID.
[[nodiscard]] std::string series_of(const DicomFile& file);

/// @throws Error a sentence that begins with "it" or "its", when the picture is not one of grey values, or where it
///         lies cannot be told
[[nodiscard]] DicomPicture describe_picture(const DicomFile& file);

/// Unpacks one frame that the library itself does not: JPEG, JPEG-LS, JPEG 2000.
/// @return as many bytes as the frame has, in little-endian order
using FrameDecoder = std::function<std::string(const DicomFile&, const DicomPicture&, std::string_view packed)>;

/// The values of all frames, as stored and then scaled: those of MONOCHROME1, which are shown inverted, are not
/// inverted.
/// @throws Error as above, when there are fewer values than the header says, or they cannot be unpacked
[[nodiscard]] RawImage picture_values(const DicomFile& file, const DicomPicture& picture, const FrameDecoder& decode);

/// The same for one frame packed by run lengths.
/// @throws Error when the frame is damaged
[[nodiscard]] std::string unpack_rle(std::string_view packed, std::size_t samples, std::size_t bytes_per_sample);

/// @throws Error when the header of a JPEG 2000 stream asks for another picture than that of the file
void require_jpeg_2000_of(std::string_view stream, const DicomPicture& picture);

}  // namespace hapticut
