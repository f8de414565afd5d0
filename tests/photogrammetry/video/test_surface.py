"""The stages after the model: undistorted pictures with sparse points, and results without any depth."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.core.stages import StageResult
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.video import motion, surface
from pointloom.photogrammetry.video.units import Units

from ..sfm.made_features import seen_model

WIDTH, HEIGHT = 96, 64
NAMES = ("frame_000003.jpg", "frame_000010.jpg", "frame_000020.jpg")


def ignore_progress(step, done, total):
    pass


def made(folder):
    return StageResult(folder.name, folder, "", {}, {}, False)


@pytest.fixture
def before(tmp_path, rng):
    frames, model = tmp_path / "frames", tmp_path / "model"
    (frames / motion.PICTURES).mkdir(parents=True)
    for name in NAMES:
        pixels = rng.integers(0, 256, (HEIGHT, WIDTH, 3), np.uint8)
        Image.fromarray(pixels).save(frames / motion.PICTURES / name)
    camera = loom.CameraModel("SIMPLE_RADIAL", WIDTH, HEIGHT, [80.0, 47.0, 33.0, -0.12])
    loom.write_colmap_model(model / motion.MODEL, seen_model(camera, NAMES, angle=0))
    return made(frames), made(model)


@pytest.fixture
def straight(before, tmp_path):
    return straighten(before, tmp_path, 1000)


def straighten(before, tmp_path, max_size):
    folder = tmp_path / "undistorted"
    folder.mkdir()
    given = {"frames": before[0], "model": before[1], "max_size": max_size}
    report = surface.straighten(folder, ignore_progress, **given, device="cpu")
    return StageResult("undistorted", folder, "", report, {}, False)


@pytest.mark.parametrize("max_size", [1000, 64, 40])
def test_undistorted_pictures_show_sparse_points_as_a_pinhole(before, tmp_path, max_size):
    result = straighten(before, tmp_path, max_size)
    model, paths, cameras = surface.open_straightened(result)
    assert model.names == tuple(f"{Path(name).stem}.png" for name in NAMES)
    assert len(model.observations) > 60
    for k, (path, camera) in enumerate(zip(paths, cameras, strict=True)):
        assert loom.read_color(path).shape == (camera.intrinsic.height, camera.intrinsic.width, 3)
        mine = model.observations[:, 0] == k
        points = model.points[model.observations[mine, 1]]
        local = points @ camera.T_camera_world[:3, :3].T + camera.T_camera_world[:3, 3]
        lens = camera.intrinsic
        pixels = local[:, :2] / local[:, 2:] * (lens.fx, lens.fy) + (lens.cx, lens.cy)
        np.testing.assert_allclose(pixels, model.pixels[mine], atol=1e-6)
    size = result.report["sizes"][0]
    assert max(size) == max_size if max_size < WIDTH else max(size) >= WIDTH - 10


def depth_without_any(straight, tmp_path):
    _, _, cameras = surface.open_straightened(straight)
    lens = cameras[0].intrinsic
    empty = DepthMap(*(np.zeros((lens.height, lens.width, *rest)) for rest in ((), (3,), ())))
    DepthMaps(cameras, [(1,), (0, 2), (1,)], [empty] * 3, folder=tmp_path / "depth" / surface.MAPS)
    return made(tmp_path / "depth")


def empty_mesh(straight, tmp_path, units):
    """Reports of the last two stages without depth."""
    depth = depth_without_any(straight, tmp_path)
    (tmp_path / "fused").mkdir()
    (tmp_path / "mesh").mkdir()
    where = {"undistorted": straight, "device": "cpu"}
    fused = surface.fuse_points(tmp_path / "fused", ignore_progress, depth=depth, **where)
    given = {"model": straight, "fused": made(tmp_path / "fused"), "units": units}
    return fused, surface.make_mesh(tmp_path / "mesh", ignore_progress, **given, **where)


def test_no_depth_gives_no_points_and_an_empty_mesh(straight, tmp_path):
    fused, mesh = empty_mesh(straight, tmp_path, Units())
    assert fused == {"share": 0.0, "points": 0}
    assert (mesh["triangles"], mesh["bounds"]) == (0, None)


@pytest.mark.parametrize("scale", [None, 30.0])
def test_poses_beside_the_mesh_carry_the_numbers_of_their_pictures_and_its_unit(straight, tmp_path, scale):
    empty_mesh(straight, tmp_path, Units(scale=scale))
    path = loom.read_trajectory(tmp_path / "mesh" / surface.POSES_LOG)
    assert path.ids[:, 0].tolist() == [3, 10, 20]
    expected = np.array([0, 0.1, 0.2]) * (scale or 1.0)
    np.testing.assert_allclose(path.poses[:, 0, 3], expected, atol=1e-9)
    model = loom.read_colmap_model(tmp_path / "mesh" / surface.SPARSE)
    np.testing.assert_allclose(model.centers[:, 0], expected, atol=1e-9)


def test_the_share_of_a_masked_picture_counts_unmasked_pixels(tmp_path):
    Image.fromarray(np.repeat(np.array([[255, 0, 0, 0]], np.uint8), 3, axis=0)).save(tmp_path / "small.png")
    Image.fromarray(np.zeros((3, 4), np.uint8)).save(tmp_path / "hidden.png")
    depth = np.zeros((3, 4))
    depth[:2, 0] = 1.0  # 2 of the 3 pixels that are left, 2 of 12 of all
    one, none = (DepthMap(z, np.zeros((3, 4, 3)), np.zeros((3, 4))) for z in (depth, 0 * depth))
    assert surface.mean_share([one], [tmp_path / "small.png"]) == pytest.approx(2 / 3)
    assert surface.mean_share([one, none], [None, tmp_path / "hidden.png"]) == pytest.approx(1 / 12)


def test_small_floating_parts_are_removed():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
    vertices = np.concatenate([corners, 0.5 * corners + 3, 0.05 * corners + 9])
    mesh = loom.TriangleMesh(vertices, np.arange(9).reshape(3, 3))
    assert len(surface.without_floaters(mesh)) == 2
    assert len(surface.without_floaters(loom.TriangleMesh())) == 0
