# SPDX-License-Identifier: BSD-3-Clause
"""The documentation as a site: `make docs`, by Sphinx with MyST and Furo. The pages are the Markdown files of the source tree."""

project = "scree"
author = "the authors of scree"
extensions = ["myst_parser"]
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
