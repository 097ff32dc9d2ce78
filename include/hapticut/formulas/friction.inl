// SPDX-License-Identifier: Apache-2.0
// Text of hapticut/force/spread_friction.hpp and of the kernels: dry friction of a point with its own coefficients.

/// What a point adds to SpreadFriction, in the unit of its normal force.
template <class Real>
struct PointFriction {
  Real limit;    ///< mu_s f
  Real dynamic;  ///< mu_d f
  Real anchor;   ///< mu_s f k_t where k_t is given
  Real spring;   ///< the stiffness along n, where it is not given

  /// @param push     normal force f
  /// @param along_n  stiffness along n
  HAPTICUT_FORMULA static PointFriction of(Real static_friction, Real dynamic_friction, Real tangential_stiffness,
                                           Real push, Real along_n) {
    const Real limit = static_friction * push;
    return {limit, dynamic_friction * push, tangential_stiffness * limit,
            select(tangential_stiffness == 0 && push > 0, along_n, Real(0))};
  }
};
