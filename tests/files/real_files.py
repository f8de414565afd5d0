"""Real files of a format: those of the folder that POINTLOOM_DATA names, else those that are shipped."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

SHIPPED = Path(__file__).parents[1] / "data"


def real_files(*patterns: str) -> list[Any]:
    """Parameters of a test, one a file; one that is skipped where there is none."""
    root = Path(os.environ.get("POINTLOOM_DATA") or SHIPPED)
    found = [pytest.param(path, id=path.name) for pattern in patterns for path in sorted(root.glob(pattern))]
    return found or [pytest.param(None, marks=pytest.mark.skip(reason="POINTLOOM_DATA names no folder of real data"))]
