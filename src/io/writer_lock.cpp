// SPDX-License-Identifier: Apache-2.0
#include "io/writer_lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "hapticut/core/errors.hpp"
#include "io/atomic_file.hpp"

namespace hapticut {
namespace {

/// The lock: one byte far beyond the end of any file. It belongs to the open file, not to the process, so that two
/// writers of one process exclude each other too. The locks that HDF5 sets (flock) are of another kind.
struct flock mark() noexcept {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = off_t(1) << 62;
  lock.l_len = 1;
  return lock;
}

/// Whether the two kinds of locks are one. HDF5 could not open a file that is locked here.
bool is_of_a_network(int file) noexcept {
  constexpr unsigned kNfs = 0x6969, kSmb = 0x517b, kCifs = 0xff534d42, kSmb2 = 0xfe534d42;  // linux/magic.h
  struct statfs system {};
  if (::fstatfs(file, &system) != 0) return true;
  const auto type = unsigned(system.f_type);
  return type == kNfs || type == kSmb || type == kCifs || type == kSmb2;
}

/// @return false: another writer has the lock. Where a file system has no such locks, writers do not see each other
bool lock(int file) noexcept {
  struct flock wanted = mark();
  return is_of_a_network(file) || ::fcntl(file, F_OFD_SETLK, &wanted) == 0 || (errno != EAGAIN && errno != EACCES);
}

bool is_locked(int file) noexcept {
  struct flock found = mark();
  return ::fcntl(file, F_OFD_GETLK, &found) == 0 && found.l_type != F_UNLCK;
}

/// An open file; -1 when it cannot be opened.
class OpenFile {
 public:
  OpenFile(const std::filesystem::path& path, int mode)
      : id(::open(path.c_str(), mode | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~OpenFile() {
    if (id >= 0) ::close(id);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  const int id;
};

bool is_file_at(int file, const std::filesystem::path& path) noexcept {
  struct stat opened {
  }, there{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_dev == there.st_dev &&
         opened.st_ino == there.st_ino;
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& path) : file_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
  if (file_ < 0) cannot_write(path, std::generic_category().message(errno));
  (void)lock(file_);  // nobody else has it
}

void WriterLock::release() noexcept {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
}

bool has_writer_lock(const std::filesystem::path& path) noexcept {
  const OpenFile file(path, O_RDONLY);
  return file.id >= 0 && is_locked(file.id);
}

bool remove_left_file(const std::filesystem::path& path) noexcept {
  const OpenFile file(path, O_WRONLY);
  if (file.id < 0) {
    if (has_writer_lock(path)) return false;
  } else if (!lock(file.id) || !is_file_at(file.id, path)) {
    return false;  // only who has the lock removes the file, because another writer may have put its own there
  }
  ::unlink(path.c_str());
  return true;
}

void refuse_second_writer(const std::filesystem::path& path, const std::string& what) {
  throw Error("cannot write " + what + "'" + path.string() +
              "': a recorder of this or another program is still writing to it; choose another file, or end that "
              "recording first.");
}

}  // namespace hapticut
