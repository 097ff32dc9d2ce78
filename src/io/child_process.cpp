// SPDX-License-Identifier: Apache-2.0
#include "io/child_process.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): <csignal> need not have kill
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "hapticut/core/errors.hpp"

extern char** environ;

namespace hapticut {
namespace {

namespace fs = std::filesystem;

/// Path of a program. Searched in this order: the environment variable, the folder of this code, the package folder
/// relative to it, the install path, the build path.
fs::path place_of(const ChildProgram& program) {
  if (const char* given = std::getenv(program.variable)) return given;
  std::error_code code;
  Dl_info here{};
  std::vector<fs::path> candidates;
  // The dynamic linker knows a program started by PATH without its folder.
  const bool known = ::dladdr(reinterpret_cast<void*>(&place_of), &here) != 0 && here.dli_fname != nullptr &&
                     std::strchr(here.dli_fname, '/') != nullptr;
  const fs::path folder = fs::weakly_canonical(known ? here.dli_fname : "/proc/self/exe", code).parent_path();
  for (const char* place : {"", "../libexec/hapticut", "../../libexec/hapticut"})
    candidates.push_back(folder / place / program.name);
  candidates.emplace_back(program.installed);
  candidates.emplace_back(program.built);
  for (const fs::path& candidate : candidates)
    if (fs::is_regular_file(candidate, code)) return candidate;
  if (*program.built == '\0') throw Error(std::string(program.need) + program.unbuilt + program.otherwise + ".");
  throw Error(std::string(program.need) + ", but the program '" + program.name +
              "', which comes with the library, was not found; set the environment variable " + program.variable +
              program.otherwise + ".");
}

using Clock = std::chrono::steady_clock;

/// Sends or receives bytes until all are transferred.
/// @param event     POLLIN or POLLOUT
/// @param transfer  part of the bytes without waiting, as ::recv
/// @return false when the child has ended, or at the end of the time
template <class Byte, class Transfer>
bool transfer_all(int socket, short event, Byte* bytes, std::size_t count, Clock::time_point end,
                  const Transfer& transfer) {
  while (count > 0) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    pollfd waiting{socket, event, 0};
    const int ready = ::poll(&waiting, 1, std::max(int(left.count()), 0));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t moved = transfer(socket, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (moved < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (moved <= 0) return false;
    bytes += moved;
    count -= std::size_t(moved);
  }
  return true;
}

}  // namespace

ChildProcess::~ChildProcess() { stop(); }

void ChildProcess::start() {
  if (process_ > 0) return;
  const std::string program = place_of(program_).string();
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Error(std::string(program_.need) + ", but a connection to the program '" + program +
                "' failed: " + std::strerror(errno) + ".");
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  char* arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  const int failure = ::posix_spawn(&process_, program.c_str(), &actions, &attributes, arguments, environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  socket_ = ends[0];
  if (failure == 0) return;
  process_ = -1;
  stop();
  throw Error(std::string(program_.need) + ", but the program '" + program +
              "' cannot be started: " + std::strerror(failure) + ".");
}

void ChildProcess::stop() noexcept {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
}

std::optional<ChildProcess::Answer> ChildProcess::ask(std::string_view content, Request limits,
                                                      std::uint64_t max_bytes) {
  const Clock::time_point end = Clock::now() + time_limit_;
  limits.bytes = content.size();
  Reply reply;
  const auto send = [&](const char* bytes, std::size_t count) {
    return transfer_all(socket_, POLLOUT, bytes, count, end, ::send);
  };
  const auto receive = [&](char* bytes, std::size_t count) {
    return transfer_all(socket_, POLLIN, bytes, count, end, ::recv);
  };
  if (process_ > 0 && send(reinterpret_cast<const char*>(&limits), sizeof limits) &&
      send(content.data(), content.size()) && receive(reinterpret_cast<char*>(&reply), sizeof reply) &&
      reply.result <= Reply::Result::no_memory && reply.bytes <= max_bytes) {
    Answer answer{reply.result, reply.reason, std::string(reply.bytes, '\0')};
    if (receive(answer.content.data(), answer.content.size())) return answer;
  }
  stop();
  return std::nullopt;
}

}  // namespace hapticut
