// SPDX-License-Identifier: Apache-2.0
#include <gdcmSerieHelper.h>
#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "io/file_errors.hpp"
#include "io/volume/dicom_check.hpp"
#include "io/volume/formats.hpp"
#include "io/volume/itk_image.hpp"

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

/// The files of a folder by series. GDCM's own search would read whatever else lies there.
class SeriesFinder : public gdcm::SerieHelper {
 public:
  explicit SeriesFinder(const fs::path& folder) {
    SetUseSeriesDetails(true);  // images of another size, spacing or direction are another series
    CreateDefaultUniqueSeriesIdentifier();
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code))
      if (entry.is_regular_file(code) && looks_like_dicom(entry.path())) files.push_back(entry.path());
    if (code) cannot_read(folder, code.message() + ".");
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      require_sound_dicom(file);
      AddFileName(file.string());
    }
    for (gdcm::FileList* list = GetFirstSingleSerieUIDFileSet(); list != nullptr;
         list = GetNextSingleSerieUIDFileSet()) {
      if (list->empty()) continue;
      std::vector<std::string>& names = series_[CreateUniqueSeriesIdentifier(list->front())];
      for (const auto& file : *list) names.push_back(file->filename);
    }
  }

  [[nodiscard]] const std::map<std::string, std::vector<std::string>>& series() const { return series_; }

 private:
  std::map<std::string, std::vector<std::string>> series_;
};

std::vector<std::string> files_of_series(const fs::path& folder, const std::string& wanted) {
  return with_itk(folder, [&] {
    const SeriesFinder finder(folder);
    if (finder.series().empty()) cannot_read(folder, "the folder has neither a DICOM series nor PNG or TIFF slices.");
    std::string list;
    for (const auto& [uid, names] : finder.series()) {
      list += (list.empty() ? "'" : ", '") + uid + "'";
      // Names of series may carry more than their UID, to tell apart images that do not belong together.
      if (!wanted.empty() && uid.rfind(wanted, 0) == 0) return names;
    }
    if (!wanted.empty()) cannot_read(folder, "it has no DICOM series '" + wanted + "'; it has " + list + ".");
    if (finder.series().size() > 1)
      cannot_read(folder, "it has several DICOM series: " + list + ". Choose one by VolumeReadOptions::dicom_series.");
    return finder.series().begin()->second;
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
    if (!(distance > 0) || !(std::abs(error.dot(first.direction.col(2))) <= tolerance))
      cannot_read(folder, "its slices are not evenly spaced at '" + name +
                              "'; one is missing or there twice. Resample the series first.");
    if (!(error.norm() <= tolerance * 2))
      cannot_read(folder, "its slices are shifted against each other (a tilted gantry). Resample the series first.");
  }
  return distance;
}

/// The values of a file whose header does not claim more of them than it can hold.
RawImage read_dicom_values(const fs::path& path) {
  const auto available = double(readable_size(path));
  const auto io = itk::GDCMImageIO::New();
  (void)read_itk_header(*io, path);
  require_bytes(path, double(io->GetImageSizeInBytes()), available, kAnyCompression);
  return read_itk_image(*io, path);
}

}  // namespace

RawImage read_dicom_file(const fs::path& path) {
  require_sound_dicom(path);
  const QuietGdcm quiet;
  RawImage image = read_dicom_values(path);
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
    const RawImage one = read_dicom_values(slice.file);
    image.bytes.insert(image.bytes.end(), one.bytes.begin(), one.bytes.end());
  }
  return image;
}

}  // namespace hapticut
