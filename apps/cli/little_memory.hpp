// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticut::apps {

/// What the program says when memory runs out.
inline constexpr const char* kNoMemory =
    "there is not enough memory for this. Use larger voxels, a smaller piece or a shorter path.";

/// Prepares the program for the end of its memory, so that it ends with the sentence `kNoMemory` and exit code 1.
///
/// OpenVDB allocates memory to destroy a tree. If this fails while an exception is on its way, C++ ends the program by
/// std::terminate. Therefore a reserve is kept: the first allocation that fails releases it and throws
/// std::bad_alloc, so there is memory for the way back to main(). If even that fails, std::terminate prints the
/// sentence, unless a device runs: then the crash handlers of the loop stop its motors.
void prepare_for_little_memory();

}  // namespace hapticut::apps
