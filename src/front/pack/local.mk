# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpack.la
libpack_la_SOURCES = \
	%D%/bed.c %D%/bidisperse.c %D%/container.c %D%/draw.c %D%/laws.c %D%/options_read.c %D%/pack.c \
	%D%/pack_search.c %D%/push.c %D%/relax.c %D%/work.c %D%/bed.h %D%/bidisperse.h %D%/container.h %D%/draw.h \
	%D%/laws.h %D%/options.h %D%/options_read.h %D%/pack.h %D%/pack_report.h %D%/pack_search.h %D%/push.h \
	%D%/relax.h %D%/work.h
