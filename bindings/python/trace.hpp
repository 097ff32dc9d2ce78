// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <cstring>

#include "arrays.hpp"
#include "hapticut/simulation/step.hpp"
#include "structs.hpp"

/// @file
/// Rows of structured arrays, e.g. from Simulation.run: `time` and the described fields of StepResult. For the removed
/// voxels, a row has only their number.
namespace hapticut::python {

namespace detail {

/// (name, type[, shape]) of each field of a struct, for numpy.dtype.
template <class S>
py::list row_fields();

template <class T>
py::tuple row_field(const char* name) {
  if constexpr (Described<T>) {
    return py::make_tuple(name, row_fields<T>());
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return py::make_tuple(name, "f8", py::make_tuple(3));
  } else if constexpr (std::is_same_v<T, Pose>) {
    return py::make_tuple(name, "f8", py::make_tuple(4, 4));
  } else if constexpr (std::is_same_v<T, Twist>) {
    return py::make_tuple(name, "f8", py::make_tuple(6));
  } else if constexpr (std::is_same_v<T, Wrench>) {
    py::list parts;
    parts.append(row_field<Vec3>("force"));
    parts.append(row_field<Vec3>("torque"));
    return py::make_tuple(name, parts);
  } else if constexpr (std::is_same_v<T, double>) {
    return py::make_tuple(name, "f8");
  } else if constexpr (Bits<T>) {
    return py::make_tuple(name, "u4");
  } else {
    static_assert(std::is_same_v<T, int> || std::is_same_v<T, std::span<const RemovedVoxel>>);
    return py::make_tuple(name, "i8");
  }
}

template <class S>
py::list row_fields() {
  py::list fields;
  for_each_field<S>([&](const auto& field) {
    fields.append(row_field<typename std::remove_cvref_t<decltype(field)>::Type>(field.name));
  });
  return fields;
}

/// Writes the fields in order, without gaps.
template <class T>
void put(std::byte*& at, const T& value) noexcept {
  const auto copy = [&at](const auto& number) {
    std::memcpy(at, &number, sizeof number);
    at += sizeof number;
  };
  if constexpr (Described<T>) {
    for_each_field<T>([&](const auto& field) { put(at, value.*field.member); });
  } else if constexpr (std::is_same_v<T, Vec3>) {
    for (const double number : value) copy(number);
  } else if constexpr (std::is_same_v<T, Pose>) {
    double matrix[16];
    write_pose(value, matrix);
    copy(matrix);
  } else if constexpr (std::is_same_v<T, Twist>) {
    put(at, value.linear);
    put(at, value.angular);
  } else if constexpr (std::is_same_v<T, Wrench>) {
    put(at, value.force);
    put(at, value.torque);
  } else if constexpr (std::is_same_v<T, double>) {
    copy(value);
  } else if constexpr (Bits<T>) {
    copy(std::uint32_t(value));
  } else if constexpr (std::is_same_v<T, int>) {
    copy(std::int64_t(value));
  } else {
    copy(std::int64_t(value.size()));
  }
}

}  // namespace detail

/// The type of a row. NumPy pads the row if its last number has half the width of the others.
inline py::dtype row_type(const py::list& fields) {
  return py::dtype::from_args(py::module_::import("numpy").attr("dtype")(fields, py::arg("align") = true));
}

/// The type of a row of Simulation.run.
inline py::dtype trace_type() {
  py::list fields;
  fields.append(detail::row_field<double>("time"));
  for (const py::handle field : detail::row_fields<StepResult>()) fields.append(field);
  return row_type(fields);
}

/// Rows of zeros.
inline py::array empty_rows(const py::dtype& type, std::size_t count) {
  py::array rows(type, py::ssize_t(count));
  std::memset(rows.mutable_data(), 0, std::size_t(rows.nbytes()));
  return rows;
}

/// @param time  [s] at the end of the step, since the run began
/// @param row   [bytes of trace_type], all zero
inline void write_trace_row(const StepResult& result, double time, std::byte* row) noexcept {
  detail::put(row, time);
  detail::put(row, result);
}

}  // namespace hapticut::python
