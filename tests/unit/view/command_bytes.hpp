// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "hapticut/view/protocol.hpp"

namespace hapticut::view_test {

/// A message as a page writes it.
struct Bytes {
  explicit Bytes(view::CommandKind kind) : bytes{std::uint8_t(kind), view::kProtocolVersion, 0, 0} {}
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

}  // namespace hapticut::view_test
