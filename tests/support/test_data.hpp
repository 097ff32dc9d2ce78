// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "support/places.hpp"

/// Skips the test, saying which file is missing, when a real input is not on this machine.
#define HAPTICUT_NEEDS_DATA(name)                                  \
  if (!std::filesystem::exists(::hapticut::test::data_path(name))) \
  GTEST_SKIP() << "needs the real input file " << name << ", which is not on this machine"
