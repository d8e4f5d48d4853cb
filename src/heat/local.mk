# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libheat.la
libheat_la_SOURCES = \
	src/heat/fields.c \
	src/heat/fields.h \
	src/heat/heat.c \
	src/heat/heat.h \
	src/heat/heat_own.h \
	src/heat/heat_rows.c \
	src/heat/heat_work.c \
	src/heat/heat_work.h
libheat_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libheat.la
