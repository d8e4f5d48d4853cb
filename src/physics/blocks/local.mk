# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libblocks.la
libblocks_la_SOURCES = \
	%D%/blocks_act.c %D%/blocks_make.c %D%/blocks_physics.c %D%/blocks_rows.c %D%/blocks.h %D%/blocks_state.h
PHYSICS_LIBS += libblocks.la
