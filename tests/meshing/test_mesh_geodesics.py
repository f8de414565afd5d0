"""Distances along meshes: exact on flat ones, near on spheres and cylinders, infinite where no way is."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom import TriangleMesh
from pointloom.kernels.lang import cpu_compiler
from pointloom.kernels.meshes import geodesics

from .shape_scenes import eight_places, hostile_triangles, icosphere, shaken_grid

EXACT = (
    1e-9  # of distances of about 1: rounds end where a distance changes by less than 2e-10, at each of some vertices
)


@pytest.mark.parametrize("cells", [5, 24])
def test_distances_on_a_plane_are_straight(device, cells):
    mesh = TriangleMesh(*shaken_grid(cells), device=device)
    source = (cells + 1) ** 2 // 3
    straight = np.linalg.norm(mesh.vertices - mesh.vertices[source], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([source]), straight, rtol=0, atol=EXACT)


def test_vertices_in_one_place_are_no_way_apart(device):
    """A strip along a line: two of its corners are one place, joined by an edge without length."""
    vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0]]
    triangles = [[0, 2, 1], [2, 4, 1], [2, 3, 4], [3, 5, 4], [5, 6, 4]]
    found = TriangleMesh(vertices, triangles, device=device).compute_geodesic_distances([0])
    np.testing.assert_allclose(found, np.linalg.norm(vertices, axis=1), rtol=0, atol=EXACT)


def test_obtuse_triangles_are_no_obstacle(device):
    """A grid sheared until its triangles are slivers, over which fronts come from outside."""
    places, triangles = shaken_grid(12)
    mesh = TriangleMesh(places @ [[1, 0, 0], [2.5, 1, 0], [0, 0, 1]], triangles, device=device)
    wanted = np.linalg.norm(mesh.vertices - mesh.vertices[40], axis=1)
    np.testing.assert_allclose(mesh.compute_geodesic_distances([40]), wanted, rtol=0, atol=EXACT)


def test_on_a_cylinder_the_error_falls_with_the_square_of_the_edges(device):
    errors = []
    for steps in (20, 40):
        turn, along = np.meshgrid(2 * np.pi * np.arange(steps) / steps, np.linspace(0, 2, steps // 2), indexing="ij")
        places = np.arange(turn.size).reshape(turn.shape)
        after = np.roll(places, -1, axis=0)
        a, b, c, d = places[:, :-1].ravel(), after[:, :-1].ravel(), after[:, 1:].ravel(), places[:, 1:].ravel()
        vertices = np.stack([np.cos(turn), np.sin(turn), along], axis=-1).reshape(-1, 3)
        mesh = TriangleMesh(vertices, np.r_[np.c_[a, b, d], np.c_[b, c, d]], device=device)
        ours = mesh.compute_geodesic_distances([steps // 4])
        wanted = np.hypot(np.minimum(turn, 2 * np.pi - turn), along - along[0, steps // 4]).ravel()
        errors.append(np.abs(ours - wanted).max())
    assert errors[0] < 0.015 and errors[1] < errors[0] / 3.5


def test_the_nearest_source_counts(device):
    """Where the fronts of two sources meet the error is below half an edge; its mean falls with the square."""
    means = []
    for cells in (20, 40):
        mesh = TriangleMesh(*shaken_grid(cells), device=device)
        chosen = [(cells + 1) * (cells // 3) + cells // 4, (cells + 1) * (2 * cells // 3) + cells // 2]
        straight = [np.linalg.norm(mesh.vertices - mesh.vertices[s], axis=1) for s in chosen]
        errors = np.abs(mesh.compute_geodesic_distances(chosen) - np.minimum(*straight))
        assert errors.max() < 0.5 / cells
        means.append(errors.mean())
    assert means[1] < means[0] / 2.5


def test_no_way_is_infinitely_long(device):
    vertices, triangles = icosphere(1)
    count = len(vertices)
    both = np.vstack([vertices, vertices + np.array([5, 0, 0]), [[9, 9, 9]]])
    mesh = TriangleMesh(both, np.vstack([triangles, triangles + count]), device=device)
    ours = mesh.compute_geodesic_distances([0])
    assert np.isfinite(ours[:count]).all() and np.isinf(ours[count:]).all()
    alone = mesh.compute_geodesic_distances([2 * count])
    assert alone[-1] == 0 and np.isinf(alone[:-1]).all()


def test_ways_lead_around_vertices_that_are_not_finite(device):
    places, triangles = shaken_grid(8, shake=0.0)
    places[40] = np.nan  # the middle
    ours = TriangleMesh(places, triangles, device=device).compute_geodesic_distances([36])
    assert np.isinf(ours[40]) and np.isfinite(np.delete(ours, 40)).all()
    assert ours[36] == 0 and ours[44] > np.linalg.norm(places[44] - places[36]) + 0.01


@settings(deadline=None, max_examples=40)
@given(hostile_triangles, st.integers(0, 7))
def test_no_way_is_longer_than_one_along_edges(triangles, source):
    """Nor shorter than the straight one, among edges of many triangles and triangles of one corner."""
    with cpu_compiler("warp"):
        mesh = TriangleMesh(eight_places, triangles)
        ours = mesh.compute_geodesic_distances([source])
        vertices = mesh.vertices
        ways = np.full((8, 8), np.inf)
        for a, b, c in triangles:
            for i, j in ((a, b), (b, c), (c, a)):
                ways[i, j] = ways[j, i] = np.linalg.norm(vertices[i] - vertices[j])
        np.fill_diagonal(ways, 0)
        for k in range(8):
            ways = np.minimum(ways, ways[:, k : k + 1] + ways[k])
        np.testing.assert_array_equal(np.isfinite(ours), np.isfinite(ways[source]))
        reached = np.isfinite(ours)
        assert (ours[reached] <= ways[source][reached] * (1 + EXACT)).all()
        assert (ours[reached] >= 0).all()


@pytest.mark.parametrize("scale", [2.0**-20, 2.0**20])
def test_distances_grow_with_the_mesh(device, scale):
    vertices, triangles = icosphere(2)
    one, other = (
        TriangleMesh(s * vertices, triangles, device=device, origin=[0, 0, 0]).compute_geodesic_distances([3])
        for s in (1, scale)
    )
    np.testing.assert_array_equal(other / scale, one)


@pytest.mark.parametrize(
    ("sources", "error", "message"),
    [
        ([], ValueError, "sources: .* at least one"),
        ([4], ValueError, "sources: expected vertex indices from 0 to 3, got 4"),
        ([-1], ValueError, "sources: expected vertex indices from 0 to 3, got -1"),
        ([3], ValueError, "sources: vertex 3 is NaN or infinite"),
        ([0.5], TypeError, "sources"),
        (0, ValueError, r"sources: expected shape \[n\]"),
    ],
)
def test_sources_that_are_none_are_refused(sources, error, message):
    mesh = TriangleMesh(np.vstack([np.eye(3), np.full(3, np.nan)]), [[0, 1, 2]])
    with pytest.raises(error, match=message):
        mesh.compute_geodesic_distances(sources)


@pytest.mark.slow
def test_distances_do_not_creep_around_slivers_for_ever(monkeypatch):
    rounds, loop_while = [], geodesics.loop_while

    def counted(running, body):
        def turn():
            rounds.append(None)
            assert len(rounds) < 2000, "distances still become shorter"
            body()

        loop_while(running, turn)

    monkeypatch.setattr(geodesics, "loop_while", counted)
    mesh = loom.datasets.object_mesh().filter_smooth_taubin(10)
    assert np.isfinite(mesh.compute_geodesic_distances([0])).all()
