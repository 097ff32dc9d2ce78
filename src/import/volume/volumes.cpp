// SPDX-License-Identifier: Apache-2.0
#include "hapticut/import/volume/volumes.hpp"

#include <optional>
#include <utility>

#include "hapticut/core/units.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "import/volume/formats.hpp"
#include "import/volume/raw_image.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

void require_no_series(const fs::path& path, const VolumeReadOptions& options) {
  if (!options.dicom_series.empty())
    cannot_read(path, "it is not a folder of DICOM files, so it has no series; leave " +
                          "VolumeReadOptions::dicom_series"_name + " out.");
}

RawImage read_folder(const fs::path& path, const VolumeReadOptions& options) {
  // Pictures next to DICOM files are previews.
  if (std::optional<RawImage> scan = read_dicom_series(path, options.dicom_series)) return *std::move(scan);
  if (!has_slices(path))
    cannot_read(path,
                "the folder has neither a DICOM series nor PNG or TIFF slices; name the folder that contains them "
                "directly, and save other pictures (JPEG, BMP) as PNG.");
  require_no_series(path, options);
  if (!options.spacing)
    cannot_read(path, "PNG and TIFF slices have no spacing; set " + "VolumeReadOptions::spacing"_name + ".");
  return read_slices(path);
}

void require_not_packed(const fs::path& path) {
  (void)readable_size(path);  // a pipe has no first bytes
  if (const std::string archive = archive_instead(first_bytes(path, 6)); !archive.empty())
    cannot_read(path, archive + "; unpack it, and name the volume in it.");
}

/// Reads data files relative to the file that names them.
DataFile data_files_beside(const fs::path& path) {
  return [folder = path.parent_path()](const std::string& name) {
    const fs::path file = folder / name;
    std::error_code code;
    if (!fs::is_regular_file(file, code)) throw Error("its data file '" + file.string() + "' cannot be opened.");
    return bytes_of_file(file);
  };
}

template <RawImage (*kParse)(std::string_view)>
RawImage read_alone(const fs::path& path) {
  return naming(path, [&] { return kParse(bytes_of_file(path)); });
}

template <RawImage (*kParse)(std::string_view, const DataFile&)>
RawImage read_with_data_files(const fs::path& path) {
  return naming(path, [&] { return kParse(bytes_of_file(path), data_files_beside(path)); });
}

struct VolumeFormat {
  std::string_view extension;  ///< in lower case, with its dot
  RawImage (*read)(const fs::path& path);
  bool is_archive = false;  ///< may be one
};

/// The formats that the extension identifies.
constexpr VolumeFormat kVolumeFormats[] = {
    {".nrrd", read_with_data_files<parse_nrrd>},      {".nhdr", read_with_data_files<parse_nrrd>},
    {".nii", read_alone<parse_nifti>, true},          {".nii.gz", read_alone<parse_nifti>, true},
    {".mhd", read_with_data_files<parse_meta_image>}, {".mha", read_with_data_files<parse_meta_image>},
    {".inv3", read_alone<parse_invesalius>, true},    {".dcm", read_dicom_file}};

RawImage read_image(const fs::path& path, const VolumeReadOptions& options) {
  if (options.spacing)
    for (int axis = 0; axis < 3; ++axis) require_positive((*options.spacing)[axis], "VolumeReadOptions::spacing [m]");
  std::error_code code;
  if (fs::is_directory(path, code)) return read_folder(path, options);
  require_no_series(path, options);
  const std::string name = lower_case(path.filename().string());
  for (const VolumeFormat& format : kVolumeFormats)
    if (name.ends_with(format.extension)) {
      if (!format.is_archive) require_not_packed(path);
      return format.read(path);
    }
  (void)readable_size(path);
  if (name.ends_with(".raw"))
    cannot_read(path, "a raw file has no header; use read_raw_grey_volume or read_raw_label_volume.");
  if (name.ends_with(".png") || name.ends_with(".tif") || name.ends_with(".tiff"))
    cannot_read(
        path,
        "a picture is one slice, even with several pages; save each page as a separate file and name the folder.");
  if (name.ends_with(".h5"))
    cannot_read(path, "it is a recording by its extension, not a volume" +
                          Sentence::clause("; use " + "read_recording"_name) + ".");
  if (is_dicom_file(path)) return read_dicom_file(path);
  require_not_packed(path);
  cannot_read(path, "its extension is not supported; volumes are " + in_one_line(volume_extensions()) +
                        ", or a folder with a DICOM series or PNG or TIFF slices; meshes are " +
                        in_one_line(kMeshExtensions) + "; workpieces are .vdb.");
}

RawImage read_raw(const fs::path& path, const RawLayout& layout) {
  for (int axis = 0; axis < 3; ++axis) require_positive(layout.spacing[axis], "RawLayout::spacing [m]");
  naming(path, [&] { require_sane_dims({double(layout.dims[0]), double(layout.dims[1]), double(layout.dims[2])}); });
  RawImage image;
  image.type = layout.type;
  image.geometry.dims = layout.dims;
  image.geometry.spacing_mm = layout.spacing / units::mm;
  const std::uint64_t needed = image.needed();
  const std::uint64_t size = readable_size(path);
  if (size < layout.skip || size - layout.skip != needed)
    cannot_read(path, "it has " + std::to_string(size) + " bytes, but its layout requires " +
                          std::to_string(layout.skip + needed) + ". Check " + "RawLayout::dims"_name + ", " +
                          "RawLayout::type"_name + " and " + "RawLayout::skip"_name + ".");
  image.bytes = bytes_of_file(path);
  image.bytes.erase(0, layout.skip);
  if (layout.big_endian) swap_bytes(image);
  return image;
}

}  // namespace

std::vector<std::string_view> volume_extensions() {
  std::vector<std::string_view> extensions;
  for (const VolumeFormat& format : kVolumeFormats) extensions.push_back(format.extension);
  return extensions;
}

GreyVolume read_grey_volume(const fs::path& path, const VolumeReadOptions& options) {
  return to_grey_volume(read_image(path, options), path, options.spacing);
}

LabelVolume read_label_volume(const fs::path& path, const VolumeReadOptions& options) {
  return to_label_volume(read_image(path, options), path, options.spacing);
}

GreyVolume read_raw_grey_volume(const fs::path& path, const RawLayout& layout) {
  return to_grey_volume(read_raw(path, layout), path, std::nullopt);
}

LabelVolume read_raw_label_volume(const fs::path& path, const RawLayout& layout) {
  return to_label_volume(read_raw(path, layout), path, std::nullopt);
}

}  // namespace hapticut
