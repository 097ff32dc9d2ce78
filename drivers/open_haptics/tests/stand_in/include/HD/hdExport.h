/* SPDX-License-Identifier: Apache-2.0 */
/* Part of a stand-in for the OpenHaptics device library, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one and none of its text. It drives nothing. */
#ifndef HAPTICUT_STAND_IN_HD_EXPORT_H
#define HAPTICUT_STAND_IN_HD_EXPORT_H

/* Tests the macro `linux`, as the real header does. Strict ISO C++ does not predefine it; without it the macros below
   stay undefined and no prototype parses. */
#if defined(_WIN32)
#define HDAPI __declspec(dllimport)
#define HDAPIENTRY __stdcall
#define HDCALLBACK __stdcall
#elif defined(linux)
#define HDAPI
#define HDAPIENTRY __attribute__((stdcall))
#define HDCALLBACK
#elif defined(__APPLE__)
#define HDAPI
#define HDAPIENTRY
#define HDCALLBACK
#endif

#endif
