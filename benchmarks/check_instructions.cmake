# SPDX-License-Identifier: Apache-2.0
# Counts the instructions of Simulation::step under callgrind and compares them with the counts in the repository. This
# measure of speed does not depend on the load of the machine.
#   cmake -DPROGRAM=... -DWORKLOAD=... -DKERNELS=... -DVALGRIND=... -DCOUNTS=instruction_counts.json -DOUT=...
#     -P check_instructions.cmake
# With -DUPDATE=ON it prints the count without comparison.
cmake_minimum_required(VERSION 3.25)
set(tolerance 3)  # percent: effect of another minor version of the compiler or of the C++ library

execute_process(
  COMMAND ${VALGRIND} --tool=callgrind --collect-atstart=no --callgrind-out-file=${OUT}
    "--toggle-collect=hapticut::Simulation::step(hapticut::Pose const&, hapticut::Twist const&, double, hapticut::HandCoupling*)"
    ${PROGRAM} ${WORKLOAD} ${KERNELS}
  OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "callgrind failed on ${WORKLOAD}:\n${errors}")
endif()
if(output MATCHES "SKIPPED: ")
  message("${output}")
  return()
endif()
if(NOT errors MATCHES "Collected : ([0-9]+)")
  message(FATAL_ERROR "callgrind counted nothing in Simulation::step:\n${errors}")
endif()
set(count ${CMAKE_MATCH_1})
if(UPDATE)
  message("\"${WORKLOAD}\": ${count}")
  return()
endif()

file(READ ${COUNTS} counts)
string(JSON expected GET "${counts}" ${KERNELS} ${WORKLOAD})
math(EXPR difference "(${count} - ${expected}) * 1000 / ${expected}")  # per mille
message("${KERNELS} ${WORKLOAD}: ${count} instructions, expected: ${expected}, difference ${difference} per mille")
math(EXPR limit "${tolerance} * 10")
if(difference GREATER limit)
  message(FATAL_ERROR "the step needs more instructions than before. If that is intended, give the reason in the commit and put "
    "${count} into ${COUNTS}.")
endif()
math(EXPR negative "-${limit}")
if(difference LESS negative)
  message(FATAL_ERROR "the step needs fewer instructions than before: put ${count} into ${COUNTS} to keep the gain.")
endif()
