# SPDX-License-Identifier: Apache-2.0
# Runs an example. Fails unless it ends with code 0 and its output matches a regular expression:
# cmake -DPROGRAM=program -DPRINTS=expression -P run_example.cmake
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
message("${output}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "it ended with ${result}")
endif()
if(NOT output MATCHES "${PRINTS}")
  message(FATAL_ERROR "it did not print: ${PRINTS}")
endif()
