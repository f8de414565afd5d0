"""Validate the plan in a manifest, since the folder may be damaged or from another source."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ..core.checks import shown

MAX_TILES = 1 << 22
OUTPUTS = ("laz", "copc")
LARGEST = 1e300  # sums of numbers stay finite

Check = Callable[[Any], bool]


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**63


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and "\0" not in value


def _is_text_or_none(value: Any) -> bool:
    return value is None or _is_text(value)


def _is_list(value: Any) -> bool:
    return isinstance(value, list)


def _numbers(count: int) -> Check:
    return lambda value: isinstance(value, list) and len(value) == count and all(map(_is_number, value))


def _is_shape(value: Any) -> bool:
    return (
        isinstance(value, list) and len(value) == 2 and all(map(_is_count, value)) and 0 < math.prod(value) <= MAX_TILES
    )


def _is_steps(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(step, dict) and _is_text(step.get("step")) for step in value)


_STATE: dict[str, Check] = {"path": _is_text, "size": _is_count, "mtime_ns": lambda value: isinstance(value, int)}
_SOURCE: dict[str, Check] = {
    **_STATE,
    "kind": lambda value: value in ("copc", "rows"),
    "points": _is_count,
    **dict.fromkeys(("low", "high", "scales", "offsets"), _numbers(3)),
    "crs": _is_text_or_none,
    "unit": _is_text_or_none,
    "attributes": lambda value: isinstance(value, dict),
}
_PLAN: dict[str, Check] = {
    "sources": lambda value: isinstance(value, list) and len(value) > 0,
    "epochs": _is_list,
    "steps": _is_steps,
    "guesses": lambda value: isinstance(value, list) and all(map(_is_number, value)),
    **dict.fromkeys(("origin", "voxel_corner", "low", "high"), _numbers(3)),
    "corner": _numbers(2),
    "shape": _is_shape,
    "size": lambda value: _is_number(value) and value > 0,
    "slack": _is_number,
    "most": _is_count,
    "levels": _is_count,
    "only": lambda value: value is None or (isinstance(value, list) and len(value) > 0),
    "output": lambda value: value in OUTPUTS,
}
_EPOCH: dict[str, Check] = {
    "paths": lambda value: isinstance(value, list) and all(map(_is_text, value)),
    "sources": lambda value: isinstance(value, list) and len(value) > 0,
}


def check_plan(plan: Any) -> None:
    """Raise ValueError for the first missing or invalid value of a plan."""
    _check("plan", plan, _PLAN)
    if len(plan["guesses"]) != len(plan["steps"]):
        raise ValueError(f"plan: expected one guess for each of {len(plan['steps'])} steps, got {len(plan['guesses'])}")
    for number, epoch in enumerate(plan["epochs"]):
        _check(f"epoch {number}", epoch, _EPOCH)
    for source in [*plan["sources"], *(source for epoch in plan["epochs"] for source in epoch["sources"])]:
        _check("source", source, _SOURCE)
        if "original" in source:
            _check("original", source["original"], _STATE)


def _check(what: str, table: Any, checks: dict[str, Check]) -> None:
    if not isinstance(table, dict):
        raise ValueError(f"{what}: expected an object, got {shown(table)}")
    for name, is_right in checks.items():
        if name not in table:
            raise ValueError(f"{what}: {name} is missing")
        if not is_right(table[name]):
            raise ValueError(f"{what}: {name} is {shown(table[name])}")
