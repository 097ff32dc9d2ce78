// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "hapticut/core/errors.hpp"
#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"
#include "hapticut/force/contact_stiffness.hpp"

/// @file
/// Conversion of vectors, rotations, poses, twists and lists of points between C++ and NumPy.
///
/// An array must be float64 and contiguous in C order. Anything else is refused with a message, so no number changes
/// and no large array is copied silently. Where only a few numbers are needed, lists, tuples and arrays of whole
/// numbers are accepted too.
namespace hapticut::python {

namespace py = pybind11;

/// Declares an argument type that is checked manually, so the message can name the argument.
/// @param Type  its type for type checkers
#define HAPTICUT_NAMED_ARGUMENT(Name, Type)                                 \
  class Name : public pybind11::object {                                    \
   public:                                                                  \
    static constexpr auto kPythonType = pybind11::detail::const_name(Type); \
    PYBIND11_OBJECT_DEFAULT(Name, object, accept)                           \
                                                                            \
   private:                                                                 \
    static bool accept(PyObject*) { return true; }                          \
  }
HAPTICUT_NAMED_ARGUMENT(FewNumbers, "numpy.typing.ArrayLike");                 ///< float64 array or list of numbers
HAPTICUT_NAMED_ARGUMENT(Float64Array, "numpy.typing.NDArray[numpy.float64]");  ///< only a float64 array
HAPTICUT_NAMED_ARGUMENT(Durations, "float | numpy.typing.NDArray[numpy.float64]");  ///< a number or a float64 array
HAPTICUT_NAMED_ARGUMENT(RealArray, "numpy.typing.NDArray[typing.Any]");  ///< array of real numbers of any type

/// "array of shape (3, 4) and dtype float32"; for other objects their type.
[[nodiscard]] std::string describe_given(py::handle given);

/// "(n, 4, 4)"; -1 stands for n.
[[nodiscard]] std::string describe_shape(std::span<const py::ssize_t> shape);

/// The numbers of an array of exactly this shape (-1: any length).
/// @param what  beginning of messages, e.g. "poses"
/// @throws Error that names the given and the required array
[[nodiscard]] std::span<const double> numbers_of(py::handle given, const char* what,
                                                 std::initializer_list<py::ssize_t> shape);

/// Copies a few numbers out of an array, a list or a tuple.
/// @return false for any other object, so another overload can accept it
/// @throws Error when shape or type is wrong
bool read_numbers(py::handle given, const char* what, std::initializer_list<py::ssize_t> shape, double* numbers);

/// A homogeneous matrix as a pose.
/// @param matrix  [16] in rows
/// @throws Error when its last row is not 0 0 0 1
[[nodiscard]] Pose pose_from(const double* matrix, const char* what);

/// Writes a pose as a homogeneous matrix.
/// @param matrix  [16] in rows
void write_pose(const Pose& pose, double* matrix);

/// A read-only view of memory that `owner` keeps alive.
[[nodiscard]] py::array view(const py::dtype& type, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                             const void* data, py::handle owner);

/// (n, 3) float64 view of the vectors.
[[nodiscard]] py::array view_of(std::span<const Vec3> points, py::handle owner);

}  // namespace hapticut::python

#if PYBIND11_VERSION_HEX >= 0x03000000
#define HAPTICUT_ARRAY_NAME pybind11::detail::io_name("numpy.typing.ArrayLike", "numpy.typing.NDArray[numpy.float64]")
#else
#define HAPTICUT_ARRAY_NAME pybind11::detail::const_name("numpy.typing.NDArray[numpy.float64]")
#endif

namespace pybind11::detail {

template <class Argument>
requires requires { Argument::kPythonType; }
struct handle_type_name<Argument> {
  static constexpr auto name = Argument::kPythonType;
};

/// A speed in rad/s. Whole numbers other than 0 are refused, because they are probably rpm.
template <>
struct type_caster<hapticut::AngularSpeed> {
  PYBIND11_TYPE_CASTER(hapticut::AngularSpeed, const_name("float"));
  bool load(handle given, bool) {
    make_caster<double> number;
    if (!number.load(given, true)) return false;
    const double speed = cast_op<double>(number);
    const bool is_whole = isinstance<int_>(given) || isinstance(given, module_::import("numpy").attr("integer"));
    if (is_whole && speed != 0)
      throw hapticut::Error("a speed of " + std::string(str(given)) +
                            " is a whole number, so probably in rpm, but speeds are in rad/s: write " +
                            std::string(str(given)) + " * hapticut.units.rpm, or " + std::string(str(given)) +
                            " * hapticut.units.rad_per_s.");
    value = hapticut::AngularSpeed::in_rad_per_s(speed);
    return true;
  }
  static handle cast(hapticut::AngularSpeed speed, return_value_policy, handle) { return float_(speed).release(); }
};

template <>
struct type_caster<hapticut::Vec3> {
  PYBIND11_TYPE_CASTER(hapticut::Vec3, HAPTICUT_ARRAY_NAME);
  bool load(handle given, bool) { return hapticut::python::read_numbers(given, "a vector", {3}, value.data()); }
  static handle cast(const hapticut::Vec3& v, return_value_policy, handle) {
    return array_t<double>(3, v.data()).release();
  }
};

template <>
struct type_caster<hapticut::Mat3> {
  PYBIND11_TYPE_CASTER(hapticut::Mat3, HAPTICUT_ARRAY_NAME);
  bool load(handle given, bool) {
    if (!hapticut::python::read_numbers(given, "a rotation", {3, 3}, value.data())) return false;
    value.transposeInPlace();  // NumPy stores rows, Eigen columns
    return true;
  }
  static handle cast(const hapticut::Mat3& m, return_value_policy, handle) {
    const hapticut::Mat3 rows = m.transpose();
    return array_t<double>({3, 3}, rows.data()).release();
  }
};

template <>
struct type_caster<hapticut::Stiffness> {
  PYBIND11_TYPE_CASTER(hapticut::Stiffness, HAPTICUT_ARRAY_NAME);
  bool load(handle given, bool) {
    if (!hapticut::python::read_numbers(given, "a stiffness", {6, 6}, value.data())) return false;
    value.transposeInPlace();  // NumPy stores rows, Eigen columns
    return true;
  }
  static handle cast(const hapticut::Stiffness& stiffness, return_value_policy, handle) {
    const hapticut::Stiffness rows = stiffness.transpose();
    return array_t<double>({6, 6}, rows.data()).release();
  }
};

template <>
struct type_caster<hapticut::Pose> {
  PYBIND11_TYPE_CASTER(hapticut::Pose, HAPTICUT_ARRAY_NAME);
  bool load(handle given, bool) {
    std::array<double, 16> matrix;
    if (!hapticut::python::read_numbers(given, "a pose", {4, 4}, matrix.data())) return false;
    value = hapticut::python::pose_from(matrix.data(), "a pose");
    return true;
  }
  static handle cast(const hapticut::Pose& pose, return_value_policy, handle) {
    array_t<double> matrix({4, 4});
    hapticut::python::write_pose(pose, matrix.mutable_data());
    return matrix.release();
  }
};

template <>
struct type_caster<hapticut::Twist> {
  PYBIND11_TYPE_CASTER(hapticut::Twist, HAPTICUT_ARRAY_NAME);
  bool load(handle given, bool) {
    std::array<double, 6> numbers;
    if (!hapticut::python::read_numbers(given, "a twist", {6}, numbers.data())) return false;
    value = {hapticut::Vec3(numbers.data()), hapticut::Vec3(numbers.data() + 3)};
    return true;
  }
  static handle cast(const hapticut::Twist& twist, return_value_policy, handle) {
    array_t<double> numbers(6);
    for (int i = 0; i < 3; ++i) {
      numbers.mutable_at(i) = twist.linear[i];
      numbers.mutable_at(i + 3) = twist.angular[i];
    }
    return numbers.release();
  }
};

}  // namespace pybind11::detail
