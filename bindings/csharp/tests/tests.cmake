# SPDX-License-Identifier: Apache-2.0
# C# under Mono. Not with sanitizers, which intercept the signals of Mono.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
# hapticut_mono_test(Suite.Name label library "output" program.cs...): runs a program and checks its output.
function(hapticut_mono_test name label library says)
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${ARGN}" "-DSAYS=${says}" "-DWORK=${PROJECT_BINARY_DIR}/mono/${name}"
    "-DLIBRARY=$<TARGET_FILE:${library}>" -P "${PROJECT_SOURCE_DIR}/bindings/csharp/tests/run.cmake")
  set_tests_properties(${name} PROPERTIES LABELS "${label};slow" TIMEOUT 300 SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()
file(GLOB HAPTICUT_CSHARP "${PROJECT_SOURCE_DIR}/bindings/csharp/*.cs")

# Tests that a runtime that uses SIGSEGV keeps running while a loop runs.
add_library(loop_for_mono MODULE "${CMAKE_CURRENT_LIST_DIR}/loop_for_mono.cpp")
target_link_libraries(loop_for_mono PRIVATE hapticut::hapticut hapticut_build_flags)
hapticut_mono_test(Mono.CatchesItsNullReferencesBesideARunningLoop csharp loop_for_mono "lives" "${CMAKE_CURRENT_LIST_DIR}/LivesOn.cs")
if(HAPTICUT_C)
  hapticut_mono_test(CSharp.KeepsThePromisesOfTheBindingUnderMono csharp hapticut_c "keeps its promises"
    "${CMAKE_CURRENT_LIST_DIR}/BindingTest.cs" ${HAPTICUT_CSHARP})
endif()
