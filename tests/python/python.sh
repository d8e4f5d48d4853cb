#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the tests of the Python package by pytest.

python=${PYTHON:-/usr/bin/python3}
for module in cffi numpy pandas pytest; do
    if ! "$python" -c "import $module" 2>/dev/null; then
        echo "skipped: $python has no $module (Debian: python3-cffi python3-numpy python3-pandas python3-pytest)"
        exit 77
    fi
done
here=$(cd "$(dirname "$0")" && pwd)
export PYTHONPATH=$top_builddir/python PYTHONDONTWRITEBYTECODE=1 SCREE=${SCREE:-$top_builddir/scree}
cd "$(mktemp -d)" || exit 1
trap 'rm -rf "$PWD"' EXIT
"$python" -m pytest -q -p no:cacheprovider "$here"
