// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/dicom/codec_process.hpp"
#include "import/dicom/dicom_picture.hpp"
#include "import/volume/formats.hpp"
#include "import/volume/slice_names.hpp"
#include "io/file_errors.hpp"
#include "io/text_lines.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

/// A slice of a series. Its values are read after the check that all slices belong together.
struct DicomSlice {
  fs::path path;
  DicomPicture picture;
};

bool alike(const DicomPicture& a, const DicomPicture& b) {
  return a.geometry.dims == b.geometry.dims && a.allocated == b.allocated &&
         (a.geometry.spacing_mm - b.geometry.spacing_mm).head<2>().cwiseAbs().maxCoeff() <= 1e-4 &&
         (a.geometry.direction - b.geometry.direction).cwiseAbs().maxCoeff() <= 1e-3;
}

/// Files of one kind, named by their Series Instance UID. If a series has several kinds (e.g. a scout of another size),
/// the less frequent kinds get a number after the UID; if no kind is the most frequent, all kinds get one.
struct AlikeSlices {
  std::string name;
  std::vector<DicomSlice> slices;
};

const std::string& series_uid(const AlikeSlices& kind) { return kind.slices.front().picture.series; }

/// Number and kind of the files, to distinguish them from others.
std::string in_words(const AlikeSlices& kind) {
  const FileGeometry& g = kind.slices.front().picture.geometry;
  const Vec3 facing = ((g.direction.col(2) * 1e3).array().round() / 1e3 + 0.0).matrix();  // avoids -0
  const std::size_t count = kind.slices.size();
  return "'" + kind.name + "' (" + std::to_string(count) + (count == 1 ? " file" : " files") + " of " +
         std::to_string(g.dims[0]) + " x " + std::to_string(g.dims[1]) +
         (g.dims[2] > 1 ? " x " + std::to_string(g.dims[2]) : "") + " samples of " +
         std::to_string(kind.slices.front().picture.allocated) + " bits, " + format_number(g.spacing_mm.x()) + " x " +
         format_number(g.spacing_mm.y()) + " mm, facing " + format_number(facing.x()) + ", " +
         format_number(facing.y()) + ", " + format_number(facing.z()) + ")";
}

/// A file whose picture does not belong to a volume: a colour screenshot, a bit mask, a damaged, cut or empty file.
struct UnreadPicture {
  fs::path path;
  std::optional<std::string> series;  // nullopt when the file is damaged before this element
  Sentence cause;
};

struct DicomFolder {
  std::vector<AlikeSlices> series;
  std::vector<UnreadPicture> unread;
};

/// A DICOM file without a picture: a directory, a report, or a slice that was cut.
struct WithoutPicture {
  fs::path path;
  std::string series, kind;  // empty when the file ends before them
  bool has_rows;
};

bool is_directory_file(const WithoutPicture& file) {
  return file.kind == "1.2.840.10008.1.3.10" || lower_case(file.path.filename().string()) == "dicomdir";
}

/// Adds the files that were meant to be slices and are none to the unread ones. Reports, previews and notes are not.
/// @param others  what is no DICOM file: also links to nothing, pipes and folders, which must not be opened
void add_lost_slices(const SliceNames& names, const std::set<std::string>& classes,
                     const std::vector<WithoutPicture>& without_picture, const std::vector<fs::path>& others,
                     DicomFolder& found) {
  constexpr const char* kCure = "Get a complete copy of it.";
  for (const WithoutPicture& file : without_picture)
    if (!is_directory_file(file) && (file.has_rows || file.kind.empty() || classes.contains(file.kind)))
      found.unread.push_back({file.path, file.series.empty() ? std::nullopt : std::optional(file.series),
                              std::string("it has no picture: it ends before one, or never had one. ") + kCure +
                                  (file.series.empty() ? "" : " If it never had one, remove it from the folder.")});
  for (const fs::path& path : others) {
    const auto cut_preamble = [&] {
      std::error_code code;
      if (!fs::is_regular_file(path, code)) return false;
      const std::string begin = first_bytes(path, 133);
      return begin.size() <= 132 && begin.find_first_not_of('\0') == std::string::npos;
    };
    if (names.is_name_of_slice(path) || names.is_slice_of_other_format(path) ||
        (names.have_no_extension() && !path.has_extension() && cut_preamble())) {
      const NoSlice lost = what_is_no_slice(path, "DICOM file");
      found.unread.push_back({path, std::nullopt, lost.what + ". " + (lost.cure.empty() ? kCure : lost.cure)});
    }
  }
}

/// The pictures of a folder.
DicomFolder pictures_in(const fs::path& folder) {
  std::vector<fs::path> files, others;
  std::error_code code, ignored;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (entry.is_regular_file(ignored) && is_dicom_file(entry.path()))
      files.push_back(entry.path());
    else if (may_be_lost_slice(entry.path()))
      others.push_back(entry.path());
  if (code) cannot_read(folder, code.message() + ".");
  std::sort(files.begin(), files.end());
  std::sort(others.begin(), others.end());
  DicomFolder found;
  SliceNames names;
  for (const char* usual : {"a.dcm", "a.ima"}) names.add(usual);
  std::set<std::string> classes;
  std::vector<WithoutPicture> without_picture;
  std::map<std::string, std::vector<AlikeSlices>> by_uid;
  for (const fs::path& path : files) {
    const std::string bytes = bytes_of_file(path);
    std::optional<std::string> uid;
    try {
      const DicomFile file = parse_dicom(bytes);
      uid = series_of(file);
      if (!file.has_picture) {
        without_picture.push_back({path, *uid, kind_of(file), has_rows(file)});
        continue;
      }
      DicomSlice slice = {path, describe_picture(file)};
      std::vector<AlikeSlices>& of_series = by_uid[slice.picture.series];
      auto kind = std::find_if(of_series.begin(), of_series.end(), [&](const AlikeSlices& known) {
        return alike(known.slices.front().picture, slice.picture);
      });
      if (kind == of_series.end()) kind = of_series.insert(kind, AlikeSlices{slice.picture.series, {}});
      names.add(path);
      classes.insert(slice.picture.kind);
      kind->slices.push_back(std::move(slice));
    } catch (const Error& error) {
      found.unread.push_back({path, uid, error.sentence()});
    }
  }
  add_lost_slices(names, classes, without_picture, others, found);
  for (auto& [uid, kinds] : by_uid) {
    std::stable_sort(kinds.begin(), kinds.end(),
                     [](const auto& a, const auto& b) { return a.slices.size() > b.slices.size(); });
    const bool one_is_largest = kinds.size() == 1 || kinds[0].slices.size() > kinds[1].slices.size();
    for (std::size_t n = 0; n < kinds.size(); ++n) {
      if (n > 0 || !one_is_largest) kinds[n].name += "#" + std::to_string(n + 1);
      found.series.push_back(std::move(kinds[n]));
    }
  }
  return found;
}

/// Pictures of other series are not checked: an export puts all series into one folder.
void require_all_read(const DicomFolder& folder, const std::optional<std::string>& series) {
  const auto counts = [&](const UnreadPicture& picture) {
    return !series || !picture.series || *picture.series == *series;
  };
  const auto count = std::count_if(folder.unread.begin(), folder.unread.end(), counts);
  if (count == 0) return;
  const UnreadPicture& first = *std::find_if(folder.unread.begin(), folder.unread.end(), counts);
  Sentence reason = first.cause;
  if (!first.series) reason += " If it is not of the series, remove it from the folder.";
  if (count > 1) reason += " The folder has " + std::to_string(count) + " such files.";
  cannot_read(first.path, reason);
}

/// @param remarks  receives a sentence about files that are left out
/// @return empty when the folder has no DICOM picture
std::vector<DicomSlice> slices_of_series(const fs::path& folder, const std::string& uid,
                                         std::vector<std::string>& remarks) {
  DicomFolder found = pictures_in(folder);
  std::vector<AlikeSlices>& series = found.series;
  if (series.empty()) {
    require_all_read(found, std::nullopt);
    return {};
  }
  const auto slices_of = [&](AlikeSlices& one) {
    require_all_read(found, series_uid(one));
    return std::move(one.slices);
  };
  std::string list;
  for (AlikeSlices& one : series) {
    append_item(list, in_words(one), ", ");
    if (uid.empty() || one.name != uid) continue;
    for (const AlikeSlices& other : series)
      if (&other != &one && series_uid(other) == series_uid(one))
        remarks.push_back("'" + folder.string() +
                          "' has slices of another kind in the series, which are left out: " + in_words(other) + ".");
    return slices_of(one);
  }
  if (!uid.empty()) cannot_read(folder, "it has no DICOM series '" + uid + "'; it has " + list + ".");
  if (series.size() > 1)
    cannot_read(folder, "it has several DICOM series, or a series of several kinds: " + list + ". Choose one with " +
                            "VolumeReadOptions::dicom_series"_name + ".");
  std::vector<DicomSlice> slices = slices_of(series.front());
  if (found.unread.size() >= slices.size())  // then the unreadable files may be the wanted ones
    cannot_read(found.unread.front().path, found.unread.front().cause + " The folder also has " + list +
                                               "; choose it with " + "VolumeReadOptions::dicom_series"_name + ".");
  const std::size_t others = found.unread.size();
  if (others > 0)
    remarks.push_back("'" + folder.string() + "' has " + std::to_string(others) +
                      (others == 1 ? " file of another series that is left out, '"
                                   : " files of other series that are left out, the first is '") +
                      found.unread.front().path.filename().string() + "': " + found.unread.front().cause.in_cpp());
  return slices;
}

}  // namespace

bool is_dicom_file(const fs::path& path) { return begins_like_dicom(first_bytes(path, 132)); }

RawImage read_dicom_file(const fs::path& path) {
  const std::string bytes = bytes_of_file(path);
  CodecProcess process;
  return naming(path, [&] {
    const DicomFile file = parse_dicom(bytes);
    const DicomPicture picture = describe_picture(file);
    if (picture.geometry.dims[2] == 1) throw Error("it is a single slice; name the folder of its series.");
    return picture_values(file, picture, std::ref(process));
  });
}

std::optional<RawImage> read_dicom_series(const fs::path& folder, const std::string& series) {
  RawImage image;
  const std::vector<DicomSlice> slices = slices_of_series(folder, series, image.remarks);
  if (slices.empty()) return std::nullopt;
  if (const std::string remark = remark_on_subfolders(folder, "DICOM files", is_dicom_file); !remark.empty())
    image.remarks.push_back(remark);
  if (slices.size() == 1 && slices.front().picture.geometry.dims[2] > 1) {
    RawImage frames = read_dicom_file(slices.front().path);
    frames.remarks = image.remarks;
    return frames;
  }
  // All slices are of one kind, so all have as many frames.
  if (const int frames = slices.front().picture.geometry.dims[2]; frames != 1)
    cannot_read(folder, "its DICOM series is in " + std::to_string(slices.size()) + " files of " +
                            std::to_string(frames) + " frames, the first is '" +
                            slices.front().path.filename().string() +
                            "'. If each is a part of the volume, join them in one file, e.g. as NRRD or NIfTI; if each "
                            "is a volume, name one of the files.");
  if (slices.size() < 2) cannot_read(folder, "its DICOM series has only one slice; a volume needs two.");
  std::vector<Vec3> places;
  for (const DicomSlice& slice : slices) {
    if (!slice.picture.has_place)
      cannot_read(slice.path,
                  "it has no position (Image Position), and the number of the slice does not tell on which side the "
                  "count begins. Export the series with positions, or save it in one NRRD or NIfTI file.");
    places.push_back(slice.picture.geometry.origin_mm);
  }
  image.geometry = slices.front().picture.geometry;
  image.geometry.dims[2] = int(slices.size());
  for (const DicomSlice& slice : slices) image.geometry.axes_assumed |= slice.picture.geometry.axes_assumed;
  const auto name = [&](std::size_t n) { return "'" + slices[n].path.filename().string() + "'"; };
  const auto order = naming(folder, [&] {
    require_sane_dims({double(image.geometry.dims[0]), double(image.geometry.dims[1]), double(slices.size())});
    return stack_planes(places, "slices", name, image.geometry);
  });
  CodecProcess process;
  for (const std::size_t n : order) {
    const DicomSlice& slice = slices[n];
    const std::string bytes = bytes_of_file(slice.path);
    const RawImage one =
        naming(slice.path, [&] { return picture_values(parse_dicom(bytes), slice.picture, std::ref(process)); });
    if (n != order.front() && one.type != image.type)
      cannot_read(slice.path, "it differs from the first slice in the type of its values.");
    image.type = one.type;
    const std::size_t first = image.bytes.size() / size_of(image.type);
    for (std::size_t sample = 0; sample < one.padding.size(); ++sample)
      if (one.padding[sample]) image.mark_padding(first + sample);
    image.bytes += one.bytes;
  }
  return image;
}

}  // namespace hapticut
