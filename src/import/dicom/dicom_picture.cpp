// SPDX-License-Identifier: Apache-2.0
#include "import/dicom/dicom_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "hapticut/core/errors.hpp"
#include "import/volume/formats.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::uint32_t kImageType = dicom_tag(8, 8), kClass = dicom_tag(8, 0x16),
                        kBetweenSlices = dicom_tag(0x18, 0x88), kPosition = dicom_tag(0x20, 0x32),
                        kOrientation = dicom_tag(0x20, 0x37), kChannels = dicom_tag(0x28, 2),
                        kPhotometric = dicom_tag(0x28, 4), kFrames = dicom_tag(0x28, 8), kRows = dicom_tag(0x28, 0x10),
                        kColumns = dicom_tag(0x28, 0x11), kPixelSpacing = dicom_tag(0x28, 0x30),
                        kAllocated = dicom_tag(0x28, 0x100), kStored = dicom_tag(0x28, 0x101),
                        kHigh = dicom_tag(0x28, 0x102), kSign = dicom_tag(0x28, 0x103),
                        kPadding = dicom_tag(0x28, 0x120), kPaddingLimit = dicom_tag(0x28, 0x121),
                        kIntercept = dicom_tag(0x28, 0x1052), kSlope = dicom_tag(0x28, 0x1053),
                        kTable = dicom_tag(0x28, 0x3000), kTableLayout = dicom_tag(0x28, 0x3002),
                        kTableValues = dicom_tag(0x28, 0x3006), kFrameOffsets = dicom_tag(0x3004, 0xc),
                        kSharedGroups = dicom_tag(0x5200, 0x9229), kFrameGroups = dicom_tag(0x5200, 0x9230),
                        kPlanePosition = dicom_tag(0x20, 0x9113), kPlaneOrientation = dicom_tag(0x20, 0x9116),
                        kMeasures = dicom_tag(0x28, 0x9110), kTransformation = dicom_tag(0x28, 0x9145);
constexpr const char* kDoseClass = "1.2.840.10008.5.1.4.1.1.481.2";
/// Enhanced and converted CT, MR and PET, and X-ray 3D, whose functional groups have the positions of the frames.
constexpr const char* kEnhanced[] = {"1.2.840.10008.5.1.4.1.1.2.1",    "1.2.840.10008.5.1.4.1.1.2.2",
                                     "1.2.840.10008.5.1.4.1.1.4.1",    "1.2.840.10008.5.1.4.1.1.4.4",
                                     "1.2.840.10008.5.1.4.1.1.128.1",  "1.2.840.10008.5.1.4.1.1.130",
                                     "1.2.840.10008.5.1.4.1.1.13.1.1", "1.2.840.10008.5.1.4.1.1.13.1.2"};

int frames_of(const DicomFile& file) {
  const std::vector<double> frames = file.data.numbers(kFrames, 1, "number of frames");
  if (frames.empty()) return 1;
  if (frames[0] != std::floor(frames[0]) || !(frames[0] >= 1 && frames[0] <= 1e6))
    throw Error("its number of frames is " + format_number(frames[0], std::round(frames[0])) +
                "; it must be a whole number from 1.");
  return int(frames[0]);
}

/// The item of a functional group of one frame, else the shared item; null when there is neither.
const DicomItem* group_of(const DicomFile& file, std::size_t frame, std::uint32_t group) {
  const auto frames = file.data.sequences.find(kFrameGroups);
  if (frames != file.data.sequences.end() && frame < frames->second.size())
    if (const DicomItem* item = frames->second[frame].item(group)) return item;
  const DicomItem* shared = file.data.item(kSharedGroups);
  return shared != nullptr ? shared->item(group) : nullptr;
}

/// Numbers of a frame: from its functional group if present, else from the file.
std::vector<double> numbers_of(const DicomFile& file, std::size_t frame, std::uint32_t group, std::uint32_t tag,
                               std::size_t count, const char* name) {
  const DicomItem* item = group_of(file, frame, group);
  return (item != nullptr && item->has(tag) ? *item : file.data).numbers(tag, count, name);
}

/// Rows, columns and the normal of a frame. Writers round them.
Mat3 direction_of(const DicomFile& file, std::size_t frame) {
  const std::vector<double> o = numbers_of(file, frame, kPlaneOrientation, kOrientation, 6, "orientation");
  Mat3 direction = Mat3::Identity();
  if (o.empty()) return direction;  // FileGeometry::axes_assumed
  direction.col(0) = Vec3(o[0], o[1], o[2]);
  direction.col(1) = Vec3(o[3], o[4], o[5]);
  direction.col(2) = direction.col(0).cross(direction.col(1)).normalized();
  if (direction.col(2).isZero())
    throw Error("its rows and columns have no valid direction; it is damaged. Get a complete copy.");
  return direction;
}

/// [mm] Positions of the frames; empty when the file lacks the position of a frame.
std::vector<Vec3> places_of(const DicomFile& file, std::size_t frames, const FileGeometry& geometry) {
  std::vector<Vec3> places;
  if (file.data.text(kClass) == kDoseClass || file.data.has(kFrameOffsets)) {
    const std::string text = file.data.text(kFrameOffsets);
    const std::optional<std::vector<double>> offsets = numbers_in(text, "\\ ");
    const bool finite =
        offsets && std::all_of(offsets->begin(), offsets->end(), [](double o) { return std::isfinite(o); });
    if (!finite || (offsets->size() != frames && !(frames == 1 && offsets->empty())))
      throw Error("the offsets of its frames are " + in_quotes(text) + "; its number of frames requires " +
                  std::to_string(frames) + ". Get a complete copy.");
    // Offsets that begin with the height of the first frame are heights, else distances along the normal (PS3.3
    // C.8.8.3.2).
    const Vec3& origin = geometry.origin_mm;
    const bool heights = frames > 1 && offsets->front() != 0 && std::abs(offsets->front() - origin.z()) <= 1e-3 &&
                         geometry.direction.col(2).head<2>().norm() <= kMaxRounding;  // axial
    for (const double offset : *offsets)
      places.emplace_back(heights ? Vec3(origin.x(), origin.y(), offset)
                                  : Vec3(origin + (offset - offsets->front()) * geometry.direction.col(2)));
    return places;
  }
  const auto groups = file.data.sequences.find(kFrameGroups);
  if (groups == file.data.sequences.end()) {
    const std::string kind = file.data.text(kClass);
    if (frames > 1 && std::find(std::begin(kEnhanced), std::end(kEnhanced), kind) != std::end(kEnhanced))
      throw Error("it lacks the functional groups with the positions of its frames. Get a complete copy.");
    return places;
  }
  if (groups->second.size() > frames)
    throw Error("its number of frames is " + std::to_string(frames) + ", but its functional groups describe " +
                std::to_string(groups->second.size()) + "; some are missing. Get a complete copy.");
  for (const DicomItem& group : groups->second) {
    const DicomItem* plane = group.item(kPlanePosition);
    const std::vector<double> p = plane != nullptr ? plane->numbers(kPosition, 3, "position") : std::vector<double>();
    if (!p.empty()) places.emplace_back(p[0], p[1], p[2]);
  }
  if (!places.empty() && places.size() != frames)
    throw Error("only " + std::to_string(places.size()) + " of its " + std::to_string(frames) +
                " frames have a position. Get a complete copy.");
  return places;
}

/// Sets distance, direction and order of the frames.
void stack_frames(const DicomFile& file, DicomPicture& picture) {
  FileGeometry& geometry = picture.geometry;
  const auto frames = std::size_t(geometry.dims[2]);
  for (std::size_t n = 1; n < frames && file.data.sequences.contains(kFrameGroups); ++n)
    if (!((direction_of(file, n) - geometry.direction).cwiseAbs().maxCoeff() <= kMaxRounding))
      throw Error("its frames 1 and " + std::to_string(n + 1) + " lie in different directions. Separate them first.");
  const std::vector<Vec3> places = places_of(file, frames, geometry);
  if (places.size() >= 2) {
    const auto name = [](std::size_t frame) { return "frame " + std::to_string(frame + 1); };
    picture.order = stack_planes(places, "frames", name, geometry);
    return;
  }
  // Not the thickness of the slices. Negative: the frames are stacked against the normal (PS3.3 C.8.4.15).
  const std::vector<double> between = numbers_of(file, 0, kMeasures, kBetweenSlices, 1, "spacing between slices");
  geometry.spacing_mm.z() = between.empty() ? 0 : between[0];
}

/// The item with this element: from any functional group of the frame, else from a shared one, else the file itself.
const DicomItem* item_with(const DicomFile& file, std::size_t frame, std::uint32_t tag) {
  const auto within = [&](const DicomItem* item) -> const DicomItem* {
    if (item == nullptr || item->has(tag)) return item;
    for (const auto& [group, items] : item->sequences)
      if (items.size() == 1 && items.front().has(tag)) return &items.front();
    return nullptr;
  };
  const auto frames = file.data.sequences.find(kFrameGroups);
  if (frames != file.data.sequences.end() && frame < frames->second.size())
    if (const DicomItem* own = within(&frames->second[frame])) return own;
  if (const DicomItem* shared = within(file.data.item(kSharedGroups))) return shared;
  return file.data.has(tag) ? &file.data : nullptr;
}

/// A stored value in binary. It is signed if the picture is signed, independent of the kind of the element.
std::optional<double> stored_number(const DicomFile& file, const DicomPicture& picture, std::size_t frame,
                                    std::uint32_t tag) {
  const DicomItem* item = item_with(file, frame, tag);
  if (item == nullptr || item->values.at(tag).empty()) return std::nullopt;
  const std::string_view bytes = item->values.at(tag);
  const auto as = [&](auto zero) { return double(number_in<decltype(zero)>(bytes, file.big_endian)); };
  if (bytes.size() == 2) return picture.has_sign ? as(std::int16_t{}) : as(std::uint16_t{});
  if (bytes.size() == 4) return picture.has_sign ? as(std::int32_t{}) : as(std::uint32_t{});
  throw Error("its pixel padding value is not one number; it is damaged. Get a complete copy.");
}

std::optional<DicomPadding> padding_of(const DicomFile& file, const DicomPicture& picture, std::size_t frame) {
  const std::optional<double> value = stored_number(file, picture, frame, kPadding);
  if (!value) return std::nullopt;
  const double limit = stored_number(file, picture, frame, kPaddingLimit).value_or(*value);
  DicomPadding padding = {std::min(*value, limit), std::max(*value, limit), false};
  const double lowest = picture.has_sign ? -std::ldexp(1.0, picture.stored - 1) : 0;
  padding.whole_words = padding.low < lowest || padding.high >= lowest + std::ldexp(1.0, picture.stored);
  return padding;
}

/// The table that some files have instead of slope and intercept (Modality LUT, PS3.3 C.11.1).
void read_table(const DicomFile& file, DicomPicture& picture) {
  const auto found = file.data.sequences.find(kTable);
  if (found == file.data.sequences.end() || found->second.empty()) return;
  const auto bytes_of = [&](std::uint32_t tag) {
    const auto value = found->second.front().values.find(tag);
    return value == found->second.front().values.end() ? std::string_view() : value->second;
  };
  const auto word = [&](std::string_view bytes, std::size_t n) {
    return number_in<std::uint16_t>(bytes.substr(2 * n), file.big_endian);
  };
  const std::string_view layout = bytes_of(kTableLayout), values = bytes_of(kTableValues);
  const std::size_t count = layout.size() != 6 ? 0 : word(layout, 0) == 0 ? 65536 : word(layout, 0);
  if (count == 0 || values.size() != 2 * count)
    throw Error(
        "its table of grey values (Modality LUT) is damaged or does not have 16-bit numbers; save it with a rescale "
        "slope and intercept instead of the table.");
  picture.table_first = picture.has_sign ? double(std::int16_t(word(layout, 1))) : double(word(layout, 1));
  for (std::size_t n = 0; n < count; ++n) picture.table.push_back(word(values, n));
}

void require_grey_picture(const DicomFile& file, const DicomPicture& picture) {
  const std::string type = file.data.text(kImageType), photometric = file.data.text(kPhotometric);
  if (("\\" + type + "\\").find("\\MOSAIC\\") != std::string::npos)
    throw Error("it is a MOSAIC: several slices side by side in one picture. Save it as separate slices first.");
  if (file.number(kChannels, "number of channels") != 1)
    throw Error("it has several values per sample; a volume has one. Convert it to grey values or labels.");
  if (!photometric.empty() && photometric != "MONOCHROME1" && photometric != "MONOCHROME2")
    throw Error("its values mean " + in_quotes(photometric) +
                "; only grey values are supported (MONOCHROME1, MONOCHROME2).");
  if (picture.allocated == 1)
    throw Error(
        "its values have 1 bit, as a segmentation (DICOM SEG); save it as labels in NRRD or NIfTI, e.g. by dcmqi.");
  const bool whole_bytes = picture.allocated == 8 || picture.allocated == 16 || picture.allocated == 32;
  if (!whole_bytes || picture.stored < 1 || picture.high >= picture.allocated || picture.high + 1 < picture.stored)
    throw Error("its values have " + std::to_string(picture.stored) + " bits up to bit " +
                std::to_string(picture.high) + " of " + std::to_string(picture.allocated) +
                "; supported are 8, 16 and 32 bits, with the stored bits inside the allocated ones.");
}

/// The stored bits as a number, with sign.
template <class Word>
double stored_value(Word word, const DicomPicture& picture) {
  const auto bits = std::uint64_t(word) >> unsigned(picture.high + 1 - picture.stored);
  const std::uint64_t mask = (std::uint64_t(1) << unsigned(picture.stored)) - 1;
  const std::uint64_t value = bits & mask;
  const bool negative = picture.has_sign && (value >> unsigned(picture.stored - 1) & 1U) != 0;
  return negative ? double(std::int64_t(value) - std::int64_t(mask) - 1) : double(value);
}

/// Values below the table map to its first entry, values above it to its last.
double in_table(double stored, const DicomPicture& picture) {
  return picture.table[std::size_t(std::clamp(stored - picture.table_first, 0.0, double(picture.table.size() - 1)))];
}

template <class Word>
void append_frame(std::string_view bytes, const DicomPicture& picture, std::size_t frame, RawImage& image) {
  const auto [slope, intercept] = picture.scale[picture.scale.size() == 1 ? 0 : frame];
  const std::optional<DicomPadding>& padding = picture.padding[picture.padding.size() == 1 ? 0 : frame];
  const std::size_t first = image.bytes.size() / size_of(image.type);
  std::size_t to = image.bytes.size();
  image.bytes.resize(to + picture.frame_samples() * size_of(image.type));
  for (std::size_t n = 0; n < picture.frame_samples(); ++n) {
    Word word;
    std::memcpy(&word, bytes.data() + n * sizeof word, sizeof word);
    const double stored = stored_value(word, picture);
    const double value = picture.table.empty() ? slope * stored + intercept : in_table(stored, picture);
    if (padding) {
      const double compared = !padding->whole_words ? stored
                              : picture.has_sign    ? double(std::make_signed_t<Word>(word))
                                                    : double(word);
      if (compared >= padding->low && compared <= padding->high) image.mark_padding(first + n);
    }
    with_value_type(image.type, [&](auto zero) {
      zero = decltype(zero)(value);
      std::memcpy(image.bytes.data() + to, &zero, sizeof zero);
      to += sizeof zero;
    });
  }
}

constexpr const char* kRunLengths = "1.2.840.10008.1.2.5";  // transfer syntax

/// Whether a compressed frame ends with this fragment, shown by the end marker of JPEG, JPEG-LS and JPEG 2000.
bool ends_stream(std::string_view fragment) {
  return fragment.substr(0, fragment.find_last_not_of('\0') + 1).ends_with("\xff\xd9");
}

/// The fragments of each frame.
std::vector<std::vector<std::string_view>> fragments_of_frames(const DicomFile& file, std::size_t frames) {
  std::vector<std::vector<std::string_view>> parts(frames);
  if (frames == 1) {
    const bool several =
        file.fragments.size() > 1 &&
        (file.syntax == kRunLengths || std::all_of(file.fragments.begin(), file.fragments.end(), ends_stream));
    if (several)
      throw Error("it contains " + std::to_string(file.fragments.size()) +
                  " compressed pictures, but its number of frames is 1. Get a complete copy.");
    parts[0] = file.fragments;
  } else if (file.fragments.size() == frames) {
    for (std::size_t n = 0; n < frames; ++n) parts[n] = {file.fragments[n]};
  } else {
    if (file.offsets.empty() &&
        std::size_t(std::count_if(file.fragments.begin(), file.fragments.end(), ends_stream)) == frames) {
      std::size_t frame = 0;
      for (const std::string_view fragment : file.fragments) {
        parts[std::min(frame, frames - 1)].push_back(fragment);
        if (ends_stream(fragment)) ++frame;
      }
      return parts;
    }
    // The table has the offset of each frame's first fragment, relative to the first frame.
    if (file.offsets.size() != 4 * frames)
      throw Error("its " + std::to_string(file.fragments.size()) + " compressed parts cannot be assigned to " +
                  std::to_string(frames) + " frames; it is damaged. Get a complete copy.");
    std::size_t frame = 0;
    std::uint64_t place = 0;
    for (const std::string_view fragment : file.fragments) {
      if (frame + 1 < frames && place == number_in<std::uint32_t>(file.offsets.substr(4 * (frame + 1)))) ++frame;
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

std::string kind_of(const DicomFile& file) {
  const std::string kind = file.data.text(kClass);
  return kind.empty() ? file.media_class : kind;
}

bool has_rows(const DicomFile& file) { return file.data.has(kRows); }

DicomPicture describe_picture(const DicomFile& file) {
  if (!file.has_picture) throw Error("it contains no picture; it is truncated, or a report. Get a complete copy.");
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
  picture.geometry.direction = direction_of(file, 0);
  picture.geometry.axes_assumed = numbers_of(file, 0, kPlaneOrientation, kOrientation, 6, "orientation").empty();
  const std::vector<double> place = numbers_of(file, 0, kPlanePosition, kPosition, 3, "position");
  picture.has_place = !place.empty();
  if (picture.has_place) picture.geometry.origin_mm = Vec3(place[0], place[1], place[2]);
  // The first number is the distance between rows.
  const std::vector<double> spacing = numbers_of(file, 0, kMeasures, kPixelSpacing, 2, "pixel spacing");
  if (!spacing.empty()) picture.geometry.spacing_mm = Vec3(spacing[1], spacing[0], 0);
  stack_frames(file, picture);
  // A dose keeps its unit.
  const bool dose = file.data.text(kClass) == kDoseClass;
  const bool each = file.data.sequences.contains(kFrameGroups);
  for (std::size_t n = 0; n < (each ? std::size_t(frames) : 1); ++n) {
    const std::vector<double> slope = numbers_of(file, n, kTransformation, kSlope, 1, "rescale slope"),
                              intercept = numbers_of(file, n, kTransformation, kIntercept, 1, "rescale intercept");
    if (!slope.empty() && slope[0] == 0) throw Error("its rescale slope is 0; all its values would be the same.");
    picture.padding.push_back(padding_of(file, picture, n));
    picture.scale.emplace_back(slope.empty() || dose ? 1 : slope[0], intercept.empty() || dose ? 0 : intercept[0]);
  }
  read_table(file, picture);
  picture.series = series_of(file);
  picture.kind = kind_of(file);
  return picture;
}

RawImage picture_values(const DicomFile& file, const DicomPicture& picture, const FrameDecoder& decode) {
  const auto frames = std::size_t(picture.geometry.dims[2]);
  const double needed = double(picture.frame_bytes()) * double(frames);
  RawImage image;
  image.geometry = picture.geometry;
  const bool scaled =
      !picture.table.empty() || std::any_of(picture.scale.begin(), picture.scale.end(),
                                            [](const auto& scale) { return scale != std::pair(1.0, 0.0); });
  image.type = scaled || picture.allocated < 32 ? ValueType::float32
               : picture.has_sign               ? ValueType::int32
                                                : ValueType::uint32;
  std::vector<std::vector<std::string_view>> parts;
  if (file.compressed) {
    double available = 0;
    for (const std::string_view fragment : file.fragments) available += double(fragment.size());
    if (file.syntax != kRunLengths) require_bytes(needed, available, kAnyCompression);
    parts = fragments_of_frames(file, frames);
  } else {
    require_bytes(needed, double(file.picture.size()), kNotCompressed);
    const std::string_view more = file.picture.substr(std::size_t(needed));  // writers pad the picture
    if (more.size() >= picture.frame_bytes() && more.find_first_not_of('\0') != std::string_view::npos)
      throw Error("its picture has " + std::to_string(file.picture.size()) + " bytes, but " + std::to_string(frames) +
                  (frames == 1 ? " frame of " : " frames of ") + std::to_string(picture.geometry.dims[0]) + " x " +
                  std::to_string(picture.geometry.dims[1]) + " samples need only " + format_number(needed) +
                  "; its number of frames, or its size, is wrong. Get a complete copy.");
  }
  for (std::size_t place = 0; place < frames; ++place) {
    const std::size_t n = picture.order.empty() ? place : picture.order[place];
    std::string bytes, packed;
    if (file.compressed)
      for (const std::string_view part : parts[n]) packed += part;
    if (!file.compressed)
      bytes = plain_frame(file, picture, n);
    else if (file.syntax == kRunLengths)
      bytes = unpack_rle(packed, picture.frame_samples(), std::size_t(picture.allocated) / 8);
    else
      bytes = decode(file, picture, packed);
    if (bytes.size() != picture.frame_bytes())
      throw Error("the size of its picture differs from its header; it is damaged. Get a complete copy.");
    if (picture.allocated == 8) append_frame<std::uint8_t>(bytes, picture, n, image);
    if (picture.allocated == 16) append_frame<std::uint16_t>(bytes, picture, n, image);
    if (picture.allocated == 32) append_frame<std::uint32_t>(bytes, picture, n, image);
  }
  return image;
}

}  // namespace hapticut
