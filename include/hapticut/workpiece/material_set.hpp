// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "hapticut/workpiece/material.hpp"

namespace hapticut {

/// A set of materials: one bit for each MaterialId, in four words. Bit `id % 64` of word `id / 64`.
struct MaterialSet {
  static constexpr std::size_t kWords = (kMaxMaterials + 1) / 64;
  std::array<std::uint64_t, kWords> words = {};

  [[nodiscard]] constexpr bool has(MaterialId id) const noexcept { return (words[id / 64U] >> (id % 64U) & 1U) != 0; }
  constexpr void insert(MaterialId id) noexcept { words[id / 64U] |= std::uint64_t(1) << (id % 64U); }
  constexpr void insert(const MaterialSet& others) noexcept {
    for (std::size_t n = 0; n < kWords; ++n) words[n] |= others.words[n];
  }

  [[nodiscard]] constexpr bool empty() const noexcept { return *this == MaterialSet{}; }
  [[nodiscard]] constexpr int size() const noexcept {
    int count = 0;
    for (const std::uint64_t word : words) count += std::popcount(word);
    return count;
  }

  /// Calls `function(id)` for each material of the set, in the order of the ids.
  template <class Function>
  constexpr void for_each(const Function& function) const {
    for (std::size_t n = 0; n < kWords; ++n)
      for (std::uint64_t bits = words[n]; bits != 0; bits &= bits - 1)
        function(MaterialId(64 * n + std::size_t(std::countr_zero(bits))));
  }

  [[nodiscard]] constexpr bool operator==(const MaterialSet&) const = default;
};

}  // namespace hapticut
