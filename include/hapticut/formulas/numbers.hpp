// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// The words of the formulas in hapticut/formulas/*.inl. Each formula is written once. The public headers include its
/// text for one voxel, with `Real` a float or a double; the kernels include the same text for a vector of voxels, with
/// a `Real` that has the same operators and words (src/kernels/wide-inl.hpp). A text has no namespace and no includes.
///
/// A condition is a bool for one voxel and a mask for a vector. `select(where, a, b)` is a where the condition is true,
/// else b. Both are computed, so one of them may divide by zero where the other is chosen. `any` and `all` turn a
/// condition into a bool: with them a text leaves out what no voxel of the vector needs.
#define HAPTICUT_FORMULA inline
namespace hapticut::formulas {

inline float select(bool where, float a, float b) { return where ? a : b; }
inline double select(bool where, double a, double b) { return where ? a : b; }
inline float min(float a, float b) { return std::min(a, b); }
inline double min(double a, double b) { return std::min(a, b); }
inline float max(float a, float b) { return std::max(a, b); }
inline double max(double a, double b) { return std::max(a, b); }
inline float abs(float a) { return std::abs(a); }
inline double abs(double a) { return std::abs(a); }
inline float sqrt(float a) { return std::sqrt(a); }
inline double sqrt(double a) { return std::sqrt(a); }
inline float reciprocal(float a) { return 1 / a; }
inline double reciprocal(double a) { return 1 / a; }
inline float inverse_root(float a) { return 1 / std::sqrt(a); }
inline double inverse_root(double a) { return 1 / std::sqrt(a); }
inline bool all(bool where) { return where; }
inline bool any(bool where) { return where; }

}  // namespace hapticut::formulas
