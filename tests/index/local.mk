# Tests of the indexes, each against brute force: check_PROGRAMS += tests/index/test_X
check_PROGRAMS += \
	tests/index/test_levels

tests_index_test_levels_SOURCES = tests/index/test_levels.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_levels_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
