# SPDX-License-Identifier: Apache-2.0
# cmake -D WEB=... -D TARGET=... -P build_web.cmake
# Builds the page in web/build if its sources have changed, and copies it to TARGET. web/node_modules keeps npm's
# downloads. Without npm or a network, the rest of the build continues.
file(MAKE_DIRECTORY "${WEB}/build")
file(LOCK "${WEB}/build/lock" GUARD PROCESS TIMEOUT 600 RESULT_VARIABLE locked)

file(GLOB_RECURSE sources LIST_DIRECTORIES false "${WEB}/src/*")
list(SORT sources)
set(content "")
foreach(source IN LISTS sources ITEMS "${WEB}/build.mjs" "${WEB}/package-lock.json")
  file(SHA256 "${source}" hash)
  string(APPEND content "${source} ${hash}\n")
endforeach()
string(SHA256 stamp "${content}")
file(SHA256 "${WEB}/package-lock.json" packages)

function(read_stamp file variable)
  set(${variable} "" PARENT_SCOPE)
  if(EXISTS "${file}")
    file(READ "${file}" text)
    set(${variable} "${text}" PARENT_SCOPE)
  endif()
endfunction()

function(give_up why)
  file(REMOVE "${TARGET}/stamp")
  message(NOTICE "The page of hapticut view was not built: ${why} Everything else is complete.")
endfunction()

include("${CMAKE_CURRENT_LIST_DIR}/web_tools.cmake")
if(NOT HAPTICUT_NPM OR NOT HAPTICUT_NODE)
  give_up("npm is missing: sudo apt-get install nodejs npm.")
  return()
endif()

read_stamp("${WEB}/node_modules/.hapticut-packages" installed)
if(NOT installed STREQUAL packages)
  execute_process(COMMAND "${HAPTICUT_NPM}" ci --no-audit --no-fund --loglevel=error WORKING_DIRECTORY "${WEB}"
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    give_up("`npm ci` in ${WEB} failed. It needs a network once; run it there to see why.")
    return()
  endif()
  file(WRITE "${WEB}/node_modules/.hapticut-packages" "${packages}")
endif()

read_stamp("${WEB}/build/page/stamp" built)
if(NOT built STREQUAL stamp)
  file(REMOVE_RECURSE "${WEB}/build/page")
  execute_process(COMMAND "${HAPTICUT_NODE}" build.mjs WORKING_DIRECTORY "${WEB}" RESULT_VARIABLE failed ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "the page cannot be built:\n${output}")
  endif()
  file(WRITE "${WEB}/build/page/stamp" "${stamp}")
endif()

read_stamp("${TARGET}/stamp" copied)
if(NOT copied STREQUAL stamp)
  file(REMOVE_RECURSE "${TARGET}")
  file(COPY "${WEB}/build/page/" DESTINATION "${TARGET}")
endif()
