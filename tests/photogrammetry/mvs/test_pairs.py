"""Semi-global matching of a pair: accurate depth where both images agree, and none elsewhere."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.mvs.depth_maps import DepthMaps
from pointloom.photogrammetry.mvs.posed_pictures import SparsePoints
from pointloom.photogrammetry.mvs.rectification import rectify

from .made_pictures import FOCAL, NORMAL, look, scene
from .test_estimation import digest

WIDTH, HEIGHT = 96, 72
LENS = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 2 * FOCAL, 2 * FOCAL, WIDTH / 2 - 0.5, HEIGHT / 2 - 0.5)
BASELINE = 0.18


def camera_at(
    x: float, y: float = 0.0, z: float = 0.0, *, angle: float = 0.0, roll: float = 0.0
) -> loom.mvs.PosedCamera:
    """A camera at a position, rotated about its vertical axis, then about its optical axis [rad]."""
    c, s, a, b = np.cos(angle), np.sin(angle), np.cos(roll), np.sin(roll)
    T = np.eye(4)
    T[:3, :3] = np.array([[a, -b, 0], [b, a, 0], [0, 0, 1]]) @ [[c, 0, -s], [0, 1, 0], [s, 0, c]]
    T[:3, 3] = -T[:3, :3] @ (x, y, z)
    return loom.mvs.PosedCamera(LENS, T)


def estimate(cameras, **options) -> DepthMaps:
    pictures, sparse = scene(cameras)
    return loom.mvs.estimate_depth_maps(pictures, cameras, sparse, method="sgm", **({"sources": [[1], [0]]} | options))


def errors(each, camera) -> np.ndarray:
    """Errors of disparity [px] for the baseline of the pairs."""
    truth, has = look(camera)[1], each.depth > 0
    return np.abs(1 / each.depth[has] - 1 / truth[has]) * LENS.fx * BASELINE


PAIRS = {
    "rectified": (camera_at(0.0), camera_at(BASELINE)),
    "second on the left": (camera_at(0.0), camera_at(-BASELINE)),
    "toward each other": (camera_at(0.0, angle=0.06), camera_at(BASELINE, angle=-0.06)),
    "one above the other": (camera_at(0.0), camera_at(0.0, BASELINE)),
    "rolled": (camera_at(0.0, roll=0.3), camera_at(BASELINE, 0.02, 0.03, roll=-0.2)),
}


@pytest.mark.parametrize("name", PAIRS)
def test_a_slanted_plane_has_subpixel_depth_and_its_normal(device, name):
    cameras = PAIRS[name]
    maps = estimate(cameras, device=device)
    assert maps.sources == ((1,), (0,))
    for each, camera in zip(maps, cameras, strict=True):
        wrong = errors(each, camera)
        assert each.share > 0.5
        assert np.median(wrong) < 0.2
        assert (wrong < 1).mean() > 0.97
        has = each.depth > 0
        cosines = each.normals[has] @ (camera.T_camera_world[:3, :3] @ NORMAL)
        assert np.median(cosines) > 0.92
        assert (each.confidence[has] > 0).all() and each.confidence.max() <= 0.5
        assert not each.confidence[~has].any() and not each.normals[~has].any()


def test_both_methods_agree():
    cameras = PAIRS["rectified"]
    pictures, sparse = scene(cameras)
    other = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, sources=[[1], [0]])
    for mine, theirs in zip(estimate(cameras), other, strict=True):
        both = (mine.depth > 0) & (theirs.depth > 0)
        assert np.median(np.abs(mine.depth[both] / theirs.depth[both] - 1)) < 0.03


def test_hidden_pixels_have_no_depth():
    """A textured bar before a textured wall hides a strip of the wall from the right image."""
    rng = np.random.default_rng(0)
    wall, bar = (rng.integers(0, 256, (HEIGHT, 2 * WIDTH), dtype=np.uint8) for _ in range(2))
    pictures = [wall[:, 20 : 20 + WIDTH].copy(), wall[:, 24 : 24 + WIDTH].copy()]
    pictures[0][:, 40:60], pictures[1][:, 28:48] = bar[:, :20], bar[:, :20]  # disparities 4 and 12
    cameras = [camera_at(0.0), camera_at(BASELINE)]
    near, far = LENS.fx * BASELINE / 12, LENS.fx * BASELINE / 4
    points = SparsePoints([[0, 0, z] for z in (near, near, far, far)], [[i, k] for i in (0, 1) for k in range(4)])
    left, right = loom.mvs.estimate_depth_maps(pictures, cameras, points, sources=[[1], [0]], method="sgm")
    hidden, inner = (slice(8, -8), slice(34, 38)), (slice(8, -8), slice(44, 56))
    assert (left.depth[hidden] > 0).mean() < 0.1
    np.testing.assert_allclose(np.median(left.depth[inner]), near, rtol=0.02)
    assert (left.depth[8:-8, 8:30] > 0).mean() > 0.9
    np.testing.assert_allclose(np.median(left.depth[8:-8, 8:30]), far, rtol=0.02)
    assert (right.depth[8:-8, 50:54] > 0).mean() < 0.1


@pytest.mark.parametrize("value", [0, 128])
def test_images_without_texture_have_no_depth(device, value):
    _, sparse = scene(list(PAIRS["rectified"]))
    plain = [np.full((HEIGHT, WIDTH), value, np.uint8)] * 2
    maps = loom.mvs.estimate_depth_maps(
        plain, PAIRS["rectified"], sparse, sources=[[1], [0]], method="sgm", device=device
    )
    assert [each.share for each in maps] == [0.0, 0.0]


@pytest.mark.parametrize("name", ["rectified", "rolled"])
def test_results_are_bitwise_identical_for_one_and_two_threads(name):
    before, digests = loom.get_num_threads(), []
    try:
        for count in (1, 2):
            loom.set_num_threads(count)
            digests.append(digest(estimate(PAIRS[name])))
    finally:
        loom.set_num_threads(before)
    assert digests[0] == digests[1]


def test_exposure_colors_files_and_folders_change_nothing(tmp_path):
    cameras = list(PAIRS["rectified"])
    pictures, sparse = scene(cameras)
    given = {"sources": [[1], [0]], "method": "sgm"}
    first = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, **given)
    darker = [pictures[0], (pictures[1] // 2).astype(np.uint8)]
    dark = loom.mvs.estimate_depth_maps(darker, cameras, sparse, **given)
    assert np.median(errors(dark[0], cameras[0])) < 0.2
    stored = loom.mvs.estimate_depth_maps(
        pictures, cameras, sparse, **given, folder=tmp_path / "maps", going=tmp_path / "going", device_bytes=0, seed=3
    )
    assert digest(first) == digest(stored) == digest(DepthMaps.open(tmp_path / "maps"))


def test_masked_pixels_and_images_without_sources_have_no_depth():
    mask = np.zeros((HEIGHT, WIDTH), bool)
    mask[:, : WIDTH // 2] = True
    maps = estimate(PAIRS["rectified"], masks=[None, mask], sources=[[1], [0]])
    assert maps[0].share > 0.5 and not maps[1].depth[:, WIDTH // 2 :].any()
    maps = estimate(PAIRS["rectified"], sources=[[1], []])
    assert maps[0].share > 0.5 and maps[1].share == 0


def test_the_unit_of_the_poses_scales_the_depth():
    cameras = PAIRS["rectified"]
    pictures, sparse = scene(list(cameras))
    scaled = []
    for camera in cameras:
        T = camera.T_camera_world.copy()
        T[:3, 3] *= 1000
        scaled.append(loom.mvs.PosedCamera(LENS, T))
    points = SparsePoints(sparse.points * 1000, sparse.observations)
    far = loom.mvs.estimate_depth_maps(pictures, scaled, points, sources=[[1], [0]], method="sgm")
    near = estimate(list(cameras))
    np.testing.assert_allclose(far[0].depth, 1000 * near[0].depth, rtol=1e-4)


def test_a_rectified_pair_keeps_its_pixels():
    pair = rectify(PAIRS["rectified"])
    assert (pair.width, pair.height, pair.order) == (WIDTH, HEIGHT, (0, 1))
    assert all(view.there is None for view in pair.views)
    assert rectify(PAIRS["second on the left"]).order == (1, 0)
    np.testing.assert_allclose(pair.per_unit, LENS.fx * BASELINE)


@pytest.mark.parametrize("name", PAIRS)
def test_corresponding_points_have_the_same_row_and_the_disparity_of_their_depth(name):
    cameras = PAIRS[name]
    pair = rectify(cameras)
    points = np.random.default_rng(0).uniform([-0.5, -0.5, 1.5], [0.5, 0.5, 2.5], (20, 3))
    pixels = []
    for view, index in zip(pair.views, pair.order, strict=True):
        T = cameras[index].T_camera_world
        p = (points @ T[:3, :3].T + T[:3, 3]) @ LENS.matrix.T
        p = p if view.there is None else p @ view.there.T
        pixels.append(p[:, :2] / p[:, 2:])
        z = ((points @ T[:3, :3].T + T[:3, 3]) @ view.back)[:, 2]
    np.testing.assert_allclose(pixels[0][:, 1], pixels[1][:, 1], atol=1e-3)
    np.testing.assert_allclose(pixels[0][:, 0] - pixels[1][:, 0], pair.per_unit / z + pair.offset, atol=1e-3)


def test_pairs_that_cannot_be_matched_are_rejected(tmp_path):
    def refused(error, match, cameras=PAIRS["rectified"], **options):
        with pytest.raises(error, match=match):
            estimate(list(cameras), folder=tmp_path / "maps", **options)
        assert not (tmp_path / "maps").exists()

    refused(ValueError, "cameras: expected a baseline across", (camera_at(0.0), camera_at(0.01, 0.0, 0.5)))
    refused(ValueError, "pictures: expected 2", [camera_at(0.1 * k) for k in range(3)], sources=[[1], [0], []])
    pictures, sparse = scene(list(PAIRS["rectified"]))
    for method, error in (("sgbm", ValueError), (None, TypeError), (1, TypeError)):
        with pytest.raises(error, match="method: expected"):
            loom.mvs.estimate_depth_maps(pictures, PAIRS["rectified"], sparse, method=method)
