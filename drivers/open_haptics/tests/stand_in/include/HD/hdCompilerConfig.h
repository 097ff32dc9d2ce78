/* SPDX-License-Identifier: Apache-2.0 */
/* Part of a stand-in for the OpenHaptics device library, written for the tests of hapticut. It has the names, the
   signatures and the numbers of the real one and none of its text. It drives nothing. */
#ifndef HAPTICUT_STAND_IN_HD_COMPILER_CONFIG_H
#define HAPTICUT_STAND_IN_HD_COMPILER_CONFIG_H

/* The real header has a pragma here that GCC and clang do not know. A program must accept it. */
#pragma deprecated(HAPTICUT_STAND_IN_UNKNOWN_PRAGMA)

#endif
