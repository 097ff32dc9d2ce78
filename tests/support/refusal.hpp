// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "hapticut/core/errors.hpp"

/// @file
/// Messages of refused actions.
namespace hapticut::test {

/// The error message of a refused action; empty if the action is not refused.
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

inline void expect_part(const std::string& text, const std::string& part) {
  EXPECT_TRUE(contains(text, part)) << "'" << text << "' lacks '" << part << "'";
}

/// Expects that an action is refused with a message that contains all of these words.
template <class Action>
void expect_refused(const Action& action, std::initializer_list<std::string> words) {
  const std::string said = refusal(action);
  EXPECT_NE(said, "") << "it is not refused";
  for (const std::string& word : words) expect_part(said, word);
}

template <class Action>
void expect_refused(const Action& action, const std::string& words) {
  expect_refused(action, {words});
}

}  // namespace hapticut::test
