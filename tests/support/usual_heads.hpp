// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hapticut/tool/head.hpp"

namespace hapticut::test {

/// One head of each shape of ToolHead::Shape that has dimensions, except the shapes `Known`. Its lengths are `scale`
/// times the usual ones. A new shape is among them without a line.
template <class... Known>
std::vector<ToolHead> usual_heads(double scale = 1) {
  std::vector<ToolHead> heads;
  for_each_shape([&]<class Shape>(Of<Shape>) {
    if constexpr (Described<Shape> && !(std::is_same_v<Shape, Known> || ...)) {
      Shape shape = Shape::usual();
      for_each_number<Shape>([&]<class T>(const Field<Shape, T>& field) {
        if (field.unit == std::string_view("m")) shape.*field.member = T(shape.*field.member * scale);
      });
      heads.emplace_back(shape);
    }
  });
  return heads;
}

/// "sphere"
inline std::string word_of(const ToolHead& head) {
  return head.visit([]<class Shape>(const Shape&) { return std::string(Shape::kWord); });
}

}  // namespace hapticut::test
