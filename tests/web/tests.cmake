# SPDX-License-Identifier: Apache-2.0
# The page: its own logic in node, and all of it in Debian's chromium, beside a program that drills.
if(NOT HAPTICUT_PAGE OR CMAKE_CXX_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  return()
endif()
find_program(HAPTICUT_CHROMIUM NAMES chromium chromium-browser)
mark_as_advanced(HAPTICUT_CHROMIUM)

# hapticut_page_test(name what...): skips, with what is missing, where the page could not be built or there is no browser.
function(hapticut_page_test name)
  add_test(NAME Page.${name} COMMAND "${CMAKE_COMMAND}" -E env "HAPTICUT_PROGRAM=$<TARGET_FILE:hapticut_cli>"
    "HAPTICUT_WEB=${PROJECT_SOURCE_DIR}/web" "HAPTICUT_PAGE=${PROJECT_BINARY_DIR}/web/page"
    "HAPTICUT_CHROMIUM=${HAPTICUT_CHROMIUM}" "HAPTICUT_NODE=${HAPTICUT_NODE}"
    sh "${PROJECT_SOURCE_DIR}/tests/web/run.sh" ${ARGN})
  set_tests_properties(Page.${name} PROPERTIES LABELS page TIMEOUT 600 PROCESSORS 2
    SKIP_REGULAR_EXPRESSION "(^|\n)SKIPPED: ")
endfunction()
hapticut_page_test(ItsOwnLogicIsRight logic)
hapticut_page_test(TheMouseRemovesWhatItsPathRemoves path_test.mjs)
hapticut_page_test(TheMolarIsDrilledAndEveryPanelObeys drill_test.mjs)
hapticut_page_test(OnePageLeadsAndOthersLookOn doors_test.mjs)
hapticut_page_test(MouseKeysFingersAndGamepadsUndoEachOtherNothing input_test.mjs)
set_tests_properties(Page.TheMolarIsDrilledAndEveryPanelObeys Page.OnePageLeadsAndOthersLookOn
  Page.MouseKeysFingersAndGamepadsUndoEachOtherNothing PROPERTIES LABELS "page;slow")
# By hand: HAPTICUT_PROGRAM=... tests/web/run.sh drill_test.mjs, with the variables above.
