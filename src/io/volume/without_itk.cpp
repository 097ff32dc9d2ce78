// SPDX-License-Identifier: Apache-2.0
// What stands in the library for everything that needs ITK, where it was built without it.
#include "hapticut/core/errors.hpp"
#include "hapticut/io/volume/volume_filters.hpp"
#include "io/file_errors.hpp"
#include "io/volume/formats.hpp"

namespace hapticut {
namespace {

const std::string kNeedsItk =
    " needs ITK, which this build of hapticut is without; install libinsighttoolkit5-dev and build it with "
    "HAPTICUT_WITH_ITK=ON.";

[[noreturn]] void cannot_do(const std::string& what) { throw Error(what + kNeedsItk); }

}  // namespace

RawImage read_nrrd(const std::filesystem::path& path) { cannot_read(path, "reading NRRD files" + kNeedsItk); }

RawImage read_nifti(const std::filesystem::path& path) { cannot_read(path, "reading NIfTI files" + kNeedsItk); }

RawImage read_dicom_file(const std::filesystem::path& path) { cannot_read(path, "reading DICOM files" + kNeedsItk); }

RawImage read_dicom_series(const std::filesystem::path& folder, const std::string&) {
  cannot_read(folder, "it has no PNG or TIFF slices, and reading DICOM files" + kNeedsItk);
}

GreyVolume resample(const GreyVolume&, double) { cannot_do("resampling a volume"); }

LabelVolume resample(const LabelVolume&, double, LabelInterpolation) { cannot_do("resampling a volume"); }

LabelVolume close_gaps(LabelVolume, double, std::uint16_t) { cannot_do("closing gaps"); }

}  // namespace hapticut
