// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "hapticut/core/errors.hpp"

/// @file
/// What the library says when it refuses something.
namespace hapticut::test {

/// The sentence that an action is refused with; empty: it is not refused.
template <class Action>
std::string refusal(const Action& action) {
  try {
    (void)action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Expects that an action is refused in a sentence with all of these words.
template <class Action>
void expect_refused(const Action& action, std::initializer_list<const char*> words) {
  const std::string said = refusal(action);
  EXPECT_NE(said, "") << "it is not refused";
  for (const char* word : words) EXPECT_TRUE(contains(said, word)) << "'" << said << "' lacks '" << word << "'";
}

}  // namespace hapticut::test
