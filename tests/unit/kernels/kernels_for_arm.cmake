# SPDX-License-Identifier: Apache-2.0
# Tests that the kernels compile for ARM with the options of src/CMakeLists.txt.
find_program(HAPTICUT_ARM_COMPILER aarch64-linux-gnu-g++)
find_path(HAPTICUT_HWY_FOLDER hwy/highway.h)
mark_as_advanced(HAPTICUT_ARM_COMPILER HAPTICUT_HWY_FOLDER)
if(HAPTICUT_ARM_COMPILER AND HAPTICUT_HWY_FOLDER)
  # A folder with Highway alone: Highway's own folder has the system's headers too, which the cross compiler cannot use.
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/arm")
  file(MAKE_DIRECTORY "${folder}")
  file(CREATE_LINK "${HAPTICUT_HWY_FOLDER}/hwy" "${folder}/hwy" SYMBOLIC)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_test(NAME KernelsForArm.Compile COMMAND "${HAPTICUT_ARM_COMPILER}" -std=gnu++20 -O1 -march=armv8-a+crypto -Wall -Wextra
    -DHWY_SHARED_DEFINE -I "${PROJECT_SOURCE_DIR}/include" -I "${PROJECT_SOURCE_DIR}/src" -I "${PROJECT_BINARY_DIR}/include"
    -isystem "${folder}" -isystem "${eigen}" -c "${PROJECT_SOURCE_DIR}/src/kernels/targets/baseline.cpp" -o "${folder}/baseline.o")
else()
  add_test(NAME KernelsForArm.Compile COMMAND "${CMAKE_COMMAND}" -E echo
    "SKIPPED: needs a compiler for ARM, aarch64-linux-gnu-g++ (Debian package g++-aarch64-linux-gnu)")
endif()
set_tests_properties(KernelsForArm.Compile PROPERTIES LABELS "package;slow" TIMEOUT 900 SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
