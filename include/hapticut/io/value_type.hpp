// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hapticut/core/description.hpp"

namespace hapticut {

/// Type of the numbers in a file.
enum class ValueType : std::uint8_t { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

constexpr auto names_of(Of<ValueType>) {
  using enum ValueType;
  return std::array{
      Named{uint8, "uint8"},     Named{int8, "int8"},       Named{uint16, "uint16"}, Named{int16, "int16"},
      Named{uint32, "uint32"},   Named{int32, "int32"},     Named{uint64, "uint64"}, Named{int64, "int64"},
      Named{float32, "float32"}, Named{float64, "float64"},
  };
}

}  // namespace hapticut
