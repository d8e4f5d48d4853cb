# Tests that run under mpirun: check_PROGRAMS += tests/mpi/test_X, with the MPI flags in their CPPFLAGS
