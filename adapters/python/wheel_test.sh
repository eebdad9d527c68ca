#!/usr/bin/env bash
# Makes a wheel of the module that was built, installs it into a folder of its own and runs the example with it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
if ! "$PYTHON" -c 'import setuptools, wheel, pybind11, pip' 2>/dev/null; then
    echo "skipped: needs pip, setuptools, wheel and pybind11 for $PYTHON"
    exit 77
fi
rm -rf "$WORK/wheel"
mkdir -p "$WORK/wheel"
cp -r "$here/../../CMakeLists.txt" "$WORK/wheel/" # what setup.py reads the version from
mkdir -p "$WORK/wheel/adapters" "$WORK/wheel/schemes"
cp -r "$here" "$WORK/wheel/adapters/python" # where building may write
"$PYTHON" -m pip wheel --quiet --no-build-isolation --no-deps --no-index -w "$WORK/wheel" "$WORK/wheel/adapters/python"
"$PYTHON" -m pip install --quiet --no-deps --no-index --target "$WORK/wheel/site" "$WORK"/wheel/kith-*.whl
cp "$here/example.py" "$WORK/wheel/"
PYTHONPATH=$WORK/wheel/site "$PYTHON" "$WORK/wheel/example.py"
