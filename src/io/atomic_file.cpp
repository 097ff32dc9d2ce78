// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "hapticut/core/errors.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw Error("cannot write '" + path.string() + "': " + reason +
              ". Check the folder, its permissions and the free disk space.");
}

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : path_(path) {
  static std::atomic<unsigned> counter{0};
  std::error_code code;
  if (!path.has_filename()) fail(path, "it has no file name");
  if (fs::is_symlink(path, code)) path_ = fs::weakly_canonical(path, code);  // keep the link, replace what it names
  const fs::file_status status = fs::status(path_, code);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it exists and is not a regular file");
  const std::string name =
      ".hapticut-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-" + path_.filename().string();
  temporary_path_ = path_.parent_path() / name;
  // O_EXCL: no other file is ever overwritten under the temporary name.
  const int file = ::open(temporary_path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0) fail(path, reason_of(errno));
  ::close(file);
}

AtomicFile::~AtomicFile() {
  if (!committed_) ::unlink(temporary_path_.c_str());
}

void AtomicFile::commit() {
  const int file = ::open(temporary_path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail(path_, reason_of(errno));
  const bool synced = ::fsync(file) == 0;
  const int sync_error = errno;
  ::close(file);
  if (!synced) fail(path_, reason_of(sync_error));
  if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) fail(path_, reason_of(errno));
  committed_ = true;
}

void write_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  AtomicFile file(path);
  errno = 0;
  try {
    std::ofstream stream;
    stream.exceptions(std::ios_base::failbit | std::ios_base::badbit);
    stream.open(file.temporary_path(), std::ios_base::binary | std::ios_base::trunc);
    write(stream);
    stream.flush();
    stream.close();
  } catch (const std::ios_base::failure&) {
    fail(path, errno != 0 ? reason_of(errno) : "writing failed");
  }
  file.commit();
}

}  // namespace hapticut
