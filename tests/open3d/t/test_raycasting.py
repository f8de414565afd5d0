"""`o3d.t.geometry.RaycastingScene`: values by arithmetic for a unit box, types and shapes of results."""

import copy
import pickle

import numpy as np
import pytest

import pointloom.open3d as o3d
from pointloom.open3d.core import Tensor, float32, float64, int32, uint32

Scene, Mesh = o3d.t.geometry.RaycastingScene, o3d.t.geometry.TriangleMesh
INVALID = 2**32 - 1
TYPES = {"t_hit": "float32", "geometry_ids": "uint32", "primitive_ids": "uint32", "ray_splits": "uint32"}
TYPES |= {"ray_ids": "uint32", "primitive_uvs": "float32", "primitive_normals": "float32", "points": "float32"}


def device_named(device):
    return o3d.core.Device(device.upper())


@pytest.fixture
def scene(device):
    made = Scene(device=device_named(device))
    assert made.add_triangles(Mesh.create_box(device=device_named(device))) == 0
    return made


def on(device, values, dtype=float32):
    return Tensor(values, dtype, device_named(device))


def read(results, device):
    """Results as NumPy arrays, after a check of types and devices."""
    assert all(v.device == device_named(device) and v.numpy().dtype == TYPES[k] for k, v in results.items())
    return {name: tensor.numpy() for name, tensor in results.items()}


RAYS = [[[0.25, 0.5, 3, 0, 0, -1], [0.25, 0.5, 0.5, 0, 0, 2]], [[5, 5, 5, 1, 0, 0], [-1, 0.25, 0.5, 0.5, 0, 0]]]


def test_rays_hit_the_box_at_known_parameters(scene, device):
    found = read(scene.cast_rays(on(device, RAYS)), device)
    np.testing.assert_array_equal(found["t_hit"], [[2, 0.25], [np.inf, 2]])
    np.testing.assert_array_equal(found["geometry_ids"], [[0, 0], [INVALID, 0]])
    np.testing.assert_array_equal(found["primitive_normals"], [[[0, 0, 1], [0, 0, 1]], [[0, 0, 0], [-1, 0, 0]]])
    assert found["primitive_ids"][1, 0] == INVALID == Scene.INVALID_ID and found["primitive_uvs"].shape == (2, 2, 2)
    corners = np.array(Mesh.create_box().vertex.positions.numpy())[
        Mesh.create_box().triangle.indices.numpy()[found["primitive_ids"][0, 0]]
    ]
    u, v = found["primitive_uvs"][0, 0]
    np.testing.assert_allclose((1 - u - v) * corners[0] + u * corners[1] + v * corners[2], [0.25, 0.5, 1], atol=1e-6)


def test_all_intersections_are_counted_listed_and_tested(scene, device):
    rays = on(device, RAYS)
    counts = scene.count_intersections(rays)
    assert counts.dtype == int32 and counts.numpy().tolist() == [[2, 1], [0, 2]]
    listed = read(scene.list_intersections(rays), device)
    assert listed["ray_splits"].tolist() == [0, 2, 3, 3, 5] and listed["ray_ids"].tolist() == [0, 0, 1, 3, 3]
    np.testing.assert_array_equal(listed["t_hit"], [2, 3, 0.25, 2, 4])
    blocked = [scene.test_occlusions(rays, *limits).numpy() for limits in ((), (0.0, 1.5), (2.5,))]
    assert [b.tolist() for b in blocked] == [[[1, 1], [0, 1]], [[0, 1], [0, 0]], [[1, 0], [0, 1]]]


def test_distances_to_the_box_are_signed_and_have_the_shape_of_the_queries(scene, device):
    queries = on(device, [[[0.5, 0.5, 0.5], [2, 0.5, 0.5]], [[0.5, 0.5, 1.25], [4, 5, 0.5]]])
    for method, expected in (
        (scene.compute_distance, [[0.5, 1], [0.25, 5]]),
        (scene.compute_signed_distance, [[-0.5, 1], [0.25, 5]]),
        (scene.compute_occupancy, [[1, 0], [0, 0]]),
    ):
        found = method(queries, nthreads=2)
        assert found.dtype == float32 and found.device == device_named(device)
        np.testing.assert_array_equal(found.numpy(), expected)
    closest = read(scene.compute_closest_points(queries), device)
    np.testing.assert_array_equal(closest["points"][0, 1], [1, 0.5, 0.5])
    np.testing.assert_array_equal(closest["points"][1, 1], [1, 1, 0.5])
    assert closest["geometry_ids"].tolist() == [[0, 0], [0, 0]]


def test_geometries_are_numbered_and_taken_as_tensors_arrays_or_meshes(device):
    made = Scene(0, device_named(device))
    corners = np.array([[0, 0, 2], [1, 0, 2], [0, 1, 2]])
    assert made.add_triangles(on(device, corners, float64), on(device, [[0, 1, 2]], uint32)) == 0
    assert made.add_triangles(vertex_positions=corners + 1.0, triangle_indices=np.array([[0, 1, 2]])) == 1
    assert made.add_triangles(mesh=Mesh.create_box(device=device_named(device))) == 2
    rays = np.array([[0.2, 0.2, 9, 0, 0, -1], [1.2, 1.2, 9, 0, 0, -1]], np.float32)
    for scene in (made, copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
        assert scene.cast_rays(rays)["geometry_ids"].numpy().tolist() == [0, 1]
    assert Scene().cast_rays(rays)["t_hit"].numpy().tolist() == [np.inf] * 2


def test_rays_of_a_camera_pass_through_pixel_centers():
    K, T = [[4.0, 0, 1.5], [0, 4, 1], [0, 0, 1]], np.eye(4)
    T[:3, 3] = 0, 0, 2
    rays = Scene.create_rays_pinhole(Tensor(K), extrinsic_matrix=Tensor(T), width_px=3, height_px=2)
    assert rays.dtype == float32 and tuple(rays.shape) == (2, 3, 6)
    np.testing.assert_allclose(rays.numpy()[1, 2], [0, 0, -2, 1 / 4, 0.5 / 4, 1])
    view = Scene.create_rays_pinhole(90, Tensor([0.0, 0, 0]), [0, 0, 2], [0, 1, 0], 2, 2).numpy()
    np.testing.assert_allclose(view[0, 0], [0, 0, 2, 0.5, -0.5, -1], atol=1e-7)


@pytest.mark.parametrize(
    ("call", "error", "name"),
    [
        (lambda s: s.add_triangles(o3d.geometry.TriangleMesh.create_box()), TypeError, "mesh"),
        (lambda s: s.cast_rays(np.zeros((2, 5), np.float32)), ValueError, "rays"),
        (lambda s: s.compute_distance(np.zeros((2, 4), np.float32)), ValueError, "query_points"),
    ],
)
def test_wrong_arguments_are_named(call, error, name):
    with pytest.raises(error, match=name):
        call(Scene())
