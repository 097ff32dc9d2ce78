#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes an environment for Python with all that the tests need but hapticut, which is taken from a build folder.
#
#   tests/python/environment.sh FOLDER BUILD [PYTHON]
#
#   FOLDER  becomes the environment; one whose requirements are the same stays
#   BUILD   the build folder: `import hapticut` there means BUILD/bindings/python/hapticut
#
# The exit code is 77 where this machine has no venv, no headers or no index of packages; the last line says which.
set -euo pipefail
folder=$1
build=$2
python=${3:-python3}
source=$(cd "$(dirname "$0")/../.." && pwd)

absent() {
  echo "$1" >&2
  exit 77
}
"$python" -c 'import venv, ensurepip, tomllib' || absent "they need Python 3.11 with venv: sudo apt-get install python3-venv"
[ -f "$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')/Python.h" ] ||
  absent "$python has no headers: sudo apt-get install python3-dev"
wanted=$("$python" "$source/tests/python/requirements.py")
if [ "$(cat "$folder/wanted" 2>/dev/null)" != "$wanted" ] || ! "$folder/bin/python" -c ''; then
  rm -rf "$folder"
  "$python" -m venv "$folder"
  printf '%s\n' "$wanted" >"$folder/requirements.txt"
  # Asked for on its own, so that a requirement that cannot be met does not look like an index that is not there.
  "$folder/bin/python" -m pip download --quiet --disable-pip-version-check --no-deps --dest "$folder/probe" pybind11 ||
    absent "pip cannot download pybind11, so nothing can be installed"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check -r "$folder/requirements.txt"
  printf '%s\n' "$wanted" >"$folder/wanted"
fi
site=$("$folder/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
realpath -m "$build/bindings/python" >"$site/hapticut.pth"
