// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include "hapticut/workpiece/material_set.hpp"

namespace pybind11::detail {

/// A set of materials is a set of their ids in Python.
template <>
struct type_caster<hapticut::MaterialSet> {
  PYBIND11_TYPE_CASTER(hapticut::MaterialSet, const_name("set[int]"));
  bool load(handle, bool) { return false; }  // Python only reads such sets
  static handle cast(const hapticut::MaterialSet& materials, return_value_policy, handle) {
    set ids;
    materials.for_each([&](hapticut::MaterialId id) { ids.add(int_(int(id))); });
    return ids.release();
  }
};

}  // namespace pybind11::detail
