// SPDX-License-Identifier: Apache-2.0
// The recorder in failures: killed process, full buffer, full disk; and with other observers.
#include "hapticut/io/recording/recorder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/replay.hpp"
#include "hapticut/realtime/realtime.hpp"
#include "hapticut/simulation/coupling.hpp"
#include "hapticut/workpiece/builders.hpp"
#include "support/no_disk_space.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

extern char** environ;

namespace hapticut::recorder_test {
namespace {

using test::patient;
using test::step_in_the_air;
using test::TemporaryFolder;

constexpr char kFolderVariable[] = "HAPTICUT_TEST_RECORDING_FOLDER";

/// A counter shared by two processes.
class SharedCounter {
 public:
  explicit SharedCounter(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_CREAT | O_RDWR, 0600);
    EXPECT_EQ(::ftruncate(file, sizeof(std::atomic<long>)), 0);
    void* memory = ::mmap(nullptr, sizeof(std::atomic<long>), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    count_ = static_cast<std::atomic<long>*>(memory);
  }
  ~SharedCounter() { ::munmap(count_, sizeof(std::atomic<long>)); }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;
  std::atomic<long>& operator*() { return *count_; }

 private:
  std::atomic<long>* count_;
};

// The process that the next test kills: an endless 1 kHz loop that records.
TEST(RecorderChild, DISABLED_RecordsUntilItIsKilled) {
  const std::filesystem::path folder = std::getenv(kFolderVariable);
  SharedCounter steps(folder / "counter");
  const test::Scene& scene = test::find_scene("axial_flat");
  Simulation simulation = scene.make();
  Recorder recorder(folder / "killed.h5", simulation);
  PeriodicClock clock(1e-3);
  for (int tick = 0;; ++tick) {
    clock.wait();
    recorder.step(scene.input(tick));
    (*steps).store(tick + 1);
  }
}

/// Starts that process, and waits until it has made some steps.
pid_t start_recorder(const TemporaryFolder& folder, SharedCounter& steps, long when) {
  ::setenv(kFolderVariable, folder.operator/("").c_str(), 1);
  std::string program = "/proc/self/exe", filter = "--gtest_filter=RecorderChild.*",
              disabled = "--gtest_also_run_disabled_tests";
  char* arguments[] = {program.data(), filter.data(), disabled.data(), nullptr};
  pid_t child = 0;
  posix_spawn_file_actions_t quietly;
  ::posix_spawn_file_actions_init(&quietly);
  ::posix_spawn_file_actions_addopen(&quietly, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  EXPECT_EQ(::posix_spawn(&child, program.c_str(), &quietly, nullptr, arguments, environ), 0);
  ::posix_spawn_file_actions_destroy(&quietly);
  while ((*steps).load() < when && ::waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return child;
}

void kill_recorder(pid_t child) {
  ASSERT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Recorder, LosesLessThanASecondWhenItsProcessIsKilled) {
  const long kAtOneKilohertz = 1000;  // steps per second
  for (const long when : {350, 1501}) {
    const TemporaryFolder folder;
    SharedCounter steps(folder / "counter");
    kill_recorder(start_recorder(folder, steps, when));
    const long made = (*steps).load();
    const Recording recording = read_recording(folder / "killed.h5");
    EXPECT_GE(long(recording.size()), made - kAtOneKilohertz);
    EXPECT_GT(recording.size(), 0U);
    EXPECT_LE(long(recording.size()), made + 1);
    EXPECT_EQ(recording.info().lost, 0U);
    EXPECT_FALSE(recording.info().closed);
    ASSERT_EQ(recording.info().remarks.size(), 1U);
    const ReplayReport report = replay(recording);
    EXPECT_TRUE(report.identical);
    EXPECT_EQ(report.steps, recording.size());
  }
}

TEST(Recorder, OfAnotherProcessKeepsItsFileUntilItIsKilled) {
  const TemporaryFolder folder;
  SharedCounter steps(folder / "counter");
  const pid_t child = start_recorder(folder, steps, 10);
  Simulation simulation = test::find_scene("axial_flat").make();
  test::expect_part(test::refusal([&] { Recorder(folder / "killed.h5", simulation); }), "another program");
  kill_recorder(child);
  EXPECT_TRUE(replay(read_recording(folder / "killed.h5")).identical);
  for (int times = 0; times < 2; ++times) {  // the second time over a complete recording
    Simulation fresh = test::find_scene("axial_flat").make();
    Recorder recorder(folder / "killed.h5", fresh, patient());
    step_in_the_air(recorder, 10);
    recorder.close();
    EXPECT_EQ(read_recording(folder / "killed.h5").size(), 10U);
  }
  EXPECT_EQ(folder.file_count(), 2U) << "the counter and the recording";
}

TEST(Recorder, CountsTheStepsThatFindItsMemoryFullAndTheRecordingSaysSo) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options;
  options.buffered_steps = 16;
  Recorder recorder(folder / "a.h5", simulation, options);
  step_in_the_air(recorder, 100000);  // faster than any disk
  const std::uint64_t lost = recorder.lost();
  ASSERT_GT(lost, 0U);
  EXPECT_EQ(recorder.recorded() + lost, 100000U);
  recorder.close();

  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_EQ(recording.info().lost, lost);
  EXPECT_EQ(recording.size(), 100000 - lost);
  ASSERT_EQ(recording.info().remarks.size(), 1U);
  EXPECT_NE(recording.info().remarks[0].find(std::to_string(lost)), std::string::npos);
  const ReplayReport report = replay(recording);
  EXPECT_TRUE(report.identical);  // up to the first gap
  EXPECT_GE(report.steps, 16U);
  EXPECT_EQ(report.steps + report.skipped, recording.size());
  EXPECT_GT(report.skipped, 0U);
}

TEST(Recorder, LosesNothingWhereItMayWait) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options = patient();
  options.buffered_steps = 16;
  Recorder recorder(folder / "a.h5", simulation, options);
  step_in_the_air(recorder, 5000);
  EXPECT_EQ(recorder.lost(), 0U);
  recorder.close();
  EXPECT_EQ(read_recording(folder / "a.h5").size(), 5000U);
}

TEST(Recorder, CountsTheStepsAfterItsEndAsLostAndDoesNotWaitForRoom) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  RecorderOptions options = patient();
  options.buffered_steps = 16;
  Recorder recorder(folder / "a.h5", simulation, options);
  step_in_the_air(recorder, 10);
  recorder.close();
  step_in_the_air(recorder, 100);
  EXPECT_EQ(recorder.recorded(), 10U);
  EXPECT_EQ(recorder.lost(), 100U);
  EXPECT_EQ(read_recording(folder / "a.h5").size(), 10U);
}

TEST(Recorder, EndsTheRecordingWhereTheWorkpieceIsExchanged) {
  const TemporaryFolder folder;
  const test::Scene& scene = test::find_scene("axial_flat");
  for (const bool reset : {false, true}) {
    Simulation simulation = scene.make();
    const WorkpieceSnapshot fresh = simulation.workpiece().snapshot();
    Recorder recorder(folder / "a.h5", simulation, patient());
    for (int tick = 0; tick < 100; ++tick) recorder.step(scene.input(tick));
    if (reset)
      simulation.reset(simulation.workpiece().clone());
    else
      simulation.history().restore(fresh);
    for (int tick = 0; tick < 200; ++tick) recorder.step(scene.input(tick));
    EXPECT_EQ(recorder.recorded(), 100U);
    EXPECT_EQ(recorder.lost(), 200U);
    EXPECT_GT(simulation.last_result().force.norm(), 0);
    recorder.close();
    const Recording recording = read_recording(folder / "a.h5");
    EXPECT_EQ(recording.info().lost, 200U);
    EXPECT_TRUE(replay(recording).identical);
  }
}

TEST(Recorder, RecordsEveryStepOfAFastToolBehindACoupling) {
  const TemporaryFolder folder;
  SimulationConfig config;
  config.reference_stiffness = 1e15;
  config.contact_time = ContactTime::end;
  Simulation simulation(build_block({Vec3(-3e-3, -3e-3, -3e-3), Vec3(3e-3, 3e-3, 0)}, 1e-4,
                                    test::find_scene("axial_flat").make().workpiece().materials()[1]),
                        Tool(SphereHead{1e-3}, RayHandle{0}, Spindle{2000 * units::rad_per_s}), config);
  VirtualCoupling coupling(simulation, {});
  Recorder recorder(folder / "a.h5", simulation, patient());
  std::uint64_t sub_ticks = 0;
  std::vector<std::pair<std::uint64_t, Vec3>> felt;  // step, and the force on the hand after it
  constexpr int kTicks = 300;
  for (int tick = 0; tick < kTicks; ++tick) {
    const double z = std::max(5e-3 - 2e-4 * tick, 0.0);  // 0.2 m/s: 4 voxels and more in a tick
    const Pose hand = Pose::from_translation(Vec3(tick == 200 ? std::nan("") : 1e-5, 0, z));
    const CoupledResult& result = coupling.step(hand, {Vec3(0, 0, -0.2), Vec3::Zero()}, 1e-3);
    sub_ticks += std::uint64_t(result.sub_ticks);
    if (result.sub_ticks > 0) felt.emplace_back(sub_ticks - 1, result.hand.force);
  }
  recorder.close();
  EXPECT_GT(sub_ticks, std::uint64_t(kTicks)) << "some ticks were divided into sub-ticks";
  EXPECT_EQ(recorder.recorded(), sub_ticks);
  EXPECT_EQ(recorder.lost(), 0U);
  EXPECT_GT(simulation.totals().removed_volume[1], 0);
  const Recording recording = read_recording(folder / "a.h5");
  const ReplayReport report = replay(recording);
  EXPECT_TRUE(report.identical) << report.first_difference->column << " in step " << report.first_difference->step;
  EXPECT_EQ(report.steps, sub_ticks);

  // The column `force` is the force on the hand, which differs from the contact force.
  const std::vector<RecordedStep> steps = recording.read(0, sub_ticks);
  double max_difference = 0;
  for (const auto& [step, force] : felt) {
    EXPECT_EQ(steps[step].force, force) << step;
    EXPECT_EQ(steps[step].path, OutputPath::coupled);
    max_difference = std::max(max_difference, (steps[step].model.force - force).norm());
  }
  EXPECT_GT(max_difference, 0.1);
}

TEST(Recorder, RecordsStepsThatOtherCodeMakes) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  Recorder recorder(folder / "a.h5", simulation, patient());
  step_in_the_air(recorder, 10);
  simulation.step({}, {}, 1e-3);
  step_in_the_air(recorder, 10);
  EXPECT_EQ(recorder.recorded(), 21U);
  EXPECT_EQ(recorder.lost(), 0U);
}

TEST(Recorder, ContinuesSteppingWhenTheDiskIsFullAndReportsThisAtTheEnd) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  {
    const test::NoDiskSpace full(16 << 20);
    Recorder recorder(folder / "a.h5", simulation, patient());
    step_in_the_air(recorder, 50000);
    EXPECT_TRUE(recorder.failed());
    EXPECT_GT(recorder.lost(), 0U);
    EXPECT_EQ(simulation.steps(), 50000U);
    const std::string refusal = test::refusal([&] { recorder.close(); });
    for (const char* part : {"a.h5", "free disk space"}) test::expect_part(refusal, part);
  }
  // The steps written before are readable.
  const Recording recording = read_recording(folder / "a.h5");
  EXPECT_GT(recording.size(), 1000U);
  EXPECT_TRUE(replay(recording).identical);
}

TEST(Recorder, HasFailedWhereItsEndCannotBeWritten) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  Recorder recorder(folder / "a.h5", simulation, patient());
  step_in_the_air(recorder, 10);
  EXPECT_FALSE(recorder.failed());
  std::filesystem::remove(folder / "a.h5");  // `close` reopens the file to write the hash of the workpiece
  EXPECT_THROW(recorder.close(), Error);
  EXPECT_TRUE(recorder.failed());
  EXPECT_EQ(recorder.lost(), 0U);
}

TEST(Recorder, RefusesPlacesAndOptionsThatCannotBe) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  EXPECT_THROW(Recorder(folder / "no/such/folder.h5", simulation), Error);
  EXPECT_THROW(Recorder(folder / "", simulation), Error);
  RecorderOptions options;
  options.buffered_steps = 1;
  EXPECT_THROW(Recorder(folder / "a.h5", simulation, options), Error);
  options = {};
  options.flush_period = 2;
  EXPECT_THROW(Recorder(folder / "a.h5", simulation, options), Error);
  const test::NoDiskSpace full;
  EXPECT_THROW(Recorder(folder / "a.h5", simulation), Error);
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(Recorder, EndsWhenALoosePieceIsRemovedAndTheRecordedStepsReplay) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  Recorder recorder(folder / "a.h5", simulation, patient());
  step_in_the_air(recorder, 10);
  BlockVoxels some;
  simulation.workpiece().for_each_block([&](const BlockView& block) { some.origin = block.origin; });
  some.voxels.words[0] = 0xff;
  ASSERT_TRUE(simulation.remove_voxels(some));
  step_in_the_air(recorder, 5);
  EXPECT_EQ(recorder.recorded(), 10U);
  EXPECT_EQ(recorder.lost(), 5U);
  recorder.close();
  const ReplayReport report = replay(read_recording(folder / "a.h5"));
  EXPECT_TRUE(report.identical);
  EXPECT_EQ(report.steps, 10U);
}

TEST(Recorder, IsOneOfTheObserversOfItsSimulation) {
  const TemporaryFolder folder;
  Simulation simulation = test::find_scene("axial_flat").make();
  {
    Recorder first(folder / "a.h5", simulation, patient()), second(folder / "b.h5", simulation, patient());
    step_in_the_air(first, 10);
    EXPECT_EQ(first.recorded(), 10U);
    EXPECT_EQ(second.recorded(), 10U);
  }
  EXPECT_TRUE(simulation.observers().all().empty());
}

}  // namespace
}  // namespace hapticut::recorder_test
