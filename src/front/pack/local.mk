# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpack.la
libpack_la_SOURCES = \
	src/front/pack/bed.c src/front/pack/bed.h \
	src/front/pack/bidisperse.c src/front/pack/bidisperse.h \
	src/front/pack/container.c src/front/pack/container.h \
	src/front/pack/draw.c src/front/pack/draw.h \
	src/front/pack/laws.c src/front/pack/laws.h \
	src/front/pack/options.h \
	src/front/pack/options_read.c src/front/pack/options_read.h \
	src/front/pack/pack.c src/front/pack/pack.h \
	src/front/pack/push.c src/front/pack/push.h \
	src/front/pack/relax.c src/front/pack/relax.h \
	src/front/pack/pack_report.h \
	src/front/pack/pack_search.c src/front/pack/pack_search.h \
	src/front/pack/work.c src/front/pack/work.h
libpack_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
