// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace hapticut::test {

/// Runs a command of the shell with its stdout and stderr on a terminal, and returns all that it writes there.
inline std::string run_on_terminal(const std::string& command) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child < 0) return "no terminal could be made";
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  std::string written;
  char buffer[4096];
  for (ssize_t count; (count = ::read(terminal, buffer, sizeof buffer)) > 0;)
    written.append(buffer, std::size_t(count));
  ::close(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  return written;
}

}  // namespace hapticut::test
