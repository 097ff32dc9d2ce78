// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/volume/volumes.hpp"

#include <optional>
#include <utility>

#include "hapticut/core/units.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"
#include "io/volume/formats.hpp"
#include "io/volume/raw_image.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

void require_no_series(const fs::path& path, const VolumeReadOptions& options) {
  if (!options.dicom_series.empty())
    cannot_read(path,
                "it is no folder of DICOM files, so it has no series to choose; leave "
                "VolumeReadOptions::dicom_series out.");
}

RawImage read_folder(const fs::path& path, const VolumeReadOptions& options) {
  // Pictures beside DICOM files are previews of them.
  if (std::optional<RawImage> scan = read_dicom_series(path, options.dicom_series)) return *std::move(scan);
  if (!has_slices(path))
    cannot_read(path,
                "the folder has neither a DICOM series nor PNG or TIFF slices; pass the folder that they lie in "
                "themselves, and save pictures of another format (JPEG, BMP) as PNG.");
  require_no_series(path, options);
  if (!options.spacing)
    cannot_read(path, "PNG and TIFF slices do not say how far apart they are; set VolumeReadOptions::spacing.");
  return read_slices(path);
}

/// Gives the content of files beside the one that names them.
DataFile data_files_beside(const fs::path& path) {
  return [folder = path.parent_path()](const std::string& name) {
    const fs::path file = folder / name;
    std::error_code code;
    if (!fs::is_regular_file(file, code)) throw Error("its data file '" + file.string() + "' cannot be opened.");
    return bytes_of_file(file);
  };
}

template <class Parse>
RawImage read_whole(const fs::path& path, const Parse& parse) {
  return naming(path, [&] { return parse(bytes_of_file(path)); });
}

RawImage read_image(const fs::path& path, const VolumeReadOptions& options) {
  if (options.spacing)
    for (int axis = 0; axis < 3; ++axis) require_positive((*options.spacing)[axis], "VolumeReadOptions::spacing [m]");
  std::error_code code;
  if (fs::is_directory(path, code)) return read_folder(path, options);
  require_no_series(path, options);
  const std::string name = lower_case(path.filename().string());
  const DataFile beside = data_files_beside(path);
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr"))
    return read_whole(path, [&](const std::string& file) { return parse_nrrd(file, beside); });
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return read_whole(path, parse_nifti);
  if (name.ends_with(".mhd") || name.ends_with(".mha"))
    return read_whole(path, [&](const std::string& file) { return parse_meta_image(file, beside); });
  if (name.ends_with(".inv3")) return read_whole(path, parse_invesalius);
  if (name.ends_with(".dcm")) return read_dicom_file(path);
  (void)readable_size(path);
  if (name.ends_with(".raw"))
    cannot_read(path, "a raw file does not say how large it is; use read_raw_grey_volume or read_raw_label_volume.");
  if (name.ends_with(".png") || name.ends_with(".tif") || name.ends_with(".tiff"))
    cannot_read(path,
                "a picture is one slice, also where it has several pages; save each page as a file of its own, and "
                "give their folder.");
  if (name.ends_with(".h5"))
    cannot_read(path, "its ending is that of a recording, which is no volume; use read_recording.");
  if (is_dicom_file(path)) return read_dicom_file(path);
  cannot_read(path,
              "its ending is not that of a format that is read: .nrrd .nhdr .nii .nii.gz .mhd .mha .inv3 .dcm, or a "
              "folder with a DICOM series or with PNG or TIFF slices; as a mesh .stl .ply .obj .off .gltf .glb, as a "
              "workpiece .vdb.");
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
    cannot_read(path, "it has " + std::to_string(size) + " bytes, but its layout asks for " +
                          std::to_string(layout.skip + needed) +
                          ". Check RawLayout::dims, RawLayout::type and RawLayout::skip.");
  image.bytes = bytes_of_file(path);
  image.bytes.erase(0, layout.skip);
  if (layout.big_endian) swap_bytes(image);
  return image;
}

}  // namespace

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
