// SPDX-License-Identifier: Apache-2.0
// The ring and the thread of the recorder, without a file. The thread sanitizer watches.
#include "realtime/background_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace hapticut {
namespace {

/// As large as a recorded step, and whole only if all of it is the same.
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
  BackgroundWriter<Row> writer(64, Row{}, 0.01,
                               {[&](const std::vector<Row>& batch) {
                                  for (const Row& row : batch) {
                                    written.push_back(row.front());
                                    for (const long value : row) whole = whole && value == row.front();
                                  }
                                },
                                [&] { ++flushes; }});
  constexpr long kMessages = 100000;
  long full = 0;
  for (long n = 0; n < kMessages; ++n)
    while (!writer.push(row_of(n))) {
      ++full;
      std::this_thread::yield();
    }
  EXPECT_EQ(writer.stop(), "");
  EXPECT_FALSE(writer.running());
  EXPECT_GT(full, 0) << "the ring should have been full";
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
  EXPECT_FALSE(writer.push(row_of(0))) << "nobody takes any more";
  EXPECT_EQ(writer.stop(), "the disk is full");
  EXPECT_EQ(writer.stop(), "the disk is full");
}

TEST(BackgroundWriter, WritesWhatIsLeftWhenItGoesAway) {
  long written = 0;
  {
    BackgroundWriter<Row> writer(1000, Row{}, 0.5,
                                 {[&](const std::vector<Row>& batch) { written += long(batch.size()); }, [] {}});
    for (long n = 0; n < 500; ++n) ASSERT_TRUE(writer.push(row_of(n)));
  }
  EXPECT_EQ(written, 500);
}

}  // namespace
}  // namespace hapticut
