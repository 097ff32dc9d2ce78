// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <iterator>

#include "io/recording/disk_space.hpp"
#include "io/recording/recording_columns.hpp"
#include "io/recording/recording_file.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/recording/settings_archive.hpp"
#include "io/vdb/vdb_bytes.hpp"

namespace hapticut {
namespace {

constexpr std::uint64_t kMaxHeaderBytes = 2 << 20;  // [bytes] upper bound of the header without the workpiece

void write_info(hid_t file, const RecordingInfo& info) {
  hdf5::write_attribute(file, "content", kMagic);
  hdf5::write_attribute(file, "format", info.format);
  for (const auto& [name, text] : kInfoTexts) hdf5::write_attribute(file, name, info.*text);
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
    const auto set = hdf5::Appender::create(group.get(), column.name, column.kind, column.shape);
    hdf5::write_attribute(set.get(), "unit", column.unit);
    if (!column.frame.empty()) hdf5::write_attribute(set.get(), "frame", column.frame);
    hdf5::write_attribute(set.get(), "meaning", column.meaning);
    append_item(names, column.name);
  }
  hdf5::write_attribute(group.get(), kFieldsAttribute, names);
}

void write_effects(hid_t file, const Effects& effects) {
  const hdf5::Group group = hdf5::create_group(file, kEffectsGroup);
  auto first = hdf5::Appender::create(group.get(), kFirstSteps, ValueType::uint64, {});
  hdf5::write_attribute(first.get(), "meaning", "number of the first step with these effects");
  auto values = hdf5::Appender::create(group.get(), kEffectValues, ValueType::float64, {kEffectNumbers});
  hdf5::write_attribute(values.get(), "columns", effect_names());
  const EffectNumbers numbers = pack(effects);
  const std::uint64_t zero = 0;
  first.append(&zero, 1);
  values.append(numbers.data(), 1);
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
  DiskSpace(path).require(vdb.size() + kMaxHeaderBytes);
  hdf5::File file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, newest_format().get()), "creating it");
  write_info(file.get(), info);
  write_settings(file.get(), simulation.config(), simulation.tool(), simulation.workpiece().materials());
  write_workpiece(file.get(), simulation.workpiece(), vdb, options.workpiece_file);
  write_effects(file.get(), simulation.config().effects);
  if (!info.device.empty()) write_capabilities(file.get(), options.capabilities);
  create_steps(file.get(), !info.device.empty());
  if (file.reset() < 0) hdf5::fail("closing it");
}

void write_recording_end(hid_t file, std::uint64_t lost, std::optional<std::uint64_t> workpiece_hash) {
  hdf5::write_attribute(file, "lost", lost);
  if (workpiece_hash) hdf5::write_attribute(file, "workpiece_hash_at_end", *workpiece_hash);
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

DeviceState reading_of_handle(const RecordedStep& step) noexcept {
  DeviceState state;
  state.X_BS = step.input.X_WH;
  state.velocity = step.input.V_WH;
  state.time = step.time;
  state.sequence = step.number + 1;
  return state;
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
