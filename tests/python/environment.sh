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

wanted=$("$python" "$source/tests/python/requirements.py")
if [ "$(cat "$folder/wanted" 2>/dev/null)" != "$wanted" ]; then
  rm -rf "$folder"
  "$python" -m venv "$folder"
  printf '%s\n' "$wanted" >"$folder/requirements.txt"
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check -r "$folder/requirements.txt"
  printf '%s\n' "$wanted" >"$folder/wanted"
fi
realpath -m "$build/bindings/python" >"$("$folder/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/hapticut.pth"
