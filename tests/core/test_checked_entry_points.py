"""Constructor checks also run for pickles and attributes. A damaged pickle raises ValueError."""

import numpy as np
import pytest

import pointloom as loom


def mesh():
    made = loom.TriangleMesh.create_box().compute_vertex_normals()
    made.triangle_uvs, made.triangle_material_ids = np.zeros((36, 2)), np.zeros(12, int)
    made.vertex_attributes["heat"] = np.arange(8.0)
    return made


def cloud():
    made = loom.PointCloud(np.eye(3), normals=np.eye(3), ring=np.arange(3))
    made.grid = 1, 3
    return made


def image():
    return loom.RGBDImage(np.zeros((4, 6, 3), np.uint8), np.ones((4, 6), np.float32))


def volume():
    made = loom.TSDFVolume(voxel_size=0.1, color=False)
    made.integrate(np.ones((4, 6), np.float32), loom.PinholeCameraIntrinsic(6, 4, 6.0, 6.0, 2.5, 1.5), np.eye(4))
    return made


def grid():
    made = loom.OccupancyGrid(0.1)
    made.insert_scan(np.eye(3), [0, 0, 0])
    return made


def field():
    return loom.DistanceField.from_point_cloud(loom.PointCloud(np.eye(3)), 0.1, 1)


def scene():
    made = loom.RaycastingScene()
    made.add_triangles(loom.TriangleMesh.create_box())
    return made


def put(*keys_and_value):
    """A change of a state: the value under these keys, deleted where it is None."""
    *keys, last, value = keys_and_value

    def change(state):
        for key in keys:
            state[key] = dict(state[key])
            state = state[key]
        if value is None:
            del state[last]
        else:
            state[last] = value

    return change


def vectors(values, kind="vec3"):
    return np.array(values, "i4" if kind == "vec3i" else "f4"), kind


@pytest.mark.parametrize(
    ("make", "change"),
    [
        (mesh, put("arrays", None)),
        (mesh, put("arrays", "triangles", vectors([[0, 1, 8]] * 12, "vec3i"))),
        (mesh, put("arrays", "triangles", vectors([[0, 1, -1]] * 12, "vec3i"))),
        (mesh, put("arrays", "vertices", vectors(np.zeros((7, 3))))),
        (mesh, put("arrays", "vertices", (np.zeros((8, 3)), "vec3"))),
        (mesh, put("arrays", "vertices", (np.zeros((12, 2), "f4"), "vec3"))),
        (mesh, put("arrays", "vertex_normals", vectors(np.zeros((7, 3))))),
        (mesh, put("arrays", "vertex_normals", (np.array([None] * 8), ""))),
        (mesh, put("arrays", "triangle_uvs", vectors(np.zeros((35, 2)), "vec2"))),
        (mesh, put("arrays", "triangle_material_ids", (np.full(12, -1, "i4"), ""))),
        (mesh, put("arrays", "unknown", vectors(np.zeros((8, 3))))),
        (mesh, put("attributes", "vertex_attributes", {"heat": (np.zeros(7), "")})),
        (mesh, put("textures", (np.zeros((2, 2), np.uint8),))),
        (mesh, put("origin", np.full(3, np.nan))),
        (mesh, put("library", "other")),
        (cloud, put("arrays", "points", vectors(np.zeros((2, 3))))),
        (cloud, put("arrays", "points", (np.zeros(3), ""))),
        (cloud, put("arrays", "normals", vectors(np.zeros((4, 3))))),
        (cloud, put("arrays", "ring", "text")),
        (cloud, put("grid", (3, 3))),
        (cloud, put("origin", [np.inf, 0, 0])),
        (image, put("height", 400)),
        (image, put("arrays", "depth_array", (np.ones(23, "f4"), ""))),
        (image, put("arrays", "color_array", (np.ones((24, 4), "u1"), ""))),
        (volume, put("arrays", "keys", np.zeros(1, np.int64))),
        (volume, put("arrays", "sizes", np.array([1e300, 1e300]))),
        (volume, put("arrays", "distances", None)),
        (grid, put("arrays", "odds", np.zeros(512, np.float32))),
        (grid, put("arrays", "voxel_size", np.array(5e-324))),
        (field, put("arrays", "voxels", np.zeros((2, 3), np.int32))),
        (field, put("arrays", "sizes", np.zeros(3))),
        (scene, put("mesh_of", [1])),
        (scene, put("mesh_of", [-1])),
        (scene, put("poses", [])),
        (scene, put("poses", [np.full((4, 4), np.nan)])),
        (scene, put("meshes", [3])),
    ],
)
def test_a_damaged_state_is_refused(make, change):
    kind, state = type(make()), make().__getstate__()
    kind.__new__(kind).__setstate__(state)  # as it is, it is taken
    change(state)
    with pytest.raises(ValueError, match="the pickle is damaged or of another version"):
        kind.__new__(kind).__setstate__(state)


def test_a_search_of_something_else_than_a_cloud_is_refused():
    kind = loom.NearestNeighborSearch
    with pytest.raises(TypeError, match="cloud"):
        kind.__new__(kind).__setstate__(np.eye(3))


@pytest.mark.parametrize(
    ("make", "names"),
    [
        (image, ["color_array", "depth_array", "height", "width", "device"]),
        (volume, ["device", "has_color", "voxel_size", "truncation"]),
        (grid, ["device", "voxel_size"]),
        (field, ["device", "voxel_size", "max_distance", "shape", "origin", "is_signed"]),
    ],
)
def test_attributes_that_arrays_depend_on_cannot_be_assigned(make, names):
    made = make()
    for name in names:
        with pytest.raises(AttributeError, match=name):
            setattr(made, name, getattr(made, name))
