# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbodies.la
libbodies_la_SOURCES = \
	src/bodies/bodies.h \
	src/bodies/bodies_rows.c \
	src/bodies/clump.c \
	src/bodies/clump.h \
	src/bodies/fields.c \
	src/bodies/fields.h \
	src/bodies/inscribe.c \
	src/bodies/inscribe.h \
	src/bodies/links.c \
	src/bodies/links.h \
	src/bodies/moments.c \
	src/bodies/moments.h \
	src/bodies/motion.c \
	src/bodies/motion.h \
	src/bodies/physics.c \
	src/bodies/place.c \
	src/bodies/place.h \
	src/bodies/rotor.c \
	src/bodies/rotor.h \
	src/bodies/sums.c \
	src/bodies/sums.h
libbodies_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libbodies.la
