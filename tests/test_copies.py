"""Public objects can be copied, pickled and printed in a line."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)


def integrate(volume, seed):
    depth = (1 + 0.2 * np.random.default_rng(seed).random((24, 32))).astype(np.float32)
    volume.integrate(depth, CAMERA, np.eye(4), np.full((24, 32, 3), 90, np.uint8))


def make_mesh(device):
    corners = [[5e5, 0, 0], [5e5 + 1, 0, 0], [5e5, 1, 0]]
    return loom.TriangleMesh(corners, [[0, 1, 2]], vertex_colors=np.eye(3), device=device)


def make_volume(device):
    volume = loom.TSDFVolume(voxel_size=0.05, device=device)
    integrate(volume, 1)
    return volume


def make_result(device):
    cloud = loom.PointCloud(np.random.default_rng(0).random((50, 3)), device=device)
    return loom.registration.registration_icp(cloud, cloud.translate([0.01, 0, 0]), 0.2)


def surface_bits(volume):
    mesh = volume.extract_triangle_mesh(0)
    return mesh.vertices.tobytes(), mesh.vertex_colors.tobytes(), volume.frame_count, volume.origin.tobytes()


MADE = {
    "mesh": (make_mesh, lambda m: (m.vertices.tobytes(), m.triangles.tobytes(), m.vertex_colors.tobytes())),
    "volume": (make_volume, surface_bits),
    "search": (
        lambda device: loom.NearestNeighborSearch(np.random.default_rng(0).random((50, 3)), device=device),
        lambda search: search.knn_search([0.5, 0.5, 0.5], 5).indices.tobytes(),
    ),
    "result": (
        make_result,
        lambda r: (r.transformation.tobytes(), r.correspondence_set.tobytes(), r.score, r.warnings),
    ),
    "trajectory": (lambda device: loom.Trajectory(np.eye(4)[None], [0.5]), lambda t: (t.poses.tobytes(), t.timestamps)),
}
WAYS = {"pickle": lambda made: pickle.loads(pickle.dumps(made)), "copy": copy.copy, "deepcopy": copy.deepcopy}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", MADE)
def test_a_copy_has_the_same_contents(device, name, way):
    make, bits = MADE[name]
    made = make(device)
    again = WAYS[way](made)
    assert type(again) is type(made) and bits(again) == bits(made)
    if hasattr(made, "device"):
        assert again.device == made.device


@pytest.mark.parametrize("way", [*WAYS, "copy()"])
def test_a_copied_volume_is_independent(device, way):
    volume = make_volume(device)
    before = surface_bits(volume)
    other = volume.copy() if way == "copy()" else WAYS[way](volume)
    integrate(other, 2)
    assert surface_bits(volume) == before and surface_bits(other) != before
    integrate(volume, 2)
    assert surface_bits(volume) == surface_bits(other)


def test_a_copied_mesh_is_assigned_to_by_itself(device):
    mesh = make_mesh(device)
    other = mesh.copy()
    other.vertex_colors = np.zeros((3, 3))
    assert mesh.vertex_colors.tolist() == np.eye(3).tolist() and not other.vertex_colors.any()


@pytest.mark.parametrize("name", MADE)
def test_printed_objects_are_one_line(device, name):
    text = repr(MADE[name][0](device))
    assert "\n" not in text and len(text) < 160 and " object at " not in text
