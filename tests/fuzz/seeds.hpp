// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <filesystem>
#include <string>
#include <vector>

#include "hapticut/core/units.hpp"
#include "hapticut/import/mesh/meshes.hpp"
#include "hapticut/import/volume/volumes.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "hapticut/workpiece/material_presets.hpp"
#include "support/dicom_files.hpp"
#include "support/meshes.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"
#include "support/volume_files.hpp"

/// @file
/// Small valid files in every supported format: the seeds of mutants and fuzzers. Each format has a folder of its name.
namespace hapticut::test {

inline constexpr const char* kFormats[] = {"dicom", "nrrd", "nifti", "meta",      "slices",   "inv3",  "stl",    "ply",
                                           "obj",   "off",  "vdb",   "recording", "settings", "poses", "profile"};

namespace seeds {

inline std::vector<std::int16_t> ramp(int count) {
  std::vector<std::int16_t> values(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) values[std::size_t(n)] = std::int16_t(n * 3 - 20);
  return values;
}

inline std::string nrrd(const std::string& fields, const std::string& data) {
  return "NRRD0004\ntype: short\ndimension: 3\nsizes: 4 3 5\nendian: little\n" + fields + "\n" + data;
}

inline std::string as_text(const std::vector<std::int16_t>& values) {
  std::string text;
  for (const std::int16_t value : values) text += std::to_string(value) + " ";
  return text;
}

inline void volumes(const std::filesystem::path& folder) {
  const std::vector<std::int16_t> values = ramp(60);
  const std::string data = little(values);
  const std::string oblique =
      "space: left-posterior-superior\nspace directions: (0.1,0,0) (0,0.2,0) (0,0,0.7)\nspace origin: (1,2,3)\n";
  write_bytes(folder / "nrrd/raw.nrrd", nrrd(oblique + "encoding: raw\n", data));
  write_bytes(folder / "nrrd/gzip.nrrd", nrrd("spacings: 1 1 2\naxis mins: 0 0 0\nencoding: gzip\n", gzipped(data)));
  write_bytes(folder / "nrrd/text.nrrd",
              nrrd("encoding: ascii\nspacings: 90 90 90\nspace units: \"um\" \"um\" \"um\"\n", as_text(values)));
  write_bytes(folder / "nrrd/skip.nrrd",
              nrrd("spacings: 1 1 1\nencoding: raw\nbyte skip: -1\nline skip: 1\n", "a line\n" + data));
  NiftiFile nifti;
  nifti.values = values;
  write_bytes(folder / "nifti/plain.nii", nifti.bytes());
  nifti.rows = {0.1F, 0, 0, 1, 0, 0.2F, 0, 2, 0, 0, 0.7F, 3};
  write_bytes(folder / "nifti/big.nii", nifti.bytes(true));
  nifti.quaternion = {0, 0, 0.7F, 1, 2, 3};
  nifti.slope = 2;
  write_bytes(folder / "nifti/packed.nii.gz", gzipped(nifti.bytes()));
  const std::string meta =
      "NDims = 3\nDimSize = 4 3 5\nElementType = MET_SHORT\nElementSpacing = 0.1 0.2 0.7\nOffset = 1 2 3\n";
  write_bytes(folder / "meta/plain.mha", meta + "ElementDataFile = LOCAL\n" + data);
  write_bytes(folder / "meta/packed.mha", meta + "CompressedData = True\nElementDataFile = LOCAL\n" + gzipped(data));
  const std::vector<std::int16_t> slice(values.begin(), values.begin() + 12);
  const std::string plain = dicom_file(dicom_slice(4, 3, 0.7, slice));
  write_bytes(folder / "dicom/plain.dcm", plain);
  write_bytes(folder / "slices/a1.png", png_slice(4, 3, slice));
  write_bytes(folder / "slices/a1.tif", tiff_slice(4, 3, slice));
  write_bytes(folder / "inv3/a.inv3", invesalius_project({4, 3, 5}, values));
}

inline void meshes(const std::filesystem::path& folder) {
  const TriangleMesh ball = ball_mesh(Vec3::Zero(), 2e-3, 4);
  write_stl(ball, folder / "stl/binary.stl");
  write_bytes(folder / "stl/text.stl",
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
              "endsolid\n");
  write_ply(ball, folder / "ply/binary.ply");
  write_bytes(folder / "ply/text.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
              "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_obj(ball, folder / "obj/ball.obj");
  write_bytes(folder / "obj/mixed.obj",
              "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2//2 3 -1\ng b\nf -1 \\\n-2 -3\n");
  write_bytes(folder / "off/a.off",
              "OFF\n# a comment\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
}

inline void texts(const std::filesystem::path& folder) {
  write_bytes(folder / "settings/a.toml",
              "[workpiece]\nsource = \"block\"\nsize_mm = [6, 6, 3]\nvoxel_mm = 0.2\nmaterial = \"mine\"\n"
              "[material.mine]\nbased_on = \"cortical_bone\"\nrelative_stiffness = 0.9\n[tool]\nhead = \"sphere\"\n"
              "radius_mm = 1\nspindle_rpm = 3e4\n[path]\nkind = \"line\"\nfrom_mm = [-2, 3, 2.5]\nto_mm = [8, 3, 2.5]\n"
              "feed_mm_per_s = 20\n");
  write_bytes(folder / "settings/b.toml",
              "[workpiece]\nsource = \"slab\"\nsize_mm = [6.5, 6.5, 3]\n[[workpiece.layers]]\nmaterial = \"enamel\"\n"
              "thickness_mm = 1.0\n[tool]\nhead = \"pear\"\ndiameter_mm = 1.2\nlength_mm = 3\nhandle = \"L\"\n"
              "handle_length_mm = 100\nhandle_neck_mm = 12\nhandle_bend_deg = 115\n[path]\nkind = \"spiral\"\n"
              "center_mm = [0, 0, 0]\nstart_radius_mm = 0\nend_radius_mm = 2\npitch_mm = 0.5\ndepth_mm = 1\n"
              "feed_mm_per_s = 4\napproach_mm = 1\n[simulation]\nrate_Hz = 500\nthesis_mode = true\n[output]\n"
              "json = \"a.json\"\n");
  write_bytes(folder / "poses/a.csv",
              "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n# a comment\n1,2,3,4,0.6,0.8,0,0\n");
  write_bytes(folder / "poses/b.csv",
              "\xEF\xBB\xBFr00,r01,r02,r10,r11,r12,r20,r21,r22,t_s,x_mm,y_mm,z_mm,remark\r\n"
              "1,0,0,0,1,0,0,0,1,0,1e-3,2,3,a\r\n0,-1,0,1,0,0,0,0,1,0.5,4,5,6,\r\n");
  write_bytes(folder / "profile/b.csv", "z_mm, rho_mm\n1,0\n1.5,0.75\n4,0.75\n4,0\n");
  write_bytes(folder / "profile/a.csv",
              "rho_mm,z_mm,radius_mm,kind\n0,0,0,cutting\n0.5,0.2,1,cutting\n0.5,3,0,smooth\n");
}

}  // namespace seeds

/// Writes all seeds below a folder.
inline void write_seeds(const std::filesystem::path& folder) {
  for (const char* format : kFormats) std::filesystem::create_directories(folder / format);
  seeds::volumes(folder);
  seeds::meshes(folder);
  seeds::texts(folder);
  const Box box = {Vec3::Zero(), Vec3::Constant(2e-3)};
  save_vdb(build_block(box, 0.15e-3, presets::cortical_bone()), folder / "vdb/a.vdb");
  save_vdb(build_sphere(Vec3::Zero(), 0.5e-3, 0.15e-3, presets::dentin()), folder / "vdb/partly_filled.vdb");
  record_scene(folder / "recording/a.h5", "axial_flat", 20);
}

}  // namespace hapticut::test
