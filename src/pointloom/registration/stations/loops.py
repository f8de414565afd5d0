"""Loop closure errors of station pairs."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...kernels.linear_algebra import matmul, norm
from ..rigid import invert_pose, rotation_vector
from .observations import Array, StationPair


@dataclass(frozen=True, eq=False)
class Loop:
    """A loop of stations, and its closure errors: `rotation` [rad], `translation` at the first station [m]."""

    stations: tuple[int, ...]
    rotation: float
    translation: float


def loops_of(pairs: Sequence[StationPair], count: int) -> list[Loop]:
    """The shortest loop of each pair outside a spanning tree."""
    near: dict[int, dict[int, Array]] = {i: {} for i in range(count)}
    loops = []
    for pair in pairs:
        a, b = pair.source, pair.target
        way = _way(near, a, b)
        if way:
            T = np.eye(4)
            for i, j in itertools.pairwise(way):
                T = matmul(near[i][j], T)
            E = matmul(invert_pose(pair.transformation), T)
            angle = float(norm(rotation_vector(E[:3, :3])))
            loops.append(Loop(tuple(way), angle, float(norm(E[:3, 3]))))
        near[a][b], near[b][a] = pair.transformation, invert_pose(pair.transformation)
    return loops


def _way(near: dict[int, dict[int, Array]], a: int, b: int) -> list[int]:
    before, front = {a: a}, [a]
    while front and b not in before:
        neighbors = [(j, i) for i in front for j in near[i]]
        front = []
        for j, i in neighbors:
            if j not in before:
                before[j] = i
                front.append(j)
    if b not in before:
        return []
    way = [b]
    while way[-1] != a:
        way.append(before[way[-1]])
    return way[::-1]
