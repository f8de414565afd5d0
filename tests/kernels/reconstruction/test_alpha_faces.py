"""Stars and faces of alpha shapes against integer arithmetic over all sets of four points."""

import math
from collections import Counter
from fractions import Fraction
from itertools import combinations, permutations, product
from typing import Any

import numpy as np
import pytest

from pointloom import PointCloud
from pointloom.kernels.memory import download
from pointloom.kernels.reconstruction import alpha_faces


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
    """The faces that one tetrahedron has, of a list of them by ascending corners; no face has more than two."""
    owners = Counter(face for corners in tetrahedra for face in combinations(corners, 3))
    assert max(owners.values(), default=0) <= 2
    return {face for face, count in owners.items() if count == 1}


RNG = np.random.default_rng(5)
ODD = np.array([0.1234567, 0.7654321, 0.3333333], np.float32)
MIRRORED = np.array(list(product((1, -1), repeat=3))) * ODD  # eight points of 24 bits on one sphere
RINGS = np.array([sign * ODD[list(order)] for order in permutations(range(3)) for sign in (1, -1)])  # in two planes
ROUND = [(math.cos(t), math.sin(t), 0) for t in np.arange(8) * math.pi / 4]
INTEGER_POINTS = [(3, 4, 0), (4, 3, 0), (-3, 4, 0), (5, 0, 0), (0, -5, 0), (-4, -3, 0), (0, 0, 5), (0, 0, 0)]
# of determinant 1 with rows of millions: tetrahedra whose volume drowns in the rounding of float64
SKEW = np.array([[2468508, -1667380, -303299], [-1650503, 2347748, -3940184], [-839939, 990009, -1317098]]) / 2**22
SETS = {
    "random": RNG.random((10, 3)),
    "a grid": list(product(range(3), range(2), range(2))),
    "a grid in another order": RNG.permutation(list(product(range(2), range(2), range(3)))),
    "a grid with gaps": [p for p in product(range(3), repeat=3) if sum(p) % 2 == 0][:11],
    "eight and more on a sphere": np.concatenate([MIRRORED, MIRRORED[:2, [1, 2, 0]], [[0.01, 0.02, 0.03]]]),
    "two rings on a sphere": RINGS,
    "a skew grid": np.array(list(product(range(2), range(3), range(2)))) @ SKEW,
    "nearly flat": np.column_stack([RNG.random((9, 2)), RNG.random(9) * 1e-7]),
    "coordinates of all sizes": RNG.normal(size=(8, 3)) * 10.0 ** RNG.integers(-12, 1, (8, 3)),
    "a ring and its poles": [*ROUND, (0, 0, 1), (0, 0, -1)],
    "a ring of whole numbers": INTEGER_POINTS,
}


def find(points, alphas, device="cpu"):
    cloud = PointCloud(points, device=device)
    tree = cloud.search_tree()
    rows = tree.order[: tree.count]
    shapes = alpha_faces.find_alpha_shapes(tree, rows, len(cloud), alphas, True)
    return [(download(faces).reshape(-1, 3), download(corners).reshape(-1, 4)) for faces, corners in shapes]


def assert_same(shapes, others):
    for arrays, expected in zip(shapes, others, strict=True):
        for array, other in zip(arrays, expected, strict=True):
            np.testing.assert_array_equal(array, other)


def as_set(rows):
    return {tuple(sorted(row)) for row in rows.tolist()}


@pytest.mark.parametrize("name", SETS)
def test_tetrahedra_and_faces_are_those_of_exact_arithmetic(device, name):
    points = np.asarray(SETS[name], np.float32)
    exact = exact_tetrahedra(points)
    radii = sorted(exact.values())
    alphas = [math.sqrt(radii[len(radii) // 2]) * 1.01, math.inf]
    for alpha, (faces, corners) in zip(alphas, find(points, alphas, device), strict=True):
        selected = [key for key, square in exact.items() if math.isinf(alpha) or square <= Fraction(alpha) ** 2]
        assert as_set(corners) == set(selected) and len(corners) == len(selected)
        assert as_set(faces) == boundary(selected) and len(faces) == len(boundary(selected))


def test_a_radius_of_exactly_alpha_is_included(device):
    box = np.array(list(product((0, 1), (0, 2), (0, 2))), np.float32) / 8 + 3  # circumradius 1.5 / 8, a whole 3 / 16
    alphas = [np.nextafter(0.1875, 0), 0.1875]
    assert [len(corners) > 0 for _, corners in find(box, alphas, device)] == [False, True]


def test_tetrahedra_are_positively_oriented_and_faces_point_outwards(device):
    points = np.float32(np.random.default_rng(1).random((40, 3)))
    ((faces, corners),) = find(points, [0.3], device)
    a, b, c, d = (points[corners[:, k]].astype(float) for k in range(4))
    volumes = np.linalg.det(np.stack([b - a, c - a, d - a], 1)) / 6
    assert (volumes > 0).all()
    x, y, z = (points[faces[:, k]].astype(float) for k in range(3))
    assert np.linalg.det(np.stack([x, y, z], 1)).sum() / 6 == pytest.approx(volumes.sum(), rel=1e-12)


def test_a_star_that_exceeds_its_memory_is_rebuilt(device):
    around = np.random.default_rng(2).normal(size=(150, 3))
    around /= np.linalg.norm(around, axis=1)[:, None]  # 296 triangles around the middle
    assert 2 * len(around) - 4 > alpha_faces.STAR_TRIANGLES
    ((faces, corners),) = find([*around, (0, 0, 0)], [2.0], device)
    assert (corners == 150).any(axis=1).sum() == 2 * len(around) - 4 == len(faces)


@pytest.mark.parametrize(
    ("seed", "count", "alpha", "limits"),
    [
        (3, 60, 0.3, {"FACES_A_POINT": 0, "TETRAHEDRA_A_POINT": 0}),
        (
            4,
            300,
            0.2,
            {
                "SCRATCH_NUMBERS": alpha_faces.STAR_TRIANGLES * alpha_faces.NUMBERS_PER_TRIANGLE,
                "CPU_POINTS_PER_THREAD": 7,
            },
        ),
    ],
    ids=["tables that are made again", "launches in parts"],
)
def test_small_tables_and_launches_in_parts_change_nothing(device, monkeypatch, seed, count, alpha, limits):
    points = np.random.default_rng(seed).random((count, 3))
    expected = find(points, [alpha], device)
    for name, limit in limits.items():
        monkeypatch.setattr(alpha_faces, name, limit)
    assert_same(find(points, [alpha], device), expected)


def test_several_alphas_give_the_results_of_each_alone(device):
    points = np.random.default_rng(6).random((80, 3))
    alphas = [0.15, 0.2, 0.25, 0.5, 1e300, math.inf]
    together = find(points, alphas, device)
    assert_same(together, [find(points, [alpha], device)[0] for alpha in alphas])
    assert_same(together[-2:-1], together[-1:])  # the square of 1e300 is infinite
    sizes = [len(corners) for _, corners in together]
    assert sizes == sorted(sizes) and sizes[0] < sizes[-1]


def near_one_sphere(rng):
    points = rng.normal(size=(200, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]  # apart from it by 6e-8, the rounding of float32


MANY = {
    "whole numbers": (np.unique(np.random.default_rng(8).integers(0, 5, (90, 3)), axis=0), 1.2),
    "points near one sphere": (near_one_sphere(np.random.default_rng(9)), 3.0),
    "a skew grid": (np.array(list(product(range(-1, 2), repeat=3))) @ SKEW, math.inf),
    "a thin sheet": (np.random.default_rng(10).random((200, 3)) * [1, 1, 1e-6], math.inf),
}


@pytest.mark.parametrize("name", MANY)
def test_neighbors_agree_on_their_tetrahedra(device, name):
    ((faces, corners),) = find(MANY[name][0], [MANY[name][1]], device)
    assert len(corners) > 40 and boundary([tuple(sorted(row)) for row in corners.tolist()]) == as_set(faces)
