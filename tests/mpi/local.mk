# Tests that run under mpirun: check_PROGRAMS += tests/mpi/test_X, with the MPI flags in their CPPFLAGS

check_PROGRAMS += \
	tests/mpi/test_comm \
	tests/mpi/test_domain \
	tests/mpi/test_exchange \
	tests/mpi/test_ghosts \
	tests/mpi/test_migrate

tests_mpi_test_comm_SOURCES = tests/mpi/test_comm.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_comm_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
tests_mpi_test_comm_LDADD = $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)
tests_mpi_test_domain_SOURCES = tests/mpi/test_domain.c
tests_mpi_test_domain_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
tests_mpi_test_domain_LDADD = $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)
tests_mpi_test_exchange_SOURCES = tests/mpi/test_exchange.c tests/mpi/team.c tests/mpi/team.h
tests_mpi_test_exchange_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
tests_mpi_test_exchange_LDADD = $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)
tests_mpi_test_ghosts_SOURCES = tests/mpi/test_ghosts.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h
tests_mpi_test_ghosts_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
tests_mpi_test_ghosts_LDADD = $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)
tests_mpi_test_migrate_SOURCES = tests/mpi/test_migrate.c tests/mpi/team.c tests/mpi/team.h tests/mpi/cloud.c tests/mpi/cloud.h
tests_mpi_test_migrate_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(CMOCKA_CFLAGS) -I$(top_srcdir)/tests/mpi
tests_mpi_test_migrate_LDADD = $(COMM_LIBS) $(TEST_LIBS) $(MPI_LIBS)
