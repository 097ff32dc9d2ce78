#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Drills a real skull CT and the built-in molar at a simulated 1 kHz. Installs missing packages, builds the command line
# program and its page, prints one table per run and writes out/demo/{skull,molar}.{json,csv,vdb,stl,png}.
#
#   scripts/demo.sh [--no-install] [--jobs N] [--view]
#
#   --view  instead shows the molar in a browser, to drill it with a mouse: hapticut view
set -euo pipefail
cd "$(dirname "$0")/.."

install=true
view=false
jobs=$(nproc)
while [ $# -gt 0 ]; do
  case $1 in
    --no-install) install=false ;;
    --view) view=true ;;
    --jobs)
      jobs=${2:-}
      [[ $jobs =~ ^[1-9][0-9]*$ ]] || { echo "demo.sh: --jobs needs a number, e.g. --jobs 2." >&2; exit 2; }
      shift
      ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "scripts/${0##*/}"
      exit 0
      ;;
    *)
      echo "demo.sh: unknown option $1; see scripts/demo.sh --help." >&2
      exit 2
      ;;
  esac
  shift
done

if $install; then
  scripts/install-deps.sh --for demo
fi
if $view; then
  command -v npm >/dev/null || { echo "demo.sh: --view builds a page, which needs npm: sudo apt-get install nodejs npm" >&2; exit 1; }
fi
mkdir -p out/demo
log=out/demo/build.log
echo "building (see $log)"
if ! { cmake --preset release -DHAPTICUT_WITH_IO=ON -DHAPTICUT_WITH_IMPORT=ON -DHAPTICUT_WITH_CLI=ON -DHAPTICUT_WITH_VIEW=ON -DHAPTICUT_KERNELS=NATIVE &&
  cmake --build --preset release -j "$jobs" -t hapticut_cli hapticut_page; } >"$log" 2>&1; then
  tail -n 40 "$log" >&2
  echo "demo.sh: the build failed; the output is in $log." >&2
  exit 1
fi
grep "^The page of hapticut view was not built" "$log" || true

if $view; then
  exec build/release/apps/cli/hapticut view molar
fi
for name in skull molar; do
  echo
  build/release/apps/cli/hapticut drill --settings "examples/demo/$name.toml" --json "out/demo/$name.json" \
    --steps-csv "out/demo/$name.csv" --save "out/demo/$name.vdb" --surface "out/demo/$name.stl" \
    --picture "out/demo/$name.png"
done
echo
echo "written: out/demo/{skull,molar}.{json,csv,vdb,stl,png}"
echo "open the results in ParaView or Blender: the .stl as a surface, the .vdb as a volume (grid density)"
