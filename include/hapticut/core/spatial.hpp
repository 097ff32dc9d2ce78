// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

/// @file
/// Vectors, rotations, poses, twists and wrenches, and their frames.
///
/// Frames: `W` world = workpiece frame, `H` handle (the hand), `T` tool head, `V` voxel grid. Symbols follow the
/// monogram notation: `X_WT` is the pose of T in W, `p_WQ` the position of Q in W, and inner letters cancel: `X_WT =
/// X_WH * X_HT`.
///
/// Every type in this file has the same memory layout with and without AVX (no aligned Eigen member), so that a library
/// and an application compiled with different flags agree on it.
namespace hapticut {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
static_assert(alignof(Vec3) == alignof(double) && alignof(Mat3) == alignof(double),
              "the layout of public types must not depend on compiler flags");

/// A rigid pose: the rotation and translation that transform coordinates of one frame into another.
struct Pose {
  Mat3 rotation = Mat3::Identity();  ///< [1] orthonormal, determinant +1
  Vec3 translation = Vec3::Zero();   ///< [m]

  [[nodiscard]] static Pose from_translation(const Vec3& translation) { return {Mat3::Identity(), translation}; }

  /// The inverse pose: `X_BA = X_AB.inverse()`.
  [[nodiscard]] Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

/// Composition: `X_AC = X_AB * X_BC`.
[[nodiscard]] inline Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  return {X_AB.rotation * X_BC.rotation, X_AB.rotation * X_BC.translation + X_AB.translation};
}

/// Transforms a point from frame B to frame A: `p_AQ = X_AB * p_BQ`.
[[nodiscard]] inline Vec3 operator*(const Pose& X_AB, const Vec3& p_BQ) {
  return X_AB.rotation * p_BQ + X_AB.translation;
}

/// Velocity of a rigid body at a named point of the body.
struct Twist {
  Vec3 linear = Vec3::Zero();   ///< [m/s] velocity of the named point
  Vec3 angular = Vec3::Zero();  ///< [rad/s] angular velocity of the body
};

/// Force and torque about a named point, acting on the tool.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N·m]
};

/// Moves a wrench to another point: the torque gains `p_QP x force`, so that the power `F·V + T·Omega` is unchanged
/// (C19).
/// @param wrench_P  the wrench about P
/// @param p_QP      [m] the vector from the new point Q to the old one P, in the frame of the wrench
[[nodiscard]] inline Wrench transport(const Wrench& wrench_P, const Vec3& p_QP) {
  return {wrench_P.force, wrench_P.torque + p_QP.cross(wrench_P.force)};
}

/// Velocity at another point Q of the same body.
/// @param twist_P  the twist at P
/// @param p_PQ     [m] the vector from P to Q, in the frame of the twist
[[nodiscard]] inline Twist transport(const Twist& twist_P, const Vec3& p_PQ) {
  return {twist_P.linear + twist_P.angular.cross(p_PQ), twist_P.angular};
}

/// Rotation by the angle |v| about v (the exponential map of SO(3)).  @param v  [rad] rotation vector
[[nodiscard]] inline Mat3 rotation_from_vector(const Vec3& v) {
  const double angle = v.norm();
  const double a = angle < 1e-6 ? 1.0 - angle * angle / 6 : std::sin(angle) / angle;
  const double half = std::sin(angle / 2);
  const double b = angle < 1e-6 ? 0.5 - angle * angle / 24 : 2 * half * half / (angle * angle);
  Mat3 skew;
  skew << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return Mat3::Identity() + a * skew + b * skew * skew;
}

/// The rotation vector of a rotation matrix (the logarithm of SO(3)).  @return [rad], length in [0, pi]
[[nodiscard]] inline Vec3 vector_from_rotation(const Mat3& rotation) {
  const Vec3 axis_times_sine(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                             rotation(1, 0) - rotation(0, 1));
  const double sine = axis_times_sine.norm() / 2;
  const double cosine = (rotation.trace() - 1) / 2;
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-7) return axis_times_sine * (angle / (2 * sine));
  if (cosine > 0) return axis_times_sine / 2;
  // At 180 degrees the antisymmetric part vanishes. The axis is the column of the symmetric part of R + I with the
  // largest diagonal; the remainder of the antisymmetric part gives the sign.
  const Mat3 m = 0.5 * (rotation + rotation.transpose()) + Mat3::Identity();
  Eigen::Index largest = 0;
  m.diagonal().maxCoeff(&largest);
  const Vec3 axis = m.col(largest).normalized();
  return axis * (axis.dot(axis_times_sine) < 0 ? -angle : angle);
}

/// The constant twist of the body's origin that moves the body from pose `from` to pose `to` in time `dt` [s].
[[nodiscard]] inline Twist twist_between(const Pose& from, const Pose& to, double dt) {
  return {(to.translation - from.translation) / dt, vector_from_rotation(to.rotation * from.rotation.transpose()) / dt};
}

/// The pose after moving with a constant twist of the body's origin for a time `dt` [s].
[[nodiscard]] inline Pose advance(const Pose& from, const Twist& twist, double dt) {
  return {rotation_from_vector(twist.angular * dt) * from.rotation, from.translation + twist.linear * dt};
}

[[nodiscard]] inline bool is_finite(const Vec3& v) { return v.allFinite(); }
[[nodiscard]] inline bool is_finite(const Pose& X) { return X.rotation.allFinite() && X.translation.allFinite(); }

/// Whether a matrix is a rotation: orthonormal within `tolerance` [1] and right-handed.
[[nodiscard]] inline bool is_rotation(const Mat3& m, double tolerance) {
  return ((m * m.transpose()) - Mat3::Identity()).cwiseAbs().maxCoeff() <= tolerance && m.determinant() > 0;
}

/// The rotation nearest to an almost orthonormal matrix (one step of Newton's polar iteration per pass).
[[nodiscard]] inline Mat3 orthonormalized(const Mat3& m) {
  Mat3 r = m;
  for (int pass = 0; pass < 3; ++pass) r = 0.5 * r * (3.0 * Mat3::Identity() - r.transpose() * r);
  return r;
}

}  // namespace hapticut
