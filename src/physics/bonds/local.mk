# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbonds.la
libbonds_la_SOURCES = \
	%D%/bond.c %D%/bonds_act.c %D%/bonds_fields.c %D%/bonds_links.c %D%/bonds_physics.c %D%/bonds_rows.c \
	%D%/bonds_table.c %D%/make.c %D%/bond.h %D%/bonds.h %D%/bonds_state.h
libbonds_la_CFLAGS = $(KERNEL_CFLAGS)
PHYSICS_LIBS += libbonds.la
