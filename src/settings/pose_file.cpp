// SPDX-License-Identifier: Apache-2.0
#include "settings/pose_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "settings/csv_file.hpp"

namespace hapticut::settings {
namespace {

constexpr std::size_t kMaxPoses = 10'000'000;  // limit of a path too; each pose takes ten times the memory of its line
constexpr double kRotationTolerance = 1e-3;    // [1] well above the error of six printed digits

constexpr std::array<const char*, 4> kPlace = {"t_s", "x_mm", "y_mm", "z_mm"};
constexpr std::array<const char*, 4> kQuaternion = {"qw", "qx", "qy", "qz"};
constexpr std::array<const char*, 9> kMatrix = {"r00", "r01", "r02", "r10", "r11", "r12", "r20", "r21", "r22"};

/// Columns that say nothing about the poses: remarks, numbers of rows, and the results of --steps_csv.
const std::vector<std::string> kSkipped = {
    "comment",      "comments",     "note",         "notes",       "remark",         "label",     "name",
    "index",        "row",          "step",         "frame",       "force_x_N",      "force_y_N", "force_z_N",
    "torque_x_Nmm", "torque_y_Nmm", "torque_z_Nmm", "removed_mm3", "contact_voxels", "status"};

/// Indices of some columns; nullopt when the file has none of them.
template <std::size_t kCount>
using Columns = std::optional<std::array<std::size_t, kCount>>;

class PoseFile {
 public:
  PoseFile(CsvFile lines, const Mat3& rotation) : lines_(std::move(lines)), rotation_(rotation) {}

  std::vector<TimedPose> read() {
    std::vector<TimedPose> poses;
    std::vector<std::string> cells;
    (void)lines_.read_names("name the columns t_s, x_mm, y_mm, z_mm ...");
    find_columns();
    while (lines_.next(cells)) {
      if (poses.size() == kMaxPoses)
        fail("there are more than " + format_number(double(kMaxPoses)) + " poses; leave some out, or divide the path.");
      poses.push_back(read_pose(cells));
      if (poses.size() > 1 && !(poses.back().t > poses[poses.size() - 2].t))
        fail("t_s = " + format_number(poses.back().t) + "; times must increase from line to line.");
    }
    if (poses.size() < 2) fail("there must be at least two poses.");
    return poses;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { lines_.fail(message); }

  template <std::size_t kCount>
  Columns<kCount> find(const std::array<const char*, kCount>& wanted) const {
    std::array<std::size_t, kCount> places = {};
    std::string missing;
    std::size_t found = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (const std::optional<std::size_t> at = lines_.column(wanted[i]))
        places[i] = *at, ++found;
      else
        missing += std::string(missing.empty() ? "" : ", ") + wanted[i];
    }
    if (found == 0) return std::nullopt;
    if (found < kCount) fail("the column " + missing + " is missing.");
    return places;
  }

  void find_columns() {
    if (std::ranges::none_of(kPlace, [&](const char* name) { return lines_.column(name).has_value(); }))
      fail(
          "the columns t_s, x_mm, y_mm, z_mm are missing; the first line must name the columns, with commas, "
          "semicolons or tabs between them.");
    std::vector<std::string> known;
    known.insert(known.end(), kPlace.begin(), kPlace.end());
    known.insert(known.end(), kQuaternion.begin(), kQuaternion.end());
    known.insert(known.end(), kMatrix.begin(), kMatrix.end());
    lines_.require_known(known, kSkipped);
    place_ = *find<4>(kPlace);
    quaternion_ = find<4>(kQuaternion);
    matrix_ = find<9>(kMatrix);
    if (quaternion_ && matrix_) fail("the file has a quaternion and a matrix; leave one of them out.");
  }

  TimedPose read_pose(const std::vector<std::string>& cells) {
    const auto number = [&](std::size_t column) { return lines_.number_at(cells, column); };
    const double t = number(place_[0]);
    const Vec3 position = Vec3(number(place_[1]), number(place_[2]), number(place_[3])) * units::mm;
    return {t, {read_rotation(number), position}};
  }

  template <class Number>
  Mat3 read_rotation(const Number& number) const {
    if (quaternion_) {
      const auto& q = *quaternion_;
      const Eigen::Quaterniond given(number(q[0]), number(q[1]), number(q[2]), number(q[3]));
      if (std::abs(given.norm() - 1) > kRotationTolerance)
        fail("the quaternion has length " + format_number(given.norm(), 1) + "; must be 1.");
      return given.normalized().toRotationMatrix();
    }
    if (!matrix_) return rotation_;
    Mat3 given;
    for (std::size_t i = 0; i < 9; ++i) given(Eigen::Index(i / 3), Eigen::Index(i % 3)) = number((*matrix_)[i]);
    if (!is_rotation(given, kRotationTolerance))
      fail("r00 ... r22 is not a rotation; its rows must be orthonormal and right-handed.");
    return orthonormalized(given);
  }

  CsvFile lines_;
  Mat3 rotation_;
  std::array<std::size_t, 4> place_ = {};
  Columns<4> quaternion_;
  Columns<9> matrix_;
};

}  // namespace

std::vector<TimedPose> read_poses(const std::filesystem::path& path, const Mat3& rotation) {
  return PoseFile(CsvFile(path, "file of poses", "path.file"_name), rotation).read();
}

std::vector<TimedPose> poses_of_text(std::string text, std::string name, const Mat3& rotation) {
  return PoseFile(CsvFile(std::move(text), std::move(name)), rotation).read();
}

}  // namespace hapticut::settings
