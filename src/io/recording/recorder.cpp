// SPDX-License-Identifier: Apache-2.0
#include "hapticut/io/recording/recorder.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <ctime>
#include <thread>

#include "hapticut/core/build_info.hpp"
#include "io/atomic_file.hpp"
#include "io/recording/disk_space.hpp"
#include "io/recording/recording_columns.hpp"
#include "io/recording/recording_file.hpp"
#include "io/recording/recording_settings.hpp"
#include "io/writer_lock.hpp"
#include "realtime/background_writer.hpp"

namespace hapticut {
namespace {

constexpr char kWhat[] = "the recording ";    // before the file name, in messages
constexpr std::uint64_t kHeadroom = 4 << 20;  // [bytes] reserve for a batch and the end of the recording

/// A step for the writer, with its effects; the writer records their changes.
struct Message {
  RecordedStep step;
  EffectNumbers effects;
};

std::string now_as_text() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// Whether numbers have equal bits: -0 is not 0 here, because the sign reaches the force.
bool same_bits(const EffectNumbers& a, const EffectNumbers& b) {
  using Bits = std::array<std::uint64_t, kEffectNumbers>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// The `.new` file next to an older recording.
std::filesystem::path path_beside(const std::filesystem::path& at) {
  constexpr std::size_t kMaxName = 251;  // [bytes] with the suffix
  return at.parent_path() / (at.filename().string().substr(0, kMaxName) + ".new");
}

/// The path of the growing recording: its final path, so others can read it meanwhile. If an older recording exists
/// there, the file beside it, and the older one stays until the new one is complete.
std::filesystem::path growing_path(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::path at = place_behind_links(path);
  return std::filesystem::exists(at, code) ? path_beside(at) : at;
}

/// Whether a recorder is at work on a recording.
bool has_recorder(const std::filesystem::path& path) {
  const std::filesystem::path at = place_behind_links(path);
  return has_writer_lock(at) || has_writer_lock(path_beside(at));
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason, bool lacked_memory = false) {
  if (lacked_memory)  // the disk is not to blame
    throw Error(std::string("cannot write ") + kWhat + "'" + path.string() + "': " + reason +
                ". Use larger voxels, a smaller piece or a shorter run.");
  cannot_write(path, reason, kWhat);
}

/// Removes a recording that did not come to its first step.
class Remains {
 public:
  Remains() = default;
  ~Remains() {
    if (!path.empty()) ::unlink(path.c_str());
  }
  Remains(const Remains&) = delete;
  Remains& operator=(const Remains&) = delete;
  std::filesystem::path path;  // empty: nothing to remove
};

}  // namespace

struct Recorder::State {
  State(std::filesystem::path a_path, Simulation& a_simulation, const RecorderOptions& some_options)
      : path(std::move(a_path)), growing(growing_path(path)), simulation(a_simulation), options(some_options) {}

  void note(const ObservedStep& step) noexcept;
  void write_batch(const std::vector<Message>& batch);
  void flush();
  std::string end_writing();

  std::filesystem::path path;     // final path of the recording
  std::filesystem::path growing;  // path until it is complete
  Simulation& simulation;
  RecorderOptions options;

  // Used by the loop's thread.
  Message message;               // the step being filled
  bool has_device_tick = false;  // the message has device data
  bool over = false;             // the recording has ended
  bool exchanged = false;        // by a change that a replay cannot repeat
  double time = 0;
  std::atomic<std::uint64_t> recorded{0}, lost{0};
  std::atomic<bool> ending_failed{false};

  // Used by the writer's thread.
  WriterLock lock;  // lock of the growing file
  std::unique_ptr<DiskSpace> disk_space;
  hdf5::File file;
  std::vector<const Column*> columns;
  std::vector<hdf5::Appender> appenders;
  std::vector<hdf5::Appender> effects_appenders;  // columns of first steps and effects
  EffectNumbers last_effects{};
  std::vector<std::byte> rows;
  std::uint64_t unflushed = 0;  // [bytes] that HDF5 may still buffer
  std::uint64_t written = 0;    // steps

  std::unique_ptr<BackgroundWriter<Message>> writer;  // connects the two threads; created last, destroyed first
};

Recorder::Recorder(const std::filesystem::path& path, Simulation& simulation, const RecorderOptions& options) {
  require_between(double(options.buffered_steps), 16, 1e7, "RecorderOptions::buffered_steps");
  require_between(options.flush_period, 0.01, 0.5, "RecorderOptions::flush_period [s]");
  if (!simulation.is_fresh())
    throw Error((simulation.steps() > 0
                     ? "the simulation has already made " + std::to_string(simulation.steps()) + " steps"
                     : std::string("the workpiece of the simulation was exchanged or changed")) +
                ", so a replay would lack its initial state; record from the first step, or reset the simulation to a "
                "clone of its workpiece first.");
  const hdf5::Quiet quiet;
  state_ = std::make_unique<State>(path, simulation, options);
  State& s = *state_;
  if (const Device* device = options.driven_by) {
    s.options.device = device->name();
    s.options.capabilities = device->capabilities();
  }
  s.last_effects = pack(simulation.config().effects);
  Remains remains;
  try {
    if (has_recorder(path)) refuse_second_writer(path, kWhat);
    { const AtomicFile may_be_written(path); }
    AtomicFile target(s.growing);
    s.lock = WriterLock(target.temporary_path());
    RecordingInfo info;
    const BuildInfo build = build_info();
    info.version = build.version;
    info.commit = build.commit;
    info.compiler = build.compiler;
    info.cpu = build.cpu;
    info.begun = now_as_text();
    info.device = s.options.device;
    info.note = options.note;
    write_recording_header(target.temporary_path(), info, simulation, s.options);
    // Another recorder may have begun meanwhile.
    const bool is_beside = s.growing != place_behind_links(path);
    if (is_beside && !remove_left_file(s.growing)) refuse_second_writer(path, kWhat);
    target.commit_new();
    remains.path = s.growing;
    s.disk_space = std::make_unique<DiskSpace>(s.growing);
    s.disk_space->require(std::filesystem::file_size(s.growing) + kHeadroom);

    // From here on the file is readable at any moment: single writer, multiple readers.
    s.file =
        hdf5::File(H5Fopen(s.growing.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, newest_format().get()), "opening it");
    const hdf5::Group steps = hdf5::open_group(s.file.get(), kStepsGroup);
    for (const Column& column : recording_columns()) {
      if (column.side == Column::Side::device && s.options.device.empty()) continue;
      s.columns.push_back(&column);
      s.appenders.emplace_back(steps.get(), column.name, column.kind);
    }
    const hdf5::Group effects = hdf5::open_group(s.file.get(), kEffectsGroup);
    s.effects_appenders.emplace_back(effects.get(), kFirstSteps, ValueType::uint64);
    s.effects_appenders.emplace_back(effects.get(), kEffectValues, ValueType::float64);
  } catch (const hdf5::Failure& failure) {
    fail(path, failure.what());
  } catch (const DiskSpace::Shortage& lacking) {
    fail(path, lacking.what());
  }
  s.writer = std::make_unique<BackgroundWriter<Message>>(
      options.buffered_steps, s.message, options.flush_period,
      BackgroundWriter<Message>::Sink{[&s](const std::vector<Message>& batch) { s.write_batch(batch); },
                                      [&s] { s.flush(); }});
  simulation.observers().add(*this);
  remains.path.clear();
}

Recorder::~Recorder() {
  State& s = *state_;
  s.simulation.observers().remove(*this);
  if (!s.writer->running()) return;
  (void)s.end_writing();
  if (s.written == 0) ::unlink(s.growing.c_str());
}

// --- loop thread -----------------------------------------------------------------------------------------------------

const StepResult& Recorder::step(const StepInput& input, const DeviceTick* device) noexcept {
  state_->message.step.device = device != nullptr ? *device : DeviceTick{};
  state_->has_device_tick = device != nullptr;
  return state_->simulation.step(input.X_WH, input.V_WH, input.dt);
}

void Recorder::set_device_tick(const DeviceTick& tick) noexcept {
  state_->message.step.device = tick;
  state_->has_device_tick = true;
}

void Recorder::on_exchange() noexcept { state_->over = state_->exchanged = true; }
void Recorder::on_removal(const BlockVoxels& /*removed*/) noexcept { on_exchange(); }

void Recorder::on_step(const ObservedStep& step) noexcept {
  State& s = *state_;
  if (s.over) {
    s.lost.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  s.note(step);
  while (!s.writer->push(s.message)) {
    if (!s.options.wait_when_full || s.writer->failed()) {
      s.lost.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    std::this_thread::yield();
  }
  s.recorded.fetch_add(1, std::memory_order_relaxed);
}

// All that a step depends on, and how a replay gets it. "Ends": a change ends the recording, by `on_exchange` or
// `on_removal`. "Begins": `Simulation::is_fresh` is demanded, and from then on the replayed steps make it.
//
// | Simulation::State                                    | in a replay                                               |
// |------------------------------------------------------|-----------------------------------------------------------|
// | input, also of rejected steps                        | pose, velocity, dt                                        |
// | coupling given to the step                           | hand.path, hand.coupled: coupling, coupling_dt            |
// | workpiece: material                                  | initial; ends                                             |
// | workpiece: pool                                      | reserved_blocks, free_blocks; `clone` makes leaves as a   |
// |                                                      | file does                                                 |
// | workpiece: undo marks                                | a step does not depend on them                            |
// | tool, other_cutter                                   | initial; ends                                             |
// | config: effects                                      | effects, from a step on                                   |
// | config: law                                          | ReplayOptions::law, or the default                        |
// | config: friction, removal; the rest                  | initial; ends; constant                                   |
// | contact_stages (also the subset of a voxel_budget),  | from workpiece, tool and config; then by the steps        |
// | X_VW, head_stiffness                                 |                                                           |
// | motion, spindle: load, springs, crushing_depth,      | begins                                                    |
// | removal list, result.energy                          |                                                           |
// | motion: separated; totals.altered                    | begins with false; ends                                   |
// | spindle: motor                                       | halted, spindle_set, spindle_setting; then by the steps   |
// | spindle: held                                        | spindle_held                                              |
// | spindle: held_setting                                | acts when the hold ends, which is a spindle_set           |
// | hand.output                                          | hand_released; then by the steps                          |
// | totals.steps                                         | number                                                    |
// | chooses_stiffness, observers, times, other totals    | a step does not depend on them                            |
//
// A VirtualCoupling moves the tool and answers to the step, and both are recorded; a reading that it rejects makes no
// step, but a hand_released.
void Recorder::State::note(const ObservedStep& step) noexcept {
  RecordedStep& row = message.step;
  row.number = step.number;
  row.input = step.input;
  if (const Device* device = options.driven_by) {
    row.device = {device->last_state(), device->last_output(), device->last_arming()};
    has_device_tick = true;
  }
  time += row.input.dt;
  row.time = has_device_tick ? row.device.state.time : time;
  if (!has_device_tick) row.device = {reading_of_handle(row), {}, ArmingState::off};
  row.spindle_setting = step.spindle_setting;
  row.reserved_blocks = simulation.config().reserved_blocks;
  row.free_blocks = step.free_blocks;
  row.hand_released = step.hand_released;
  row.halted = step.halted;
  row.spindle_set = step.spindle_set;
  row.spindle_held = step.spindle_held;
  row.path = step.path;
  row.hand = step.path == OutputPath::coupled ? step.hand : HandOutput{};
  note_result(step.result, row);
  message.effects = pack(simulation.config().effects);
}

std::uint64_t Recorder::recorded() const noexcept { return state_->recorded.load(std::memory_order_relaxed); }
std::uint64_t Recorder::lost() const noexcept { return state_->lost.load(std::memory_order_relaxed); }
bool Recorder::failed() const noexcept {
  return state_->writer->failed() || state_->ending_failed.load(std::memory_order_acquire);
}

// --- writer thread ---------------------------------------------------------------------------------------------------

void Recorder::State::flush() {
  const hdf5::Quiet quiet;
  hdf5::checked(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "flushing");
  unflushed = 0;
}

/// Ends the writer thread and closes the file.
/// @return the reason of a failure, or an empty text
std::string Recorder::State::end_writing() {
  std::string failure = writer->stop();
  const hdf5::Quiet quiet;
  appenders.clear();
  effects_appenders.clear();
  if (file.reset() < 0 && failure.empty()) failure = "closing failed";
  if (!failure.empty()) ending_failed.store(true, std::memory_order_release);
  return failure;
}

void Recorder::State::write_batch(const std::vector<Message>& batch) {
  const hdf5::Quiet quiet;
  hsize_t length = 0;
  hdf5::checked(H5Fget_filesize(file.get(), &length), "getting its size");
  unflushed += batch.size() * sizeof(RecordedStep);  // upper bound of their size in the file
  disk_space->require(length + unflushed + kHeadroom);
  // Effects first: a reader of a step then finds its effects.
  for (const Message& one : batch) {
    if (same_bits(one.effects, last_effects)) continue;
    last_effects = one.effects;
    effects_appenders[1].append(last_effects.data(), 1);
    effects_appenders[0].append(&one.step.number, 1);
  }
  for (std::size_t n = 0; n < columns.size(); ++n) {
    const Column& column = *columns[n];
    rows.resize(batch.size() * column.bytes);
    for (std::size_t row = 0; row < batch.size(); ++row) column.pack(batch[row].step, rows.data() + row * column.bytes);
    appenders[n].append(rows.data(), batch.size());
  }
  written += batch.size();
}

void Recorder::close() {
  State& s = *state_;
  if (!s.writer->running()) throw Error("the recorder of '" + s.path.string() + "' is closed already.");
  s.over = true;  // later steps are dropped without waiting
  const std::string failure = s.end_writing();
  // A failed writer leaves steps in the buffer.
  if (!failure.empty()) s.lost.fetch_add(s.recorded.exchange(s.written) - s.written);
  const hdf5::Quiet quiet;
  if (!failure.empty() && s.written == 0) {
    ::unlink(s.growing.c_str());
    fail(s.path, failure, s.writer->lacked_memory());
  }
  try {
    hdf5::File file(H5Fopen(s.growing.c_str(), H5F_ACC_RDWR, newest_format().get()), "opening it");
    std::optional<std::uint64_t> hash;
    if (!s.exchanged) hash = s.simulation.workpiece().hash();
    write_recording_end(file.get(), s.lost.load(), hash);
    if (file.reset() < 0) hdf5::fail("closing it");
  } catch (const hdf5::Failure& error) {
    s.ending_failed.store(true, std::memory_order_release);
    fail(s.path, failure.empty() ? error.what() : failure, s.writer->lacked_memory());
  }
  s.disk_space.reset();
  if (!failure.empty())
    fail(s.path, failure + "; its first " + std::to_string(s.written) + " steps are in '" + s.growing.string() + "'",
         s.writer->lacked_memory());
  std::error_code code;
  if (const auto last = place_behind_links(s.path); s.growing != last) std::filesystem::rename(s.growing, last, code);
  if (code) {
    s.ending_failed.store(true, std::memory_order_release);
    fail(s.path, code.message() + "; it is complete in '" + s.growing.string() + "'");
  }
  s.lock.release();
}

}  // namespace hapticut
