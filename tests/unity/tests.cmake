# SPDX-License-Identifier: Apache-2.0
# The Unity package under Mono, with a stand-in for the engine, and as scripts/package-unity.sh fills it.
if(NOT HAPTICUT_C OR BUILD_SHARED_LIBS OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
file(GLOB program "${CMAKE_CURRENT_LIST_DIR}/*.cs" "${PROJECT_SOURCE_DIR}/bindings/unity/Runtime/*.cs"
  "${PROJECT_SOURCE_DIR}/bindings/unity/Editor/*.cs")
add_test(NAME Unity.DrillsShowsAndSoundsInAStandInForTheEngine COMMAND "${CMAKE_COMMAND}"
  "-DBINDING=${PROJECT_SOURCE_DIR}/bindings/csharp" "-DPROGRAM=${program}" "-DSAYS=drilled, seen, heard"
  "-DWORK=${PROJECT_BINARY_DIR}/unity" "-DLIBRARY=$<TARGET_FILE:hapticut_c>" -P "${PROJECT_SOURCE_DIR}/tests/csharp/run.cmake")
add_test(NAME Unity.PackageHasTheLibraryAndAllThatItNeeds COMMAND "${PROJECT_SOURCE_DIR}/scripts/package-unity.sh"
  --library "$<TARGET_FILE:hapticut_c>" --out "${PROJECT_BINARY_DIR}/unity/package")
set_tests_properties(Unity.DrillsShowsAndSoundsInAStandInForTheEngine Unity.PackageHasTheLibraryAndAllThatItNeeds PROPERTIES
  LABELS system TIMEOUT 300 SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
