// SPDX-License-Identifier: Apache-2.0
#include "documentation.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hapticut::python {

namespace {

struct Entry {
  std::string_view key;
  const char* text;
};

constexpr Entry kEntries[] = {
#include "documentation.inc"
};

const char* find(std::string_view key) {
  const auto* entry = std::lower_bound(std::begin(kEntries), std::end(kEntries), key,
                                       [](const Entry& e, std::string_view wanted) { return e.key < wanted; });
  return entry != std::end(kEntries) && entry->key == key ? entry->text : nullptr;
}

}  // namespace

const char* doc(std::string_view key) {
  if (const char* text = find(key)) return text;
  throw std::logic_error("no header of hapticut documents " + std::string(key));
}

const char* doc_or_none(std::string_view key) {
  const char* text = find(key);
  return text != nullptr ? text : "";
}

}  // namespace hapticut::python
