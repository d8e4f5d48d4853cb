# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libheat.la
libheat_la_SOURCES = \
	src/physics/heat/heat_conduct.c \
	src/physics/heat/heat_fields.c \
	src/physics/heat/heat_fields.h \
	src/physics/heat/heat_physics.c \
	src/physics/heat/heat.h \
	src/physics/heat/heat_own.h \
	src/physics/heat/heat_rows.c \
	src/physics/heat/heat_state.h \
	src/physics/heat/heat_walls.c \
	src/physics/heat/heat_work.c \
	src/physics/heat/heat_work.h
libheat_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libheat.la
