# SPDX-License-Identifier: Apache-2.0
# The page of `hapticut view`: built if npm is found, once per change, not per configuration.
if(NOT (HAPTICUT_VIEW AND HAPTICUT_CLI))
  return()
endif()
find_program(HAPTICUT_NPM npm)
find_program(HAPTICUT_NODE NAMES node nodejs)
mark_as_advanced(HAPTICUT_NPM HAPTICUT_NODE)
if(NOT HAPTICUT_NPM OR NOT HAPTICUT_NODE)
  list(APPEND HAPTICUT_COMPONENT_REPORT
    "page: off (the page of hapticut view, to turn it on: sudo apt-get install nodejs npm)")
  return()
endif()
set(HAPTICUT_PAGE TRUE)
list(APPEND HAPTICUT_COMPONENT_REPORT "page: on  (the page of hapticut view, docs/command-line.md)")

add_custom_target(hapticut_page ALL
  COMMAND "${CMAKE_COMMAND}" -D "NPM=${HAPTICUT_NPM}" -D "NODE=${HAPTICUT_NODE}" -D "WEB=${PROJECT_SOURCE_DIR}/web"
    -D "TARGET=${PROJECT_BINARY_DIR}/web/page" -P "${CMAKE_CURRENT_LIST_DIR}/BuildPage.cmake"
  COMMENT "The page of hapticut view" VERBATIM)
if(HAPTICUT_INSTALL)
  include(GNUInstallDirs)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/web/page/" DESTINATION "${CMAKE_INSTALL_DATADIR}/hapticut/web" OPTIONAL)
endif()
