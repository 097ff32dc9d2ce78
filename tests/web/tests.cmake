# SPDX-License-Identifier: Apache-2.0
# Tests of the page: its logic in node, and the whole page in Debian's chromium, connected to a program that drills.
if(NOT HAPTICUT_PAGE OR CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  return()
endif()
find_program(HAPTICUT_CHROMIUM NAMES chromium chromium-browser)
mark_as_advanced(HAPTICUT_CHROMIUM)

# hapticut_page_test(name arguments of run.sh...): a test that skips with a message if the page or a browser is missing.
function(hapticut_page_test name)
  add_test(NAME Page.${name} COMMAND "${CMAKE_COMMAND}" -E env "HAPTICUT_PROGRAM=$<TARGET_FILE:hapticut_cli>"
    "HAPTICUT_WEB=${PROJECT_SOURCE_DIR}/apps/page/web" "HAPTICUT_PAGE=${PROJECT_BINARY_DIR}/web/page"
    "HAPTICUT_CHROMIUM=${HAPTICUT_CHROMIUM}" "HAPTICUT_NODE=${HAPTICUT_NODE}"
    sh "${PROJECT_SOURCE_DIR}/tests/web/run.sh" ${ARGN})
  set_tests_properties(Page.${name} PROPERTIES LABELS page TIMEOUT 600 PROCESSORS 2
    SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()
hapticut_page_test(UnitTestsOfItsLogicPass logic)
hapticut_page_test(TheMouseRemovesTheVolumeOfItsPath path_test.mjs)
hapticut_page_test(TheMouseDrillsAMolarAndEveryPanelWorks drill_test.mjs)
hapticut_page_test(OnePageHasControlAndOthersWatch doors_test.mjs)
hapticut_page_test(MouseKeysFingersAndGamepadsDoNotInterfere input_test.mjs)
set_tests_properties(Page.TheMouseDrillsAMolarAndEveryPanelWorks Page.OnePageHasControlAndOthersWatch
  Page.MouseKeysFingersAndGamepadsDoNotInterfere PROPERTIES LABELS "page;slow")
# To run one test without ctest: HAPTICUT_PROGRAM=... tests/web/run.sh drill_test.mjs, with the variables above.
