# SPDX-License-Identifier: Apache-2.0
# Instruction sets of the kernels; each takes a minute of processor time to compile. Sets HAPTICUT_KERNEL_TARGETS, the
# names of files in src/kernels/targets/, and HAPTICUT_KERNELS_LEAVE_OUT, Highway's names of the sets that are left out.
set(HAPTICUT_KERNELS ALL CACHE STRING "ALL instruction sets, or NATIVE: only the best one of this machine")
set_property(CACHE HAPTICUT_KERNELS PROPERTY STRINGS ALL NATIVE)

set(HAPTICUT_KERNEL_TARGETS baseline avx2 avx3)
if(HAPTICUT_KERNELS STREQUAL "NATIVE")
  # Highway reports the best set with the same detection as at run time. ARM has only the baseline. When
  # cross-compiling, all sets are compiled.
  if(NOT hapticut_best_kernels AND NOT CMAKE_CROSSCOMPILING)
    try_run(hapticut_best_ran hapticut_best_compiled "${CMAKE_BINARY_DIR}/best_kernels"
      "${CMAKE_CURRENT_LIST_DIR}/best_kernels.cpp" LINK_LIBRARIES hwy::hwy RUN_OUTPUT_VARIABLE best)
    if(hapticut_best_compiled AND hapticut_best_ran EQUAL 0)
      set(hapticut_best_kernels "${best}" CACHE INTERNAL "the best instruction set of this machine")
    endif()
    unset(hapticut_best_ran CACHE)
    unset(hapticut_best_compiled CACHE)
  endif()
  if(hapticut_best_kernels)
    set(HAPTICUT_KERNEL_TARGETS baseline ${hapticut_best_kernels})
    list(REMOVE_DUPLICATES HAPTICUT_KERNEL_TARGETS)
  else()
    message(STATUS "HAPTICUT_KERNELS=NATIVE, but the best instruction set of this machine is unknown: all are compiled")
  endif()
elseif(NOT HAPTICUT_KERNELS STREQUAL "ALL")
  message(FATAL_ERROR "HAPTICUT_KERNELS=${HAPTICUT_KERNELS}, but it must be ALL or NATIVE")
endif()

set(HAPTICUT_KERNELS_LEAVE_OUT 0)
foreach(target avx2 avx3)
  if(NOT target IN_LIST HAPTICUT_KERNEL_TARGETS)
    string(TOUPPER "${target}" target)
    string(APPEND HAPTICUT_KERNELS_LEAVE_OUT "|HWY_${target}")
  endif()
endforeach()
