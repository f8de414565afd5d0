"""Meshes cut at a level of vertex values: agreement with brute force for each triangle."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler

from .poisson_scenes import edges_by_use, poisson, sphere


def grid(size: int, device=None, **arrays) -> TriangleMesh:
    """The square from 0 to `size`, two triangles per unit; vertex (x, y) has index x (size + 1) + y."""
    positions = np.stack(np.meshgrid(np.arange(size + 1), np.arange(size + 1), indexing="ij"), axis=-1).reshape(-1, 2)
    corner = (positions[:, 0] * (size + 1) + positions[:, 1])[(positions < size).all(axis=1)]
    right, up = corner + size + 1, corner + 1
    triangles = np.concatenate([np.stack([corner, right, up], axis=1), np.stack([right, right + 1, up], axis=1)])
    vertices = np.concatenate([positions, np.zeros((len(positions), 1))], axis=1)
    return TriangleMesh(vertices, triangles, device=device, **arrays)


def clip(corners, values, level):
    """The polygon of a triangle above the level, float64 [k, d], by Sutherland and Hodgman."""
    clipped = []
    for p, q, a, b in zip(corners, np.roll(corners, -1, axis=0), values, np.roll(values, -1), strict=True):
        if a >= level:
            clipped.append(p)
        if (a > level > b) or (a < level < b):
            clipped.append(p + (q - p) * (level - a) / (b - a))
    return np.array(clipped).reshape(-1, corners.shape[1])


def signed_areas(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


@pytest.mark.parametrize("values", list(itertools.product([0.0, 1.0, 3.0], repeat=3)))
def test_one_triangle_is_clipped_as_a_polygon(device, values):
    corners = np.array([[0, 0, 0], [4.0, 0, 0], [1, 8, 0]])
    mesh = TriangleMesh(corners, [[0, 1, 2]], device=device)
    left = mesh.trim(values, 1.0, island_ratio=0)
    polygon = clip(corners, values, 1.0)
    x, y = polygon[:, :2].T
    area = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2
    areas = signed_areas(left.vertices, left.triangles)
    assert (areas > 0).all() and abs(areas.sum() - area) < 1e-6
    if area > 0:
        assert {tuple(np.float32(p)) for p in polygon} == {tuple(np.float32(p)) for p in left.vertices}


def test_a_cut_ball_matches_brute_force(device):
    mesh, _ = poisson(sphere(600), depth=4, device=device)
    vertices, triangles = mesh.array("vertices").numpy().astype(float), mesh.triangles
    values = np.random.default_rng(0).normal(size=len(vertices)) + vertices[:, 2]
    left = mesh.trim(values, 0.25, island_ratio=0)
    wanted = sum(
        np.linalg.norm(np.cross(p[i] - p[0], p[i + 1] - p[0])) / 2
        for p in (clip(vertices[t], values[t], 0.25) for t in triangles)
        for i in range(1, len(p) - 1)
    )
    assert abs(left.get_surface_area() / wanted - 1) < 1e-6
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 0, 2]].reshape(-1, 2), axis=1), axis=0)
    a, b = edges.T
    cut = (values[a] - 0.25) * (values[b] - 0.25) < 0
    a, b = a[cut], b[cut]
    share = ((0.25 - values[a]) / (values[b] - values[a]))[:, None]
    positions = np.float32(vertices[a] * (1 - share) + vertices[b] * share)
    remaining = np.unique(triangles[(values[triangles] > 0.25).any(axis=1)])
    remaining = remaining[values[remaining] >= 0.25]
    wanted = np.concatenate([np.float32(vertices[remaining]), positions])
    np.testing.assert_array_equal(left.vertices, np.float64(wanted))
    normals = mesh.vertex_normals.astype(float)
    between = normals[a] * (1 - share) + normals[b] * share
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    np.testing.assert_allclose(left.vertex_normals, np.concatenate([normals[remaining], between]), atol=1e-7)


def test_colors_are_interpolated_along_the_edge(device):
    mesh = TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]], vertex_colors=np.eye(3), device=device)
    left = mesh.trim([0, 4, 0], 1)
    np.testing.assert_array_equal(left.vertex_colors, np.float32([[0, 1, 0], [0.75, 0.25, 0], [0, 0.25, 0.75]]))
    assert left.vertex_normals is None


def test_a_level_out_of_range_keeps_all_or_nothing(device):
    mesh = grid(4, device)
    values = np.arange(25.0)
    for level in (-1, 0):
        left = mesh.trim(values, level)
        np.testing.assert_array_equal(left.triangles, mesh.triangles)
        np.testing.assert_array_equal(left.vertices, mesh.vertices)
    left = mesh.trim(values, 24.5)
    assert len(left) == 0 and len(left.vertices) == 0
    assert len(TriangleMesh(device=device).trim([], 0)) == 0


def dots(size, *cells, inside=1.0):
    """Values 1 at some vertices of a grid and 0 elsewhere (or the other way round)."""
    values = np.full((size + 1, size + 1), 1.0 - inside)
    for cell in cells:
        values[cell] = inside
    return values.ravel()


def area_of(mesh, values, level=0.5, **options):
    return mesh.trim(values, level, **options).get_surface_area()


DOT = 6 * 0.5**3  # six triangles around a vertex, each cut halfway


def test_holes_below_the_ratio_are_preserved(device):
    mesh = grid(10, device)
    values = dots(10, (2, 2), inside=0.0)
    assert abs(area_of(mesh, values, island_ratio=0) - (100 - DOT)) < 1e-4
    assert abs(area_of(mesh, values, island_ratio=0.0074) - (100 - DOT)) < 1e-4
    left = mesh.trim(values, 0.5, island_ratio=0.0076)
    assert abs(left.get_surface_area() - 100) < 1e-4
    _, counts, _ = edges_by_use(left.triangles)
    assert counts.max() == 2 and (counts == 1).sum() == 40  # the square's boundary alone: no crack along the hole


def test_a_missing_piece_at_the_boundary_is_no_hole(device):
    mesh = grid(10, device)
    for cell, share in (((0, 5), 3), ((0, 0), 1)):
        values = dots(10, cell, inside=0.0)
        assert abs(area_of(mesh, values, island_ratio=0.5) - (100 - share / 8)) < 1e-4


def test_an_isolated_part_below_the_level_is_removed(device):
    mesh = grid(10, device)
    ball, _ = poisson(sphere(200), depth=3, device=device)
    vertices = np.concatenate([mesh.vertices, ball.vertices * 0.1 + 50])
    both = TriangleMesh(vertices, np.concatenate([mesh.triangles, ball.triangles + 121]), device=device)
    values = np.concatenate([np.ones(121), np.zeros(len(ball.vertices))])
    assert abs(both.trim(values, 0.5, island_ratio=0.1).get_surface_area() - 100) < 1e-4


def parts_of(triangles, chosen):
    """Edge-connected components of chosen triangles, by flood fill."""
    at = {}
    for i in np.flatnonzero(chosen):
        for k in range(3):
            at.setdefault(frozenset((triangles[i][k], triangles[i][(k + 1) % 3])), []).append(i)
    left, parts = set(np.flatnonzero(chosen)), []
    while left:
        front, part = [left.pop()], set()
        while front:
            i = front.pop()
            part.add(i)
            for k in range(3):
                for j in at[frozenset((triangles[i][k], triangles[i][(k + 1) % 3]))]:
                    if j in left:
                        left.remove(j)
                        front.append(j)
        parts.append(part)
    return parts


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.01, 0.05, 0.2]), st.floats(0.1, 0.9))
def test_islands_and_holes_match_flood_fill(seed, ratio, share):
    """Values of 0 and 1, so that every cut is in the middle of an edge."""
    rng = np.random.default_rng(seed)
    mesh = grid(8)
    corners = mesh.triangles[rng.permutation(128)[:120]]  # some missing: an inner boundary
    wanted = rng.random(len(corners)) < share
    vertices = mesh.vertices[corners].reshape(-1, 3)  # a value per corner: separate triangles, then one mesh
    values = np.repeat(wanted, 3) * 2.0 - 1
    levels = np.zeros(81)
    levels[corners[wanted].ravel()] = 1.0
    with cpu_compiler("warp"):
        joined = TriangleMesh(mesh.vertices, corners)
        split = joined.trim(levels, 0.5, island_ratio=0)
        left = joined.trim(levels, 0.5, island_ratio=ratio)
        apart = TriangleMesh(vertices, np.arange(360).reshape(-1, 3)).trim(values, 0.0, island_ratio=0)
    assert abs(apart.get_surface_area() - wanted.sum() / 2) < 1e-4
    pieces, above, positions = pieces_of(mesh.vertices, corners, levels)
    areas, total = np.abs(signed_areas(positions, pieces)), len(corners) / 2
    assert abs(areas[above].sum() - split.get_surface_area()) < 1e-4
    for part in parts_of(pieces, above):
        if areas[list(part)].sum() < ratio * total - 1e-9:
            above[list(part)] = False
    uses = {}
    for i, t in enumerate(pieces):
        for k in range(3):
            uses.setdefault(frozenset((t[k], t[(k + 1) % 3])), []).append(i)
    selected = above.copy()
    for part in parts_of(pieces, ~above):
        around = [uses[frozenset((pieces[i][k], pieces[i][(k + 1) % 3]))] for i in part for k in range(3)]
        enclosed = all(len(at) > 1 for at in around) and any(above[j] for at in around for j in at)
        if enclosed and areas[list(part)].sum() < ratio * total - 1e-9:
            selected[list(part)] = True
    assert abs(left.get_surface_area() - areas[selected].sum()) < 1e-4


def pieces_of(vertices, triangles, values):
    """(triangles, above, positions) of a mesh whose edges between 0 and 1 are split by hand."""
    positions, numbers, pieces, above = list(vertices), {}, [], []

    def middle(a, b):
        key = frozenset((a, b))
        if key not in numbers:
            numbers[key] = len(positions)
            positions.append((vertices[a] + vertices[b]) / 2)
        return numbers[key]

    for t in triangles:
        high = values[t] > 0.5
        if high.all() or not high.any():
            pieces.append(tuple(t))
            above.append(bool(high.all()))
            continue
        lone = int(np.flatnonzero(high == (high.sum() == 1))[0])
        a, b, c = t[lone], t[(lone + 1) % 3], t[(lone + 2) % 3]
        p, q = middle(a, b), middle(a, c)
        pieces += [(a, p, q), (p, b, c), (p, c, q)]
        above += [bool(high[lone])] + [not high[lone]] * 2
    return np.array(pieces), np.array(above), np.array(positions)


def test_huge_values_are_cut_correctly(device):
    mesh = TriangleMesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]], device=device)
    np.testing.assert_array_equal(mesh.trim([-1e100, 1e100, -1e100], 0).vertices, [[4, 0, 0], [2, 0, 0], [2, 2, 0]])
