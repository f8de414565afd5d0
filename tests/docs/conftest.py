"""Make docs/machinery importable."""

import importlib.util
import sys
from pathlib import Path

collect_ignore = ["test_machinery.py"] if importlib.util.find_spec("sphinx") is None else []

DOCS = Path(__file__).resolve().parents[2] / "docs"
sys.path.insert(0, str(DOCS))
