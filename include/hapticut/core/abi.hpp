// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hapticut/version.hpp"

/// @file
/// What a program and the library must agree on so that a type has the same layout in both. A program that differs does
/// not link; the linker's message names the values that the program was compiled with: docs/embedding.md.
namespace hapticut::abi {

// Numbers with names, for a linker's message. NOLINTBEGIN(readability-identifier-naming)
enum class hapticut_version : int {};
enum class glibcxx_debug : int {};
enum class glibcxx_use_cxx11_abi : int {};
enum class libcxx_abi : int {};
enum class eigen_version : int {};
enum class eigen_align : int {};
enum class eigen_row_major : int {};
enum class eigen_index_bytes : int {};
enum class struct_bytes : int {};
// NOLINTEND(readability-identifier-naming)

/// One member of each type that public structs are made of. Equal sizes show that program and library agree.
struct Struct {
  char character;
  enum { first } choice;
  bool flag;
  double number;
  std::string text;
  std::vector<double> list;
  std::vector<double>::iterator place;
  std::map<int, double> map;
  std::optional<double> some;
  std::shared_ptr<double> shared;
  std::function<void()> function;
};

#ifdef _GLIBCXX_DEBUG
inline constexpr glibcxx_debug kGlibcxxDebug{1};
#else
inline constexpr glibcxx_debug kGlibcxxDebug{0};
#endif
#ifdef _GLIBCXX_USE_CXX11_ABI
inline constexpr glibcxx_use_cxx11_abi kGlibcxxUseCxx11Abi{_GLIBCXX_USE_CXX11_ABI};
#else
inline constexpr glibcxx_use_cxx11_abi kGlibcxxUseCxx11Abi{0};
#endif
#ifdef _LIBCPP_ABI_VERSION
inline constexpr libcxx_abi kLibcxxAbi{_LIBCPP_ABI_VERSION};
#else
inline constexpr libcxx_abi kLibcxxAbi{0};
#endif

/// The library defines exactly one of these: the one with the values that it was compiled with.
template <hapticut_version, glibcxx_debug, glibcxx_use_cxx11_abi, libcxx_abi, eigen_version, eigen_align,
          eigen_row_major, eigen_index_bytes, struct_bytes>
[[gnu::visibility("default")]] void library_was_compiled_with();

// Each file has one. It is kept even if unused, so that each file refers to the function.
#if defined(__has_cpp_attribute) && __has_cpp_attribute(gnu::retain)
[[gnu::used, gnu::retain]]
#else
[[gnu::used]]
#endif
static void (*const kMustAgree)() = &library_was_compiled_with<
    hapticut_version(100 * HAPTICUT_VERSION_MAJOR + HAPTICUT_VERSION_MINOR), kGlibcxxDebug, kGlibcxxUseCxx11Abi,
    kLibcxxAbi, eigen_version(100 * EIGEN_WORLD_VERSION + EIGEN_MAJOR_VERSION), eigen_align(alignof(Eigen::Vector2d)),
    eigen_row_major(Eigen::Matrix3d::IsRowMajor), eigen_index_bytes(sizeof(Eigen::Index)),
    struct_bytes(sizeof(Struct))>;

}  // namespace hapticut::abi
