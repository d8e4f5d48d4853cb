# SPDX-License-Identifier: BSD-3-Clause
# Tests of the Python package, by pytest
EXTRA_DIST += tests/python/test_pairs.py tests/python/test_simulation.py tests/python/test_tutorial.py tests/python/test_wheel.py
dist_check_SCRIPTS += tests/python/python.sh
tests/python/python.log: libscree.la python/scree/copied
