#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks a change: installs missing packages, checks the format, builds library, program, tests, examples, benchmarks and
# the Python package in release mode, and runs every test without the label slow. The last line is
# `N passed, N failed, N skipped`; it counts tests of GoogleTest, tests of ctest and the checks. It is missing only when
# packages cannot be installed. The lines above it show the seconds of each stage. The exit code is 0 only when nothing
# failed.
#
#   scripts/test.sh [--full | --only STAGE] [--no-install] [--jobs N]
#
#   --full        everything: the above with every instruction set, the slow tests, and the stages below
#   --only STAGE  only one stage:
#                 address  the unit and contract tests and 10^5 composed ticks, with clang++ and its sanitizers for
#                          addresses and undefined behaviour; also compiles library, program, examples and benchmarks
#                 threads  the tests of data exchange between threads, with the thread sanitizer
#                 lint     clang-tidy on every source of the library
#                 package  the package in external projects, with each component off, as shared libraries with clang++, for ARM
#                 python   the Python package installed by pip, and its tests
#                 fuzz     20 000 damaged files, and 20 s of the fuzzer of each format
#   --no-install  do not install packages
#   --jobs N      run N compilers and tests at once (default: one per processor)
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

all_stages=(address threads lint package python fuzz)
stages=()
fast=true
full=false
install=true
jobs=$(nproc)
drivers=(drivers/*/sdk.cmake)
drivers=("${drivers[@]%/sdk.cmake}")
drivers=("${drivers[@]#drivers/}")
while [ $# -gt 0 ]; do
  case $1 in
    --full)
      fast=true
      full=true
      stages=("${all_stages[@]}")
      ;;
    --only)
      printf '%s\n' "${all_stages[@]}" | grep -xF -- "${2:-}" >/dev/null ||
        { echo "test.sh: --only needs a stage: ${all_stages[*]}." >&2; exit 2; }
      fast=false
      full=false
      stages=("$2")
      shift
      ;;
    --no-install) install=false ;;
    --jobs)
      jobs=${2:-}
      [[ $jobs =~ ^[1-9][0-9]*$ ]] || { echo "test.sh: --jobs needs a number, e.g. --jobs 2." >&2; exit 2; }
      shift
      ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "scripts/${0##*/}"
      exit 0
      ;;
    *)
      echo "test.sh: unknown option $1; see scripts/test.sh --help." >&2
      exit 2
      ;;
  esac
  shift
done

logs=$PWD/out/test
findings=$PWD/out/fuzz # keeps inputs with findings
rm -rf "$logs"
mkdir -p "$logs"
passed=0
failed=0
skipped=0
failures=()
skips=()
times=()

# record_time NAME STARTED: adds a line to the table of times.
record_time() { times+=("$(printf '%5d s  %s' $((SECONDS - $2)) "$1")"); }

# check NAME COMMAND...: runs one check; its output goes to a file and is shown only on failure.
check() {
  local name=$1 started=$SECONDS
  shift
  local log="$logs/${name//[^a-zA-Z0-9]/-}.log"
  "$@" >"$log" 2>&1
  local status=$?
  record_time "$name" "$started"
  if [ $status -eq 0 ]; then
    passed=$((passed + 1))
    printf 'ok      %s (%d s)\n' "$name" $((SECONDS - started))
  else
    failed=$((failed + 1))
    failures+=("$name")
    printf 'FAILED  %s (%d s); the end of %s:\n' "$name" $((SECONDS - started)) "$log"
    tail -n 60 "$log"
    return 1
  fi
}

# run_tests NAME PRESET ARGUMENTS...: runs the tests of one build and counts each.
run_tests() {
  local name=$1 preset=$2 started=$SECONDS failed_before=$failed status kind test reason
  shift 2
  rm -rf "build/$preset/reports"
  ctest --preset "$preset" -j "$jobs" --output-junit "$logs/$name.xml" "$@"
  status=$?
  record_time "tests: $name" "$started"
  while IFS=$'\t' read -r kind test reason; do
    case $kind in
      passed) passed=$((passed + 1)) ;;
      failed)
        failed=$((failed + 1))
        failures+=("$name: $test")
        ;;
      skipped)
        skipped=$((skipped + 1))
        skips+=("$name: $test: $reason")
        ;;
    esac
  done < <(tests/support/count_tests.py "$logs/$name.xml" "build/$preset/reports" ||
    printf 'failed\tits reports cannot be counted\t\n')
  if [ $status -ne 0 ] && [ "$failed" -eq "$failed_before" ]; then
    failed=$((failed + 1))
    failures+=("$name: ctest ended with code $status")
  fi
}

parts=()
for part in SIMD IO IMPORT ITK ASSIMP SETTINGS C VIEW CLI TESTS BENCHMARKS EXAMPLES; do parts+=("-DHAPTICUT_WITH_$part=ON"); done
configure() { cmake --preset "$1" -UHAPTICUT_PROPERTY_PARAMETERS "${parts[@]}" "${@:2}"; }
build() { cmake --build --preset "$1" -j "$jobs" "${@:2}"; }

# format_is_clean: finds code that clang-format would change, and the marks of a failed merge.
format_is_clean() {
  ! git grep -nE '^(<<<<<<<|>>>>>>>) ' &&
    git ls-files -z --cached --others --exclude-standard -- '*.hpp' '*.inl' '*.cpp' '*.h' '*.c' | xargs -0 clang-format --dry-run --Werror
}

build_release() { check "configure" configure release -DHAPTICUT_WITH_PYTHON=OFF "$@" && check "build" build release; }

# ended_well STATUS LOG: shows the log of a background job and returns its status.
ended_well() {
  cat "$2"
  return "$1"
}

# build_all OPTIONS...: builds everything; pip fetches the packages of the Python tests meanwhile.
build_all() {
  local environment status python=$PWD/build/python-environment/bin/python
  tests/python/environment.sh build/python-environment build/release >"$logs/environment.log" 2>&1 &
  environment=$!
  build_release "$@" || { wait $environment; return 1; }
  wait $environment
  status=$?
  if [ $status -eq 77 ]; then
    skipped=$((skipped + 1))
    skips+=("the tests of Python: $(tail -n 1 "$logs/environment.log")")
    return 0
  fi
  check "environment: Python" ended_well $status "$logs/environment.log" &&
    check "configure: Python" configure release "$@" -DHAPTICUT_WITH_PYTHON=ON "-DPython_EXECUTABLE=$python" \
    "-Dpybind11_DIR=$("$python" -m pybind11 --cmakedir)" && check "build: Python" build release && return
  cmake -DHAPTICUT_WITH_PYTHON=OFF build/release >/dev/null # the other tests continue
}

# Property tests run with a tenth of their random inputs, which differ in numbers, not in memory accesses.
address() {
  check "configure: address" configure address "-DHAPTICUT_PROPERTY_PARAMETERS=seed=1 max_success=10" &&
    check "build: address" build address &&
    run_tests address address -LE slow &&
    check "composed ticks: address" build/address/tests/system/test_coupling '--gtest_filter=Composed*'
}

# Only tests of data exchange between threads; the library is built without its optional components.
threads() {
  check "configure: threads" cmake --preset threads &&
    check "build: threads" build threads -t test_realtime test_loop test_islands test_device "${drivers[@]/#/test_}" test_device_contract test_safety test_view &&
    run_tests threads threads
}

# Checks one unity build per folder, which parses third-party headers a quarter as often. Two checks are off, because they
# would treat the sources of a folder as headers. The build of `package` shows that each file includes its headers. Device
# adapters are compiled against stand-ins for their SDKs, as in their tests. Sources that replace a part of this build
# (src/kernels/scalar_kernels.cpp) are not checked.
lint_is_clean() {
  local not_in_rooms=-bugprone-suspicious-include,-google-global-names-in-headers rooms
  cmake --build --preset lint -t hapticut_commit || return
  mapfile -t rooms < <(grep -oE '"file": "[^"]+"' build/lint/compile_commands.json | cut -d '"' -f 4 | sort -u |
    while IFS= read -r file; do printf '%s\n' "${file#"$PWD/"}"; done |
    grep -E '^(build/lint/)?(src|drivers|apps)/.*[.]c(pp|xx)$|_under_test[.]dir/Unity/' | grep -v '^drivers/.*/tests/')
  [ ${#rooms[@]} -gt 0 ] || { echo "build/lint/compile_commands.json names no source of this folder"; return 1; }
  printf '%s\0' "${rooms[@]}" | xargs -0 -n 1 -P "$jobs" clang-tidy -p build/lint --quiet "--checks=$not_in_rooms"
}
lint() { check "configure: lint" configure lint && check "clang-tidy" lint_is_clean; }

package() {
  local rest=()
  if $fast; then rest=(-L slow); else build_release || return; fi
  run_tests package release -L package "${rest[@]}"
  check "configure: shared" configure shared &&
    check "build: shared" build shared -t src/all apps/page/all apps/cli/all examples/all "${drivers[@]/%/_under_test}" &&
    run_tests shared shared
}

python() {
  $fast || check "configure" configure release || return
  run_tests python release -L python -L slow
}

# fuzz_format FORMAT: runs the fuzzer of a format, from the seeds of this project. Its log has the number of inputs.
fuzz_format() {
  mkdir -p "$logs/corpus/$1"
  ASAN_OPTIONS=allocator_may_return_null=1 "build/fuzz/tests/fuzz/fuzz_$1" -max_total_time=20 -timeout=20 \
    -rss_limit_mb=4096 -artifact_prefix="$findings/$1-" "$logs/corpus/$1" "$logs/seeds/$1" >"$logs/fuzz-$1.log" 2>&1 ||
    { tail -n 40 "$logs/fuzz-$1.log"; return 1; }
}
fuzz_all() {
  export -f fuzz_format
  export logs findings
  local fuzzer
  for fuzzer in build/fuzz/tests/fuzz/fuzz_*; do
    [ -x "$fuzzer" ] && printf '%s\n' "${fuzzer##*/fuzz_}"
  done | xargs -P "$jobs" -I FORMAT bash -c 'fuzz_format FORMAT'
}
# Makes different mutants in each run. The log ends with the command that repeats them.
mutants() {
  local seed=$RANDOM status
  build/release/tests/fuzz/hapticut_mutants 20000 "$seed" "$findings/mutants"
  status=$?
  echo "repeat with: build/release/tests/fuzz/hapticut_mutants 20000 $seed"
  return $status
}
fuzz() {
  mkdir -p "$findings"
  $fast || check "configure" configure release || return
  check "build: mutants" build release -t hapticut_mutants || return
  check "mutants" mutants
  check "seeds" build/release/tests/fuzz/hapticut_mutants --seeds "$logs/seeds" &&
    check "configure: fuzz" cmake --preset fuzz && check "build: fuzz" build fuzz -t fuzzers && check "fuzzers" fuzz_all
}

if $install; then
  started=$SECONDS
  scripts/install-deps.sh --for test || exit 1
  record_time "packages" "$started"
fi

if $fast; then
  check "format" format_is_clean
  kernels=NATIVE
  $full && kernels=ALL
  if build_all "-DHAPTICUT_KERNELS=$kernels"; then
    run_tests fast release -LE slow
    $full && run_tests slow release -L slow -LE 'package|python'
  fi
fi
for stage in ${stages[@]+"${stages[@]}"}; do "$stage"; done

echo
for name in ${skips[@]+"${skips[@]}"}; do echo "skipped: $name"; done
for name in ${failures[@]+"${failures[@]}"}; do echo "failed:  $name"; done
for time in ${times[@]+"${times[@]}"}; do echo "$time"; done
printf '%5d s  in total\n' "$SECONDS"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
