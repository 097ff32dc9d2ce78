// SPDX-License-Identifier: Apache-2.0
#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/file_errors.hpp"
#include "io/formats.hpp"
#include "io/itk_image.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

/// While it lives, GDCM prints nothing.
class QuietGdcm {
 public:
  QuietGdcm() : warned_(gdcm::Trace::GetWarningFlag()), failed_(gdcm::Trace::GetErrorFlag()) {
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
  }
  ~QuietGdcm() {
    gdcm::Trace::SetWarning(warned_);
    gdcm::Trace::SetError(failed_);
  }
  QuietGdcm(const QuietGdcm&) = delete;
  QuietGdcm& operator=(const QuietGdcm&) = delete;

 private:
  bool warned_, failed_;
};

std::vector<std::string> files_of_series(const fs::path& folder, const std::string& wanted) {
  return with_itk(folder, [&] {
    const auto names = itk::GDCMSeriesFileNames::New();
    names->SetInputDirectory(folder.string());
    const std::vector<std::string> series = names->GetSeriesUIDs();
    if (series.empty()) cannot_read(folder, "the folder has neither a DICOM series nor PNG or TIFF slices.");
    std::string list;
    for (const std::string& uid : series) {
      list += (list.empty() ? "'" : ", '") + uid + "'";
      // Names of series may carry more than their UID, to tell apart images that do not belong together.
      if (!wanted.empty() && uid.rfind(wanted, 0) == 0) return names->GetFileNames(uid);
    }
    if (!wanted.empty()) cannot_read(folder, "it has no DICOM series '" + wanted + "'; it has " + list + ".");
    if (series.size() > 1)
      cannot_read(folder, "it has several DICOM series: " + list + ". Choose one by VolumeReadOptions::dicom_series.");
    return names->GetFileNames(series.front());
  });
}

struct Slice {
  std::string file;
  RawImage header;
  double height_mm = 0;  ///< along the normal of the slices
};

/// Checks that the slices form a regular grid and returns their distance.
double slice_distance_mm(const fs::path& folder, const std::vector<Slice>& slices) {
  const FileGeometry& first = slices.front().header.geometry;
  const double distance = (slices.back().height_mm - slices.front().height_mm) / double(slices.size() - 1);
  // Scanners round positions to hundredths of a millimetre.
  const double tolerance = std::max(0.011, 0.01 * distance);
  for (std::size_t n = 0; n < slices.size(); ++n) {
    const FileGeometry& geometry = slices[n].header.geometry;
    const std::string name = fs::path(slices[n].file).filename().string();
    if (geometry.dims != first.dims || slices[n].header.type != slices.front().header.type ||
        (geometry.spacing_mm - first.spacing_mm).head<2>().cwiseAbs().maxCoeff() > 1e-4 ||
        (geometry.direction - first.direction).cwiseAbs().maxCoeff() > 1e-3)
      cannot_read(folder, "slice '" + name + "' differs from the first one in size, spacing, direction or type.");
    const Vec3 expected = first.origin_mm + double(n) * distance * first.direction.col(2);
    const Vec3 error = geometry.origin_mm - expected;
    if (!(distance > 0) || std::abs(error.dot(first.direction.col(2))) > tolerance)
      cannot_read(folder, "its slices are not evenly spaced at '" + name +
                              "'; one is missing or there twice. Resample the series first.");
    if (error.norm() > tolerance * 2)
      cannot_read(folder, "its slices are shifted against each other (a tilted gantry). Resample the series first.");
  }
  return distance;
}

}  // namespace

RawImage read_dicom_file(const fs::path& path) {
  (void)readable_size(path);
  const QuietGdcm quiet;
  const auto io = itk::GDCMImageIO::New();
  RawImage image = read_itk_image(*io, path);
  if (image.geometry.dims[2] == 1) cannot_read(path, "it is a single slice; pass the folder of its series.");
  return image;
}

RawImage read_dicom_series(const fs::path& folder, const std::string& series) {
  const QuietGdcm quiet;
  std::vector<Slice> slices;
  for (const std::string& file : files_of_series(folder, series)) {
    const auto io = itk::GDCMImageIO::New();
    slices.push_back({file, read_itk_header(*io, file)});
    if (slices.back().header.geometry.dims[2] != 1) cannot_read(file, "it has several frames; pass the file itself.");
  }
  if (slices.size() < 2) cannot_read(folder, "its DICOM series has only one slice; a volume needs two.");
  // The normal of the slices completes a right-handed frame, whatever the order of the files.
  for (Slice& slice : slices) {
    Mat3& direction = slice.header.geometry.direction;
    direction.col(2) = direction.col(0).cross(direction.col(1));
    slice.height_mm = slice.header.geometry.origin_mm.dot(slices.front().header.geometry.direction.col(2));
  }
  std::stable_sort(slices.begin(), slices.end(),
                   [](const auto& a, const auto& b) { return a.height_mm < b.height_mm; });

  RawImage image = slices.front().header;
  image.geometry.spacing_mm.z() = slice_distance_mm(folder, slices);
  image.geometry.dims[2] = int(slices.size());
  require_sane_dims(folder, {double(image.geometry.dims[0]), double(image.geometry.dims[1]), double(slices.size())});
  for (const Slice& slice : slices) {
    const auto io = itk::GDCMImageIO::New();
    const RawImage one = read_itk_image(*io, slice.file);
    image.bytes.insert(image.bytes.end(), one.bytes.begin(), one.bytes.end());
  }
  return image;
}

}  // namespace hapticut
