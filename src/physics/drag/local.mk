# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdrag.la
libdrag_la_SOURCES = \
	src/physics/drag/carrier.c \
	src/physics/drag/carrier.h \
	src/physics/drag/drag.h \
	src/physics/drag/drag_own.h \
	src/physics/drag/drag_rows.c \
	src/physics/drag/drag_fields.c \
	src/physics/drag/drag_fields.h \
	src/physics/drag/drag_law.c \
	src/physics/drag/drag_law.h \
	src/physics/drag/drag_physics.c \
	src/physics/drag/porosity.c \
	src/physics/drag/porosity.h
libdrag_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libdrag.la
