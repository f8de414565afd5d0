"""Halo of each step, and files that no tile needs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .plan_check import TilePlan

if TYPE_CHECKING:
    from .steps.step import Step

RADIUS_SLACK = 1 + 1e-5  # float32 distance


def halos_of(steps: list[Step], radii: list[float], slack: float) -> list[float]:
    """Halo that each step needs, and 0 after the last."""
    spreads = [0.0]
    for step in steps:
        spreads.append(step.spread_after(spreads[-1]))
    halos = [0.0]
    for step, radius, spread in zip(reversed(steps), reversed(radii), reversed(spreads[:-1]), strict=True):
        wanted = step.halo_before(halos[0], spread, radius * RADIUS_SLACK)
        is_local = step.radius == 0 and step.neighbors is None
        halos.insert(0, halos[0] if is_local else wanted + 4 * step.hops * slack)
    return halos


def far_files(plan: TilePlan, tiles: list[tuple[Any, ...]]) -> set[int]:
    """Files without windows that are beyond all tiles and halos, by their bounds. If a halo later reaches one of them,
    it is sorted into tiles then (`UnsortedFileError`)."""
    radii = [step.radius for step in plan.steps]
    halo = halos_of(plan.steps, radii, plan.slack)[0] + max((s.radius for s in plan.steps if s.epoch), default=0.0)
    columns, rows = plan.shape
    ids = np.array([tile[0] for tile in tiles])
    wanted = np.zeros((rows + 1, columns + 1), np.int64)
    wanted[ids // columns + 1, ids % columns + 1] = 1
    below = wanted.cumsum(axis=0).cumsum(axis=1)  # number of wanted tiles below and left of a corner
    far = set()
    for number, source in enumerate(plan.files):
        if source["kind"] == "copc":
            continue
        ends = np.array([source["low"][:2], source["high"][:2]]) + np.array([[-1], [1]]) * (halo + plan.slack)
        cells = np.floor((ends - plan.corner) / plan.size)
        (x0, y0), (x1, y1) = np.clip(cells, 0, np.array(plan.shape) - 1).astype(np.int64)
        is_beside = (cells[1] < 0).any() or (cells[0] >= np.array(plan.shape)).any()
        if is_beside or not below[y1 + 1, x1 + 1] - below[y0, x1 + 1] - below[y1 + 1, x0] + below[y0, x0]:
            far.add(number)
    return far
