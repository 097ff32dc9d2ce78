// SPDX-License-Identifier: Apache-2.0
// Workpieces from built-in shapes and from files.
#include <algorithm>
#include <filesystem>
#include <set>

#include "build/voxel_amounts.hpp"
#include "hapticut/build/molar.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "io/file_errors.hpp"
#include "settings/required.hpp"
#include "settings/workpiece_settings.hpp"
#ifdef HAPTICUT_HAS_IMPORT
#include "settings/mesh_source.hpp"
#include "settings/volume_source.hpp"
#endif

namespace hapticut::settings {
namespace {

using Source = WorkpieceSettings;

/// Names of the settings that are set.
std::set<std::string> given_settings(const Source& s) {
  std::set<std::string> given;
  const auto note = [&](const char* name, bool is_set) {
    if (is_set) given.insert(name);
  };
  note("voxel_mm", s.voxel_mm.has_value());
  note("size_mm", s.size_mm.has_value());
  note("material", !s.material.empty());
  note("shells", !s.shells.empty());
  note("layers", !s.layers.empty());
  note("labels", !s.labels.empty());
  note("unclaimed_labels", s.unclaimed_labels.has_value());
  note("grey", !s.grey.empty());
  note("grade_low", s.grade_low.has_value());
  note("grade_high", s.grade_high.has_value());
  note("grade_at_low", !s.grade_at_low.empty());
  note("grade_at_high", !s.grade_at_high.empty());
  note("spacing_mm", s.spacing_mm.has_value());
  note("crop_mm", !s.crop_mm.empty());
  note("largest_component", s.largest_component);
  note("fill_cavities", !s.fill_cavities.empty());
  note("close_gaps_mm", s.close_gaps_mm.has_value());
  note("partial_volume", s.partial_volume.has_value());
  note("dicom_series", !s.dicom_series.empty());
  note("raw_dims", !s.raw.dims.empty());
  note("raw_type", !s.raw.type.empty());
  note("raw_big_endian", s.raw.big_endian);
  note("raw_skip_bytes", s.raw.skip_bytes > 0);
  note("unit_mm", s.unit_mm.has_value());
  note("grid", !s.grid.empty());
  note("grid_kind", s.grid_kind.has_value());
  note("large", s.large);
  return given;
}

void refuse_all_but(const Source& s, const std::set<std::string>& used) {
  settings::refuse_all_but(s, used, s.source + " does not use it");
}

double voxel_size(const Source& s) { return s.voxel_mm.value_or(0.1) * units::mm; }

Box box_of(const Source& s) {
  if (!s.size_mm) fail_missing("workpiece.size_mm"_name, s.source);
  return {Vec3::Zero(), *s.size_mm * units::mm};
}

Workpiece make_block(const Source& s) {
  refuse_all_but(s, {"voxel_mm", "size_mm", "material"});
  if (s.material.empty()) fail_missing("workpiece.material"_name, s.source);
  return build_block(box_of(s), voxel_size(s), s.materials.find(s.material));
}

Workpiece make_slab(const Source& s) {
  refuse_all_but(s, {"voxel_mm", "size_mm", "layers"});
  if (s.layers.empty()) throw Error("a slab needs at least one layer. Set " + "workpiece.layers"_name + ".");
  std::vector<hapticut::Layer> layers;
  for (const Source::Layer& layer : s.layers) {
    if (layer.material.empty() || !layer.thickness_mm)
      throw Error("a layer of the slab has no material or no thickness_mm; each layer needs both.");
    layers.push_back({s.materials.find(layer.material), *layer.thickness_mm * units::mm});
  }
  const Box box = box_of(s);
  Workpiece slab = build_layered_slab(box, voxel_size(s), layers);
  const Vec3 size = box.max - box.min;
  ByMaterial<double> wanted{};  // [m^3]
  double left = size.z();
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const double thickness = std::min(left, layers[n].thickness);
    left -= thickness;
    const double noise = 1e-6 * voxel_size(s);  // error of what the layers above leave of the box
    wanted[n + 1] = thickness > noise ? size.x() * size.y() * thickness : 0;
  }
  if (const std::string found = differences_of(slab, wanted, "layers"); s.warn && !found.empty())
    s.warn(found + "Choose smaller voxels, or layers of whole voxels.");
  return slab;
}

/// The materials of the workpiece with the user's changes.
Workpiece with_changed_materials(Workpiece workpiece, const MaterialChanges& changes) {
  if (changes.empty()) return workpiece;
  MaterialTable table;
  for (const Material& material : workpiece.materials().all()) table.add(changes.changed(material));
  workpiece.set_materials(std::move(table));
  return workpiece;
}

Workpiece read_vdb(const Source& s) {
  refuse_all_but(s, {"material", "unit_mm", "grid", "grid_kind"});
  if (s.material.empty()) {
    if (s.unit_mm || !s.grid.empty() || s.grid_kind)
      throw Error(
          "workpiece.material"_name +
          " is missing; a .vdb of another program needs it in addition to unit_mm, grid or grid_kind. A .vdb of "
          "hapticut needs none of the four. Set " +
          "workpiece.material"_name + ", or leave the others out.");
    if (s.materials.sharpness)
      throw Error("tool.sharpness"_name + " = " + std::string(name_or_null(*s.materials.sharpness)) +
                  " was given, but the materials of '" + s.source +
                  "' keep the constants of the file. Leave it out, or set the constants in [material].");
    return with_changed_materials(load_vdb(s.source), s.materials);
  }
  VdbImport import;
  import.material = s.materials.find(s.material);
  import.grid = s.grid;
  import.unit_mm = s.unit_mm.value_or(1);
  import.kind = s.grid_kind.value_or(import.kind);
  return load_vdb(s.source, import);
}

/// Runs a function that makes a workpiece from a file. @throws Error that names the file
template <class Make>
Workpiece naming_source(const Source& s, const Make& make) {
  try {
    return make();
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    throw Error("cannot make a workpiece from '" + s.source + "': " + error.sentence());
  }
}

Workpiece make_molar(const Source& s) {
  refuse_all_but(s, {"voxel_mm"});
  Workpiece molar = build_molar(voxel_size(s));
  MaterialTable table;
  for (const Material& material : molar.materials().all()) table.add(s.materials.find(material.name));
  molar.set_materials(std::move(table));
  return molar;
}

}  // namespace

void refuse_all_but(const WorkpieceSettings& settings, const std::set<std::string>& used, const std::string& because) {
  for (const std::string& name : given_settings(settings))
    if (!used.contains(name))
      throw Error(Name("workpiece." + name) + " is set; must be left out, because " + because +
                  ". Leave it out, or choose another workpiece: docs/command-line.md lists the settings of each.");
}

std::vector<std::string> built_in_workpieces() { return {"block", "slab", "molar"}; }

bool is_volume(const WorkpieceSettings& s) {
  for (const std::string& known : built_in_workpieces())
    if (s.source == known) return false;
  if (extension_in_lower_case(s.source) == ".vdb" || is_mesh_file(s.source)) return false;
  return !is_missing(s.source);
}

namespace {

Workpiece made_or_read(const WorkpieceSettings& s) {
  if (s.source.empty())
    throw Error("workpiece.source"_name + " is missing. Set " + "workpiece.source"_name +
                " to block, slab, molar or a file.");
  if (s.source == "block") return make_block(s);
  if (s.source == "slab") return make_slab(s);
  if (s.source == "molar") return make_molar(s);
  if (const std::string reason = unreachable(s.source); !reason.empty()) cannot_read(s.source, reason);
  if (is_missing(s.source))
    throw Error("there is no file '" + std::filesystem::absolute(s.source).string() +
                "', and no built-in workpiece of that name." +
                suggestion(std::filesystem::path(s.source).filename().string(), built_in_workpieces()) +
                " Check the name: in a settings file it is relative to that file, in a flag to the working folder.");
  if (extension_in_lower_case(s.source) == ".vdb") return read_vdb(s);
#ifdef HAPTICUT_HAS_IMPORT
  if (is_mesh_file(s.source)) {
    refuse_all_but(s, {"voxel_mm", "material", "shells", "unit_mm", "large"});
    return naming_source(s, [&] { return make_workpiece_from_mesh(s); });
  }
  refuse_all_but(s, {"voxel_mm",          "labels",        "unclaimed_labels", "grey",           "grade_low",
                     "grade_high",        "grade_at_low",  "grade_at_high",    "spacing_mm",     "crop_mm",
                     "largest_component", "fill_cavities", "close_gaps_mm",    "partial_volume", "dicom_series",
                     "raw_dims",          "raw_type",      "raw_big_endian",   "raw_skip_bytes", "large"});
  return naming_source(s, [&] { return make_workpiece_from_volume(s); });
#else
  throw Error(
      "'" + s.source +
      "' cannot be read, because this program was built without its import component and reads only .vdb files. "
      "Build it with HAPTICUT_WITH_IMPORT=ON.");
#endif
}

}  // namespace

Workpiece make_workpiece(WorkpieceSettings s, CutterKind cutter, std::optional<Sharpness> sharpness) {
  s.materials.cutter = cutter;
  s.materials.sharpness = sharpness;
  Workpiece workpiece = made_or_read(s);
  s.materials.require_known(workpiece.materials());
  return workpiece;
}

}  // namespace hapticut::settings
