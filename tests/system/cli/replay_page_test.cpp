// SPDX-License-Identifier: Apache-2.0
// The page that replays a recording contains the recorded steps.
#include "page/session/replay_page.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <fstream>

#include "hapticut/core/errors.hpp"
#include "support/no_disk_space.hpp"
#include "support/recordings.hpp"
#include "support/temporary_folder.hpp"
#include "system/cli/view_desk.hpp"

namespace hapticut::replay_page_test {
namespace {

using view::MessageKind;

constexpr const char* kScene = "circular_groove";

struct SentMessage {
  double time;
  std::string bytes;
  [[nodiscard]] MessageKind kind() const { return MessageKind(bytes[0]); }
  template <class Value>
  [[nodiscard]] Value at(std::size_t offset) const {
    Value value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
  }
};

std::string unpacked(const std::vector<std::uint8_t>& gzip) {
  std::string bytes(100 << 20, '\0');
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  stream.next_in = const_cast<Bytef*>(gzip.data());
  stream.avail_in = uInt(gzip.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = uInt(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

std::vector<SentMessage> messages_in(const Recording& recording) {
  const std::string bytes = unpacked(apps::replay_stream(recording));
  EXPECT_EQ(bytes.substr(0, 8), std::string("HCRP\1\0\0\0", 8));
  std::vector<SentMessage> messages;
  for (std::size_t at = 8; at < bytes.size();) {
    SentMessage one{0, {}};
    std::uint32_t length = 0;
    std::memcpy(&one.time, bytes.data() + at, 8);
    std::memcpy(&length, bytes.data() + at + 8, 4);
    one.bytes = bytes.substr(at + 12, length);
    at += 12 + length;
    messages.push_back(std::move(one));
  }
  return messages;
}

/// Compares the messages with the recorded steps.
void expect_what_was_recorded(const Recording& recording, std::uint64_t steps) {
  const std::vector<SentMessage> messages = messages_in(recording);
  ASSERT_GT(messages.size(), 3U);
  EXPECT_EQ(messages[0].kind(), MessageKind::hello);
  EXPECT_EQ(messages[0].at<std::uint32_t>(4), 0U);  // a replay accepts no commands
  const view::Message tool = view::encode(recording.tool());
  EXPECT_EQ(messages[1].bytes, std::string(tool.begin(), tool.end()));
  EXPECT_EQ(messages[2].kind(), MessageKind::page);

  constexpr std::size_t kHead = 4;
  std::uint64_t told = 0;
  double before = 0, removed = 0, removed_by_steps = 0;
  int pictures = 0;
  const std::vector<RecordedStep> recorded = recording.read(0, steps);
  ASSERT_EQ(recorded.size(), steps);
  for (const SentMessage& one : messages) {
    EXPECT_GE(one.time, before);
    before = one.time;
    pictures += one.kind() == MessageKind::snapshot ? 1 : 0;
    if (one.kind() == MessageKind::trace) {
      ASSERT_EQ(one.at<std::uint64_t>(kHead), told);
      const auto count = one.at<std::uint32_t>(kHead + 8);
      for (std::uint32_t n = 0; n < count; ++n, ++told) {
        ASSERT_LT(told, steps);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          ASSERT_EQ(one.at<float>(kHead + 12 + 24 * n + 4 * std::size_t(axis)), float(recorded[told].force[axis]));
        removed_by_steps += recorded[told].removed_volume;
      }
      EXPECT_NEAR(removed, removed_by_steps, 1e-9 * removed_by_steps);
    }
    if (one.kind() == MessageKind::instruments) {
      const std::size_t materials = kHead + 96 + 8 + 16 + 8 + 4;  // without lateness
      removed = 0;
      for (std::uint32_t n = 0; n < one.at<std::uint32_t>(materials); ++n)
        removed += one.at<double>(materials + 4 + 8 * std::size_t(n));
    }
  }
  EXPECT_EQ(told, steps);
  const double seconds = recorded.back().time - recorded.front().time;
  EXPECT_NEAR(pictures, 30 * seconds + 1, 2);
  EXPECT_GT(removed, 0);
}

TEST(ReplayPage, HoldsEveryStepThatWasRecorded) {
  const test::TemporaryFolder folder;
  test::record_scene(folder / "a.h5", kScene, 510);
  expect_what_was_recorded(read_recording(folder / "a.h5"), 510);
}

// A hovering bur passes through the workpiece with a held spindle: it presses hard and crushes nothing. So does its
// replay.
TEST(ReplayPage, ABurThatHoversIntoTheWorkpieceReplaysWithTheSameBits) {
  using units::mm;
  const test::TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  {
    test::Desk desk;
    desk.turn("Record", 1);
    desk.lead(Vec3(0, 0, 1 * mm), false);
    for (const double x : {1, -1, 1}) desk.lead(Vec3(x * mm, 0, -1 * mm), false);
    desk.lead(Vec3(0, 0, 1 * mm), true);
    desk.lead(Vec3(0, 0, -0.3 * mm), true);  // cuts
    desk.lead(Vec3(1 * mm, 0, -1 * mm), false);
    desk.session.suspend();
  }
  std::filesystem::current_path(before);
  const Recording recording = read_recording(folder / "session-1.h5");
  std::uint64_t held_in_contact = 0;
  double removed = 0;
  for (const RecordedStep& step : recording.read(0, recording.size())) {
    held_in_contact += step.spindle_held && step.contact.voxels > 0 ? 1 : 0;
    removed += step.removed_volume;
  }
  EXPECT_GT(held_in_contact, 100U);
  EXPECT_GT(removed, 0);
  const ReplayReport report = replay(recording);
  EXPECT_EQ(report.steps, recording.size());
  EXPECT_TRUE(report.identical) << report.first_difference->column << " in step " << report.first_difference->step;
}

TEST(ReplayPage, ThatCannotBeWrittenLeavesTheOlderOneAsItIs) {
  const test::TemporaryFolder folder;
  for (const char* name : {"page.js", "page.css"}) std::ofstream(folder / name) << "/* page */";
  std::ofstream(folder / "index.html")
      << "<link rel=\"stylesheet\" href=\"page.css\"><script src=\"page.js\"></script>";
  const Recording recording = read_recording(test::record_scene(folder / "a.h5", kScene, 20));
  apps::write_replay_page(recording, folder / "", folder / "a.html");
  const std::string page = test::read_bytes(folder / "a.html");
  EXPECT_GT(page.size(), 1000U);
  const test::NoDiskSpace full;
  EXPECT_THROW(apps::write_replay_page(recording, folder / "", folder / "a.html"), Error);
  EXPECT_EQ(test::read_bytes(folder / "a.html"), page);
}

/// A recording of 250 steps, a change outside the steps, and 100 more steps.
template <class Happens>
Recording interrupted(const std::filesystem::path& path, const Happens& happens) {
  const test::Scene& scene = test::find_scene(kScene);
  Simulation simulation = scene.make();
  simulation.history().reserve(10000);
  {
    Recorder recorder(path, simulation, test::patient());
    for (int tick = 0; tick < 350; ++tick) {
      if (tick == 100) simulation.history().mark();
      if (tick == 250) happens(simulation);
      recorder.step(scene.input(tick));
    }
    recorder.close();
  }
  return read_recording(path);
}

TEST(ReplayPage, EndsWhereAnUndoHasEndedTheRecording) {
  const test::TemporaryFolder folder;
  expect_what_was_recorded(interrupted(folder / "a.h5", [](Simulation& s) { (void)s.history().undo(10000); }), 250);
}

TEST(ReplayPage, EndsWhereAnotherToolHasEndedTheRecording) {
  const test::TemporaryFolder folder;
  expect_what_was_recorded(interrupted(folder / "a.h5", [](Simulation& s) { s.set(s.tool()); }), 250);
}

/// A recording and a built page.
class WrittenReplay : public testing::Test {
 protected:
  WrittenReplay() {
    test::record_scene(folder / "a.h5", kScene, 60);
    page("index.html", "<link rel=\"stylesheet\" href=\"page.css\">\n<script src=\"page.js\"></script>");
    page("page.css", "body{}");
    page("page.js", "const end = '</script>';");
  }
  void page(const char* name, const std::string& text) { test::write_bytes(folder / name, text); }
  [[nodiscard]] Recording recording() const { return read_recording(folder / "a.h5"); }
  void expect_refused(const std::string& reason) const {
    try {
      apps::write_replay_page(recording(), folder / ".", folder / "a.html");
      FAIL() << reason;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }
  test::TemporaryFolder folder;
};

TEST_F(WrittenReplay, IsOnePageThatNeedsNothingElse) {
  apps::write_replay_page(recording(), folder / ".", folder / "a.html");
  const std::string html = test::read_bytes(folder / "a.html");
  EXPECT_NE(html.find("<style>body{}</style>"), std::string::npos);
  EXPECT_NE(html.find("const end = '<\\/script>';"), std::string::npos);  // does not end the element
  EXPECT_EQ(html.find("src="), std::string::npos);
  const std::string begin = "type=\"application/octet-stream\">";
  const std::size_t at = html.find(begin) + begin.size();
  // gzip begins with 1f 8b 08, and base64 takes three bytes for four digits.
  EXPECT_EQ(html.substr(at, 4), "H4sI");
  EXPECT_EQ(html.find('<', at) - at, (apps::replay_stream(recording()).size() + 2) / 3 * 4);
}

TEST_F(WrittenReplay, IsAFolderForAServer) {
  std::filesystem::create_directory(folder / "out");
  apps::write_replay_folder(recording(), folder / ".", folder / "out");
  const std::vector<std::uint8_t> stream = apps::replay_stream(recording());
  EXPECT_EQ(test::read_bytes(folder / "out/recording.bin"), std::string(stream.begin(), stream.end()));
  EXPECT_NE(test::read_bytes(folder / "out/index.html").find("data-from=\"recording.bin\""), std::string::npos);
  for (const char* name : {"page.css", "page.js"})
    EXPECT_EQ(test::read_bytes(folder / "out" / name), test::read_bytes(folder / name));
}

TEST_F(WrittenReplay, IsRefusedInASentenceWhereThePageIsNotThere) {
  page("index.html", "<html></html>");
  expect_refused("another version than this program");
  std::filesystem::remove(folder / "index.html");
  expect_refused("index.html' cannot be read; build the page again");
}

}  // namespace
}  // namespace hapticut::replay_page_test
