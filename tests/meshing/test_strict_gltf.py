"""A textured .glb holds what the specification asks, by a strict reader of its own; and that reader sees damage."""

import json
import struct

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


def beyond(doc):
    doc["accessors"][0]["count"] += 1


def unaligned(doc):
    doc["accessors"][0]["byteOffset"] = 2


def unlike(doc):
    next(a for a in doc["accessors"] if "max" in a)["max"][0] += 1.0


def nowhere(doc):
    doc["textures"][0]["source"] = 7


@pytest.mark.parametrize(
    ("damage", "said"),
    [(beyond, "beyond its view"), (unaligned, "alignment"), (unlike, ".max"), (nowhere, "texture.source")],
)
def test_the_strict_reader_sees_damage(written, tmp_path, damage, said):
    data = written.read_bytes()
    size = struct.unpack("<I", data[12:16])[0]
    doc = json.loads(data[20 : 20 + size])
    damage(doc)
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size :]
    head = struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON")
    (tmp_path / "hurt.glb").write_bytes(head + text + rest)
    assert any(said in fault for fault in faults_of_glb(tmp_path / "hurt.glb"))
