# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libhard.la
libhard_la_SOURCES = \
	src/hard/border.c \
	src/hard/border.h \
	src/hard/colour.c \
	src/hard/colour.h \
	src/hard/contacts.c \
	src/hard/contacts.h \
	src/hard/hard.h \
	src/hard/hard_rows.c \
	src/hard/pairs.c \
	src/hard/pairs.h \
	src/hard/physics.c \
	src/hard/problem.c \
	src/hard/problem.h \
	src/hard/row.h \
	src/hard/solve.c \
	src/hard/solve.h \
	src/hard/state.h
libhard_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libhard.la
