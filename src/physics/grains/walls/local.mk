# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libwalls.la
libwalls_la_SOURCES = \
	%D%/mesh.c %D%/mesh_obj.c %D%/mesh_ply.c %D%/mesh_polygon.c %D%/mesh_shape.c %D%/mesh_stl.c %D%/wall_area.c \
	%D%/wall_bulk.c %D%/wall_field.c %D%/wall_free.c %D%/wall_free_create.c %D%/wall_grid.c %D%/wall_inside.c \
	%D%/wall_mesh.c %D%/wall_motion.c %D%/wall_patch.c %D%/wall_surface.c %D%/wall_touch.c %D%/wall_tree.c \
	%D%/walls.c %D%/walls_depth.c %D%/walls_displacement.c %D%/walls_foot.c %D%/walls_force.c %D%/walls_free.c \
	%D%/walls_history.c %D%/walls_near.c %D%/walls_overlap.c %D%/walls_pose.c %D%/walls_solid.c %D%/walls_sums.c \
	%D%/walls_touch.c %D%/walls_visit.c %D%/mesh.h %D%/mesh_shape.h %D%/wall.h %D%/wall_area.h %D%/wall_bulk.h \
	%D%/wall_field.h %D%/wall_free.h %D%/wall_grid.h %D%/wall_inside.h %D%/wall_mesh.h %D%/wall_motion.h \
	%D%/wall_options.h %D%/wall_solid.h %D%/wall_touch.h %D%/wall_tree.h %D%/walls_free.h %D%/walls_foot.h %D%/walls_history.h \
	%D%/walls_near.h %D%/walls_parts.h %D%/walls_touch.h
