"""Geodesic distances: exact on flat meshes, close on spheres and cylinders, infinite between components."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.meshes import geodesics

from .shape_scenes import eight_vertices, hostile_triangles, icosphere, shaken_grid

EXACT = 1e-9  # of distances of about 1: iterations end where distances change by less than 2e-10


@pytest.mark.parametrize("cells", [5, 24])
def test_distances_on_a_plane_are_straight(device, cells):
    mesh = TriangleMesh(*shaken_grid(cells), device=device)
    source = (cells + 1) ** 2 // 3
    straight = np.linalg.norm(mesh.vertices - mesh.vertices[source], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([source]), straight, rtol=0, atol=EXACT)


def test_coincident_vertices_have_zero_distance(device):
    """A strip along a line: two of its corners coincide and are joined by an edge of zero length."""
    vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0]]
    triangles = [[0, 2, 1], [2, 4, 1], [2, 3, 4], [3, 5, 4], [5, 6, 4]]
    result = TriangleMesh(vertices, triangles, device=device).compute_geodesic_distances([0])
    np.testing.assert_allclose(result, np.linalg.norm(vertices, axis=1), rtol=0, atol=EXACT)


def test_obtuse_triangles_are_handled(device):
    """A grid sheared into slivers, which fronts enter from outside."""
    positions, triangles = shaken_grid(12)
    mesh = TriangleMesh(positions @ [[1, 0, 0], [2.5, 1, 0], [0, 0, 1]], triangles, device=device)
    wanted = np.linalg.norm(mesh.vertices - mesh.vertices[40], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([40]), wanted, rtol=0, atol=EXACT)


def test_on_a_cylinder_the_error_decreases_quadratically_with_edge_length(device):
    errors = []
    for steps in (20, 40):
        angle, along = np.meshgrid(2 * np.pi * np.arange(steps) / steps, np.linspace(0, 2, steps // 2), indexing="ij")
        indices = np.arange(angle.size).reshape(angle.shape)
        after = np.roll(indices, -1, axis=0)
        a, b, c, d = indices[:, :-1].ravel(), after[:, :-1].ravel(), after[:, 1:].ravel(), indices[:, 1:].ravel()
        vertices = np.stack([np.cos(angle), np.sin(angle), along], axis=-1).reshape(-1, 3)
        mesh = TriangleMesh(vertices, np.r_[np.c_[a, b, d], np.c_[b, c, d]], device=device)
        result = mesh.compute_geodesic_distances([steps // 4])
        wanted = np.hypot(np.minimum(angle, 2 * np.pi - angle), along - along[0, steps // 4]).ravel()
        errors.append(np.abs(result - wanted).max())
    assert errors[0] < 0.015 and errors[1] < errors[0] / 3.5


def test_distances_are_to_the_nearest_source(device):
    """Where the fronts of two sources meet, the error is below half an edge; its mean falls quadratically."""
    means = []
    for cells in (20, 40):
        mesh = TriangleMesh(*shaken_grid(cells), device=device)
        chosen = [(cells + 1) * (cells // 3) + cells // 4, (cells + 1) * (2 * cells // 3) + cells // 2]
        straight = [np.linalg.norm(mesh.vertices - mesh.vertices[s], axis=1) for s in chosen]
        errors = np.abs(mesh.compute_geodesic_distances(chosen) - np.minimum(*straight))
        assert errors.max() < 0.5 / cells
        means.append(errors.mean())
    assert means[1] < means[0] / 2.5


def test_unreachable_vertices_are_infinitely_far(device):
    vertices, triangles = icosphere(1)
    count = len(vertices)
    both = np.vstack([vertices, vertices + np.array([5, 0, 0]), [[9, 9, 9]]])
    mesh = TriangleMesh(both, np.vstack([triangles, triangles + count]), device=device)
    result = mesh.compute_geodesic_distances([0])
    assert np.isfinite(result[:count]).all() and np.isinf(result[count:]).all()
    alone = mesh.compute_geodesic_distances([2 * count])
    assert alone[-1] == 0 and np.isinf(alone[:-1]).all()


def test_paths_avoid_non_finite_vertices(device):
    positions, triangles = shaken_grid(8, shake=0.0)
    positions[40] = np.nan  # the middle
    result = TriangleMesh(positions, triangles, device=device).compute_geodesic_distances([36])
    assert np.isinf(result[40]) and np.isfinite(np.delete(result, 40)).all()
    assert result[36] == 0 and result[44] > np.linalg.norm(positions[44] - positions[36]) + 0.01


@settings(deadline=None, max_examples=40)
@given(hostile_triangles, st.integers(0, 7))
def test_no_path_is_longer_than_along_edges(triangles, source):
    """Not shorter than the straight line either, among edges of many triangles and degenerate triangles."""
    with cpu_compiler("warp"):
        mesh = TriangleMesh(eight_vertices, triangles)
        result = mesh.compute_geodesic_distances([source])
        vertices = mesh.vertices
        ways = np.full((8, 8), np.inf)
        for a, b, c in triangles:
            for i, j in ((a, b), (b, c), (c, a)):
                ways[i, j] = ways[j, i] = np.linalg.norm(vertices[i] - vertices[j])
        np.fill_diagonal(ways, 0)
        for k in range(8):
            ways = np.minimum(ways, ways[:, k : k + 1] + ways[k])
        np.testing.assert_array_equal(np.isfinite(result), np.isfinite(ways[source]))
        reached = np.isfinite(result)
        assert (result[reached] <= ways[source][reached] * (1 + EXACT)).all()
        assert (result[reached] >= 0).all()


@pytest.mark.slow
def test_distances_converge_around_slivers(monkeypatch):
    rounds, loop_while = [], geodesics.loop_while

    def counted(running, body):
        def step():
            rounds.append(None)
            assert len(rounds) < 2000, "distances still become shorter"
            body()

        loop_while(running, step)

    monkeypatch.setattr(geodesics, "loop_while", counted)
    mesh = loom.datasets.object_mesh().filter_smooth_taubin(10)
    assert np.isfinite(mesh.compute_geodesic_distances([0])).all()
