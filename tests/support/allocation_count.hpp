// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Counts calls of the C and C++ allocators and of mutex locks on this thread while armed. The program that uses it
/// links allocation_count.cpp, which replaces malloc and its family for the whole process.
namespace hapticut::test {

struct CallCounts {
  long allocations = 0;    ///< malloc, calloc, realloc, memalign and similar, and through them operator new
  long deallocations = 0;  ///< free, and through it operator delete
  long locks = 0;          ///< pthread_mutex_lock
};

/// Starts counting on this thread from zero.
void arm_call_counts();

/// Stops counting and returns the counts.
CallCounts disarm_call_counts();

}  // namespace hapticut::test
