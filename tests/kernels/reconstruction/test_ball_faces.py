"""Triangles under empty balls: those of brute force in float64, and on grids, circles and solids one triangulation."""

import itertools

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.arrays.select import gather_rows
from pointloom.kernels.arrays.sort import positions
from pointloom.kernels.lang import uint8
from pointloom.kernels.memory import download, full
from pointloom.kernels.reconstruction import ball_faces
from pointloom.kernels.reconstruction.ball_faces import BallPoints, list_faces


def faces_of(points, normals, radius, device):
    """The triangles as rows of the cloud, the lowest first, sorted, none left out or refused; and their circles'
    widths. The order of the list depends on the first room, which differs by device."""
    cloud = loom.PointCloud(points, normals=normals, device=device, origin=[0, 0, 0])
    tree = cloud.search_tree()
    mask = full(tree.count, 1, uint8, tree.device)
    ball = BallPoints(tree, gather_rows(cloud.arrays["normals"], tree.order), mask, radius)
    corners, widths, _ = list_faces(ball, positions(tree.count, tree.device))
    rows = download(tree.order)[download(corners).reshape(-1, 3)]
    first = rows.argmin(axis=1)
    rolled = np.stack([rows[np.arange(len(rows)), (first + k) % 3] for k in range(3)], axis=1)
    order = np.lexsort(rolled.T[::-1])
    return rolled[order], download(widths)[order]


def brute_faces(points, normals, radius):
    """All triples at once: the ball's center by the circumcenter, and its distance to all points, if it exists."""
    rows = np.array(list(itertools.combinations(range(len(points)), 3)))
    a, b, c = rows.T
    B, C = points[b] - points[a], points[c] - points[a]
    n = np.cross(B, C)
    squares = [(x * x).sum(axis=1, keepdims=True) for x in (B, C, n)]
    middle = (np.cross(n, B) * squares[1] + np.cross(C, n) * squares[0]) / (2 * squares[2])
    rest = radius**2 - (middle**2).sum(axis=1)
    u = n / np.sqrt(squares[2])
    agree = (normals[rows] * u[:, None]).sum(axis=2)
    side = np.sign(agree.sum(axis=1))
    fits = (rest >= 0) & (side[:, None] * agree >= 0).all(axis=1)
    rows, side = rows[fits], side[fits]
    centers = (points[a] + middle)[fits] + u[fits] * (side * np.sqrt(rest[fits]))[:, None]
    distances = np.linalg.norm(points - centers[:, None], axis=2)
    np.put_along_axis(distances, rows, np.inf, axis=1)
    empty = (distances > radius).all(axis=1)
    return {(a, b, c) if s > 0 else (a, c, b) for (a, b, c), s in zip(rows[empty].tolist(), side[empty], strict=True)}


def as_set(triangles):
    return set(map(tuple, triangles.tolist()))


def by_corners(triangles, widths):
    return dict(zip(map(tuple, triangles.tolist()), widths.tolist(), strict=True))


def bumpy(rng, count, thickness):
    points = rng.random((count, 3)) * [1, 1, thickness]
    normals = rng.normal(size=(count, 3)) * 0.4 + [0, 0, 1]
    return points.astype(np.float32).astype(np.float64), normals.astype(np.float32).astype(np.float64)


@pytest.mark.parametrize(
    ("count", "thickness", "radius"),
    [(26, 0.05, 0.2), (26, 0.3, 0.4), (26, 1.0, 0.4), (26, 0.3, 2.0), (60, 0.1, 0.4), (60, 1.0, 0.3), (90, 0.3, 0.8)],
)
def test_the_triangles_are_those_of_brute_force(device, rng, count, thickness, radius):
    points, normals = bumpy(rng, count, thickness)
    faces, _ = faces_of(points, normals, radius, device)
    expected = brute_faces(points, normals, radius)
    assert len(faces) == len(expected) > 0 and as_set(faces) == expected


@pytest.mark.slow
def test_a_ball_nearly_as_large_as_a_sphere_of_points_finds_the_triangles_of_brute_force(device, rng):
    """Each point has more possible corners than those of which all pairs are tested."""
    points = rng.normal(size=(90, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    points = points.astype(np.float32).astype(np.float64)
    faces, _ = faces_of(points, points, 0.98, device)
    assert len(faces) == 2 * 90 - 4 and as_set(faces) == brute_faces(points, points, 0.98)


def test_circle_widths_are_fractions_of_the_ball(device, rng):
    points, normals = bumpy(rng, 50, 0.1)
    faces, widths = faces_of(points, normals, 0.3, device)
    a, b, c = (points[faces[:, k]] for k in range(3))
    sides = [np.linalg.norm(p - q, axis=1) for p, q in ((a, b), (b, c), (c, a))]
    radii = np.prod(sides, axis=0) / (2 * np.linalg.norm(np.cross(b - a, c - a), axis=1))
    np.testing.assert_allclose(widths, (radii / 0.3) ** 2, rtol=1e-6)  # rounded to float32


def test_points_with_too_many_neighbors_are_processed_again(device, rng, monkeypatch):
    points, normals = bumpy(rng, 300, 0.1)
    expected, _ = faces_of(points, normals, 0.3, device)
    monkeypatch.setattr(ball_faces, "FIRST_ROOM", 4)
    monkeypatch.setattr(ball_faces, "CPU_ROOM", 4)
    monkeypatch.setattr(ball_faces, "FIRST_SLOTS", 1)
    monkeypatch.setattr(ball_faces, "POINTS_PER_LAUNCH", 70)
    faces, _ = faces_of(points, normals, 0.3, device)
    assert len(faces) == len(expected) and as_set(faces) == as_set(expected)


def area_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)[:, 2] / 2


@pytest.mark.parametrize(
    ("spacing", "radius"), [(1.0, 0.75), (0.1, 1.0), (3e-5, 3.0), (1e-10, 1.0), (1e8, 0.75), (1.0, 3.0)]
)
def test_a_grid_has_two_triangles_a_cell_and_none_overlap(device, spacing, radius):
    points = np.array([(x, y, 0) for x in range(20) for y in range(20)]) * spacing
    faces, _ = faces_of(points, np.tile([0.0, 0, 1], (400, 1)), radius * spacing, device)
    areas = area_of(points / spacing, faces)
    assert len(faces) == 2 * 19 * 19
    np.testing.assert_allclose(areas, 0.5, rtol=1e-5)  # rounding to float32
    cells = (points / spacing)[faces].min(axis=1).round()
    assert (np.unique(cells, axis=0, return_counts=True)[1] == 2).all()


@pytest.mark.parametrize("seed", range(2))
def test_points_on_one_circle_are_a_fan_about_the_first(device, seed):
    circle = {(x, y) for x in range(-5, 6) for y in range(-5, 6) if x * x + y * y == 25}
    points = np.random.default_rng(seed).permutation([(x, y, 7.0) for x, y in sorted(circle)])
    faces, _ = faces_of(points, np.tile([0.0, 0, 2], (12, 1)), 6.0, device)
    assert len(faces) == 10 and (faces[:, 0] == 0).all() and (area_of(points, faces) > 0).all()


CORNERS = itertools.product((-1, 1), repeat=2)
MIDDLES = sorted({p for corner in CORNERS for p in itertools.permutations((*corner, 0))})
SOLIDS = {
    "cube": (list(itertools.product((-1, 1), repeat=3)), 12),
    "octahedron": ([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], 8),
    "cuboctahedron": (MIDDLES, 20),
}  # fmt: skip


@pytest.mark.parametrize("solid", SOLIDS)
@pytest.mark.parametrize(("side", "seed"), [(1, 0), (-1, 1)])
def test_the_corners_of_a_solid_make_its_closed_surface_from_outside_and_from_inside(device, solid, side, seed):
    corners, count = SOLIDS[solid]
    points = np.random.default_rng(seed).permutation(np.array(corners, float))
    radius = 0.9 * np.linalg.norm(points[0])  # from inside the ball through all corners is the first that does not fit
    faces, _ = faces_of(points, side * points, radius, device)
    mesh = loom.TriangleMesh(points, faces)
    assert len(faces) == count and mesh.is_watertight()
    volume = np.einsum("ij,ij->i", points[faces[:, 0]], np.cross(points[faces[:, 1]], points[faces[:, 2]])).sum()
    assert np.sign(volume) == side


@pytest.mark.parametrize("solid", SOLIDS)
def test_a_ball_blocked_from_all_sides_does_not_fit(device, solid):
    points = np.array(SOLIDS[solid][0], float)
    assert len(faces_of(points, -points, np.linalg.norm(points[0]), device)[0]) == 0


def test_a_circle_as_large_as_the_ball_counts(device):
    points = np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0]])
    normals = np.tile([0.0, 0, 1], (3, 1))
    assert len(faces_of(points, normals, 2.5, device)[0]) == 1
    assert len(faces_of(points, normals, np.nextafter(np.float32(2.5), 0), device)[0]) == 0


def test_a_normal_at_a_right_angle_agrees_and_three_do_not(device):
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    right, up, down = [1.0, 0, 0], [0.0, 0, 1], [0.0, 0, -1]
    assert as_set(faces_of(points, np.array([right, up, right]), 1.0, device)[0]) == {(0, 1, 2)}
    assert as_set(faces_of(points, np.array([right, down, right]), 1.0, device)[0]) == {(0, 2, 1)}
    assert len(faces_of(points, np.array([right, right, right]), 1.0, device)[0]) == 0
    assert len(faces_of(points, np.array([up, up, down]), 1.0, device)[0]) == 0


@pytest.mark.parametrize("power", [-40, 50])
def test_a_power_of_two_as_scale_changes_no_triangle(device, rng, power):
    points, normals = bumpy(rng, 200, 0.2)
    expected, widths = faces_of(points, normals, 0.2, device)
    scaled, scaled_widths = faces_of(np.ldexp(points, power), normals, 0.2 * 2.0**power, device)
    assert len(scaled) == len(expected) > 100 and by_corners(scaled, scaled_widths) == by_corners(expected, widths)
