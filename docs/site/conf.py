# What Sphinx makes the site of: pages of docs/, as build.sh puts them together.
project = "rbpa"
author = "the rbpa authors"
copyright = "the rbpa authors, MIT"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown"}
root_doc = "index"

myst_heading_anchors = 4
# A page may skip a level, and show what no compiler accepts.
suppress_warnings = ["myst.header", "misc.highlighting_failure"]

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings have them
napoleon_google_docstring = False
napoleon_use_ivar = True
highlight_language = "none"

html_theme = "sphinx_rtd_theme"
html_title = "rbpa"
html_copy_source = False
html_show_sphinx = False
html_extra_path = ["extra"]
