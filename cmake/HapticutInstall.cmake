# SPDX-License-Identifier: Apache-2.0
# `cmake --install`, and the package that `find_package(hapticut)` finds.

if(NOT HAPTICUT_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)

set(HAPTICUT_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/hapticut")

# Refuses to install a part of the targets, e.g. after scripts/demo.sh, which builds only those that it needs: files of
# the package would name libraries that do not exist.
set(_programs hapticut_cli hapticut_decoder hapticut_recording_reader)
list(TRANSFORM HAPTICUT_COMPONENTS_WITH_CORE PREPEND hapticut_ OUTPUT_VARIABLE _with_core)
string(TOLOWER "${HAPTICUT_VENDORS}" _vendors)
set(_others io settings view c ${_vendors})
list(TRANSFORM _others PREPEND hapticut_ OUTPUT_VARIABLE _libraries)
foreach(_target hapticut ${_with_core} ${_libraries} ${_programs})
  if(TARGET ${_target})
    install(CODE "if(NOT EXISTS \"$<TARGET_FILE:${_target}>\")\n  list(APPEND hapticut_absent ${_target})\nendif()")
  endif()
endforeach()
install(CODE "set(hapticut_build \"cmake --build ${CMAKE_BINARY_DIR} -t\")")
install(CODE [[
if(hapticut_absent)
  list(JOIN hapticut_absent " " hapticut_absent)
  message(FATAL_ERROR "Nothing is installed, because a part of hapticut is not built. Build it first:\n\
  ${hapticut_build} ${hapticut_absent}")
endif()]])

if(TARGET hapticut_page)
  install(CODE "set(page \"${PROJECT_BINARY_DIR}/web/page/index.html\")
set(build_page \"cmake --build ${PROJECT_BINARY_DIR} -t hapticut_page\")")
  install(CODE [[
if(NOT EXISTS "${page}")
  message(STATUS "The page of `hapticut view` is not built, so it is not installed. To have it: ${build_page}")
endif()]])
  install(DIRECTORY "${PROJECT_BINARY_DIR}/web/page/" DESTINATION "${CMAKE_INSTALL_DATADIR}/hapticut/web" OPTIONAL)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/hapticut" "${PROJECT_BINARY_DIR}/include/hapticut"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp" PATTERN "*.inl" PATTERN "*.h")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/cpp" "${PROJECT_SOURCE_DIR}/examples/c" "${PROJECT_SOURCE_DIR}/examples/python"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" PATTERN "__pycache__" EXCLUDE)

foreach(_program IN LISTS _programs)
  if(TARGET ${_program})
    set(_place "${CMAKE_INSTALL_LIBEXECDIR}/hapticut")
    if(_program STREQUAL "hapticut_cli")
      set(_place "${CMAKE_INSTALL_BINDIR}")
    endif()
    install(TARGETS ${_program} RUNTIME DESTINATION "${_place}")
  endif()
endforeach()

# A shared library is found next to its users, at any install prefix.
file(RELATIVE_PATH _from_programs "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
foreach(_target ${_with_core} ${_libraries} hapticut_cli)
  if(TARGET ${_target} AND BUILD_SHARED_LIBS)
    set_target_properties(${_target} PROPERTIES INSTALL_RPATH "$ORIGIN;$ORIGIN/${_from_programs}")
  endif()
endforeach()

# One export set per component, so the dependencies of a component are looked up only on request.
if(TARGET hapticut)
  foreach(_component IN LISTS HAPTICUT_COMPONENTS_WITH_CORE)
    set_target_properties(hapticut_${_component} PROPERTIES EXPORT_NAME ${_component})
  endforeach()
  install(TARGETS hapticut ${_with_core} EXPORT hapticutTargets)
  install(EXPORT hapticutTargets NAMESPACE hapticut:: DESTINATION "${HAPTICUT_CMAKE_DIR}")
endif()
foreach(_component physics ${_others})
  if(TARGET hapticut_${_component})
    set_target_properties(hapticut_${_component} PROPERTIES EXPORT_NAME ${_component})
    install(TARGETS hapticut_${_component} EXPORT hapticut_${_component}Targets)
    install(EXPORT hapticut_${_component}Targets NAMESPACE hapticut:: DESTINATION "${HAPTICUT_CMAKE_DIR}")
  endif()
endforeach()
if(TARGET hapticut_c)
  file(RELATIVE_PATH HAPTICUT_PREFIX_FROM_PKGCONFIG "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/hapticut_c.pc.in" "${PROJECT_BINARY_DIR}/hapticut_c.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/hapticut_c.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endif()
set(_type "")
if(TARGET hapticut)
  get_target_property(_type hapticut TYPE)
endif()
if(_type STREQUAL "STATIC_LIBRARY")
  set(HAPTICUT_IS_STATIC TRUE)
  if(HAPTICUT_SIMD)
    list(JOIN HAPTICUT_NEEDS_SIMD "\" \"" HAPTICUT_PACKAGE_NEEDS_CORE)
    set(HAPTICUT_PACKAGE_NEEDS_CORE "\"${HAPTICUT_PACKAGE_NEEDS_CORE}\"")
  endif()
else()
  set(HAPTICUT_IS_STATIC FALSE)
endif()
set(HAPTICUT_SETTINGS_NEED_IO FALSE)
if(HAPTICUT_IO)
  set(HAPTICUT_SETTINGS_NEED_IO TRUE)
endif()
set(_needs ${HAPTICUT_NEEDS_IO})
foreach(_part IN LISTS HAPTICUT_PARTS_OF_IO)
  if(HAPTICUT_${_part})
    list(APPEND _needs ${HAPTICUT_NEEDS_${_part}})
    string(TOLOWER "${_part}" _part)
    list(APPEND HAPTICUT_PACKAGE_PARTS_OF_IO "${_part}")
  endif()
endforeach()
list(JOIN HAPTICUT_NEEDS_SETTINGS "\" \"" HAPTICUT_PACKAGE_NEEDS_SETTINGS)
set(HAPTICUT_PACKAGE_NEEDS_SETTINGS "\"${HAPTICUT_PACKAGE_NEEDS_SETTINGS}\"")
list(JOIN _needs "\" \"" HAPTICUT_PACKAGE_NEEDS_IO)
set(HAPTICUT_PACKAGE_NEEDS_IO "\"${HAPTICUT_PACKAGE_NEEDS_IO}\"")
list(JOIN HAPTICUT_ITK_MODULES " " HAPTICUT_ITK_MODULES)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/hapticut-config.cmake.in"
  "${PROJECT_BINARY_DIR}/hapticut-config.cmake" INSTALL_DESTINATION "${HAPTICUT_CMAKE_DIR}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hapticut-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hapticut-config.cmake" "${PROJECT_BINARY_DIR}/hapticut-config-version.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindHapticutOpenVDB.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindHapticutHDF5.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindOpenHaptics.cmake" "${PROJECT_SOURCE_DIR}/src/device/force_dimension/FindForceDimension.cmake"
        DESTINATION "${HAPTICUT_CMAKE_DIR}")
install(FILES "${CMAKE_CURRENT_LIST_DIR}/itk/FindHDF5.cmake" DESTINATION "${HAPTICUT_CMAKE_DIR}/itk")
