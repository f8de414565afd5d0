"""create_from_point_cloud_poisson: close to the true surface, closed, reproducible, and the effect of each argument."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.lang import cpu_compiler

from .poisson_scenes import (
    assert_only_the_cube_cuts,
    bits,
    clustered_sphere,
    cube_around,
    edges_by_use,
    poisson,
    sphere,
    sphere_distance,
)


def test_samples_of_a_ball_give_a_closed_ball(device):
    mesh, densities = poisson(sphere(1500), device=device)
    assert mesh.is_watertight() and len(mesh.cluster_connected_triangles()[1]) == 1
    edges, counts, twisted = edges_by_use(mesh.triangles)
    assert (counts == 2).all() and twisted == 0 and len(mesh.vertices) - len(edges) + len(mesh) == 2
    assert abs(mesh.get_volume() / (4 / 3 * np.pi) - 1) < 0.01  # outwards: the volume has a sign
    assert sphere_distance(mesh.vertices).max() < 0.02
    assert densities.shape == (len(mesh.vertices),) and densities.dtype == np.float32


def test_level_transitions_have_no_crack(device):
    points = clustered_sphere(5000)
    mesh, densities = poisson(points, depth=7, scale=1.3, device=device)
    assert np.ptp(densities) > 2.5  # local depths: cells of three levels and more
    assert assert_only_the_cube_cuts(mesh, points, 1.3) == 0 and mesh.is_watertight()


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::pointloom.NormalsWarning")
@pytest.mark.slow_on_emulated_cuda("thirty trees, on the CPU alone")
@settings(deadline=None, max_examples=30)
@given(st.integers(0, 10**6), st.integers(2, 300), st.integers(3, 7), st.sampled_from([1.0, 3.0, 8.0]))
def test_there_is_no_crack_for_any_points(seed, count, depth, power):
    rng = np.random.default_rng(seed)
    points, normals = rng.random((count, 3)) ** power, rng.normal(size=(count, 3))
    with cpu_compiler("warp"):
        mesh, densities = poisson(points, normals, depth)
        assert_only_the_cube_cuts(mesh, points)
        assert np.isfinite(mesh.vertices).all() and np.isfinite(densities).all()
        assert not mesh.edge_topology().has_split_vertex


def test_an_open_scan_ends_at_the_cube(device):
    points = sphere(3000)
    points = points[points[:, 2] > 0]
    mesh, _ = poisson(points, device=device)
    assert assert_only_the_cube_cuts(mesh, points) > 0
    _, side = cube_around(points)
    assert (mesh.vertices.max(axis=0) - mesh.vertices.min(axis=0)).max() > 0.999 * side
    near = cKDTree(points).query(mesh.vertices)[0] < 0.05
    assert np.quantile(sphere_distance(mesh.vertices[near]), 0.95) < 0.01


def test_all_sides_of_the_cube_are_equivalent(device):
    """Samples are within a cell or two of all six sides: splines beyond a side must be included on all of them."""
    points = sphere(1500)
    straight, densities = poisson(points, device=device)
    rotated, others = poisson(points * [-1, 1, -1], device=device)
    apart, nearest = cKDTree(rotated.vertices * [-1, 1, -1]).query(straight.vertices)
    assert np.quantile(apart, 0.99) < 1e-5
    assert np.quantile(np.abs(densities - others[nearest]), 0.99) < 1e-5


@pytest.mark.parametrize("power", [-90, 20])
def test_triangles_do_not_depend_on_the_unit_of_length(device, power):
    points = sphere(1000)
    mesh, densities = poisson(points, device=device)
    cloud = loom.PointCloud(points * 2.0**power, normals=points, origin=np.zeros(3), device=device)
    scaled, others = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
    np.testing.assert_array_equal(scaled.triangles, mesh.triangles)
    np.testing.assert_array_equal(scaled.vertices, mesh.vertices * 2.0**power)
    np.testing.assert_array_equal(others, densities)


def test_a_width_sets_the_depth_with_cells_no_wider(device):
    points = sphere(1000)
    _, side = cube_around(points)
    for width in (side / 32, side / 17):
        assert bits(poisson(points, depth=2, width=width, device=device)) == bits(poisson(points, device=device))


def test_normal_lengths_matter_only_on_request(device):
    points = sphere(1000)
    lengths = np.random.default_rng(1).uniform(0.2, 2, (1000, 1))
    assert bits(poisson(points, points * 4, device=device)) == bits(poisson(points, device=device))
    plain = poisson(points, device=device)[0].vertices
    weighed = poisson(points, points * lengths, confidence=True, device=device)[0].vertices
    apart = cKDTree(plain).query(weighed)[0]
    assert 1e-4 < np.median(apart) < 1e-2


@pytest.mark.parametrize("factor", [2.0**-80, 2.0**80])
def test_a_common_factor_of_normals_changes_nothing(device, factor):
    points = sphere(1000)
    normals = (points * np.random.default_rng(1).uniform(0.2, 2, (1000, 1))).astype(np.float32)
    plain, scaled = (poisson(points, normals * f, confidence=True, device=device) for f in (1, np.float32(factor)))
    assert bits(plain) == bits(scaled)


def test_longer_normals_attract_the_surface(device):
    """Two samples of a sheet at each position, one above the other: the longer normals win."""
    rng = np.random.default_rng(0)
    flat = np.concatenate([rng.random((2000, 2)), np.zeros((2000, 1))], axis=1)
    points = np.concatenate([flat, flat + np.array([0, 0, 0.02])])
    normals = np.tile([0, 0, 1.0], (4000, 1))
    heights = []
    for above in (0.1, 1.0, 10.0):
        lengths = np.repeat([1.0, above], 2000)[:, None]
        mesh, _ = poisson(points, normals * lengths, confidence=True, device=device)
        inner = (np.abs(mesh.vertices[:, :2] - 0.5) < 0.4).all(axis=1)
        heights.append(np.median(mesh.vertices[inner, 2]))
    assert 0 < heights[0] < 0.006 < heights[1] < 0.014 < heights[2] < 0.02


def test_point_weights_attract_the_surface(device):
    points = sphere(2000)
    meshes = [poisson(points, point_weight=weight, device=device)[0] for weight in (0, 2)]
    errors = [np.quantile(sphere_distance(mesh.vertices), 0.95) for mesh in meshes]
    assert errors[1] < errors[0] / 2 and errors[0] < 0.02


def test_linear_interpolation_is_less_exact_than_parabolic(device):
    points = sphere(8000)
    (curved, _), (straight, _) = (poisson(points, linear_fit=fit, device=device) for fit in (False, True))
    np.testing.assert_array_equal(curved.triangles, straight.triangles)
    errors = [np.median(sphere_distance(mesh.vertices)) for mesh in (curved, straight)]
    assert errors[0] < 0.65 * errors[1]


def test_more_samples_per_node_give_a_coarser_tree(device):
    points = sphere(3000)
    depths = [np.median(poisson(points, depth=6, samples_per_node=n, device=device)[1]) for n in (1.5, 6.0)]
    assert abs(depths[0] - depths[1] - 1) < 0.1  # log4 of four


def test_colors_come_from_the_nearest_points(device):
    points = sphere(1000)
    colors = np.random.default_rng(2).random((1000, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, normals=points, colors=colors, device=device)
    mesh, _ = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, 5)
    apart, nearest = cKDTree(points).query(mesh.vertices, k=2)
    clear = apart[:, 1] - apart[:, 0] > 1e-5
    np.testing.assert_array_equal(mesh.vertex_colors[clear], colors[nearest[clear, 0]])
    assert poisson(points, device=device)[0].vertex_colors is None
