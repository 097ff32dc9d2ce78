# SPDX-License-Identifier: Apache-2.0
# `cmake --install` and what `find_package(hapticut)` finds afterwards.

if(NOT HAPTICUT_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)

set(HAPTICUT_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/hapticut")

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/hapticut" "${PROJECT_BINARY_DIR}/include/hapticut"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# A shared library is found beside its users, wherever the whole is installed.
file(RELATIVE_PATH _from_programs "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
foreach(_target hapticut_bench hapticut_io hapticut_settings hapticut_view hapticut_c hapticut_cli)
  if(TARGET ${_target} AND BUILD_SHARED_LIBS)
    set_target_properties(${_target} PROPERTIES INSTALL_RPATH "$ORIGIN;$ORIGIN/${_from_programs}")
  endif()
endforeach()

# One set of exported targets per component: what a component needs is looked up only for those who ask for it.
if(TARGET hapticut)
  install(TARGETS hapticut EXPORT hapticutTargets)
  install(EXPORT hapticutTargets NAMESPACE hapticut:: DESTINATION "${HAPTICUT_CMAKE_DIR}")
endif()
foreach(_component physics bench io settings view c openhaptics forcedimension)
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
if(TARGET hapticut_cli)
  install(TARGETS hapticut_cli)
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
              "${CMAKE_CURRENT_LIST_DIR}/FindHapticutOpenVDB.cmake" "${CMAKE_CURRENT_LIST_DIR}/FindOpenHaptics.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindForceDimension.cmake"
        DESTINATION "${HAPTICUT_CMAKE_DIR}")
