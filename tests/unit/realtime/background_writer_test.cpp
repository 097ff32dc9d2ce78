// SPDX-License-Identifier: Apache-2.0
// The ring and the thread of the recorder, without a file. Also run with the thread sanitizer.
#include "realtime/background_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>

namespace hapticut::background_writer_test {
namespace {

/// As large as a recorded step. All values of a complete row are equal.
using Row = std::array<long, 128>;

Row row_of(long number) {
  Row row;
  row.fill(number);
  return row;
}

TEST(BackgroundWriter, WritesEveryMessageWholeAndInOrderBesideALoopAtFullSpeed) {
  std::vector<long> written;
  bool whole = true;
  int flushes = 0;
  std::atomic<bool> was_full{false};
  BackgroundWriter<Row> writer(64, Row{}, 0.01,
                               {[&](const std::vector<Row>& batch) {
                                  while (!was_full) std::this_thread::yield();  // simulates a slow disk, once
                                  for (const Row& row : batch) {
                                    written.push_back(row.front());
                                    for (const long value : row) whole = whole && value == row.front();
                                  }
                                },
                                [&] { ++flushes; }});
  constexpr long kMessages = 100000;
  for (long n = 0; n < kMessages; ++n)
    while (!writer.push(row_of(n))) {
      was_full = true;
      std::this_thread::yield();
    }
  EXPECT_EQ(writer.stop(), "");
  EXPECT_FALSE(writer.running());
  EXPECT_TRUE(whole);
  EXPECT_GE(flushes, 1);
  ASSERT_EQ(written.size(), std::size_t(kMessages));
  for (long n = 0; n < kMessages; ++n) ASSERT_EQ(written[std::size_t(n)], n);
}

TEST(BackgroundWriter, EndsWhereItsSinkThrowsAndSaysWhy) {
  long written = 0;
  BackgroundWriter<Row> writer(16, Row{}, 0.01,
                               {[&](const std::vector<Row>& batch) {
                                  written += long(batch.size());
                                  if (written > 100) throw std::runtime_error("the disk is full");
                                },
                                [] {}});
  for (long n = 0; !writer.failed(); ++n)
    if (!writer.push(row_of(n))) std::this_thread::yield();
  while (writer.push(row_of(0))) {
  }
  EXPECT_FALSE(writer.push(row_of(0))) << "no thread empties the queue";
  EXPECT_EQ(writer.stop(), "the disk is full");
  EXPECT_EQ(writer.stop(), "the disk is full");
}

TEST(BackgroundWriter, EndsAfterAFailedFlushAndAfterAnyException) {
  BackgroundWriter<Row> flushing(
      16, Row{}, 0.01, {[](const std::vector<Row>&) {}, [] { throw std::runtime_error("no room to flush"); }});
  EXPECT_TRUE(flushing.push(row_of(1)));
  EXPECT_EQ(flushing.stop(), "no room to flush");
  EXPECT_TRUE(flushing.failed());

  BackgroundWriter<Row> strange(16, Row{}, 0.01, {[](const std::vector<Row>&) { throw 7; }, [] {}});
  EXPECT_TRUE(strange.push(row_of(1)));
  EXPECT_FALSE(strange.stop().empty());
  EXPECT_TRUE(strange.failed());
}

TEST(BackgroundWriter, WritesTheRemainingMessagesWhenItIsDestroyed) {
  long written = 0;
  {
    BackgroundWriter<Row> writer(1000, Row{}, 0.5,
                                 {[&](const std::vector<Row>& batch) { written += long(batch.size()); }, [] {}});
    for (long n = 0; n < 500; ++n) ASSERT_TRUE(writer.push(row_of(n)));
  }
  EXPECT_EQ(written, 500);
}

}  // namespace
}  // namespace hapticut::background_writer_test
