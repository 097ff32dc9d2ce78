// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <variant>
#include <vector>

#include "hapticut/view/protocol.hpp"

namespace hapticut::view_test {

/// Command numbers as documented in hapticut/view/protocol.hpp.
struct CommandKind {
  static constexpr std::uint8_t set_spindle_speed = 1, set_undo_mark = 2, undo = 3, redo = 4, hold_force = 5,
                                move_hand = 6, stop = 7, look_at = 8, set_control = 9, load = 10;
};
inline constexpr std::uint8_t kCommandKinds = std::variant_size_v<view::ViewCommand> - 1;  // all but WriterLeft
static_assert(CommandKind::load == kCommandKinds, "add the kind of the new command above");

/// Builds a message of a page.
struct Bytes {
  explicit Bytes(std::uint8_t kind) : bytes{kind, view::kProtocolVersion, 0, 0} {}
  template <class Number>
  Bytes& add(Number number) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(&number);
    bytes.insert(bytes.end(), first, first + sizeof number);
    return *this;
  }
  Bytes& add(const Vec3& v) { return add(v.x()).add(v.y()).add(v.z()); }
  Bytes& add(const Pose& pose) {
    for (int row = 0; row < 3; ++row) add(Vec3(pose.rotation.row(row)));
    return add(pose.translation);
  }
  std::vector<std::uint8_t> bytes;
};

/// Reads a number at a place of a message.
template <class Number>
Number number_at(const view::Message& message, std::size_t place) {
  Number number{};
  EXPECT_LE(place + sizeof number, message.size());
  std::memcpy(&number, message.data() + place, sizeof number);
  return number;
}

}  // namespace hapticut::view_test
