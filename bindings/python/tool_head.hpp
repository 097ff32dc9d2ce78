// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "hapticut/tool/head.hpp"

namespace pybind11::detail {

/// Accepts a shape as a head, as in C++. pybind11's implicit conversions would lose the message when the shape is
/// invalid.
template <>
struct type_caster<hapticut::ToolHead> : type_caster_base<hapticut::ToolHead> {
#if PYBIND11_VERSION_HEX >= 0x03000000
  static constexpr auto name = io_name("ToolHead | SphereHead | ConeHead | FlatHead | ProfileHead", "ToolHead");
#endif

  bool load(handle given, bool convert) {
    return type_caster_base<hapticut::ToolHead>::load(given, convert) || make<hapticut::SphereHead>(given) ||
           make<hapticut::ConeHead>(given) || make<hapticut::FlatHead>(given) || make<hapticut::ProfileHead>(given);
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
