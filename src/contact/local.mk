# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcontact.la
libcontact_la_SOURCES = \
	src/contact/force.c \
	src/contact/force.h \
	src/contact/force_account.h \
	src/contact/force_contacts.c \
	src/contact/force_general.c \
	src/contact/force_general.h \
	src/contact/force_grip.h \
	src/contact/force_kernel.h \
	src/contact/force_physics.h \
	src/contact/law.c \
	src/contact/law.h \
	src/contact/law_check.c \
	src/contact/law_cohesion.c \
	src/contact/law_cohesion.h \
	src/contact/law_eepa.h \
	src/contact/law_custom.h \
	src/contact/law_form.h \
	src/contact/law_general.c \
	src/contact/law_general.h \
	src/contact/law_hertz.h \
	src/contact/law_hooke.h \
	src/contact/law_grip.c \
	src/contact/law_grip.h \
	src/contact/law_jkr.h \
	src/contact/law_kernel.h \
	src/contact/law_luding.h \
	src/contact/law_parts.c \
	src/contact/law_parts.h \
	src/contact/law_resist.c \
	src/contact/law_resist.h \
	src/contact/law_rigid.h \
	src/contact/law_root.h \
	src/contact/law_restitution.c \
	src/contact/law_restitution.h \
	src/contact/law_table.c \
	src/contact/law_spring.h \
	src/contact/law_sticky.c \
	src/contact/law_sticky.h \
	src/contact/law_springs.c \
	src/contact/law_user.c \
	src/contact/law_user.h \
	src/contact/law_spheres.h \
	src/contact/law_vector.h \
	src/contact/law_table.h \
	src/contact/law_thornton.h
libcontact_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libcontact_la_LIBADD = libforce_baseline.la

# A law of the user's is compiled against the text of this header
include_HEADERS += src/contact/scree_law.h
src/contact/scree_law.text: src/contact/scree_law.h
	$(AM_V_GEN)$(MKDIR_P) src/contact && sed 's/\\/\\\\/g; s/"/\\"/g; s/^/"/; s/$$/\\n"/' $(srcdir)/src/contact/scree_law.h >$@
$(libcontact_la_OBJECTS): src/contact/scree_law.text
BUILT_SOURCES += src/contact/scree_law.text
CLEANFILES += src/contact/scree_law.text

# The laws over a batch, once for each instruction set
FORCE_SOURCES = src/contact/force_block.c
noinst_LTLIBRARIES += libforce_baseline.la
libforce_baseline_la_SOURCES = $(FORCE_SOURCES)
libforce_baseline_la_CFLAGS = $(KERNEL_CFLAGS)
libforce_baseline_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_baseline \
	-DFORCE_KERNEL_NAME='"baseline"'
if X86_KERNELS
noinst_LTLIBRARIES += libforce_v3.la libforce_v4.la
libforce_v3_la_SOURCES = $(FORCE_SOURCES)
libforce_v3_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V3)
libforce_v3_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v3 \
	-DFORCE_KERNEL_NAME='"x86-64-v3"'
libforce_v4_la_SOURCES = $(FORCE_SOURCES)
libforce_v4_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V4)
libforce_v4_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v4 \
	-DFORCE_KERNEL_NAME='"x86-64-v4"'
libcontact_la_LIBADD += libforce_v3.la libforce_v4.la
endif
