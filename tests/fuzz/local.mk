# SPDX-License-Identifier: BSD-3-Clause
# The readers under libFuzzer: `make fuzz`, or tests/fuzz/run.sh, which builds this program by clang in a folder of its own
EXTRA_PROGRAMS += tests/fuzz/readers
CLEANFILES += tests/fuzz/readers
EXTRA_DIST += tests/fuzz/run.sh
tests_fuzz_readers_SOURCES = tests/fuzz/readers.c
tests_fuzz_readers_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_fuzz_readers_LDFLAGS = $(AM_LDFLAGS) -fsanitize=fuzzer,address,undefined
tests_fuzz_readers_LDADD = $(SCENE_LIBS)

fuzz:
	FUZZ_BUILD='$(abs_top_builddir)/build-fuzz' $(top_srcdir)/tests/fuzz/run.sh $(SECONDS)

.PHONY: fuzz
