// SPDX-License-Identifier: Apache-2.0
#include "settings/workpiece_settings.hpp"

#include <cmath>

namespace hapticut::settings {
namespace {

/// The parts of "material=rest"; nullopt when the text has another form.
std::optional<std::pair<std::string, std::string>> parse_assignment(const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == 0 || at == std::string::npos || at + 1 == text.size()) return std::nullopt;
  return std::pair(text.substr(0, at), text.substr(at + 1));
}

/// A setting that is a list of tables, each of them one `Element`.
template <class Element>
Setting table_list(std::string key, std::string flag, std::deque<Element>& elements, std::string allowed,
                   std::string meaning, std::vector<Setting> (*settings_of_element)(Element&),
                   bool (*parse)(const std::string& material, const std::string& rest, Element&)) {
  Setting setting{std::move(key), std::move(flag), std::move(meaning), std::move(allowed), Setting::Kind::tables};
  setting.clear = [&elements] { elements.clear(); };
  setting.open_table = [&elements, settings_of_element](const std::string&) {
    return settings_of_element(elements.emplace_back());
  };
  setting.assign_short_form = [&elements, parse](const std::string& text) {
    const auto parts = parse_assignment(text);
    if (!parts) return false;
    Element& element = elements.emplace_back();
    element.material = parts->first;
    return parse(parts->first, parts->second, element);
  };
  return setting;
}

using Layer = WorkpieceSettings::Layer;
using Labels = WorkpieceSettings::Labels;
using GreyRange = WorkpieceSettings::GreyRange;

std::vector<Setting> settings_of_layer(Layer& layer) {
  return {text("material", "", layer.material, "name of a material"),
          number("thickness_mm", "", layer.thickness_mm, Range::positive(), "thickness of the layer")};
}

bool parse_layer(const std::string&, const std::string& rest, Layer& layer) {
  layer.thickness_mm = parse_number(rest);
  return layer.thickness_mm && *layer.thickness_mm > 0;
}

bool is_label(double value) { return value >= 0 && value <= 65535 && value == std::floor(value); }

std::vector<Setting> settings_of_labels(Labels& labels) {
  Setting values{"values", "", "labels of the material", "a list of whole numbers from 0 to 65535",
                 Setting::Kind::numbers};
  values.assign = [&labels](const Value& value) {
    labels.values = std::get<std::vector<double>>(value);
    bool good = !labels.values.empty();
    for (const double label : labels.values) good = good && is_label(label);
    return good;
  };
  return {text("material", "", labels.material, "name of a material"), std::move(values)};
}

bool parse_labels(const std::string&, const std::string& rest, Labels& labels) {
  for (const std::string& part : split(rest, ',')) {
    const std::optional<double> label = parse_number(part);
    if (!label || !is_label(*label)) return false;
    labels.values.push_back(*label);
  }
  return true;
}

std::vector<Setting> settings_of_grey(GreyRange& range) {
  return {text("material", "", range.material, "name of a material"),
          number("from", "", range.from, Range::any(), "lowest grey value"),
          number("to", "", range.to, Range::any(), "grey value where the range ends")};
}

bool parse_grey(const std::string&, const std::string& rest, GreyRange& range) {
  const std::vector<std::string> ends = split(rest, ':');
  if (ends.size() != 2 || (ends[0].empty() && ends[1].empty())) return false;
  if (!ends[0].empty() && !(range.from = parse_number(ends[0]))) return false;
  return ends[1].empty() || (range.to = parse_number(ends[1]));
}

using Shell = WorkpieceSettings::Shell;

std::vector<Setting> settings_of_shell(Shell& shell) {
  return {text("material", "", shell.material, "name of a material, or empty"),
          text("object", "", shell.object, "name of an object in the file")};
}

bool parse_shell(const std::string&, const std::string& rest, Shell& shell) {
  shell.object = rest;
  return true;
}

}  // namespace

std::vector<Setting> settings_of(WorkpieceSettings& w) {
  const Range any = Range::any(), positive = Range::positive();
  std::vector<Setting> settings = {
      path("workpiece.source", "--workpiece", w.source,
           "source of the workpiece: block, slab, molar, or a file or folder", built_in_workpieces()),
      number("workpiece.voxel_mm", "--voxel_mm", w.voxel_mm, Range{0, kMaxVoxelSize / units::mm, true},
             "edge length of a voxel [0.1; for a volume its smallest spacing]"),
      vector("workpiece.size_mm", "--size_mm", w.size_mm, positive,
             "block, slab: size along x, y, z; one corner is at the origin"),
      text("workpiece.material", "--material", w.material,
           "block, mesh, .vdb of another program: name of the material"),
      table_list<Shell>("workpiece.shells", "--shell", w.shells, "MATERIAL=OBJECT, where MATERIAL may be empty",
                        "mesh with several objects: material inside one object; repeat the flag for each object",
                        &settings_of_shell, &parse_shell),
      table_list<Layer>("workpiece.layers", "--layer", w.layers, "MATERIAL=THICKNESS_MM",
                        "slab: one layer; repeat the flag from the top down", &settings_of_layer, &parse_layer),
      table_list<Labels>("workpiece.labels", "--label", w.labels, "MATERIAL=LABEL,LABEL...",
                         "volume: labels of one material; repeat the flag for each material", &settings_of_labels,
                         &parse_labels),
      choice("workpiece.unclaimed_labels", "--unclaimed_labels", w.unclaimed_labels,
             "volume of labels: treatment of labels without a material [refuse]"),
      table_list<GreyRange>("workpiece.grey", "--grey", w.grey, "MATERIAL=FROM:TO, where one end may be left out",
                            "volume: grey values of one material; repeat the flag for each material", &settings_of_grey,
                            &parse_grey),
      number("workpiece.grade_low", "--grade_low", w.grade_low, any,
             "volume: grey value where the graded material begins; its constants vary up to grade_high"),
      number("workpiece.grade_high", "--grade_high", w.grade_high, any, "volume: grey value at which the grade ends"),
      text("workpiece.grade_at_low", "--grade_at_low", w.grade_at_low, "volume: material at grade_low"),
      text("workpiece.grade_at_high", "--grade_at_high", w.grade_at_high, "volume: material at grade_high"),
      vector("workpiece.spacing_mm", "--spacing_mm", w.spacing_mm, positive,
             "volume: distance between samples; replaces the spacing of the file"),
      numbers("workpiece.crop_mm", "--crop_mm", w.crop_mm, 6, any,
              "volume: keep only the box from its lower corner x, y, z to its upper corner x, y, z"),
      boolean("workpiece.largest_component", "--largest_component", w.largest_component,
              "volume: keep only the largest connected piece"),
      text("workpiece.fill_cavities", "--fill_cavities", w.fill_cavities,
           "volume of labels: material that fills enclosed cavities"),
      number("workpiece.close_gaps_mm", "--close_gaps_mm", w.close_gaps_mm, positive,
             "fill_cavities: also fill holes and slits that a ball of this radius cannot enter"),
      boolean("workpiece.partial_volume", "--partial_volume", w.partial_volume,
              "volume of grey values: border voxels get the material behind the border [true]"),
      text("workpiece.dicom_series", "--dicom_series", w.dicom_series,
           "folder of DICOM files: Series Instance UID of the series to read"),
      numbers("workpiece.raw_dims", "--raw_dims", w.raw.dims, 3, Range::between(1, 65535),
              "file without a header: number of samples along x (fastest), y, z"),
      text("workpiece.raw_type", "--raw_type", w.raw.type,
           "file without a header: type of a value: uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32 "
           "or float64"),
      boolean("workpiece.raw_big_endian", "--raw_big_endian", w.raw.big_endian,
              "file without a header: values are big-endian"),
      integer("workpiece.raw_skip_bytes", "--raw_skip_bytes", w.raw.skip_bytes, 0, 1e12,
              "file without a header: number of bytes before the first value [0]"),
      number("workpiece.unit_mm", "--unit_mm", w.unit_mm, positive,
             "mesh, .vdb of another program: length of one unit of the file [1; for glTF 1000, because glTF is in "
             "metres]"),
      text("workpiece.grid", "--grid", w.grid, ".vdb of another program: name of the grid"),
      choice("workpiece.grid_kind", "--grid_kind", w.grid_kind,
             ".vdb of another program: meaning of its values [from_class: the grid class in the file]"),
      boolean("workpiece.large", "--large", w.large,
              "mesh, volume: build the workpiece even if it needs more than 4 GiB or ten minutes"),
  };
  settings.push_back(w.materials.setting());
  return settings;
}

}  // namespace hapticut::settings
