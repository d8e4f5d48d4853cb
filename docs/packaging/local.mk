# SPDX-License-Identifier: BSD-3-Clause
# Packages: see docs/packaging/README.md
EXTRA_DIST += \
	%D%/README.md %D%/apptainer/scree.def %D%/debian/changelog %D%/debian/control %D%/debian/copyright \
	%D%/debian/libscree-dev.install %D%/debian/libscree-index0.install %D%/debian/libscree0.install \
	%D%/debian/python3-scree.install %D%/debian/rules %D%/debian/scree-examples.install \
	%D%/debian/scree-petsc.install %D%/debian/scree.install %D%/debian/source/format %D%/spack/package.py

# make deb: Debian packages in deb/, from the archive of `make dist`. The project has neither a mailing list for the maintainer's
# address nor a bug at Debian that asks for the package; uPlot (src/front/page) and three.js (src/front/view) are there as their authors publish them, without their sources.
not_yet = bogus-mail-host,bogus-mail-host-in-debian-changelog,initial-upload-closes-no-bugs,source-is-missing
.PHONY: deb
deb: dist
	@command -v dpkg-buildpackage >/dev/null && command -v dh >/dev/null || \
		{ echo "make deb: needs dpkg-dev, debhelper and dh-python (apt-get install dpkg-dev debhelper dh-python)" >&2; exit 1; }
	rm -rf deb && $(MKDIR_P) deb
	cp $(distdir).tar.gz deb/$(PACKAGE)_$(VERSION).orig.tar.gz
	cd deb && tar -xzf $(PACKAGE)_$(VERSION).orig.tar.gz && cp -r $(distdir)/docs/packaging/debian $(distdir)/
	cd deb/$(distdir) && DEB_BUILD_OPTIONS="parallel=$$(nproc)" dpkg-buildpackage -us -uc
	@if command -v lintian >/dev/null; then lintian --suppress-tags $(not_yet) --fail-on error,warning deb/*.changes; \
	else echo "make deb: not looked at by lintian, which is not here"; fi
	@ls deb/*.deb

clean-local: clean-deb
clean-deb:
	rm -rf deb
.PHONY: clean-deb
