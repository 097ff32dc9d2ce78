// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>

#include "hapticut/c/hapticut.h"

/// @file
/// How errors leave the library: as a number, and as a sentence that is kept for the thread.
namespace hapticut::c {

/// An error of the C interface that is not a hapticut::Error.
class Refusal : public std::runtime_error {
 public:
  Refusal(hapticut_result code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  [[nodiscard]] int code() const { return code_; }

 private:
  int code_;
};

/// Stores the sentence for this thread, cut to the size of the buffer.
/// @return code
int fail(int code, const char* sentence) noexcept;
[[nodiscard]] const char* last_failure() noexcept;

/// Stores the sentence of the exception that is being handled.  @return its code
int fail_by_exception() noexcept;

/// Runs a function that may throw.  @return the code that it returns, HAPTICUT_OK if it returns void, or an error code
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

/// @throws Refusal when the pointer is null
void require_argument(const void* pointer, const char* name);

/// Copies a text and a final 0. A long text is cut at the start of a UTF-8 character.
void copy_text(const std::string& text, char* to, std::size_t capacity) noexcept;

}  // namespace hapticut::c
