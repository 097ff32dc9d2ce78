// SPDX-License-Identifier: Apache-2.0
#include "import/volume/raw_image.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "hapticut/build/volume_operations.hpp"
#include "hapticut/core/units.hpp"
#include "import/volume/formats.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

/// Converts each value; `convert` may throw.
template <class Value, class Convert>
void convert_values(const RawImage& image, std::vector<Value>& values, const Convert& convert) {
  with_value_type(image.type, [&](auto zero) {
    using Stored = decltype(zero);
    for (std::size_t n = 0; n < values.size(); ++n) {
      if (image.is_padding(n)) continue;
      Stored stored;
      std::memcpy(&stored, image.bytes.data() + n * sizeof stored, sizeof stored);
      values[n] = convert(stored);
    }
  });
}

/// Sets padding to a value without material: air in Hounsfield units, or the lowest value of the scan if that is lower.
/// Padded labels are 0 already.
void fill_padding(const RawImage& image, GreyVolume& volume) {
  float air = -1000;
  for (std::size_t n = 0; n < volume.values.size(); ++n)
    if (!image.is_padding(n)) air = std::min(air, volume.values[n]);  // NaN compares false
  for (std::size_t n = 0; n < volume.values.size(); ++n)
    if (image.is_padding(n)) volume.values[n] = air;
}

/// @throws Error unless the directions of the axes are perpendicular unit vectors, apart from rounding. Removes the
///         rounding.
Mat3 directions_in(const FileGeometry& geometry, const std::filesystem::path& path) {
  const Vec3 lengths = geometry.direction.colwise().norm();
  const Mat3 unit = geometry.direction * lengths.cwiseInverse().asDiagonal();
  const Mat3 cosines = unit.transpose() * unit - Mat3::Identity();
  if (!(cosines.cwiseAbs().maxCoeff() < kMaxRounding))
    cannot_read(path, "its axes are not perpendicular; resample it to a regular grid first.");
  if (!((lengths.array() - 1).abs().maxCoeff() < 2 * kMaxRounding))
    cannot_read(path, "the directions of its axes are not of length 1. Check its header.");
  return orthonormalized(unit);
}

/// Reverses a left-handed grid along z: the last slice becomes the first, and no sample moves.
template <class Value>
void turn_round_z(Volume<Value>& volume, FileGeometry& geometry) {
  const int last = volume.dims[2] - 1;
  const auto slice = [&](int k) { return volume.values.begin() + std::ptrdiff_t(volume.offset(0, 0, k)); };
  for (int k = 0; k < volume.dims[2] / 2; ++k) std::swap_ranges(slice(k), slice(k + 1), slice(last - k));
  geometry.origin_mm += geometry.direction.col(2) * (last * geometry.spacing_mm.z());
  geometry.direction.col(2) *= -1;
}

template <class Value, class Convert>
Volume<Value> to_volume(const RawImage& image, const std::filesystem::path& path, const std::optional<Vec3>& spacing,
                        const Convert& convert) {
  FileGeometry geometry = image.geometry;
  if (!geometry.unknown_unit.empty() && !spacing)
    cannot_read(path, "its unit " + in_quotes(geometry.unknown_unit) +
                          " is not known; write m, cm, mm, um or nm into its header, or set " +
                          "VolumeReadOptions::spacing"_name + ".");
  for (int axis = 0; axis < 3; ++axis)  // a negative spacing mirrors the axis, also when the caller gives its length
    if (geometry.spacing_mm[axis] < 0) {
      geometry.spacing_mm[axis] *= -1;
      geometry.direction.col(axis) *= -1;
    }
  // The caller's spacing also defines the length of an unknown unit.
  if (!geometry.unknown_unit.empty()) geometry.origin_mm *= spacing->norm() / units::mm / geometry.spacing_mm.norm();
  if (!geometry.direction.allFinite())
    cannot_read(path,
                "the direction of one of its axes is zero or not a number. Write the directions of three axes into its "
                "header.");
  if (spacing) geometry.spacing_mm = *spacing / units::mm;
  if (!is_finite(geometry.spacing_mm) || !(geometry.spacing_mm.minCoeff() > 0))
    cannot_read(path, "it lacks the spacing of its samples (" + format_number(geometry.spacing_mm.x()) + " x " +
                          format_number(geometry.spacing_mm.y()) + " x " + format_number(geometry.spacing_mm.z()) +
                          " mm); set " + "VolumeReadOptions::spacing"_name + ".");
  if (!is_finite(geometry.origin_mm)) cannot_read(path, "its origin is not finite. Check its header.");
  const Vec3 extent = Vec3(geometry.dims[0], geometry.dims[1], geometry.dims[2]).cwiseProduct(geometry.spacing_mm);
  constexpr double kMaxLength = 1e5;  // [mm]
  if (!(extent.maxCoeff() <= kMaxLength))
    cannot_read(path, "it is " + format_number(extent.maxCoeff() * 1e-3, kMaxLength * 1e-3) + " m long; at most " +
                          format_number(kMaxLength * 1e-3) + " m are allowed. Check its spacing, or set another one.");
  constexpr double kMaxDistance = 1e9;  // [mm]
  if (!(geometry.origin_mm.cwiseAbs().maxCoeff() <= kMaxDistance))
    cannot_read(path, "its origin is more than " + format_number(kMaxDistance * 1e-3) + " m away. Check its header.");
  geometry.direction = directions_in(geometry, path);

  Volume<Value> volume;
  volume.dims = geometry.dims;
  volume.values.resize(volume.size());
  convert_values(image, volume.values, convert);
  volume.padding = std::size_t(std::count(image.padding.begin(), image.padding.end(), true));
  if constexpr (std::is_same_v<Value, float>)
    if (volume.padding > 0) fill_padding(image, volume);
  if (geometry.direction.determinant() < 0) turn_round_z(volume, geometry);
  volume.spacing = geometry.spacing_mm * units::mm;
  volume.X_WG = {geometry.direction, geometry.origin_mm * units::mm};
  volume.remarks = image.remarks;
  if (geometry.axes_assumed)
    volume.remarks.push_back("'" + path.string() +
                             "' does not say how its axes lie in the patient; they are taken for left, back and head.");
  return volume;
}

/// [bytes] What a copy as a text may have put before the line feeds of binary data: the number of line feeds, if a
/// carriage return precedes each; else 0.
std::size_t added_returns(std::string_view data) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = data.find('\n', at)) != std::string_view::npos; ++at, ++count)
    if (at == 0 || data[at - 1] != '\r') return 0;
  return count;
}

}  // namespace

void require_sane_dims(const std::array<double, 3>& dims) {
  const auto text = [](double n) { return format_number(n, std::round(n)); };
  const std::string claim = text(dims[0]) + " x " + text(dims[1]) + " x " + text(dims[2]);
  for (const double n : dims)
    if (!(n >= 1) || n != std::floor(n))
      throw Error("it claims " + claim +
                  " samples; there must be a whole number of them along every axis, at least 1.");
  if (!(dims[0] * dims[1] * dims[2] <= double(kMaxVolumeSamples)))
    throw Error("it claims " + claim + " samples; at most " + format_number(double(kMaxVolumeSamples)) +
                " are supported. Crop or downsample it first.");
}

void require_dimensions(double dimensions, double max_dimensions) {
  if (!(dimensions >= 3 && dimensions <= max_dimensions))
    throw Error("it has " + format_number(dimensions) +
                " dimensions; a volume has three. Extract one volume from it, or combine its slices.");
}

void require_one_volume(double samples) {
  if (samples != 1)
    throw Error("it has " + format_number(samples) + " volumes or values per sample; extract one volume first.");
}

void require_bytes(double needed, double available, double best_ratio) {
  const bool compressed = best_ratio > kNotCompressed;
  if (needed > available * best_ratio + (compressed ? 1024 : 0))
    throw Error("its header claims " + format_number(needed) + " bytes of data, but there are only " +
                format_number(available) + (compressed ? " compressed ones." : ".") + " Is it truncated?");
}

void require_no_more(std::uint64_t claimed, std::string_view data, std::uint64_t slice, bool same_file) {
  if (data.size() <= claimed) return;
  constexpr std::uint64_t kFew = 64;  // [bytes]
  const std::string_view more = data.substr(std::size_t(claimed));
  if (const std::size_t added = added_returns(data); added == more.size())
    throw Error("it was copied as a text, which has put " + std::to_string(added) + (added == 1 ? " byte" : " bytes") +
                " (CR) among its values. Copy it as binary data.");
  const bool zeros = more.find_first_not_of('\0') == std::string_view::npos,
             blank = more.find_first_not_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos,
             few = more.size() < std::max(slice, kFew);
  if (same_file ? !blank : !few || !zeros)
    throw Error("its header claims " + std::to_string(claimed) + " bytes of data, but there are " +
                std::to_string(data.size()) + ". Check the type and the sizes that it names.");
}

void swap_bytes(RawImage& image) {
  const auto size = std::ptrdiff_t(size_of(image.type));
  for (auto at = image.bytes.begin(); at != image.bytes.end(); at += size) std::reverse(at, at + size);
}

GreyVolume to_grey_volume(const RawImage& image, const std::filesystem::path& path,
                          const std::optional<Vec3>& spacing) {
  return to_volume<float>(image, path, spacing, [&](auto value) {
    const auto grey = double(value);
    if (std::abs(grey) > double(std::numeric_limits<float>::max()))  // not of what is no number
      cannot_read(path, "it has the value " + format_number(grey) +
                            ", which is too large for a grey value. Check its type and byte order.");
    return float(value);
  });
}

LabelVolume to_label_volume(const RawImage& image, const std::filesystem::path& path,
                            const std::optional<Vec3>& spacing) {
  return to_volume<std::uint16_t>(image, path, spacing, [&](auto value) {
    const double given = double(value), label = std::round(given);
    if (!(label >= 0 && label <= 65535 && std::abs(given - label) <= kLabelRounding))
      cannot_read(path, "it has the value " + format_number(given, label) +
                            ", but labels are whole numbers from 0 to 65535. Read it as a grey volume instead.");
    return std::uint16_t(label);
  });
}

}  // namespace hapticut
