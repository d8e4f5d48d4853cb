# SPDX-License-Identifier: BSD-3-Clause
# The readers under libFuzzer: `make fuzz`, or tests/fuzz/run.sh, which builds this program by clang in a folder of its own
EXTRA_PROGRAMS += %D%/readers
CLEANFILES += %D%/readers
EXTRA_DIST += %D%/run.sh
tests_fuzz_readers_SOURCES = %D%/readers.c
tests_fuzz_readers_LDFLAGS = $(AM_LDFLAGS) -fsanitize=fuzzer,address,undefined
tests_fuzz_readers_LDADD = $(SCENE_LIBS)

fuzz:
	FUZZ_BUILD='$(abs_top_builddir)/build-fuzz' $(top_srcdir)/tests/fuzz/run.sh $(SECONDS)

.PHONY: fuzz
