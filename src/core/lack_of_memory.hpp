// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <new>
#include <string_view>
#include <system_error>

namespace hapticut {

/// Whether an exception says that memory was lacking, also for the stack of a thread: oneTBB, which OpenVDB uses, then
/// throws a std::runtime_error.
[[nodiscard]] inline bool is_lack_of_memory(const std::exception& error) noexcept {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  if (const auto* of_system = dynamic_cast<const std::system_error*>(&error))
    return of_system->code() == std::errc::resource_unavailable_try_again ||
           of_system->code() == std::errc::not_enough_memory;
  return std::string_view(error.what()).find("pthread_create has failed") != std::string_view::npos;
}

}  // namespace hapticut
