// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "hapticut/core/description.hpp"

namespace hapticut {

/// "SetScale" for `commands::SetScale`, for messages.
template <class Command>
constexpr std::string_view name_of_command() {
  constexpr std::string_view kScope = "commands::", kSelf = __PRETTY_FUNCTION__;  // ends: Command = commands::SetScale]
  constexpr std::size_t kBegin = kSelf.find(kScope) + kScope.size();
  return kSelf.substr(kBegin, kSelf.find_first_of("];", kBegin) - kBegin);
}

/// Checks the numbers of a command.
/// @throws Error naming the command's field, its value and the range of `fields_of`
template <Described Command>
void require_in_range(const Command& command) {
  require_fields_within(command, std::string(name_of_command<Command>()) + "::");
}

}  // namespace hapticut
