// SPDX-License-Identifier: Apache-2.0
// The springs of a head of any shape, for a vector of points; included once per instruction set.
#if defined(HAPTICUT_KERNELS_SPRINGS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#undef HAPTICUT_KERNELS_SPRINGS_INL_HPP
#else
#define HAPTICUT_KERNELS_SPRINGS_INL_HPP
#endif

#include "kernels/profile_springs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace hapticut::kernels::HWY_NAMESPACE {

/// Calls `function(springs)` with the springs of the head's shape for vectors W (hapticut/formulas/springs.inl).
template <class W, class Function>
HWY_INLINE auto visit_springs(const ToolHead& head, const Function& function) {
  return head.visit([&](const auto& shape) HWY_ATTR { return formulas::with_springs<W>(shape, function); });
}

}  // namespace hapticut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
