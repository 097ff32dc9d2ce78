# SPDX-License-Identifier: Apache-2.0
# Compiles a program and runs it with a library and the path of the C header as argument:
# cmake -DPROGRAM=a.cs;b.cs -DSAYS=... -DWORK=... -DLIBRARY=... -P run.cmake
cmake_minimum_required(VERSION 3.25)
find_program(MCS mcs)
find_program(MONO mono)
if(NOT MCS OR NOT MONO)
  message("SKIPPED: mono and its compiler are missing; apt-get install mono-runtime mono-mcs.")
  return()
endif()
file(MAKE_DIRECTORY "${WORK}")
execute_process(COMMAND "${MCS}" -warnaserror -nowarn:649 "-out:${WORK}/program.exe" ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
get_filename_component(folder "${LIBRARY}" DIRECTORY)
execute_process(COMMAND "${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${folder}:$ENV{LD_LIBRARY_PATH}" "${MONO}"
  "${WORK}/program.exe" "${CMAKE_CURRENT_LIST_DIR}/../../../include/hapticut/c/types.h" OUTPUT_VARIABLE said ERROR_VARIABLE complained RESULT_VARIABLE result)
message("${said}")
if(NOT result EQUAL 0 OR NOT said MATCHES "${SAYS}")
  message(FATAL_ERROR "mono ended with ${result} and said: ${said}${complained}")
endif()
