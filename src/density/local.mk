# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdensity.la
libdensity_la_SOURCES = src/density/density.c src/density/density.h src/density/density_rows.c
libdensity_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libdensity.la
