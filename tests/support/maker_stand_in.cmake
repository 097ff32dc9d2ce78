# SPDX-License-Identifier: Apache-2.0
# Functions for the stand-ins of makers' SDKs.

# maker_adapter_under_test(name STAND_IN COMPONENT): builds the adapter of HAPTICUT_WITH_<COMPONENT> against its
# stand-in, in strict ISO C++. The sources are those that a machine with the SDK builds.
function(maker_adapter_under_test name stand_in component)
  get_property(sources GLOBAL PROPERTY HAPTICUT_${component}_SOURCES)
  get_property(headers GLOBAL PROPERTY HAPTICUT_${component}_HEADERS)
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
  target_include_directories(${name} PUBLIC ${headers} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/drivers)
  target_link_libraries(${name} PUBLIC hapticut::hapticut ${stand_in} PRIVATE hapticut_build_flags)
endfunction()

# maker_header_test(Suite.Name WILL_FAIL flags...): tests that uses_header.cpp parses with these flags; with WILL_FAIL ON,
# that it does not parse.
function(maker_header_test name will_fail)
  add_test(NAME "${name}" COMMAND ${CMAKE_CXX_COMPILER} ${ARGN} -fsyntax-only
    -isystem ${CMAKE_CURRENT_SOURCE_DIR}/include ${CMAKE_CURRENT_SOURCE_DIR}/uses_header.cpp)
  set_tests_properties("${name}" PROPERTIES WILL_FAIL ${will_fail} LABELS unit)
endfunction()

# maker_finder_test(Suite.Name PACKAGE LIBRARY modules): tests the find module in the folder `modules`. It must find an
# SDK with the layout of ${CMAKE_CURRENT_BINARY_DIR}/sdk, whose include folder is that of the stand-in, and must report an
# absent SDK.
function(maker_finder_test name package library modules)
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/sdk")
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/include" "${CMAKE_CURRENT_BINARY_DIR}/sdk/include" SYMBOLIC)
  add_test(NAME "${name}" COMMAND ${CMAKE_COMMAND} -DPACKAGE=${package} -DLIBRARY=${library}
    -DSOURCE=${CMAKE_CURRENT_SOURCE_DIR}/finder -DBINARY=${CMAKE_CURRENT_BINARY_DIR}/finder
    -DSDK=${CMAKE_CURRENT_BINARY_DIR}/sdk "-DFLAGS=${CMAKE_CXX_FLAGS}" -DMODULES=${modules}
    -DCOMPILER=${CMAKE_CXX_COMPILER} -DGENERATOR=${CMAKE_GENERATOR}
    -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/run_finder.cmake)
  set_tests_properties("${name}" PROPERTIES LABELS unit)
endfunction()
