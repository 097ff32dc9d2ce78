#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes an environment for Python with all that the tests need but hapticut, which is taken from a build folder.
#
#   tests/python/environment.sh FOLDER BUILD [PYTHON]
#
#   FOLDER  becomes the environment; one whose requirements are the same stays
#   BUILD   the build folder: `import hapticut` there means BUILD/bindings/python/hapticut
set -euo pipefail
folder=$1
build=$2
python=${3:-python3}
source=$(cd "$(dirname "$0")/../.." && pwd)

"$python" -c 'import venv, ensurepip, tomllib' || {
  echo "the tests of Python need Python 3.11 with venv: sudo apt-get install python3-venv" >&2
  exit 1
}
[ -f "$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')/Python.h" ] || {
  echo "$python has no headers: sudo apt-get install python3-dev" >&2
  exit 1
}
wanted=$("$python" "$source/tests/python/requirements.py")
if [ "$(cat "$folder/wanted" 2>/dev/null)" != "$wanted" ]; then
  rm -rf "$folder"
  "$python" -m venv "$folder"
  printf '%s\n' "$wanted" >"$folder/requirements.txt"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check -r "$folder/requirements.txt"
  printf '%s\n' "$wanted" >"$folder/wanted"
fi
realpath -m "$build/bindings/python" >"$("$folder/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/hapticut.pth"
