// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace hapticut {

/// Calls a function at the end of its scope, even if an exception ends it.
template <class Function>
class AtEnd {
 public:
  explicit AtEnd(Function function) : function_(std::move(function)) {}
  ~AtEnd() { function_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  Function function_;
};

}  // namespace hapticut
