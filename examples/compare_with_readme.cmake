# SPDX-License-Identifier: Apache-2.0
# Fails unless README.md contains the example word for word, without the licence line.
file(READ "${README}" readme)
file(READ "${EXAMPLE}" example)
string(REGEX REPLACE "^// SPDX[^\n]*\n" "" example "${example}")
string(FIND "${readme}" "${example}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${README} does not show ${EXAMPLE} word for word; copy the example into the README.")
endif()
