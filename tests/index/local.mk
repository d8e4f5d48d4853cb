# SPDX-License-Identifier: BSD-3-Clause
# Tests of the indexes, each against brute force, and a benchmark (built on demand: make tests/index/bench_index)
check_PROGRAMS += \
	tests/index/test_auto \
	tests/index/test_index \
	tests/index/test_levels \
	tests/index/test_stay \
	tests/index/test_stencil \
	tests/index/test_wanted

EXTRA_PROGRAMS += tests/index/bench_index
CLEANFILES += tests/index/bench_index

tests_index_test_auto_SOURCES = tests/index/test_auto.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_auto_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_test_index_SOURCES = tests/index/test_index.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_index_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_test_levels_SOURCES = tests/index/test_levels.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_levels_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_test_stay_SOURCES = tests/index/test_stay.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_stay_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_test_stencil_SOURCES = tests/index/test_stencil.c
tests_index_test_stencil_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_test_wanted_SOURCES = tests/index/test_wanted.c tests/index/cloud.c tests/index/cloud.h
tests_index_test_wanted_LDADD = $(INDEX_LIBS) $(TEST_LIBS)
tests_index_bench_index_SOURCES = tests/index/bench_fit.c tests/index/bench_fit.h \
	tests/index/bench_index.c tests/index/bench_scene.c tests/index/bench_scene.h
tests_index_bench_index_LDADD = $(SCENE_LIBS)
