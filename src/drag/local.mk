# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdrag.la
libdrag_la_SOURCES = \
	src/drag/carrier.c \
	src/drag/carrier.h \
	src/drag/drag.h \
	src/drag/drag_own.h \
	src/drag/drag_rows.c \
	src/drag/fields.c \
	src/drag/fields.h \
	src/drag/law.c \
	src/drag/law.h \
	src/drag/physics.c \
	src/drag/porosity.c \
	src/drag/porosity.h
libdrag_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libdrag.la
