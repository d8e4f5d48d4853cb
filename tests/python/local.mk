# SPDX-License-Identifier: BSD-3-Clause
# Tests of the Python package, by pytest
EXTRA_DIST += %D%/test_pairs.py %D%/test_simulation.py %D%/test_tutorial.py %D%/test_wheel.py
dist_check_SCRIPTS += %D%/python.sh
tests/python/python.log: libscree.la python/scree/copied
