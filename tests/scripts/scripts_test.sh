#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the scripts and their options on a simulated machine: copies of the scripts in a temporary folder, with
# stand-ins for apt-get, dpkg-query, cmake and hapticut. Nothing is installed or built.
#
#   scripts_test.sh SOURCE CASE
set -uo pipefail
source_folder=$1
case_name=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
project=$work/project
calls=$work/calls
mkdir -p "$project" "$work/bin"
cp -r "$source_folder/scripts" "$source_folder/examples" "$project/"
: >"$calls"
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# Only these programs exist for a script under test.
for tool in bash sh sed mktemp rm grep tail env dirname mkdir nproc cat id git sort uniq; do
  ln -s "$(command -v "$tool")" "$work/bin/$tool"
done

# stand_in NAME BODY: makes a program of the simulated machine. It appends its arguments to the file of calls, then runs
# BODY.
stand_in() {
  rm -f "$work/bin/$1"
  printf '#!/bin/sh\necho "%s $*" >>"%s"\n%s\n' "$1" "$calls" "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# run SCRIPT ARGUMENTS...: runs a script and sets $code to its exit code, $out to its stdout and $errors to its stderr.
run() {
  out=$(cd "$project" && PATH=$work/bin "scripts/$1" "${@:2}" 2>"$work/errors" </dev/null)
  code=$?
  errors=$(cat "$work/errors")
}

expect_code() { [ "$code" -eq "$1" ] || fail "exit code $code instead of $1; $out $errors"; }
expect_quiet() { [ -z "$out$errors" ] || fail "unexpected output: $out $errors"; }
expect_out() { case $out in *"$1"*) ;; *) fail "stdout is '$out'; no '$1' in it" ;; esac; }
expect_one_line_error() {
  case $errors in *"$1"*) ;; *) fail "stderr is '$errors'; no '$1' in it" ;; esac
  [ "$(printf '%s\n' "$errors" | grep -c '')" -eq 1 ] || fail "more than one line: $errors"
}
expect_call() { grep -qF -- "$1" "$calls" || fail "no call '$1' among: $(cat "$calls")"; }
expect_no_call() { ! grep -qF -- "$1" "$calls" || fail "unexpected call '$1'"; }

all_installed='echo installed'
none_installed='exit 1'

case $case_name in
  help)
    for script in install-deps.sh demo.sh test.sh bench.sh; do
      # --help also works through a relative path from another folder.
      (cd "$project/scripts" && PATH=$work/bin "./$script" --help) >/dev/null 2>"$work/errors" || fail "$script: $(cat "$work/errors")"
      run "$script" --help
      expect_code 0
      expect_out "scripts/$script"
      # The help names every option that the script accepts.
      for option in $(grep -oE -- '^ +(-h \| )?--[a-z-]+( \| --[a-z-]+)*\)' "$project/scripts/$script" | grep -oE -- '--[a-z-]+'); do
        [ "$option" = --help ] || expect_out "$option"
      done
    done
    ;;
  unknown)
    for script in install-deps.sh demo.sh test.sh bench.sh; do
      for option in --nonsense extra; do
        run "$script" "$option"
        [ "$code" -ne 0 ] || fail "$script accepts $option"
        expect_one_line_error "unknown option $option; see scripts/$script --help."
      done
    done
    for script in demo.sh test.sh; do
      for number in "" 0 -1 two; do
        run "$script" --jobs $number
        expect_code 2
        expect_one_line_error "--jobs needs a number"
      done
    done
    for stage in "" everything "address threads"; do
      run test.sh --only ${stage:+"$stage"}
      expect_code 2
      expect_one_line_error "--only needs a stage: address threads lint package python fuzz."
    done
    run install-deps.sh --for
    expect_code 1
    expect_one_line_error "--for needs a group"
    run install-deps.sh --for everything
    expect_code 1
    expect_one_line_error "unknown group everything"
    [ ! -s "$calls" ] || fail "something was run: $(cat "$calls")"
    ;;
  list)
    for group in core build test demo bench; do
      run install-deps.sh --for $group --list
      expect_code 0
      [ "$(printf '%s\n' "$out" | grep -vcE '^[a-z0-9.+-]+$')" -eq 0 ] || fail "not one package a line: $out"
      [ -z "$(printf '%s\n' "$out" | sort | uniq -d)" ] || fail "$group names a package twice"
    done
    run install-deps.sh --for demo --list
    expect_out invesalius-examples
    ;;
  nothing_missing)
    stand_in dpkg-query "$all_installed"
    stand_in apt-get 'exit 1'
    for group in core build test demo bench; do
      run install-deps.sh --for $group
      expect_code 0
      expect_quiet
    done
    run install-deps.sh --check
    expect_code 0
    expect_quiet
    expect_no_call apt-get
    ;;
  check)
    stand_in dpkg-query 'case $* in *libeigen3-dev*) exit 1 ;; *) echo installed ;; esac'
    stand_in apt-get 'exit 0'
    run install-deps.sh --check
    expect_code 1
    expect_one_line_error "missing: libeigen3-dev; run scripts/install-deps.sh --for build."
    expect_no_call apt-get
    ;;
  install)
    stand_in dpkg-query 'case $* in *libeigen3-dev*) exit 1 ;; *) echo installed ;; esac'
    stand_in id 'echo 0'
    stand_in apt-get 'exit 0'
    run install-deps.sh
    expect_code 0
    expect_call "apt-get install -y -q --no-install-recommends libeigen3-dev"
    expect_no_call "apt-get update"
    # If an installation fails, the package lists are updated and the installation is tried again.
    : >"$calls"
    stand_in apt-get 'case $* in update*) : >"'"$work"'/fresh" ;; *) [ -e "'"$work"'/fresh" ] ;; esac'
    run install-deps.sh
    expect_code 0
    expect_call "apt-get update"
    ;;
  cannot_install)
    stand_in dpkg-query "$none_installed"
    stand_in id 'echo 0'
    stand_in apt-get 'echo "E: Unable to locate package libopenvdb-dev"; exit 100'
    run install-deps.sh --for core
    expect_code 1
    expect_one_line_error "E: Unable to locate package libopenvdb-dev"
    stand_in id 'echo 1000'
    run install-deps.sh --for core
    expect_code 1
    expect_one_line_error "needs root or sudo"
    rm "$work/bin/apt-get" "$work/bin/dpkg-query"
    run install-deps.sh --for core
    expect_code 1
    expect_one_line_error "not a Debian system"
    ;;
  demo)
    stand_in cmake 'mkdir -p build/release/apps/cli
cp "'"$work"'/bin/hapticut" build/release/apps/cli/hapticut'
    stand_in hapticut ':'
    ln -s "$(command -v cp)" "$(command -v chmod)" "$work/bin/"
    printf '#!/bin/sh\necho "install-deps.sh $*" >>"%s"\n' "$calls" >"$project/scripts/install-deps.sh"
    run demo.sh --jobs 3
    expect_code 0
    expect_call "install-deps.sh --for demo"
    expect_call "cmake --build --preset release -j 3 -t hapticut_cli hapticut_page"
    for name in skull molar; do
      expect_call "hapticut drill --settings examples/demo/$name.toml --json out/demo/$name.json --steps-csv out/demo/$name.csv --save out/demo/$name.vdb --surface out/demo/$name.stl --picture out/demo/$name.png"
      [ -f "$project/examples/demo/$name.toml" ] || fail "there is no examples/demo/$name.toml"
    done
    : >"$calls"
    run demo.sh --no-install
    expect_code 0
    expect_no_call install-deps.sh
    stand_in hapticut 'exit 1'
    run demo.sh --no-install
    [ "$code" -ne 0 ] || fail "demo.sh does not report a failed run"
    stand_in cmake 'echo "error: no such thing"; exit 1'
    run demo.sh --no-install
    expect_code 1
    case $errors in *"error: no such thing"*"the build failed; the output is in out/demo/build.log."*) ;; *) fail "$errors" ;; esac
    ;;
  count)
    mkdir "$work/reports"
    cat >"$work/junit.xml" <<'END'
<testsuite>
  <testcase name="tool" status="fail"><failure/><system-out>[  FAILED  ] Bur.Cuts</system-out></testcase>
  <testcase name="loop" status="fail"><system-out>[==========] Running 5 tests from 1 test suite.
[ RUN      ] Loop.Begins
[       OK ] Loop.Begins (0 ms)
[ RUN      ] Rates/Loop.Turns/1
[  FAILED  ] Rates/Loop.Turns/1, where GetParam() = 250 (12 ms)
[ RUN      ] Loop.Waits
[  SKIPPED ] Loop.Waits (0 ms)
[ RUN      ] Loop.Crashes
</system-out></testcase>
  <testcase name="sound" status="run"><system-out>[==========] Running 2 tests from 1 test suite.
[ RUN      ] Sound.Leaves
</system-out></testcase>
  <testcase name="vdb" status="run"/>
  <testcase name="heat" status="run"/>
  <testcase name="Page.Opens" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/><system-out>SKIPPED: there is no browser.</system-out></testcase>
  <testcase name="Scripts.Run" status="run"/>
  <testcase name="Package.Links" status="fail"/>
  <testcase name="Example.Heat" status="notrun"><skipped message="Unable to find executable"/></testcase>
  <testcase name="Example.Old" status="disabled"/>
</testsuite>
END
    cat >"$work/reports/tool.xml" <<'END'
<testsuites><testsuite name="Bur">
  <testcase name="Cuts" status="run" classname="Bur"><failure message="no"/></testcase>
  <testcase name="Turns" status="run" classname="Bur"/>
  <testcase name="Writes" status="notrun" classname="Bur"/>
  <testcase name="Reads" status="run" result="skipped" classname="Bur"><skipped message="a.cpp:1&#x0A;needs a file&#x0A;"/></testcase>
</testsuite></testsuites>
END
    echo '<testsuites/>' >"$work/reports/heat.xml"
    printf '<testsuites>' >"$work/reports/vdb.xml"
    said=$("$source_folder/tests/support/count_tests.py" "$work/junit.xml" "$work/reports" | tr '\t' '|')
    expected='failed|Bur.Cuts|
passed|Bur.Turns|
skipped|Bur.Writes|switched off in its source
skipped|Bur.Reads|needs a file
passed|Loop.Begins|
failed|Rates/Loop.Turns/1|
skipped|Loop.Waits|its program ended before it gave a reason
failed|loop: ended in Loop.Crashes|
failed|sound: ended in Sound.Leaves|
failed|vdb: its report cannot be read: no element found: line 1, column 12|
failed|heat: its filter names no test|
skipped|Page.Opens|there is no browser.
passed|Scripts.Run|
failed|Package.Links|
failed|Example.Heat: Unable to find executable|
skipped|Example.Old|switched off in its source'
    [ "$said" = "$expected" ] || fail "wrong counts of the tests: $said"
    ;;
  *) fail "no case $case_name" ;;
esac
[ "$failures" -eq 0 ]
