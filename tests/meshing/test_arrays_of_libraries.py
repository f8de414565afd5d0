"""Meshes, scenes and volumes accept and return arrays of other libraries."""

import numpy as np
import pytest

import pointloom as loom

from ..array_library import LIBRARIES, assert_same, fake_library, package


@pytest.fixture(params=LIBRARIES)
def library(request, device, monkeypatch):
    return fake_library(request.param, device, monkeypatch)


@pytest.fixture
def ball(device):
    return loom.TriangleMesh.create_sphere(1.0, 8, device=device)


@pytest.fixture
def meshes(library, ball, device):
    vertices, triangles = ball.vertices.astype(np.float32), ball.triangles
    theirs = loom.TriangleMesh(library.make(vertices), library.make(triangles))
    return theirs, loom.TriangleMesh(vertices, triangles, device=device)


def test_a_mesh_shares_its_input_arrays(library, device, ball):
    vertices, triangles = library.make(ball.vertices.astype(np.float32)), library.make(ball.triangles)
    mesh = loom.TriangleMesh(vertices, triangles)
    assert str(mesh.device) == device and mesh.arrays["vertices"].ptr == library.address(vertices)
    assert mesh.arrays["triangles"].ptr == library.address(triangles)
    np.testing.assert_array_equal(mesh.triangles, ball.triangles)


def test_mesh_operations_return_arrays_of_its_library(library, meshes):
    operations = {
        "areas": lambda m: m.compute_triangle_areas(),
        "edges": lambda m: m.get_boundary_edges(),
        "open edges": lambda m: m.remove_triangles_by_index([0]).get_boundary_edges(),
        "loop": lambda m: m.remove_triangles_by_index([0]).get_boundaries()[0],
        "vertices": lambda m: m.get_non_manifold_vertices(),
        "starts": lambda m: m.compute_adjacency_list()[0],
        "neighbors": lambda m: m.compute_adjacency_list()[1],
        "parts": lambda m: m.cluster_connected_triangles()[0],
        "sizes": lambda m: m.cluster_connected_triangles()[1],
        "curvature": lambda m: m.compute_vertex_curvature().gaussian,
        "geodesic": lambda m: m.compute_geodesic_distances([0]),
        "meeting": lambda m: m.get_self_intersecting_triangles(),
        "error": lambda m: m.compute_error_map(m.translate([0.1, 0, 0]))[1],
        "samples": lambda m: m.sample_points_uniformly(50, seed=1).compute_nearest_neighbor_distance(),
    }
    theirs, reference = meshes
    for name, operation in operations.items():
        try:
            assert_same(library, operation(theirs), operation(reference))
        except AssertionError as error:
            raise AssertionError(name) from error


def test_masks_and_indices_can_be_arrays_of_any_library(library, meshes):
    theirs, reference = meshes
    mask = np.arange(len(reference)) % 3 == 0
    corners = reference.vertices[:, 2] > 0.5
    rows = np.array([3, -1, 3])
    for result, expected in (
        (theirs.remove_triangles_by_mask(library.make(mask)), reference.remove_triangles_by_mask(mask)),
        (theirs.remove_vertices_by_mask(library.make(corners)), reference.remove_vertices_by_mask(corners)),
        (theirs.remove_triangles_by_index(library.make(rows)), reference.remove_triangles_by_index(rows)),
        (theirs.select_by_index(library.make(np.arange(9))), reference.select_by_index(np.arange(9))),
    ):
        np.testing.assert_array_equal(result.vertices, expected.vertices)
        np.testing.assert_array_equal(result.triangles, expected.triangles)
    with pytest.raises(IndexError, match="vertex_indices:"):
        theirs.remove_vertices_by_index(library.make(np.array([0, 999])))


def test_triangles_without_their_vertices_are_rejected(library, ball):
    vertices, triangles = ball.vertices.astype(np.float32), ball.triangles.copy()
    triangles[2, 1] = len(vertices)
    with pytest.raises(ValueError, match="triangles:"):
        loom.TriangleMesh(library.make(vertices), library.make(triangles))
    with pytest.raises(TypeError, match="triangles:"):
        loom.TriangleMesh(library.make(vertices), library.make(vertices))


def test_scene_returns_the_array_type_of_its_queries(library, ball, device, rng):
    for shift in ([0, 0, 0], [5e5, 5.4e6, 0]):
        scene, empty = loom.RaycastingScene(device), loom.RaycastingScene(device)
        scene.add_triangles(ball.translate(shift))
        rays = np.hstack([rng.normal(size=(4, 30, 3)) * 3 + shift, rng.normal(size=(4, 30, 3))]).reshape(2, 60, 6)
        points = rng.normal(size=(5, 7, 3)) + shift
        if library.name == "jax":
            if any(shift):
                continue  # float32 cannot represent such coordinates
            rays, points = rays.astype(np.float32), points.astype(np.float32)
        for each in (scene, empty):
            for query, given in (
                (each.cast_rays, rays), (each.list_intersections, rays), (each.compute_closest_points, points),
            ):  # fmt: skip
                expected, result = query(given), query(library.make(given))
                assert result.keys() == expected.keys()
                for name, values in expected.items():
                    assert package(result[name]) == library.name
                    np.testing.assert_array_equal(library.host(result[name]), values, err_msg=name)
            for query, given in (
                (each.test_occlusions, rays), (each.count_intersections, rays), (each.compute_distance, points),
                (each.compute_signed_distance, points), (each.compute_occupancy, points),
            ):  # fmt: skip
                assert_same(library, query(library.make(given)), query(given))
    with pytest.raises(ValueError, match="rays:"):
        scene.cast_rays(library.make(np.zeros(3, np.float32)))


def test_a_volume_returns_the_array_type_of_its_frames(library, device, rng):
    camera = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    depth = rng.integers(950, 1050, (24, 32)).astype(np.uint16)
    color = rng.integers(0, 256, (24, 32, 3)).astype(np.uint8)
    seen = []
    for make in (library.make, np.asarray):
        volume = loom.TSDFVolume(voxel_size=0.05, device=device)
        volume.integrate(make(depth), camera, np.eye(4), color=make(color))
        seen.append(volume.ray_cast(camera, np.eye(4), weight_threshold=0))
        assert package(volume.extract_point_cloud(0).compute_nearest_neighbor_distance()) == package(make(depth))
    for name in ("depth", "points", "normals", "colors"):
        result, expected = getattr(seen[0], name), getattr(seen[1], name)
        assert package(result) == library.name
        np.testing.assert_array_equal(library.host(result), expected.astype(library.host(result).dtype))
