// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <concepts>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "documentation.hpp"
#include "hapticut/core/description.hpp"
#include "pickles.hpp"

/// @file
/// Binds plain structs. Every field is a keyword of the constructor with C++'s default, an attribute with the header's
/// comment, and part of the object's text and pickle. The fields come from the struct's description
/// (core/description.hpp) or from the call.
namespace hapticut::python {

namespace detail {

/// The comment of a field; `from_` in Python is `from` in C++.
inline const char* doc_of_field(const std::string& scope, std::string_view name) {
  while (name.ends_with('_')) name.remove_suffix(1);
  return doc_or_none(scope + "::" + std::string(name));
}
inline std::string doc_of_field(const std::string& text, const std::string& scope, std::string_view name) {
  return text.empty() ? doc_of_field(scope, name) : text;
}

/// The comment of a field, with shape and range behind its unit: "[m] (3,) from Ho to To".
template <class S, class T>
std::string doc_of_described(const hapticut::Field<S, T>& field, const std::string& scope) {
  std::string text = *field.unit != '\0' ? "[" + std::string(field.unit) + "]" : "";
  std::string comment = doc_of_field(scope, field.name);
  if (comment.empty()) comment = field.text;
  if (!text.empty() && comment.starts_with(text + " ")) comment.erase(0, text.size() + 1);
  const auto add = [&text](const std::string& words) {
    if (!text.empty() && !words.empty()) text += ' ';
    text += words;
  };
  if constexpr (std::is_same_v<T, Vec3>) add("(3,)");
  if constexpr (std::is_same_v<T, Pose>) add("(4, 4)");
  if constexpr (std::is_same_v<T, Twist>) add("(6,)");
  add(field.range.short_text());
  add(comment);
  return text;
}

/// "Name(first=1, second=2)".
template <class Names>
std::string text_of(py::handle self, const Names& names) {
  std::string fields;
  for (const char* name : names)
    fields += (fields.empty() ? "" : ", ") + std::string(name) + "=" + std::string(py::repr(self.attr(name)));
  return std::string(py::str(py::type::of(self).attr("__qualname__"))) + "(" + fields + ")";
}

}  // namespace detail

/// A field of struct S.
template <class S, class T, bool kRequired>
struct Field {
  using Value = T;
  static constexpr bool kIsRequired = kRequired;
  const char* name;
  T S::*member;
  std::string text = {};  ///< empty: the comment of the header

  [[nodiscard]] const T& get(const S& s) const { return s.*member; }
  void set(S& s, T value) const { s.*member = std::move(value); }
  [[nodiscard]] auto argument(const S& defaults) const {
    if constexpr (kRequired) {
      return py::arg(name);
    } else {
      return py::arg(name) = defaults.*member;
    }
  }
  void define(py::class_<S>& binding, const std::string& scope) const {
    binding.def_readwrite(name, member, detail::doc_of_field(text, scope, name).c_str());
  }
};

template <class S, class T>
Field<S, T, false> field(const char* name, T S::*member) {
  return {name, member, {}};
}

/// A field that is a required argument of the constructor.
template <class S, class T>
Field<S, T, true> required(const char* name, T S::*member) {
  return {name, member, {}};
}

/// A field with another type in Python.
template <class S, class T, class Get, class Set>
struct ComputedField {
  using Value = T;
  static constexpr bool kIsRequired = false;
  const char* name;
  Get getter;
  Set setter;
  std::string text = {};  ///< empty: the comment of the header

  [[nodiscard]] T get(const S& s) const { return getter(s); }
  void set(S& s, T value) const { setter(s, std::move(value)); }
  [[nodiscard]] auto argument(const S& defaults) const { return py::arg(name) = getter(defaults); }
  void define(py::class_<S>& binding, const std::string& scope) const {
    binding.def_property(name, getter, setter, detail::doc_of_field(text, scope, name).c_str());
  }
};

template <class S, class T, class Get, class Set>
ComputedField<S, T, Get, Set> computed(const char* name, Get getter, Set setter, std::string text = {}) {
  return {name, getter, setter, std::move(text)};
}

/// A bit enumeration, which is a whole number in Python.
template <class T>
concept Bits = std::is_enum_v<T> && requires(T bits) {
  { bits | bits } -> std::same_as<T>;
};

/// Whether the numbers of a struct are required arguments; specialise it next to the binding.
template <class S>
inline constexpr bool kNumbersAreRequired = false;

/// The Python type `Type` for a C++ type, with both conversions. Specialise it.
template <class T>
struct InPython {};

template <Bits T>
struct InPython<T> {
  using Type = std::uint32_t;
  static Type there(const T& bits) { return Type(bits); }
  static T back(Type number) { return T(number); }
};

/// A null pointer becomes None.
template <class T>
struct InPython<std::shared_ptr<const T>> {
  using Type = std::optional<std::shared_ptr<T>>;
  static Type there(const std::shared_ptr<const T>& object) {
    return object ? Type(std::const_pointer_cast<T>(object)) : std::nullopt;
  }
  static std::shared_ptr<const T> back(const Type& given) { return given.value_or(nullptr); }
};

/// A non-owned name; names from Python live as long as the program.
template <>
struct InPython<std::string_view> {
  using Type = std::string;
  static Type there(std::string_view name) { return std::string(name); }
  static std::string_view back(const Type& given) {
    static std::set<std::string> names;
    return *names.insert(given).first;
  }
};

namespace detail {

/// A field in its Python form.
template <class S, class T>
auto in_python(const hapticut::Field<S, T>& field, const std::string& scope) {
  std::string text = doc_of_described(field, scope);
  if constexpr (requires { typename InPython<T>::Type; }) {
    using Type = typename InPython<T>::Type;
    const auto member = field.member;
    return computed<S, Type>(
        field.name, [member](const S& s) { return InPython<T>::there(s.*member); },
        [member](S& s, const Type& given) { s.*member = InPython<T>::back(given); }, std::move(text));
  } else {
    constexpr bool kRequired = kNumbersAreRequired<S> && std::is_same_v<T, double>;
    return Field<S, T, kRequired>{field.name, field.member, std::move(text)};
  }
}

/// Number of positional arguments: all fields of a small struct; of a larger one the required fields, at least one.
template <class... Fields>
constexpr std::size_t positional_fields() {
  constexpr std::size_t kFew = 4;
  if (sizeof...(Fields) <= kFew) return sizeof...(Fields);
  std::size_t must = 0;
  ((must += Fields::kIsRequired ? 1 : 0), ...);
  return must > 0 ? must : 1;
}

template <class S, class... Fields, std::size_t... kFirst, std::size_t... kRest>
void define_constructor(py::class_<S>& binding, const std::tuple<Fields...>& fields, std::index_sequence<kFirst...>,
                        std::index_sequence<kRest...>) {
  const S defaults{};
  const auto construct = [fields](typename Fields::Value... values) {
    S s{};
    std::apply([&](const auto&... field) { (field.set(s, std::move(values)), ...); }, fields);
    return s;
  };
  if constexpr (sizeof...(kRest) == 0) {
    binding.def(py::init(construct), std::get<kFirst>(fields).argument(defaults)...);
  } else {
    binding.def(py::init(construct), std::get<kFirst>(fields).argument(defaults)..., py::kw_only(),
                std::get<sizeof...(kFirst) + kRest>(fields).argument(defaults)...);
  }
}

}  // namespace detail

/// Binds a struct.
/// @param name   in Python
/// @param scope  its name in C++, within namespace hapticut
template <class S, class... Fields>
py::class_<S> bind_struct(py::handle parent, const char* name, const char* scope, Fields... fields) {
  py::class_<S> binding(parent, name, doc_or_none(scope));
  const std::tuple<Fields...> all(fields...);
  constexpr std::size_t kFirst = detail::positional_fields<Fields...>();
  detail::define_constructor(binding, all, std::make_index_sequence<kFirst>(),
                             std::make_index_sequence<sizeof...(Fields) - kFirst>());
  (fields.define(binding, scope), ...);
  const std::array<const char*, sizeof...(Fields)> names = {fields.name...};
  binding.def("__repr__", [names](py::handle self) { return detail::text_of(self, names); });
  const auto copy = [](const S& s) { return S(s); };
  binding.def("__copy__", copy);
  binding.def(
      "__deepcopy__", [](const S& s, const py::dict&) { return S(s); }, py::arg("memo"));
  binding.def(py::pickle(
      [all](const py::object& self) -> py::tuple {
        return std::apply([&](const auto&... field) { return py::make_tuple(py::object(self.attr(field.name))...); },
                          all);
      },
      [all](const py::tuple& values) {
        S s{};
        std::apply(
            [&](const auto&... field) {
              std::size_t i = 0;
              (field.set(s, values[i++].template cast<typename Fields::Value>()), ...);
            },
            all);
        return s;
      }));
  return binding;
}

template <class S, class... Fields>
py::class_<S> bind_struct(py::handle parent, const char* name, Fields... fields) {
  return bind_struct<S>(parent, name, name, fields...);
}

/// Binds a described struct with all its fields.
/// @param scope  its name in C++ within namespace hapticut, if different from Python
template <Described S>
py::class_<S> bind_described(py::handle parent, const char* name, const char* scope = nullptr) {
  const char* in_cpp = scope != nullptr ? scope : name;
  return std::apply(
      [&](const auto&... fields) { return bind_struct<S>(parent, name, in_cpp, detail::in_python(fields, in_cpp)...); },
      fields_of(Of<S>{}));
}

template <class S, class T>
std::pair<const char*, T S::*> member(const char* name, T S::*pointer) {
  return {name, pointer};
}

/// Binds some members of a read-only struct.
template <class S, class... Members>
py::class_<S> bind_part_of_result(py::handle parent, const char* name,
                                  std::pair<const char*, Members S::*>... members) {
  py::class_<S> binding(parent, name, doc(name));
  (binding.def_property_readonly(
       members.first, [member = members.second](const S& s) -> const Members& { return s.*member; },
       py::return_value_policy::copy, doc_or_none(std::string(name) + "::" + members.first)),
   ...);
  const std::array<const char*, sizeof...(Members)> names = {members.first...};
  binding.def("__repr__", [names](py::handle self) { return detail::text_of(self, names); });
  return binding;
}

/// Binds a read-only struct with all its members, e.g. the result of a call.
template <class S, class... Members>
py::class_<S> bind_result(py::handle parent, const char* name, std::pair<const char*, Members S::*>... members) {
  py::class_<S> binding = bind_part_of_result<S>(parent, name, members...);
  pickled_by_members(binding, members.second...);
  return binding;
}

/// Binds a described, read-only struct.
template <Described S>
py::class_<S> bind_described_result(py::handle parent, const char* name) {
  py::class_<S> binding(parent, name, doc(name));
  std::vector<const char*> names;
  for_each_field<S>([&](const auto& field) {
    using T = typename std::remove_cvref_t<decltype(field)>::Type;
    const std::string text = detail::doc_of_described(field, name);
    if constexpr (Bits<T>)
      binding.def_property_readonly(
          field.name, [member = field.member](const S& s) { return std::uint32_t(s.*member); }, text.c_str());
    else
      binding.def_property_readonly(
          field.name, [member = field.member](const S& s) -> const T& { return s.*member; },
          py::return_value_policy::copy, text.c_str());
    names.push_back(field.name);
  });
  binding.def("__repr__", [names](py::handle self) { return detail::text_of(self, names); });
  std::apply([&](const auto&... fields) { pickled_by_members(binding, fields.member...); }, fields_of(Of<S>{}));
  return binding;
}

/// Binds a named enumeration; the docstrings of its values are the comments of the header.
/// @param scope  its name in C++ within namespace hapticut, if different from Python
template <NamedEnum E>
py::enum_<E> bind_enum(py::handle parent, const char* name, const char* scope = nullptr) {
  const std::string in_cpp = scope != nullptr ? scope : name;
  py::enum_<E> binding(parent, name, doc_or_none(in_cpp));
  for (const Named<E>& one : names_of(Of<E>{}))
    binding.value(one.name, one.value, doc_or_none(in_cpp + "::" + one.name));
  return binding;
}

/// Binds a bit enumeration. `a | b` and `a & b` give whole numbers, also with a number as operand; with an array they
/// give arrays.
template <NamedEnum E>
void bind_bits(py::handle parent, const char* name) {
  py::enum_<E> binding = bind_enum<E>(parent, name);
  binding.attr("__array_ufunc__") = py::none();  // arrays then use the operators below
  const auto define = [&binding](const char* left, const char* right, const char* operation) {
    const auto apply = [operation](E bits, const py::object& other) -> py::object {
      const py::object number = py::isinstance<E>(other) ? py::object(py::int_(other)) : other;
      return number.attr(operation)(py::int_(std::uint32_t(bits)));
    };
    binding.def(left, apply, py::arg("other")).def(right, apply, py::arg("other"));
  };
  define("__and__", "__rand__", "__and__");
  define("__or__", "__ror__", "__or__");
  define("__xor__", "__rxor__", "__xor__");
}

}  // namespace hapticut::python
