// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <iterator>

#include "io/recording/recording_columns.hpp"
#include "io/recording/recording_file.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/recording/room_on_disk.hpp"
#include "io/recording/settings_archive.hpp"
#include "io/vdb/vdb_bytes.hpp"

namespace hapticut {
namespace {

constexpr hsize_t kChunk = 256;                 // rows
constexpr std::uint64_t kHeaderRoom = 2 << 20;  // [bytes] more than all but the workpiece needs

/// An empty data set whose first dimension has no end.
hdf5::DataSet create_endless(hid_t group, const std::string& name, hid_t type, const std::vector<hsize_t>& row_shape) {
  std::vector<hsize_t> now = {0}, most = {H5S_UNLIMITED}, chunk = {kChunk};
  for (const hsize_t length : row_shape) {
    now.push_back(length);
    most.push_back(length);
    chunk.push_back(length);
  }
  const hdf5::DataSpace space(H5Screate_simple(int(now.size()), now.data(), most.data()), "making room for " + name);
  const hdf5::Properties properties(H5Pcreate(H5P_DATASET_CREATE), "creating " + name);
  hdf5::checked(H5Pset_chunk(properties.get(), int(chunk.size()), chunk.data()), "creating " + name);
  return {H5Dcreate2(group, name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
          "creating " + name};
}

void write_info(hid_t file, const RecordingInfo& info) {
  hdf5::write_attribute(file, "content", kMagic);
  hdf5::write_attribute(file, "format", info.format);
  hdf5::write_attribute(file, "version", info.version);
  hdf5::write_attribute(file, "commit", info.commit);
  hdf5::write_attribute(file, "compiler", info.compiler);
  hdf5::write_attribute(file, "cpu", info.cpu);
  hdf5::write_attribute(file, "begun", info.begun);
  hdf5::write_attribute(file, "device", info.device);
  hdf5::write_attribute(file, "note", info.note);
  hdf5::write_attribute(file, "frames",
                        "W world = workpiece, H handle of the tool (origin Ho), T head of the tool, B base of the "
                        "device, S stylus; X_AB takes coordinates of B to A");
}

void write_workpiece(hid_t file, const Workpiece& workpiece, const std::string& vdb,
                     const std::filesystem::path& source) {
  const hdf5::Group group = hdf5::create_group(file, kWorkpieceGroup);
  hdf5::write_attribute(group.get(), "hash", workpiece.hash());
  hdf5::write_attribute(group.get(), "full_hash", full_hash(workpiece));
  if (!source.empty()) {
    hdf5::write_attribute(group.get(), "file", std::filesystem::absolute(source).string());
    return;
  }
  const hdf5::DataSet set =
      hdf5::write_array(group.get(), kWorkpieceBytes, reinterpret_cast<const std::uint8_t*>(vdb.data()), {vdb.size()});
  hdf5::write_attribute(set.get(), "meaning", "the workpiece before the first step, an OpenVDB file byte by byte");
}

void create_steps(hid_t file, bool with_device) {
  const hdf5::Group group = hdf5::create_group(file, kStepsGroup);
  std::string names;
  for (const Column& column : recording_columns()) {
    if (column.side == Column::Side::device && !with_device) continue;
    const hdf5::DataSet set = create_endless(group.get(), column.name, hdf5::type_of(column.kind).file, column.shape);
    hdf5::write_attribute(set.get(), "unit", column.unit);
    if (!column.frame.empty()) hdf5::write_attribute(set.get(), "frame", column.frame);
    hdf5::write_attribute(set.get(), "meaning", column.meaning);
    if (!names.empty()) names += ',';
    names += column.name;
  }
  hdf5::write_attribute(group.get(), kFieldsAttribute, names);
}

void write_effects(hid_t file, const Effects& effects) {
  const hdf5::Group group = hdf5::create_group(file, kEffectsGroup);
  const hdf5::DataSet first = create_endless(group.get(), kFirstSteps, H5T_STD_U64LE, {});
  hdf5::write_attribute(first.get(), "meaning", "number of the first step with these effects");
  const hdf5::DataSet values = create_endless(group.get(), kEffectValues, H5T_IEEE_F64LE, {kEffectNumbers});
  hdf5::write_attribute(values.get(), "columns", effect_names());
  const EffectNumbers numbers = pack(effects);
  const hsize_t one = 1, row[] = {1, kEffectNumbers};
  const std::uint64_t zero = 0;
  hdf5::checked(H5Dset_extent(first.get(), &one), "writing effects");
  hdf5::checked(H5Dset_extent(values.get(), row), "writing effects");
  hdf5::checked(H5Dwrite(first.get(), H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &zero), "writing effects");
  hdf5::checked(H5Dwrite(values.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
                "writing effects");
}

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x100000001b3ULL;
  return hash ^ (hash >> 29);
}

}  // namespace

hdf5::Properties newest_format() {
  hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "preparing");
  hdf5::checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "preparing");
  return access;
}

void write_recording_header(const std::filesystem::path& path, const RecordingInfo& info, const Simulation& simulation,
                            const RecorderOptions& options) {
  std::string vdb;
  if (options.workpiece_file.empty()) vdb = vdb_bytes(simulation.workpiece());
  RoomOnDisk(path).require(vdb.size() + kHeaderRoom);
  hdf5::File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, newest_format().get()), "creating it");
  write_info(file.get(), info);
  write_settings(file.get(), simulation.config(), simulation.tool(), simulation.workpiece().materials());
  write_workpiece(file.get(), simulation.workpiece(), vdb, options.workpiece_file);
  write_effects(file.get(), simulation.config().effects);
  if (!info.device.empty()) write_capabilities(file.get(), options.capabilities);
  create_steps(file.get(), !info.device.empty());
  if (file.reset() < 0) hdf5::fail("closing it");
}

void write_recording_end(hid_t file, std::uint64_t lost, std::uint64_t workpiece_hash) {
  hdf5::write_attribute(file, "lost", lost);
  hdf5::write_attribute(file, "workpiece_hash_at_end", workpiece_hash);
  hdf5::write_attribute(file, "closed", 1);
}

void note_result(const StepResult& result, RecordedStep& row) noexcept {
  row.force = result.force;
  row.torque = result.torque;
  row.model = result.model;
  row.removed_volume = result.removed_volume;
  row.removed_voxels = result.removed_voxels.size();
  row.removed_voxels_hash = 0;
  for (const RemovedVoxel& voxel : result.removed_voxels) {
    for (const int i : voxel.index) row.removed_voxels_hash = mix(row.removed_voxels_hash, std::uint32_t(i));
    row.removed_voxels_hash = mix(row.removed_voxels_hash, voxel.material);
  }
  row.contact = result.contact;
  row.energy = result.energy;
  row.spindle = result.spindle;
  row.sub_steps = result.sub_steps;
  row.status = result.status;
}

std::uint64_t full_hash(const Workpiece& workpiece) {
  std::uint64_t hash = workpiece.hash();
  const auto mix_number = [&](double number) { hash = mix(hash, std::bit_cast<std::uint64_t>(number)); };
  mix_number(workpiece.voxel_size());
  for (const double number : workpiece.frame().X_WV.rotation.reshaped()) mix_number(number);
  for (const double number : workpiece.frame().X_WV.translation) mix_number(number);
  workpiece.for_each_block([&](const BlockView& block) {
    if (block.centroid == nullptr) return;
    for (int n = 0; n < kBlockVoxels; ++n) hash = mix(hash, std::uint32_t(block.centroid[n]));
  });
  return hash;
}

}  // namespace hapticut
