// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hapticut/core/errors.hpp"

namespace hapticut::apps {

/// @param component  missing component: "io"
/// @param what       what cannot be done: "'a.h5' cannot be read"
/// @throws Error that says how to build the component
[[noreturn]] inline void fail_without(const std::string& component, const std::string& what) {
  std::string option = "HAPTICUT_WITH_";
  for (const char letter : component) option += char(letter - 'a' + 'A');
  throw Error(what + ", because this program was built without its " + component + " component. Build it with " +
              option + "=ON.");
}

}  // namespace hapticut::apps
