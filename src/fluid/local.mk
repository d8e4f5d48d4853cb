# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libfluid.la
libfluid_la_SOURCES = \
	src/fluid/assembly.c \
	src/fluid/assembly.h \
	src/fluid/body.c \
	src/fluid/body.h \
	src/fluid/drag.c \
	src/fluid/drag.h \
	src/fluid/drive.c \
	src/fluid/drive.h \
	src/fluid/feet.c \
	src/fluid/feet.h \
	src/fluid/fields.c \
	src/fluid/fields.h \
	src/fluid/fill.c \
	src/fluid/fill.h \
	src/fluid/fill_open.c \
	src/fluid/fill_open.h \
	src/fluid/flow.c \
	src/fluid/flow.h \
	src/fluid/flow_fields.c \
	src/fluid/flow_fields.h \
	src/fluid/fluid.c \
	src/fluid/fluid.h \
	src/fluid/fluid_rows.c \
	src/fluid/forces.c \
	src/fluid/forces.h \
	src/fluid/kernel.c \
	src/fluid/kernel.h \
	src/fluid/look.c \
	src/fluid/look.h \
	src/fluid/march.c \
	src/fluid/march.h \
	src/fluid/marks.c \
	src/fluid/marks.h \
	src/fluid/mirror.c \
	src/fluid/mirror.h \
	src/fluid/mls.c \
	src/fluid/mls.h \
	src/fluid/momentum.c \
	src/fluid/momentum.h \
	src/fluid/motion.c \
	src/fluid/motion.h \
	src/fluid/nodes.c \
	src/fluid/nodes.h \
	src/fluid/open.c \
	src/fluid/open.h \
	src/fluid/operators.c \
	src/fluid/operators.h \
	src/fluid/path.c \
	src/fluid/path.h \
	src/fluid/physics.c \
	src/fluid/pressure.c \
	src/fluid/pressure.h \
	src/fluid/projection.c \
	src/fluid/projection.h \
	src/fluid/projection_parts.h \
	src/fluid/regions.c \
	src/fluid/regions.h \
	src/fluid/residual.c \
	src/fluid/residual.h \
	src/fluid/shift.c \
	src/fluid/shift.h \
	src/fluid/shown.c \
	src/fluid/shown.h \
	src/fluid/shown_drag.c \
	src/fluid/state.h \
	src/fluid/steady.c \
	src/fluid/steady.h \
	src/fluid/tensors.c \
	src/fluid/tensors.h \
	src/fluid/weights.c \
	src/fluid/weights.h
libfluid_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libfluid.la libsolve.la
FLUID_LIBS = libfluid.la $(SOLVE_LIBS)
