#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian 12 packages that hapticut needs. Says nothing when nothing is missing.
#
#   scripts/install-deps.sh [--for core|build|test|demo|bench] [--list] [--check]
#
#   --for GROUP  core   compiler, CMake, OpenVDB, Eigen: the library alone
#                build  core, file formats and the command line (default)
#                test   build, and the tools of scripts/test.sh: test libraries, clang, formatter, linter, readers to
#                       compare files with, the needs of pip for the Python package, tools for the page, a browser
#                demo   build without ITK and Assimp, which are large and not needed; the skull CT of scripts/demo.sh; and
#                       tools for the page
#                bench  build, and the benchmark library
#   --list       print the packages of the group, one per line, and stop
#   --check      install nothing; exit 1 and name what is missing
set -eu

core='g++ cmake ninja-build git ca-certificates libopenvdb-dev libtbb-dev libimath-dev libboost-dev libeigen3-dev libhwy-dev'
program="$core libhdf5-dev libpng-dev libtiff-dev libarchive-dev libexpat1-dev zlib1g-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev"
build="$program libinsighttoolkit5-dev libassimp-dev"
page=
command -v node >/dev/null && command -v npm >/dev/null || page='nodejs npm'  # keeps an existing installation
bench="$build ccache libbenchmark-dev"
test="$bench valgrind libgtest-dev librapidcheck-dev clang clang-format clang-tidy libclang-rt-14-dev
  libc++-dev libc++abi-dev pkg-config
  libopenvdb-tools python3-openvdb python3-venv python3-dev pybind11-dev mono-runtime mono-mcs $page chromium"
[ "$(uname -m 2>/dev/null)" = aarch64 ] || test="$test g++-aarch64-linux-gnu"
demo="$program ccache invesalius-examples $page"

complain() {
  printf '%s: %s\n' "install-deps.sh" "$1" >&2
  exit 1
}

group=build
action=install
while [ $# -gt 0 ]; do
  case $1 in
    --for)
      [ $# -ge 2 ] || complain "--for needs a group: core, build, test, demo or bench."
      group=$2
      shift
      ;;
    --list | --check) action=${1#--} ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    *) complain "unknown option $1; see scripts/install-deps.sh --help." ;;
  esac
  shift
done
case $group in
  core) packages=$core ;;
  build) packages=$build ;;
  test) packages=$test ;;
  demo) packages=$demo ;;
  bench) packages=$bench ;;
  *) complain "unknown group $group; choose core, build, test, demo or bench." ;;
esac

if [ "$action" = list ]; then
  printf '%s\n' $packages
  exit 0
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  complain "this is not a Debian system; install the equivalents of the Debian packages $(echo $packages) and pass --no-install to the other scripts."
fi

missing=
for package in $packages; do
  case $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true) in
    installed*) ;;
    *) missing="$missing $package" ;;
  esac
done
missing=${missing# }
[ -n "$missing" ] || exit 0
[ "$action" = install ] || complain "missing: $missing; run scripts/install-deps.sh --for $group."

as_root=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || complain "$missing are missing, and installation needs root or sudo; run as root: apt-get install $missing"
  as_root=sudo
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
install_missing() {
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing >"$log" 2>&1
}

echo "install-deps.sh: installing $missing"
# The package lists may be missing or outdated: refresh them only when the first attempt fails.
if ! install_missing; then
  $as_root apt-get update -q >"$log" 2>&1 && install_missing ||
    complain "cannot install $missing: $(grep -m1 '^E:' "$log" || tail -n1 "$log")"
fi
