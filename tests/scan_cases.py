"""Marks that choose the scans of a test, and of which set they are (`scan_set` in conftest.py)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def on_sets(names: str, *, shipped: Iterable[Any] = (), real: Iterable[Any] = ()) -> pytest.MarkDecorator:
    """Run a test on cases of either set: values of the arguments `names`, a tuple or pytest.param of several."""
    cases = []
    for scan_set, set_cases in (("shipped", shipped), ("real", real)):
        for case in set_cases:
            values = getattr(case, "values", case if isinstance(case, tuple) else (case,))
            cases.append(pytest.param(*values, scan_set, marks=getattr(case, "marks", ())))
    return pytest.mark.parametrize((*names.split(), "scan_set"), cases, indirect=["scan_set"])


# The shipped terrain tile is the real one, so it is in one set only.
ON_SCANS = on_sets("scan", shipped=("fragment", "lidar", "terrain"), real=("fragment", "lidar"))
ON_REAL_SCANS = pytest.mark.parametrize("scan_set", ["real"], indirect=True)
