"""Which way is up in a mesh: files of glTF say so, it goes along and turns with the mesh, and views stand upright."""

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


@pytest.mark.parametrize(("name", "up", "told"), [("a.glb", "y", Y), ("a.gltf", "z", Z), ("a.ply", "y", None)])
def test_files_of_gltf_say_which_axis_is_up(tmp_path, name, up, told):
    loom.write_triangle_mesh(tmp_path / name, loom.TriangleMesh.create_box())
    assert loom.read_triangle_mesh(tmp_path / name, up=up).up == told


def test_up_goes_along_and_turns_with_the_mesh(cone):
    assert cone.translate((1, 2, 3)).compute_vertex_normals().paint_uniform_color((1, 0, 0)).up == Y
    assert cone.rotate(QUARTER, (0, 0, 0)).up == Z and cone.scale(3.0, (0, 0, 0)).up == Y
    assert pickle.loads(pickle.dumps(cone)).up == Y
    assert loom.TriangleMesh.create_box().translate((1, 0, 0)).up is None


def test_pictures_stand_upright(cone):
    same = loom.render(cone, None, (120, 120), up="y")
    assert np.array_equal(loom.render(cone, None, (120, 120)), same)
    assert not np.array_equal(loom.render(cone, None, (120, 120), up="z"), same)
    turned = np.eye(4)
    turned[:3, :3] = QUARTER
    posed = loom.render({"geometry": cone, "pose": turned}, None, (120, 120))
    rows, columns = np.nonzero((posed != 255).any(axis=2))
    assert np.ptp(rows) > 2 * np.ptp(columns)


@pytest.mark.parametrize(
    ("value", "kind"), [("w", ValueError), ((0, 0, 0), ValueError), ((1, 2), ValueError), (object(), TypeError)]
)
def test_what_is_no_direction_is_refused(cone, value, kind):
    with pytest.raises(kind, match="up:"):
        cone.up = value
    assert cone.up == Y
