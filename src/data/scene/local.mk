# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libscene.la
libscene_la_SOURCES = \
	src/data/scene/compare.c \
	src/data/scene/compare.h \
	src/data/scene/decimal.c \
	src/data/scene/decimal.h \
	src/data/scene/finish.c \
	src/data/scene/finish_box.c \
	src/data/scene/finish.h \
	src/data/scene/insertion.c \
	src/data/scene/insertion.h \
	src/data/scene/lattice.c \
	src/data/scene/lattice.h \
	src/data/scene/mistakes.c \
	src/data/scene/mistakes.h \
	src/data/scene/pack/pack_search.c \
	src/data/scene/pack/pack_search.h \
	src/data/scene/pack/pile.c \
	src/data/scene/pack/pile.h \
	src/data/scene/pack/push.c \
	src/data/scene/pack/push.h \
	src/data/scene/pack/relax.c \
	src/data/scene/pack/relax.h \
	src/data/scene/packed.c \
	src/data/scene/packed.h \
	src/data/scene/packed_radii.c \
	src/data/scene/packed_radii.h \
	src/data/scene/placegrid.c \
	src/data/scene/placegrid.h \
	src/data/scene/region.c \
	src/data/scene/region.h \
	src/data/scene/scatter.c \
	src/data/scene/scatter.h \
	src/data/scene/scene.c \
	src/data/scene/scene.h \
	src/data/scene/scene_check.c \
	src/data/scene/scene_check.h \
	src/data/scene/scene_check_box.c \
	src/data/scene/scene_check_box.h \
	src/data/scene/scene_check_output.c \
	src/data/scene/scene_check_output.h \
	src/data/scene/scene_check_walls.c \
	src/data/scene/scene_check_walls.h \
	src/data/scene/scene_files.c \
	src/data/scene/scene_files.h \
	src/data/scene/scene_particles.c \
	src/data/scene/scene_particles.h \
	src/data/scene/scene_read.c \
	src/data/scene/scene_read.h \
	src/data/scene/scene_sections.h \
	src/data/scene/scene_share.h \
	src/data/scene/scene_stage.c \
	src/data/scene/scene_stage.h \
	src/data/scene/scene_text.c \
	src/data/scene/scene_text.h \
	src/data/scene/schema.c \
	src/data/scene/schema.h \
	src/data/scene/schema_contact.c \
	src/data/scene/schema_contact.h \
	src/data/scene/schema_help.c \
	src/data/scene/schema_help.h \
	src/data/scene/schema_normalise.c \
	src/data/scene/schema_normalise.h \
	src/data/scene/schema_output.c \
	src/data/scene/schema_output.h \
	src/data/scene/schema_particles.c \
	src/data/scene/schema_particles.h \
	src/data/scene/schema_read.c \
	src/data/scene/schema_read.h \
	src/data/scene/schema_root.c \
	src/data/scene/schema_root.h \
	src/data/scene/schema_rows.h \
	src/data/scene/schema_search.c \
	src/data/scene/schema_search.h \
	src/data/scene/schema_set.c \
	src/data/scene/schema_stage.c \
	src/data/scene/schema_stage.h \
	src/data/scene/schema_unknown.c \
	src/data/scene/schema_unknown.h \
	src/data/scene/schema_value.c \
	src/data/scene/schema_value.h \
	src/data/scene/schema_walls.c \
	src/data/scene/schema_walls.h \
	src/data/scene/schema_write.c \
	src/data/scene/schema_write.h \
	src/data/scene/sizes.c \
	src/data/scene/sizes.h \
	src/data/scene/sizes_file.c \
	src/data/scene/sizes_file.h \
	src/data/scene/source.h \
	src/data/scene/source_batch.c \
	src/data/scene/source_batch.h \
	src/data/scene/source_ids.c \
	src/data/scene/source_ids.h \
	src/data/scene/source_radii.c \
	src/data/scene/source_radii.h \
	src/data/scene/source_sphere.c \
	src/data/scene/source_sphere.h \
	src/data/scene/synonyms.c \
	src/data/scene/synonyms.h \
	src/data/scene/table.c \
	src/data/scene/table.h \
	src/data/scene/table_lines.c \
	src/data/scene/table_lines.h \
	src/data/scene/tree.c \
	src/data/scene/tree.h \
	src/data/scene/tree_advice.c \
	src/data/scene/tree_advice.h \
	src/data/scene/tree_parse.c \
	src/data/scene/tree_write.c \
	src/data/scene/unique.c \
	src/data/scene/unique.h \
	src/data/scene/units.c \
	src/data/scene/units.h
libscene_la_CPPFLAGS = $(AM_CPPFLAGS) $(YAML_CFLAGS) $(MPI_CFLAGS)
libscene_la_LIBADD = $(YAML_LIBS) $(ZLIB_LIBS)

EXTRA_DIST += docs/scene.md

# What writes docs/scene.md, after a change of the schema
EXTRA_PROGRAMS += src/data/scene/document_scene
CLEANFILES += src/data/scene/document_scene
src_data_scene_document_scene_SOURCES = src/data/scene/document_scene.c
src_data_scene_document_scene_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
src_data_scene_document_scene_LDADD = $(SCENE_LIBS)
