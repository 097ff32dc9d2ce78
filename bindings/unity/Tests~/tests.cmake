# SPDX-License-Identifier: Apache-2.0
# The Unity package under Mono, with a stand-in for the engine, and as scripts/package-unity.sh fills it. The engine takes
# no notice of a folder with a ~.
if(NOT HAPTICUT_C OR BUILD_SHARED_LIBS OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
file(GLOB program "${CMAKE_CURRENT_LIST_DIR}/*.cs" "${PROJECT_SOURCE_DIR}/bindings/unity/Runtime/*.cs"
  "${PROJECT_SOURCE_DIR}/bindings/unity/Editor/*.cs")
hapticut_mono_test(Unity.DrillsShowsAndSoundsInAStandInForTheEngine unity hapticut_c "drilled, seen, heard" ${program} ${HAPTICUT_CSHARP})
add_test(NAME Unity.PackageHasTheLibraryAndAllThatItNeeds COMMAND "${PROJECT_SOURCE_DIR}/scripts/package-unity.sh"
  --library "$<TARGET_FILE:hapticut_c>" --out "${PROJECT_BINARY_DIR}/unity/package")
set_tests_properties(Unity.PackageHasTheLibraryAndAllThatItNeeds PROPERTIES LABELS "unity;slow" TIMEOUT 300)
