// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <variant>

#include "hapticut/tool/head.hpp"

namespace pybind11::detail {

/// The name of a head that is given or returned, as pybind11's io_name: "ToolHead | SphereHead | ...", "ToolHead".
template <class... Shapes>
constexpr auto accepted_heads(std::variant<Shapes...>* /*type*/) {
  return const_name("@ToolHead") + (... + (const_name(" | ") + const_name(Shapes::kName))) + const_name("@ToolHead@");
}

/// Accepts a shape as a head, as in C++. pybind11's implicit conversions would lose the message when the shape is
/// invalid.
template <>
struct type_caster<hapticut::ToolHead> : type_caster_base<hapticut::ToolHead> {
#if PYBIND11_VERSION_HEX >= 0x03000000
  static constexpr auto name = accepted_heads(static_cast<hapticut::ToolHead::Shape*>(nullptr));
#endif

  bool load(handle given, bool convert) {
    bool loaded = type_caster_base<hapticut::ToolHead>::load(given, convert);
    hapticut::for_each_shape([&]<class Shape>(hapticut::Of<Shape>) { loaded = loaded || make<Shape>(given); });
    return loaded;
  }

 private:
  template <class Shape>
  bool make(handle given) {
    if (!isinstance<Shape>(given)) return false;
    made_.emplace(hapticut::ToolHead::Shape(given.cast<const Shape&>()));
    value = &*made_;
    return true;
  }

  std::optional<hapticut::ToolHead> made_;
};

}  // namespace pybind11::detail
