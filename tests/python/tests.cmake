# SPDX-License-Identifier: Apache-2.0
# The Python tests: on the package of this build if HAPTICUT_WITH_PYTHON is ON, and on a package that pip builds and
# installs into a new environment. Not part of sanitizer builds, because Python lacks their flags.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  return()
endif()
if(HAPTICUT_PYTHON)
  add_test(NAME Python.PassesItsTestsInTheBuildFolder COMMAND "${PROJECT_SOURCE_DIR}/tests/python/of_build.sh"
    "${Python_EXECUTABLE}" "${PROJECT_BINARY_DIR}/bindings/python")
  set_tests_properties(Python.PassesItsTestsInTheBuildFolder PROPERTIES LABELS python TIMEOUT 900 COST 100
    SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endif()
add_test(NAME Python.InstallsInAFreshEnvironmentAndPassesItsTests
  COMMAND "${PROJECT_SOURCE_DIR}/tests/python/in_fresh_environment.sh" "${PROJECT_BINARY_DIR}/python/default")
set_tests_properties(Python.InstallsInAFreshEnvironmentAndPassesItsTests PROPERTIES LABELS "python;slow" TIMEOUT 1800
  PROCESSORS 2 SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
