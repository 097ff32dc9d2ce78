// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hapticut::apps {

/// A text table with two columns.
class Table {
 public:
  explicit Table(std::string title) : title_(std::move(title)) {}

  void add(std::string name, std::string value) { rows_.emplace_back(std::move(name), std::move(value)); }
  [[nodiscard]] std::string text() const;

 private:
  std::string title_;
  std::vector<std::pair<std::string, std::string>> rows_;
};

/// A number with `digits` significant digits, e.g. `12.3`; without an exponent if that is readable.
[[nodiscard]] std::string rounded(double value, int digits = 4);

/// `12.3 kB`, `4.5 MB`.
[[nodiscard]] std::string bytes(std::size_t count);

}  // namespace hapticut::apps
