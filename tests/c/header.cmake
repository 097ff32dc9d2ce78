# SPDX-License-Identifier: Apache-2.0
# Compiles the header of the C interface as C and C++: cmake -DINCLUDE=... -DWORK=... -DCC=... -DCXX=... -P header.cmake
file(MAKE_DIRECTORY "${WORK}")
set(twice "#include <hapticut/c/hapticut.h>\n#include <hapticut/c/hapticut.h>\n")
file(WRITE "${WORK}/use.c" "${twice}unsigned f(void);\n"
  "unsigned f(void) { hapticut_step_input input = {.struct_size = sizeof input}; return input.struct_size; }\n")
file(WRITE "${WORK}/use.cpp" "${twice}"
  "unsigned f() { hapticut_step_input input{}; input.struct_size = sizeof input; return input.struct_size; }\n")
function(compile)
  execute_process(COMMAND ${ARGN} "-I${INCLUDE}" -Wall -Wextra -Wpedantic -Werror -fsyntax-only COMMAND_ERROR_IS_FATAL ANY)
  math(EXPR done "${done} + 1")
  set(done ${done} PARENT_SCOPE)
endfunction()
set(done 0)
compile("${CC}" -std=c99 "${WORK}/use.c")
compile("${CC}" -std=c17 "${WORK}/use.c")
compile("${CXX}" -std=c++17 -fno-exceptions -fno-rtti "${WORK}/use.cpp")
# Unreal compiles the header with clang++ and libc++, without exceptions and RTTI.
find_program(clang NAMES clang++)
if(clang)
  compile("${clang}" -std=c++17 -fno-exceptions -fno-rtti "${WORK}/use.cpp")
  compile("${clang}" -std=c99 -x c "${WORK}/use.c")
  file(WRITE "${WORK}/with_libcxx.cpp" "#include <vector>\n#include \"use.cpp\"\n#ifndef _LIBCPP_VERSION\n#error not libc++\n#endif\n")
  file(WRITE "${WORK}/libcxx.cpp" "#include <vector>\n")
  execute_process(COMMAND "${clang}" -std=c++17 -stdlib=libc++ -fsyntax-only "${WORK}/libcxx.cpp" RESULT_VARIABLE no_libcxx
    OUTPUT_QUIET ERROR_QUIET)
  if(no_libcxx EQUAL 0)
    compile("${clang}" -std=c++17 -stdlib=libc++ -fno-exceptions -fno-rtti "${WORK}/with_libcxx.cpp")
  else()
    message("not compiled with libc++, which is missing: apt-get install libc++-dev libc++abi-dev")
  endif()
endif()
message("compiled ${done} times")
