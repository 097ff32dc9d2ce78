// SPDX-License-Identifier: Apache-2.0
#include "c/failure.hpp"

#include <array>
#include <cstring>
#include <new>

#include "c/words_of_c.hpp"

namespace hapticut::c {
namespace {

// No destructor: a thread may end, or the library be unloaded, at any time.
thread_local std::array<char, 2048> sentence_of_thread{};

std::size_t cut_length(const char* text, std::size_t length, std::size_t capacity) noexcept {
  if (length < capacity) return length;
  std::size_t cut = capacity - 1;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0U) == 0x80U)
    --cut;  // not in the middle of a character
  return cut;
}

void copy(const char* text, std::size_t length, char* to, std::size_t capacity) noexcept {
  const std::size_t cut = cut_length(text, length, capacity);
  std::memcpy(to, text, cut);
  to[cut] = '\0';
}

/// Reports an Error of the library in the words of C.
int fail_in_words_of_c(const Error& error) noexcept {
  try {
    return fail(HAPTICUT_ERROR_REFUSED, in_words_of_c(error).c_str());
  } catch (const std::exception&) {  // no memory for the words of C
    return fail(HAPTICUT_ERROR_REFUSED, error.what());
  }
}

}  // namespace

int fail(int code, const char* sentence) noexcept {
  copy(sentence, std::strlen(sentence), sentence_of_thread.data(), sentence_of_thread.size());
  return code;
}

const char* last_failure() noexcept { return sentence_of_thread.data(); }

int fail_by_exception() noexcept {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return fail(refusal.code(), refusal.what());
  } catch (const Error& error) {
    return fail_in_words_of_c(error);
  } catch (const std::bad_alloc&) {
    return fail(HAPTICUT_ERROR_MEMORY, "There is not enough memory; use larger voxels or a smaller workpiece.");
  } catch (const std::exception& error) {
    return fail(HAPTICUT_ERROR_INTERNAL, error.what());
  } catch (...) {
    return fail(HAPTICUT_ERROR_INTERNAL, "An unknown exception was thrown.");
  }
}

void require_argument(const void* pointer, const char* name) {
  if (pointer == nullptr)
    throw Refusal(HAPTICUT_ERROR_ARGUMENT, std::string(name) + " is a null pointer; it must not be null.");
}

void copy_text(const std::string& text, char* to, std::size_t capacity) noexcept {
  copy(text.data(), text.size(), to, capacity);
}

}  // namespace hapticut::c
