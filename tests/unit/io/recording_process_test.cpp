// SPDX-License-Identifier: Apache-2.0
// A separate program reads recordings, because a file may crash it.
#include <gtest/gtest.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have kill
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "hapticut/io/recording/recording.hpp"
#include "io/recording/hdf5_source.hpp"
#include "io/recording/recording_access.hpp"
#include "io/recording/recording_process.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

/// HDF5's own checksum of metadata (Bob Jenkins' lookup3), which its library exports.
extern "C" std::uint32_t H5_checksum_lookup3(const void* bytes, std::size_t count, std::uint32_t begin);

namespace hapticut::recording_process_test {
namespace {

using test::complaint_about;
using test::TemporaryFolder;

constexpr int kSteps = 5;
constexpr const char* kVariable = "HAPTICUT_RECORDING_READER";

/// During the lifetime of this object, another program reads recordings.
struct OtherReader {
  explicit OtherReader(const std::string& program) { ::setenv(kVariable, program.c_str(), 1); }
  ~OtherReader() { ::unsetenv(kVariable); }
  OtherReader(const OtherReader&) = delete;
  OtherReader& operator=(const OtherReader&) = delete;
};

std::filesystem::path recorded(const TemporaryFolder& folder) {
  return test::record_scene(folder / "a.h5", "axial_flat", kSteps);
}

/// A shell script that replaces the reader.
std::string script(const TemporaryFolder& folder, const std::string& text) {
  test::write_bytes(folder / "reader", "#!/bin/sh\n" + text);
  std::filesystem::permissions(folder / "reader", std::filesystem::perms::owner_all);
  return (folder / "reader").string();
}

/// A reply of the reader, in the notation of printf(1).
std::string octal(const Reply& reply) {
  std::string text;
  const auto* bytes = reinterpret_cast<const unsigned char*>(&reply);
  for (std::size_t n = 0; n < sizeof reply; ++n) {
    text += "\\";
    for (const int shift : {6, 3, 0}) text += char('0' + ((bytes[n] >> shift) & 7));
  }
  return text;
}

TEST(RecordingProcess, ReadsTheSameDataAsHdf5InThisProcess) {
  const TemporaryFolder folder;
  const std::filesystem::path path = recorded(folder);
  RecordingProcess process(path, std::filesystem::file_size(path));
  const std::unique_ptr<Hdf5Source> here = open_hdf5_file(path);
  for (const Column& column : recording_columns()) {
    const std::string place = "steps/" + column.name;
    ASSERT_EQ(process.exists(place), here->exists(place)) << place;
    if (!here->exists(place)) continue;
    EXPECT_EQ(process.layout(place).shape, here->layout(place).shape) << place;
    EXPECT_EQ(process.layout(place).is_real, here->layout(place).is_real) << place;
    std::vector<std::byte> there_rows, here_rows;
    process.rows(place, column.kind, column.numbers, 1, kSteps - 1, there_rows);
    here->rows(place, column.kind, column.numbers, 1, kSteps - 1, here_rows);
    EXPECT_EQ(there_rows.size(), (kSteps - 1) * column.bytes);
    EXPECT_EQ(there_rows, here_rows) << place;
  }
  EXPECT_EQ(process.bytes("workpiece/vdb"), here->bytes("workpiece/vdb"));
  EXPECT_EQ(process.text("tool/head"), here->text("tool/head"));
  EXPECT_EQ(process.text_attribute("", "begun"), here->text_attribute("", "begun"));
  EXPECT_EQ(process.number_attribute("workpiece", "hash"), here->number_attribute("workpiece", "hash"));
  EXPECT_FALSE(process.has_attribute("steps", "taste"));
  EXPECT_THROW((void)process.text("tool/taste"), hdf5::Failure);
  EXPECT_EQ(process.text("tool/head"), here->text("tool/head"));  // a refusal does not end the reader
  std::vector<std::byte> rows;
  EXPECT_THROW(process.rows("steps/dt", ValueType::float64, 1, kSteps, 1, rows), hdf5::Failure);
  EXPECT_THROW(process.rows("steps/dt", ValueType::float64, 3, 0, kSteps, rows), hdf5::Failure);
}

TEST(RecordingProcess, MayBeAskedBySeveralThreads) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(recorded(folder));
  const Vec3 expected = recording.read(0, kSteps).back().force;
  std::vector<std::thread> threads;
  for (int n = 0; n < 4; ++n)
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) {
        EXPECT_EQ(recording.read(0, kSteps).back().force, expected);
      }
    });
  for (std::thread& thread : threads) thread.join();
}

// HDF5 1.10.8 trusts the number of entries in the root of a B-tree, and reads and writes beyond its buffers.
TEST(RecordingProcess, DiesOfAFileWhoseChecksumsFitAndIsOneSentence) {
  const TemporaryFolder folder;
  std::string bytes = test::read_bytes(recorded(folder));
  constexpr std::size_t kEntriesAt = 24, kEnd = 34;  // version 2 B-tree header, HDF5 File Format Specification III.A.2
  const std::uint16_t entries = 0xffff;
  int trees = 0;
  for (std::size_t at = bytes.find("BTHD"); at != std::string::npos; at = bytes.find("BTHD", at + 1), ++trees) {
    std::memcpy(&bytes[at + kEntriesAt], &entries, sizeof entries);
    const std::uint32_t sum = H5_checksum_lookup3(&bytes[at], kEnd, 0);
    std::memcpy(&bytes[at + kEnd], &sum, sizeof sum);
  }
  ASSERT_GT(trees, 0);
  test::write_bytes(folder / "hurts.h5", bytes);
  // In a child of this test, which crashes.
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      (void)open_hdf5_file(folder / "hurts.h5")->has_attribute("", "content");
    } catch (const Error&) {
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const std::string refusal = complaint_about(folder / "hurts.h5");
  test::expect_part(refusal, "damaged");
  if (WIFSIGNALED(status)) test::expect_part(refusal, "crashed or took too long");
  EXPECT_EQ(complaint_about(folder / "a.h5"), "");
}

TEST(RecordingProcess, ThatIsMissingOrEndsOrLiesIsOneSentence) {
  const TemporaryFolder folder;
  const std::filesystem::path path = recorded(folder);
  {
    const OtherReader missing("/no/such/program");
    test::expect_part(complaint_about(path), "'/no/such/program' cannot be started");
  }
  for (const std::string& program :
       {std::string("/bin/false"), script(folder, "kill -SEGV $$"),
        // More bytes than requested, and a message of any length.
        script(folder, "printf '" + octal({Reply::Result::done, 0, 1ULL << 40U}) + "' >&0; sleep 9"),
        script(folder, "printf '" + octal({Reply::Result::refused, 0, 1ULL << 40U}) + "' >&0; sleep 9"),
        script(folder, "printf '" + octal({Reply::Result(7), 0, 0}) + "' >&0; sleep 9")}) {
    SCOPED_TRACE(program);
    const OtherReader other(program);
    test::expect_part(complaint_about(path), "crashed or took too long");
  }
  const OtherReader tells(
      script(folder, "printf '" + octal({Reply::Result::refused, 0, 4}) + "a\\nb\\033' >&0; sleep 9"));
  test::expect_part(complaint_about(path), "a?b?");
}

TEST(RecordingProcess, ThatHangsIsNotWaitedForLonger) {
  const TemporaryFolder folder;
  const std::filesystem::path path = recorded(folder);
  const OtherReader hangs(script(folder, "exec sleep 60"));
  EXPECT_THROW(RecordingProcess(path, std::filesystem::file_size(path), std::chrono::milliseconds(50)), hdf5::Failure);
  EXPECT_LE(ChildProcess::kMaxReplyTime, std::chrono::seconds(20));
}

/// The only child of this process; 0: none.
pid_t child_of_this_process() {
  const std::string list = test::read_bytes("/proc/self/task/" + std::to_string(::getpid()) + "/children");
  return list.empty() ? 0 : pid_t(std::stol(list));
}

TEST(RecordingProcess, ThatIsKilledWhileARecordingIsOpenEndsTheReading) {
  const TemporaryFolder folder;
  const std::filesystem::path path = recorded(folder);
  {
    const Recording recording = read_recording(path);
    EXPECT_EQ(recording.read(0, kSteps).size(), std::size_t(kSteps));
    const pid_t child = child_of_this_process();
    if (child == 0) GTEST_SKIP() << "This system does not say which processes a process has started.";
    ::kill(child, SIGKILL);
    for (int n = 0; n < 2; ++n) EXPECT_THROW((void)recording.read(0, kSteps), Error);
    EXPECT_THROW(write_csv(recording, folder / "a.csv"), Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
  }
  EXPECT_EQ(child_of_this_process(), 0);
}

}  // namespace
}  // namespace hapticut::recording_process_test
