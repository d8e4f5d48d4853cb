# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libgrains.la
libgrains_la_SOURCES = \
	src/physics/grains/grains_balance.c \
	src/physics/grains/grains.c \
	src/physics/grains/grains.h \
	src/physics/grains/limit.c \
	src/physics/grains/grains_notes.c \
	src/physics/grains/obstacles.c \
	src/physics/grains/overlaps.c \
	src/physics/grains/overlaps.h \
	src/physics/grains/grains_own.h \
	src/physics/grains/grains_physics.c \
	src/physics/grains/record.c \
	src/physics/grains/sorts.c \
	src/physics/grains/sorts.h \
	src/physics/grains/stable.c \
	src/physics/grains/start.c
libgrains_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libgrains.la
