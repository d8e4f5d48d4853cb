# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libscene.la
libscene_la_SOURCES = \
	src/scene/compare.c \
	src/scene/compare.h \
	src/scene/decimal.c \
	src/scene/decimal.h \
	src/scene/finish.c \
	src/scene/finish.h \
	src/scene/insertion.c \
	src/scene/insertion.h \
	src/scene/lattice.c \
	src/scene/lattice.h \
	src/scene/mistakes.c \
	src/scene/mistakes.h \
	src/scene/packing.c \
	src/scene/packing.h \
	src/scene/placegrid.c \
	src/scene/placegrid.h \
	src/scene/region.c \
	src/scene/region.h \
	src/scene/scene.c \
	src/scene/scene.h \
	src/scene/scene_check.c \
	src/scene/scene_check.h \
	src/scene/scene_check_box.c \
	src/scene/scene_check_box.h \
	src/scene/scene_check_output.c \
	src/scene/scene_check_output.h \
	src/scene/scene_check_walls.c \
	src/scene/scene_check_walls.h \
	src/scene/scene_files.c \
	src/scene/scene_files.h \
	src/scene/scene_particles.c \
	src/scene/scene_particles.h \
	src/scene/scene_read.c \
	src/scene/scene_read.h \
	src/scene/scene_sections.h \
	src/scene/scene_share.h \
	src/scene/scene_stage.c \
	src/scene/scene_stage.h \
	src/scene/scene_text.c \
	src/scene/scene_text.h \
	src/scene/schema.c \
	src/scene/schema.h \
	src/scene/schema_contact.c \
	src/scene/schema_contact.h \
	src/scene/schema_help.c \
	src/scene/schema_help.h \
	src/scene/schema_normalise.c \
	src/scene/schema_normalise.h \
	src/scene/schema_output.c \
	src/scene/schema_output.h \
	src/scene/schema_particles.c \
	src/scene/schema_particles.h \
	src/scene/schema_read.c \
	src/scene/schema_read.h \
	src/scene/schema_root.c \
	src/scene/schema_root.h \
	src/scene/schema_rows.h \
	src/scene/schema_search.c \
	src/scene/schema_search.h \
	src/scene/schema_set.c \
	src/scene/schema_stage.c \
	src/scene/schema_stage.h \
	src/scene/schema_unknown.c \
	src/scene/schema_unknown.h \
	src/scene/schema_value.c \
	src/scene/schema_value.h \
	src/scene/schema_walls.c \
	src/scene/schema_walls.h \
	src/scene/schema_write.c \
	src/scene/schema_write.h \
	src/scene/sizes.c \
	src/scene/sizes.h \
	src/scene/sizes_file.c \
	src/scene/sizes_file.h \
	src/scene/source.h \
	src/scene/source_batch.c \
	src/scene/source_batch.h \
	src/scene/source_ids.c \
	src/scene/source_ids.h \
	src/scene/source_sphere.c \
	src/scene/source_sphere.h \
	src/scene/synonyms.c \
	src/scene/synonyms.h \
	src/scene/table.c \
	src/scene/table.h \
	src/scene/table_lines.c \
	src/scene/table_lines.h \
	src/scene/tree.c \
	src/scene/tree.h \
	src/scene/tree_advice.c \
	src/scene/tree_advice.h \
	src/scene/tree_parse.c \
	src/scene/tree_write.c \
	src/scene/unique.c \
	src/scene/unique.h \
	src/scene/units.c \
	src/scene/units.h
libscene_la_CPPFLAGS = $(AM_CPPFLAGS) $(YAML_CFLAGS) $(MPI_CFLAGS)
libscene_la_LIBADD = $(YAML_LIBS) $(ZLIB_LIBS)

EXTRA_DIST += docs/scene.md

# What writes docs/scene.md, after a change of the schema
EXTRA_PROGRAMS += src/scene/document
CLEANFILES += src/scene/document
src_scene_document_SOURCES = src/scene/document.c
src_scene_document_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
src_scene_document_LDADD = $(SCENE_LIBS)
