# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libfiles.la
libfiles_la_SOURCES = \
	src/files/file.c \
	src/files/file.h \
	src/files/lines.c \
	src/files/lines.h \
	src/files/numbers.c \
	src/files/numbers.h
libfiles_la_CPPFLAGS = $(AM_CPPFLAGS) $(ZLIB_CFLAGS)
libfiles_la_LIBADD = $(ZLIB_LIBS)
