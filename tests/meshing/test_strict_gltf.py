"""A textured .glb holds what the specification asks, by a strict reader of its own; and that reader sees damage."""

import pytest

import pointloom as loom

from .picture_scenes import CAMERA, wall_scene
from .strict_gltf import faults_of_glb

pytest.importorskip("PIL")


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    scene = wall_scene((0.8, 1.2, 0.95))
    found = loom.color_map.texture_from_pictures(scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    path = tmp_path_factory.mktemp("gltf") / "wall.glb"
    loom.write_triangle_mesh(path, found.mesh)
    return path


def test_a_texture_out_of_pictures_is_written_as_the_specification_asks(written):
    assert faults_of_glb(written) == []
