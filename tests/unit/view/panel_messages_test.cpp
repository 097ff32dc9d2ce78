// SPDX-License-Identifier: Apache-2.0
// The bytes of the messages for the panels of a page.
#include <gtest/gtest.h>

#include <string>

#include "unit/view/command_bytes.hpp"

namespace hapticut::panel_messages_test {
namespace {

using namespace view;
using view_test::number_at;

TEST(PanelMessages, AToolIsItsHandleAndItsOutline) {
  const Tool tool(FlatHead{1e-3, 3e-3, FlatRule::bottom_only}, LHandle{0.1, 0.015, 0.5});
  const Message message = encode(tool);
  EXPECT_EQ(message[0], 5);
  EXPECT_EQ(number_at<std::uint32_t>(message, 100), 1U) << "an L";
  EXPECT_EQ(number_at<double>(message, 104), 0.1);
  EXPECT_EQ(number_at<double>(message, 112), 0.015);
  EXPECT_EQ(number_at<double>(message, 120), 0.5);
  EXPECT_EQ(number_at<double>(message, 128), 0.0) << "its tip";
  ASSERT_EQ(number_at<std::uint32_t>(message, 136), 3U) << "edges";
  ASSERT_EQ(message.size(), 140 + 3 * 28U);
  EXPECT_EQ(number_at<double>(message, 140), 1e-3);
  EXPECT_EQ(number_at<std::uint32_t>(message, 140 + 24), 1U) << "the bottom cuts";
  EXPECT_EQ(number_at<std::uint32_t>(message, 140 + 28 + 24), 0U) << "the side is smooth";
  const Message straight = encode(Tool(SphereHead{1e-3}, RayHandle{0.2}));
  EXPECT_EQ(number_at<std::uint32_t>(straight, 100), 0U);
  EXPECT_EQ(number_at<double>(straight, 104), 0.2);
}

TEST(PanelMessages, ControlsDescribeThemselves) {
  const std::vector<Control> controls = {
      {7, Control::Kind::choice, 1, 0, 2, "tool", "Head", "mm", "ball|cone|flat", "off", 0.5, 1.5, 1.75, "who"}};
  const Message message = encode(controls);
  EXPECT_EQ(message[0], 6);
  EXPECT_EQ(number_at<std::uint32_t>(message, 4), 1U);
  EXPECT_EQ(number_at<std::uint16_t>(message, 8), 7);
  EXPECT_EQ(message[10], 2) << "a choice";
  EXPECT_EQ(message[11], 0);
  EXPECT_EQ(number_at<double>(message, 12), 1);
  EXPECT_EQ(number_at<double>(message, 28), 2);
  EXPECT_EQ(number_at<double>(message, 36), 0.5);
  EXPECT_EQ(number_at<double>(message, 52), 1.75);
  EXPECT_EQ(number_at<std::uint16_t>(message, 60), 4);
  EXPECT_EQ(std::string(message.begin() + 62, message.begin() + 66), "tool");
  EXPECT_EQ(std::string(message.end() - 3, message.end()), "who");
  EXPECT_EQ(message.size(), 60 + (2 + 4) + (2 + 4) + (2 + 2) + (2 + 14) + (2 + 3) + (2 + 3U));
}

TEST(PanelMessages, ATraceIsSixNumbersATick) {
  const std::vector<TraceSample> samples = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}};
  const Message message = encode_trace(99, samples);
  ASSERT_EQ(message.size(), 16 + 48U);
  EXPECT_EQ(message[0], 7);
  EXPECT_EQ(number_at<std::uint64_t>(message, 4), 99U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 12), 2U);
  EXPECT_EQ(number_at<float>(message, 16 + 4), 2);
  EXPECT_EQ(number_at<float>(message, 16 + 24 + 20), 12);
}

TEST(PanelMessages, ANoticeIsASentenceAndHowBadItIs) {
  const Message message = encode_notice(Severity::error, "No.");
  ASSERT_EQ(message.size(), 15U);
  EXPECT_EQ(message[0], 8);
  EXPECT_EQ(number_at<std::uint32_t>(message, 4), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 8), 3U);
  EXPECT_EQ(std::string(message.begin() + 12, message.end()), "No.");
}

TEST(PanelMessages, InstrumentsHaveLatencyAndVolumes) {
  Instruments given;
  given.X_WG = Pose::from_translation(Vec3(0.1, 0.2, 0.3));
  given.power = 4;
  given.ticks = 1000;
  given.missed = 2;
  given.bucket = 25e-6;
  given.latency = {998, 2};
  given.removed = {1e-9, 0, 3e-9};
  given.forces = {0.5, 0, 2};
  given.under = 3;
  const Message message = encode(given);
  ASSERT_EQ(message.size(), 132 + 4 + 8 + 4 + 24 + 4 + 24 + 4U);
  EXPECT_EQ(message[0], 9);
  EXPECT_EQ(number_at<double>(message, 4 + 72), 0.1);
  EXPECT_EQ(number_at<double>(message, 100), 4);
  EXPECT_EQ(number_at<std::uint64_t>(message, 108), 1000U);
  EXPECT_EQ(number_at<std::uint64_t>(message, 116), 2U);
  EXPECT_EQ(number_at<double>(message, 124), 25e-6);
  EXPECT_EQ(number_at<std::uint32_t>(message, 132), 2U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 136), 998U);
  EXPECT_EQ(number_at<std::uint32_t>(message, 144), 3U);
  EXPECT_EQ(number_at<double>(message, 148 + 16), 3e-9);
  EXPECT_EQ(number_at<std::uint32_t>(message, 172), 3U);
  EXPECT_EQ(number_at<double>(message, 176 + 16), 2);
  EXPECT_EQ(number_at<std::uint32_t>(message, 200), 3U) << "under the tip";
}

TEST(PanelMessages, HeatHasAByteForEachCell) {
  Heat given;
  given.X_WC = Pose::from_translation(Vec3(0.1, 0.2, 0.3));
  given.cell_size = 4e-4;
  given.dims = {2, 1, 1};
  given.first = 10.25;
  given.step = 0.5;
  given.structures = {{50, 80, 3}};
  given.cells = {0, 74};
  const Message message = encode(given);
  ASSERT_EQ(message.size(), 4 + 96 + 8 + 12 + 32 + 4 + 24 + 2U);
  EXPECT_EQ(message[0], 10);
  EXPECT_EQ(number_at<double>(message, 4 + 72), 0.1);
  EXPECT_EQ(number_at<double>(message, 100), 4e-4);
  EXPECT_EQ(number_at<std::uint32_t>(message, 108), 2U);
  EXPECT_EQ(number_at<double>(message, 120), 10.25);
  EXPECT_EQ(number_at<double>(message, 144), 47) << "the threshold";
  EXPECT_EQ(number_at<std::uint32_t>(message, 152), 1U);
  EXPECT_EQ(number_at<double>(message, 156), 50);
  EXPECT_EQ(number_at<double>(message, 172), 3) << "s above the threshold";
  EXPECT_EQ(message[181], 74);
  EXPECT_EQ(encode(Heat{}).size(), 156U) << "off";
}

}  // namespace
}  // namespace hapticut::panel_messages_test
