# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdensity.la
libdensity_la_SOURCES = src/physics/density/density.c src/physics/density/density.h src/physics/density/density_rows.c
libdensity_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libdensity.la
