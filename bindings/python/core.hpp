// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "arrays.hpp"
#include "hapticut/core/errors.hpp"
#include "hapticut/core/mesh.hpp"
#include "hapticut/core/volume.hpp"

namespace hapticut::python {

/// Copies a NumPy array into a volume. The array may have any memory order and any type of real numbers; grey values
/// become float32, labels must be whole numbers 0 ... 65535.
/// @throws Error that names the given and the required array
template <class Value>
Volume<Value> volume_from(py::handle values, const Vec3& spacing, const Pose& X_WG) {
  constexpr bool kLabels = std::is_integral_v<Value>;
  const std::string what = kLabels ? "labels" : "grey values";
  const auto needed = [&] {
    return "it must be an array of shape (nx, ny, nz) and " +
           std::string(kLabels ? "a whole-number dtype, e.g. uint8 or uint16."
                               : "a real dtype, e.g. int16 or float32.");
  };
  if (!py::isinstance<py::array>(values)) throw Error(what + ": " + describe_given(values) + " was given; " + needed());
  const auto given = py::reinterpret_borrow<py::array>(values);
  const char kind = given.dtype().kind();
  const bool is_number = kind == 'i' || kind == 'u' || (kLabels ? kind == 'b' : kind == 'f');
  if (!is_number || given.ndim() != 3) throw Error(what + ": " + describe_given(values) + " was given; " + needed());
  for (int axis = 0; axis < 3; ++axis)
    if (given.shape(axis) > std::numeric_limits<int>::max())
      throw Error(what + ": " + describe_given(values) + " was given; an axis is too long.");

  Volume<Value> volume;
  volume.spacing = spacing;
  volume.X_WG = X_WG;
  for (int axis = 0; axis < 3; ++axis) volume.dims[std::size_t(axis)] = int(given.shape(axis));
  using Wide = std::conditional_t<kLabels, std::int64_t, float>;
  // One pass in the order of the volume: x fastest.
  const py::array_t<Wide, py::array::f_style | py::array::forcecast> wide(given);
  const Wide* numbers = wide.data();
  volume.values.resize(std::size_t(given.size()));
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    if constexpr (kLabels) {
      if (numbers[i] < 0 || numbers[i] > std::numeric_limits<Value>::max())
        throw Error("labels contain " + std::to_string(numbers[i]) + "; they must be within 0 ... 65535.");
    }
    volume.values[i] = Value(numbers[i]);
  }
  require_valid(volume);
  return volume;
}

}  // namespace hapticut::python
