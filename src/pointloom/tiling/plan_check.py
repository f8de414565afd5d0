"""Validate the plan in a manifest, since the folder may be damaged or from another source."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..core.json_fields import (
    Checks,
    check_fields,
    is_count,
    is_list,
    is_number,
    is_positive,
    is_text,
    list_of,
    numbers,
    optional,
)

MAX_TILES = 1 << 22
OUTPUTS = ("laz", "copc")

Box = tuple[float, float, float, float]


class TilePlan(Protocol):
    """The fields of `plan.Plan` that steps and readers use."""

    data: dict[str, Any]
    files: list[dict[str, Any]]
    epochs: list[dict[str, Any]]
    steps: list[Any]
    origin: NDArray[np.float64]
    corner: NDArray[np.float64]
    size: float
    shape: tuple[int, ...]
    slack: float
    max_points: int

    def numbered(self, epoch: int | None = None) -> list[tuple[int, dict[str, Any]]]: ...

    def tile_of(self, positions: NDArray[np.float64]) -> NDArray[np.int64]: ...

    def tiles_in(self, window: Box) -> list[int]: ...


def _is_shape(value: object) -> bool:
    return (
        isinstance(value, list) and len(value) == 2 and all(map(is_count, value)) and 0 < math.prod(value) <= MAX_TILES
    )


def _is_steps(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(step, dict) and is_text(step.get("step")) for step in value)


_STATE: Checks = {"path": is_text, "size": is_count, "mtime_ns": lambda value: isinstance(value, int)}
_SOURCE_CHECKS: Checks = {
    **_STATE,
    "kind": lambda value: value in ("copc", "rows"),
    "points": is_count,
    **dict.fromkeys(("low", "high", "scales", "offsets"), numbers(3)),
    "crs": optional(is_text),
    "unit": optional(is_text),
    "attributes": lambda value: isinstance(value, dict),
}
_PLAN_CHECKS: Checks = {
    "sources": lambda value: isinstance(value, list) and len(value) > 0,
    "epochs": is_list,
    "steps": _is_steps,
    "guesses": list_of(is_number),
    **dict.fromkeys(("origin", "voxel_low", "low", "high"), numbers(3)),
    "corner": numbers(2),
    "shape": _is_shape,
    "size": is_positive,
    "slack": is_number,
    "most": is_count,
    "levels": is_count,
    "only": lambda value: value is None or (isinstance(value, list) and len(value) > 0),
    "output": lambda value: value in OUTPUTS,
}
_EPOCH_CHECKS: Checks = {"paths": list_of(is_text), "sources": lambda value: isinstance(value, list) and len(value) > 0}


def check_plan(plan: Mapping[str, Any]) -> None:
    """Raise ValueError for the first missing or invalid value of a plan."""
    check_fields("plan", plan, _PLAN_CHECKS)
    if len(plan["guesses"]) != len(plan["steps"]):
        raise ValueError(f"plan: expected one guess for each of {len(plan['steps'])} steps, got {len(plan['guesses'])}")
    for number, epoch in enumerate(plan["epochs"]):
        check_fields(f"epoch {number}", epoch, _EPOCH_CHECKS)
    for source in [*plan["sources"], *(source for epoch in plan["epochs"] for source in epoch["sources"])]:
        check_fields("source", source, _SOURCE_CHECKS)
        if "original" in source:
            check_fields("original", source["original"], _STATE)
