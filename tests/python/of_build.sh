#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the Python tests on the package of a build folder: of_build.sh PYTHON PACKAGE [ARGUMENTS OF PYTEST]
set -eu
python=$1
package=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
shift 2
"$python" -c 'from importlib.util import find_spec; exit(not all(map(find_spec, ("pytest", "mypy", "pandas", "trimesh"))))' || {
  echo "SKIPPED: $python lacks what the tests of Python need; tests/python/environment.sh makes one that has it."
  exit 0
}
export PYTHONPATH="$package"
cd "$package" # so `import hapticut` finds only this package
exec "$python" -m pytest -q --rootdir "$source" -c "$source/pyproject.toml" -p no:cacheprovider "$@" "$source/tests/python"
