// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

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
extern const ChildProgram kDecoder;          ///< unpacks compressed DICOM pictures
extern const ChildProgram kRecordingReader;  ///< reads recordings

/// A child process for reading code that a damaged file can crash: the child dies, and this process reports an error.
/// `start` starts the child; its standard input is the socket of the connection. The child ends with this object.
/// docs/decisions/0011-readers.md explains why it is not a fork.
class ChildProcess {
 public:
  explicit ChildProcess(const ChildProgram& program) : program_(program) {}
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts the child unless it runs already.
  /// @throws Error when the program is missing or cannot be started
  void start();
  void stop() noexcept;
  [[nodiscard]] bool runs() const noexcept { return process_ > 0; }

  /// @return false when the child has ended
  [[nodiscard]] bool send(std::string_view bytes) const;

  /// @param[in,out] time_left  maximum waiting time; reduced by the time waited
  /// @return false when the child has ended, or when `time_left` is over (then 0)
  [[nodiscard]] bool receive(char* bytes, std::size_t count, std::chrono::nanoseconds& time_left) const;

 private:
  ChildProgram program_;
  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace hapticut
