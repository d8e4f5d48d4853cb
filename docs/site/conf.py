# SPDX-License-Identifier: BSD-3-Clause
"""The documentation as a site: `make docs`, by Sphinx with MyST and Furo. The pages are the Markdown files of the source tree."""

import logging
import os
import sys

project = "scree"
author = "the authors of scree"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc"]
root_doc = "docs/index"
include_patterns = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/*.md", "docs/howto/*.md", "docs/packaging/README.md", "examples/**.md"]
exclude_patterns = ["**/*.head.md", "examples/**/out/**"]
source_suffix = {".md": "markdown"}
html_theme = "furo"
html_title = "scree"
html_copy_source = False
html_show_sphinx = False
myst_heading_anchors = 4
# Scenes and outputs of commands have more kinds of text than Pygments knows
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]

# The C library: what Doxygen wrote of the headers. Python: the docstrings of the package, which is not loaded
build = os.environ["SCREE_BUILD"]
breathe_projects = {"scree": os.path.join(build, "site", ".doxygen")}
breathe_default_project = "scree"
breathe_domain_by_extension = {"h": "c"}
sys.path.insert(0, os.path.join(build, "python"))
autodoc_mock_imports = ["cffi", "numpy"]
autodoc_member_order = "bysource"


def _forget(app):
    """Forgets what Sphinx itself has loaded of these modules (cffi, for its requests): autodoc puts a stand-in for new ones alone."""
    for name in [name for name in sys.modules if name.partition(".")[0] in autodoc_mock_imports]:
        del sys.modules[name]


def setup(app):
    app.connect("builder-inited", _forget)


# A function may have the name of a struct (scree_box, scree_field): C keeps two lists of names, Sphinx one
logging.getLogger("sphinx.sphinx.domains.c").addFilter(lambda record: "Duplicate C declaration" not in str(record.msg))
