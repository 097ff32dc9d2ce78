# SPDX-License-Identifier: Apache-2.0
# Tests a find module: a project that uses it finds the stand-in of a maker's SDK. If the SDK is absent, the message says
# what to do:
#   cmake -DPACKAGE=OpenHaptics -DLIBRARY=OpenHaptics_HD_LIBRARY -DSOURCE=... -DBINARY=... -DSDK=... -DFLAGS=... -DMODULES=...
#         -DCOMPILER=... -DGENERATOR=... -P run_finder.cmake
file(REMOVE_RECURSE "${BINARY}")
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}:\n${output}")
  endif()
endfunction()
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -S "${SOURCE}" -B "${BINARY}" -DMODULES=${MODULES} -DCMAKE_CXX_COMPILER=${COMPILER}
  "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${configure} -D${PACKAGE}_ROOT=${SDK})
run(${CMAKE_COMMAND} --build "${BINARY}")
run("${BINARY}/finder")

file(REMOVE_RECURSE "${BINARY}")
# Simulates a machine without the SDK, even if this machine has one.
execute_process(COMMAND ${configure} -D${LIBRARY}=OFF
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0 OR NOT output MATCHES "${PACKAGE}_ROOT")
  message(FATAL_ERROR "the message for an absent SDK does not say what to do:\n${output}")
endif()
