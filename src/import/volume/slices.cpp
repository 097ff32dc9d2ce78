// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/interruption.hpp"
#include "hapticut/core/units.hpp"
#include "import/volume/formats.hpp"
#include "import/volume/picture_file.hpp"
#include "import/volume/slice_names.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

enum class SliceFormat : std::uint8_t { kPng, kTiff };

/// Format of a slice; nullopt for other files, such as the `._name` files of macOS.
std::optional<SliceFormat> format_of(const fs::path& path) {
  if (path.filename().string().starts_with("._")) return std::nullopt;
  const std::string extension = lower_case(path.extension().string());
  if (extension == ".png") return SliceFormat::kPng;
  if (extension == ".tif" || extension == ".tiff") return SliceFormat::kTiff;
  return std::nullopt;
}

struct SliceNumber {
  std::string before;  ///< text of the name before the number
  std::uint64_t value = 0;
};

struct SliceFile {
  fs::path path;
  SliceFormat format;
  std::vector<SliceNumber> numbers = {};  ///< numbers in its name
};

PictureFile read_picture(const SliceFile& file) {
  return file.format == SliceFormat::kPng ? read_png(file.path) : read_tiff(file.path);
}

std::vector<SliceNumber> numbers_of_name(const fs::path& path) {
  constexpr const char* kDigits = "0123456789";
  const std::string name = path.stem().string();
  std::vector<SliceNumber> numbers;
  for (std::size_t end = 0, begin = 0; (begin = name.find_first_of(kDigits, end)) != std::string::npos;) {
    end = std::min(name.find_first_not_of(kDigits, begin), name.size());
    if (end - begin <= 18) numbers.push_back({name.substr(0, begin), std::stoull(name.substr(begin, end - begin))});
  }
  if (numbers.empty())
    cannot_read(path,
                "slices are ordered by the numbers in their names, but this name has none. Move the file elsewhere.");
  return numbers;
}

void require_follows(const fs::path& folder, const SliceFile& before, const SliceFile& file, bool does) {
  if (!does)
    cannot_read(folder, "its slices '" + before.path.filename().string() + "' and '" + file.path.filename().string() +
                            "' are not consecutive; one is missing, duplicated, or of another series. Add the missing "
                            "one, or move files of other series elsewhere.");
}

/// Refuses a file that has the name of a slice and is none, e.g. s06.bmp or s06.tif.part after s05.tif. It would end
/// the volume early.
void require_no_lost_slices(const fs::path& folder, const std::vector<SliceFile>& files,
                            const std::vector<fs::path>& others) {
  SliceNames names;
  for (const SliceFile& file : files) names.add(file.path);
  for (const fs::path& path : others)
    if (names.is_name_of_slice(path) || names.is_slice_of_other_format(path)) {
      const NoSlice found = what_is_no_slice(path, "PNG or TIFF file");
      cannot_read(folder, "'" + path.filename().string() + "' has the name of a slice, but " + found.what + ". " +
                              (found.cure.empty() ? "Save it as its neighbours, or remove it from the folder."
                                                  : found.cure + " If it is no slice, remove it from the folder."));
    }
}

/// The slices of a folder, ordered by the last number in their names that differs between them. The numbers need no
/// leading zeros.
std::vector<SliceFile> ordered_slices(const fs::path& folder) {
  std::vector<SliceFile> files;
  std::vector<fs::path> others;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (const auto format = format_of(entry.path()))
      files.push_back({entry.path(), *format});
    else if (may_be_lost_slice(entry.path()))
      others.push_back(entry.path());
  }
  if (code) cannot_read(folder, code.message() + ".");
  std::sort(others.begin(), others.end());
  if (files.size() < 2) {
    for (const SliceFile& file : files) (void)read_picture(file);  // throws when a file has several pages
    cannot_read(folder, "it has fewer than two PNG or TIFF slices; a volume needs two.");
  }
  require_no_lost_slices(folder, files, others);
  for (SliceFile& file : files) file.numbers = numbers_of_name(file.path);
  std::size_t n = files[0].numbers.size() - 1;
  for (const SliceFile& file : files) require_follows(folder, files[0], file, file.numbers.size() == n + 1);
  const auto value = [&](const SliceFile& file) { return file.numbers[n].value; };
  const auto as_in_first = [&](const SliceFile& file) { return value(file) == value(files[0]); };
  while (n > 0 && std::all_of(files.begin(), files.end(), as_in_first)) --n;
  std::sort(files.begin(), files.end(), [&](const auto& a, const auto& b) { return value(a) < value(b); });
  for (std::size_t at = 1; at < files.size(); ++at)
    require_follows(folder, files[at - 1], files[at],
                    files[at].numbers[n].before == files[0].numbers[n].before &&
                        value(files[at]) - value(files[at - 1]) == value(files[1]) - value(files[0]) &&
                        value(files[at]) != value(files[at - 1]));
  return files;
}

/// Reads the slices and checks that they have the same format.
template <class Use>
std::array<int, 3> for_each_slice(const fs::path& folder, const Use& use) {
  const std::vector<SliceFile> files = ordered_slices(folder);
  std::array<int, 3> dims{};
  std::optional<PictureFile> first;
  for (const SliceFile& file : files) {
    look_for_interruption();
    PictureFile picture = read_picture(file);
    if (!first) {
      first = PictureFile{picture.dims, picture.channels, picture.type, {}};
      dims = {picture.dims[0], picture.dims[1], int(files.size())};
      naming(folder, [&] { require_sane_dims({double(dims[0]), double(dims[1]), double(dims[2])}); });
    }
    if (picture.dims != first->dims || picture.channels != first->channels || picture.type != first->type)
      cannot_read(file.path, "it differs from the first slice in size, channels or depth.");
    use(file, picture);
  }
  return dims;
}

void remark_on_subfolders_of(const fs::path& folder, std::vector<std::string>& remarks) {
  const std::string remark = remark_on_subfolders(folder, "PNG or TIFF files",
                                                  [](const fs::path& path) { return format_of(path).has_value(); });
  if (!remark.empty()) remarks.push_back(remark);
}

}  // namespace

bool has_slices(const fs::path& folder) {
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (format_of(entry.path())) return true;
  if (code) cannot_read(folder, code.message() + ".");
  return false;
}

RawImage read_slices(const fs::path& folder) {
  RawImage image;
  image.geometry.spacing_mm.setZero();
  image.geometry.dims = for_each_slice(folder, [&](const SliceFile& file, const PictureFile& picture) {
    if (picture.channels == 2)
      cannot_read(file.path, "it has grey values and transparency; save the grey values alone.");
    if (picture.channels != 1)
      cannot_read(file.path, "it is in colour; save grey values" +
                                 Sentence::clause(", or read labels with " + "read_color_slices"_name) + ".");
    image.type = picture.type;
    image.bytes += picture.bytes;
  });
  remark_on_subfolders_of(folder, image.remarks);
  return image;
}

LabelVolume read_color_slices(const fs::path& folder, const std::map<Color, std::uint16_t>& label_of,
                              const Vec3& spacing) {
  for (int axis = 0; axis < 3; ++axis) require_positive(spacing[axis], "spacing of colour slices [m]");
  LabelVolume volume;
  bool found = false;
  volume.dims = for_each_slice(folder, [&](const SliceFile& file, const PictureFile& picture) {
    const std::size_t channels = picture.channels;
    if ((channels != 3 && channels != 4) || picture.type != ValueType::uint8)
      cannot_read(file.path, "it is not a colour picture with 8 bits per channel.");
    Color last;
    std::uint16_t label = 0;
    bool known = false;
    for (std::size_t at = 0; at < picture.bytes.size(); at += channels) {
      const auto channel = [&](std::size_t n) { return std::uint8_t(picture.bytes[at + n]); };
      const Color color = {channel(0), channel(1), channel(2)};
      if (!known || color != last) {  // neighbours are usually equal
        const auto entry = label_of.find(color);
        label = entry == label_of.end() ? std::uint16_t(0) : entry->second;
        last = color;
        known = true;
      }
      const bool opaque = channels == 3 || channel(3) == 255;
      volume.values.push_back(opaque ? label : std::uint16_t(0));
      found |= opaque && label != 0;
    }
  });
  if (!found) cannot_read(folder, "its slices have no pixel of the given colours.");
  volume.spacing = spacing;
  remark_on_subfolders_of(folder, volume.remarks);
  return volume;
}

}  // namespace hapticut
