// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "hapticut/tool/catalogue.hpp"

namespace hapticut::test {

/// Made only when it is asked for, because that takes a while.
struct CatalogueHead {
  std::string name;
  std::function<ToolHead()> make;
};

inline void PrintTo(const CatalogueHead& named, std::ostream* out) { *out << named.name; }

/// One of each, of its usual dimensions.
inline std::vector<CatalogueHead> catalogue_heads() {
  std::vector<CatalogueHead> heads;
  for (const HeadShape& shape : head_shapes())
    if (shape.find(HeadDimension::diameter) != nullptr || shape.find(HeadDimension::tip_diameter) != nullptr)
      heads.push_back({shape.name, [&shape] { return shape.usual(); }});
  return heads;
}

}  // namespace hapticut::test
