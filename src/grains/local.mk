# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libgrains.la
libgrains_la_SOURCES = \
	src/grains/balance.c \
	src/grains/grains.c \
	src/grains/grains.h \
	src/grains/limit.c \
	src/grains/notes.c \
	src/grains/obstacles.c \
	src/grains/overlaps.c \
	src/grains/overlaps.h \
	src/grains/parts.h \
	src/grains/physics.c \
	src/grains/record.c \
	src/grains/sorts.c \
	src/grains/sorts.h \
	src/grains/stable.c \
	src/grains/start.c
libgrains_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libgrains.la
