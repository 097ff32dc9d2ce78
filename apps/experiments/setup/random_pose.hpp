// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "hapticut/core/spatial.hpp"
#include "hapticut/core/units.hpp"

namespace hapticut::test {

/// Random numbers, vectors and rotations, equal on every machine and with every standard library (SplitMix64).
class RandomPoses {
 public:
  explicit RandomPoses(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    z ^= z >> 31;
    return low + (high - low) * (double(z >> 11) * 0x1p-53);
  }

  /// A unit vector, uniform on the sphere.
  [[nodiscard]] Vec3 direction() {
    const double z = between(-1, 1), angle = between(0, 2 * units::kPi), rho = std::sqrt(1 - z * z);
    return {rho * std::cos(angle), rho * std::sin(angle), z};
  }

  /// A vector of length up to `max_length`, in any direction.
  [[nodiscard]] Vec3 vector(double max_length) {
    const double length = between(0, max_length);
    return length * direction();
  }

  /// A rotation, uniform over all rotations (Shoemake).
  [[nodiscard]] Mat3 rotation() {
    const double u = between(0, 1), a = between(0, 2 * units::kPi), b = between(0, 2 * units::kPi);
    const Eigen::Quaterniond q(std::sqrt(u) * std::cos(b), std::sqrt(1 - u) * std::sin(a),
                               std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b));
    return q.normalized().toRotationMatrix();
  }

 private:
  std::uint64_t state_;
};

}  // namespace hapticut::test
