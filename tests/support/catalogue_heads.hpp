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

/// One of each, of common dimensions.
inline std::vector<CatalogueHead> catalogue_heads() {
  using units::mm;
  return {{"round", [] { return round_head(1.4 * mm); }},
          {"inverted_cone", [] { return inverted_cone_head(1.4 * mm, 0.9 * mm, 1.2 * mm); }},
          {"cylinder", [] { return cylinder_head(1.2 * mm, 4 * mm); }},
          {"round_end_cylinder", [] { return round_end_cylinder_head(1.2 * mm, 4 * mm); }},
          {"tapered", [] { return tapered_head(0.9 * mm, 1.6 * mm, 4 * mm); }},
          {"round_end_tapered", [] { return round_end_tapered_head(0.8 * mm, 1.6 * mm, 4 * mm); }},
          {"needle", [] { return needle_head(1.2 * mm, 5 * mm); }},
          {"flame", [] { return flame_head(1.4 * mm, 4 * mm, 0.9 * mm, 2 * mm); }},
          {"pear", [] { return pear_head(1.4 * mm, 2.6 * mm, 0.8 * mm); }},
          {"wheel", [] { return wheel_head(4 * mm, 0.8 * mm, 1.4 * mm); }},
          {"christmas_tree", [] { return christmas_tree_head(2 * mm, 3 * mm, 3); }},
          {"twist_drill", [] { return twist_drill_head(2 * mm, 5 * mm); }}};
}

}  // namespace hapticut::test
