"""Deformation graphs, fields of Gaussians and borders of surfaces against float64 NumPy."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pointloom.kernels.bending import deformation_graph as graphs
from pointloom.kernels.bending.coherent_field import move_points
from pointloom.kernels.bending.surface_pairs import find_borders
from pointloom.kernels.lang import mat33d, vec3, vec3d
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import PointTree


def weights_of(p: np.ndarray, nodes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    d = np.linalg.norm(nodes - p, axis=1)
    near = np.argsort(d, kind="stable")[:5]
    end = d[near[-1]] * (1 if len(near) == 5 else 2)
    near = near[:4]
    w = np.maximum(1 - d[near] / end, 0) ** 2 if end > 0 else np.zeros(len(near))
    if not w.any():
        w[0] = 1
    return near, w / w.sum()


def bent(p: np.ndarray, nodes: np.ndarray, rotations: np.ndarray, centers: np.ndarray) -> np.ndarray:
    near, w = weights_of(p, nodes)
    return sum(w[k] * (rotations[j] @ (p - nodes[j]) + centers[j]) for k, j in enumerate(near))


@pytest.mark.parametrize(("count", "spread"), [(1, 1.0), (3, 1.0), (6, 0.0), (9, 1.0)])
def test_points_normals_and_volumes_follow_the_graph(device, count, spread):
    """One node, fewer nodes than a point takes, nodes at one position, and enough of them."""
    rng = np.random.default_rng(count)
    nodes = (0.25 + spread * rng.uniform(-1, 1, (count, 3))).astype(np.float32)
    rotations = Rotation.from_rotvec(0.3 * rng.normal(size=(count, 3))).as_matrix()
    centers = nodes + 0.2 * rng.normal(size=(count, 3))
    points = np.vstack([nodes[:1], rng.uniform(-1, 1, (6, 3)), [[np.nan, 0, 0]]]).astype(np.float32)
    normals = rng.normal(size=(8, 3)).astype(np.float32)
    normals[1] = 0
    arrays = upload(nodes, vec3, device), upload(rotations, mat33d, device), upload(centers, vec3d, device)
    graph = graphs.DeformationGraph(*arrays)
    influence = graphs.Influence(upload(points, vec3, device), graph)

    def position(p):
        return bent(p, nodes.astype(float), rotations, centers)

    finite = points[:-1].astype(float)
    expected = np.array([position(p) for p in finite])
    wide = graphs.bend_wide(graph, influence, (5, 6, 7))
    for moved, origin in ((graphs.bend_points(graph, influence), 0), (wide, [5, 6, 7])):
        np.testing.assert_allclose(download(moved)[:-1] - origin, expected, atol=1e-6)
        assert np.isnan(download(moved)[-1, 0])
    step = 1e-6 * np.eye(3)
    slopes = np.array([np.stack([position(p + e) - position(p - e) for e in step], axis=1) for p in finite]) / 2e-6
    volumes = np.linalg.det(slopes)
    np.testing.assert_allclose(download(graphs.measure_volumes(graph, influence)), [*volumes, np.nan], rtol=1e-4)
    transformed = volumes[:, None] * np.linalg.solve(slopes.transpose(0, 2, 1), normals[:-1, :, None])[:, :, 0]
    sizes = np.linalg.norm(transformed, axis=1, keepdims=True)
    transformed *= np.linalg.norm(normals[:-1], axis=1, keepdims=True) / np.where(sizes > 0, sizes, 1)
    result = download(graphs.bend_normals(graph, influence, upload(normals, vec3, device)))
    np.testing.assert_allclose(result, [*transformed, normals[-1]], atol=1e-4)


@pytest.mark.parametrize("side", [3, 8])
def test_borders_are_points_far_from_the_mean_of_their_neighbors(device, side):
    """9 points give no border: too few have enough neighbors."""
    grid = np.stack(np.meshgrid(*[np.arange(side)] * 2), axis=-1).reshape(-1, 2)
    points = np.column_stack([grid, 0.1 * np.sin(grid[:, 0])]).astype(np.float32)
    points += np.random.default_rng(0).uniform(-0.1, 0.1, points.shape).astype(np.float32)  # no equal distances
    normals = np.tile(np.array([0, 0, 1], np.float32), (side * side, 1))
    result = download(find_borders(PointTree(upload(points, vec3, device)), upload(normals, vec3, device)))
    d = np.linalg.norm(points[:, None].astype(float) - points, axis=2)
    near = np.argsort(d, axis=1)[:, :20]
    offsets = np.linalg.norm((points[near].astype(float).mean(axis=1) - points)[:, :2], axis=1)
    borders = offsets > 0.3 * np.take_along_axis(d, near, axis=1)[:, -1]
    np.testing.assert_array_equal(result, borders if side * side > 10 else False)


def test_points_move_by_the_sum_of_the_gaussians_and_stay_where_they_are_not_finite(device, rng):
    points = rng.normal(size=(50, 3)).astype(np.float32)
    points[3], points[7] = np.nan, [0, np.inf, 0]
    shift, unit, scale = np.array([0.5, -1.0, 2.0]), 0.25, 1.5
    centers, weights = rng.normal(size=(2, 12, 3))
    result = download(move_points(upload(points, vec3, device), shift, unit, centers, weights, scale))
    scaled = (points.astype(float) + shift) * unit
    gaps = ((scaled[:, None] - centers) ** 2).sum(axis=2)
    expected = points + np.exp(-scale * gaps) @ weights / unit
    expected[[3, 7]] = points[[3, 7]]
    np.testing.assert_allclose(result, expected, rtol=1e-6, atol=1e-6)
    still = move_points(upload(points, vec3, device), shift, unit, centers[:0], weights[:0], scale)
    np.testing.assert_array_equal(download(still), points)
