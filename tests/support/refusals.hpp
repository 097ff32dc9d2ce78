// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut::test {

/// What is said of a call that is refused; empty when it is not.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    (void)call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

/// Expects that a call is refused, and that the reason has this part.
template <class Call>
void expect_refusal(const Call& call, const std::string& part) {
  const std::string refusal = refusal_of(call);
  EXPECT_NE(refusal, "") << "instead of '" << part << "'";
  expect_part(refusal, part);
}

}  // namespace hapticut::test
