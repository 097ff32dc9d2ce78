// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <set>
#include <string>
#include <vector>

/// @file
/// Standard output and the output files of a command. One that fails does not take the others with it.
namespace hapticut::apps {

/// The name that stands for standard output instead of a file.
inline constexpr const char* kStandardOutput = "-";

/// Prints an error on standard error, in the words of the flags.
void tell_error(const std::string& message);

/// Prints a text on standard output.
/// @throws Error when it could not be written completely: a full disk, a closed pipe
void print_on_stdout(const std::string& text);

/// Writes a text as a file, or to standard output for "-".
/// @throws Error when it could not be written completely
void write_text(const std::string& file, const std::string& text);

/// Thrown to end a command whose errors were told already.
class AlreadyTold : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "an output failed"; }
};

/// The outputs of a command. An error is told on standard error at once, the other outputs are still written, and
/// `finish` ends the command with the exit code of a failure.
class Delivery {
 public:
  /// Checks before the work begins that the files can be written, and creates their folders.
  /// @param texts  files of text, which may be "-": standard output
  /// @param files  other files. Empty names are outputs that are not wanted
  /// @throws Error when none of the wanted files can be written
  explicit Delivery(const std::vector<std::string>& texts, const std::vector<std::string>& files = {});

  /// Prints a text for people: on standard output, or on standard error when standard output is one of the files.
  void print(const std::string& text);

  /// Whether a file is wanted, and has not failed so far.
  [[nodiscard]] bool wants(const std::string& file) const;

  /// Begins a file that grows during the work, if it is wanted.
  /// @throws AlreadyTold when it fails and no other output is left
  void begin(const std::string& file, const std::function<void()>& work);

  /// Writes a file, if it is wanted.
  void write(const std::string& file, const std::function<void()>& work);

  /// Any other part of the command: its error is told, and the command goes on.
  void attempt(const std::function<void()>& work, const std::string& what = "this");

  /// @throws AlreadyTold when anything failed
  void finish() const;

 private:
  bool attempted(const std::function<void()>& work, const std::string& what);

  std::size_t usable_ = 0;  // outputs that can be written, when the work begins
  bool prints_on_stderr_ = false, print_failed_ = false, failed_ = false;
  std::set<std::string> failed_files_;
};

}  // namespace hapticut::apps
