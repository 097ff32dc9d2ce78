# SPDX-License-Identifier: Apache-2.0
# Tests of the header and the library of the C interface.
if(NOT HAPTICUT_C OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  return()
endif()
add_test(NAME CHeader.CompilesInCAndInCppWithoutExceptions COMMAND "${CMAKE_COMMAND}" "-DINCLUDE=${PROJECT_SOURCE_DIR}/include"
  "-DWORK=${PROJECT_BINARY_DIR}/c_header" "-DCC=${CMAKE_C_COMPILER}" "-DCXX=${CMAKE_CXX_COMPILER}"
  -P "${CMAKE_CURRENT_LIST_DIR}/header.cmake")
set_tests_properties(CHeader.CompilesInCAndInCppWithoutExceptions PROPERTIES LABELS system TIMEOUT 300)
if(NOT HAPTICUT_PYTHON3)
  return()
endif()
add_test(NAME CLibrary.ShowsTheFunctionsOfItsHeaderAndNothingElse COMMAND "${HAPTICUT_PYTHON3}"
  "${CMAKE_CURRENT_LIST_DIR}/library.py" symbols "$<TARGET_FILE:hapticut_c>"
  "${PROJECT_SOURCE_DIR}/include/hapticut/c/hapticut.h")
set_tests_properties(CLibrary.ShowsTheFunctionsOfItsHeaderAndNothingElse PROPERTIES LABELS system TIMEOUT 60)
# In a build with shared libraries, hapticut_c also needs the other libraries of hapticut.
if(NOT BUILD_SHARED_LIBS)
  add_test(NAME CLibrary.NeedsNoLibraryThatItsPageDoesNotName COMMAND "${HAPTICUT_PYTHON3}"
    "${CMAKE_CURRENT_LIST_DIR}/library.py" needs "$<TARGET_FILE:hapticut_c>")
  set_tests_properties(CLibrary.NeedsNoLibraryThatItsPageDoesNotName PROPERTIES LABELS system TIMEOUT 60)
endif()
