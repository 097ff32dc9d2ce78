#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the package with pip into a new virtual environment, as a user would, and runs the Python tests there.
#
#   tests/python/in_fresh_environment.sh FOLDER [PYTHON [TEST...]]
#
#   FOLDER  the environment; its old content is removed
#   PYTHON  interpreter (default: python3)
#   TEST    arguments of pytest (default: all of tests/python)
set -euo pipefail
folder=$(realpath -m "$1")
python=${2:-python3}
shift $(($# > 2 ? 2 : $#))
source=$(cd "$(dirname "$0")/../.." && pwd)

skip() {
  echo "SKIPPED: $1"
  exit 0
}
command -v "$python" >/dev/null || skip "there is no $python."
"$python" -c 'import sys; sys.exit(sys.version_info < (3, 9))' || skip "$python is older than Python 3.9."
"$python" -c 'import venv, ensurepip' 2>/dev/null || skip "$python has no venv; sudo apt-get install python3-venv."
include=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')
[ -f "$include/Python.h" ] || skip "$python has no headers; sudo apt-get install python3-dev."

unset PYTHONPATH PYTHONHOME
export CC=${CC:-cc} CXX=${CXX:-c++} # the names that CMake uses, so ccache shares objects with other builds
rm -rf "$folder"
"$python" -m venv "$folder"
# Only the package index may be missing; checked separately, so no other failure looks like it.
"$folder/bin/python" -m pip download --quiet --no-deps --dest "$folder/probe" scikit-build-core ||
  skip "pip cannot download scikit-build-core, so nothing can be installed."
"$folder/bin/python" -m pip install --quiet "$source[test]"
cd "$folder" # so `import hapticut` finds only the installed package
exec "$folder/bin/python" -m pytest -q --rootdir "$source" -c "$source/pyproject.toml" -p no:cacheprovider \
  "${@:-$source/tests/python}"
