noinst_LTLIBRARIES += liboutput.la
liboutput_la_SOURCES = \
	src/output/checkpoint.c \
	src/output/checkpoint.h \
	src/output/checkpoint_parts.h \
	src/output/checkpoint_read.c \
	src/output/checkpoint_table.c \
	src/output/checkpoint_table.h \
	src/output/contact_list.c \
	src/output/contact_list.h \
	src/output/convert.c \
	src/output/convert.h \
	src/output/describe.c \
	src/output/describe.h \
	src/output/dump.c \
	src/output/dump.h \
	src/output/dump_read.c \
	src/output/file.c \
	src/output/file.h \
	src/output/frame.c \
	src/output/frame.h \
	src/output/frame_rows.c \
	src/output/h5.c \
	src/output/h5.h \
	src/output/h5_watch.c \
	src/output/h5_watch.h \
	src/output/h5_data.c \
	src/output/h5md.c \
	src/output/h5md.h \
	src/output/h5md_contacts.c \
	src/output/h5md_frame.c \
	src/output/h5md_head.c \
	src/output/h5md_parts.h \
	src/output/h5md_read.c \
	src/output/h5md_read.h \
	src/output/h5md_resume.c \
	src/output/info.c \
	src/output/info.h \
	src/output/lammps_data.c \
	src/output/lammps_data.h \
	src/output/lines.c \
	src/output/lines.h \
	src/output/observables.c \
	src/output/observables.h \
	src/output/observables_bulk.c \
	src/output/observables_kinds.h \
	src/output/observables_row.c \
	src/output/observables_single.c \
	src/output/observables_stress.c \
	src/output/output.h \
	src/output/output_options.c \
	src/output/output_options.h \
	src/output/progress.c \
	src/output/progress.h \
	src/output/report.c \
	src/output/report.h \
	src/output/report_json.c \
	src/output/rows.c \
	src/output/rows.h \
	src/output/xdmf.c \
	src/output/xdmf.h
liboutput_la_CPPFLAGS = $(AM_CPPFLAGS) $(HDF5_CFLAGS) $(MPI_CFLAGS) $(ZLIB_CFLAGS)
liboutput_la_LIBADD = $(HDF5_LIBS) $(ZLIB_LIBS)

EXTRA_DIST += docs/output.md

# What writes the tables of docs/output.md, after a change of fields or observables
EXTRA_PROGRAMS += src/output/document
CLEANFILES += src/output/document
src_output_document_SOURCES = src/output/document.c
src_output_document_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
src_output_document_LDADD = $(OUTPUT_LIBS)
