// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "io/dicom/codec_process.hpp"
#include "io/dicom/dicom_picture.hpp"
#include "io/file_errors.hpp"
#include "io/volume/formats.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

std::string bytes_of_file(const fs::path& path) { return first_bytes(path, std::size_t(readable_size(path))); }

/// A slice of a series. Its values are read when all slices are known to belong together.
struct DicomSlice {
  fs::path path;
  DicomPicture picture;
};

bool alike(const DicomPicture& a, const DicomPicture& b) {
  return a.geometry.dims == b.geometry.dims && a.allocated == b.allocated &&
         (a.geometry.spacing_mm - b.geometry.spacing_mm).head<2>().cwiseAbs().maxCoeff() <= 1e-4 &&
         (a.geometry.direction - b.geometry.direction).cwiseAbs().maxCoeff() <= 1e-3;
}

/// The pictures of a folder by series; images of another size, spacing or direction are another series, whose name has
/// a number behind the UID. Files without a picture (directories, reports) are left out.
std::map<std::string, std::vector<DicomSlice>> series_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (entry.is_regular_file(code) && begins_like_dicom(first_bytes(entry.path(), 132))) files.push_back(entry.path());
  if (code) cannot_read(folder, code.message() + ".");
  std::sort(files.begin(), files.end());
  std::map<std::string, std::vector<DicomSlice>> series;
  for (const fs::path& path : files) {
    const std::string bytes = bytes_of_file(path);
    try {
      DicomSlice slice = {path, describe_picture(parse_dicom(bytes))};
      std::string name = slice.picture.series;
      for (int n = 1; series.contains(name) && !alike(series[name].front().picture, slice.picture); ++n)
        name = slice.picture.series + "." + std::to_string(n);
      series[name].push_back(std::move(slice));
    } catch (const Error& error) {
      if (!std::string_view(error.what()).starts_with(kNoDicomPicture)) cannot_read(path, error.what());
    }
  }
  return series;
}

std::vector<DicomSlice> slices_of_series(const fs::path& folder, const std::string& wanted) {
  std::map<std::string, std::vector<DicomSlice>> series = series_in(folder);
  if (series.empty()) cannot_read(folder, "the folder has neither a DICOM series nor PNG or TIFF slices.");
  std::string list;
  for (auto& [uid, slices] : series) {
    list += (list.empty() ? "'" : ", '") + uid + "'";
    if (!wanted.empty() && uid == wanted) return std::move(slices);
  }
  if (!wanted.empty()) cannot_read(folder, "it has no DICOM series '" + wanted + "'; it has " + list + ".");
  if (series.size() > 1)
    cannot_read(folder, "it has several DICOM series: " + list + ". Choose one by VolumeReadOptions::dicom_series.");
  return std::move(series.begin()->second);
}

FrameDecoder decoder_in(CodecProcess& process) {
  return
      [&process](const DicomFile& file, const DicomPicture& picture, const std::vector<std::string_view>& fragments) {
        return process.unpack(file, picture, fragments);
      };
}

}  // namespace

RawImage read_dicom_file(const fs::path& path) {
  const std::string bytes = bytes_of_file(path);
  CodecProcess process;
  return naming(path, [&] {
    const DicomFile file = parse_dicom(bytes);
    const DicomPicture picture = describe_picture(file);
    if (picture.geometry.dims[2] == 1) throw Error("it is a single slice; pass the folder of its series.");
    return picture_values(file, picture, decoder_in(process));
  });
}

RawImage read_dicom_series(const fs::path& folder, const std::string& series) {
  std::vector<DicomSlice> slices = slices_of_series(folder, series);
  for (const DicomSlice& slice : slices)
    if (slice.picture.geometry.dims[2] != 1) cannot_read(slice.path, "it has several frames; pass the file itself.");
  if (slices.size() < 2) cannot_read(folder, "its DICOM series has only one slice; a volume needs two.");
  std::vector<Vec3> places;
  for (const DicomSlice& slice : slices) {
    if (!slice.picture.has_place)
      cannot_read(slice.path, "it does not say where it lies. Save the series in one file.");
    places.push_back(slice.picture.geometry.origin_mm);
  }
  RawImage image;
  image.geometry = slices.front().picture.geometry;
  image.geometry.dims[2] = int(slices.size());
  require_sane_dims(folder, {double(image.geometry.dims[0]), double(image.geometry.dims[1]), double(slices.size())});
  const auto name = [&](std::size_t n) { return "'" + slices[n].path.filename().string() + "'"; };
  const auto order = naming(folder, [&] { return stack_planes(places, "slices", name, image.geometry); });
  CodecProcess process;
  for (const std::size_t n : order) {
    const DicomSlice& slice = slices[n];
    const std::string bytes = bytes_of_file(slice.path);
    const RawImage one =
        naming(slice.path, [&] { return picture_values(parse_dicom(bytes), slice.picture, decoder_in(process)); });
    if (n != order.front() && one.type != image.type)
      cannot_read(slice.path, "it differs from the first slice in the type of its values.");
    image.type = one.type;
    const std::size_t first = image.bytes.size() / size_of(image.type);
    for (std::size_t sample = 0; sample < one.padding.size(); ++sample)
      if (one.padding[sample]) image.mark_padding(first + sample);
    image.bytes.insert(image.bytes.end(), one.bytes.begin(), one.bytes.end());
  }
  return image;
}

}  // namespace hapticut
