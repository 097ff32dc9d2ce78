# SPDX-License-Identifier: Apache-2.0
# The page of `hapticut view`: built if npm is found, once per change, not per configuration. The build looks for npm
# itself, so an npm that is installed after the configuration is used.
if(NOT (HAPTICUT_VIEW AND HAPTICUT_CLI))
  return()
endif()
include("${CMAKE_CURRENT_LIST_DIR}/web_tools.cmake")
if(HAPTICUT_NPM AND HAPTICUT_NODE)
  set(HAPTICUT_PAGE TRUE)
  list(APPEND HAPTICUT_COMPONENT_REPORT "page: on  (the page of hapticut view, docs/command-line.md)")
else()
  list(APPEND HAPTICUT_COMPONENT_REPORT
    "page: off (the page of hapticut view, to turn it on: sudo apt-get install nodejs npm)")
endif()

add_custom_target(hapticut_page ALL
  COMMAND "${CMAKE_COMMAND}" -D "WEB=${CMAKE_CURRENT_LIST_DIR}/web" -D "TARGET=${PROJECT_BINARY_DIR}/web/page"
    -P "${CMAKE_CURRENT_LIST_DIR}/build_web.cmake"
  COMMENT "The page of hapticut view" VERBATIM)
