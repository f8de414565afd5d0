"""Delaunay tetrahedra of a few points by integer arithmetic over all sets of four: the oracle of the tests.

Ties are settled by a real perturbation: every point is lifted by its square less a number so small that it decides
nothing else, the first point's the largest.
"""

from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np


def cross(a: Any, b: Any) -> list[int]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a: Any, b: Any) -> int:
    return sum(x * y for x, y in zip(a, b, strict=True))


def to_integers(points: np.ndarray) -> tuple[list[list[int]], Fraction]:
    """float32 coordinates as multiples of a unit, and the unit."""
    exact = [[Fraction(float(x)) for x in p] for p in np.asarray(points, np.float32)]
    unit = Fraction(1, max(x.denominator for p in exact for x in p))
    return [[int(x / unit) for x in p] for p in exact], unit


def sphere(arms: list[list[int]], lifts: list[int]) -> tuple[list[int], int]:
    """(N, D): a point p seen from the first corner is inside if dot(p, N) > lift D, for D > 0."""
    b, c, d = arms
    parts = [cross(c, d), cross(d, b), cross(b, c)]
    return [sum(lift * part[k] for lift, part in zip(lifts, parts, strict=True)) for k in range(3)], dot(b, parts[0])


def exact_tetrahedra(points: np.ndarray) -> dict[tuple[int, ...], Fraction]:
    """The squared circumradius of each Delaunay tetrahedron of float32 points, by its ascending corners."""
    coordinates, unit = to_integers(points)
    count = len(coordinates)
    step = 4 * max(abs(x) for p in coordinates for x in p).bit_length() + 40  # more bits than a coefficient has
    lifts = [(dot(p, p) << step * (count + 1)) - (1 << step * (count - i)) for i, p in enumerate(coordinates)]
    tetrahedra = {}
    for corners in combinations(range(count), 4):
        a, *others = corners
        relative = [[x - y for x, y in zip(p, coordinates[a], strict=True)] for p in coordinates]
        # lifts seen from a: the same up to a linear function of the place, which moves no point inside or outside
        raised = [
            lift - lifts[a] - 2 * (dot(coordinates[a], p) << step * (count + 1))
            for lift, p in zip(lifts, relative, strict=True)
        ]
        arms = [relative[i] for i in others]
        N, D = sphere(arms, [raised[i] for i in others])
        if D == 0:
            continue
        side = 1 if D > 0 else -1
        if not any(side * dot(relative[i], N) > side * raised[i] * D for i in range(count) if i not in corners):
            flat, _ = sphere(arms, [dot(arm, arm) for arm in arms])
            tetrahedra[corners] = Fraction(dot(flat, flat), 4 * D * D) * unit**2
    return tetrahedra


def boundary(tetrahedra: list[tuple[int, ...]]) -> set[tuple[int, ...]]:
    """The faces that one tetrahedron has, of a list of them by ascending corners."""
    faces: dict[tuple[int, ...], int] = {}
    for corners in tetrahedra:
        for face in combinations(corners, 3):
            faces[face] = faces.get(face, 0) + 1
    return {face for face, count in faces.items() if count == 1}
