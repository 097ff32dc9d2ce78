# SPDX-License-Identifier: Apache-2.0
# A runtime that uses SIGSEGV itself goes on living beside a loop. The sanitizers want that signal for themselves.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
add_library(loop_for_mono MODULE mono/loop_for_mono.cpp)
target_link_libraries(loop_for_mono PRIVATE hapticut::hapticut hapticut_build_flags)
add_dependencies(system_tests loop_for_mono)
add_test(NAME Mono.CatchesItsNullReferencesBesideARunningLoop COMMAND "${CMAKE_COMMAND}"
  "-DSOURCE=${CMAKE_CURRENT_LIST_DIR}" "-DWORK=${PROJECT_BINARY_DIR}/mono" "-DLIBRARY=$<TARGET_FILE:loop_for_mono>"
  -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
set_tests_properties(Mono.CatchesItsNullReferencesBesideARunningLoop PROPERTIES LABELS system TIMEOUT 300
  SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
