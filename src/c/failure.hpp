// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>

#include "hapticut/c/hapticut.h"

/// @file
/// How what goes wrong leaves the library: as a number, and as a sentence that waits in the thread.
namespace hapticut::c {

/// What a call is refused with that is no hapticut::Error.
class Refusal : public std::runtime_error {
 public:
  Refusal(hapticut_result code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  [[nodiscard]] int code() const { return code_; }

 private:
  int code_;
};

/// Keeps the sentence for this thread, cut to what there is room for.
/// @return code
int fail(int code, const char* sentence) noexcept;
[[nodiscard]] const char* last_failure() noexcept;

/// The number and the sentence of the exception that is being handled.
int fail_by_exception() noexcept;

/// Runs a function that may throw and returns a number, or nothing where all is well.
template <class Body>
int guarded(Body&& body) noexcept {
  try {
    if constexpr (std::is_void_v<decltype(body())>)
      body();
    else
      return body();
    return HAPTICUT_OK;
  } catch (...) {
    return fail_by_exception();
  }
}

/// @throws Refusal when it is null
void require_argument(const void* pointer, const char* name);

/// Copies a text, cut where a character of UTF-8 begins, and a 0.
void copy_text(const std::string& text, char* to, std::size_t capacity) noexcept;

}  // namespace hapticut::c
