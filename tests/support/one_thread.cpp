// SPDX-License-Identifier: Apache-2.0
// Debian's TBB is not instrumented, so the thread sanitizer reports a race wherever its workers exchange data. With
// this file in a test, TBB runs in the calling thread; our own threads are still checked.
#include <tbb/global_control.h>

namespace {

const tbb::global_control kOneThread(tbb::global_control::max_allowed_parallelism, 1);

}  // namespace
