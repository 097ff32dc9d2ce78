// SPDX-License-Identifier: Apache-2.0
#include "reports/delivery.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/lack_of_memory.hpp"
#include "hapticut/core/errors.hpp"
#include "io/atomic_file.hpp"
#include "reports/flag_words.hpp"
#include "reports/json_file.hpp"

namespace hapticut::apps {

void tell_error(const std::string& message) {
  const char* const erase_bar = ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
  std::fprintf(stderr, "%shapticut: %s\n", erase_bar, message.c_str());
}

void print_on_stdout(const std::string& text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 &&
                       std::ferror(stdout) == 0;
  if (written) return;
  const int reason = errno;
  std::clearerr(stdout);  // the end of the program does not tell it again
  throw Error("cannot write to standard output: " +
              (reason != 0 ? std::generic_category().message(reason) : std::string("writing failed")) +
              ". Check where it is redirected to, and the free disk space there.");
}

void write_text(const std::string& file, const std::string& text) {
  if (file == kStandardOutput) return print_on_stdout(text);
  write_atomically(file, text);
}

Delivery::Delivery(const std::vector<std::string>& texts, const std::vector<std::string>& files) {
  prints_on_stderr_ = std::ranges::find(texts, kStandardOutput) != texts.end();
  std::vector<std::string> errors;
  const auto check = [&](const std::string& file) {
    try {
      require_writable(file);
      ++usable_;
    } catch (const Error& error) {
      errors.push_back(in_words_of_flags(error));
      failed_files_.insert(file);
    }
  };
  for (const std::string& file : texts) {
    if (file == kStandardOutput) ++usable_;
    if (!file.empty() && file != kStandardOutput) check(file);
  }
  for (const std::string& file : files) {
    if (file == kStandardOutput) {
      errors.emplace_back("'-' is standard output, which takes text only; give this file a name.");
      failed_files_.insert(file);
    } else if (!file.empty()) {
      check(file);
    }
  }
  if (errors.empty()) return;
  failed_ = true;
  const std::string last = errors.back();
  if (usable_ == 0) errors.pop_back();
  for (const std::string& error : errors) tell_error(error);
  if (usable_ == 0) throw Error(last);
}

void Delivery::print(const std::string& text) {
  if (prints_on_stderr_) {
    std::fputs(text.c_str(), stderr);
  } else if (!print_failed_) {
    print_failed_ = !attempted([&] { print_on_stdout(text); }, "the table");
  }
}

bool Delivery::wants(const std::string& file) const { return !file.empty() && !failed_files_.contains(file); }

void Delivery::begin(const std::string& file, const std::function<void()>& work) {
  if (!wants(file) || attempted(work, "'" + file + "'")) return;
  failed_files_.insert(file);
  if (--usable_ == 0) throw AlreadyTold();
}

void Delivery::write(const std::string& file, const std::function<void()>& work) {
  if (wants(file) && !attempted(work, "'" + file + "'")) failed_files_.insert(file);
}

void Delivery::attempt(const std::function<void()>& work, const std::string& what) { (void)attempted(work, what); }

bool Delivery::attempted(const std::function<void()>& work, const std::string& what) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    tell_error(is_lack_of_memory(error)
                   ? "there is not enough memory to write " + what + ". Use larger voxels or a smaller piece."
                   : in_words_of_flags(error));
  }
  failed_ = true;
  return false;
}

void Delivery::finish() const {
  if (failed_) throw AlreadyTold();
}

}  // namespace hapticut::apps
