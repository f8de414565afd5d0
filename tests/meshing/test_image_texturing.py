"""Textures from images: one image per triangle or a mean, occlusion, seams, files, and rejected input."""

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.images.image_files import write_png
from pointloom.meshing.color_map import image_texturing
from pointloom.meshing.color_map.results import NothingSeenError

from ..hostile import faults_of
from .color_scenes import WALL, make_scene, paint
from .image_scenes import CAMERA, sampled, steps_of, wall_colors, wall_mesh, wall_scene

TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def assert_valid_glb(path: Path) -> None:
    data = path.read_bytes()
    assert struct.unpack("<4sII", data[:12]) == (b"glTF", 2, len(data))
    chunks, at = [], 12
    while at + 8 <= len(data):
        size, kind = struct.unpack("<I4s", data[at : at + 8])
        assert size % 4 == 0 and at + 8 + size <= len(data)
        chunks.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    assert [kind for kind, _ in chunks] == [b"JSON", b"BIN\0"]
    doc, binary = json.loads(chunks[0][1]), chunks[1][1]
    views, accessors = doc["bufferViews"], doc["accessors"]
    assert doc["asset"]["version"] == "2.0" and 0 <= len(binary) - doc["buffers"][0]["byteLength"] < 4
    for view in views:
        room = doc["buffers"][view["buffer"]]["byteLength"] - view.get("byteOffset", 0)
        assert 0 < view["byteLength"] <= room
    arrays = [values_of(accessor, views[accessor["bufferView"]], binary) for accessor in accessors]
    for part in (part for mesh in doc["meshes"] for part in mesh["primitives"]):
        positions = accessors[part["attributes"]["POSITION"]]
        assert {"min", "max"} <= set(positions)
        for accessor in (accessors[k] for k in part["attributes"].values()):
            assert accessor["count"] == positions["count"]
            assert accessor["componentType"] == 5126 or accessor.get("normalized")
            assert views[accessor["bufferView"]].get("target", 34962) == 34962
        if "indices" in part:
            indices = arrays[part["indices"]]
            assert indices.max() < positions["count"] and len(indices) % 3 == 0
            assert indices.max() < 2 ** (8 * indices.dtype.itemsize) - 1  # the value for a primitive restart


def values_of(accessor: dict[str, Any], view: dict[str, Any], binary: bytes) -> Any:
    """The elements of an accessor: aligned, within their view, finite, and with the given minimum and maximum."""
    dtype, width, count = np.dtype(TYPES[accessor["componentType"]]), WIDTHS[accessor["type"]], accessor["count"]
    offset, begin = accessor.get("byteOffset", 0), view.get("byteOffset", 0)
    stride = view.get("byteStride", dtype.itemsize * width)
    assert offset % dtype.itemsize == (begin + offset) % dtype.itemsize == stride % dtype.itemsize == 0
    assert count > 0 and (stride % 4 == 0 or "byteStride" not in view)
    assert offset + stride * (count - 1) + dtype.itemsize * width <= view["byteLength"]
    values = np.array([np.frombuffer(binary, dtype, width, begin + offset + stride * i) for i in range(count)])
    assert np.isfinite(values.astype(np.float64)).all()
    for name, extreme in (("min", values.min(0)), ("max", values.max(0))):
        assert name not in accessor or np.array_equal(np.array(accessor[name], dtype), extreme)
    return values


texture = loom.meshing.texture_from_images
GAINS = (0.8, 1.2, 0.95)
Option = loom.meshing.ImageTextureOption
NO_LEVELING = Option(exposures=False, seam_leveling=False, local_leveling=False)
MIDDLE = np.full(3, 1 / 3)


def errors_of(result):
    """The error in the middle of each visible triangle, after one gain."""
    rows = np.flatnonzero(result.views >= 0)
    centers = np.asarray(result.mesh.vertices)[np.asarray(result.mesh.triangles)[rows]].mean(1)
    truth = 255 * wall_colors(centers[:, 0], centers[:, 1])
    colors = np.array([sampled(result.mesh, row, MIDDLE) for row in rows])
    return np.abs(colors * (colors * truth).sum() / (colors**2).sum() - truth)


def test_a_triangle_has_the_colors_of_its_position(device):
    scene = wall_scene(device=device)
    result = texture(scene.mesh, scene.images, CAMERA, scene.extrinsics)
    assert result.seen_fraction > 0.3 and result.used_count >= 2 and result.chart_count >= 2 and result.reliable
    assert errors_of(result).max() < 2.5  # half a level of rounding, twice, and bilinear smoothing
    assert result.mesh.vertex_colors is None and result.mesh.textures[0].shape == (result.size, result.size, 3)
    assert f"{result.chart_count}" in str(result) and result.to_dict()["seen"] == result.seen_count


@pytest.mark.parametrize(
    ("options", "mean", "maximum"),
    [({"exposures": False, "seam_leveling": False}, 0.5, 1.5), ({"exposures": False}, 0.5, 1.5), ({}, 0.5, 1.5),
     ({"seam_leveling": False, "local_leveling": False}, 1.0, 3.0)],
)  # fmt: skip
def test_each_leveling_takes_seams_away(device, options, mean, maximum):
    scene = wall_scene(GAINS, device)
    given = (scene.mesh, scene.images, CAMERA, scene.extrinsics)
    plain = texture(*given, NO_LEVELING)
    before = steps_of(plain.mesh, plain.views)
    assert before.mean() > 15 and abs(plain.step - plain.step_before) < 0.1 * plain.step_before
    result = texture(*given, Option(**options))
    steps = steps_of(result.mesh, result.views)
    assert len(steps) == len(before) and steps.mean() < mean and steps.max() < maximum


def test_seam_statistics_describe_the_finished_texture(device):
    scene = wall_scene(GAINS, device)
    tinted = [np.clip(image * (1.0, 1.0, 1.0 + 0.2 * k), 0, 255) for k, image in enumerate(scene.images)]
    images = [image.astype(np.uint8) for image in tinted]
    for option in (NO_LEVELING, None):
        result = texture(scene.mesh, images, CAMERA, scene.extrinsics, option)
        steps = steps_of(result.mesh, result.views)
        assert abs(result.step - steps.mean()) < 0.05 * steps.mean() + 0.05
        assert result.step_95 > result.step and result.to_dict()["step_95"] == result.step_95
    assert result.step < 0.5 and result.step_95 < 1.0 and "95% below" in str(result)


def test_exposure_correction_restores_the_surface_colors(device):
    scene = wall_scene(GAINS, device)
    result = texture(scene.mesh, scene.images, CAMERA, scene.extrinsics)
    without = texture(scene.mesh, scene.images, CAMERA, scene.extrinsics, Option(exposures=False))
    assert errors_of(result).mean() < 0.5 * errors_of(without).mean()


def test_an_image_with_other_content_is_excluded(device):
    scene = wall_scene((1.0,) * 5, device)
    poses = [scene.extrinsics[2]] * 5
    images = [scene.images[2]] * 4 + [scene.images[2].copy()]
    images[4][:, :, :] = (255, 0, 0)
    images[4][np.arange(72) % 8 < 4] = (120, 0, 0)  # with larger gradients than the others
    result = texture(scene.mesh, images, CAMERA, poses, Option(exposures=False))
    assert 4 not in result.views and result.outlier_count == result.pair_count // 5
    unfiltered = texture(scene.mesh, images, CAMERA, poses, Option(exposures=False, outliers=False))
    assert (unfiltered.views[unfiltered.views >= 0] == 4).all() and unfiltered.outlier_count == 0


def test_occluded_images_are_not_used(device):
    wall, board = wall_mesh(device=device), wall_mesh(3, device=device)
    before = loom.TriangleMesh(0.25 * np.asarray(board.vertices) - (0, 0, 0.3), board.triangles, device=device)
    scene = wall_scene((1.0,), device)
    result = texture(wall + before, scene.images, CAMERA, scene.extrinsics)
    seen = result.views >= 0
    centers = np.asarray(wall.vertices)[wall.triangles].mean(1)
    behind = (np.abs(centers[:, :2]) < 0.2).all(1)
    assert not seen[: len(wall)][behind].any() and seen[len(wall) :].all()


def test_back_facing_triangles_are_not_visible(device):
    scene = wall_scene((1.0,), device)
    flipped = loom.TriangleMesh(scene.mesh.vertices, np.asarray(scene.mesh.triangles)[:, ::-1], device=device)
    with pytest.raises(NothingSeenError, match=r"^images:"):
        texture(flipped, scene.images, CAMERA, scene.extrinsics)


def test_triangles_without_an_image_take_vertex_colors_or_are_plain(device):
    scene = wall_scene((1.0,), device)
    colored = scene.mesh.with_arrays()
    colored.vertex_colors = np.tile((0.2, 0.6, 0.4), (len(np.asarray(scene.mesh.vertices)), 1))
    for mesh, color, drew in ((colored, (51, 153, 102), True), (scene.mesh, (255, 0, 255), False)):
        result = texture(mesh, scene.images, CAMERA, scene.extrinsics, Option(plain=(1, 0, 1)))
        blind = np.flatnonzero(result.views < 0)
        assert len(blind) and result.drew_colors is drew
        assert all(np.abs(sampled(result.mesh, row, MIDDLE) - color).max() <= 1 for row in blind)


def test_a_small_texture_contains_all_charts_at_a_smaller_scale():
    scene = wall_scene()
    given = (scene.mesh, scene.images, CAMERA, scene.extrinsics)
    result, small = texture(*given), texture(*given, size=64)
    assert result.scale == 1.0 and small.scale < 0.6 and small.mesh.textures[0].shape == (64, 64, 3)
    assert errors_of(small).mean() < 2
    with pytest.raises(ValueError, match="size:"):
        texture(*given, Option(smoothness=0.0), size=16)


def test_an_interrupted_texture_continues_to_the_same_result(device, tmp_path, monkeypatch):
    scene = wall_scene((0.8, 1.1, 1.0))
    given = scene.mesh.to(device), scene.images, CAMERA, scene.extrinsics
    expected = texture(*given, size=128)
    work, choices = tmp_path / "work", []
    choose, level = image_texturing._choose_views, image_texturing.SeamLevels

    def counted(*arguments):
        choices.append(arguments)
        return choose(*arguments)

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(image_texturing, "_choose_views", counted)
    monkeypatch.setattr(image_texturing, "SeamLevels", interrupted)
    with pytest.raises(KeyboardInterrupt):
        texture(*given, size=128, work=work)
    monkeypatch.setattr(image_texturing, "SeamLevels", level)
    result = texture(*given, size=128, work=work)
    assert len(choices) == 1
    np.testing.assert_array_equal(result.views, expected.views)
    np.testing.assert_array_equal(result.mesh.textures[0], expected.mesh.textures[0])
    assert result.to_dict() == expected.to_dict()
    darker = [np.asarray(image) // 2 for image in scene.images]
    for other in ((given[0], darker, *given[2:]), (*given, Option(smoothness=0.5))):
        texture(*other, size=128, work=work)
    assert len(choices) == 3  # other images or options start again


def test_an_sfm_model_provides_cameras_and_files(tmp_path):
    scene = wall_scene(GAINS)
    names = [f"{k}.png" for k in range(3)]
    for name, image in zip(names, scene.images, strict=True):
        write_png(tmp_path / name, image)
    lens = loom.CameraModel.from_intrinsic(CAMERA)
    model = loom.SfmModel(names, [lens] * 3, np.array(scene.extrinsics))
    expected = texture(scene.mesh, scene.images, CAMERA, scene.extrinsics)
    for images in (tmp_path, [tmp_path / name for name in names], scene.images):
        result = texture(scene.mesh, images, model)
        assert np.array_equal(result.mesh.textures[0], expected.mesh.textures[0])
    posed = [loom.photogrammetry.PosedCamera(CAMERA, T) for T in scene.extrinsics]
    assert np.array_equal(texture(scene.mesh, scene.images, posed).views, expected.views)
    (tmp_path / "1.png").unlink()
    with pytest.raises(loom.FileError, match=r"/1\.png:.*3"):
        texture(scene.mesh, tmp_path, model)


@pytest.mark.parametrize("ending", [".obj", ".glb"])
def test_files_contain_the_texture_for_other_programs(tmp_path, ending):
    trimesh = pytest.importorskip("trimesh")
    scene = wall_scene(GAINS)
    result = texture(scene.mesh, scene.images, CAMERA, scene.extrinsics)
    loom.write_triangle_mesh(tmp_path / f"wall{ending}", result.mesh)
    read = trimesh.load(tmp_path / f"wall{ending}", force="mesh", process=False)
    assert len(read.faces) == len(scene.mesh)
    material = read.visual.material
    image = material.image if ending == ".obj" else material.baseColorTexture
    assert np.array_equal(np.asarray(image.convert("RGB")), result.mesh.textures[0])
    if ending == ".glb":
        assert_valid_glb(tmp_path / "wall.glb")


def test_surfaces_beyond_depth_max_are_not_visible():
    scene = wall_scene()
    with pytest.raises(NothingSeenError):
        texture(scene.mesh, scene.images, CAMERA, scene.extrinsics, Option(depth_max=0.5))


ARGUMENTS = {"option": Option(), "size": 256, "work": None, "progress": None}
FIELDS = {"smoothness": 1.0, "depth_max": 4.0, "plain": (0.5, 0.5, 0.5)}


@pytest.mark.parametrize("field", FIELDS)
def test_a_hostile_value_of_an_option_is_rejected_by_name(field):
    faults = faults_of(Option, FIELDS, field)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("argument", ["mesh", "images", "cameras", "extrinsics", *ARGUMENTS])
def test_a_hostile_value_is_rejected_by_name(argument):
    scene = wall_scene()
    given = {"mesh": wall_mesh(5), "images": scene.images, "cameras": CAMERA, "extrinsics": scene.extrinsics}
    faults = faults_of(texture, {**given, **ARGUMENTS}, argument)
    assert not faults, "\n".join(faults)


ROWS = 25


def with_uvs(mesh, rows=ROWS):
    """The wall in the lower left quarter of the texture, the ball in the lower right quarter."""
    triangles, vertices = mesh.triangles, mesh.vertices
    half = len(triangles) // 2
    uvs = np.zeros((len(triangles), 3, 2))
    uvs[:half] = (vertices[triangles[:half]][..., :2] + 1) / 2 * 0.48 + 0.01
    index = triangles[half:] - rows * rows
    uvs[half:, :, 0] = index % rows / (rows - 1) * 0.48 + 0.51
    uvs[half:, :, 1] = index // rows / (rows - 1) * 0.48 + 0.01
    mesh = mesh.copy()
    mesh.triangle_uvs = uvs.reshape(-1, 2)
    return mesh


def bake(scene, size=128, mesh=None, images=None):
    mesh = with_uvs(scene.mesh) if mesh is None else mesh
    images = [frame.color for frame in scene.frames] if images is None else images
    extrinsics = [np.linalg.inv(pose) for pose in scene.poses]
    return mesh.project_images_to_albedo(images, scene.camera, extrinsics, size)


def wall_texels(size):
    """Wall positions [m] of the texels of the lower left quarter, and their rows and columns."""
    row, column = np.mgrid[:size, :size]
    u, v = (column + 0.5) / size, 1 - (row + 0.5) / size
    inside = (u > 0.02) & (u < 0.48) & (v > 0.02) & (v < 0.48)
    x, y = ((t[inside] - 0.01) / 0.48 * 2 - 1 for t in (u, v))
    return np.stack([x, y, np.full_like(x, WALL)], -1), row[inside], column[inside]


def test_texels_have_the_color_of_their_position(device):
    scene = make_scene(device, rows=ROWS)
    texture = bake(scene).textures[0]
    positions, row, column = wall_texels(128)
    result = texture[row, column] / 255
    seen = result.max(axis=1) > 0
    errors = np.abs(result - paint(positions))[seen].max(axis=1)
    assert seen.mean() > 0.5
    # bilinear between pixels of 10 mm, two roundings to bytes
    assert np.median(errors) < 0.01 and errors.max() < 0.1


def test_foreground_and_background_do_not_mix_colors(device):
    """A red ball in front of a wall of another color: no red on the wall, no wall color on the ball."""
    scene = make_scene(device, rows=ROWS)
    plain = []
    for frame, pose in zip(scene.frames, scene.poses, strict=True):
        v, u = np.mgrid[: scene.camera.height, : scene.camera.width]
        x, y = (u - scene.camera.cx) / scene.camera.fx, (v - scene.camera.cy) / scene.camera.fy
        z = (np.stack([x, y, np.ones_like(x)], -1) @ pose[:3, :3].T * frame.depth[..., None] + pose[:3, 3])[..., 2]
        plain.append(np.where((z > WALL - 1e-3)[..., None], (0, 120, 250), (250, 0, 0)).astype(np.uint8))
    texture = bake(scene, images=plain).textures[0]
    wall = texture[70:122, 6:58].reshape(-1, 3)
    ball = texture[70:122, 70:122].reshape(-1, 3)
    assert set(map(tuple, wall.tolist())) == {(0, 120, 250), (0, 0, 0)}
    assert set(map(tuple, ball.tolist())) == {(250, 0, 0), (0, 0, 0)}


def test_back_facing_triangles_are_not_painted(device):
    camera = loom.PinholeCameraIntrinsic(64, 48, 30.0, 30.0, 31.5, 23.5)
    corners, uvs = [[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 0], [1, 0], [0, 1]]
    white = np.full((48, 64, 3), 255, np.uint8)
    sums = []
    for triangle in ([0, 1, 2], [0, 2, 1]):
        mesh = loom.TriangleMesh(corners, [triangle], device=device)
        mesh.triangle_uvs = [uvs[k] for k in triangle]
        sums.append(int(mesh.project_images_to_albedo([white], camera, [np.eye(4)], 16).textures[0].sum()))
    assert sums[0] == 0 and sums[1] > 0


def test_the_nearer_image_has_more_weight(device):
    camera = loom.PinholeCameraIntrinsic(64, 48, 150.0, 150.0, 31.5, 23.5)
    mesh = loom.TriangleMesh([[-0.3, -0.3, 2], [0.3, -0.3, 2], [-0.3, 0.3, 2]], [[0, 2, 1]], device=device)
    mesh.triangle_uvs = [[0, 0], [0, 1], [1, 0]]
    red, blue = (np.full((48, 64, 3), c, np.uint8) for c in ((240, 0, 0), (0, 0, 240)))
    back = np.eye(4)
    back[2, 3] = 2.0  # twice as far: a sixteenth of the weight
    texture = mesh.project_images_to_albedo([red, blue], [camera, camera.matrix], [np.eye(4), back], 32).textures[0]
    ratio = texture[20, 9].astype(float)
    # the viewing angle decreases as well: cos^4 / z^4
    x, y = -0.3 + 0.6 * (9.5 / 32), -0.3 + 0.6 * (1 - 20.5 / 32)
    weights = [(z / np.sqrt(x * x + y * y + z * z) / z) ** 4 for z in (2.0, 4.0)]
    assert np.abs(ratio[[0, 2]] - 240 * np.array(weights) / sum(weights)).max() <= 1


def test_texels_beside_a_triangle_repeat_it(device):
    mesh = loom.TriangleMesh([[-1, -1, 2], [1, -1, 2], [-1, 1, 2]], [[0, 2, 1]], device=device)
    mesh.vertex_colors = np.tile([0, 99 / 255, 0], (3, 1))  # where the image ends
    mesh.triangle_uvs = [[0.5, 0.5], [0.5, 0.75], [0.75, 0.5]]
    camera = loom.PinholeCameraIntrinsic(64, 48, 20.0, 20.0, 31.5, 23.5)
    green = np.full((48, 64, 3), (0, 99, 0), np.uint8)
    texture = mesh.project_images_to_albedo([green], camera, [np.eye(4)], 64).textures[0]
    assert texture[31 + 8, 36].tolist() == [0, 99, 0] and texture[31 + 9, 36].tolist() == [0, 0, 0]
    assert set(map(tuple, texture.reshape(-1, 3).tolist())) == {(0, 99, 0), (0, 0, 0)}


def test_unseen_texels_take_the_vertex_colors(device):
    scene = make_scene(device, rows=ROWS)
    mesh = with_uvs(scene.mesh)
    mesh.vertex_colors = paint(mesh.vertices)
    texture = bake(scene, mesh=mesh).textures[0]
    positions, row, column = wall_texels(128)
    # linear across triangles of 8 cm
    assert np.median(np.abs(texture[row, column] / 255 - paint(positions)).max(axis=1)) < 0.02
    assert texture[row, column].max(axis=1).min() > 0


def test_scale_and_position_do_not_matter(device):
    scene = make_scene(device, rows=ROWS, width=80, height=60)
    expected = bake(scene, 64).textures[0].astype(int)
    for scale, shift in ((1e-6, 0), (1e6, 0), (1.0, (5e5, 5.4e6, 120))):
        mesh = loom.TriangleMesh(scene.mesh.vertices * scale + shift, scene.mesh.triangles, device=device)
        poses = scene.poses.copy()
        poses[:, :3, 3] = poses[:, :3, 3] * scale + shift
        moved = make_scene(device, rows=ROWS, width=80, height=60)
        moved.mesh, moved.poses = mesh, poses
        mesh.triangle_uvs = with_uvs(scene.mesh).triangle_uvs
        result = bake(moved, 64, mesh=mesh).textures[0].astype(int)
        # a texel beside an edge may belong to either side
        assert (np.abs(result - expected).max(axis=-1) > 2).mean() < 0.01


def test_bad_input_is_named():
    scene = make_scene(rows=ROWS, width=32, height=24)
    mesh, camera = with_uvs(scene.mesh), scene.camera
    images, poses = [frame.color for frame in scene.frames], list(scene.poses)
    flat, nan = loom.TriangleMesh([[0, 0, 0]]), [np.full((4, 4), np.nan), *poses[1:]]
    wrong = [*images[:2], np.zeros((2, 2, 3), np.uint8), *images[3:]]
    for one, given, named in (
        (scene.mesh, (images, camera, poses), "expected triangle_uvs"),
        (flat, (images, camera, poses), "expected triangles"),
        (mesh, (images, camera, poses[:4]), "expected 5, one per image, got 4"),
        (mesh, (images, [camera], poses), "expected 5, one per image, got 1"),
        (mesh, (wrong, camera, poses), r"images\[2\]"),
        (mesh, (images, camera, poses, 0), "tex_size"),
        (mesh, (images, camera, nan), r"extrinsic_matrices\[0\]"),
    ):
        with pytest.raises(ValueError, match=named):
            one.project_images_to_albedo(*given)
    outside = mesh.copy()
    outside.triangle_uvs = np.asarray(mesh.triangle_uvs) + 5
    with pytest.raises(ValueError, match=r"^mesh:"):
        outside.project_images_to_albedo(images, camera, poses)
    broken = np.array(mesh.triangle_uvs)
    broken[:30] = np.nan
    mesh.triangle_uvs = broken
    assert mesh.project_images_to_albedo(images, camera, poses, 16).textures[0].shape == (16, 16, 3)
