# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libformats.la
libformats_la_SOURCES = \
	src/formats/checkpoint.c \
	src/formats/checkpoint.h \
	src/formats/checkpoint_file.c \
	src/formats/checkpoint_file.h \
	src/formats/checkpoint_folder.c \
	src/formats/checkpoint_head.c \
	src/formats/checkpoint_parts.h \
	src/formats/checkpoint_read.c \
	src/formats/checkpoint_read_head.c \
	src/formats/checkpoint_table.c \
	src/formats/checkpoint_table.h \
	src/formats/contact_list.c \
	src/formats/contact_list.h \
	src/formats/convert.c \
	src/formats/convert.h \
	src/formats/dump.c \
	src/formats/dump.h \
	src/formats/dump_read.c \
	src/formats/frame.c \
	src/formats/frame.h \
	src/formats/frame_rows.c \
	src/formats/h5.c \
	src/formats/h5.h \
	src/formats/h5_data.c \
	src/formats/h5_watch.c \
	src/formats/h5_watch.h \
	src/formats/h5md.c \
	src/formats/h5md.h \
	src/formats/h5md_contacts.c \
	src/formats/h5md_contacts.h \
	src/formats/h5md_file.c \
	src/formats/h5md_file.h \
	src/formats/h5md_frame.c \
	src/formats/h5md_frame.h \
	src/formats/h5md_head.c \
	src/formats/h5md_head.h \
	src/formats/h5md_observables.c \
	src/formats/h5md_observables.h \
	src/formats/h5md_read.c \
	src/formats/h5md_read.h \
	src/formats/h5md_resume.c \
	src/formats/h5md_resume.h \
	src/formats/info.c \
	src/formats/info.h \
	src/formats/lammps_data.c \
	src/formats/lammps_data.h \
	src/formats/lineage.c \
	src/formats/lineage.h \
	src/formats/output.h \
	src/formats/output_options.c \
	src/formats/output_options.h \
	src/formats/restart.c \
	src/formats/restart.h \
	src/formats/rows.c \
	src/formats/rows.h \
	src/formats/xdmf.c \
	src/formats/xdmf.h
libformats_la_CPPFLAGS = $(AM_CPPFLAGS) $(HDF5_CFLAGS) $(MPI_CFLAGS) $(ZLIB_CFLAGS)
libformats_la_LIBADD = $(HDF5_LIBS)
