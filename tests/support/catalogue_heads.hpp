// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "hapticut/tool/catalogue.hpp"

namespace hapticut::test {

struct CatalogueHead {
  std::string name;
  ToolHead head;
};

inline void PrintTo(const CatalogueHead& named, std::ostream* out) { *out << named.name; }

/// One of each, of common dimensions.
inline std::vector<CatalogueHead> catalogue_heads() {
  using units::mm;
  return {{"round", round_head(1.4 * mm)},
          {"inverted_cone", inverted_cone_head(1.4 * mm, 0.9 * mm, 1.2 * mm)},
          {"cylinder", cylinder_head(1.2 * mm, 4 * mm)},
          {"round_end_cylinder", round_end_cylinder_head(1.2 * mm, 4 * mm)},
          {"tapered", tapered_head(0.9 * mm, 1.6 * mm, 4 * mm)},
          {"round_end_tapered", round_end_tapered_head(0.8 * mm, 1.6 * mm, 4 * mm)},
          {"needle", needle_head(1.2 * mm, 5 * mm)},
          {"flame", flame_head(1.4 * mm, 4 * mm, 0.9 * mm, 2 * mm)},
          {"pear", pear_head(1.4 * mm, 2.6 * mm, 0.8 * mm)},
          {"wheel", wheel_head(4 * mm, 0.8 * mm, 1.4 * mm)},
          {"christmas_tree", christmas_tree_head(2 * mm, 3 * mm, 3)},
          {"twist_drill", twist_drill_head(2 * mm, 5 * mm)}};
}

}  // namespace hapticut::test
