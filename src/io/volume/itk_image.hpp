// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <itkImageIOBase.h>

#include <filesystem>
#include <new>
#include <string>

#include "io/file_errors.hpp"
#include "io/volume/raw_image.hpp"

/// @file
/// The door to ITK's file formats: errors become ours, nothing is printed, nothing is allocated before the header is
/// believable.
namespace hapticut {

/// While it lives, ITK and the NIfTI library print nothing.
class QuietItk {
 public:
  QuietItk();
  ~QuietItk();
  QuietItk(const QuietItk&) = delete;
  QuietItk& operator=(const QuietItk&) = delete;

 private:
  bool warned_;
};

/// The sentence of an ITK exception that says what is wrong.
[[nodiscard]] std::string reason_of(const itk::ExceptionObject& exception);

/// Runs `work` with ITK quiet; whatever it throws becomes an Error that names the file.
template <class Work>
auto with_itk(const std::filesystem::path& path, const Work& work) {
  try {
    const QuietItk quiet;
    return work();
  } catch (const Error&) {
    throw;
  } catch (const itk::ExceptionObject& exception) {
    cannot_read(path, reason_of(exception));
  } catch (const std::bad_alloc&) {
    cannot_read(path, "there is not enough memory for it. Crop or downsample it first.");
  } catch (const std::exception& exception) {
    cannot_read(path, exception.what());
  }
}

/// Geometry and type of an image of three dimensions (further ones must have size 1) with one value per sample; no
/// values.
[[nodiscard]] RawImage read_itk_header(itk::ImageIOBase& io, const std::filesystem::path& path);

/// The same with its values.
[[nodiscard]] RawImage read_itk_image(itk::ImageIOBase& io, const std::filesystem::path& path);

/// Reads all values of an image whose header `io` has read, whatever its dimensions.
[[nodiscard]] std::vector<std::byte> read_itk_values(itk::ImageIOBase& io);

}  // namespace hapticut
