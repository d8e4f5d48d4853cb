# SPDX-License-Identifier: BSD-3-Clause
# Packages: see docs/packaging/README.md
packaging = docs/packaging/debian
EXTRA_DIST += docs/packaging/README.md docs/packaging/spack/package.py docs/packaging/apptainer/scree.def \
	$(packaging)/changelog $(packaging)/control $(packaging)/copyright $(packaging)/rules $(packaging)/source/format \
	$(packaging)/libscree-dev.install $(packaging)/libscree-index0.install $(packaging)/libscree0.install \
	$(packaging)/python3-scree.install $(packaging)/scree-examples.install $(packaging)/scree-petsc.install $(packaging)/scree.install

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
