// SPDX-License-Identifier: Apache-2.0
// A fuzzer of one format, FUZZ_FORMAT: passes libFuzzer's bytes to the parser. Parsers report damage by throwing Error;
// anything else is a finding.
#include <cstdint>
#include <string>
#include <string_view>

#include "hapticut/core/errors.hpp"
#include "import/dicom/dicom_picture.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "import/volume/formats.hpp"

namespace hapticut::test {
namespace {

[[maybe_unused]] void fuzz_dicom(std::string_view bytes) {
  const DicomFile file = parse_dicom(bytes);
  const DicomPicture picture = describe_picture(file);
  (void)picture_values(file, picture, [](const auto&, const DicomPicture& p, std::string_view packed) {
    if (!packed.empty()) require_jpeg_2000_of(packed, p);
    return std::string(p.frame_bytes(), '\0');
  });
}

[[maybe_unused]] void fuzz_nrrd(std::string_view bytes) {
  (void)parse_nrrd(bytes, [&](const std::string&) { return std::string(bytes); });
}

[[maybe_unused]] void fuzz_nifti(std::string_view bytes) { (void)parse_nifti(bytes); }
[[maybe_unused]] void fuzz_meta(std::string_view bytes) {
  (void)parse_meta_image(bytes, [&](const std::string&) { return std::string(bytes); });
}
[[maybe_unused]] void fuzz_stl(std::string_view bytes) { (void)to_meshes(parse_stl(bytes), 1e-3); }
[[maybe_unused]] void fuzz_ply(std::string_view bytes) { (void)to_meshes(parse_ply(bytes), 1e-3); }
[[maybe_unused]] void fuzz_obj(std::string_view bytes) { (void)to_meshes(parse_obj(bytes), 1e-3); }
[[maybe_unused]] void fuzz_off(std::string_view bytes) { (void)to_meshes(parse_off(bytes), 1e-3); }

}  // namespace
}  // namespace hapticut::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    hapticut::test::FUZZ_FORMAT({reinterpret_cast<const char*>(data), size});
  } catch (const hapticut::Error&) {
  }
  return 0;
}
