// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/recording.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <span>

#include "hapticut/io/vdb/vdb.hpp"
#include "io/file_errors.hpp"
#include "io/recording/recording_access.hpp"
#include "io/recording/recording_file.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/recording/settings_archive.hpp"
#include "io/vdb/vdb_bytes.hpp"

namespace hapticut {
namespace {

/// Runs a part of the reading.
/// @throws Error  with the name of the file in front of whatever went wrong
template <class Function>
auto reading(const std::filesystem::path& path, const Function& function) {
  const hdf5::Quiet quiet;
  try {
    return function();
  } catch (const std::bad_alloc&) {
    hdf5::be_quiet_at_exit();
    cannot_read(path, "there is not enough memory for it; it is too large or damaged.");
  } catch (const std::exception& error) {
    hdf5::be_quiet_at_exit();
    const std::string reason = error.what();
    cannot_read(path, reason + (reason.ends_with('.') ? "" : "."));
  }
}

/// Runs a part of the reading that builds what the settings in the file describe.
/// @throws Error  that says so: the reader has no other place to look for them
template <class Function>
auto settings_in_file(const Function& function) {
  try {
    return function();
  } catch (const hdf5::Failure&) {
    throw;
  } catch (const Error& error) {
    throw Error(std::string("in the settings inside it: ") + error.what());
  }
}

constexpr std::size_t kHead = 12;  // [bytes] of a file that say what it is

/// Whether a writer has the file open, or was killed while it had: a bit in the head of the file (HDF5 File Format
/// Specification, superblock version 3).
bool has_writer(std::string_view head) {
  constexpr std::size_t kVersion = 8, kFlags = 11;
  constexpr unsigned kWriterWithReaders = 4;
  return head.size() > kFlags && head[kVersion] == 3 && (unsigned(head[kFlags]) & kWriterWithReaders) != 0;
}

/// @param id    what HDF5 made of the file
/// @param head  its first bytes
hdf5::File require_open(hid_t id, std::string_view head) {
  hdf5::File file(id);
  if (file.valid()) return file;
  if (!head.starts_with("\x89HDF")) throw Error("it is not an HDF5 file, so not a recording of hapticut");
  hdf5::fail("it is a damaged HDF5 file; opening it");
}

hdf5::File open_file(const std::filesystem::path& path) {
  const std::string head = first_bytes(path, kHead);
  const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "preparing");
  constexpr unsigned kAttempts = 12;  // to read what the writer is just changing; HDF5's own 100 take minutes
  unsigned mode = H5F_ACC_RDONLY;
  if (has_writer(head)) {
    mode |= H5F_ACC_SWMR_READ;
    hdf5::checked(H5Pset_metadata_read_attempts(access.get(), kAttempts), "preparing");
  }
  return require_open(H5Fopen(path.c_str(), mode, access.get()), head);
}

/// The same of bytes, of which HDF5 makes a copy.
hdf5::File open_bytes(std::string bytes) {
  constexpr std::size_t kGrowth = 1 << 16;  // [bytes] that would be added; nothing is
  // HDF5 takes two that are open under the same name for the same.
  static std::atomic<std::uint64_t> opened{0};
  const std::string name = "bytes " + std::to_string(opened++);
  const hdf5::Properties access(H5Pcreate(H5P_FILE_ACCESS), "preparing");
  hdf5::checked(H5Pset_fapl_core(access.get(), kGrowth, /*backing_store=*/false), "preparing");
  hdf5::checked(H5Pset_file_image(access.get(), bytes.data(), bytes.size()), "preparing");
  return require_open(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.get()), std::string_view(bytes).substr(0, kHead));
}

RecordingInfo read_info(hid_t file) {
  if (!hdf5::has_attribute(file, "content") || hdf5::read_text_attribute(file, "content") != kMagic)
    throw Error("it is an HDF5 file, but not a recording of hapticut");
  RecordingInfo info;
  info.format = hdf5::read_number_attribute(file, "format");
  if (info.format < 1 || info.format > kRecordingFormat)
    throw Error("it has format " + std::to_string(info.format) + ", and this version of hapticut reads formats 1 to " +
                std::to_string(kRecordingFormat) + "; use a newer version");
  info.version = hdf5::read_text_attribute(file, "version");
  info.commit = hdf5::read_text_attribute(file, "commit");
  info.compiler = hdf5::read_text_attribute(file, "compiler");
  info.cpu = hdf5::read_text_attribute(file, "cpu");
  info.begun = hdf5::read_text_attribute(file, "begun");
  info.device = hdf5::read_text_attribute(file, "device");
  info.note = hdf5::read_text_attribute(file, "note");
  info.closed = hdf5::has_attribute(file, "closed");
  if (info.closed) info.workpiece_hash_at_end = hdf5::read_number_attribute(file, "workpiece_hash_at_end");
  return info;
}

std::vector<RecordedEffects> read_effects(hid_t file, double update_rate) {
  if (!hdf5::exists(file, kEffectsGroup)) throw Error("it lacks the group 'effects'");
  const hdf5::Group group = hdf5::open_group(file, kEffectsGroup);
  const auto first = hdf5::read_array<std::uint64_t>(group.get(), kFirstSteps);
  const auto values = hdf5::read_array<double>(group.get(), kEffectValues);
  const hdf5::DataSet set = hdf5::open_data_set(group.get(), kEffectValues);
  const std::string names = hdf5::read_text_attribute(set.get(), "columns");
  const std::size_t width = std::size_t(std::count(names.begin(), names.end(), ',')) + 1;
  const std::vector<hsize_t> shape = hdf5::shape_of(set.get());
  if (shape.size() != 2 || shape[1] != width) throw Error("its 'effects/values' has not as many columns as names");
  // The writer may have been killed between the two.
  const std::size_t count = std::min(first.size(), values.size() / width);
  if (count == 0 || first[0] != 0) throw Error("its group 'effects' does not say what was in force at the first step");
  std::vector<RecordedEffects> effects(count);
  for (std::size_t n = 0; n < count; ++n) {
    effects[n] = {first[n], unpack(names, std::span(values).subspan(n * width, width))};
    validate(effects[n].effects, update_rate);
  }
  return effects;
}

/// Opens the columns, and checks that they are what this format says.
void open_columns(OpenRecording& s) {
  if (!hdf5::exists(s.file.get(), kStepsGroup)) throw Error("it lacks the group 'steps'");
  const hdf5::Group group = hdf5::open_group(s.file.get(), kStepsGroup);
  s.size = std::numeric_limits<std::uint64_t>::max();
  const FieldList listed(group.get(), kStepsGroup);
  std::size_t known = 0;
  for (const Column& column : recording_columns()) {
    if (column.side == Column::Side::device && s.info.device.empty()) continue;
    const std::string name = std::string(kStepsGroup) + "/" + column.name;
    if (!listed.contains(column.name)) continue;  // it came later: the steps have its default
    ++known;
    if (!hdf5::exists(group.get(), column.name)) throw Error("it lacks the column '" + name + "'");
    hdf5::DataSet set = hdf5::open_data_set(group.get(), column.name);
    const std::vector<hsize_t> shape = hdf5::shape_of(set.get());
    if (shape.size() != column.shape.size() + 1 ||
        !std::equal(column.shape.begin(), column.shape.end(), shape.begin() + 1) ||
        hdf5::number_class(set, name) != (column.kind == ColumnKind::real ? H5T_FLOAT : H5T_INTEGER))
      throw Error("its column '" + name + "' has another shape or type than a recording's");
    // A writer that was killed may have left some columns longer than others.
    s.size = std::min<std::uint64_t>(s.size, shape[0]);
    s.columns.push_back({&column, std::move(set)});
  }
  if (listed.complete && known != listed.names.size())
    throw Error("it has a column that this version of hapticut does not know; use a newer version");
  if (s.columns.empty() || s.columns.front().column->name != "number")
    throw Error("it lacks the column 'steps/number'");
}

/// Finds the first gap in the numbers of the steps.
void find_gaps(OpenRecording& s) {
  constexpr std::uint64_t kStatusesAtOnce = 1 << 16;
  const OpenColumn& numbers = s.columns.front();
  std::uint64_t expected = 0;
  std::vector<std::byte> rows;
  s.before_first_gap = s.size;
  for (std::uint64_t first = 0; first < s.size; first += kStatusesAtOnce) {
    const std::uint64_t count = std::min(kStatusesAtOnce, s.size - first);
    read_rows(numbers, first, count, rows);
    for (std::uint64_t n = 0; n < count; ++n) {
      std::uint64_t number = 0;
      std::memcpy(&number, rows.data() + n * sizeof number, sizeof number);
      if (number < expected || number == std::numeric_limits<std::uint64_t>::max())
        throw Error("the numbers of its steps do not increase");
      if (number > expected && s.before_first_gap == s.size) s.before_first_gap = first + n;
      s.info.lost += number - expected;
      expected = number + 1;
    }
  }
  if (s.info.closed) s.info.lost = std::max(s.info.lost, hdf5::read_number_attribute(s.file.get(), "lost"));
}

void remark(RecordingInfo& info, std::uint64_t size) {
  if (!info.closed)
    info.remarks.push_back("The recording has no end: it is still being written, or its program was killed after " +
                           std::to_string(size) + " steps.");
  if (info.lost > 0)
    info.remarks.push_back(std::to_string(info.lost) +
                           " steps are missing, because the disk did not keep up or the workpiece was exchanged; a "
                           "replay ends before the first of them.");
}

}  // namespace

void read_rows(const OpenColumn& open, std::uint64_t first, std::uint64_t count, std::vector<std::byte>& rows) {
  const Column& column = *open.column;
  rows.resize(count * column.bytes);
  if (count == 0) return;
  std::vector<hsize_t> from(column.shape.size() + 1, 0), length = {count};
  from[0] = first;
  length.insert(length.end(), column.shape.begin(), column.shape.end());
  const std::string what = "reading " + column.name;
  const hdf5::DataSpace source(H5Dget_space(open.set.get()), what);
  hdf5::checked(H5Sselect_hyperslab(source.get(), H5S_SELECT_SET, from.data(), nullptr, length.data(), nullptr), what);
  const hdf5::DataSpace target(H5Screate_simple(int(length.size()), length.data(), nullptr), what);
  hdf5::checked(
      H5Dread(open.set.get(), type_of(column.kind).memory, target.get(), source.get(), H5P_DEFAULT, rows.data()), what);
}

void read_rows(const Recording& recording, const OpenColumn& column, std::uint64_t first, std::uint64_t count,
               std::vector<std::byte>& rows) {
  reading(recording.path(), [&] { read_rows(column, first, count, rows); });
}

Recording::Recording(std::unique_ptr<OpenRecording> state) : state_(std::move(state)) {}
Recording::Recording(Recording&&) noexcept = default;
Recording& Recording::operator=(Recording&&) noexcept = default;
Recording::~Recording() = default;

const std::filesystem::path& Recording::path() const { return state_->path; }
const RecordingInfo& Recording::info() const { return state_->info; }
bool Recording::has_device() const { return !state_->info.device.empty(); }
const DeviceCapabilities& Recording::capabilities() const { return state_->capabilities; }
std::uint64_t Recording::size() const { return state_->size; }
bool Recording::default_law() const { return state_->default_law; }
const Tool& Recording::tool() const { return *state_->tool; }
const SimulationConfig& Recording::config() const { return state_->config; }
const std::vector<RecordedEffects>& Recording::effects() const { return state_->effects; }

std::vector<RecordedStep> Recording::read(std::uint64_t first, std::uint64_t count) const {
  const std::uint64_t begin = std::min(first, state_->size);
  std::vector<RecordedStep> steps(std::min(count, state_->size - begin));
  reading(state_->path, [&] {
    std::vector<std::byte> rows;
    for (const OpenColumn& open : state_->columns) {
      read_rows(open, begin, steps.size(), rows);
      for (std::size_t n = 0; n < steps.size(); ++n)
        open.column->unpack(steps[n], rows.data() + n * open.column->bytes);
    }
  });
  return steps;
}

Workpiece Recording::workpiece() const {
  return reading(state_->path, [&] {
    const hdf5::Group group = hdf5::open_group(state_->file.get(), kWorkpieceGroup);
    const std::uint64_t expected = hdf5::read_number_attribute(group.get(), "full_hash");
    const bool elsewhere = hdf5::has_attribute(group.get(), "file");
    std::filesystem::path source;
    Workpiece workpiece = [&] {
      if (elsewhere) {
        source = hdf5::read_text_attribute(group.get(), "file");
        // The file may have been moved together with the recording.
        if (!std::filesystem::exists(source)) source = state_->path.parent_path() / source.filename();
        return load_vdb(source);
      }
      const auto bytes = hdf5::read_array<std::uint8_t>(group.get(), kWorkpieceBytes);
      return workpiece_of_vdb(std::string(bytes.begin(), bytes.end()));
    }();
    workpiece.set_materials(state_->materials);
    if (full_hash(workpiece) != expected)
      throw Error(elsewhere ? "the workpiece file '" + source.string() + "' is not the one that was recorded"
                            : std::string("its workpiece is damaged"));
    return workpiece;
  });
}

namespace {

/// @param open  opens the file
template <class Open>
std::unique_ptr<OpenRecording> parse_recording(const std::filesystem::path& path, const Open& open) {
  auto state = std::make_unique<OpenRecording>();
  reading(path, [&] {
    OpenRecording& s = *state;
    s.path = path;
    s.file = open();
    s.info = read_info(s.file.get());
    settings_in_file([&] {
      s.config = read_config(s.file.get());
      s.default_law = read_default_law(s.file.get());
      s.tool.emplace(read_tool(s.file.get()));
      s.materials = read_materials(s.file.get());
      if (!s.info.device.empty()) s.capabilities = read_capabilities(s.file.get());
      s.effects = read_effects(s.file.get(), s.config.update_rate);
      s.config.effects = s.effects.front().effects;
      validate(s.config);
    });
    if (!hdf5::exists(s.file.get(), kWorkpieceGroup)) throw Error("it lacks the group 'workpiece'");
    open_columns(s);
    find_gaps(s);
    remark(s.info, s.size);
  });
  return state;
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
  (void)readable_size(path);
  return Recording(parse_recording(path, [&] { return open_file(path); }));
}

Recording recording_of_bytes(std::string bytes, const std::filesystem::path& name) {
  return RecordingAccess::make(parse_recording(name, [&] { return open_bytes(std::move(bytes)); }));
}

}  // namespace hapticut
