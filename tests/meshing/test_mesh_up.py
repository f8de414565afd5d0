"""The up axis of a mesh: glTF files define it, it follows copies and rotations, and views are upright."""

import pickle

import numpy as np
import pytest

import pointloom as loom

QUARTER = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])  # takes y to z
Y, Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@pytest.fixture
def cone(device):
    mesh = loom.TriangleMesh.create_cone(0.5, 4.0).rotate(QUARTER.T, (0, 0, 0)).to(device)
    mesh.up = "y"
    return mesh


@pytest.mark.parametrize(("name", "up", "expected"), [("a.glb", "y", Y), ("a.gltf", "z", Z), ("a.ply", "y", None)])
def test_gltf_files_define_the_up_axis(tmp_path, name, up, expected):
    loom.write_triangle_mesh(tmp_path / name, loom.TriangleMesh.create_box())
    assert loom.read_triangle_mesh(tmp_path / name, up=up).up == expected


def test_up_axis_follows_rotations_of_the_mesh(cone):
    assert cone.translate((1, 2, 3)).compute_vertex_normals().paint_uniform_color((1, 0, 0)).up == Y
    assert cone.rotate(QUARTER, (0, 0, 0)).up == Z and cone.scale(3.0, (0, 0, 0)).up == Y
    assert pickle.loads(pickle.dumps(cone)).up == Y
    assert loom.TriangleMesh.create_box().translate((1, 0, 0)).up is None


def test_images_are_upright(cone):
    same = loom.render(cone, None, (120, 120), up="y")
    assert np.array_equal(loom.render(cone, None, (120, 120)), same)
    assert not np.array_equal(loom.render(cone, None, (120, 120), up="z"), same)
    rotation = np.eye(4)
    rotation[:3, :3] = QUARTER
    posed = loom.render({"geometry": cone, "pose": rotation}, None, (120, 120))
    rows, columns = np.nonzero((posed != 255).any(axis=2))
    assert np.ptp(rows) > 2 * np.ptp(columns)


@pytest.mark.parametrize(
    ("value", "kind"), [("w", ValueError), ((0, 0, 0), ValueError), ((1, 2), ValueError), (object(), TypeError)]
)
def test_invalid_directions_are_rejected(cone, value, kind):
    with pytest.raises(kind, match="up:"):
        cone.up = value
    assert cone.up == Y
