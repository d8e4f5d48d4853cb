# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpairs.la
libpairs_la_SOURCES = \
	%D%/classes_choose.c %D%/history.c %D%/history_follow.c %D%/history_keep.c %D%/history_restore.c \
	%D%/history_rows.c %D%/interaction.c %D%/pairlist.c %D%/pairlist_blocks.c %D%/pairlist_build.c \
	%D%/pairlist_shares.c %D%/skin.c %D%/skin_choice.c %D%/sweep.c %D%/walk.c %D%/walk_kernels.c \
	%D%/walk_ordered.c %D%/classes_choose.h %D%/history.h %D%/history_keep.h %D%/history_rows.h \
	%D%/interaction.h %D%/pairlist.h %D%/pairlist_build.h %D%/skin.h %D%/skin_choice.h %D%/sweep.h %D%/walk.h \
	%D%/walk_filter.h %D%/walk_four.h %D%/walk_history.h %D%/walk_kernel.h %D%/walk_ordered.h
libpairs_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libpairs_la_LIBADD = libwalk_baseline.la

# The operations of the walk, once for each instruction set
WALK_SOURCES = %D%/walk_block.c
noinst_LTLIBRARIES += libwalk_baseline.la
libwalk_baseline_la_SOURCES = $(WALK_SOURCES)
libwalk_baseline_la_CFLAGS = $(KERNEL_CFLAGS)
libwalk_baseline_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_baseline
if X86_KERNELS
noinst_LTLIBRARIES += libwalk_v3.la libwalk_v4.la
libwalk_v3_la_SOURCES = $(WALK_SOURCES)
libwalk_v3_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V3)
libwalk_v3_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_v3
libwalk_v4_la_SOURCES = $(WALK_SOURCES)
libwalk_v4_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V4)
libwalk_v4_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DWALK_KERNEL=walk_kernel_v4
libpairs_la_LIBADD += libwalk_v3.la libwalk_v4.la
endif
