// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/contact/cut_voxel.hpp and of the kernels: vectors in space.

/// A vector in T.
template <class Real>
struct Triple {
  Real x, y, z;

  HAPTICUT_FORMULA friend Real dot(const Triple& a, const Triple& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
  HAPTICUT_FORMULA friend Triple cross(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// [m/s] v + omega x r
template <class Real>
HAPTICUT_FORMULA Triple<Real> velocity_at(const Triple<Real>& r, const Eigen::Vector3f& v,
                                          const Eigen::Vector3f& omega) {
  const Real ox(omega.x()), oy(omega.y()), oz(omega.z());
  return {Real(v.x()) + oy * r.z - oz * r.y, Real(v.y()) + oz * r.x - ox * r.z, Real(v.z()) + ox * r.y - oy * r.x};
}

/// [1] The largest |n_i| of a unit vector n along the grid's axes, which are the columns of `axes`.
template <class Real>
HAPTICUT_FORMULA Real largest_component(const Eigen::Matrix3f& axes, const Triple<Real>& n) {
  Real largest = Real(kMinMaxNorm);
  for (int axis = 0; axis < 3; ++axis)
    largest = max(largest, abs(dot(n, Triple<Real>{Real(axes(0, axis)), Real(axes(1, axis)), Real(axes(2, axis))})));
  return min(largest, Real(1));
}
