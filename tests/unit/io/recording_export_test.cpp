// SPDX-License-Identifier: Apache-2.0
// Export of recordings to CSV and NumPy: with all digits.
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <sstream>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/units.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::recording_export_test {
namespace {

using test::TemporaryFolder;

constexpr int kSteps = 400;

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

double number(const std::string& text) {
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(end.ptr, text.data() + text.size()) << text;
  return value;
}

TEST(RecordingExport, WritesEveryDigitAsText) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", kSteps));
  write_csv(recording, folder / "a.csv");
  std::istringstream lines(test::read_bytes(folder / "a.csv"));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const std::vector<std::string> names = cells_of(line);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    return std::size_t(found - names.begin());
  };
  const std::size_t z = column("pose_translation_2"), force = column("force_2"), hash = column("removed_voxels_hash"),
                    row21 = column("pose_rotation_21"), count = column("number");
  std::size_t rows = 0;
  bool cut = false;
  for (; std::getline(lines, line); ++rows) {
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), names.size());
    const RecordedStep step = recording.read(rows, 1).at(0);
    EXPECT_EQ(number(cells[z]), step.input.X_WH.translation.z());
    EXPECT_EQ(number(cells[row21]), step.input.X_WH.rotation(2, 1));
    EXPECT_EQ(number(cells[force]), step.force.z());
    EXPECT_EQ(cells[hash], std::to_string(step.removed_voxels_hash));
    EXPECT_EQ(cells[count], std::to_string(rows));
    cut = cut || step.removed_voxels_hash != 0;
  }
  EXPECT_EQ(rows, std::size_t(kSteps));
  EXPECT_TRUE(cut);
}

TEST(RecordingExport, WritesArraysThatNumPyReads) {
  if (std::system("/usr/bin/python3 -c 'import numpy' > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs the Python module numpy (Debian package python3-numpy)";
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", kSteps));
  write_npz(recording, folder / "a.npz");
  test::write_bytes(folder / "check.py", R"(
import sys, numpy
data = numpy.load(sys.argv[1])
n = int(sys.argv[2])
assert data["force"].shape == (n, 3) and data["force"].dtype == numpy.float64, data["force"].shape
assert data["pose_rotation"].shape == (n, 3, 3)
assert data["dt"].shape == (n,)
assert data["number"].dtype == numpy.uint64 and list(data["number"]) == list(range(n))
assert data["status"].dtype == numpy.uint32 and data["sub_steps"].dtype == numpy.int32
print(data["force"][-1, 2].hex(), data["energy_cutting"].sum().hex() != "0x0.0p+0")
)");
  const std::string command = "/usr/bin/python3 " + (folder / "check.py").string() + " " + (folder / "a.npz").string() +
                              " " + std::to_string(kSteps) + " > " + (folder / "out").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::istringstream out(test::read_bytes(folder / "out"));
  std::string force, cut;
  out >> force >> cut;
  EXPECT_EQ(std::strtod(force.c_str(), nullptr), recording.read(kSteps - 1, 1)[0].force.z());
  EXPECT_EQ(cut, "True");
}

TEST(RecordingExport, SaysWhatCannotBeWritten) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", 5));
  const auto write_sound = [](const Recording& r, const std::filesystem::path& path) { write_wav(r, path); };
  for (const std::function<void(const Recording&, const std::filesystem::path&)>& write :
       {std::function(write_csv), std::function(write_npz), std::function(write_sound)})
    test::expect_refused([&] { write(recording, folder / "no/such/a"); }, "no/such/a");
}

TEST(RecordingExport, KeepsTheRecordingThatItReads) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", 5));
  std::filesystem::create_symlink(folder / "a.h5", folder / "link.csv");
  const std::string before = test::read_bytes(folder / "a.h5");
  const auto write_sound = [](const Recording& r, const std::filesystem::path& path) { write_wav(r, path); };
  for (const std::function<void(const Recording&, const std::filesystem::path&)>& write :
       {std::function(write_csv), std::function(write_npz), std::function(write_sound)})
    for (const char* name : {"a.h5", "link.csv"})
      test::expect_refused([&] { write(recording, folder / name); }, "it is the recording itself");
  EXPECT_EQ(test::read_bytes(folder / "a.h5"), before);
}

// A tone of the recorded spindle is in the file, and it lasts as long as the steps.
TEST(RecordingExport, WritesTheSoundOfTheDrill) {
  const TemporaryFolder folder;
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", "axial_flat", kSteps));
  write_wav(recording, folder / "a.wav", 16'000);
  const std::string bytes = test::read_bytes(folder / "a.wav");
  const auto number_at = [&](std::size_t place, std::size_t length) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + place, length);
    return value;
  };
  ASSERT_GT(bytes.size(), 44U);
  EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 8), "RIFFWAVEfmt ");
  EXPECT_EQ(number_at(4, 4), bytes.size() - 8);
  EXPECT_EQ(number_at(20, 2), 1U) << "PCM";
  EXPECT_EQ(number_at(22, 2), 1U) << "one channel";
  EXPECT_EQ(number_at(24, 4), 16'000U);
  EXPECT_EQ(number_at(34, 2), 16U);
  EXPECT_EQ(number_at(40, 4), bytes.size() - 44);
  double seconds = 0, speed = 0;
  for (const RecordedStep& step : recording.read(0, kSteps)) seconds += step.input.dt, speed = step.spindle.speed;
  const std::size_t count = (bytes.size() - 44) / 2;
  EXPECT_NEAR(double(count), 16'000 * seconds, 1);
  // Its amplitude in the second half, after the spindle has accelerated, and the amplitude next to the tone.
  const auto strength = [&](double frequency) {
    double cosine = 0, sine = 0;
    for (std::size_t n = count / 2; n < count; ++n) {
      const double sample = std::int16_t(number_at(44 + 2 * n, 2)) / 32767.0,
                   angle = 2 * units::kPi * frequency * double(n) / 16'000;
      const double window = 1 - std::cos(4 * units::kPi * double(n) / double(count));
      cosine += window * sample * std::cos(angle), sine += window * sample * std::sin(angle);
    }
    return 4 * std::hypot(cosine, sine) / double(count);
  };
  const double turns = std::abs(speed) / (2 * units::kPi);
  ASSERT_GT(turns, 50);
  EXPECT_GT(strength(turns), 0.05);
  EXPECT_LT(strength(1.3 * turns), 0.5 * strength(turns));
  EXPECT_THROW(write_wav(recording, folder / "a.wav", 1000), Error);
}

}  // namespace
}  // namespace hapticut::recording_export_test
