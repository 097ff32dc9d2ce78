// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/tool/catalogue.hpp"

namespace hapticut::test {

/// Made only when it is asked for, because that takes a while.
struct CatalogueHead {
  std::string name;
  std::function<ToolHead()> make;
};

inline void PrintTo(const CatalogueHead& named, std::ostream* out) { *out << named.name; }

/// One of each, of its usual dimensions; not the sphere, cone and flat head, which tests make by their constructors.
/// @throws Error naming a shape that lacks what each of the catalogue has
inline std::vector<CatalogueHead> catalogue_heads() {
  using enum HeadDimension;
  std::vector<CatalogueHead> heads;
  for (const HeadShape& shape : head_shapes()) {
    const std::string name = shape.name;
    if (name == "sphere" || name == "cone" || name == "flat") continue;
    if (shape.find(diameter) == nullptr && shape.find(tip_diameter) == nullptr)
      throw Error("the shape " + name + " has no diameter and no tip_diameter; see HeadShape.");
    heads.push_back({name, [&shape] { return shape.usual(); }});
  }
  return heads;
}

}  // namespace hapticut::test
