# SPDX-License-Identifier: Apache-2.0
# Components that need the SDK of a device maker, which is not in Debian and which no script can install.

# hapticut_maker_sdk(NAME "whose devices" package variable_with_its_library "what to install"): decides HAPTICUT_<NAME>
# from HAPTICUT_WITH_<NAME>, which is AUTO, ON or OFF. HAPTICUT_MAKERS are the names with an SDK on this machine,
# HAPTICUT_MAKER_PACKAGES their packages; a component has the name of its package in lower case.
macro(hapticut_maker_sdk name purpose package library install)
  set_property(CACHE HAPTICUT_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(HAPTICUT_${name} FALSE)
  if(HAPTICUT_WITH_${name})
    find_package(${package} QUIET MODULE)
    if(${package}_FOUND)
      set(HAPTICUT_${name} TRUE)
      list(APPEND HAPTICUT_MAKERS ${name})
      list(APPEND HAPTICUT_MAKER_PACKAGES ${package})
      list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: on  (${purpose}, ${${library}})")
    elseif(NOT HAPTICUT_WITH_${name} STREQUAL "AUTO")
      message(FATAL_ERROR "HAPTICUT_WITH_${name}=ON, but the SDK was not found: install ${install}, or set ${package}_ROOT.")
    else()
      list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: off (${purpose}, to turn it on: docs/devices.md)")
    endif()
  else()
    list(APPEND HAPTICUT_COMPONENT_REPORT "${name}: off (${purpose}, HAPTICUT_WITH_${name}=OFF)")
  endif()
endmacro()

# hapticut_use_maker_devices(target): defines the macros of device/use_maker_devices.hpp, and links the components.
function(hapticut_use_maker_devices target)
  foreach(name IN LISTS HAPTICUT_MAKERS)
    string(TOLOWER ${name} component)
    target_compile_definitions(${target} PRIVATE HAPTICUT_HAS_${name})
    target_link_libraries(${target} PRIVATE hapticut::${component})
  endforeach()
endfunction()

# hapticut_device_adapter(component NAME SDK_TARGET sources...): a separate library for the component, because building
# and linking it needs the SDK. The tests build the same sources, HAPTICUT_<NAME>_SOURCES, with the headers in
# HAPTICUT_<NAME>_HEADERS, against a stand-in.
function(hapticut_device_adapter component name sdk)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE sources)
  set_property(GLOBAL PROPERTY HAPTICUT_${name}_SOURCES "${sources}")
  set_property(GLOBAL PROPERTY HAPTICUT_${name}_HEADERS "${CMAKE_CURRENT_SOURCE_DIR}/include")
  if(HAPTICUT_${name})
    add_library(hapticut_${component} ${sources})
    add_library(hapticut::${component} ALIAS hapticut_${component})
    target_include_directories(hapticut_${component} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
      PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/drivers)
    target_link_libraries(hapticut_${component} PUBLIC hapticut PRIVATE ${sdk} $<BUILD_INTERFACE:hapticut_build_flags>)
    set_target_properties(hapticut_${component} PROPERTIES POSITION_INDEPENDENT_CODE ON VERSION ${PROJECT_VERSION}
      SOVERSION 0)
  endif()
endfunction()
