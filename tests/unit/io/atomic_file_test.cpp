// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "hapticut/core/errors.hpp"
#include "support/temporary_folder.hpp"

namespace hapticut::atomic_file_test {
namespace {

using test::TemporaryFolder;

TEST(AtomicFile, TheFileOfAKilledProgramIsRemovedByTheNextOne) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const AtomicFile file(folder / "a.txt");
    ::_exit(0);  // like a kill: no cleanup
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_EQ(folder.file_count(), 1U);
  const AtomicFile other(folder / "b.txt");
  EXPECT_EQ(folder.file_count(), 1U) << "the file of the dead process is gone, that of this one is there";
  const AtomicFile third(folder / "c.txt");
  EXPECT_EQ(folder.file_count(), 2U) << "the file of a living process stays";
}

// Two writers of one file, here three threads of two processes: each gives a whole file, and the last one stays.
TEST(AtomicFile, IsWholeHoweverManyWriteItAtOnce) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.txt";
  constexpr std::size_t kSize = 200'000;
  const auto write_often = [&](char letter) {
    for (int n = 0; n < 30; ++n) write_atomically(path, std::string(kSize, letter));
  };
  write_often('a');
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    write_often('b');
    ::_exit(0);
  }
  std::atomic<int> working{2};
  const auto work = [&](char letter) {
    write_often(letter);
    --working;
  };
  std::thread one(work, 'c'), two(work, 'd');
  do {
    const std::string text = test::read_bytes(path);
    EXPECT_EQ(text.size(), kSize);
    EXPECT_EQ(text.find_first_not_of(text[0]), std::string::npos);
  } while (working > 0 && !HasFailure());
  one.join();
  two.join();
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(folder.file_count(), 1U) << "no temporary file stays";
}

TEST(AtomicFile, BehindLinksIsMadeWhereTheyPoint) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink(folder / "c", folder / "b");
  EXPECT_EQ(place_behind_links(folder / "a"), folder / "c");
  write_atomically(folder / "a", "text");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "a"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "b"));
  EXPECT_EQ(test::read_bytes(folder / "c"), "text");
  std::filesystem::create_symlink("circle", folder / "circle");
  EXPECT_THROW(AtomicFile(folder / "circle"), Error);
}

TEST(AtomicFile, NamesMayBeAsLongAsTheSystemAllows) {
  const TemporaryFolder folder;
  for (const std::size_t length : {200U, 240U, 255U}) {
    const std::string name = std::string(length - 4, 'a') + ".txt";
    write_atomically(folder / name, [](std::ostream& stream) { stream << "text"; });
    EXPECT_EQ(test::read_bytes(folder / name), "text");
  }
  EXPECT_THROW(AtomicFile(folder / std::string(256, 'a')), Error);
}

}  // namespace
}  // namespace hapticut::atomic_file_test
