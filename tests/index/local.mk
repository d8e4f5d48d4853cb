# Tests of the indexes, each against brute force: check_PROGRAMS += tests/index/test_X
