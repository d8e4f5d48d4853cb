# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libwalls.la
libwalls_la_SOURCES = \
	src/walls/mesh.c \
	src/walls/mesh.h \
	src/walls/mesh_obj.c \
	src/walls/mesh_ply.c \
	src/walls/mesh_polygon.c \
	src/walls/mesh_shape.c \
	src/walls/mesh_shape.h \
	src/walls/mesh_stl.c \
	src/walls/wall.h \
	src/walls/wall_area.c \
	src/walls/wall_area.h \
	src/walls/wall_grid.c \
	src/walls/wall_grid.h \
	src/walls/wall_inside.c \
	src/walls/wall_inside.h \
	src/walls/wall_mesh.c \
	src/walls/wall_mesh.h \
	src/walls/wall_motion.c \
	src/walls/wall_motion.h \
	src/walls/wall_patch.c \
	src/walls/wall_surface.c \
	src/walls/wall_touch.c \
	src/walls/wall_touch.h \
	src/walls/walls.c \
	src/walls/walls_displacement.c \
	src/walls/walls_foot.c \
	src/walls/walls_force.c \
	src/walls/walls_history.c \
	src/walls/walls_history.h \
	src/walls/walls_near.c \
	src/walls/walls_near.h \
	src/walls/walls_overlap.c \
	src/walls/walls_parts.h \
	src/walls/walls_pose.c \
	src/walls/walls_sums.c \
	src/walls/walls_visit.c \
	src/walls/walls_touch.c \
	src/walls/walls_touch.h
