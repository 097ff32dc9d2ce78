// SPDX-License-Identifier: Apache-2.0
#include "reports/table.hpp"

#include <algorithm>
#include <cstdio>

namespace hapticut::apps {

std::string Table::text() const {
  std::size_t width = 0;
  for (const auto& [name, value] : rows_) width = std::max(width, name.size());
  std::string text = title_ + '\n';
  for (const auto& [name, value] : rows_)
    text += "  " + name + std::string(width - name.size() + 2, ' ') + value + '\n';
  return text;
}

std::string rounded(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

std::string bytes(std::size_t count) {
  const double n = double(count);
  if (n < 1e3) return std::to_string(count) + " B";
  if (n < 1e6) return rounded(n / 1e3, 3) + " kB";
  return n < 1e9 ? rounded(n / 1e6, 3) + " MB" : rounded(n / 1e9, 3) + " GB";
}

}  // namespace hapticut::apps
