"""Metrics between surfaces: known distances, brute force over many points, valid bounds."""

import numpy as np
import pytest

from pointloom import TriangleMesh

from .surface_oracles import distances_to_triangles
from .test_scene_distances import CUBE, FAR, corners_of, torus


def plate(height=0.0, size=1.0, device=None, shift=(0, 0, 0)) -> TriangleMesh:
    corners = np.array([[0, 0, height], [size, 0, height], [size, size, height], [0, size, height]]) + shift
    return TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]], device=device)


def test_distance_of_parallel_plates_is_exact(device):
    result = plate(device=device).compute_metrics(plate(0.5, device=device), [0.4, 0.6], n_sampled_points=500)
    assert result.chamfer == pytest.approx(1, rel=1e-12)
    assert result.hausdorff == result.hausdorff_bound == 0.5 and result.fscore.tolist() == [0, 100]
    assert result.mean == result.rms == result.max == (0.5, 0.5)


@pytest.mark.slow
@pytest.mark.parametrize("shift", [np.zeros(3), FAR])
def test_means_match_dense_sampling_at_any_position(device, shift):
    a, b = torus(), torus(30, 9)
    mesh, other = (TriangleMesh(v + shift, t, device=device) for v, t in (a, b))
    result = mesh.compute_metrics(other, [0.02], n_sampled_points=20000)
    samples = mesh.sample_points_uniformly(4000, seed=7).points - shift
    truth = distances_to_triangles(samples, corners_of(*b)).min(1)
    assert result.mean[0] == pytest.approx(truth.mean(), rel=0.05)  # of 4,000 random points
    assert result.rms[0] == pytest.approx(np.sqrt((truth**2).mean()), rel=0.05)
    assert result.max[0] >= truth.max() - 1e-6


def test_hausdorff_distance_between_vertices_is_detected(device):
    tent = TriangleMesh([[-3, 0, 1], [3, 0, 1], [0, 0.1, 1], [0, -0.1, 1]], [[0, 1, 2], [0, 3, 1]], device=device)
    posts = [[[x, -1, 0], [x, 1, 0], [x, 0, -1]] for x in (-3, 3)]
    ground = TriangleMesh(np.reshape(posts, (-1, 3)), [[0, 1, 2], [3, 4, 5]], device=device)
    result = tent.compute_metrics(ground, [0.1], n_sampled_points=10)
    exact = np.hypot(3, 1)  # at the middle, where no vertex and hardly a sample is: vertices 2 and 3 are located there
    assert result.max[0] == pytest.approx(exact, rel=1e-3) and result.hausdorff_bound >= exact * (1 - 1e-6)
    line = TriangleMesh([[-3, 0, 1], [3, 0, 1], [3, 1e-3, 1]], [[0, 1, 2]], device=device)
    result = line.compute_metrics(ground, [0.1], n_sampled_points=10)
    assert result.max[0] == pytest.approx(exact, abs=1e-3)


def test_bounds_are_valid_and_tight_on_random_surfaces(device):
    rng = np.random.default_rng(0)
    for _ in range(3):
        one, two = (rng.random((18, 3)) for _ in range(2))
        meshes = [TriangleMesh(v, np.arange(18).reshape(-1, 3), device=device) for v in (one, two)]
        result = meshes[0].compute_metrics(meshes[1], [0.1], n_sampled_points=200)
        w = rng.dirichlet([1, 1, 1], 3000)
        points = np.einsum("nk,tkd->tnd", w, one.reshape(-1, 3, 3)).reshape(-1, 3)
        there = distances_to_triangles(points, corners_of(two, np.arange(18).reshape(-1, 3))).min(1).max()
        assert there <= result.hausdorff_bound + 1e-6 and there <= result.max[0] + 2e-5
        assert result.max[0] == pytest.approx(there, abs=0.02)  # of 3,000 points a triangle
        assert 0 <= result.hausdorff_bound - result.hausdorff <= 2e-5


def test_an_error_map_colors_each_vertex_by_its_distance(device):
    vertices, triangles = torus()
    mesh = TriangleMesh(np.vstack([vertices, [[np.nan] * 3]]), triangles, device=device)
    cube = TriangleMesh(*CUBE, device=device)
    colored, distances = mesh.compute_error_map(cube)
    truth = distances_to_triangles(vertices.astype(np.float32), corners_of(*CUBE)).min(1)
    np.testing.assert_allclose(distances[:-1], truth, rtol=1e-6, atol=1e-7)
    assert np.isnan(distances[-1]) and colored.vertex_colors[-1].tolist() == [0.5, 0.5, 0.5]
    order = np.argsort(distances[:-1])
    assert (np.diff(colored.vertex_colors[:-1][order, 1]) >= -1e-6).all()  # green grows along the colors
    capped = mesh.compute_error_map(cube, max_distance=0.1)[0].vertex_colors[:-1]
    yellow = np.broadcast_to(np.float32([0.993, 0.906, 0.144]), ((truth > 0.1).sum(), 3))
    np.testing.assert_allclose(capped[truth > 0.1], yellow, rtol=1e-6)
    assert np.isinf(mesh.compute_error_map(TriangleMesh([], [], device=device))[1][:-1]).all()
    colored, distances = cube.compute_error_map(cube)  # no largest distance to divide by
    assert (distances == 0).all() and (colored.vertex_colors == colored.vertex_colors[0]).all()
