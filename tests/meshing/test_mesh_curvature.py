"""Vertex curvature of spheres, cylinders, saddles and planes, and NaN where it is undefined."""

import numpy as np
import pytest

from pointloom import TriangleMesh

from .shape_scenes import icosphere, shaken_grid


def around(device, height, cells=24):
    """A grid over -1/2 .. 1/2 as a height field of x and y, and its middle vertex."""
    positions, triangles = shaken_grid(cells, shake=0.0)
    x, y = positions[:, 0] - 0.5, positions[:, 1] - 0.5
    middle = int(np.argmin(x * x + y * y))
    return TriangleMesh(np.c_[x, y, height(x, y)], triangles, device=device).compute_vertex_curvature(), middle


@pytest.mark.parametrize("radius", [1.0, 0.02, 300.0])
def test_a_sphere_has_the_curvature_of_its_radius(device, radius):
    errors = []
    for rounds in (2, 3):
        curvature = TriangleMesh(*icosphere(rounds, radius), device=device).compute_vertex_curvature()
        np.testing.assert_allclose(curvature.mean * radius, 1, rtol=0, atol=1e-3)  # truncated: edges of 0.3 radii
        errors.append(np.abs(curvature.gaussian * radius**2 - 1).max())
        assert (curvature.least <= curvature.mean).all() and (curvature.mean <= curvature.largest).all()
    assert errors[0] < 0.03 and errors[1] < errors[0] / 3  # falls with the square of the edges


def test_angle_defects_of_a_closed_mesh_sum_to_4_pi(device):
    """Gauss-Bonnet: over a sphere, curvature times mixed Voronoi area sums to 4 pi."""
    rng = np.random.default_rng(0)
    vertices, triangles = icosphere(1)
    mesh = TriangleMesh(vertices * (1 + 1.5 * rng.random((len(vertices), 1))), triangles, device=device)
    areas = mixed_areas(mesh.vertices, triangles)
    assert areas.sum() == pytest.approx(mesh.get_surface_area(), rel=1e-12)
    assert (mesh.compute_vertex_curvature().gaussian * areas).sum() == pytest.approx(4 * np.pi, rel=1e-12)


def mixed_areas(vertices, triangles):
    """The mixed Voronoi areas of Meyer et al., figure 4."""
    areas = np.zeros(len(vertices))
    for triangle in triangles:
        for k in range(3):
            p, q, r = vertices[np.roll(triangle, -k)]
            u, v, w = q - p, r - p, r - q
            twice = np.linalg.norm(np.cross(u, v))
            if u @ v < 0:
                areas[triangle[k]] += twice / 4
            elif u @ w > 0 or v @ w < 0:
                areas[triangle[k]] += twice / 8
            else:
                areas[triangle[k]] += (u @ u * (v @ w) - v @ v * (u @ w)) / twice / 8
    return areas


@pytest.mark.parametrize(
    ("height", "smallest", "largest"),
    [
        (lambda x, y: 0 * x, 0, 0),
        (lambda x, y: -(x * x + y * y) / 2, 1, 1),
        (lambda x, y: (x * x - y * y) / 2, -1, 1),
        (lambda x, y: -(x * x + 3 * y * y) / 2, 1, 3),
    ],
    ids=["plane", "cap", "saddle", "ridge"],
)
def test_surfaces_over_a_plane_have_their_second_derivatives(device, height, smallest, largest):
    curvature, middle = around(device, height)
    result = [values[middle] for values in curvature]
    wanted = [(smallest + largest) / 2, smallest * largest, smallest, largest]
    np.testing.assert_allclose(result, wanted, rtol=0, atol=0.02)  # cells of 1/24: some 1/24^2 of the curvature
    assert np.isnan(curvature.mean[0])  # at the rim


def test_only_consistently_oriented_rings_have_a_curvature(device):
    vertices, triangles = icosphere(0)
    plain = TriangleMesh(vertices, triangles, device=device).compute_vertex_curvature().mean
    assert np.isfinite(plain).all()
    flipped = triangles.copy()
    flipped[0] = flipped[0, ::-1]
    doubled = np.vstack([triangles, triangles[:1]])
    opened = triangles[1:]
    for other in (flipped, doubled, opened):
        curvature = TriangleMesh(vertices, other, device=device).compute_vertex_curvature()
        wrong = np.isin(np.arange(12), triangles[0])
        for values in curvature:
            np.testing.assert_array_equal(np.isnan(values), wrong)
        np.testing.assert_array_equal(curvature.mean[~wrong], plain[~wrong])


def test_two_fans_at_a_vertex_have_no_curvature(device):
    vertices, triangles = icosphere(0)
    other = np.where(triangles == 0, 0, triangles + 11)
    touching = np.vstack([vertices, 2 * vertices[0] - vertices[1:]])
    curvature = TriangleMesh(touching, np.vstack([triangles, other[:, ::-1]]), device=device).compute_vertex_curvature()
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(curvature.gaussian)), [0])


def test_degenerate_and_non_finite_triangles_have_no_curvature(device):
    vertices, triangles = icosphere(0)
    for spoilt in ([np.nan, 0, 0], vertices[triangles[0, 1]]):  # the latter flattens two triangles
        positions = vertices.copy()
        positions[triangles[0, 0]] = spoilt
        curvature = TriangleMesh(positions, triangles, device=device).compute_vertex_curvature()
        assert np.isnan(curvature.mean[triangles[0]]).all()
        assert np.isfinite(curvature.mean).sum() >= 4
    assert [len(values) for values in TriangleMesh(device=device).compute_vertex_curvature()] == [0] * 4
    assert np.isnan(TriangleMesh([[1, 2, 3]], device=device).compute_vertex_curvature().mean).all()
