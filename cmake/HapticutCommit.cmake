# SPDX-License-Identifier: Apache-2.0
# A script that runs at every build. Writes the git commit into a small header if it has changed, so a new commit
# recompiles one file.
#   cmake -DSOURCE_DIR=... -DOUTPUT=.../hapticut_commit.hpp -P HapticutCommit.cmake

set(commit "")
find_program(git git)
if(git)
  # A copy inside another repository must not use the commit of that repository.
  execute_process(COMMAND "${git}" rev-parse --show-toplevel WORKING_DIRECTORY "${SOURCE_DIR}"
                  OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(top STREQUAL SOURCE_DIR)
    execute_process(COMMAND "${git}" describe --always --dirty --abbrev=12 --exclude=* WORKING_DIRECTORY "${SOURCE_DIR}"
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()

set(text "// SPDX-License-Identifier: Apache-2.0\n#pragma once\n#define HAPTICUT_COMMIT \"${commit}\"\n")
set(before "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT text STREQUAL before)
  file(WRITE "${OUTPUT}" "${text}")
endif()
