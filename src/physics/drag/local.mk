# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdrag.la
libdrag_la_SOURCES = \
	%D%/carrier.c %D%/drag_fields.c %D%/drag_law.c %D%/drag_physics.c %D%/drag_rows.c %D%/porosity.c \
	%D%/carrier.h %D%/drag.h %D%/drag_fields.h %D%/drag_law.h %D%/drag_own.h %D%/porosity.h
PHYSICS_LIBS += libdrag.la
