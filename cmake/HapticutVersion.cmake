# SPDX-License-Identifier: Apache-2.0
# The version of project() and the git commit, for C++. hapticut/version.hpp is installed, the header with
# the commit is not.

configure_file("${CMAKE_CURRENT_LIST_DIR}/version.hpp.in" "${PROJECT_BINARY_DIR}/include/hapticut/version.hpp" @ONLY)

set(_commit_header "${PROJECT_BINARY_DIR}/generated/hapticut_commit.hpp")
add_custom_target(hapticut_commit BYPRODUCTS "${_commit_header}"
  COMMAND "${CMAKE_COMMAND}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DOUTPUT=${_commit_header}"
          -P "${CMAKE_CURRENT_LIST_DIR}/HapticutCommit.cmake"
  COMMENT "Looking up the commit" VERBATIM)

# hapticut_use_version(target): lets a target of the project include the commit. hapticut::physics provides the version.
function(hapticut_use_version target)
  add_dependencies(${target} hapticut_commit)
  target_include_directories(${target} PRIVATE "${PROJECT_BINARY_DIR}/generated")
  set_property(SOURCE core/build_info.cpp APPEND PROPERTY
    COMPILE_DEFINITIONS "HAPTICUT_COMPILER=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}\"")
endfunction()
