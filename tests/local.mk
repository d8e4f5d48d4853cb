# SPDX-License-Identifier: BSD-3-Clause
# A test program names what it links with; cmocka comes by TEST_LIBS. A program that calls MPI states in the first
# comment of its source on how many ranks it is run: "Ranks: 1 2 3 4 8" (and "Long: 27" for check-long).
TEST_LIBS = $(CMOCKA_LIBS)
TEST_MPI_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(HDF5_CFLAGS)

EXTRA_DIST += tests/launch tests/lsan.supp tests/without_cmocka/cmocka.h

dist_check_SCRIPTS += tests/lint

# By hand: do the tests notice wrong code?
EXTRA_DIST += tests/mutate tests/mutants.txt tests/examples_sanitized.sh

check_PROGRAMS += \
	tests/test_checksum \
	tests/test_error \
	tests/test_memory \
	tests/test_random \
	tests/test_eigen3 \
	tests/test_hash \
	tests/test_scan \
	tests/test_team \
	tests/test_timer \
	tests/test_version

tests_test_checksum_SOURCES = tests/test_checksum.c
tests_test_checksum_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_error_SOURCES = tests/test_error.c
tests_test_error_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_memory_SOURCES = tests/test_memory.c
tests_test_memory_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_random_SOURCES = tests/test_random.c
tests_test_random_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_eigen3_SOURCES = tests/test_eigen3.c
tests_test_eigen3_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_hash_SOURCES = tests/test_hash.c
tests_test_hash_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_scan_SOURCES = tests/test_scan.c
tests_test_scan_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_team_SOURCES = tests/test_team.c
tests_test_team_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_timer_SOURCES = tests/test_timer.c
tests_test_timer_LDADD = $(CORE_LIBS) $(TEST_LIBS)
tests_test_version_SOURCES = tests/test_version.c
tests_test_version_LDADD = $(CORE_LIBS) $(TEST_LIBS)

check_PROGRAMS += \
	tests/test_force \
	tests/test_force_loop \
	tests/test_integrator \
	tests/test_law \
	tests/test_law_impact \
	tests/test_law_motion \
	tests/test_bonds \
	tests/test_law_parts \
	tests/test_law_range \
	tests/test_stability \
	tests/test_timestep
EXTRA_DIST += tests/fields_by_hand.h tests/forces_by_hand.h tests/law_parts_by_hand.h tests/laws_by_hand.h tests/near.h tests/own_law.h tests/pairs_by_hand.h tests/particles_by_hand.h
tests_test_force_SOURCES = tests/test_force.c
tests_test_force_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_force_loop_SOURCES = tests/test_force_loop.c
tests_test_force_loop_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_force_loop_CPPFLAGS = $(AM_CPPFLAGS)
if X86_KERNELS
tests_test_force_loop_CPPFLAGS += -DSCREE_X86_KERNELS
endif
tests_test_integrator_SOURCES = tests/test_integrator.c
tests_test_integrator_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_law_SOURCES = tests/test_law.c
tests_test_law_LDADD = $(WALLS_LIBS) $(TEST_LIBS)
tests_test_law_motion_SOURCES = tests/test_law_motion.c
tests_test_law_motion_LDADD = $(WALLS_LIBS) $(TEST_LIBS)
tests_test_bonds_SOURCES = tests/test_bonds.c
tests_test_bonds_LDADD = libbonds.la $(SCENE_LIBS) $(TEST_LIBS)
tests_test_law_parts_SOURCES = tests/test_law_parts.c
tests_test_law_parts_LDADD = $(WALLS_LIBS) $(TEST_LIBS)
tests_test_law_range_SOURCES = tests/test_law_range.c
tests_test_law_range_LDADD = $(WALLS_LIBS) $(TEST_LIBS)
tests_test_law_impact_SOURCES = tests/test_law_impact.c
tests_test_law_impact_LDADD = $(WALLS_LIBS) $(TEST_LIBS)
tests_test_stability_SOURCES = tests/test_stability.c
tests_test_stability_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_timestep_SOURCES = tests/test_timestep.c
tests_test_timestep_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_classes tests/test_history tests/test_pairlist tests/test_particles tests/test_sweep
EXTRA_DIST += tests/cloud_by_hand.h
tests_test_history_SOURCES = tests/test_history.c
tests_test_history_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)
tests_test_sweep_SOURCES = tests/test_sweep.c
tests_test_sweep_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)
tests_test_pairlist_SOURCES = tests/test_pairlist.c
tests_test_pairlist_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)
tests_test_classes_SOURCES = tests/test_classes.c
tests_test_classes_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_particles_SOURCES = tests/test_particles.c
tests_test_particles_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)

# The scene: what its headers include needs MPI's
check_PROGRAMS += \
	tests/test_generate \
	tests/test_insertion \
	tests/test_packed \
	tests/test_placegrid \
	tests/test_region \
	tests/test_scene \
	tests/test_scene_allowed \
	tests/test_scene_check \
	tests/test_scene_large \
	tests/test_scene_compare \
	tests/test_schema \
	tests/test_sizes \
	tests/test_source \
	tests/test_tree \
	tests/test_units
EXTRA_DIST += tests/scene_by_hand.h
tests_test_generate_SOURCES = tests/test_generate.c
tests_test_generate_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_generate_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_packed_SOURCES = tests/test_packed.c
tests_test_packed_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_packed_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_insertion_SOURCES = tests/test_insertion.c
tests_test_insertion_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_insertion_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_placegrid_SOURCES = tests/test_placegrid.c
tests_test_placegrid_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_placegrid_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_region_SOURCES = tests/test_region.c
tests_test_region_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_region_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_scene_SOURCES = tests/test_scene.c
tests_test_scene_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_scene_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_scene_allowed_SOURCES = tests/test_scene_allowed.c
tests_test_scene_allowed_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_scene_allowed_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_scene_check_SOURCES = tests/test_scene_check.c
tests_test_scene_check_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_scene_check_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_scene_large_SOURCES = tests/test_scene_large.c
tests_test_scene_large_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_scene_large_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_scene_compare_SOURCES = tests/test_scene_compare.c
tests_test_scene_compare_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_scene_compare_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_schema_SOURCES = tests/test_schema.c
tests_test_schema_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_schema_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_sizes_SOURCES = tests/test_sizes.c
tests_test_sizes_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_sizes_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_source_SOURCES = tests/test_source.c
tests_test_source_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_source_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_tree_SOURCES = tests/test_tree.c
tests_test_tree_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_tree_LDADD = $(SCENE_LIBS) $(TEST_LIBS)
tests_test_units_SOURCES = tests/test_units.c
tests_test_units_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_units_LDADD = $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_describe
tests_test_describe_SOURCES = tests/test_describe.c
tests_test_describe_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_describe_LDADD = $(ENGINE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_lammps
tests_test_lammps_SOURCES = tests/test_lammps.c
tests_test_lammps_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_lammps_LDADD = $(OBSERVE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_output_options
tests_test_output_options_SOURCES = tests/test_output_options.c
tests_test_output_options_LDADD = $(OBSERVE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_progress
tests_test_progress_SOURCES = tests/test_progress.c
tests_test_progress_LDADD = $(OBSERVE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_file
tests_test_file_SOURCES = tests/test_file.c
tests_test_file_LDADD = $(OBSERVE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_library
tests_test_library_SOURCES = tests/test_library.c
tests_test_library_LDADD = $(APP_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_interaction
tests_test_interaction_SOURCES = tests/test_interaction.c
tests_test_interaction_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_plan
tests_test_plan_SOURCES = tests/test_plan.c
tests_test_plan_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_plan_LDADD = libengine.la $(CORE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_skin_choice
tests_test_skin_choice_SOURCES = tests/test_skin_choice.c
tests_test_skin_choice_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)
check_PROGRAMS += tests/test_skin
tests_test_skin_SOURCES = tests/test_skin.c
tests_test_skin_LDADD = $(PAIRS_LIBS) $(TEST_LIBS)

# Beside LAMMPS; minutes
dist_check_SCRIPTS += tests/crosscode.sh tests/granular_lammps.sh
EXTRA_DIST += tests/granular/base.yaml tests/granular/dmt.dump.gz tests/granular/granular.data tests/granular/hertz.dump.gz \
	tests/granular/in.granular tests/granular/jkr.dump.gz tests/granular/laws tests/granular/mindlin_rescale.dump.gz \
	tests/granular/rescale_force.dump.gz tests/granular/rolling_sds.dump.gz tests/granular/twisting_marshall.dump.gz \
	tests/granular/in.sheared tests/granular/sheared.data tests/granular/sheared_0.dump.gz tests/granular/sheared_2.5.dump.gz \
	tests/granular/twisting_sds.dump.gz tests/granular/in.wall tests/granular/wall.data tests/granular/wall_laws \
	tests/granular/wall_hertz.dump.gz tests/granular/wall_rolling.dump.gz tests/granular/wall_twisting.dump.gz

# make tests/bench_force: times of the force loop
EXTRA_PROGRAMS += tests/bench_force
CLEANFILES += tests/bench_force
tests_bench_force_SOURCES = tests/bench_force.c
tests_bench_force_LDADD = $(INTEGRATE_LIBS)

# make tests/bench_triad: what memory and units give at most
EXTRA_PROGRAMS += tests/bench_triad
CLEANFILES += tests/bench_triad
tests_bench_triad_SOURCES = tests/bench_triad.c
tests_bench_triad_LDADD = $(CORE_LIBS)

check_PROGRAMS += \
	tests/test_mesh \
	tests/test_mesh_ply \
	tests/test_wall \
	tests/test_wall_edge \
	tests/test_wall_history \
	tests/test_wall_images \
	tests/test_wall_mesh \
	tests/test_wall_motion \
	tests/test_wall_moving \
	tests/test_wall_touch
EXTRA_DIST += tests/mesh_by_hand.h tests/surface_by_hand.h tests/walls_by_hand.h
tests_test_mesh_SOURCES = tests/test_mesh.c
tests_test_mesh_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_mesh_ply_SOURCES = tests/test_mesh_ply.c
tests_test_mesh_ply_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_SOURCES = tests/test_wall.c
tests_test_wall_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_edge_SOURCES = tests/test_wall_edge.c
tests_test_wall_edge_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_mesh_SOURCES = tests/test_wall_mesh.c
tests_test_wall_mesh_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_motion_SOURCES = tests/test_wall_motion.c
tests_test_wall_motion_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_history_SOURCES = tests/test_wall_history.c
tests_test_wall_history_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_images_SOURCES = tests/test_wall_images.c
tests_test_wall_images_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_moving_SOURCES = tests/test_wall_moving.c
tests_test_wall_moving_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)
tests_test_wall_touch_SOURCES = tests/test_wall_touch.c
tests_test_wall_touch_LDADD = $(INTEGRATE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_pack tests/test_pack_draw
tests_test_pack_SOURCES = tests/test_pack.c
tests_test_pack_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_pack_LDADD = $(PACK_LIBS) $(TEST_LIBS)
tests_test_pack_draw_SOURCES = tests/test_pack_draw.c
tests_test_pack_draw_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_pack_draw_LDADD = $(PACK_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_exact
tests_test_exact_SOURCES = tests/test_exact.c
tests_test_exact_LDADD = $(CORE_LIBS) $(TEST_LIBS)

# A tool of tests/app/reproducible.sh
EXTRA_PROGRAMS += tests/checkpoint_lines
CLEANFILES += tests/checkpoint_lines
tests/app/reproducible.log: tests/checkpoint_lines
tests_checkpoint_lines_SOURCES = tests/checkpoint_lines.c
tests_checkpoint_lines_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_checkpoint_lines_LDADD = $(OBSERVE_LIBS)

check_PROGRAMS += tests/test_hard
tests_test_hard_SOURCES = tests/test_hard.c
tests_test_hard_LDADD = libhard.la $(CORE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_bodies
tests_test_bodies_SOURCES = tests/test_bodies.c
tests_test_bodies_LDADD = libbodies.la $(CORE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_clump
tests_test_clump_SOURCES = tests/test_clump.c
tests_test_clump_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_clump_LDADD = libbodies.la $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_bonds_links
tests_test_bonds_links_SOURCES = tests/test_bonds_links.c
tests_test_bonds_links_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_bonds_links_LDADD = libbonds.la $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_drag
tests_test_drag_SOURCES = tests/test_drag.c
tests_test_drag_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_drag_LDADD = libdrag.la $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_board
tests_test_board_SOURCES = tests/test_board.c
tests_test_board_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_board_LDADD = $(VIEW_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_operators
tests_test_fluid_operators_SOURCES = tests/test_fluid_operators.c tests/fluid_cloud.c tests/fluid_cloud.h
tests_test_fluid_operators_LDADD = $(FLUID_LIBS) $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_drive
tests_test_fluid_drive_SOURCES = tests/test_fluid_drive.c
tests_test_fluid_drive_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_fluid_drive_LDADD = $(FLUID_LIBS) $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_layer
tests_test_fluid_layer_SOURCES = tests/test_fluid_layer.c
tests_test_fluid_layer_LDADD = $(FLUID_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_walls
tests_test_fluid_walls_SOURCES = tests/test_fluid_walls.c tests/fluid_cloud.c tests/fluid_cloud.h
tests_test_fluid_walls_CPPFLAGS = $(TEST_MPI_CPPFLAGS)
tests_test_fluid_walls_LDADD = $(FLUID_LIBS) $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_mls
tests_test_fluid_mls_SOURCES = tests/test_fluid_mls.c tests/fluid_cloud.c tests/fluid_cloud.h
tests_test_fluid_mls_LDADD = $(FLUID_LIBS) $(SCENE_LIBS) $(TEST_LIBS)

check_PROGRAMS += tests/test_fluid_pattern
tests_test_fluid_pattern_SOURCES = tests/test_fluid_pattern.c
tests_test_fluid_pattern_LDADD = $(FLUID_LIBS) $(TEST_LIBS)
