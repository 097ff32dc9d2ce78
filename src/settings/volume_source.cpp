// SPDX-License-Identifier: Apache-2.0
#include "settings/volume_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hapticut/build/volume_builders.hpp"
#include "hapticut/build/volume_operations.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/import/volume/volume_filters.hpp"
#include "hapticut/import/volume/volumes.hpp"

namespace hapticut::settings {
namespace {

using Source = WorkpieceSettings;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

VolumeReadOptions read_options(const Source& s) {
  VolumeReadOptions options;
  if (s.spacing_mm) options.spacing = *s.spacing_mm * units::mm;
  options.dicom_series = s.dicom_series;
  return options;
}

bool is_raw(const Source& s) {
  return s.source.ends_with(".raw") || !s.raw.dims.empty() || !s.raw.type.empty() || s.raw.big_endian ||
         s.raw.skip_bytes > 0;
}

RawLayout raw_layout(const Source& s) {
  if (!s.dicom_series.empty())
    throw Error("a file without a header has no series; leave " + "workpiece.dicom_series"_name + " out.");
  if (s.raw.dims.empty() || s.raw.type.empty() || !s.spacing_mm)
    throw Error("a file without a header needs its dimensions, type and spacing; set all of " +
                "workpiece.raw_dims"_name + ", " + "workpiece.raw_type"_name + " and " + "workpiece.spacing_mm"_name +
                ".");
  const auto type = value_named<ValueType>(s.raw.type);
  if (!type)
    throw Error("workpiece.raw_type"_name + " = " + s.raw.type + "; must be one of " + list_of_names<ValueType>() +
                ".");
  for (const double n : s.raw.dims)
    if (n != std::floor(n)) throw Error("workpiece.raw_dims"_name + " must be whole numbers: samples along x, y, z.");
  return {{int(s.raw.dims[0]), int(s.raw.dims[1]), int(s.raw.dims[2])},
          *s.spacing_mm * units::mm,
          *type,
          s.raw.big_endian,
          s.raw.skip_bytes};
}

GreyVolume read_grey(const Source& s) {
  return is_raw(s) ? read_raw_grey_volume(s.source, raw_layout(s)) : read_grey_volume(s.source, read_options(s));
}

LabelVolume read_labels(const Source& s) {
  return is_raw(s) ? read_raw_label_volume(s.source, raw_layout(s)) : read_label_volume(s.source, read_options(s));
}

/// Passes on what the reader remarks, and warns when the volume has padding.
template <class Value>
Volume<Value> warned(const Source& s, Volume<Value> volume) {
  if (s.warn)
    for (const std::string& remark : volume.remarks) s.warn(remark);
  if (s.warn && volume.padding > 0)
    s.warn(std::to_string(volume.padding) + " of the " + std::to_string(volume.size()) + " samples of " + s.source +
           " are padding outside the field of view and are treated as air.");
  return volume;
}

std::optional<Box> crop_box(const Source& s) {
  if (s.crop_mm.empty()) return std::nullopt;
  const auto& c = s.crop_mm;
  const Box box{Vec3(c[0], c[1], c[2]) * units::mm, Vec3(c[3], c[4], c[5]) * units::mm};
  if (!(box.max.array() > box.min.array()).all())
    throw Error("workpiece.crop_mm"_name +
                " must be x, y, z of the lower corner and then x, y, z of the upper one; here an "
                "upper value is not above the lower one.");
  return box;
}

VolumeBuildOptions build_options(const Source& s) {
  VolumeBuildOptions options;
  options.voxel_size = s.voxel_mm.value_or(0) * units::mm;
  options.crop = crop_box(s);
  options.partial_volume = s.partial_volume.value_or(true);
  options.large = s.large;
  options.observer = s.tell;
  options.warn = s.warn;
  return options;
}

template <class Value>
Volume<Value> cropped(Volume<Value> volume, const std::optional<Box>& box) {
  return box ? crop_to_box(volume, *box) : volume;
}

/// Gives enclosed cavities a new label, and that label the material of `fill_cavities`.
LabelVolume filled(const Source& s, LabelVolume volume, std::vector<LabelMaterial>& materials) {
  const std::uint16_t label = unused_label(volume);
  if (s.close_gaps_mm) volume = close_gaps(std::move(volume), *s.close_gaps_mm * units::mm, label);
  volume = fill_cavities(std::move(volume), label);
  if (std::find(volume.values.begin(), volume.values.end(), label) == volume.values.end())
    throw Error("the labels enclose no cavity that " + "workpiece.fill_cavities"_name + " could fill. " +
                (s.close_gaps_mm ? "Raise " + "workpiece.close_gaps_mm"_name + ", or leave both out."
                                 : "Set " + "workpiece.close_gaps_mm"_name + " if a canal leads outside, or leave " +
                                       "workpiece.fill_cavities"_name + " out."));
  const auto same = std::find_if(materials.begin(), materials.end(),
                                 [&](const LabelMaterial& known) { return known.material.name == s.fill_cavities; });
  if (same != materials.end())
    same->labels.push_back(label);
  else
    materials.push_back({{label}, s.materials.find(s.fill_cavities)});
  return volume;
}

Workpiece from_labels(const Source& s) {
  LabelVolume volume = cropped(warned(s, read_labels(s)), crop_box(s));
  if (s.largest_component) volume = keep_largest_component(std::move(volume));
  std::vector<LabelMaterial> materials;
  for (const Source::Labels& labels : s.labels)
    materials.push_back({{labels.values.begin(), labels.values.end()}, s.materials.find(labels.material)});
  if (!s.fill_cavities.empty()) volume = filled(s, std::move(volume), materials);
  return build_from_labels(volume, materials, build_options(s), s.unclaimed_labels.value_or(UnclaimedLabels::refuse));
}

GreyVolume read_body(const Source& s, double lowest) {
  GreyVolume volume = cropped(warned(s, read_grey(s)), crop_box(s));
  if (s.largest_component) volume = keep_largest_component(std::move(volume), lowest);
  return volume;
}

Workpiece not_empty(Workpiece workpiece) {
  if (workpiece.solid_voxels() == 0)
    throw Error(
        "no voxel is left: none of its values belongs to a material, or its parts are too thin for the voxels. Run "
        "hapticut inspect on the file to see its values, and choose smaller voxels.");
  return workpiece;
}

Workpiece from_ranges(const Source& s) {
  std::vector<hapticut::GreyRange> ranges;
  double lowest = kInfinity;
  for (const Source::GreyRange& range : s.grey) {
    ranges.push_back({range.from.value_or(-kInfinity), range.to.value_or(kInfinity), s.materials.find(range.material)});
    lowest = std::min(lowest, ranges.back().from);
  }
  VolumeBuildOptions options = build_options(s);
  std::vector<std::string> said;  // told only when something is left: the refusal says the rest
  if (s.warn) options.warn = [&](const std::string& sentence) { said.push_back(sentence); };
  Workpiece workpiece = not_empty(build_from_grey(read_body(s, lowest), ranges, options));
  for (const std::string& sentence : said) s.warn(sentence);
  return workpiece;
}

Workpiece from_grade(const Source& s) {
  if (!s.grade_low || !s.grade_high || s.grade_at_low.empty() || s.grade_at_high.empty())
    throw Error("a grade needs all of " + "workpiece.grade_low"_name + ", " + "workpiece.grade_high"_name + ", " +
                "workpiece.grade_at_low"_name + " and " + "workpiece.grade_at_high"_name + "; set the missing ones.");
  Grade grade;
  grade.low = *s.grade_low;
  grade.high = *s.grade_high;
  grade.at_low = s.materials.find(s.grade_at_low);
  grade.at_high = s.materials.find(s.grade_at_high);
  return build_from_grey(read_body(s, grade.low), grade, build_options(s));
}

}  // namespace

Workpiece make_workpiece_from_volume(const Source& s) {
  const bool graded = s.grade_low || s.grade_high || !s.grade_at_low.empty() || !s.grade_at_high.empty();
  const int methods = int(!s.labels.empty()) + int(!s.grey.empty()) + int(graded);
  if (methods != 1)
    throw Error("a volume needs either labels, or ranges of grey values, or a grade; " + std::to_string(methods) +
                " of them are set. Set " + "workpiece.labels"_name + ", " + "workpiece.grey"_name + " or " +
                "workpiece.grade_low"_name + ".");
  if (s.close_gaps_mm && s.fill_cavities.empty())
    throw Error("workpiece.close_gaps_mm"_name + " needs " + "workpiece.fill_cavities"_name +
                ", the material that fills the gaps.");
  if (!s.labels.empty()) return not_empty(from_labels(s));
  if (s.unclaimed_labels)
    throw Error("workpiece.unclaimed_labels"_name +
                " needs labels; grey values outside all ranges are empty. Leave it out.");
  if (!s.fill_cavities.empty())
    throw Error("workpiece.fill_cavities"_name +
                " needs labels; in grey values it is not clear what is enclosed. Leave it out.");
  return graded ? not_empty(from_grade(s)) : from_ranges(s);
}

VolumeSummary summarize_volume(const Source& s, std::optional<double> threshold) {
  refuse_all_but(s,
                 {"spacing_mm", "crop_mm", "dicom_series", "raw_dims", "raw_type", "raw_big_endian", "raw_skip_bytes"},
                 s.source + " is a volume without materials");
  GreyVolume volume = read_grey(s);
  const std::size_t padding = volume.padding;
  const std::vector<std::string> remarks = volume.remarks;
  volume = cropped(std::move(volume), crop_box(s));
  const auto [lowest, highest] = grey_range(volume);
  VolumeSummary summary{volume.dims,
                        volume.spacing,
                        volume.X_WG,
                        box_of_volume(volume),
                        lowest,
                        highest,
                        std::size_t(std::count_if(volume.values.begin(), volume.values.end(),
                                                  [](float value) { return std::isnan(value); })),
                        padding,
                        remarks,
                        volume.values.size() * sizeof(float)};
  if (threshold) summary.voxels_at_or_above = count_from(volume, *threshold);
  summary.voxels_by_label = count_labels(volume);
  return summary;
}

}  // namespace hapticut::settings
