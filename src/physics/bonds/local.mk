# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbonds.la
libbonds_la_SOURCES = \
	src/physics/bonds/bond.c \
	src/physics/bonds/bond.h \
	src/physics/bonds/bonds.h \
	src/physics/bonds/bonds_rows.c \
	src/physics/bonds/bonds_fields.c \
	src/physics/bonds/bonds_links.c \
	src/physics/bonds/make.c \
	src/physics/bonds/bonds_physics.c \
	src/physics/bonds/bonds_state.h \
	src/physics/bonds/bonds_table.c
libbonds_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libbonds.la
