"""The scripts and styles that pages are joined from."""

import gzip
import re
from importlib import resources

import pytest

from pointloom.drawing.page import sources

MOST_BYTES = 45_000  # of the engine, compressed: a page of it is open before one has noticed
DECLARED = r"^(?:const|let|class|function|async function) (\w+)"


def test_the_sources_come_with_the_package():
    names = {each.name for each in (resources.files("pointloom.drawing") / "page").iterdir()}
    assert {"player.html", "player.css", "engine.css", *(f"{name}.js" for name in sources.PLAYER)} <= names


def test_the_engine_is_small():
    script = sources.join_scripts(sources.ENGINE) + sources.read_source("engine.css")
    assert len(gzip.compress(script.encode(), mtime=0)) < MOST_BYTES


@pytest.mark.parametrize("names", [sources.PLAYER])
def test_no_name_is_declared_by_two_modules(names):
    """They are joined into one function, in which the second one would be an error."""
    declared = [name for each in names for name in re.findall(DECLARED, sources.read_source(f"{each}.js"), re.M)]
    assert len(declared) > 50
    assert sorted(declared) == sorted(set(declared))


def test_a_policy_names_a_text_by_its_hash():
    assert sources.hash_of("") == "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="
