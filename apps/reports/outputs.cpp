// SPDX-License-Identifier: Apache-2.0
#include "reports/outputs.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "hapticut/core/units.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/surface/extract_surface.hpp"
#include "import/mesh/mesh_extensions.hpp"
#include "import/volume/density_file.hpp"
#include "io/atomic_file.hpp"
#include "reports/json_file.hpp"
#ifdef HAPTICUT_HAS_IMPORT
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "hapticut/io/picture/picture.hpp"
#include "import/mesh/mesh_formats.hpp"
#include "io/picture/blank_picture.hpp"
#endif

namespace hapticut::apps {

using namespace settings;

namespace {

std::string names_of(StepStatus status) {
  std::string names;
  for_each_bit<StepStatus>([&](StepStatus bit, const std::string& name) {
    if (has_any(status, bit)) names += (names.empty() ? "" : "|") + name;
  });
  return names.empty() ? "ok" : names;
}

bool has_extension(const std::string& path, const std::vector<std::string>& extensions) {
  return std::ranges::find(extensions, extension_in_lower_case(path)) != extensions.end();
}

/// The sentence about a file of another extension; empty if there is nothing to say.
std::string wrong_extension(const std::string& path, const std::vector<std::string>& extensions) {
  if (path.empty() || has_extension(path, extensions)) return "";
  return "cannot write '" + path + "': its extension must be one of " + joined(extensions) + ".";
}

/// Checks that this program can write a file of this format.
void require_writer([[maybe_unused]] const std::string& path) {
#ifndef HAPTICUT_HAS_IMPORT
  if (path.empty() || has_extension(path, {".vdb"})) return;
  throw Error(
      "cannot write '" + path +
      "', because this program was built without its import component and writes only .vdb files. Build it with "
      "HAPTICUT_WITH_IMPORT=ON.");
#endif
}

}  // namespace

std::vector<Setting> settings_of(OutputSettings& o) {
  return {
      json_setting(o.json),
      path("output.steps_csv", "--steps_csv", o.steps_csv, "CSV file with one line per step; -: to standard output",
           {kStandardOutput}),
      path("output.record", "--record", o.record, "recording of every step, for replay and export"),
      workpiece_file("output.save", "--save", o.workpiece, "remaining workpiece, .vdb or .nrrd"),
      path("output.surface", "--surface", o.surface, "surface of the remaining workpiece, .stl or .ply"),
      path("output.picture", "--picture", o.picture, "picture of the remaining workpiece, .png"),
      vector("output.picture_view", "--picture_view", o.picture_view, Range::any(),
             "direction of the picture, from the camera into the scene [-0.6,0.9,-0.8]"),
  };
}

Setting workpiece_file(std::string key, std::string flag, std::string& target, std::string meaning) {
  Setting setting = path(std::move(key), std::move(flag), target, std::move(meaning));
  setting.files = [&target, named = setting.files] {
    std::vector<std::filesystem::path> files = named();
    if (has_extension(target, {".nrrd"})) files.push_back(density_file(target));
    return files;
  };
  return setting;
}

Delivery delivery_of(const OutputSettings& outputs) {
  std::string wrong;
  for (const std::string& sentence :
       {wrong_extension(outputs.workpiece, {".vdb", ".nrrd"}), wrong_extension(outputs.surface, {".stl", ".ply"}),
        wrong_extension(outputs.picture, {".png"})})
    wrong += (wrong.empty() || sentence.empty() ? "" : " ") + sentence;
  if (!wrong.empty()) throw UsageError(wrong);
  for (const std::string& path : {outputs.workpiece, outputs.surface, outputs.picture}) require_writer(path);
  return Delivery({outputs.json, outputs.steps_csv},
                  {outputs.workpiece, outputs.surface, outputs.picture, outputs.record});
}

void check_workpiece_file(const std::string& path) {
  const std::string wrong = wrong_extension(path, {".vdb", ".nrrd", ".stl", ".ply"});
  if (!wrong.empty()) throw UsageError(wrong);
  require_writer(path);
  require_writable(path);
}

std::string warning_of_empty_file(const std::string& path, const Workpiece& workpiece) {
  constexpr std::int64_t kFew = 1000;  // voxels; more have a surface
  if (path.empty() || has_extension(path, {".vdb"}) || workpiece.solid_voxels() > kFew) return "";
  if (has_extension(path, {".nrrd"}))
    return workpiece.empty() ? "nothing is left of the workpiece, so '" + path + "' has one voxel, which is empty."
                             : "";
  if (!extract_surface(workpiece).mesh.triangles.empty()) return "";
  return "no surface is left of the workpiece, so '" + path + "' " +
         (has_extension(path, {".png"}) ? "shows the background alone." : "has no triangle.");
}

std::string warning_of_empty_outputs(const OutputSettings& outputs, const Workpiece& workpiece) {
  std::string sentences;
  for (const std::string& path : {outputs.workpiece, outputs.surface, outputs.picture}) {
    const std::string sentence = warning_of_empty_file(path, workpiece);
    sentences += (sentences.empty() || sentence.empty() ? "" : " ") + sentence;
  }
  return sentences;
}

#ifdef HAPTICUT_HAS_IMPORT
namespace {

/// Writes one empty voxel, because a volume cannot be without any.
void write_empty_nrrd(const std::string& path, const GridFrame& frame) {
  const auto write = [&]<class Value>(Volume<Value> volume, const std::filesystem::path& file) {
    volume.dims = {1, 1, 1};
    volume.spacing.setConstant(frame.voxel_size);
    volume.X_WG = frame.X_WV;
    volume.values = {Value(0)};
    write_nrrd(volume, file);
  };
  write(GreyVolume{}, density_file(path));
  write(LabelVolume{}, path);
}

}  // namespace

void write_workpiece(const std::string& path, const Workpiece& workpiece) {
  if (has_extension(path, {".nrrd"}))
    return workpiece.empty() ? write_empty_nrrd(path, workpiece.frame()) : write_nrrd(workpiece, path);
  if (has_extension(path, {".stl", ".ply"})) return write_surface(path, workpiece);
  save_vdb(workpiece, path);
}

void write_surface(const std::string& path, const Workpiece& workpiece) {
  const WorkpieceSurface surface = extract_surface(workpiece);
  if (surface.mesh.triangles.empty()) return write_without_triangles(path);
  if (has_extension(path, {".ply"})) return write_ply(colored(surface, workpiece.materials()), path);
  write_stl(surface.mesh, path);
}

void write_picture_of(const OutputSettings& outputs, const Workpiece& workpiece) {
  PictureOptions options;
  options.view_direction = outputs.picture_view.value_or(options.view_direction);
  const WorkpieceSurface surface = extract_surface(workpiece);
  if (surface.mesh.triangles.empty()) return write_blank_picture(options, outputs.picture);
  write_picture({colored(surface, workpiece.materials())}, options, outputs.picture);
}
#else
// `require_writer` has refused all formats that need io.
void write_workpiece(const std::string& path, const Workpiece& workpiece) { save_vdb(workpiece, path); }
void write_surface(const std::string&, const Workpiece&) {}
void write_picture_of(const OutputSettings&, const Workpiece&) {}
#endif

void write_steps(const std::string& path, const std::vector<StepRow>& rows) {
  const auto write = [&](std::ostream& stream) {
    stream << "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,force_x_N,force_y_N,force_z_N,torque_x_Nmm,torque_y_Nmm,torque_z_Nmm,"
              "removed_mm3,contact_voxels,status\n";
    char line[512];
    for (const StepRow& row : rows) {
      const Eigen::Quaterniond q(row.X_WT.rotation);
      const Vec3 p = row.X_WT.translation / units::mm, torque = row.torque / units::N_mm;
      std::snprintf(line, sizeof line, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%d,",
                    row.t, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), row.force.x(), row.force.y(), row.force.z(),
                    torque.x(), torque.y(), torque.z(), row.removed / units::mm3, row.contact_voxels);
      stream << line << names_of(row.status) << '\n';
    }
  };
  if (path != kStandardOutput) return write_atomically(path, write);
  std::ostringstream text;
  write(text);
  print_on_stdout(text.str());
}

}  // namespace hapticut::apps
