# SPDX-License-Identifier: BSD-3-Clause
# A test program is one name in check_PROGRAMS: its source is NAME.c, its flags and libraries are those of all programs
# (AM_CPPFLAGS, LDADD), and what several tests share is in libtests. A program that calls MPI states in the first comment
# of its source on how many ranks it is run: "Ranks: 1 2 3 4 8" (and "Long: 27" for check-long).

check_PROGRAMS += \
	%D%/base/test_checksum %D%/base/test_eigen3 %D%/base/test_error %D%/base/test_exact \
	%D%/base/test_file %D%/base/test_hash %D%/base/test_memory %D%/base/test_random %D%/base/test_scan \
	%D%/base/test_team %D%/base/test_timer %D%/base/test_version %D%/data/formats/test_lammps \
	%D%/data/formats/test_output_options %D%/data/observe/test_describe %D%/data/observe/test_progress \
	%D%/data/scene/test_generate %D%/data/scene/test_insertion %D%/data/scene/test_packed \
	%D%/data/scene/test_placegrid %D%/data/scene/test_region %D%/data/scene/test_scene \
	%D%/data/scene/test_scene_allowed %D%/data/scene/test_scene_check %D%/data/scene/test_scene_compare \
	%D%/data/scene/test_scene_large %D%/data/scene/test_schema %D%/data/scene/test_sizes \
	%D%/data/scene/test_source %D%/data/scene/test_tree %D%/data/scene/test_units %D%/engine/test_plan \
	%D%/front/library/test_library %D%/front/pack/test_pack %D%/front/pack/test_pack_draw \
	%D%/front/view/test_board %D%/index/test_auto %D%/index/test_events %D%/index/test_index \
	%D%/index/test_levels %D%/index/test_stay %D%/index/test_stencil %D%/index/test_wanted \
	%D%/kernel/pairs/test_history %D%/kernel/pairs/test_interaction %D%/kernel/pairs/test_pairlist \
	%D%/kernel/pairs/test_skin %D%/kernel/pairs/test_skin_choice %D%/kernel/pairs/test_sweep \
	%D%/kernel/particles/test_classes %D%/kernel/particles/test_particles %D%/mpi/test_balance \
	%D%/mpi/test_checkpoint %D%/mpi/test_checkpoint_damage %D%/mpi/test_comm %D%/mpi/test_copies \
	%D%/mpi/test_domain %D%/mpi/test_dump %D%/mpi/test_exchange %D%/mpi/test_fluid_coupled_solve \
	%D%/mpi/test_fluid_electrolyte %D%/mpi/test_fluid_matrices %D%/mpi/test_fluid_moving_step \
	%D%/mpi/test_fluid_nodes %D%/mpi/test_fluid_passes %D%/mpi/test_fluid_rigid_bodies \
	%D%/mpi/test_fluid_rigid_motion %D%/mpi/test_fluid_rigid_step %D%/mpi/test_fluid_rigid_walls \
	%D%/mpi/test_fluid_scalars %D%/mpi/test_fluid_solver_watch %D%/mpi/test_fluid_surroundings \
	%D%/mpi/test_ghosts %D%/mpi/test_ghosts_sums %D%/mpi/test_groups %D%/mpi/test_h5md \
	%D%/mpi/test_h5md_read %D%/mpi/test_h5md_run %D%/mpi/test_library %D%/mpi/test_migrate \
	%D%/mpi/test_mover %D%/mpi/test_observables %D%/mpi/test_projection %D%/mpi/test_regions \
	%D%/mpi/test_report %D%/mpi/test_scene_ranks %D%/mpi/test_shadows %D%/mpi/test_shear \
	%D%/mpi/test_solve %D%/mpi/test_solve_interface %D%/mpi/test_stress \
	%D%/physics/bodies/shapes/test_chamfer %D%/physics/bodies/shapes/test_solid \
	%D%/physics/bodies/shapes/test_stiff %D%/physics/bodies/shapes/test_touch \
	%D%/physics/bodies/test_bodies %D%/physics/bodies/test_clump %D%/physics/bonds/test_bonds \
	%D%/physics/bonds/test_bonds_links %D%/physics/drag/test_drag \
	%D%/physics/fluid/carried/test_fluid_layer %D%/physics/fluid/carried/test_fluid_scalar_links \
	%D%/physics/fluid/coupling/test_fluid_grain_coupling \
	%D%/physics/fluid/coupling/test_fluid_grain_surfaces \
	%D%/physics/fluid/coupling/test_fluid_lubrication %D%/physics/fluid/coupling/test_fluid_rigid \
	%D%/physics/fluid/lattice/test_fluid_arrangement %D%/physics/fluid/lattice/test_fluid_body_surfaces \
	%D%/physics/fluid/lattice/test_fluid_mirror %D%/physics/fluid/lattice/test_fluid_pattern \
	%D%/physics/fluid/lattice/test_fluid_walls %D%/physics/fluid/operators/test_fluid_correction_tensors \
	%D%/physics/fluid/operators/test_fluid_gradient_correction %D%/physics/fluid/operators/test_fluid_mls \
	%D%/physics/fluid/operators/test_fluid_operators %D%/physics/fluid/schemes/test_fluid_drive \
	%D%/physics/fluid/schemes/test_fluid_open_sides %D%/physics/fluid/schemes/test_fluid_particle_shift \
	%D%/physics/fluid/schemes/test_fluid_residual %D%/physics/grains/batch/test_force \
	%D%/physics/grains/batch/test_force_loop %D%/physics/grains/laws/test_law \
	%D%/physics/grains/laws/test_law_impact %D%/physics/grains/laws/test_law_loops \
	%D%/physics/grains/laws/test_law_motion %D%/physics/grains/laws/test_law_parts \
	%D%/physics/grains/laws/test_law_range %D%/physics/grains/motion/test_integrator \
	%D%/physics/grains/motion/test_stability %D%/physics/grains/motion/test_timestep \
	%D%/physics/grains/walls/test_mesh %D%/physics/grains/walls/test_mesh_ply \
	%D%/physics/grains/walls/test_wall %D%/physics/grains/walls/test_wall_depth \
	%D%/physics/grains/walls/test_wall_edge %D%/physics/grains/walls/test_wall_field \
	%D%/physics/grains/walls/test_wall_free %D%/physics/grains/walls/test_wall_history \
	%D%/physics/grains/walls/test_wall_images %D%/physics/grains/walls/test_wall_mesh \
	%D%/physics/grains/walls/test_wall_motion %D%/physics/grains/walls/test_wall_moving \
	%D%/physics/grains/walls/test_wall_touch %D%/physics/hard/test_hard %D%/physics/hard/test_models \
	%D%/physics/hard/test_newton %D%/physics/hard/test_pull %D%/physics/hard/test_resist
check_LTLIBRARIES += libtests.la
libtests_la_SOURCES = \
	%D%/index/bench_events.c %D%/index/bench_fit.c %D%/index/bench_scene.c %D%/index/index_cloud.c \
	%D%/mpi/cloud.c %D%/mpi/fixture.c %D%/mpi/fluid_run.c %D%/mpi/folder.c %D%/mpi/lattice_matrix.c \
	%D%/mpi/team.c %D%/physics/fluid/fluid_cloud.c %D%/fields_by_hand.h %D%/index/bench_events.h \
	%D%/index/bench_fit.h %D%/index/bench_scene.h %D%/index/index_cloud.h \
	%D%/kernel/pairs/cloud_by_hand.h %D%/mpi/cloud.h %D%/mpi/fixture.h %D%/mpi/fluid_run.h \
	%D%/mpi/folder.h %D%/mpi/lattice_matrix.h %D%/mpi/observed.h %D%/mpi/state.h %D%/mpi/team.h \
	%D%/mpi/trajectory.h %D%/near.h %D%/own_law.h %D%/particles_by_hand.h \
	%D%/physics/bodies/shapes/solid_by_hand.h %D%/physics/fluid/fluid_cloud.h \
	%D%/physics/grains/forces_by_hand.h %D%/physics/grains/laws/law_parts_by_hand.h \
	%D%/physics/grains/laws/laws_by_hand.h %D%/physics/grains/pairs_by_hand.h \
	%D%/physics/grains/walls/mesh_by_hand.h %D%/physics/grains/walls/surface_by_hand.h \
	%D%/physics/grains/walls/walls_by_hand.h %D%/scene_by_hand.h %D%/test.h
EXTRA_DIST += \
	%D%/examples_sanitized.sh %D%/granular/base.yaml %D%/granular/dmt.dump.gz %D%/granular/granular.data \
	%D%/granular/hertz.dump.gz %D%/granular/in.granular %D%/granular/in.sheared %D%/granular/in.wall \
	%D%/granular/jkr.dump.gz %D%/granular/laws %D%/granular/mindlin_rescale.dump.gz \
	%D%/granular/rescale_force.dump.gz %D%/granular/rolling_sds.dump.gz %D%/granular/sheared.data \
	%D%/granular/sheared_0.dump.gz %D%/granular/sheared_2.5.dump.gz %D%/granular/twisting_marshall.dump.gz \
	%D%/granular/twisting_sds.dump.gz %D%/granular/wall.data %D%/granular/wall_hertz.dump.gz \
	%D%/granular/wall_laws %D%/granular/wall_rolling.dump.gz %D%/granular/wall_twisting.dump.gz %D%/launch \
	%D%/lsan.supp %D%/mutants.txt %D%/mutate %D%/physics/bodies/shapes/fcl_pairs.cpp %D%/without_cmocka/cmocka.h
tests_physics_bodies_shapes_test_touch_CPPFLAGS = $(AM_CPPFLAGS) $(CCD_CFLAGS)
tests_physics_bodies_shapes_test_touch_LDADD = $(LDADD) $(CCD_LIBS)
tests_physics_grains_batch_test_force_loop_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)

dist_check_SCRIPTS += %D%/crosscode.sh %D%/granular_lammps.sh %D%/lint %D%/rock_distance.sh
tests/rock_distance.log: tests/physics/bodies/shapes/rock_pairs

# make tests/bench_NAME: times of the force loop, what memory and units give at most, indexes, and what has the length of
# the rank count. checkpoint_lines is a tool of tests/app.
EXTRA_PROGRAMS += \
	%D%/bench_force %D%/bench_triad %D%/checkpoint_lines %D%/index/bench_index %D%/mpi/bench_ranks \
	%D%/physics/bodies/shapes/rock_pairs %D%/physics/hard/oracle
CLEANFILES += %D%/bench_force %D%/bench_triad %D%/checkpoint_lines %D%/index/bench_index %D%/mpi/bench_ranks
# oracle.sh solves contact problems again by Siconos, where that is there
if HAVE_SICONOS
tests/app/oracle.log: tests/physics/hard/oracle
endif
CLEANFILES += %D%/physics/hard/oracle %D%/physics/bodies/shapes/rock_pairs
tests_physics_hard_oracle_CPPFLAGS = $(AM_CPPFLAGS) $(SICONOS_CFLAGS)
tests_physics_hard_oracle_LDADD = $(SICONOS_LIBS) $(HDF5_LIBS) $(MPI_LIBS)
tests/app/bench.log: tests/bench_triad tests/index/bench_index
tests/app/random_scenes.log tests/app/ranks.log tests/app/reproducible.log: tests/checkpoint_lines
