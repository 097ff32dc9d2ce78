// SPDX-License-Identifier: Apache-2.0
#include "io/recording/disk_space.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace hapticut {
namespace {

constexpr std::uint64_t kBytesAtOnce = 8 << 20;  // [bytes] reserved at a time, to reserve rarely

[[noreturn]] void fail(int error_number) { throw DiskSpace::Shortage(std::generic_category().message(error_number)); }

/// [bytes] that a file has on its disk.
std::uint64_t bytes_on_disk(int file) {
  constexpr std::uint64_t kUnit = 512;  // [bytes] unit of st_blocks
  struct stat status {};
  if (::fstat(file, &status) != 0) fail(errno);
  return std::uint64_t(status.st_blocks) * kUnit;
}

std::uint64_t free_bytes(int file) {
  struct statvfs disk {};
  if (::fstatvfs(file, &disk) != 0) fail(errno);
  return std::uint64_t(disk.f_bavail) * disk.f_frsize;
}

std::string megabytes(std::uint64_t bytes) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f MB", double(bytes) * 1e-6);
  return text.data();
}

/// Reserves the disk space of a file up to a length.
/// @return false: the disk is too full
bool reserve(int file, std::uint64_t length) {
  if (::fallocate(file, FALLOC_FL_KEEP_SIZE, 0, off_t(length)) == 0) return true;
  if (errno == ENOSPC) return false;
  if (errno != EOPNOTSUPP && errno != ENOSYS) fail(errno);
  // This file system cannot reserve: check the free space.
  return free_bytes(file) >= length - std::min(length, bytes_on_disk(file));
}

}  // namespace

DiskSpace::DiskSpace(const std::filesystem::path& path) : file_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
  if (file_ < 0) fail(errno);
}

DiskSpace::~DiskSpace() {
  struct stat status {};
  // Truncating to the present length frees the reserved space beyond it. If that fails, the file only takes more disk
  // space.
  if (::fstat(file_, &status) == 0) (void)!::ftruncate(file_, status.st_size);
  ::close(file_);
}

void DiskSpace::require(std::uint64_t length) {
  if (length <= safe_) return;
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const std::uint64_t max_length =
      limit.rlim_cur == RLIM_INFINITY ? length + kBytesAtOnce : std::uint64_t(limit.rlim_cur);
  if (length > max_length) fail(EFBIG);
  for (const std::uint64_t reserved : {std::min(max_length, length + kBytesAtOnce), length})
    if (reserve(file_, reserved)) {
      safe_ = reserved;
      return;
    }
  const std::uint64_t needed = length - std::min(length, bytes_on_disk(file_));
  throw Shortage(std::generic_category().message(ENOSPC) + ": it needs " + megabytes(needed) + " free, and " +
                 megabytes(free_bytes(file_)) + " are there");
}

}  // namespace hapticut
