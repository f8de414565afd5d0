"""Make docs/machinery importable."""

import importlib.util
import sys
from pathlib import Path

import pytest

collect_ignore = ["test_machinery.py"] if importlib.util.find_spec("sphinx") is None else []

DOCS = Path(__file__).resolve().parents[2] / "docs"
sys.path.insert(0, str(DOCS))


@pytest.fixture(scope="module")
def names_of_torch():
    """The names of pointloom.torch, with or without torch."""
    from machinery import public

    before = set(sys.modules)
    public.replace_torch()
    yield
    for name in set(sys.modules) - before:
        if name.startswith(("torch", "pointloom.torch")):
            del sys.modules[name]
