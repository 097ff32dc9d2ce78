# SPDX-License-Identifier: Apache-2.0
# The Python package as its users meet it: installed by pip into a new environment. Not part of sanitizer builds, whose
# flags pip's build does not share.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  return()
endif()
add_test(NAME Python.InstallsInAFreshEnvironmentAndPassesItsTests
  COMMAND "${PROJECT_SOURCE_DIR}/tests/python/in_fresh_environment.sh" "${PROJECT_BINARY_DIR}/python/default")
set_tests_properties(Python.InstallsInAFreshEnvironmentAndPassesItsTests PROPERTIES LABELS python TIMEOUT 1800
  PROCESSORS 2 SKIP_REGULAR_EXPRESSION "SKIPPED: ")
