// SPDX-License-Identifier: Apache-2.0
#include "io/recording/disk_space.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace hapticut {
namespace {

constexpr std::uint64_t kBytesAtOnce = 8 << 20;  // [bytes] reserved at a time, to reserve rarely

[[noreturn]] void fail(int error_number) { throw DiskSpace::Shortage(std::generic_category().message(error_number)); }

std::uint64_t length_of(int file) {
  struct stat status {};
  if (::fstat(file, &status) != 0) fail(errno);
  return std::uint64_t(status.st_size);
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
  const std::uint64_t reserved = std::min(max_length, length + kBytesAtOnce);
  if (::fallocate(file_, FALLOC_FL_KEEP_SIZE, 0, off_t(reserved)) != 0) {
    if (errno != EOPNOTSUPP && errno != ENOSYS) fail(errno);
    struct statvfs disk {};  // this file system cannot reserve: check the free space
    if (::fstatvfs(file_, &disk) != 0) fail(errno);
    const std::uint64_t now = length_of(file_), growth = reserved - std::min(reserved, now);
    if (std::uint64_t(disk.f_bavail) * disk.f_frsize < growth) fail(ENOSPC);
  }
  safe_ = reserved;
}

}  // namespace hapticut
