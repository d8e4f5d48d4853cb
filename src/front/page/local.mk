# SPDX-License-Identifier: BSD-3-Clause
# The page that `scree report` makes: copied to build/page, where the program finds it, and installed
pagedir = $(pkgdatadir)/page
page_files = report.py page.js page.css uPlot.iife.min.js uPlot.min.css uPlot.LICENSE
dist_page_DATA = $(page_files:%=src/front/page/%)
all-local: page/copied
page/copied: $(dist_page_DATA)
	@$(MKDIR_P) page
	@for file in $^; do cp -f "$$file" page/ || exit 1; done
	@touch $@
clean-local: clean-page
clean-page:
	rm -rf page
.PHONY: clean-page
