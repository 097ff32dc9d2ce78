#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes a Python environment with the packages of the tests; hapticut comes from a build folder.
#
#   tests/python/environment.sh FOLDER BUILD [PYTHON]
#
#   FOLDER  the environment; kept if its requirements are unchanged
#   BUILD   the build folder: `import hapticut` there means BUILD/bindings/python/hapticut
#
# The exit code is 77 when this machine has no venv, no headers or no package index; the last line says which.
set -euo pipefail
folder=$1
build=$2
python=${3:-python3}
source=$(cd "$(dirname "$0")/../.." && pwd)

absent() {
  echo "$1" >&2
  exit 77
}
"$python" -c 'import venv, ensurepip, tomllib' || absent "tests need Python 3.11 with venv: sudo apt-get install python3-venv"
[ -f "$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')/Python.h" ] ||
  absent "$python has no headers: sudo apt-get install python3-dev"
required=$("$python" "$source/tests/python/requirements.py")
if [ "$(cat "$folder/required" 2>/dev/null)" != "$required" ] || ! "$folder/bin/python" -c ''; then
  rm -rf "$folder"
  "$python" -m venv "$folder"
  printf '%s\n' "$required" >"$folder/requirements.txt"
  # Checked separately, so an unsatisfiable requirement does not look like a missing package index.
  "$folder/bin/python" -m pip download --quiet --disable-pip-version-check --no-deps --dest "$folder/probe" pybind11 ||
    absent "pip cannot download pybind11, so nothing can be installed"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check -r "$folder/requirements.txt"
  printf '%s\n' "$required" >"$folder/required"
fi
site=$("$folder/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
realpath -m "$build/bindings/python" >"$site/hapticut.pth"
