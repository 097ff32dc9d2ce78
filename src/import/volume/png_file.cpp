// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>

#include "import/volume/formats.hpp"
#include "import/volume/picture_file.hpp"
#include "io/file_errors.hpp"

namespace hapticut {
namespace {

/// libpng, reading from memory. It reports errors by longjmp.
class PngReader {
 public:
  PngReader(const std::filesystem::path& path, const std::string& file)
      : path_(path),
        file_(file),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::ignore)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      cannot_read(path, "libpng did not start.");
    }
    png_set_read_fn(png_, this, &PngReader::read);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  PictureFile read() {
    checked([this] {
      png_read_info(png_, info_);
      png_set_expand(png_);  // palettes to colours, fewer than 8 bits to 8, transparent colours to alpha
      if (std::endian::native == std::endian::little) png_set_swap(png_);
      png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    const png_uint_32 width = png_get_image_width(png_, info_), height = png_get_image_height(png_, info_);
    require_sane_dims({double(width), double(height), 1});
    const std::size_t row = png_get_rowbytes(png_, info_);
    require_bytes(double(row) * height, double(file_.size()), kDeflate);

    PictureFile picture{{int(width), int(height)},
                        png_get_channels(png_, info_),
                        png_get_bit_depth(png_, info_) == 16 ? ValueType::uint16 : ValueType::uint8,
                        {}};
    picture.bytes.resize(row * height);
    std::vector<png_bytep> rows(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = reinterpret_cast<png_bytep>(picture.bytes.data() + y * row);
    checked([this, first = rows.data()] {
      png_read_image(png_, first);
      png_read_end(png_, nullptr);
    });
    return picture;
  }

 private:
  /// @param calls  calls of libpng; they may not create objects with destructors
  template <class Calls>
  void checked(const Calls& calls) {
    if (setjmp(png_jmpbuf(png_)) != 0) cannot_read(path_, "it is damaged or truncated (" + std::string(reason_) + ").");
    calls();
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp reason) {
    auto& self = *static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(self.reason_, reason, sizeof self.reason_ - 1);
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}
  static void read(png_structp png, png_bytep to, png_size_t count) {
    auto& self = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > self.file_.size() - self.at_) png_error(png, "end of file");
    std::memcpy(to, self.file_.data() + self.at_, count);
    self.at_ += count;
  }

  const std::filesystem::path& path_;
  const std::string& file_;
  std::size_t at_ = 0;
  char reason_[128] = {};
  png_structp png_;
  png_infop info_;
};

}  // namespace

PictureFile read_png(const std::filesystem::path& path) {
  const std::string file = bytes_of_file(path);
  if (!file.starts_with("\x89PNG\r\n\x1a\n")) cannot_read(path, "its format differs from its extension.");
  return naming(path, [&] { return PngReader(path, file).read(); });
}

}  // namespace hapticut
