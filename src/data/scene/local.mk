# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libscene.la
libscene_la_SOURCES = \
	%D%/compare.c %D%/decimal.c %D%/finish.c %D%/finish_box.c %D%/insertion.c %D%/lattice.c %D%/mistakes.c \
	%D%/pack/pack_search.c %D%/pack/pile.c %D%/pack/push.c %D%/pack/relax.c %D%/packed.c %D%/packed_radii.c \
	%D%/placegrid.c %D%/region.c %D%/scatter.c %D%/scene.c %D%/scene_check.c %D%/scene_check_box.c \
	%D%/scene_check_output.c %D%/scene_check_walls.c %D%/scene_files.c %D%/scene_particles.c %D%/scene_read.c \
	%D%/scene_shapes.c %D%/scene_stage.c %D%/scene_text.c %D%/schema.c %D%/schema_contact.c %D%/schema_help.c \
	%D%/schema_normalise.c %D%/schema_output.c %D%/schema_particles.c %D%/schema_read.c %D%/schema_root.c \
	%D%/schema_search.c %D%/schema_set.c %D%/schema_stage.c %D%/schema_unknown.c %D%/schema_value.c \
	%D%/schema_walls.c %D%/schema_write.c %D%/sizes.c %D%/sizes_file.c %D%/source_batch.c %D%/source_bodies.c \
	%D%/source_ids.c %D%/source_radii.c %D%/source_sphere.c %D%/synonyms.c %D%/table.c %D%/table_lines.c \
	%D%/tree.c %D%/tree_advice.c %D%/tree_parse.c %D%/tree_write.c %D%/unique.c %D%/units.c %D%/compare.h \
	%D%/decimal.h %D%/finish.h %D%/insertion.h %D%/mistakes.h %D%/pack/pack_search.h %D%/pack/pile.h \
	%D%/pack/relax.h %D%/packed.h %D%/packed_radii.h %D%/placegrid.h %D%/region.h %D%/scene.h %D%/scene_check.h \
	%D%/scene_files.h %D%/scene_particles.h %D%/scene_read.h %D%/scene_sections.h %D%/scene_shapes.h \
	%D%/scene_share.h %D%/scene_stage.h %D%/scene_text.h %D%/schema.h %D%/schema_help.h %D%/schema_normalise.h \
	%D%/schema_output.h %D%/schema_particles.h %D%/schema_read.h %D%/schema_root.h %D%/schema_rows.h \
	%D%/schema_sections.h %D%/schema_unknown.h %D%/schema_value.h %D%/sizes.h %D%/sizes_file.h %D%/source.h \
	%D%/source_batch.h %D%/source_bodies.h %D%/source_makers.h %D%/source_radii.h %D%/source_sphere.h %D%/tree.h \
	%D%/tree_advice.h %D%/units.h
libscene_la_CPPFLAGS = $(AM_CPPFLAGS) $(YAML_CFLAGS)
libscene_la_LIBADD = $(YAML_LIBS) $(ZLIB_LIBS)

EXTRA_DIST += docs/scene.md

# What writes docs/scene.md, after a change of the schema
EXTRA_PROGRAMS += %D%/document_scene
CLEANFILES += %D%/document_scene
