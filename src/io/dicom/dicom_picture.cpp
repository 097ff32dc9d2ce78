// SPDX-License-Identifier: Apache-2.0
#include "io/dicom/dicom_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "hapticut/core/errors.hpp"
#include "io/volume/formats.hpp"
#include "io/volume/number_text.hpp"

namespace hapticut {
namespace {

constexpr std::uint32_t kImageType = dicom_tag(8, 8), kClass = dicom_tag(8, 0x16), kThickness = dicom_tag(0x18, 0x50),
                        kBetweenSlices = dicom_tag(0x18, 0x88), kSeries = dicom_tag(0x20, 0xe),
                        kPosition = dicom_tag(0x20, 0x32), kOrientation = dicom_tag(0x20, 0x37),
                        kChannels = dicom_tag(0x28, 2), kPhotometric = dicom_tag(0x28, 4), kFrames = dicom_tag(0x28, 8),
                        kRows = dicom_tag(0x28, 0x10), kColumns = dicom_tag(0x28, 0x11),
                        kPixelSpacing = dicom_tag(0x28, 0x30), kAllocated = dicom_tag(0x28, 0x100),
                        kStored = dicom_tag(0x28, 0x101), kHigh = dicom_tag(0x28, 0x102),
                        kSign = dicom_tag(0x28, 0x103), kIntercept = dicom_tag(0x28, 0x1052),
                        kSlope = dicom_tag(0x28, 0x1053), kFrameOffsets = dicom_tag(0x3004, 0xc),
                        kSharedGroups = dicom_tag(0x5200, 0x9229), kFrameGroups = dicom_tag(0x5200, 0x9230),
                        kPlanePosition = dicom_tag(0x20, 0x9113), kPlaneOrientation = dicom_tag(0x20, 0x9116),
                        kMeasures = dicom_tag(0x28, 0x9110), kTransformation = dicom_tag(0x28, 0x9145);
constexpr const char* kDoseClass = "1.2.840.10008.5.1.4.1.1.481.2";

int frames_of(const DicomFile& file) {
  const std::vector<double> frames = file.data.numbers(kFrames, 1, "number of frames");
  if (frames.empty()) return 1;
  if (frames[0] != std::floor(frames[0]) || !(frames[0] >= 1 && frames[0] <= 1e6))
    throw Error("its number of frames is " + format_number(frames[0]) + "; it must be a whole number from 1.");
  return int(frames[0]);
}

/// What a frame says in a functional group, or all frames share, or nothing.
const DicomItem* group_of(const DicomFile& file, std::size_t frame, std::uint32_t group) {
  const auto frames = file.data.sequences.find(kFrameGroups);
  if (frames != file.data.sequences.end() && frame < frames->second.size())
    if (const DicomItem* item = frames->second[frame].item(group)) return item;
  const DicomItem* shared = file.data.item(kSharedGroups);
  return shared != nullptr ? shared->item(group) : nullptr;
}

const DicomItem& group_or_file(const DicomFile& file, std::size_t frame, std::uint32_t group) {
  const DicomItem* item = group_of(file, frame, group);
  return item != nullptr ? *item : file.data;
}

Mat3 direction_of(const DicomItem& item) {
  const std::vector<double> o = item.numbers(kOrientation, 6, "orientation");
  Mat3 direction = Mat3::Identity();
  if (o.empty()) return direction;
  direction.col(0) = Vec3(o[0], o[1], o[2]);
  direction.col(1) = Vec3(o[3], o[4], o[5]);
  direction.col(2) = direction.col(0).cross(direction.col(1));
  return direction;
}

Vec3 position_of(const DicomItem& item) {
  const std::vector<double> p = item.numbers(kPosition, 3, "position");
  return p.empty() ? Vec3(Vec3::Zero()) : Vec3(p[0], p[1], p[2]);
}

/// Where along the normal the frames lie [mm]; empty where the file does not say it of each.
std::vector<double> heights_of(const DicomFile& file, std::size_t frames, const Vec3& normal) {
  if (file.data.text(kClass) == kDoseClass || file.data.has(kFrameOffsets)) {
    const std::string text = file.data.text(kFrameOffsets);
    const std::optional<std::vector<double>> offsets = numbers_in(text, "\\ ");
    const bool finite =
        offsets && std::all_of(offsets->begin(), offsets->end(), [](double o) { return std::isfinite(o); });
    if (!finite || (offsets->size() != frames && !(frames == 1 && offsets->empty())))
      throw Error("the offsets of its frames are " + in_quotes(text) + "; by its number of frames there must be " +
                  std::to_string(frames) + ". Get a complete copy.");
    return *offsets;
  }
  std::vector<double> heights;
  for (std::size_t n = 0; n < frames; ++n) {
    const DicomItem* plane = group_of(file, n, kPlanePosition);
    if (plane == nullptr || !plane->has(kPosition)) return {};
    heights.push_back(position_of(*plane).dot(normal));
  }
  return heights;
}

/// Sets the distance and the direction of the frames.
void stack_frames(const DicomFile& file, FileGeometry& geometry) {
  const auto frames = std::size_t(geometry.dims[2]);
  const std::vector<double> heights = heights_of(file, frames, geometry.direction.col(2));
  if (heights.size() < 2) {
    const DicomItem& measures = group_or_file(file, 0, kMeasures);
    std::vector<double> between = measures.numbers(kBetweenSlices, 1, "spacing between slices");
    if (between.empty()) between = measures.numbers(kThickness, 1, "slice thickness");
    geometry.spacing_mm.z() = between.empty() ? 0 : std::abs(between[0]);
    return;
  }
  const double step = (heights.back() - heights.front()) / double(frames - 1);
  for (std::size_t n = 0; n < frames; ++n)
    if (!(std::abs(heights[n] - heights[0] - double(n) * step) <= std::max(0.011, 0.01 * std::abs(step))))
      throw Error("its frames are not evenly spaced at frame " + std::to_string(n + 1) + ". Resample it first.");
  geometry.spacing_mm.z() = std::abs(step);
  if (step < 0) geometry.direction.col(2) *= -1;
}

void require_grey_picture(const DicomFile& file, const DicomPicture& picture) {
  const std::string type = file.data.text(kImageType), photometric = file.data.text(kPhotometric);
  if (("\\" + type + "\\").find("\\MOSAIC\\") != std::string::npos)
    throw Error("it is a MOSAIC: several slices side by side in one picture. Save them as slices first.");
  if (file.number(kChannels, "number of channels") != 1)
    throw Error("it has several values per sample; a volume has one. Convert it to grey values or labels.");
  if (!photometric.empty() && photometric != "MONOCHROME1" && photometric != "MONOCHROME2")
    throw Error("its values mean " + in_quotes(photometric) + "; grey values are read (MONOCHROME1, MONOCHROME2).");
  const bool whole_bytes = picture.allocated == 8 || picture.allocated == 16 || picture.allocated == 32;
  if (!whole_bytes || picture.stored < 1 || picture.high >= picture.allocated || picture.high + 1 < picture.stored)
    throw Error("its values have " + std::to_string(picture.stored) + " bits up to bit " +
                std::to_string(picture.high) + " of " + std::to_string(picture.allocated) +
                "; 8, 16 and 32 bits are read, and no more can be stored than there are.");
}

/// Bits that count, with their sign.
template <class Word>
double stored_value(Word word, const DicomPicture& picture) {
  const auto bits = std::uint64_t(word) >> unsigned(picture.high + 1 - picture.stored);
  const std::uint64_t mask = (std::uint64_t(1) << unsigned(picture.stored)) - 1;
  const std::uint64_t value = bits & mask;
  const bool negative = picture.has_sign && (value >> unsigned(picture.stored - 1) & 1U) != 0;
  return negative ? double(std::int64_t(value) - std::int64_t(mask) - 1) : double(value);
}

template <class Word>
void append_frame(std::string_view bytes, const DicomPicture& picture, std::size_t frame, RawImage& image) {
  const auto [slope, intercept] = picture.scale[picture.scale.size() == 1 ? 0 : frame];
  std::size_t to = image.bytes.size();
  image.bytes.resize(to + picture.frame_samples() * size_of(image.type));
  for (std::size_t n = 0; n < picture.frame_samples(); ++n) {
    Word word;
    std::memcpy(&word, bytes.data() + n * sizeof word, sizeof word);
    const double value = slope * stored_value(word, picture) + intercept;
    with_value_type(image.type, [&](auto zero) {
      zero = decltype(zero)(value);
      std::memcpy(image.bytes.data() + to, &zero, sizeof zero);
      to += sizeof zero;
    });
  }
}

/// The fragments of each frame.
std::vector<std::vector<std::string_view>> fragments_of_frames(const DicomFile& file, std::size_t frames) {
  std::vector<std::vector<std::string_view>> parts(frames);
  if (frames == 1) {
    parts[0] = file.fragments;
  } else if (file.fragments.size() == frames) {
    for (std::size_t n = 0; n < frames; ++n) parts[n] = {file.fragments[n]};
  } else {
    // The table names the place of each frame's first fragment, counted from that of the first frame.
    if (file.offsets.size() != 4 * frames)
      throw Error("its " + std::to_string(file.fragments.size()) + " compressed parts cannot be told apart into " +
                  std::to_string(frames) + " frames; it is damaged. Get a complete copy.");
    std::size_t frame = 0;
    std::uint64_t place = 0;
    for (const std::string_view fragment : file.fragments) {
      std::uint32_t next = 0;
      if (frame + 1 < frames) std::memcpy(&next, file.offsets.data() + 4 * (frame + 1), sizeof next);
      if (frame + 1 < frames && place == next) ++frame;
      parts[frame].push_back(fragment);
      place += 8 + fragment.size();
    }
  }
  return parts;
}

/// Frames that are not compressed, in little-endian order.
std::string plain_frame(const DicomFile& file, const DicomPicture& picture, std::size_t frame) {
  std::string bytes(file.picture.substr(frame * picture.frame_bytes(), picture.frame_bytes()));
  const auto word = std::ptrdiff_t(picture.allocated > 8 ? picture.allocated / 8 : file.words ? 2 : 1);
  if (file.big_endian)
    for (auto at = bytes.begin(); bytes.end() - at >= word; at += word) std::reverse(at, at + word);
  return bytes;
}

}  // namespace

DicomPicture describe_picture(const DicomFile& file) {
  DicomPicture picture;
  picture.allocated = file.number(kAllocated, "number of bits allocated");
  picture.stored = file.number(kStored, "number of bits stored");
  picture.high = file.number(kHigh, "highest bit");
  picture.has_sign = file.number(kSign, "kind of values") != 0;
  require_grey_picture(file, picture);
  const int frames = frames_of(file);
  const double rows = file.number(kRows, "number of rows"), columns = file.number(kColumns, "number of columns");
  require_sane_dims({columns, rows, double(frames)});
  picture.geometry.dims = {int(columns), int(rows), frames};
  picture.geometry.direction = direction_of(group_or_file(file, 0, kPlaneOrientation));
  picture.geometry.origin_mm = position_of(group_or_file(file, 0, kPlanePosition));
  // The distance of the rows comes first.
  const std::vector<double> spacing = group_or_file(file, 0, kMeasures).numbers(kPixelSpacing, 2, "pixel spacing");
  picture.geometry.spacing_mm = spacing.empty() ? Vec3(Vec3::Zero()) : Vec3(spacing[1], spacing[0], 0);
  stack_frames(file, picture.geometry);
  // The unit of a dose is its own affair.
  const bool dose = file.data.text(kClass) == kDoseClass;
  const bool each = file.data.sequences.contains(kFrameGroups);
  for (std::size_t n = 0; n < (each ? std::size_t(frames) : 1); ++n) {
    const DicomItem& item = group_or_file(file, n, kTransformation);
    const std::vector<double> slope = item.numbers(kSlope, 1, "rescale slope"),
                              intercept = item.numbers(kIntercept, 1, "rescale intercept");
    if (!slope.empty() && slope[0] == 0) throw Error("its rescale slope is 0; all its values would be the same.");
    picture.scale.emplace_back(slope.empty() || dose ? 1 : slope[0], intercept.empty() || dose ? 0 : intercept[0]);
  }
  picture.series = file.data.text(kSeries);
  return picture;
}

RawImage picture_values(const DicomFile& file, const DicomPicture& picture, const FrameDecoder& decode) {
  const auto frames = std::size_t(picture.geometry.dims[2]);
  const double needed = double(picture.frame_bytes()) * double(frames);
  RawImage image;
  image.geometry = picture.geometry;
  const bool scaled = std::any_of(picture.scale.begin(), picture.scale.end(),
                                  [](const auto& scale) { return scale != std::pair(1.0, 0.0); });
  image.type = scaled || picture.allocated < 32 ? ValueType::float32
               : picture.has_sign               ? ValueType::int32
                                                : ValueType::uint32;
  std::vector<std::vector<std::string_view>> parts;
  if (file.compressed) {
    double available = 0;
    for (const std::string_view fragment : file.fragments) available += double(fragment.size());
    constexpr const char* kRunLengths = "1.2.840.10008.1.2.5";
    if (file.syntax != kRunLengths) require_bytes(needed, available, kAnyCompression);
    parts = fragments_of_frames(file, frames);
  } else {
    require_bytes(needed, double(file.picture.size()), kNotCompressed);
  }
  for (std::size_t n = 0; n < frames; ++n) {
    std::string bytes;
    if (!file.compressed) {
      bytes = plain_frame(file, picture, n);
    } else if (file.syntax == "1.2.840.10008.1.2.5") {
      std::string packed;
      for (const std::string_view part : parts[n]) packed += part;
      bytes = unpack_rle(packed, picture.frame_samples(), std::size_t(picture.allocated) / 8);
    } else {
      bytes = decode(file, picture, parts[n]);
    }
    if (bytes.size() != picture.frame_bytes())
      throw Error("its picture is of another size than its header says; it is damaged. Get a complete copy.");
    if (picture.allocated == 8) append_frame<std::uint8_t>(bytes, picture, n, image);
    if (picture.allocated == 16) append_frame<std::uint16_t>(bytes, picture, n, image);
    if (picture.allocated == 32) append_frame<std::uint32_t>(bytes, picture, n, image);
  }
  return image;
}

}  // namespace hapticut
