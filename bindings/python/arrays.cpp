// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "hapticut/core/errors.hpp"

namespace hapticut::python {

std::string describe_given(py::handle given) {
  if (py::isinstance<py::array>(given)) {
    const auto array = py::reinterpret_borrow<py::array>(given);
    return "an array of shape " + std::string(py::str(array.attr("shape"))) + " and dtype " +
           std::string(py::str(array.dtype())) + (array.flags() & py::array::c_style ? "" : ", not in C order");
  }
  return "an object of type " + std::string(py::str(py::type::of(given).attr("__name__")));
}

std::string describe_shape(std::span<const py::ssize_t> shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += (i > 0 ? ", " : "") + (shape[i] < 0 ? std::string("n") : std::to_string(shape[i]));
  return text + (shape.size() == 1 ? ",)" : ")");
}

namespace {

bool has_shape(const py::array& array, std::span<const py::ssize_t> shape) {
  if (array.ndim() != py::ssize_t(shape.size())) return false;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (shape[i] >= 0 && array.shape(py::ssize_t(i)) != shape[i]) return false;
  return true;
}

/// The numbers of an object as a new array; nothing when it contains no numbers. None is no number.
/// @throws error_already_set for any other error, such as KeyboardInterrupt
std::optional<py::array_t<double>> converted(py::handle given) {
  try {
    py::array_t<double, py::array::c_style | py::array::forcecast> array(py::reinterpret_borrow<py::object>(given));
    const auto is_nan = [](double number) { return std::isnan(number); };
    if (std::any_of(array.data(), array.data() + array.size(), is_nan)) {
      const py::object objects = py::module_::import("numpy").attr("array")(given, py::str("object")).attr("ravel")();
      for (const py::handle object : objects)
        if (object.is_none()) return std::nullopt;
    }
    return array;
  } catch (const py::error_already_set& error) {
    for (PyObject* wrong : {PyExc_TypeError, PyExc_ValueError, PyExc_OverflowError})
      if (error.matches(wrong)) return std::nullopt;
    throw;
  }
}

/// What to do about an array that is not the required one.
std::string cure_of(py::handle given, std::span<const py::ssize_t> shape) {
  const std::optional<py::array_t<double>> numbers = converted(given);
  if (!numbers) return "";
  if (has_shape(*numbers, shape)) return " numpy.ascontiguousarray(..., dtype=numpy.float64) makes one.";
  if (shape.size() > 1 && shape[0] < 0 && has_shape(*numbers, shape.subspan(1)))
    return " For n = 1 write x[numpy.newaxis].";
  return "";
}

[[noreturn]] void refuse(py::handle given, const char* what, std::span<const py::ssize_t> shape) {
  throw Error(std::string(what) + ": " + describe_given(given) +
              " was given; it must be a C-contiguous array of shape " + describe_shape(shape) + " and dtype float64." +
              cure_of(given, shape));
}

bool is_float64(const py::array& array) {
  return array.dtype().kind() == 'f' && array.itemsize() == sizeof(double) &&
         array.dtype().attr("isnative").cast<bool>();
}

}  // namespace

std::span<const double> numbers_of(py::handle given, const char* what, std::initializer_list<py::ssize_t> shape) {
  const std::span<const py::ssize_t> wanted(shape.begin(), shape.size());
  if (!py::isinstance<py::array>(given)) refuse(given, what, wanted);
  const auto array = py::reinterpret_borrow<py::array>(given);
  const bool fits = has_shape(array, wanted) && py::isinstance<py::array_t<double>>(array) &&
                    (array.flags() & py::array::c_style) != 0 &&
                    reinterpret_cast<std::uintptr_t>(array.data()) % alignof(double) == 0;
  if (!fits) refuse(given, what, wanted);
  return {static_cast<const double*>(array.data()), std::size_t(array.size())};
}

bool read_numbers(py::handle given, const char* what, std::initializer_list<py::ssize_t> shape, double* numbers) {
  const std::span<const py::ssize_t> wanted(shape.begin(), shape.size());
  if (py::isinstance<py::array>(given)) {
    const auto array = py::reinterpret_borrow<py::array>(given);
    if (py::isinstance<py::array_t<double>>(array) || array.dtype().kind() == 'f') {
      if (!is_float64(array)) refuse(given, what, wanted);
      const std::span<const double> values = numbers_of(given, what, shape);
      std::copy(values.begin(), values.end(), numbers);
      return true;
    }
    const char kind = array.dtype().kind();
    if (kind != 'i' && kind != 'u') refuse(given, what, wanted);
  } else if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) {
    return false;
  }
  const std::optional<py::array_t<double>> array = converted(given);
  if (!array || !has_shape(*array, wanted)) refuse(array ? py::handle(*array) : given, what, wanted);
  std::copy_n(array->data(), array->size(), numbers);
  return true;
}

Pose pose_from(const double* matrix, const char* what) {
  if (!(matrix[12] == 0 && matrix[13] == 0 && matrix[14] == 0 && matrix[15] == 1))
    throw Error(
        std::string(what) + " has " + format_number(matrix[12]) + " " + format_number(matrix[13]) + " " +
        format_number(matrix[14]) + " " + format_number(matrix[15]) +
        " as its last row; it must be 0 0 0 1, with the translation in the last column. Is the matrix transposed?");
  Pose pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = matrix[4 * row + column];
    pose.translation[row] = matrix[4 * row + 3];
  }
  return pose;
}

void write_pose(const Pose& pose, double* matrix) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix[4 * row + column] = pose.rotation(row, column);
    matrix[4 * row + 3] = pose.translation[row];
    matrix[12 + row] = 0;
  }
  matrix[15] = 1;
}

py::array view(const py::dtype& type, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
               const void* data, py::handle owner) {
  py::array array(type, std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array view_of(std::span<const Vec3> points, py::handle owner) {
  return view(py::dtype::of<double>(), {py::ssize_t(points.size()), 3}, {sizeof(Vec3), sizeof(double)}, points.data(),
              owner);
}

}  // namespace hapticut::python
