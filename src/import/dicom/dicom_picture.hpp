// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/dicom/dicom_elements.hpp"
#include "import/volume/raw_image.hpp"

namespace hapticut {

/// Range of values that mark samples outside the field of view.
struct DicomPadding {
  double low, high;  ///< as stored, inclusive
  bool whole_words;  ///< compared with all allocated bits, because the value does not fit the stored bits
};

/// Description of a picture, from the header of a DICOM file.
struct DicomPicture {
  FileGeometry geometry;           ///< dims[2] is the number of frames; position and direction of the lowest frame
  std::vector<std::size_t> order;  ///< order of the frames, from lowest to highest; empty: as stored
  bool has_place = false;          ///< the file has an origin
  std::string kind;                ///< SOP Class UID
  int allocated = 16;              ///< [bit] allocated for a value
  int stored = 16;                 ///< [bit] used for a value
  int high = 15;                   ///< index of the highest used bit
  bool has_sign = false;
  std::vector<std::pair<double, double>> scale;  ///< slope and intercept, shared or per frame
  std::vector<std::uint16_t> table;              ///< replaces the scale; starts at the stored value `table_first`
  double table_first = 0;
  std::vector<std::optional<DicomPadding>> padding;  ///< shared or per frame
  std::string series;                                ///< Series Instance UID

  [[nodiscard]] std::size_t frame_samples() const {
    return std::size_t(geometry.dims[0]) * std::size_t(geometry.dims[1]);
  }
  [[nodiscard]] std::size_t frame_bytes() const { return frame_samples() * std::size_t(allocated) / 8; }
};

/// Stacks planes (slices of a series, frames of a file) along the normal of the first plane. Sets the origin, the
/// distance and, if positions are more accurate, the directions.
/// @param places_mm  position of the first sample of each plane, at least two
/// @param planes     word for the message: "slices"
/// @param name  name of one plane, for the message
/// @return order of the planes, from lowest to highest
/// @throws Error "its slices ..." when the planes are not stacked at equal distances
[[nodiscard]] std::vector<std::size_t> stack_planes(const std::vector<Vec3>& places_mm, const std::string& planes,
                                                    const std::function<std::string(std::size_t)>& name,
                                                    FileGeometry& geometry);

/// The Series Instance UID of a file.
[[nodiscard]] inline std::string series_of(const DicomFile& file) { return file.data.text(dicom_tag(0x20, 0xe)); }

/// The SOP Class UID of a file; empty when it has none.
[[nodiscard]] std::string kind_of(const DicomFile& file);

/// Whether a file describes a picture, even if it lacks its values.
[[nodiscard]] bool has_rows(const DicomFile& file);

/// @throws Error without the name of the file, when the picture has no grey values, or its position is
///         unknown
[[nodiscard]] DicomPicture describe_picture(const DicomFile& file);

/// Unpacks one frame in JPEG, JPEG-LS or JPEG 2000.
/// @return the bytes of the frame, in little-endian order
using FrameDecoder = std::function<std::string(const DicomFile&, const DicomPicture&, std::string_view packed)>;

/// The values of all frames, as stored and then scaled. MONOCHROME1, which viewers show inverted, is not inverted.
/// @throws Error without the name of the file, when there are fewer values than the header says, or they
///         cannot be unpacked
[[nodiscard]] RawImage picture_values(const DicomFile& file, const DicomPicture& picture, const FrameDecoder& decode);

/// The values of one frame in run-length encoding (RLE).
/// @throws Error when the frame is damaged
[[nodiscard]] std::string unpack_rle(std::string_view packed, std::size_t samples, std::size_t bytes_per_sample);

/// @throws Error when the header of a JPEG 2000 stream describes another picture than the file
void require_jpeg_2000_of(std::string_view stream, const DicomPicture& picture);

}  // namespace hapticut
