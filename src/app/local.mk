noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES = \
	src/app/ablate.c \
	src/app/check.c \
	src/app/command.c src/app/command.h \
	src/app/guards.c \
	src/app/outputs.c src/app/outputs.h \
	src/app/rebuild.c \
	src/app/resume.c \
	src/app/run.c src/app/run.h \
	src/app/simulation.c src/app/simulation.h \
	src/app/sources.c \
	src/app/step.c \
	src/app/timing.c

libapp_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)

bin_PROGRAMS += scree
scree_SOURCES = src/app/main.c
scree_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
scree_LDADD = $(APP_LIBS)
