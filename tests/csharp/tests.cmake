# SPDX-License-Identifier: Apache-2.0
# C# over the C interface, under Mono. The sanitizers want the runtime's signals for themselves.
if(NOT HAPTICUT_C OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
add_test(NAME CSharp.KeepsThePromisesOfTheBindingUnderMono COMMAND "${CMAKE_COMMAND}" "-DBINDING=${PROJECT_SOURCE_DIR}/bindings/csharp"
  "-DPROGRAM=${CMAKE_CURRENT_LIST_DIR}/BindingTest.cs" "-DSAYS=keeps its promises" "-DWORK=${PROJECT_BINARY_DIR}/csharp"
  "-DLIBRARY=$<TARGET_FILE:hapticut_c>" -P "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
set_tests_properties(CSharp.KeepsThePromisesOfTheBindingUnderMono PROPERTIES LABELS system TIMEOUT 300
  SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
