// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace hapticut::test {

/// Path of a real input file, whether it exists or not.
inline std::filesystem::path data_path(const std::string& name) {
  return std::filesystem::path(HAPTICUT_TEST_DATA) / name;
}

}  // namespace hapticut::test

/// Skips the test, saying which file is missing, when a real input is not on this machine.
#define HAPTICUT_NEEDS_DATA(name)                                  \
  if (!std::filesystem::exists(::hapticut::test::data_path(name))) \
  GTEST_SKIP() << "needs the real input file " << name << ", which is not on this machine"
