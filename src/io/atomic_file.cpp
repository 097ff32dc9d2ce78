// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have kill
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "hapticut/core/errors.hpp"
#include "io/writer_lock.hpp"

namespace hapticut {
namespace {

namespace fs = std::filesystem;

std::string text_of_errno(int error_number) { return std::generic_category().message(error_number); }

constexpr std::string_view kTemporaryPrefix = ".hapticut-";
constexpr std::size_t kMaxName = 255;  // [bytes] length of a file name

/// Identifies this machine and its process-id namespace: process ids mean the same only within both.
std::string home_of_processes() {
  char host[256] = {};
  ::gethostname(host, sizeof host - 1);
  std::error_code code;
  const std::string space = fs::read_symlink("/proc/self/ns/pid", code).string();
  std::array<char, 24> text;
  std::snprintf(text.data(), text.size(), "%08zx", std::hash<std::string>{}(host + space) & 0xffffffffU);
  return text.data();
}

/// ".hapticut-HOME-PROCESS-NUMBER-NAME"; a long name is shortened to its end, which has the extension.
std::string temporary_name(const std::string& name) {
  static std::atomic<unsigned> counter{0};
  static const std::string home = home_of_processes();
  const std::string start =
      std::string(kTemporaryPrefix) + home + "-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "-";
  return start + name.substr(name.size() - std::min(name.size(), kMaxName - start.size()));
}

/// Id of the process that made a temporary file here and has ended, or 0.
pid_t gone_maker_of(const std::string& name) {
  static const std::string start = std::string(kTemporaryPrefix) + home_of_processes() + "-";
  pid_t maker = 0;
  if (!name.starts_with(start)) return 0;
  const char* first = name.data() + start.size();
  const auto [end, error] = std::from_chars(first, name.data() + name.size(), maker);
  if (error != std::errc{} || end == first || *end != '-' || maker <= 0) return 0;
  return ::kill(maker, 0) != 0 && errno == ESRCH ? maker : 0;
}

/// Removes temporary files that killed programs left in a folder.
void remove_leftovers(const fs::path& folder) {
  std::error_code code;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, code), end; !code && entry != end;
       entry.increment(code))
    if (gone_maker_of(entry->path().filename().string()) != 0) ::unlink(entry->path().c_str());
}

}  // namespace

void cannot_write(const fs::path& path, const Sentence& reason, const std::string& what) {
  throw Error("cannot write " + what + "'" + path.string() + "': " + reason +
              ". Check the folder, its permissions and the free disk space.");
}

fs::path place_behind_links(const fs::path& path) {
  constexpr int kMaxLinks = 40;  // as in Linux
  std::error_code code;
  if (!fs::is_symlink(path, code)) return path;
  if (fs::exists(path, code)) {
    fs::path place = fs::canonical(path, code);
    return code ? path : place;  // the target of /dev/stdout can be a pipe, which has no path
  }
  fs::path place = path;  // `weakly_canonical` does not follow a link whose target is missing
  for (int links = 0; links < kMaxLinks && fs::is_symlink(place, code); ++links) {
    const fs::path target = fs::read_symlink(place, code);
    if (code) return path;
    place = place.parent_path() / target;
  }
  return place;
}

AtomicFile::AtomicFile(const fs::path& path) : path_(place_behind_links(path)) {
  std::error_code code;
  if (!path.has_filename()) cannot_write(path, "it has no file name");
  const fs::file_status status = fs::status(path_, code);
  if (status.type() == fs::file_type::none) cannot_write(path, code.message());  // such as a circle of links
  if (fs::exists(status) && !fs::is_regular_file(status)) cannot_write(path, "it exists and is not a regular file");
  if (path_.filename().string().size() > kMaxName) cannot_write(path, text_of_errno(ENAMETOOLONG));
  if (has_writer_lock(path_)) refuse_second_writer(path);
  remove_leftovers(path_.parent_path());
  temporary_path_ = path_.parent_path() / temporary_name(path_.filename().string());
  // O_EXCL: the temporary name never overwrites another file.
  const int file = ::open(temporary_path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0) cannot_write(path, text_of_errno(errno));
  ::close(file);
}

AtomicFile::~AtomicFile() {
  if (!committed_) ::unlink(temporary_path_.c_str());
}

void AtomicFile::flush() const {
  const int file = ::open(temporary_path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) cannot_write(path_, text_of_errno(errno));
  const bool synced = ::fsync(file) == 0;
  const int sync_error = errno;
  ::close(file);
  if (!synced) cannot_write(path_, text_of_errno(sync_error));
}

void AtomicFile::commit() {
  flush();
  if (has_writer_lock(path_)) refuse_second_writer(path_);
  if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) cannot_write(path_, text_of_errno(errno));
  committed_ = true;
}

void AtomicFile::commit_new() {
  flush();
  // A file system that cannot rename so replaces the file.
  if (::renameat2(AT_FDCWD, temporary_path_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST && has_writer_lock(path_)) refuse_second_writer(path_);
    if (errno != EINVAL && errno != ENOSYS) cannot_write(path_, text_of_errno(errno));
    return commit();
  }
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
    cannot_write(path, errno != 0 ? text_of_errno(errno) : "writing failed");
  }
  file.commit();
}

void write_atomically(const fs::path& path, std::string_view bytes) {
  write_atomically(path, [&](std::ostream& stream) { stream.write(bytes.data(), std::streamsize(bytes.size())); });
}

}  // namespace hapticut
