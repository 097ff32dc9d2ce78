# SPDX-License-Identifier: Apache-2.0
# Tests of the package in projects outside hapticut. Not part of sanitizer builds, because the outside projects would
# need the same flags.
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT HAPTICUT_INSTALL)
  return()
endif()
function(hapticut_package_test name case)
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" -DCASE=${case} "-DSOURCE=${PROJECT_SOURCE_DIR}"
    "-DBUILD=${PROJECT_BINARY_DIR}" "-DWORK=${PROJECT_BINARY_DIR}/consumer/${case}" "-DCXX=${CMAKE_CXX_COMPILER}"
    "-DCC=${CMAKE_C_COMPILER}" "-DWITH_IO=${HAPTICUT_IMPORT}" "-DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    -P "${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake")
  set_tests_properties(${name} PROPERTIES LABELS "package;slow" TIMEOUT 900 SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()
hapticut_package_test(Package.IsFoundLinkedAndRunByAnOutsideProject installed)
set_tests_properties(Package.IsFoundLinkedAndRunByAnOutsideProject PROPERTIES LABELS package)
hapticut_package_test(Package.LetsAnOutsideProjectLinkWhatComesWithTheCore with_core)
hapticut_package_test(Package.HasExamplesThatBuildFromItsDocumentation examples)
hapticut_package_test(Package.HasPhysicsThatLinkNothingAndNeedNoOpenVDB physics)
hapticut_package_test(Package.LetsAnOutsideProjectUseItsOwnGrids openvdb)
if(HAPTICUT_IO)
  hapticut_package_test(Package.LetsAnOutsideProjectRecordAndReplay io)
endif()
if(HAPTICUT_IMPORT)
  hapticut_package_test(Package.LetsAnOutsideProjectReadAndWriteFiles import)
endif()
if(HAPTICUT_C)
  hapticut_package_test(Package.HasACInterfaceThatNeedsNeitherEigenNorOpenVDB c)
endif()
if(HAPTICUT_SETTINGS)
  hapticut_package_test(Package.LetsAnOutsideProjectReadAScene settings)
endif()
hapticut_package_test(Package.LetsAnOutsideProjectLinkOnlyWhatAgreesWithIt abi)
hapticut_package_test(Package.SaysThatItWasBuiltWithoutAComponent no_io)
hapticut_package_test(Package.CanBeAddedAsASubdirectory subdirectory)
if(HAPTICUT_CLI)
  hapticut_package_test(Package.BuildsItsProgramWithoutIo program_without_io)
  set_tests_properties(Package.BuildsItsProgramWithoutIo PROPERTIES FIXTURES_REQUIRED subdirectory)
  set_tests_properties(Package.CanBeAddedAsASubdirectory PROPERTIES FIXTURES_SETUP subdirectory)
endif()
hapticut_package_test(Package.GivesTheSameForceToAProgramCompiledForAvx avx)
hapticut_package_test(Package.NamesTheDebianPackageOfAMissingOpenVDB no_openvdb)
# Each configuration builds library, C interface and program, most objects of which ccache knows from this build.
function(hapticut_configuration_test name)
  cmake_parse_arguments(ARG "" "" "WITHOUT;HIDDEN;OPTIONS" ${ARGN})
  set(lists "")
  foreach(list WITHOUT HIDDEN OPTIONS)
    list(JOIN ARG_${list} "," value)
    list(APPEND lists "-D${list}=${value}")
  endforeach()
  add_test(NAME Package.IsWhole${name} COMMAND "${CMAKE_COMMAND}" ${lists} "-DKERNELS=${HAPTICUT_KERNELS}"
    "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DBUILD=${PROJECT_BINARY_DIR}/../whole_${name}" "-DCXX=${CMAKE_CXX_COMPILER}"
    "-DCC=${CMAKE_C_COMPILER}" "-DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    -P "${PROJECT_SOURCE_DIR}/tests/consumer/configuration.cmake")
  set_tests_properties(Package.IsWhole${name} PROPERTIES LABELS "package;slow" TIMEOUT 1800 RUN_SERIAL ON)
endfunction()
if(NOT BUILD_SHARED_LIBS)
  set(all SIMD IO IMPORT ITK ASSIMP SETTINGS C VIEW CLI)
  hapticut_configuration_test(AfterTheDemo HIDDEN ITK ASSIMP OPTIONS -DHAPTICUT_WITH_EXAMPLES=ON)
  hapticut_configuration_test(WithoutSimd WITHOUT SIMD)
  hapticut_configuration_test(WithoutIo WITHOUT IO IMPORT ITK ASSIMP)
  hapticut_configuration_test(WithoutImport WITHOUT IMPORT ITK ASSIMP)
  hapticut_configuration_test(WithoutItk WITHOUT ITK)
  hapticut_configuration_test(WithoutAssimp WITHOUT ASSIMP)
  hapticut_configuration_test(WithoutSettings WITHOUT SETTINGS)
  hapticut_configuration_test(WithoutC WITHOUT C)
  hapticut_configuration_test(WithoutView WITHOUT VIEW)
  hapticut_configuration_test(WithoutProgram WITHOUT CLI)
  hapticut_configuration_test(AsCoreAlone WITHOUT ${all})
  hapticut_configuration_test(AsCoreAloneFileByFile WITHOUT ${all}
    OPTIONS -DCMAKE_UNITY_BUILD=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O0)
  hapticut_configuration_test(AsSharedCoreAlone WITHOUT ${all} OPTIONS -DBUILD_SHARED_LIBS=ON)
endif()
# Each component is configured, built and tested with nothing but what it needs; the components that come with the core,
# together.
function(hapticut_alone_test name folders)
  list(JOIN ARGN "," components)
  add_test(NAME Package.Has${name}ThatStandsAlone COMMAND "${CMAKE_COMMAND}" "-DCOMPONENTS=${components}"
    "-DFOLDERS=${folders}" "-DKERNELS=${HAPTICUT_KERNELS}" "-DSOURCE=${PROJECT_SOURCE_DIR}"
    "-DBUILD=${PROJECT_BINARY_DIR}/../alone_${name}"
    "-DCXX=${CMAKE_CXX_COMPILER}" "-DCC=${CMAKE_C_COMPILER}" "-DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    -P "${PROJECT_SOURCE_DIR}/tests/consumer/alone.cmake")
  set_tests_properties(Package.Has${name}ThatStandsAlone PROPERTIES LABELS "package;slow" TIMEOUT 1800 RUN_SERIAL ON)
endfunction()
if(NOT BUILD_SHARED_LIBS)
  hapticut_alone_test(Io io IO)
  hapticut_alone_test(Import import IO IMPORT)
  hapticut_alone_test(Settings settings SETTINGS)
  hapticut_alone_test(C c C)
  hapticut_alone_test(View view VIEW)
  list(JOIN HAPTICUT_COMPONENTS_WITH_CORE "," with_core)
  hapticut_alone_test(Core "${with_core}")
  foreach(driver IN LISTS HAPTICUT_DRIVERS)
    get_filename_component(folder "${driver}" NAME)
    string(REPLACE "_" ";" words "${folder}")
    set(name DriverOf)
    foreach(word IN LISTS words)  # DriverOfForceDimension
      string(SUBSTRING "${word}" 0 1 initial)
      string(SUBSTRING "${word}" 1 -1 others)
      string(TOUPPER "${initial}" initial)
      string(APPEND name "${initial}${others}")
    endforeach()
    hapticut_alone_test(${name} ${folder})
  endforeach()
endif()
add_test(NAME Package.EveryOptionalPackageIsInstalledByTheScript COMMAND "${CMAKE_COMMAND}"
  "-DOPTIONS=${PROJECT_SOURCE_DIR}/cmake/HapticutOptions.cmake" "-DSCRIPT=${PROJECT_SOURCE_DIR}/scripts/install-deps.sh"
  -P "${PROJECT_SOURCE_DIR}/tests/consumer/compare_package_lists.cmake")
add_test(NAME Package.EveryOptionIsInTheReadme COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${PROJECT_SOURCE_DIR}"
  -P "${PROJECT_SOURCE_DIR}/tests/consumer/compare_options_with_readme.cmake")
