# SPDX-License-Identifier: BSD-3-Clause
# A test program is one name in check_PROGRAMS: its source is NAME.c, its flags and libraries are those of all programs
# (AM_CPPFLAGS, LDADD), and what several tests share is in libtests. A program that calls MPI states in the first comment
# of its source on how many ranks it is run: "Ranks: 1 2 3 4 8" (and "Long: 27" for check-long).

check_PROGRAMS += \
	%D%/index/test_auto %D%/index/test_index %D%/index/test_levels %D%/index/test_stay %D%/index/test_stencil \
	%D%/index/test_wanted %D%/mpi/test_balance %D%/mpi/test_checkpoint %D%/mpi/test_checkpoint_damage \
	%D%/mpi/test_comm %D%/mpi/test_copies %D%/mpi/test_domain %D%/mpi/test_dump %D%/mpi/test_exchange \
	%D%/mpi/test_ghosts %D%/mpi/test_ghosts_sums %D%/mpi/test_groups %D%/mpi/test_h5md %D%/mpi/test_h5md_read \
	%D%/mpi/test_h5md_run %D%/mpi/test_library %D%/mpi/test_migrate %D%/mpi/test_observables \
	%D%/mpi/test_projection %D%/mpi/test_regions %D%/mpi/test_report %D%/mpi/test_scene_ranks \
	%D%/mpi/test_shadows %D%/mpi/test_shear %D%/mpi/test_solve %D%/mpi/test_solve_interface %D%/mpi/test_stress \
	%D%/test_board %D%/test_bodies %D%/test_bonds %D%/test_bonds_links %D%/test_checksum %D%/test_classes \
	%D%/test_clump %D%/test_describe %D%/test_drag %D%/test_eigen3 %D%/test_error %D%/test_exact %D%/test_file \
	%D%/test_fluid_arrangement %D%/test_fluid_body_surfaces %D%/test_fluid_correction_tensors \
	%D%/test_fluid_drive %D%/test_fluid_gradient_correction %D%/test_fluid_grain_coupling %D%/test_fluid_layer \
	%D%/test_fluid_mirror %D%/test_fluid_mls %D%/test_fluid_open_sides %D%/test_fluid_operators \
	%D%/test_fluid_particle_shift %D%/test_fluid_pattern %D%/test_fluid_residual %D%/test_fluid_scalar_links \
	%D%/test_fluid_walls %D%/test_force %D%/test_force_loop %D%/test_generate %D%/test_hard %D%/test_hash \
	%D%/test_history %D%/test_insertion %D%/test_integrator %D%/test_interaction %D%/test_lammps %D%/test_law \
	%D%/test_law_impact %D%/test_law_motion %D%/test_law_parts %D%/test_law_range %D%/test_library \
	%D%/test_memory %D%/test_mesh %D%/test_mesh_ply %D%/test_output_options %D%/test_pack %D%/test_pack_draw \
	%D%/test_packed %D%/test_pairlist %D%/test_particles %D%/test_placegrid %D%/test_plan %D%/test_progress \
	%D%/test_random %D%/test_region %D%/test_scan %D%/test_scene %D%/test_scene_allowed %D%/test_scene_check \
	%D%/test_scene_compare %D%/test_scene_large %D%/test_schema %D%/test_sizes %D%/test_skin \
	%D%/test_skin_choice %D%/test_source %D%/test_stability %D%/test_sweep %D%/test_team %D%/test_timer \
	%D%/test_timestep %D%/test_tree %D%/test_units %D%/test_version %D%/test_wall %D%/test_wall_edge \
	%D%/test_wall_history %D%/test_wall_images %D%/test_wall_mesh %D%/test_wall_motion %D%/test_wall_moving \
	%D%/test_wall_touch
check_LTLIBRARIES += libtests.la
libtests_la_SOURCES = \
	%D%/fluid_cloud.c %D%/index/bench_fit.c %D%/index/bench_scene.c %D%/index/index_cloud.c %D%/mpi/cloud.c \
	%D%/mpi/fixture.c %D%/mpi/folder.c %D%/mpi/lattice_matrix.c %D%/mpi/team.c %D%/cloud_by_hand.h \
	%D%/fields_by_hand.h %D%/fluid_cloud.h %D%/forces_by_hand.h %D%/index/bench_fit.h %D%/index/bench_scene.h \
	%D%/index/index_cloud.h %D%/law_parts_by_hand.h %D%/laws_by_hand.h %D%/mesh_by_hand.h %D%/mpi/cloud.h \
	%D%/mpi/fixture.h %D%/mpi/folder.h %D%/mpi/lattice_matrix.h %D%/mpi/observed.h %D%/mpi/state.h \
	%D%/mpi/team.h %D%/mpi/trajectory.h %D%/near.h %D%/own_law.h %D%/pairs_by_hand.h %D%/particles_by_hand.h \
	%D%/scene_by_hand.h %D%/surface_by_hand.h %D%/test.h %D%/walls_by_hand.h
EXTRA_DIST += \
	%D%/examples_sanitized.sh %D%/granular/base.yaml %D%/granular/dmt.dump.gz %D%/granular/granular.data \
	%D%/granular/hertz.dump.gz %D%/granular/in.granular %D%/granular/in.sheared %D%/granular/in.wall \
	%D%/granular/jkr.dump.gz %D%/granular/laws %D%/granular/mindlin_rescale.dump.gz \
	%D%/granular/rescale_force.dump.gz %D%/granular/rolling_sds.dump.gz %D%/granular/sheared.data \
	%D%/granular/sheared_0.dump.gz %D%/granular/sheared_2.5.dump.gz %D%/granular/twisting_marshall.dump.gz \
	%D%/granular/twisting_sds.dump.gz %D%/granular/wall.data %D%/granular/wall_hertz.dump.gz \
	%D%/granular/wall_laws %D%/granular/wall_rolling.dump.gz %D%/granular/wall_twisting.dump.gz %D%/launch \
	%D%/lsan.supp %D%/mutants.txt %D%/mutate %D%/without_cmocka/cmocka.h
tests_test_force_loop_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)

dist_check_SCRIPTS += %D%/crosscode.sh %D%/granular_lammps.sh %D%/lint

# make tests/bench_NAME: times of the force loop, what memory and units give at most, indexes, and what has the length of
# the rank count. checkpoint_lines is a tool of tests/app.
EXTRA_PROGRAMS += %D%/bench_force %D%/bench_triad %D%/checkpoint_lines %D%/index/bench_index %D%/mpi/bench_ranks
CLEANFILES += %D%/bench_force %D%/bench_triad %D%/checkpoint_lines %D%/index/bench_index %D%/mpi/bench_ranks
tests/app/bench.log: tests/bench_triad tests/index/bench_index
tests/app/random_scenes.log tests/app/ranks.log tests/app/reproducible.log: tests/checkpoint_lines
