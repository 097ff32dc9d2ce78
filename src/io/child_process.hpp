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

/// A program that comes with the library, and where it may be.
struct ChildProgram {
  const char* name;       ///< of its file
  const char* variable;   ///< environment variable that names it, before all other places
  const char* installed;  ///< path after `cmake --install`
  const char* built;      ///< path in the build tree; empty: it was not built
  const char* need;       ///< begins the sentence that says it is missing: "its values are compressed"
  const char* unbuilt;    ///< goes on where it was not built: ", which needs ITK"
  const char* otherwise;  ///< ends either sentence: ", or save the file uncompressed"; may be empty
};
extern const ChildProgram kDecoder;          ///< unpacks compressed DICOM pictures
extern const ChildProgram kRecordingReader;  ///< reads recordings

/// A program of its own for what may end a process when a file is damaged: it dies, and this one says so. It is started
/// by `start`, is talked to over a socket that is its input, and ends with this object; docs/decisions/0011-readers.md
/// says why it is no fork.
class ChildProcess {
 public:
  explicit ChildProcess(const ChildProgram& program) : program_(program) {}
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts it, unless it runs.
  /// @throws Error a sentence, when it is missing or cannot be started
  void start();
  void stop() noexcept;
  [[nodiscard]] bool runs() const noexcept { return process_ > 0; }

  /// @return whether all was sent; not: it has ended
  [[nodiscard]] bool send(std::string_view bytes) const;

  /// @param patience  how long may be waited; becomes shorter by what was
  /// @return whether all came; not: it has ended, or the patience has, which is then 0
  [[nodiscard]] bool receive(char* bytes, std::size_t count, std::chrono::nanoseconds& patience) const;

 private:
  ChildProgram program_;
  pid_t process_ = -1;
  int socket_ = -1;
};

}  // namespace hapticut
