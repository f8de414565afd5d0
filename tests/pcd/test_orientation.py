"""Consistent orientation: compared with Kruskal's algorithm on small clouds, known surfaces, and edge cases."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import PointTree

from .any_cloud import examples
from .orientation import agreement, orient, random_signs, sphere


def row_sums(a):
    return a[..., 0] + a[..., 1] + a[..., 2]  # in this order, as the kernels sum


def listed_neighbors(points, units, k, cos_alpha_tol, outliers):
    """[n, k] by distance, ties by index; excluded neighbors are replaced by the point itself."""
    d = points[None] - points[:, None]
    sqdists = row_sums(d * d)
    lists = np.argsort(sqdists, axis=1, kind="stable")[:, :k]
    d = np.take_along_axis(d, lists[..., None], axis=1)
    heights = np.abs(row_sums(d * units[:, None]))
    drop = heights > np.float32(cos_alpha_tol) * np.sqrt(row_sums(d * d)) if cos_alpha_tol < 1 else heights < 0
    if outliers:
        ranked = np.sort(heights, axis=1)
        low, high = ranked[:, k // 4], ranked[:, 3 * k // 4]
        drop |= heights > (high + np.float32(1.5) * (high - low))[:, None]
    return np.where(drop, np.arange(len(points))[:, None], lists)


def orient_by_kruskal(points, normals, k, cos_alpha_tol=1.0, outliers=False):
    """The rule in NumPy, quadratic; vertices are ranks on the tree's curve, which breaks ties."""
    usable = np.flatnonzero(np.isfinite(points).all(axis=1) & np.isfinite(normals).all(axis=1))
    oriented = normals.copy()
    if not len(usable):
        return oriented
    rows = usable[download(PointTree(upload(points[usable], vec3, "cpu")).order)]
    positions, exact = points[rows], normals[rows].astype(float)
    sizes = np.sqrt(row_sums(exact * exact))
    units = (exact / np.where(sizes > 0, sizes, 1)[:, None]).astype(np.float32)
    cosines = row_sums(units[:, None].astype(float) * units[None].astype(float))
    labels, signs = np.arange(len(rows)), np.ones(len(rows))

    def join(u, v):
        if labels[u] != labels[v]:
            part = labels == labels[v]
            signs[part] *= (-1.0 if cosines[u, v] < 0 else 1.0) * signs[u] * signs[v]
            labels[part] = labels[u]

    lists = listed_neighbors(positions, units, min(k, len(rows)), cos_alpha_tol, outliers)
    starts = np.repeat(np.arange(len(rows)), lists.shape[1])
    weights = (1 - np.abs(cosines[starts, lists.ravel()])).astype(np.float32).clip(0)
    for entry in np.argsort(weights, kind="stable"):
        join(starts[entry], lists.flat[entry])
    u, v = np.triu_indices(len(rows), 1)
    d = positions[v] - positions[u]
    for pair in np.argsort(row_sums(d * d), kind="stable"):
        join(u[pair], v[pair])
    low = np.flatnonzero(positions[:, 2] == positions[:, 2].min())
    low = low[rows[low].argmin()]
    signs *= signs[low] * (-1 if normals[rows[low], 2] > 0 else 1)
    oriented[rows] *= signs[:, None].astype(np.float32)
    return oriented


@st.composite
def small_clouds(draw):
    rng = np.random.default_rng(draw(st.integers(0, 10_000)))
    count = draw(st.integers(1, 80))
    points = rng.integers(0, 4, (count, 3)) if draw(st.booleans()) else rng.normal(size=(count, 3)) ** 3
    normals = rng.normal(size=(count, 3)) * rng.uniform(0.5, 2, (count, 1))
    points, normals = points.astype(np.float32), normals.astype(np.float32)
    if draw(st.booleans()):
        normals = np.eye(3, dtype=np.float32)[rng.integers(0, 3, count)] * rng.choice([-1, 0, 1, 1], (count, 1))
    if draw(st.booleans()):
        points[rng.random(count) < 0.1, rng.integers(0, 3)] = rng.choice([np.nan, np.inf, -np.inf])
        normals[rng.random(count) < 0.1, rng.integers(0, 3)] = np.nan
    return points, normals.astype(np.float32)


@given(cloud=small_clouds(), k=st.sampled_from([1, 2, 5, 12, 100]))
@examples(15)
def test_signs_follow_the_minimum_spanning_tree(device, cloud, k):
    """With duplicates, all kinds of ties, zero normals, and non-finite points and normals."""
    points, normals = cloud
    result = orient(points, normals, k, device)
    np.testing.assert_array_equal(result, orient_by_kruskal(points, normals, k))


@pytest.mark.parametrize("options", [(0.5, 1.0), (0.0, 0.6), (0.5, 0.8)], ids=str)
def test_steep_and_outlying_neighbors_are_left_out(device, rng, options):
    penalty, steepest = options
    changed = penalty > 0  # the effect of outliers is tested on a thin wall below
    for k in (3, 8, 20):
        points, normals = rng.normal(size=(2, 120, 3)).astype(np.float32) ** 3
        result = orient(points, normals, k, device, lambda_penalty=penalty, cos_alpha_tol=steepest)
        np.testing.assert_array_equal(result, orient_by_kruskal(points, normals, k, steepest, penalty > 0))
        changed |= not np.array_equal(result, orient(points, normals, k, device))
    assert changed, "the options matter on such clouds"


def torus(rng, count):
    u, v = rng.uniform(0, 2 * np.pi, (2, count))
    outward = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) * 2 + 0.7 * outward, outward


def nested(rng, count):
    parts = [sphere(rng, count // 2), sphere(rng, count // 2, 2.0)]
    return np.concatenate([p for p, _ in parts]), np.concatenate([n for _, n in parts])


@pytest.mark.parametrize("surface", [sphere, torus, nested])
def test_normals_of_closed_surfaces_point_outward(device, surface, rng):
    points, outward = surface(rng, 4000)
    result = orient(points, random_signs(rng, outward), 12, device)
    np.testing.assert_array_equal(result, outward.astype(np.float32))
    fitted = loom.PointCloud(points, device=device).estimate_normals(max_nn=12)
    assert agreement(fitted.orient_normals_consistent_tangent_plane(12).normals, outward) == 1.0


def thin_wall(half, spacing):
    """Points and outward normals of a round plate of radius 1 with a round rim."""
    steps = np.arange(-1, 1, spacing)
    xy = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    xy = xy[(xy**2).sum(axis=1) < 1]
    faces = [np.column_stack([xy, np.full(len(xy), side)]) for side in (-half, half)]
    angle, tilt = np.meshgrid(np.arange(0, 2 * np.pi, spacing), np.linspace(-np.pi / 2, np.pi / 2, 7))
    angle, tilt = angle.ravel(), tilt.ravel()
    rim = np.stack([np.cos(angle) * np.cos(tilt), np.sin(angle) * np.cos(tilt), np.sin(tilt)], axis=1)
    points = np.concatenate([*faces, np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) + half * rim])
    return points, np.concatenate([np.tile([0, 0, side], (len(xy), 1)) for side in (-1.0, 1.0)] + [rim])


@pytest.mark.parametrize("options", [{"cos_alpha_tol": 0.5}, {"lambda_penalty": 1.0}], ids=str)
def test_faces_of_a_thin_wall_are_separated_by_excluding_neighbors_across(device, options, rng):
    """The faces are 4 cm apart and their points 3 cm: one of ten neighbors is on the other face."""
    points, outward = thin_wall(0.02, 0.03)
    normals = random_signs(rng, outward)
    assert agreement(orient(points, normals, 10, device), outward) < 0.9
    assert agreement(orient(points, normals, 10, device, **options), outward) == 1.0


def test_coplanar_and_collinear_points_are_oriented(device, rng):
    """Open3D's Delaunay tetrahedra do not exist there."""
    plane = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    down = np.tile([0.0, 0, -1], (500, 1))
    assert agreement(orient(plane, random_signs(rng, down), 8, device), down) == 1.0
    line = np.column_stack([np.linspace(0, 1, 500), np.zeros((500, 2))])
    assert agreement(orient(line, random_signs(rng, down), 8, device), down) == 1.0
    lattice = np.stack(np.meshgrid(*[np.arange(8.0)] * 3), axis=-1).reshape(-1, 3)
    down = np.tile([0.0, 0.6, -0.8], (512, 1))
    assert agreement(orient(lattice, random_signs(rng, down), 8, device), down) == 1.0


@pytest.mark.parametrize("k", [1, 3, 40])
def test_duplicates_terminate(device, rng, k):
    """More copies of a point than k: all its neighbors are copies."""
    points = np.repeat(rng.normal(size=(7, 3)), 60, axis=0)[rng.permutation(420)]
    down = np.tile([0.6, 0.0, -0.8], (420, 1))
    assert agreement(orient(points, random_signs(rng, down), k, device), down) == 1.0
    equal = np.full((420, 3), 0.3)
    assert agreement(orient(equal, random_signs(rng, down), k, device), down) == 1.0


@pytest.mark.parametrize("k", [1, 2, 10_000_000])
def test_clouds_of_a_few_points_are_oriented(device, k):
    points = np.array([[0, 0, 1], [0, 0, 0], [1, 0, 0.0]])
    normals = np.array([[0, 0.6, 0.8], [0, 0, 1], [0, 0.6, -0.8]], np.float32)
    for count, expected in ((0, []), (1, [-1]), (2, [-1, -1]), (3, [-1, -1, 1])):
        result = orient(points[:count].reshape(-1, 3), normals[:count].reshape(-1, 3), k, device)
        np.testing.assert_array_equal(result, normals[:count] * np.array(expected, np.float32).reshape(-1, 1))
