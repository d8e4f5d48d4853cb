# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libhard.la
libhard_la_SOURCES = \
	src/physics/hard/border.c \
	src/physics/hard/border.h \
	src/physics/hard/colour.c \
	src/physics/hard/colour.h \
	src/physics/hard/contacts.c \
	src/physics/hard/contacts.h \
	src/physics/hard/hard.h \
	src/physics/hard/hard_check.c \
	src/physics/hard/hard_rows.c \
	src/physics/hard/pairs.c \
	src/physics/hard/pairs.h \
	src/physics/hard/hard_physics.c \
	src/physics/hard/problem.c \
	src/physics/hard/problem.h \
	src/physics/hard/row.h \
	src/physics/hard/hard_solve.c \
	src/physics/hard/hard_solve.h \
	src/physics/hard/hard_state.h
libhard_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libhard.la
