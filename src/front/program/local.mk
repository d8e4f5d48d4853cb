# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES = \
	%D%/ablate.c %D%/ablate_error.c %D%/ablate_run.c %D%/ablate_table.c %D%/axis.c %D%/check.c %D%/check_parts.c \
	%D%/command.c %D%/command_line.c %D%/command_pack.c %D%/command_picture.c %D%/layout.c %D%/lookup.c \
	%D%/manual.c %D%/pack_settle.c %D%/page.c %D%/run_cost.c %D%/sample.c %D%/scree_main.c %D%/speed_error.c \
	%D%/speed_plot.c %D%/speed_write.c %D%/step_study.c %D%/tabular.c %D%/trial.c %D%/variant.c \
	%D%/variant_keys.c %D%/ablate_parts.h %D%/axis.h %D%/check_parts.h %D%/command.h %D%/command_line.h \
	%D%/commands.h %D%/pack_settle.h %D%/sample.h %D%/speed_error.h %D%/tabular.h %D%/trial.h %D%/variant.h
libapp_la_CPPFLAGS = $(AM_CPPFLAGS) -DSCREE_PAGE_FOLDER='"$(pagedir)"'

bin_PROGRAMS += scree
scree_SOURCES = %D%/main.c
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
