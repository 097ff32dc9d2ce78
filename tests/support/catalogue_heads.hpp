// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "hapticut/tool/catalogue.hpp"

namespace hapticut::test {

/// Made only on request, because it takes a while.
struct CatalogueHead {
  std::string name;
  std::function<ToolHead()> make;
};

inline void PrintTo(const CatalogueHead& named, std::ostream* out) { *out << named.name; }

/// One head of each shape with its usual dimensions; not of ToolHead::Shape, which tests construct directly.
inline std::vector<CatalogueHead> catalogue_heads() {
  std::vector<CatalogueHead> heads;
  for (const HeadShape& shape : head_shapes()) {
    const std::string name = shape.name;
    bool is_shape = false;
    for_each_shape([&]<class Shape>(Of<Shape>) { is_shape = is_shape || name == Shape::kWord; });
    if (is_shape) continue;
    heads.push_back({name, [&shape] { return shape.usual(); }});
  }
  return heads;
}

}  // namespace hapticut::test
