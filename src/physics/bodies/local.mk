# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbodies.la
libbodies_la_SOURCES = \
	src/physics/bodies/bodies.h \
	src/physics/bodies/bodies_rows.c \
	src/physics/bodies/clump.c \
	src/physics/bodies/clump.h \
	src/physics/bodies/bodies_fields.c \
	src/physics/bodies/bodies_fields.h \
	src/physics/bodies/inscribe.c \
	src/physics/bodies/inscribe.h \
	src/physics/bodies/bodies_links.c \
	src/physics/bodies/bodies_links.h \
	src/physics/bodies/moments.c \
	src/physics/bodies/moments.h \
	src/physics/bodies/bodies_motion.c \
	src/physics/bodies/bodies_motion.h \
	src/physics/bodies/bodies_physics.c \
	src/physics/bodies/place.c \
	src/physics/bodies/place.h \
	src/physics/bodies/rotor.c \
	src/physics/bodies/rotor.h \
	src/physics/bodies/sums.c \
	src/physics/bodies/sums.h
libbodies_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libbodies.la
