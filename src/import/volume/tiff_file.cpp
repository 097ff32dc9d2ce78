// SPDX-License-Identifier: Apache-2.0
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "import/volume/formats.hpp"
#include "import/volume/picture_file.hpp"
#include "io/file_errors.hpp"

namespace hapticut {
namespace {

constexpr tmsize_t kMaxPiece = tmsize_t(1) << 28;  // [bytes] size of a strip or a tile

class TiffReader {
 public:
  explicit TiffReader(const std::filesystem::path& path) : path_(path), available_(double(readable_size(path))) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxPiece);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &TiffReader::note_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &TiffReader::ignore, nullptr);
    tiff_.reset(TIFFOpenExt(path.c_str(), "rm", options.get()));
    if (!tiff_) fail("its format differs from its extension, or it is damaged; save it as TIFF again");
  }

  PictureFile read() {
    std::uint32_t width = 0, height = 0;
    if (TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width) != 1 ||
        TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height) != 1)
      fail("it has no width or height");
    require_sane_dims({double(width), double(height), 1});
    PictureFile picture{{int(width), int(height)}, field(TIFFTAG_SAMPLESPERPIXEL), value_type(), {}};
    if (picture.channels < 1 || picture.channels > 4) fail("it has more than four channels");
    const auto layout = field(TIFFTAG_PLANARCONFIG), meaning = field(TIFFTAG_PHOTOMETRIC);
    if (picture.channels > 1 && layout != PLANARCONFIG_CONTIG) fail("its channels are stored separately");
    if (meaning != PHOTOMETRIC_MINISBLACK && meaning != PHOTOMETRIC_RGB)
      fail("its values are neither grey (0 = black) nor RGB; save it as one of these");
    if (field(TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT) fail("it is stored rotated or mirrored; save it upright");
    const std::size_t row = std::size_t(width) * picture.channels * size_of(picture.type);
    require_bytes(double(row) * height, available_, kAnyCompression);
    picture.bytes.resize(row * height);
    if (TIFFIsTiled(tiff_.get()) != 0)
      read_tiles(picture, row);
    else
      read_rows(picture, row);
    if (TIFFLastDirectory(tiff_.get()) == 0) fail("it has several pages; save one slice per file");
    return picture;
  }

 private:
  [[nodiscard]] std::uint16_t field(std::uint32_t tag) const {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
    return value;
  }

  [[nodiscard]] ValueType value_type() const {
    const auto bits = field(TIFFTAG_BITSPERSAMPLE), format = field(TIFFTAG_SAMPLEFORMAT);
    if (bits == 8 && format == SAMPLEFORMAT_UINT) return ValueType::uint8;
    if (bits == 16 && format == SAMPLEFORMAT_UINT) return ValueType::uint16;
    if (bits == 16 && format == SAMPLEFORMAT_INT) return ValueType::int16;
    if (bits == 32 && format == SAMPLEFORMAT_IEEEFP) return ValueType::float32;
    fail("its type of values is not supported; save 8 or 16 bits per pixel");
  }

  void read_rows(PictureFile& picture, std::size_t row) {
    if (TIFFScanlineSize64(tiff_.get()) != row || TIFFStripSize64(tiff_.get()) > std::uint64_t(kMaxPiece))
      fail("its strips do not match its size");
    for (std::size_t y = 0; y < std::size_t(picture.dims[1]); ++y)
      if (TIFFReadScanline(tiff_.get(), picture.bytes.data() + y * row, std::uint32_t(y), 0) != 1)
        fail("it is damaged or truncated");
  }

  void read_tiles(PictureFile& picture, std::size_t row) {
    std::uint32_t tile_width = 0, tile_height = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &tile_width);
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &tile_height);
    const std::uint64_t size = TIFFTileSize64(tiff_.get()), tile_row = TIFFTileRowSize64(tiff_.get());
    if (tile_width < 1 || tile_height < 1 || size > std::uint64_t(kMaxPiece) || size < tile_row * tile_height)
      fail("its tiles do not match its size");
    const std::size_t pixel = picture.channels * size_of(picture.type);
    if (tile_row < tile_width * pixel) fail("its tiles do not match its size");
    std::vector<std::byte> tile(static_cast<std::size_t>(size));
    const auto width = std::uint32_t(picture.dims[0]), height = std::uint32_t(picture.dims[1]);
    for (std::uint32_t y = 0; y < height; y += tile_height)
      for (std::uint32_t x = 0; x < width; x += tile_width) {
        if (TIFFReadTile(tiff_.get(), tile.data(), x, y, 0, 0) < 0) fail("it is damaged or truncated");
        const std::size_t count = pixel * std::min(tile_width, width - x);
        for (std::uint32_t line = 0; line < std::min(tile_height, height - y); ++line)
          std::memcpy(picture.bytes.data() + (y + line) * row + x * pixel, tile.data() + line * tile_row, count);
      }
  }

  [[noreturn]] void fail(const std::string& reason) const {
    cannot_read(path_, reason + (reason_.empty() ? "" : " (" + reason_ + ")") + ".");
  }

  static int note_error(TIFF*, void* self, const char*, const char* format, va_list arguments) {
    char text[256];
    std::vsnprintf(text, sizeof text, format, arguments);
    std::string& reason = static_cast<TiffReader*>(self)->reason_;
    reason = text;
    reason.erase(reason.find_last_not_of(" .\n") + 1);
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return 1;  // libtiff calls no other handler
  }
  static int ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

  const std::filesystem::path& path_;
  double available_;    // bytes in the file
  std::string reason_;  // last message of libtiff
  std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_{nullptr, TIFFClose};
};

}  // namespace

PictureFile read_tiff(const std::filesystem::path& path) {
  return naming(path, [&] { return TiffReader(path).read(); });
}

}  // namespace hapticut
