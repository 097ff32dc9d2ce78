// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "io/child_messages.hpp"

namespace hapticut {

/// A program that comes with the library, and its possible places.
struct ChildProgram {
  const char* name;       ///< file name
  const char* variable;   ///< environment variable with its path; overrides all other places
  const char* installed;  ///< path after `cmake --install`
  const char* built;      ///< path in the build tree; empty: not built
  const char* need;       ///< begins the message that the program is missing: "its values are compressed"
  const char* unbuilt;    ///< continues it when the program was not built: ", which needs ITK"
  const char* otherwise;  ///< ends the message: ", or save the file uncompressed"; may be empty
};

/// A child process for reading code that a damaged file can crash: the child dies, and this process reports an error.
/// Its side is `child::serve`. The child ends with this object. docs/decisions/0011-readers.md explains why it is not a
/// fork.
class ChildProcess {
 public:
  static constexpr std::chrono::seconds kMaxReplyTime{20};

  /// A reply with its content.
  struct Answer {
    Reply::Result result;
    std::uint64_t reason;
    std::string content;
  };

  /// @param time_limit  maximum time of one request and its reply
  explicit ChildProcess(const ChildProgram& program, std::chrono::nanoseconds time_limit = kMaxReplyTime)
      : program_(program), time_limit_(time_limit) {}
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts the child unless it runs already.
  /// @throws Error when the program is missing or cannot be started
  void start();
  void stop() noexcept;

  /// Sends a request and waits for its reply.
  /// @param limits     memory and processor time of the child
  /// @param max_bytes  maximum length of the reply's content
  /// @return nullopt when the child does not run, ends, takes too long or sends something else; it is then stopped
  [[nodiscard]] std::optional<Answer> ask(std::string_view content, Request limits, std::uint64_t max_bytes);

 private:
  ChildProgram program_;
  std::chrono::nanoseconds time_limit_;
  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace hapticut
