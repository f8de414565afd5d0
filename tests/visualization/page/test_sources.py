"""The scripts and styles of which pages are composed."""

import gzip
import re

import pytest

from pointloom.visualization.page import sources
from pointloom.visualization.viewer.link.page import ServedPage

MAX_BYTES = 45_000  # of the engine, compressed: small enough to load at once
MAX_LIVE_BYTES = 100_000  # of the complete page, compressed, and of its parts besides the engine
MAX_PANEL_BYTES = 40_000
DECLARED = r"^(?:const|let|class|function|async function) (\w+)"


def test_the_engine_is_small():
    script = sources.join_scripts(sources.ENGINE) + sources.read_source("engine.css")
    assert len(gzip.compress(script.encode(), mtime=0)) < MAX_BYTES


def test_the_live_page_is_small_and_makes_no_external_requests():
    page = sources.live_page("a title")
    engine = sources.join_scripts(sources.ENGINE) + sources.read_source("engine.css")
    size = len(gzip.compress(page, mtime=0))
    assert size < MAX_LIVE_BYTES
    assert size - len(gzip.compress(engine.encode(), mtime=0)) < MAX_PANEL_BYTES
    text = page.decode().replace("http://www.w3.org/", "")  # XML namespaces, which are not requested
    assert not re.search(r"https?://|@import|\bimport\(|\beval\(|new Function|\son[a-z]+=|style=\"", text)


def test_the_live_page_shows_its_title_as_text():
    served = ServedPage(sources.live_page('<script>alert("1")</script> {{script}}'))
    assert served.text.decode().count("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; {{script}}") == 2


@pytest.mark.parametrize("names", [sources.PLAYER, sources.LIVE])
def test_no_name_is_declared_by_two_modules(names):
    """The scripts are joined into one function, in which a second declaration would be an error."""
    declared = [name for each in names for name in re.findall(DECLARED, sources.read_source(f"{each}.js"), re.M)]
    assert len(declared) > 50
    assert sorted(declared) == sorted(set(declared))
