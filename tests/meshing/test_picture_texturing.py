"""texture_from_pictures: one image per triangle, charts that agree at seams, and rejected input."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.pictures.image_files import write_png
from pointloom.meshing.color_map.results import NothingSeenError

from ..hostile import faults_of
from .picture_scenes import CAMERA, sampled, steps_of, wall_colors, wall_mesh, wall_scene
from .strict_gltf import faults_of_glb

texture = loom.color_map.texture_from_pictures
GAINS = (0.8, 1.2, 0.95)
NO_LEVELLING = {"exposures": False, "seam_leveling": False, "local_leveling": False}
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
    result = texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    assert result.seen_share > 0.3 and result.used_count >= 2 and result.chart_count >= 2 and result.reliable
    assert errors_of(result).max() < 2.5  # half a level of rounding, twice, and bilinear smoothing
    assert result.mesh.vertex_colors is None and result.mesh.textures[0].shape == (result.size, result.size, 3)
    assert f"{result.chart_count}" in str(result) and result.to_dict()["seen"] == result.seen_count


@pytest.mark.parametrize(
    ("options", "mean", "maximum"),
    [
        ({"exposures": False, "seam_leveling": False}, 0.5, 1.5),
        ({"exposures": False}, 0.5, 1.5),
        ({"seam_leveling": False, "local_leveling": False}, 1.0, 3.0),
        ({}, 0.5, 1.5),
    ],
)
def test_each_leveling_takes_seams_away(device, options, mean, maximum):
    scene = wall_scene(GAINS, device)
    given = (scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    plain = texture(*given, **NO_LEVELLING)
    before = steps_of(plain.mesh, plain.views)
    assert before.mean() > 15 and abs(plain.step - plain.step_before) < 0.1 * plain.step_before
    result = texture(*given, **options)
    steps = steps_of(result.mesh, result.views)
    assert len(steps) == len(before) and steps.mean() < mean and steps.max() < maximum


def test_seam_statistics_describe_the_finished_texture(device):
    scene = wall_scene(GAINS, device)
    tinted = [np.clip(picture * (1.0, 1.0, 1.0 + 0.2 * k), 0, 255) for k, picture in enumerate(scene.pictures)]
    pictures = [picture.astype(np.uint8) for picture in tinted]
    for options in (NO_LEVELLING, {}):
        result = texture(scene.mesh, pictures, CAMERA, scene.extrinsics, **options)
        steps = steps_of(result.mesh, result.views)
        assert abs(result.step - steps.mean()) < 0.05 * steps.mean() + 0.05
        assert result.step_95 > result.step and result.to_dict()["step_95"] == result.step_95
    assert result.step < 0.5 and result.step_95 < 1.0 and "95% below" in str(result)


def test_exposure_correction_restores_the_surface_colors(device):
    scene = wall_scene(GAINS, device)
    result = texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    without = texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics, exposures=False)
    assert errors_of(result).mean() < 0.5 * errors_of(without).mean()


def test_an_image_with_other_content_is_excluded(device):
    scene = wall_scene((1.0,) * 5, device)
    poses = [scene.extrinsics[2]] * 5
    pictures = [scene.pictures[2]] * 4 + [scene.pictures[2].copy()]
    pictures[4][:, :, :] = (255, 0, 0)
    pictures[4][np.arange(72) % 8 < 4] = (120, 0, 0)  # with larger gradients than the others
    result = texture(scene.mesh, pictures, CAMERA, poses, exposures=False)
    assert 4 not in result.views and result.outlier_count == result.pair_count // 5
    unfiltered = texture(scene.mesh, pictures, CAMERA, poses, exposures=False, outliers=False)
    assert (unfiltered.views[unfiltered.views >= 0] == 4).all() and unfiltered.outlier_count == 0


def test_occluded_images_are_not_used(device):
    wall, board = wall_mesh(device=device), wall_mesh(3, device=device)
    before = loom.TriangleMesh(0.25 * np.asarray(board.vertices) - (0, 0, 0.3), board.triangles, device=device)
    scene = wall_scene((1.0,), device)
    result = texture(wall + before, scene.pictures, CAMERA, scene.extrinsics)
    seen = result.views >= 0
    centers = np.asarray(wall.vertices)[wall.triangles].mean(1)
    behind = (np.abs(centers[:, :2]) < 0.2).all(1)
    assert not seen[: len(wall)][behind].any() and seen[len(wall) :].all()


def test_back_facing_triangles_are_not_visible(device):
    scene = wall_scene((1.0,), device)
    flipped = loom.TriangleMesh(scene.mesh.vertices, np.asarray(scene.mesh.triangles)[:, ::-1], device=device)
    with pytest.raises(NothingSeenError, match=r"^pictures:"):
        texture(flipped, scene.pictures, CAMERA, scene.extrinsics)


def test_triangles_without_an_image_take_vertex_colors_or_are_plain(device):
    scene = wall_scene((1.0,), device)
    colored = scene.mesh._with_arrays()
    colored.vertex_colors = np.tile((0.2, 0.6, 0.4), (len(np.asarray(scene.mesh.vertices)), 1))
    for mesh, color, drew in ((colored, (51, 153, 102), True), (scene.mesh, (255, 0, 255), False)):
        result = texture(mesh, scene.pictures, CAMERA, scene.extrinsics, plain=(1, 0, 1))
        blind = np.flatnonzero(result.views < 0)
        assert len(blind) and result.drew_colors is drew
        assert all(np.abs(sampled(result.mesh, row, MIDDLE) - color).max() <= 1 for row in blind)


def test_a_small_texture_contains_all_charts_at_a_smaller_scale():
    scene = wall_scene()
    given = (scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    result, small = texture(*given), texture(*given, size=64)
    assert result.scale == 1.0 and small.scale < 0.6 and small.mesh.textures[0].shape == (64, 64, 3)
    assert errors_of(small).mean() < 2
    with pytest.raises(ValueError, match="size:"):
        texture(*given, size=16, smoothness=0.0)


def test_an_sfm_model_provides_cameras_and_files(tmp_path):
    scene = wall_scene(GAINS)
    names = [f"{k}.png" for k in range(3)]
    for name, picture in zip(names, scene.pictures, strict=True):
        write_png(tmp_path / name, picture)
    lens = loom.CameraModel.from_intrinsic(CAMERA)
    model = loom.SfmModel(names, [lens] * 3, np.array(scene.extrinsics))
    expected = texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    for pictures in (tmp_path, [tmp_path / name for name in names], scene.pictures):
        result = texture(scene.mesh, pictures, model)
        assert np.array_equal(result.mesh.textures[0], expected.mesh.textures[0])
    posed = [loom.mvs.PosedCamera(CAMERA, T) for T in scene.extrinsics]
    assert np.array_equal(texture(scene.mesh, scene.pictures, posed).views, expected.views)
    (tmp_path / "1.png").unlink()
    with pytest.raises(loom.FileError, match=r"/1\.png:.*3"):
        texture(scene.mesh, tmp_path, model)


@pytest.mark.parametrize("ending", [".obj", ".glb"])
def test_files_contain_the_texture_for_other_programs(tmp_path, ending):
    trimesh = pytest.importorskip("trimesh")
    scene = wall_scene(GAINS)
    result = texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics)
    loom.write_triangle_mesh(tmp_path / f"wall{ending}", result.mesh)
    read = trimesh.load(tmp_path / f"wall{ending}", force="mesh", process=False)
    assert len(read.faces) == len(scene.mesh)
    material = read.visual.material
    picture = material.image if ending == ".obj" else material.baseColorTexture
    assert np.array_equal(np.asarray(picture.convert("RGB")), result.mesh.textures[0])
    assert ending == ".obj" or faults_of_glb(tmp_path / "wall.glb") == []


def test_surfaces_beyond_depth_max_are_not_visible():
    scene = wall_scene()
    with pytest.raises(NothingSeenError):
        texture(scene.mesh, scene.pictures, CAMERA, scene.extrinsics, depth_max=0.5)


ARGUMENTS = {"size": 256, "smoothness": 1.0, "depth_max": 4.0, "plain": (0.5, 0.5, 0.5)}
FLAGS = {"outliers": True, "exposures": True, "seam_leveling": True, "local_leveling": True, "progress": None}


SLOW = [pytest.param(flag, marks=pytest.mark.slow) for flag in FLAGS]


@pytest.mark.parametrize("argument", ["mesh", "pictures", "cameras", "extrinsics", *ARGUMENTS, *SLOW])
def test_a_hostile_value_is_rejected_by_name(argument):
    scene = wall_scene()
    small = wall_mesh(5)
    given = {"pictures": scene.pictures, "cameras": CAMERA, "extrinsics": scene.extrinsics}
    faults = faults_of(texture, {"mesh": small, **given, **ARGUMENTS, **FLAGS}, argument)
    assert not faults, "\n".join(faults)
