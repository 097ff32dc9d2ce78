# SPDX-License-Identifier: Apache-2.0
# Runs commands: `code` and `output` are set to the result. `must` ends the script with the output of one that fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
  set(code "${code}" PARENT_SCOPE)
endfunction()
macro(must)
  run(${ARGN})
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed with ${code}: ${ARGN}\n${output}")
  endif()
endmacro()
