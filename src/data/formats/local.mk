# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libformats.la
libformats_la_SOURCES = \
	%D%/checkpoint.c %D%/checkpoint_file.c %D%/checkpoint_folder.c %D%/checkpoint_head.c %D%/checkpoint_io.c \
	%D%/checkpoint_names.c %D%/checkpoint_rows.c %D%/checkpoint_table.c %D%/contact_list.c %D%/contact_problem.c \
	%D%/convert.c %D%/dump.c %D%/dump_read.c %D%/frame.c %D%/frame_rows.c %D%/h5.c %D%/h5_data.c %D%/h5_watch.c \
	%D%/h5md.c %D%/h5md_contacts.c %D%/h5md_element.c %D%/h5md_file.c %D%/h5md_frame.c %D%/h5md_head.c \
	%D%/h5md_observables.c %D%/h5md_read.c %D%/h5md_resume.c %D%/info.c %D%/lammps_data.c %D%/lineage.c \
	%D%/output_options.c %D%/output_shapes.c %D%/restart.c %D%/rows.c %D%/vtp.c %D%/wall_frames.c %D%/xdmf.c \
	%D%/checkpoint.h %D%/checkpoint_folder.h %D%/checkpoint_names.h %D%/checkpoint_parts.h \
	%D%/checkpoint_state.h %D%/checkpoint_table.h %D%/contact_list.h %D%/contact_problem.h %D%/convert.h \
	%D%/dump.h %D%/frame.h %D%/h5.h %D%/h5_watch.h %D%/h5md.h %D%/h5md_element.h %D%/h5md_file.h %D%/h5md_head.h \
	%D%/h5md_observables.h %D%/h5md_parts.h %D%/h5md_read.h %D%/info.h %D%/lammps_data.h %D%/lineage.h \
	%D%/output.h %D%/output_options.h %D%/output_shapes.h %D%/restart.h %D%/rows.h %D%/vtp.h %D%/wall_frames.h \
	%D%/xdmf.h
libformats_la_CPPFLAGS = $(AM_CPPFLAGS) $(ZLIB_CFLAGS)
libformats_la_LIBADD = $(HDF5_LIBS)
