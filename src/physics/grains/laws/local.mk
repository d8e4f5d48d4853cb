# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcontact.la
libcontact_la_SOURCES = \
	src/physics/grains/batch/force.c \
	src/physics/grains/batch/force.h \
	src/physics/grains/batch/force_account.h \
	src/physics/grains/batch/force_contacts.c \
	src/physics/grains/batch/force_general.c \
	src/physics/grains/batch/force_general.h \
	src/physics/grains/batch/force_grip.h \
	src/physics/grains/batch/force_kernel.h \
	src/physics/grains/batch/force_physics.h \
	src/physics/grains/laws/law.c \
	src/physics/grains/laws/law.h \
	src/physics/grains/laws/law_check.c \
	src/physics/grains/laws/law_cohesion.c \
	src/physics/grains/laws/law_cohesion.h \
	src/physics/grains/laws/law_eepa.h \
	src/physics/grains/laws/law_custom.h \
	src/physics/grains/laws/law_form.h \
	src/physics/grains/laws/law_general.c \
	src/physics/grains/laws/law_general.h \
	src/physics/grains/laws/law_hertz.h \
	src/physics/grains/laws/law_hooke.h \
	src/physics/grains/laws/law_grip.c \
	src/physics/grains/laws/law_grip.h \
	src/physics/grains/laws/law_kernel.h \
	src/physics/grains/laws/law_luding.h \
	src/physics/grains/laws/law_part.h \
	src/physics/grains/laws/law_parts.c \
	src/physics/grains/laws/law_parts.h \
	src/physics/grains/laws/law_resist.c \
	src/physics/grains/laws/law_resist.h \
	src/physics/grains/laws/law_rigid.h \
	src/physics/grains/laws/law_root.h \
	src/physics/grains/laws/law_restitution.c \
	src/physics/grains/laws/law_restitution.h \
	src/physics/grains/laws/law_table.c \
	src/physics/grains/laws/law_spring.h \
	src/physics/grains/laws/law_springs.c \
	src/physics/grains/laws/law_user.c \
	src/physics/grains/laws/law_user.h \
	src/physics/grains/laws/law_spheres.h \
	src/physics/grains/laws/law_vector.h \
	src/physics/grains/laws/law_table.h \
	src/physics/grains/laws/law_thornton.h
libcontact_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libcontact_la_LIBADD = libforce_baseline.la

# The folder has a header a part: a new one needs no line here
EXTRA_DIST += src/physics/grains/laws/parts

# A law of the user's is compiled against the text of this header
include_HEADERS += src/physics/grains/laws/scree_law.h
src/physics/grains/laws/scree_law.text: src/physics/grains/laws/scree_law.h
	$(AM_V_GEN)$(MKDIR_P) src/physics/grains/laws && sed 's/\\/\\\\/g; s/"/\\"/g; s/^/"/; s/$$/\\n"/' $(srcdir)/src/physics/grains/laws/scree_law.h >$@
$(libcontact_la_OBJECTS): src/physics/grains/laws/scree_law.text
BUILT_SOURCES += src/physics/grains/laws/scree_law.text
CLEANFILES += src/physics/grains/laws/scree_law.text

# The laws over a batch, once for each instruction set
FORCE_SOURCES = src/physics/grains/batch/force_block.c
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
