# SPDX-License-Identifier: BSD-3-Clause
# The Python package: copied, with the headers, to build/python, where PYTHONPATH finds it. It needs no compiler.
python_files = __init__.py _library.py _scene.py _search.py _simulation.py
python_sources = $(python_files:%=src/front/python/scree/%) src/scree.h src/scree_pairs.h
EXTRA_DIST += pyproject.toml %D%/build_package.py $(python_files:%=src/front/python/scree/%)

all-local: python/scree/copied
python/scree/copied: $(python_sources)
	@$(MKDIR_P) python/scree
	@for file in $^; do cp -f "$$file" python/scree/ || exit 1; done
	@echo "LIBRARY = \"$(abs_builddir)/.libs/libscree.so\"" >python/scree/_where.py
	@touch $@

# make install-python: the package for the library of `make install`
pythondir = $(datadir)/scree/python
install-python: python/scree/copied
	$(MKDIR_P) $(DESTDIR)$(pythondir)/scree
	for file in $(python_sources); do $(INSTALL_DATA) $(srcdir)/$$file $(DESTDIR)$(pythondir)/scree/ || exit 1; done
	echo "LIBRARY = \"$(libdir)/libscree.so\"" >$(DESTDIR)$(pythondir)/scree/_where.py
	@echo "PYTHONPATH=$(pythondir) finds the package scree"
.PHONY: install-python

clean-local: clean-python
clean-python:
	rm -rf python
.PHONY: clean-python
