// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The sanitizer that this is compiled for. g++ defines a macro, clang++ has __has_feature.
#if defined(__has_feature)
#define HAPTICUT_HAS_FEATURE(name) __has_feature(name)
#else
#define HAPTICUT_HAS_FEATURE(name) 0
#endif

namespace hapticut::test {

#if defined(__SANITIZE_ADDRESS__) || HAPTICUT_HAS_FEATURE(address_sanitizer)
inline constexpr bool kWithAddressSanitizer = true;
#else
inline constexpr bool kWithAddressSanitizer = false;
#endif

#if defined(__SANITIZE_THREAD__) || HAPTICUT_HAS_FEATURE(thread_sanitizer)
inline constexpr bool kWithThreadSanitizer = true;
#else
inline constexpr bool kWithThreadSanitizer = false;
#endif

}  // namespace hapticut::test

#undef HAPTICUT_HAS_FEATURE
