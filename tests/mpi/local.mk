# SPDX-License-Identifier: BSD-3-Clause
# Tests of the communication; most run under mpirun, on the rank counts that their source states.

check_PROGRAMS += \
	tests/mpi/test_comm \
	tests/mpi/test_copies \
	tests/mpi/test_domain \
	tests/mpi/test_exchange \
	tests/mpi/test_ghosts \
	tests/mpi/test_ghosts_sums \
	tests/mpi/test_groups \
	tests/mpi/test_migrate \
	tests/mpi/test_shadows \
	tests/mpi/test_shear

MPI_TEST_FLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
MPI_TEST_LIBS = libintegrate.la libwalls.la libcontact.la $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)

tests_mpi_test_comm_SOURCES = tests/mpi/test_comm.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_comm_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_comm_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_copies_SOURCES = tests/mpi/test_copies.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h tests/mpi/fixture.c tests/mpi/fixture.h
tests_mpi_test_copies_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_copies_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_domain_SOURCES = tests/mpi/test_domain.c
tests_mpi_test_domain_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_domain_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_exchange_SOURCES = tests/mpi/test_exchange.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_exchange_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_exchange_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_ghosts_SOURCES = tests/mpi/test_ghosts.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h tests/mpi/fixture.c tests/mpi/fixture.h
tests_mpi_test_ghosts_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_ghosts_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_ghosts_sums_SOURCES = tests/mpi/test_ghosts_sums.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h tests/mpi/fixture.c tests/mpi/fixture.h
tests_mpi_test_ghosts_sums_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_ghosts_sums_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_groups_SOURCES = tests/mpi/test_groups.c
tests_mpi_test_groups_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_groups_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_migrate_SOURCES = tests/mpi/test_migrate.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h
tests_mpi_test_migrate_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_migrate_LDADD = $(MPI_TEST_LIBS)

tests_mpi_test_shear_SOURCES = tests/mpi/test_shear.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h
tests_mpi_test_shear_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_shear_LDADD = $(MPI_TEST_LIBS)
tests_mpi_test_shadows_SOURCES = tests/mpi/test_shadows.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_shadows_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_shadows_LDADD = $(MPI_TEST_LIBS)

check_PROGRAMS += tests/mpi/test_balance
tests_mpi_test_balance_SOURCES = tests/mpi/test_balance.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_balance_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_balance_LDADD = $(MPI_TEST_LIBS)

check_PROGRAMS += tests/mpi/test_scene_ranks
tests_mpi_test_scene_ranks_SOURCES = tests/mpi/test_scene_ranks.c tests/mpi/folder.c tests/mpi/folder.h
tests_mpi_test_scene_ranks_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_scene_ranks_LDADD = $(SCENE_LIBS) $(TEST_LIBS) $(MPI_LIBS)

check_PROGRAMS += \
	tests/mpi/test_checkpoint \
	tests/mpi/test_checkpoint_damage \
	tests/mpi/test_dump \
	tests/mpi/test_h5md \
	tests/mpi/test_h5md_read \
	tests/mpi/test_h5md_run \
	tests/mpi/test_observables \
	tests/mpi/test_report \
	tests/mpi/test_stress

OUTPUT_TEST_SOURCES = tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h tests/mpi/folder.c tests/mpi/folder.h
OUTPUT_TEST_FLAGS = $(MPI_TEST_FLAGS) $(HDF5_CFLAGS)
OUTPUT_TEST_LIBS = $(OBSERVE_LIBS) $(TEST_LIBS) $(HDF5_LIBS) $(MPI_LIBS)

tests_mpi_test_checkpoint_SOURCES = tests/mpi/test_checkpoint.c tests/mpi/state.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_checkpoint_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_checkpoint_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_checkpoint_damage_SOURCES = tests/mpi/test_checkpoint_damage.c tests/mpi/state.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_checkpoint_damage_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_checkpoint_damage_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_dump_SOURCES = tests/mpi/test_dump.c $(OUTPUT_TEST_SOURCES)
tests_mpi_test_dump_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_dump_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_h5md_SOURCES = tests/mpi/test_h5md.c tests/mpi/trajectory.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_h5md_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_h5md_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_h5md_read_SOURCES = tests/mpi/test_h5md_read.c tests/mpi/trajectory.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_h5md_read_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_h5md_read_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_h5md_run_SOURCES = tests/mpi/test_h5md_run.c tests/mpi/trajectory.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_h5md_run_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_h5md_run_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_observables_SOURCES = tests/mpi/test_observables.c tests/mpi/observed.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_observables_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_observables_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_report_SOURCES = tests/mpi/test_report.c $(OUTPUT_TEST_SOURCES)
tests_mpi_test_report_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_report_LDADD = $(OUTPUT_TEST_LIBS)
tests_mpi_test_stress_SOURCES = tests/mpi/test_stress.c tests/mpi/observed.h $(OUTPUT_TEST_SOURCES)
tests_mpi_test_stress_CPPFLAGS = $(OUTPUT_TEST_FLAGS)
tests_mpi_test_stress_LDADD = $(OUTPUT_TEST_LIBS)

# make tests/mpi/bench_ranks: what has the length of the rank count
EXTRA_PROGRAMS += tests/mpi/bench_ranks
CLEANFILES += tests/mpi/bench_ranks
tests_mpi_bench_ranks_SOURCES = tests/mpi/bench_ranks.c
tests_mpi_bench_ranks_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_bench_ranks_LDADD = $(COMM_LIBS) $(MPI_LIBS)

check_PROGRAMS += tests/mpi/test_solve
tests_mpi_test_solve_SOURCES = tests/mpi/test_solve.c tests/mpi/lattice_matrix.c tests/mpi/lattice_matrix.h tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_solve_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_solve_LDADD = $(SOLVE_LIBS) $(TEST_LIBS) $(MPI_LIBS)

check_PROGRAMS += tests/mpi/test_solve_interface
tests_mpi_test_solve_interface_SOURCES = tests/mpi/test_solve_interface.c tests/mpi/lattice_matrix.c tests/mpi/lattice_matrix.h tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_solve_interface_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_solve_interface_LDADD = $(SOLVE_LIBS) $(TEST_LIBS) $(MPI_LIBS)

check_PROGRAMS += tests/mpi/test_projection
tests_mpi_test_projection_SOURCES = tests/mpi/test_projection.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_projection_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_projection_LDADD = $(FLUID_LIBS) $(TEST_LIBS) $(MPI_LIBS)

check_PROGRAMS += tests/mpi/test_regions
tests_mpi_test_regions_SOURCES = tests/mpi/test_regions.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_regions_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_regions_LDADD = libfluid.la $(SOLVE_LIBS) $(SCENE_LIBS) $(TEST_LIBS) $(MPI_LIBS)

# The engine as a library
check_PROGRAMS += tests/mpi/test_library
tests_mpi_test_library_SOURCES = tests/mpi/test_library.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_library_CPPFLAGS = $(MPI_TEST_FLAGS)
tests_mpi_test_library_LDADD = $(APP_LIBS) $(TEST_LIBS) $(MPI_LIBS)
