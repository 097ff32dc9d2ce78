// SPDX-License-Identifier: Apache-2.0
// Debian's TBB is not instrumented, so that whatever its workers hand over to each other looks like a race to the
// thread sanitizer. With this file in a test, TBB runs in the thread that calls it; threads of our own are watched as
// ever.
#include <tbb/global_control.h>

namespace {

const tbb::global_control kOneThread(tbb::global_control::max_allowed_parallelism, 1);

}  // namespace
