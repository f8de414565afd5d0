"""texture: outputs, figures, and unreliable results."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.wording import json_text
from pointloom.datasets.scenes.room import write_room_sequence
from pointloom.io.frames.datasets import open_dataset
from pointloom.io.pictures.image_files import read_color, write_png

from .commands import answer, names_in, refusal, run, unreliable


@pytest.fixture(scope="module")
def scan(tmp_path_factory):
    """Frames of the room and their mesh without colors."""
    folder = tmp_path_factory.mktemp("texture")
    write_room_sequence(folder / "room", frame_count=12, width=160, height=120)
    fused = loom.fuse(open_dataset(folder / "room"), voxel_size=0.06).mesh
    bare = loom.TriangleMesh(fused.vertices, fused.triangles)
    loom.write_triangle_mesh(folder / "bare.ply", bare)
    uvs = np.zeros((len(bare), 3, 2))
    side = int(np.ceil(np.sqrt(len(bare))))  # a trivial atlas: a small square for each triangle
    row, column = np.divmod(np.arange(len(bare)), side)
    for k, (x, y) in enumerate(((0.1, 0.1), (0.9, 0.1), (0.1, 0.9))):
        uvs[:, k] = np.stack([column + x, row + y], 1) / side
    bare.triangle_uvs = uvs.reshape(-1, 2)
    bare.textures = [np.zeros((4, 4, 3), np.uint8)]
    loom.write_triangle_mesh(folder / "mapped.obj", bare)
    return folder


@pytest.mark.slow
def test_vertices_take_the_colors_of_the_frames(scan, tmp_path):
    report = answer("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--device", "cpu")
    assert report["command"] == "texture" and report["method"] == "rigid" and report["frames"] == 12
    assert report["seen_share"] > 0.5 and report["residual"] < report["residual_before"]
    assert report["size"] is None and report["reliable"]
    mesh = loom.read_triangle_mesh(tmp_path / "out.ply")
    assert len(mesh) == report["triangles"] and np.ptp(mesh.vertex_colors) > 0.5
    bare, frames = loom.read_triangle_mesh(scan / "bare.ply", device="cpu"), loom.open_dataset(scan / "room")
    result = loom.color_map.texture_mesh(bare, frames)  # the same call in Python
    loom.write_triangle_mesh(tmp_path / "called.ply", result.mesh)
    assert (tmp_path / "called.ply").read_bytes() == (tmp_path / "out.ply").read_bytes()
    figures = json.loads(json_text(result.to_dict()))
    assert figures == {key: report[key] for key in figures}


@pytest.mark.slow
def test_a_texture_is_filled_if_the_mesh_has_texture_coordinates(scan, tmp_path):
    words = ["texture", scan / "mapped.obj", scan / "room", "-o", tmp_path / "out.glb", "--size", "256"]
    report = answer(*words, "--method", "non-rigid", "--every", "2", "--device", "cpu")
    assert report["size"] == 256 and report["texel_share"] > 0.3
    mesh = loom.read_triangle_mesh(tmp_path / "out.glb")
    assert mesh.textures[0].shape == (256, 256, 3) and mesh.textures[0].std() > 10 and mesh.vertex_colors is None


def test_poses_are_unchanged_without_a_method(scan, tmp_path):
    words = ["texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--method", "none"]
    report = answer(*words, "--every", "2", "--picture", tmp_path / "out.png")
    assert report["turned"] == pytest.approx(0, abs=1e-5) and report["moved"] < 1e-12 and report["frames"] == 6
    assert report["residual"] == report["residual_before"] and read_color(tmp_path / "out.png").shape == (960, 1280, 3)
    assert names_in(tmp_path) == ["out.ply", "out.png"]


def test_the_summary_matches_the_library(scan, tmp_path):
    result = run("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--every", "2")
    assert result.exit_code == 0, result.stderr
    for word in ("of the vertices", "residual", "moved", "out.ply"):
        assert word in result.stdout
    bare, frames = loom.read_triangle_mesh(scan / "bare.ply"), loom.open_dataset(scan / "room", every=2)
    assert "\n".join(result.stdout.splitlines()[1:-3]) == str(loom.color_map.texture_mesh(bare, frames))


def test_frames_that_do_not_show_the_mesh_or_little_of_it_are_unreliable(scan, tmp_path):
    mesh = loom.read_triangle_mesh(scan / "bare.ply")
    loom.write_triangle_mesh(tmp_path / "far.ply", loom.TriangleMesh(mesh.vertices + 100.0, mesh.triangles))
    report = unreliable("texture", tmp_path / "far.ply", scan / "room", "-o", tmp_path / "out.ply")
    assert "no frame shows the mesh" in str(report["warnings"]) and report["files"] == []
    assert names_in(tmp_path) == ["far.ply"]
    words = ["texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.ply", "--every", "12"]
    report = unreliable(*words, "--depth-max", "2")
    assert "only" in str(report["warnings"]) and "of the vertices" in str(report["warnings"])
    assert (tmp_path / "out.ply").exists()


def test_invalid_input_is_an_error_that_names_it(scan, tmp_path):
    out = tmp_path / "out.ply"
    assert "not written to .stl" in refusal("texture", scan / "bare.ply", scan / "room", "-o", tmp_path / "out.stl")
    assert "no.ply" in refusal("texture", tmp_path / "no.ply", scan / "room", "-o", out)
    vertices = loom.read_triangle_mesh(scan / "bare.ply").vertices
    loom.write_triangle_mesh(tmp_path / "points.off", loom.TriangleMesh(vertices))
    assert "contains no faces" in refusal("texture", tmp_path / "points.off", scan / "room", "-o", out)
    out.write_bytes(b"old")
    assert "exists" in refusal("texture", scan / "bare.ply", scan / "room", "-o", out) and out.read_bytes() == b"old"
    write_room_sequence(tmp_path / "gray", frame_count=2, width=64, height=48)
    for path in (tmp_path / "gray").glob("*.color.png"):
        path.unlink()
    assert "frames without" in refusal("texture", scan / "bare.ply", tmp_path / "gray", "-o", tmp_path / "a.ply")


def test_images_of_a_model_give_a_texture(tmp_path):
    from ..meshing.picture_scenes import CAMERA, wall_scene

    scene = wall_scene((0.8, 1.1, 1.0))
    loom.write_triangle_mesh(tmp_path / "wall.ply", scene.mesh)
    names = [f"{k}.png" for k in range(3)]
    model = loom.SfmModel(names, [loom.CameraModel.from_intrinsic(CAMERA)] * 3, np.array(scene.extrinsics))
    for sparse, images in (("project/sparse/0", "project/images"), ("work/mesh/sparse", "work/undistorted/images")):
        (tmp_path / images).mkdir(parents=True)
        (tmp_path / sparse).parent.mkdir(parents=True, exist_ok=True)
        for name, picture in zip(names, scene.pictures, strict=True):
            write_png(tmp_path / images / name, picture)
        loom.write_colmap_model(tmp_path / sparse, model)
    words = ["texture", tmp_path / "wall.ply"]
    report = answer(*words, tmp_path / "project", "-o", tmp_path / "a.glb", "--size", "256", "--device", "cpu")
    assert report["layout"] == "model" and report["pictures"] == 3 and report["size"] == 256
    assert report["reliable"] and report["seen"] > 0.3 * report["triangles"]
    assert answer(*words, tmp_path / "work", "-o", tmp_path / "b.glb", "--size", "256", "--device", "cpu")["files"]
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    assert loom.read_triangle_mesh(tmp_path / "a.glb").textures[0].shape == (256, 256, 3)
    refused = run(*words, tmp_path / "project", "-o", tmp_path / "c.glb", "--method", "rigid")
    assert refused.exit_code == 2 and "--method is for RGB-D frames" in refused.stderr
