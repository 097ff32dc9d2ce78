// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "import/volume/formats.hpp"
#include "import/volume/unpack.hpp"
#include "io/byte_reader.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

constexpr std::size_t kNifti1 = 348, kNifti2 = 540;  // [bytes] sizes of the headers
constexpr std::size_t kExtensions = 4;  // [bytes] after the header, which tell whether there are extensions

/// A NIfTI header, in the units of the file.
struct NiftiHeader {
  bool swapped = false;
  int version = 1;
  std::array<double, 8> dim{}, pixdim{};  ///< [0]: number of dimensions; handedness of the quaternion
  int type = 0;
  double offset = 0;  ///< [bytes] position of the values
  double slope = 0, intercept = 0;
  int units = 0, qform = 0, sform = 0;  ///< codes
  std::array<double, 6> quaternion{};   ///< b, c, d, and the position of the first sample
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor | Eigen::DontAlign> rows;
};

/// Reads the fields of a header by their positions.
class NiftiFields {
 public:
  NiftiFields(std::string_view bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}

  template <class Number>
  [[nodiscard]] Number at(std::size_t place) const {
    return number_in<Number>(bytes_.substr(place, sizeof(Number)), swapped_);
  }

  template <class Number, class Numbers>
  void read(std::size_t place, Numbers& numbers) const {
    for (auto& number : numbers) {
      number = double(at<Number>(place));
      place += sizeof(Number);
    }
  }

 private:
  std::string_view bytes_;
  bool swapped_;
};

/// By the NIfTI standard, an offset below the minimum means the minimum, e.g. 0 or 348 mean 352.
double at_least(double offset, std::size_t least) { return offset < double(least) ? double(least) : offset; }

NiftiHeader parse_nifti_header(std::string_view bytes) {
  if (bytes.size() < kNifti1) throw Error("it is too short for a NIfTI header. Get a complete copy.");
  for (const bool swapped : {false, true}) {
    const NiftiFields fields(bytes, swapped);
    NiftiHeader h;
    h.swapped = swapped;
    auto rows = h.rows.reshaped<Eigen::RowMajor>();
    const auto length = fields.at<std::int32_t>(0);
    if (length == std::int32_t(kNifti1)) {
      const std::string_view magic = bytes.substr(344, 4);
      if (magic == std::string_view("ni1\0", 4)) throw Error("its values are in another file; save both as one .nii.");
      if (magic != std::string_view("n+1\0", 4)) throw Error("it has the header of an ANALYZE file; save it as NIfTI.");
      fields.read<std::int16_t>(40, h.dim);
      h.type = fields.at<std::int16_t>(70);
      fields.read<float>(76, h.pixdim);
      h.offset = at_least(double(fields.at<float>(108)), kNifti1 + kExtensions);
      h.slope = double(fields.at<float>(112));
      h.intercept = double(fields.at<float>(116));
      h.units = fields.at<std::uint8_t>(123);
      h.qform = fields.at<std::int16_t>(252);
      h.sform = fields.at<std::int16_t>(254);
      fields.read<float>(256, h.quaternion);
      fields.read<float>(280, rows);
      return h;
    }
    if (length == std::int32_t(kNifti2) && bytes.size() >= kNifti2) {
      if (bytes.substr(4, 4) != std::string_view("n+2\0", 4))
        throw Error("its values are in another file, or its header is damaged; save it as one .nii.");
      h.version = 2;
      h.type = fields.at<std::int16_t>(12);
      fields.read<std::int64_t>(16, h.dim);
      fields.read<double>(104, h.pixdim);
      h.offset = at_least(double(fields.at<std::int64_t>(168)), kNifti2 + kExtensions);
      h.slope = fields.at<double>(176);
      h.intercept = fields.at<double>(184);
      h.qform = fields.at<std::int32_t>(344);
      h.sform = fields.at<std::int32_t>(348);
      fields.read<double>(352, h.quaternion);
      fields.read<double>(400, rows);
      h.units = fields.at<std::int32_t>(500);
      return h;
    }
  }
  throw Error("it is not a NIfTI file.");
}

ValueType type_of_nifti(int code) {
  using enum ValueType;
  static constexpr std::pair<int, ValueType> kTypes[] = {{2, uint8},    {4, int16},    {8, int32},    {16, float32},
                                                         {64, float64}, {256, int8},   {512, uint16}, {768, uint32},
                                                         {1024, int64}, {1280, uint64}};
  if (const ValueType* type = found_in(kTypes, code)) return *type;
  throw Error("its values are of type " + std::to_string(code) +
              ", which is not supported; save it as grey values or labels.");
}

Mat3 rotation_of(const NiftiHeader& h) {
  const double b = h.quaternion[0], c = h.quaternion[1], d = h.quaternion[2];
  const double square = b * b + c * c + d * d;
  // Rounding may give slightly more than 1 for a rotation by 180 degrees.
  const Eigen::Quaterniond q(std::sqrt(std::max(0.0, 1 - square)), b, c, d);
  return q.normalized().toRotationMatrix();
}

/// The pose of the grid: from the affine map if the file has a nonzero one, else from the quaternion, else along the
/// axes of the patient with the first sample at the origin.
FileGeometry geometry_of_nifti(const NiftiHeader& h) {
  FileGeometry geometry;
  for (std::size_t axis = 0; axis < 3; ++axis) geometry.dims[axis] = int(h.dim[axis + 1]);
  const Vec3 pixdim(h.pixdim[1], h.pixdim[2], h.pixdim[3]);
  geometry.spacing_mm = pixdim;
  const Mat3 axes = h.rows.leftCols<3>();
  const bool has_map = h.sform > 0 && axes != Mat3::Zero();
  // Programs differ: some take the absolute value, some mirror the axis, some take 1.
  if (!has_map && pixdim.minCoeff() < 0)
    throw Error("its spacing (pixdim) is " + format_number(pixdim.x()) + " x " + format_number(pixdim.y()) + " x " +
                format_number(pixdim.z()) +
                "; a spacing must be positive. Write it so, and an affine map (sform) that tells whether an axis is "
                "mirrored.");
  // In files, x points right and y to the front.
  const Vec3 signs(-1, -1, 1);
  if (has_map) {
    geometry.set_axes(signs.asDiagonal() * axes);
    geometry.origin_mm = signs.cwiseProduct(Vec3(h.rows.col(3)));
  } else if (h.qform > 0) {
    geometry.direction = signs.asDiagonal() * rotation_of(h);
    if (h.pixdim[0] < 0) geometry.direction.col(2) *= -1;
    geometry.origin_mm = signs.cwiseProduct(Vec3(h.quaternion[3], h.quaternion[4], h.quaternion[5]));
  } else {
    geometry.axes_assumed = true;
  }
  constexpr int kMetre = 1, kMicron = 3, kSpace = 7;
  geometry.scale((h.units & kSpace) == kMetre ? 1e3 : (h.units & kSpace) == kMicron ? 1e-3 : 1);
  return geometry;
}

double bytes_needed(const NiftiHeader& h) {
  require_dimensions(h.dim[0], 7);
  require_sane_dims({h.dim[1], h.dim[2], h.dim[3]});
  for (std::size_t n = 4; n <= std::size_t(h.dim[0]); ++n) require_one_volume(std::max(1.0, h.dim[n]));
  if (h.offset != std::floor(h.offset) || !std::isfinite(h.offset))
    throw Error("its values would begin at byte " + format_number(h.offset) + "; it is damaged. Get a complete copy.");
  return h.offset + h.dim[1] * h.dim[2] * h.dim[3] * double(size_of(type_of_nifti(h.type)));
}

/// @throws Error when the values would begin where the file has extensions, which then are read as values
void require_room_for_extensions(const NiftiHeader& h, std::string_view bytes) {
  constexpr double kLeast = 16;  // [bytes] size of an extension
  const std::size_t end = h.version == 1 ? kNifti1 : kNifti2;
  if (bytes[end] != 0 && h.offset < double(end + kExtensions) + kLeast)
    throw Error("it has extensions behind its header (its byte " + std::to_string(end) + " is not 0), but its values " +
                "begin at byte " + format_number(h.offset) +
                ", too. Write the position of the values into its header (vox_offset), or 0 into that byte if it has " +
                "no extensions.");
}

/// Applies the scale of the file; a slope of 0 means no scale.
void scale(const NiftiHeader& h, RawImage& image) {
  if (h.slope == 0 || !std::isfinite(h.slope) || (h.slope == 1 && h.intercept == 0)) return;
  if (!std::isfinite(h.intercept)) throw Error("the offset of its values is not a finite number.");
  std::string scaled;
  scaled.reserve(image.bytes.size() / size_of(image.type) * sizeof(float));
  with_value_type(image.type, [&](auto stored) {
    for (std::size_t from = 0; from < image.bytes.size(); from += sizeof stored) {
      std::memcpy(&stored, image.bytes.data() + from, sizeof stored);
      append_bytes_of(scaled, float(double(stored) * h.slope + h.intercept));
    }
  });
  image.bytes = std::move(scaled);
  image.type = ValueType::float32;
}

RawImage parse_unpacked(std::string_view bytes) {
  const NiftiHeader header = parse_nifti_header(bytes);
  const double needed = bytes_needed(header);
  require_bytes(needed, double(bytes.size()), kNotCompressed);
  require_room_for_extensions(header, bytes);
  RawImage image;
  image.type = type_of_nifti(header.type);
  image.geometry = geometry_of_nifti(header);
  require_no_more(std::uint64_t(needed), bytes, image.needed() / std::uint64_t(image.geometry.dims[2]), true);
  image.bytes = bytes.substr(std::size_t(header.offset), image.needed());
  if (header.swapped) swap_bytes(image);
  scale(header, image);
  return image;
}

}  // namespace

RawImage parse_nifti(std::string_view bytes) {
  if (!bytes.starts_with("\x1f\x8b")) return parse_unpacked(bytes);
  const double needed = bytes_needed(parse_nifti_header(start_of_gzip(bytes, kNifti2)));
  require_bytes(needed, double(bytes.size()), kDeflate);
  return parse_unpacked(
      unpack_gzip(bytes, 2 * std::uint64_t(needed) + (1U << 20U)));  // with what may follow the values
}

}  // namespace hapticut
