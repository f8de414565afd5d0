"""Sphinx configuration of the site (`make docs`). Neither the build nor the pages access the network."""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS), str(DOCS.parent / "src")]
os.environ["PYTHONPATH"] = os.pathsep.join(sys.path[:2])  # for processes that run scripts of the gallery

from machinery import commands, galleries, pages, pictures, reference, scraper, whole  # noqa: E402
from machinery.public import by_home, public_modules, replace_torch  # noqa: E402

from pointloom import __version__  # noqa: E402
from pointloom.visualization.recording.shared_player import write_player  # noqa: E402

replace_torch()
public_modules()  # makes each importable by its public name

project, author, release, version = "pointloom", "the authors of pointloom", __version__, __version__
copyright = author
language = "en"  # the search fails in languages without translated messages
# URL of the site. If empty, there are no canonical links, no sitemap and no banner on older versions.
SITE = pages.LOCATION["documentation"].rstrip("/")

extensions = [
    *("myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon", "sphinx_design"),
    "sphinx_gallery.gen_gallery",
]
exclude_patterns = ["README.md", "examples", "machinery", "made", "operations.py", "**/*.ipynb", "**/*.py.md5"]
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
default_role = "py:obj"
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence", "deflist"]
suppress_warnings = ["config.cache", "myst.header"]

autosummary_generate = False
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
napoleon_use_ivar = True
napoleon_use_admonition_for_notes = False
napoleon_custom_sections = [("Example", "example")]
toc_object_entries_show_parents = "hide"

_sources, _targets = galleries.folders()
sphinx_gallery_conf = {
    "examples_dirs": _sources,
    "gallery_dirs": _targets,
    "filename_pattern": r"plot_",
    "within_subsection_order": "FileNameSortKey",
    "image_scrapers": ("machinery.scraper.show_results",),
    "reset_modules": (),
    "capture_repr": (),
    "parallel": 2 if importlib.util.find_spec("joblib") else False,
    "default_thumb_file": str(DOCS / "static" / "logo.png"),
    "download_all_examples": False,
    "write_computation_times": False,
    "show_signature": False,
    "remove_config_comments": True,
    "min_reported_time": 1_000_000,
    "plot_gallery": os.environ.get("POINTLOOM_GALLERY", "True"),
}

html_theme = "pydata_sphinx_theme"
html_title = f"pointloom {release}"
html_short_title = "Point clouds, scans, RGB-D frames and photographs to registered clouds and meshes, on CUDA and CPU"
(scraper.MADE / scraper.RECORDINGS).mkdir(parents=True, exist_ok=True)  # must exist before the build
html_static_path = ["static", "made"]
html_css_files = ["site.css"]
html_search_scorer = str(DOCS / "machinery" / "search_scorer.js")
html_js_files = [("site.js", {"priority": 900})]
html_context = {"default_mode": "auto"}
html_favicon = "static/logo.svg"
html_baseurl = f"{SITE}/stable/" if SITE else ""
html_copy_source = False
html_show_sourcelink = False
html_sidebars = {"index": [], "install": []}
html_theme_options: dict[str, Any] = {
    "logo": {"text": "pointloom", "image_light": "static/logo.svg", "image_dark": "static/logo.svg"},
    "navbar_end": ["theme-switcher"],
    "header_links_before_dropdown": 7,
    "show_toc_level": 2,
    "navigation_with_keys": False,
    "footer_start": ["copyright"],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
    "show_version_warning_banner": bool(SITE),
}
if SITE:
    html_theme_options["switcher"] = {"json_url": f"{SITE}/stable/versions.json", "version_match": release}
    html_theme_options["check_switcher"] = False
    html_theme_options["navbar_end"] = ["version-switcher", "theme-switcher"]


def make_pages(app: Any) -> None:
    """Generate pages from the library before sphinx-gallery runs."""
    write_player(scraper.MADE)
    pages.bring(DOCS)
    commands.write_pages(DOCS / "commands")
    reference.write_pages(DOCS / "reference")
    if app.config.sphinx_gallery_conf["plot_gallery"] != "False":
        pictures.write_pictures(DOCS)


def make_gallery_index(app: Any) -> None:
    """Write the index of the gallery after sphinx-gallery has run."""
    galleries.write_index(DOCS)


def rewrite_links(app: Any, page: str, source: list[str]) -> None:
    """Rewrite links of pages that are also read on the code host."""
    if Path(app.env.doc2path(page)).suffix == ".md":
        source[0] = pages.rewrite_links(page, source[0])


def prepare_results(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Prepare the section Returns of a docstring for napoleon."""
    lines[:] = reference.results_as_text(lines)


def add_examples(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Append the picture of a name and the gallery pages that use it to its docstring, and link mentioned pages."""
    lines[:] = [reference.linked(line) for line in lines] + pictures.picture_of(name) + reference.examples_of(name)


def short_signature(app: Any, what: str, name: str, thing: Any, options: Any, given: Any, result: Any) -> Any:
    """Show type hints as written: `ArrayLike` instead of its definition."""
    return reference.signature_of(what, name, thing)


def find_public_name(app: Any, env: Any, node: Any, content: Any) -> Any:
    """Resolve references to the module that defines a type to its public name."""
    name = by_home().get(node.get("reftarget", ""))
    if node.get("refdomain") != "py" or name is None:
        return None
    python = env.get_domain("py")
    return python.resolve_xref(env, node["refdoc"], app.builder, "obj", name, node, content)


def setup(app: Any) -> dict[str, Any]:
    """Connect the event handlers."""
    app.connect("builder-inited", make_pages, priority=100)
    app.connect("builder-inited", make_gallery_index, priority=900)
    app.connect("source-read", rewrite_links)
    app.connect("autodoc-process-docstring", prepare_results, priority=100)
    app.connect("autodoc-process-docstring", add_examples, priority=900)
    app.connect("autodoc-process-signature", short_signature)
    app.connect("missing-reference", find_public_name)
    app.connect("build-finished", whole.write_lists, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
