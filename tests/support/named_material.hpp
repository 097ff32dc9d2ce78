// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/workpiece/material.hpp"

namespace hapticut::test {

/// A material with a name and default constants.
[[nodiscard]] inline Material named(const std::string& name) {
  Material material;
  material.name = name;
  return material;
}

}  // namespace hapticut::test
