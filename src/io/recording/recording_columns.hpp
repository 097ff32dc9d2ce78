// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "hapticut/io/recording/recording.hpp"
#include "io/recording/hdf5.hpp"

/// @file
/// The columns of a recording: one data set each, with its unit and frame.
namespace hapticut {

/// One column: its name and meaning, and the conversion between a row and a step.
struct Column {
  enum class Side { input, result, device };

  std::string name, unit, frame, meaning;
  Side side;
  ValueType kind = ValueType::float64;
  std::vector<hsize_t> shape = {};  ///< shape of one row; empty: one number
  std::size_t numbers = 1;          ///< numbers in one row
  std::size_t bytes = 0;            ///< size of one row
  std::function<void(const RecordedStep&, std::byte*)> pack = {};
  std::function<void(RecordedStep&, const std::byte*)> unpack = {};
};

/// All columns of the current format, in the order of the file.
[[nodiscard]] const std::vector<Column>& recording_columns();

/// Group that contains the columns.
inline constexpr char kStepsGroup[] = "steps";

/// One number of a packed row.
[[nodiscard]] double number_at(const Column& column, const std::byte* row, std::size_t element);

}  // namespace hapticut
