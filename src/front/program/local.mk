# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES = \
	src/front/program/ablate.c \
	src/front/program/ablate.h \
	src/front/program/ablate_error.c \
	src/front/program/ablate_error.h \
	src/front/program/ablate_run.c \
	src/front/program/ablate_run.h \
	src/front/program/check.c \
	src/front/program/check.h \
	src/front/program/check_parts.c \
	src/front/program/check_parts.h \
	src/front/program/run_cost.c \
	src/front/program/run_cost.h \
	src/front/program/command.c \
	src/front/program/command.h \
	src/front/program/command_line.c \
	src/front/program/command_line.h \
	src/front/program/layout.c \
	src/front/program/layout.h \
	src/front/program/lookup.c \
	src/front/program/lookup.h \
	src/front/program/manual.c \
	src/front/program/manual.h \
	src/front/program/command_pack.c \
	src/front/program/command_pack.h \
	src/front/program/pack_settle.c \
	src/front/program/pack_settle.h \
	src/front/program/page.c \
	src/front/program/page.h \
	src/front/program/command_picture.c \
	src/front/program/command_picture.h \
	src/front/program/scree_main.c \
	src/front/program/sample.c \
	src/front/program/sample.h \
	src/front/program/speed_error.c \
	src/front/program/speed_error.h \
	src/front/program/speed_plot.c \
	src/front/program/speed_plot.h \
	src/front/program/speed_write.c \
	src/front/program/step_study.c \
	src/front/program/step_study.h \
	src/front/program/trial.c \
	src/front/program/trial.h \
	src/front/program/variant.c \
	src/front/program/variant.h
libapp_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) -DSCREE_PAGE_FOLDER='"$(pagedir)"'

bin_PROGRAMS += scree
scree_SOURCES = src/front/program/main.c
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
