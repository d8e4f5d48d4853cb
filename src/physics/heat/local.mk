# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libheat.la
libheat_la_SOURCES = \
	%D%/heat_conduct.c %D%/heat_fields.c %D%/heat_physics.c %D%/heat_rows.c %D%/heat_walls.c %D%/heat_work.c \
	%D%/heat.h %D%/heat_fields.h %D%/heat_own.h %D%/heat_state.h %D%/heat_work.h
PHYSICS_LIBS += libheat.la
