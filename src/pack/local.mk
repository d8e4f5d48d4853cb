# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpack.la
libpack_la_SOURCES = \
	src/pack/bed.c src/pack/bed.h \
	src/pack/bidisperse.c src/pack/bidisperse.h \
	src/pack/container.c src/pack/container.h \
	src/pack/draw.c src/pack/draw.h \
	src/pack/laws.c src/pack/laws.h \
	src/pack/options.h \
	src/pack/options_read.c src/pack/options_read.h \
	src/pack/pack.c src/pack/pack.h \
	src/pack/push.c src/pack/push.h \
	src/pack/relax.c src/pack/relax.h \
	src/pack/report.h \
	src/pack/search.c src/pack/search.h \
	src/pack/work.c src/pack/work.h
libpack_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
