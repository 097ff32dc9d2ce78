// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/recording.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>

#include "core/lack_of_memory.hpp"
#include "hapticut/io/vdb/vdb.hpp"
#include "io/file_errors.hpp"
#include "io/recording/recording_access.hpp"
#include "io/recording/recording_file.hpp"
#include "io/recording/recording_process.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/recording/settings_archive.hpp"
#include "io/vdb/vdb_bytes.hpp"

namespace hapticut {
namespace {

/// Runs a part of the reading.
/// @throws Error with the name of the file before the message
template <class Function>
auto reading(const std::filesystem::path& path, const Function& function) {
  try {
    return function();
  } catch (const hdf5::Failure& failure) {
    if (failure.fault() == Fault::not_hdf5) cannot_read(path, failure.sentence() + ".");
    cannot_read(path, (failure.fault() == Fault::damaged ? "" : "it is damaged, or another program changed it: ") +
                          failure.sentence() + ". Get a complete copy, or record it again.");
  } catch (const Error& error) {
    cannot_read(path, error.sentence());
  } catch (const std::exception& error) {
    if (is_lack_of_memory(error)) cannot_read(path, "there is not enough memory for it; it is too large or damaged.");
    cannot_read(path, std::string(error.what()) + ".");
  }
}

/// Runs a part of the reading that builds objects from the settings in the file.
/// @throws Error whose message says that the settings are inside the file
template <class Function>
auto settings_in_file(const Function& function) {
  try {
    return function();
  } catch (const hdf5::Failure&) {
    throw;
  } catch (const Error& error) {
    throw Error("in the settings inside it: " + error.sentence());
  }
}

RecordingInfo read_info(RecordingSource& source) {
  if (!source.has_attribute("", "content") || source.text_attribute("", "content") != kMagic)
    throw Error("it is an HDF5 file, but not a recording of hapticut.");
  RecordingInfo info;
  info.format = source.number_attribute("", "format");
  if (info.format != kRecordingFormat)
    throw Error("it has format " + std::to_string(info.format) + "; this version of hapticut reads format " +
                std::to_string(kRecordingFormat) + "; use " +
                (info.format < kRecordingFormat ? "the version that wrote it" : "a newer version") + ".");
  for (const auto& [name, text] : kInfoTexts) info.*text = source.text_attribute("", name);
  info.closed = source.has_attribute("", "closed");
  if (info.closed && source.has_attribute("", "workpiece_hash_at_end"))
    info.workpiece_hash_at_end = source.number_attribute("", "workpiece_hash_at_end");
  return info;
}

std::vector<RecordedEffects> read_effects(RecordingSource& source, double update_rate) {
  if (!source.exists(kEffectsGroup)) throw Error("it lacks the group 'effects'.");
  const std::string group = std::string(kEffectsGroup) + "/", places = group + kEffectValues;
  const auto first = source.whole_numbers(group + kFirstSteps);
  const auto values = source.reals(places);
  const std::string names = source.text_attribute(places, "columns");
  const std::size_t width = std::size_t(std::count(names.begin(), names.end(), ',')) + 1;
  const std::vector<std::uint64_t> shape = source.layout(places).shape;
  if (shape.size() != 2 || shape[1] != width)
    throw Error("the number of columns of its 'effects/values' differs from the number of names.");
  // The writer may have been killed between writing the two.
  const std::size_t count = std::min(first.size(), values.size() / width);
  if (count == 0 || first[0] != 0) throw Error("its group 'effects' lacks the effects of the first step.");
  std::vector<RecordedEffects> effects(count);
  for (std::size_t n = 0; n < count; ++n) {
    effects[n] = {first[n], unpack(names, std::span(values).subspan(n * width, width))};
    validate(effects[n].effects, update_rate);
  }
  return effects;
}

std::string place_of(const Column& column) { return std::string(kStepsGroup) + "/" + column.name; }

void read_rows(const OpenRecording& s, const Column& column, std::uint64_t first, std::uint64_t count,
               std::vector<std::byte>& rows) {
  s.source->rows(place_of(column), column.kind, column.numbers, first, count, rows);
}

/// Finds the columns and checks them against the format.
void open_columns(OpenRecording& s) {
  RecordingSource& source = *s.source;
  if (!source.exists(kStepsGroup)) throw Error("it lacks the group 'steps'.");
  s.size = std::numeric_limits<std::uint64_t>::max();
  const std::vector<std::string> listed = fields_listed(source, kStepsGroup);
  std::size_t known = 0;
  for (const Column& column : recording_columns()) {
    if (column.side == Column::Side::device && s.info.device.empty()) continue;
    const std::string place = place_of(column);
    if (!contains(listed, column.name)) continue;  // a newer column: the steps have its default
    ++known;
    if (!source.exists(place)) throw Error("it lacks the column '" + place + "'.");
    const DataSetLayout layout = source.layout(place);
    const std::vector<std::uint64_t>& shape = layout.shape;
    if (shape.size() != column.shape.size() + 1 ||
        !std::equal(column.shape.begin(), column.shape.end(), shape.begin() + 1) ||
        layout.is_real != (column.kind == ValueType::float64))
      throw Error("its column '" + place + "' has a wrong shape or type.");
    // A killed writer may have left columns of different length.
    s.size = std::min(s.size, shape[0]);
    s.columns.push_back(&column);
  }
  if (known != listed.size())
    throw Error("it has a column that this version of hapticut does not know; use a newer version.");
  if (s.columns.empty() || s.columns.front()->name != "number") throw Error("it lacks the column 'steps/number'.");
}

/// Finds the first gap in the step numbers.
void find_gaps(OpenRecording& s) {
  constexpr std::uint64_t kStatusesAtOnce = 1 << 16;
  const Column& numbers = *s.columns.front();
  std::uint64_t expected = 0;
  std::vector<std::byte> rows;
  s.before_first_gap = s.size;
  for (std::uint64_t first = 0; first < s.size; first += kStatusesAtOnce) {
    const std::uint64_t count = std::min(kStatusesAtOnce, s.size - first);
    read_rows(s, numbers, first, count, rows);
    for (std::uint64_t n = 0; n < count; ++n) {
      std::uint64_t number = 0;
      std::memcpy(&number, rows.data() + n * sizeof number, sizeof number);
      if (number < expected || number == std::numeric_limits<std::uint64_t>::max())
        throw Error("the numbers of its steps do not increase.");
      if (number > expected && s.before_first_gap == s.size) s.before_first_gap = first + n;
      s.info.lost += number - expected;
      expected = number + 1;
    }
  }
  if (s.info.closed) s.info.lost = std::max(s.info.lost, s.source->number_attribute("", "lost"));
}

void remark(RecordingInfo& info, std::uint64_t size) {
  if (!info.closed)
    info.remarks.push_back("The recording has no end: it is still being written, or its program was killed after " +
                           std::to_string(size) + " steps.");
  if (info.lost > 0)
    info.remarks.push_back(
        std::to_string(info.lost) +
        " steps are missing: the disk was too slow or full, or workpiece, tool, materials, friction or "
        "removal changed between steps. A replay ends before the first of them.");
}

}  // namespace

void read_rows(const Recording& recording, const Column& column, std::uint64_t first, std::uint64_t count,
               std::vector<std::byte>& rows) {
  reading(recording.path(), [&] { read_rows(RecordingAccess::state(recording), column, first, count, rows); });
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
    for (const Column* column : state_->columns) {
      read_rows(*state_, *column, begin, steps.size(), rows);
      for (std::size_t n = 0; n < steps.size(); ++n) column->unpack(steps[n], rows.data() + n * column->bytes);
    }
  });
  return steps;
}

Workpiece Recording::workpiece() const {
  return reading(state_->path, [&] {
    RecordingSource& from = *state_->source;
    const std::uint64_t expected = from.number_attribute(kWorkpieceGroup, "full_hash");
    const bool elsewhere = from.has_attribute(kWorkpieceGroup, "file");
    std::filesystem::path source;
    Workpiece workpiece = [&] {
      if (elsewhere) {
        source = from.text_attribute(kWorkpieceGroup, "file");
        // The file may have moved together with the recording.
        if (!std::filesystem::exists(source)) source = state_->path.parent_path() / source.filename();
        return load_vdb(source);
      }
      const std::vector<std::byte> bytes = from.bytes(std::string(kWorkpieceGroup) + "/" + kWorkpieceBytes);
      return workpiece_of_vdb(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    }();
    workpiece.set_materials(state_->materials);
    if (full_hash(workpiece) != expected)
      throw Error(elsewhere ? "the workpiece file '" + source.string() + "' differs from the recorded one."
                            : std::string("its workpiece is damaged."));
    return workpiece;
  });
}

Recording read_recording(const std::filesystem::path& path) {
  const std::uint64_t size = readable_size(path);
  auto state = std::make_unique<OpenRecording>();
  reading(path, [&] {
    OpenRecording& s = *state;
    s.path = path;
    s.source = std::make_unique<RecordingProcess>(path, size);
    RecordingSource& source = *s.source;
    s.info = read_info(source);
    settings_in_file([&] {
      s.config = read_config(source);
      s.default_law = read_default_law(source);
      s.tool.emplace(read_tool(source));
      s.materials = read_materials(source);
      if (!s.info.device.empty()) s.capabilities = read_capabilities(source);
      s.effects = read_effects(source, s.config.update_rate);
      s.config.effects = s.effects.front().effects;
      validate(s.config);
    });
    if (!source.exists(kWorkpieceGroup)) throw Error("it lacks the group 'workpiece'.");
    open_columns(s);
    find_gaps(s);
    remark(s.info, s.size);
  });
  return Recording(std::move(state));
}

}  // namespace hapticut
