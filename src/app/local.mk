# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES = \
	src/app/ablate.c \
	src/app/ablate.h \
	src/app/ablate_error.c \
	src/app/ablate_error.h \
	src/app/ablate_run.c \
	src/app/ablate_run.h \
	src/app/check.c \
	src/app/check.h \
	src/app/check_parts.c \
	src/app/check_parts.h \
	src/app/cost.c \
	src/app/cost.h \
	src/app/command.c \
	src/app/command.h \
	src/app/command_line.c \
	src/app/command_line.h \
	src/app/layout.c \
	src/app/layout.h \
	src/app/lookup.c \
	src/app/lookup.h \
	src/app/manual.c \
	src/app/manual.h \
	src/app/pack.c \
	src/app/pack.h \
	src/app/pack_settle.c \
	src/app/pack_settle.h \
	src/app/page.c \
	src/app/page.h \
	src/app/picture.c \
	src/app/picture.h \
	src/app/program.c \
	src/app/sample.c \
	src/app/sample.h \
	src/app/speed_error.c \
	src/app/speed_error.h \
	src/app/speed_plot.c \
	src/app/speed_plot.h \
	src/app/speed_write.c \
	src/app/step_study.c \
	src/app/step_study.h \
	src/app/trial.c \
	src/app/trial.h \
	src/app/variant.c \
	src/app/variant.h
libapp_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) -DSCREE_PAGE_FOLDER='"$(pagedir)"'

bin_PROGRAMS += scree
scree_SOURCES = src/app/main.c
scree_LDADD = $(APP_LIBS)

# The manual page and the completions of bash, zsh and fish, which the program writes from its tables
nodist_man_MANS = scree.1
completionsdir = $(datadir)/bash-completion/completions
nodist_completions_DATA = completions/scree
zshdir = $(datadir)/zsh/site-functions
nodist_zsh_DATA = completions/_scree
fishdir = $(datadir)/fish/vendor_completions.d
nodist_fish_DATA = completions/scree.fish
CLEANFILES += scree.1 completions/scree completions/_scree completions/scree.fish
scree.1: scree$(EXEEXT)
	$(AM_V_GEN)./scree$(EXEEXT) help --man >$@.new && mv $@.new $@
completions/scree: scree$(EXEEXT)
	@$(MKDIR_P) completions
	$(AM_V_GEN)./scree$(EXEEXT) help --bash >$@.new && mv $@.new $@
completions/_scree: scree$(EXEEXT)
	@$(MKDIR_P) completions
	$(AM_V_GEN)./scree$(EXEEXT) help --zsh >$@.new && mv $@.new $@
completions/scree.fish: scree$(EXEEXT)
	@$(MKDIR_P) completions
	$(AM_V_GEN)./scree$(EXEEXT) help --fish >$@.new && mv $@.new $@
