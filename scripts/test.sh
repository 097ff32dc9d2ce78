#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Checks everything: installs what is missing, builds, runs every test, checks format and lint, compiles with clang++,
# runs the unit tests under the address and undefined-behaviour sanitizers (but the longest, whose code others run too),
# and the tests of what threads exchange under the thread sanitizer. The last line is `N passed, N failed, N skipped`,
# where a test is one test of ctest or one of the checks above; the exit code is 0 only when nothing failed.
#
#   scripts/test.sh [--quick] [--fuzz] [--lint-all] [--no-install] [--jobs N]
#
#   --quick       format, release build and its tests only
#   --fuzz        also run the fuzzer of each format for 60 s, and 20 000 mutants of right files
#   --lint-all    clang-tidy on every source of the library, not only on those changed in the last six hours before HEAD
#   --no-install  do not install packages
#   --jobs N      run N compilers and tests at once (default: one per processor)
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1

quick=false
fuzz=false
lint_all=false
install=true
jobs=$(nproc)
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=true ;;
    --fuzz) fuzz=true ;;
    --lint-all) lint_all=true ;;
    --no-install) install=false ;;
    --jobs)
      jobs=${2:-}
      [[ $jobs =~ ^[1-9][0-9]*$ ]] || { echo "test.sh: --jobs needs a number, e.g. --jobs 2." >&2; exit 2; }
      shift
      ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    *)
      echo "test.sh: unknown option $1; see scripts/test.sh --help." >&2
      exit 2
      ;;
  esac
  shift
done

# What ccache knows from another clone of the repository serves this one too.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true

logs=out/test
rm -rf "$logs"
mkdir -p "$logs"
passed=0
failed=0
skipped=0
failures=()
skips=()
times=()

# check NAME COMMAND...: one check; its output goes to a file and is shown only when it fails.
check() {
  local name=$1 started=$SECONDS
  shift
  local log="$logs/${name//[^a-zA-Z0-9]/-}.log"
  if "$@" >"$log" 2>&1; then
    passed=$((passed + 1))
    times+=("$name $((SECONDS - started)) s")
    printf 'ok      %s (%d s)\n' "$name" $((SECONDS - started))
  else
    failed=$((failed + 1))
    failures+=("$name")
    printf 'FAILED  %s (%d s); the end of %s:\n' "$name" $((SECONDS - started)) "$log"
    tail -n 60 "$log"
    return 1
  fi
}

# run_tests PRESET ARGUMENTS...: every test of one build, counted one by one.
run_tests() {
  local preset=$1 report started=$SECONDS
  shift
  report="$PWD/$logs/$preset.xml"
  ctest --preset "$preset" -j "$jobs" --output-junit "$report" "$@"
  local status=$? kind name reason
  times+=("tests: $preset $((SECONDS - started)) s")
  local failed_before=$failed
  while IFS=$'\t' read -r kind name reason; do
    case $kind in
      passed) passed=$((passed + 1)) ;;
      failed)
        failed=$((failed + 1))
        failures+=("$preset: $name")
        ;;
      skipped)
        skipped=$((skipped + 1))
        skips+=("$preset: $name: ${reason:-no reason given}")
        ;;
    esac
  done < <(read_report "$report")
  if [ $status -ne 0 ] && [ "$failed" -eq "$failed_before" ]; then
    failed=$((failed + 1))
    failures+=("$preset: ctest ended with code $status")
  fi
}

# read_report FILE: one line per test, `passed|failed|skipped <tab> name <tab> reason`, from CTest's JUnit file. The
# reason is what a GoogleTest test gave to GTEST_SKIP, or what another test printed after `SKIPPED: `.
read_report() {
  [ -f "$1" ] || return 0
  sed -e 's/&quot;/"/g; s/&lt;/</g; s/&gt;/>/g; s/&apos;/'"'"'/g; s/&amp;/\&/g' "$1" | awk '
    /<testcase / {
      match($0, / name="[^"]*"/); name = substr($0, RSTART + 7, RLENGTH - 8)
      match($0, / status="[^"]*"/); status = substr($0, RSTART + 9, RLENGTH - 10)
      reason = ""; collecting = 0
    }
    /^\[  SKIPPED \]/ { collecting = 0 }
    collecting && reason == "" && NF { reason = $0 }
    /: Skipped$/ { collecting = 1 }
    { at = index($0, "SKIPPED: "); if (at && reason == "") reason = substr($0, at + 9) }
    /<\/testcase>/ {
      kind = status == "run" ? "passed" : status == "fail" ? "failed" : "skipped"
      if (status == "disabled" && reason == "") reason = "switched off in its source"
      sub(/<\/system-out>.*/, "", reason)
      printf "%s\t%s\t%s\n", kind, name, reason
    }'
}

configure() {
  cmake --preset "$1" -DHAPTICUT_WITH_IO=ON -DHAPTICUT_WITH_ITK=ON -DHAPTICUT_WITH_ASSIMP=ON \
    -DHAPTICUT_WITH_SETTINGS=ON -DHAPTICUT_WITH_VIEW=ON -DHAPTICUT_WITH_CLI=ON -DHAPTICUT_WITH_TESTS=ON
}
build() { cmake --build --preset "$1" -j "$jobs" "${@:2}"; }
our_sources() { git ls-files -z -- '*.hpp' '*.cpp'; }
format_is_clean() { our_sources | xargs -0 clang-format --dry-run --Werror; }

# The sources of the library that the linter looks at: all of them, or those that are not as they were six hours
# before the last commit. A shallow clone has no such time: then all of them. What stands in for a part that this build
# has (src/kernels/scalar_kernels.cpp, src/io/volume/without_itk.cpp) is not compiled here, so it is not looked at.
sources_to_lint() {
  local base=
  $lint_all || base=$(git rev-list -1 --before="$(($(git log -1 --format=%ct) - 21600))" HEAD)
  if [ -n "$base" ]; then
    git diff -z --name-only -M50% --diff-filter=AM "$base" -- 'src/*.cpp'
  else
    git ls-files -z -- 'src/*.cpp'
  fi
}
compiled_to_lint() {
  local source
  while IFS= read -r -d '' source; do
    if grep -qF "\"file\": \"$PWD/$source\"" build/lint/compile_commands.json; then
      printf '%s\0' "$source"
    fi
  done
}
lint_is_clean() {
  cmake --build --preset lint -t hapticut_commit || return
  sources_to_lint | compiled_to_lint | xargs -0 -r -n 1 -P "$jobs" clang-tidy -p build/lint --quiet
}

# fuzz_format FORMAT: a minute of its fuzzer, from the seeds that our own writers make. The report says how many inputs ran.
fuzz_format() {
  local corpus="$PWD/$logs/corpus/$1"
  mkdir -p "$corpus"
  ASAN_OPTIONS=allocator_may_return_null=1 "build/fuzz/tests/fuzz/fuzz_$1" -max_total_time=60 -timeout=20 \
    -rss_limit_mb=4096 -artifact_prefix="$logs/$1-" "$corpus" "$logs/seeds/$1"
}

if $install; then
  scripts/install-deps.sh --for test || exit 1
fi

check "format" format_is_clean
if check "configure: release" configure release && check "build: release" build release; then
  run_tests release
fi
if ! $quick; then
  if check "configure: clang++" configure clang && check "build: clang++" build clang; then
    # The same package as shared libraries.
    run_tests clang -R '^Package\.(IsFound|LetsAnOutsideProject)'
    check "configure: clang-tidy" configure lint && check "clang-tidy" lint_is_clean
  fi
  if check "configure: sanitizers" configure asan-ubsan &&
    check "build: sanitizers" build asan-ubsan -t unit_tests test_device_contract; then
    run_tests asan-ubsan
  fi
  # Only what threads exchange: the rest of the library is built for it without its optional parts.
  if check "configure: thread sanitizer" cmake --preset tsan -DHAPTICUT_WITH_IO=OFF -DHAPTICUT_WITH_CLI=OFF -DHAPTICUT_WITH_VIEW=ON \
      -DHAPTICUT_WITH_TESTS=ON &&
    check "build: thread sanitizer" build tsan -t test_realtime test_loop test_device test_device_contract \
      test_safety test_view; then
    run_tests tsan
  fi
fi

if $fuzz; then
  check "mutants" build/release/tests/fuzz/hapticut_mutants 20000 "$RANDOM" "$logs/mutants"
  if build/release/tests/fuzz/hapticut_mutants --seeds "$logs/seeds" &&
    check "configure: fuzzers" cmake --preset fuzz && check "build: fuzzers" build fuzz -t fuzzers; then
    for folder in "$logs"/seeds/*; do
      format=${folder##*/}
      [ -x "build/fuzz/tests/fuzz/fuzz_$format" ] && check "fuzz: $format" fuzz_format "$format"
    done
  fi
fi

echo
for name in ${skips[@]+"${skips[@]}"}; do echo "skipped: $name"; done
for name in ${failures[@]+"${failures[@]}"}; do echo "failed:  $name"; done
for time in ${times[@]+"${times[@]}"}; do echo "time:    $time"; done
echo "took $((SECONDS / 60)) min $((SECONDS % 60)) s"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
