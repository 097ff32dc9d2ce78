#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the time of a step and compares it with straightforward implementations and with its deadline. Writes the raw
# results to out/bench/*.json and the tables to out/bench/verdict.md and table.md, and prints them: first which scenes fit
# into 1 ms.
#
#   scripts/bench.sh [--all] [--repetitions N] [--kernels avx2] [--no-install]
#
#   --all            all workloads, voxel sizes and radii (about half an hour); default: those in the table
#   --kernels avx2   measure those of AVX2, where the machine would choose AVX-512
#   --repetitions N  number of repetitions, in random order; the median is used (default 5)
#   --no-install     do not install packages
set -euo pipefail
cd "$(dirname "$0")/.."

filter='W2/.*/R2/|W1/.*/R2/(hapticut_static|dense_simd)|W3/.*/R[23]/(hapticut|hapticut_static|dense_simd)'
repetitions=5
install=true
while [ $# -gt 0 ]; do
  case $1 in
    --all) filter=. ;;
    --no-install) install=false ;;
    --kernels)
      export HAPTICUT_BENCH_KERNELS=${2:-}
      shift
      ;;
    --repetitions)
      repetitions=${2:-}
      [[ $repetitions =~ ^[1-9][0-9]*$ ]] || { echo "bench.sh: --repetitions needs a number, e.g. --repetitions 5." >&2; exit 2; }
      shift
      ;;
    -h | --help)
      sed -n '3,/^set/s/^# \{0,1\}//p' "scripts/${0##*/}"
      exit 0
      ;;
    *)
      echo "bench.sh: unknown option $1; see scripts/bench.sh --help." >&2
      exit 2
      ;;
  esac
  shift
done

if $install; then scripts/install-deps.sh --for bench; fi
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true
out=out/bench
mkdir -p "$out"
cmake --preset release -DHAPTICUT_WITH_BENCHMARKS=ON ${HAPTICUT_BENCH_KERNELS:+-DHAPTICUT_KERNELS=ALL} >"$out/build.log" 2>&1 &&
  cmake --build --preset release -t bench_verdict bench_step bench_scenarios bench_report hapticut_cli >>"$out/build.log" 2>&1 ||
  { tail -n 40 "$out/build.log" >&2; echo "bench.sh: the build failed; see $out/build.log." >&2; exit 1; }

run() {
  local name=$1
  shift
  echo "measuring: $name" >&2
  "build/release/benchmarks/bench_$name" --benchmark_out="$out/$name.json.part" --benchmark_out_format=json "$@" \
    >"$out/$name.log" 2>&1 || { tail -n 20 "$out/$name.log" >&2; exit 1; }
  mv "$out/$name.json.part" "$out/$name.json"
}
echo "measuring: what fits into 1 ms" >&2
build/release/benchmarks/bench_verdict | tee "$out/verdict.md"
run step --benchmark_filter="$filter" --benchmark_repetitions="$repetitions" --benchmark_enable_random_interleaving=true
run scenarios --benchmark_repetitions="$repetitions" --benchmark_enable_random_interleaving=true
echo "measuring: loop" >&2
build/release/apps/cli/hapticut loop mock:spiral --seconds 60 --json "$out/loop.json" >"$out/loop.log" 2>&1 ||
  { tail -n 20 "$out/loop.log" >&2; exit 1; }

{
  echo "commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown), $(date -u +%Y-%m-%d), $(nproc) processors:" \
    "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
  echo
  build/release/benchmarks/bench_report "$out/step.json" "$out/scenarios.json" --loop "$out/loop.json"
} | tee "$out/table.md"
