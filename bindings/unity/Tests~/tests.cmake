# SPDX-License-Identifier: Apache-2.0
# Tests the Unity package under Mono with a fake engine, and the package that scripts/package-unity.sh makes. The engine
# ignores folders that end with ~.
if(NOT HAPTICUT_C OR BUILD_SHARED_LIBS OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
file(GLOB program "${CMAKE_CURRENT_LIST_DIR}/*.cs" "${PROJECT_SOURCE_DIR}/bindings/unity/Runtime/*.cs"
  "${PROJECT_SOURCE_DIR}/bindings/unity/Editor/*.cs")
hapticut_mono_test(Unity.DrillsShowsAndSoundsInAStandInForTheEngine unity hapticut_c "drilled, seen, heard" ${program} ${HAPTICUT_CSHARP})
add_test(NAME Unity.PackageHasTheLibraryAndAllThatItNeeds COMMAND "${PROJECT_SOURCE_DIR}/scripts/package-unity.sh"
  --library "$<TARGET_FILE:hapticut_c>" --out "${PROJECT_BINARY_DIR}/unity/package")
set_tests_properties(Unity.PackageHasTheLibraryAndAllThatItNeeds PROPERTIES LABELS "unity;slow" TIMEOUT 300)
