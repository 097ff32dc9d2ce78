// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hapticut/core/errors.hpp"

/// @file
/// Makes classes that are no plain structs copy and pickle.
namespace hapticut::python {

namespace py = pybind11;

namespace detail {

/// @throws Error unless a pickled state has as many items as this version writes
inline void require_items(const py::tuple& state, std::size_t count, const char* what) {
  if (state.size() != count)
    throw Error(std::string(what) +
                " was pickled by another version of hapticut; pickle it again with this version, or keep workpieces as "
                ".vdb files and runs as recordings.");
}

/// The values of attributes. Their names would otherwise have types of C++ in the signature.
inline py::tuple attributes_of(const py::object& self, const std::vector<const char*>& names) {
  py::list values;
  for (const char* name : names) values.append(self.attr(name));
  return py::tuple(values);
}

}  // namespace detail

/// A class whose objects are made again from the attributes that its constructor takes, in their order.
template <class Binding>
void pickled_by_constructor(Binding& binding, std::initializer_list<const char*> attributes) {
  const std::vector<const char*> names(attributes);
  binding.def("__reduce__", [names](const py::object& self) {
    return py::make_tuple(py::type::of(self), detail::attributes_of(self, names));
  });
}

/// A class without a constructor in Python, whose objects are the values of these members.
template <class S, class... Members>
void pickled_by_members(py::class_<S>& binding, Members S::*... members) {
  const auto copy = [](const S& s) { return S(s); };
  binding.def("__copy__", copy);
  binding.def(
      "__deepcopy__", [](const S& s, const py::dict&) { return S(s); }, py::arg("memo"));
  binding.def(py::pickle([members...](const S& s) { return py::make_tuple(s.*members...); },
                         [members...](const py::tuple& state) {
                           detail::require_items(state, sizeof...(Members), "the object");
                           S s{};
                           std::size_t i = 0;
                           ((s.*members = state[i++].template cast<Members>()), ...);
                           return s;
                         }));
}

/// A class of numbers without pointers, as bytes for the same version of the library.
template <class S>
void pickled_by_bytes(py::class_<S>& binding) {
  static_assert(std::is_trivially_copyable_v<S>);
  binding.def(
      py::pickle([](const S& s) { return py::make_tuple(py::bytes(reinterpret_cast<const char*>(&s), sizeof s)); },
                 [](const py::tuple& state) {
                   detail::require_items(state, 1, "the object");
                   const std::string bytes = state[0].cast<std::string>();
                   detail::require_items(state, bytes.size() == sizeof(S) ? 1 : 0, "the object");
                   alignas(S) std::byte copy[sizeof(S)];
                   std::memcpy(copy, bytes.data(), sizeof(S));
                   return S(*reinterpret_cast<const S*>(copy));
                 }));
}

}  // namespace hapticut::python
