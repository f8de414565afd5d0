"""Depth and points from one image: references, scale and shift, cameras, edges, tiles."""

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.depth.alignment import AlignmentError, align_inverse_depth, align_to_distances
from pointloom.photogrammetry.depth.estimation import DepthEstimate
from pointloom.photogrammetry.depth.evaluation import evaluate_depth
from pointloom.photogrammetry.depth.tiles import refine_by_tiles

from .tiny_networks import fixed_map, linear

SIDE = 518  # the network's image goes in and comes out as it is


def scene(height=SIDE, width=SIDE):
    """True depth [m]: a sloping floor, a wall, and a board in front of both."""
    v, u = np.mgrid[:height, :width]
    z = np.minimum(1.5 / np.maximum((v / height - 0.45), 1e-3), 4.0)
    board = (np.abs(u / width - 0.4) < 0.15) & (np.abs(v / height - 0.5) < 0.2)
    return np.where(board, 1.5, z)


@pytest.fixture
def network(tmp_path):
    """A network that gives the scene up to scale and shift, and the scene."""
    z = scene()
    return fixed_map(tmp_path / "scene.onnx", 37 / z + 5), z


IMAGE = np.random.default_rng(0).integers(0, 256, (SIDE, SIDE, 3), dtype=np.uint8)
CAMERA = loom.PinholeCameraIntrinsic(SIDE, SIDE, 500.0, 510.0, 250.0, 262.0)


def test_a_depth_map_as_reference_gives_meters(network):
    path, z = network
    for align, scale in ((np.round(z * 5000).astype(np.uint16), 5000.0), (z.astype(np.float32), 1000.0)):
        result = loom.photogrammetry.estimate_depth(IMAGE, path, align=align, depth_scale=scale)
        assert result.is_metric
        assert (result.unit, result.inlier_fraction, result.references) == ("m", 1.0, SIDE * SIDE)
        assert (result.scale, result.shift) == pytest.approx((1 / 37, -5 / 37), rel=1e-3)
        np.testing.assert_allclose(result.depth, z, rtol=1e-3)
        assert evaluate_depth(result.depth, z).abs_rel < 1e-3


def test_a_depth_map_of_another_size_is_aligned_at_its_borders(network):
    path, _ = network
    coarse = (np.mgrid[:37, :37].astype(float) + 0.5) * SIDE / 37 - 0.5
    v, u = coarse
    z = np.minimum(1.5 / np.maximum((v / SIDE - 0.45), 1e-3), 4.0)
    z[(np.abs(u / SIDE - 0.4) < 0.2) & (np.abs(v / SIDE - 0.5) < 0.25)] = 0  # no depth near the board
    result = loom.photogrammetry.estimate_depth(IMAGE, path, align=z)
    assert result.references == (z > 0).sum()
    assert result.inlier_fraction == 1.0
    assert (result.scale, result.shift) == pytest.approx((1 / 37, -5 / 37), rel=1e-4)


def test_wrong_and_missing_sensor_depth_is_ignored(network):
    path, z = network
    sensor = z.copy()
    lost = np.random.default_rng(0).random(z.shape)
    sensor[lost < 0.3] = 0
    sensor[lost < 0.05] = np.nan
    sensor[lost > 0.65] *= 2 * lost[lost > 0.65]  # by 1.3 and more
    result = loom.photogrammetry.estimate_depth(IMAGE, path, align=sensor)
    np.testing.assert_allclose(result.depth, z, rtol=1e-4)
    assert result.inlier_fraction < 0.7


def test_the_invalid_value_of_sensors_is_no_depth(network):
    path, z = network
    sensor = np.round(z * 1000).astype(np.uint16)
    sensor[:200] = 65535
    result = loom.photogrammetry.estimate_depth(IMAGE, path, align=sensor)
    assert (result.references, result.inlier_fraction) == (318 * SIDE, 1.0)


def test_reference_files_match_arrays(network, tmp_path):
    path, z = network
    np.save(tmp_path / "z.npy", z.astype(np.float32))
    Image.fromarray(np.round(z * 1000).astype(np.uint16)).save(tmp_path / "z.png")
    by_array = loom.photogrammetry.estimate_depth(IMAGE, path, align=z.astype(np.float32))
    np.testing.assert_array_equal(
        loom.photogrammetry.estimate_depth(IMAGE, path, align=tmp_path / "z.npy").depth, by_array.depth
    )
    np.testing.assert_allclose(
        loom.photogrammetry.estimate_depth(IMAGE, path, align=tmp_path / "z.png").depth, z, rtol=2e-3
    )
    for name, text in (
        ("a.txt", "# measured\n100 500 {a}\n300 20 {b}\n"),
        ("a.csv", "u,v,meters\n100,500,{a}\n300,20,{b}\n"),
    ):
        (tmp_path / name).write_text(text.format(a=z[500, 100], b=z[20, 300]))
        result = loom.photogrammetry.estimate_depth(IMAGE, path, align=tmp_path / name)
        np.testing.assert_allclose(result.depth, z, rtol=1e-4)
        assert (result.references, result.inlier_fraction, result.is_metric) == (2, None, True)


def sparse_model(z, count=120, wrong=0.3, size=SIDE, distorted=False):
    """A sparse model of three images. The second observes points of the scene, some of them wrong."""
    rng = np.random.default_rng(4)
    u, v = rng.uniform(0, size - 1, (2, count))
    row, column = (np.round(x * SIDE / size).astype(int).clip(0, SIDE - 1) for x in (v, u))
    depth = z[row, column]
    depth = np.where(rng.random(count) < wrong, rng.uniform(0.5, 6, count), depth)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [0.3, -0.2, 0.5]
    f, k = size / SIDE, (0.1,) if distorted else ()
    params = (500 * f, 250.5 * f, 262.5 * f, *k) if distorted else (500 * f, 510 * f, 250.5 * f, 262.5 * f)
    camera = loom.CameraModel("SIMPLE_RADIAL" if distorted else "PINHOLE", size, size, params)
    points = camera.unproject(np.stack([u, v], 1)) * depth[:, None]
    seen = np.stack([np.ones(count, int), np.arange(count)], 1)
    observations = np.concatenate([[[0, 0], [0, 1]], seen])
    return loom.SfmModel(
        ("a/left.png", "b/photo.png", "c/right.png"), (camera,) * 3, np.stack([np.eye(4), T, T]),
        points=(points - T[:3, 3]) @ T[:3, :3], observations=observations, pixels=np.zeros((len(observations), 2)),
    )  # fmt: skip


def test_a_sparse_model_or_its_folder_gives_its_unit_and_camera(network, tmp_path):
    path, z = network
    Image.fromarray(IMAGE).save(tmp_path / "photo.png")
    model, photo = sparse_model(z), tmp_path / "photo.png"
    loom.write_colmap_model(tmp_path / "sparse", model)
    for image, align in ((photo, model), (IMAGE, (model, "b/photo.png")), (photo, tmp_path / "sparse")):
        result = loom.photogrammetry.estimate_depth(image, path, align=align)
        assert not result.is_metric
        assert (result.unit, result.intrinsic_source) == ("the sparse model's", "the sparse model")
        assert result.intrinsic == CAMERA and result.references == 120
        assert result.inlier_fraction > 0.6
        assert evaluate_depth(result.depth, z).abs_rel < 5e-3
    (tmp_path / "empty").mkdir()
    with pytest.raises(loom.FileError, match="empty: "):
        loom.photogrammetry.estimate_depth(photo, path, align=tmp_path / "empty")


@pytest.mark.parametrize("options", [{"size": 259}, {"distorted": True}])
def test_the_camera_of_a_sparse_model_is_scaled_and_its_distortion_removed(network, options):
    path, z = network
    result = loom.photogrammetry.estimate_depth(IMAGE, path, align=(sparse_model(z, **options), "photo.png"))
    assert evaluate_depth(result.depth, z).abs_rel < 5e-3
    left_out = ", its distortion left out" if "distorted" in options else ""
    assert result.intrinsic_source == f"the sparse model{left_out}"
    camera, fy = result.intrinsic, 500 if left_out else 510
    assert (camera.fx, camera.fy, camera.cx, camera.cy) == pytest.approx((500, fy, 250, 262), rel=1e-5)


def test_depth_far_beyond_the_references_is_dropped(tmp_path):
    w = np.tile(np.linspace(-0.1, 1, SIDE), (SIDE, 1))
    path = fixed_map(tmp_path / "m.onnx", w)
    sensor = np.where(w > 0.5, 1 / np.where(w > 0.5, w, 1), 0)
    result = loom.photogrammetry.estimate_depth(IMAGE, path, align=sensor)
    valid = result.depth > 0
    assert result.depth.max() == pytest.approx(20, rel=0.05)
    np.testing.assert_array_equal(valid[0], w[0] > 0.05)


@pytest.mark.parametrize(
    ("align", "error", "reason"),
    [
        ([(600, 3, 1.0), (3, 3, 2.0)], ValueError, r"pixel \(600, 3\) is outside the image of 518 x 518"),
        ([(6, 3, -1.0), (3, 3, 2.0)], ValueError, "distances above 0"),
        ([(6, 3, 1.0)], ValueError, "expected at least 2 distances .*, got 1"),
        (np.ones((480, 640)), ValueError, "expected the depth map with the aspect ratio of the image.*, got 640 x 480"),
        (np.zeros((518, 518)), ValueError, "references inside the image, got 0"),
        (np.ones((2, 2, 2)), ValueError, r"of shape \[2, 2, 2\]"),
        ("none.txt", loom.FileError, "cannot be read"),
        ("none.ply", loom.FileError, "unknown extension '.ply'"),
        (sparse_model(scene()), ValueError, "identifies images by name"),
        ((sparse_model(scene()), "x.png"), ValueError, "expected one image 'x.png' in the model, got 0; .* a/left.png"),
        ((sparse_model(scene()), "left.png"), ValueError, "references inside the image, got 2"),
    ],
)
def test_references_that_do_not_fit_the_image_are_refused(network, align, error, reason):
    with pytest.raises(error, match=reason):
        loom.photogrammetry.estimate_depth(IMAGE, network[0], align=align)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("1 2 3\n4 5\n", r"line 2\): expected u v meters"),
        ("u v m\n1 2 three\n", "line 2"),
        ("# none\n", "contains no rows"),
    ],
)
def test_a_damaged_file_of_distances_names_the_line(network, tmp_path, text, reason):
    path = tmp_path / "d.txt"
    path.write_text(text)
    with pytest.raises(loom.FileError, match=reason):
        loom.photogrammetry.estimate_depth(IMAGE, network[0], align=path)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(loom.FileError, match="not UTF-8 text"):
        loom.photogrammetry.estimate_depth(IMAGE, network[0], align=path)


def test_points_are_unprojected_with_the_camera(network, device):
    path, z = network
    result = loom.photogrammetry.estimate_depth(IMAGE, path, intrinsic=CAMERA, align=z.astype(np.float32))
    cloud = result.to_point_cloud(keep_edges=True, device=device)
    v, u = np.mgrid[:SIDE, :SIDE]
    expected = np.stack([(u - 250) / 500 * z, (v - 262) / 510 * z, z], -1).reshape(-1, 3)
    np.testing.assert_allclose(cloud.points, expected, rtol=1e-4, atol=1e-4)
    np.testing.assert_allclose(cloud.colors, IMAGE.reshape(-1, 3) / 255, atol=1e-6)
    assert str(cloud.device) == device
    assert len(result.to_point_cloud(keep_edges=True, stride=2)) == (SIDE // 2) ** 2


def test_a_camera_of_another_size_is_refused(network):
    camera = loom.PinholeCameraIntrinsic(640, 480, 500.0, 500.0, 320.0, 240.0)
    with pytest.raises(ValueError, match="intrinsic:"):
        loom.photogrammetry.estimate_depth(IMAGE, network[0], intrinsic=camera)


def test_a_smoothed_edge_leaves_no_points_between_the_surfaces(tmp_path, device):
    z = scene()
    small = (1 / z)[::7, ::7].astype(np.float32)
    smooth = np.array(Image.fromarray(small).resize((SIDE, SIDE), Image.Resampling.BILINEAR))
    result = loom.photogrammetry.estimate_depth(
        IMAGE, fixed_map(tmp_path / "m.onnx", smooth), align=1 / smooth, intrinsic=CAMERA
    )
    result = DepthEstimate(**{**vars(result), "enlargement": 3.0})
    cloud = result.to_point_cloud(device=device)
    depth = cloud.project_to_depth_image(SIDE, SIDE, CAMERA, depth_scale=1, depth_max=100)
    row = SIDE // 3  # the board before the wall
    ramp = (result.depth[row] > 1.6) & (result.depth[row] < 3.8)
    assert ramp.sum() >= 8
    assert not depth[row][ramp].any()
    assert depth[row][~ramp].all()
    floor = depth[int(0.93 * SIDE)]  # slanted, and without gaps
    assert floor.all()
    assert len(cloud) > 0.97 * SIDE * SIDE


def test_one_model_serves_many_images(tmp_path):
    path = linear(tmp_path / "m.onnx", size=(28, 28))
    model = loom.photogrammetry.DepthModel(path)
    for seed in range(3):
        image = np.random.default_rng(seed).integers(0, 256, (28, 28, 3), dtype=np.uint8)
        once, again = (loom.photogrammetry.estimate_depth(image, each).depth for each in (path, model))
        np.testing.assert_array_equal(once, again)


def test_tiles_add_detail_at_the_scale_of_the_full_image():
    """The network gives finer details for a tile, and each tile has a different scale."""
    v, u = np.mgrid[:240, :320]
    true = (0.3 + 0.5 * v / 240 + 0.03 * np.sin(1.2 * u)).astype(np.float32)
    color = np.stack([u % 256, v % 256, u // 256], -1).astype(np.uint8)
    calls = []

    def inverse(part):
        rows, columns = part.shape[:2]
        top, left = int(part[0, 0, 1]), int(part[0, 0, 0]) + 256 * int(part[0, 0, 2])
        calls.append((top, left))
        return np.float32(3 + len(calls)) * true[top : top + rows, left : left + columns] + np.float32(len(calls))

    coarse = (0.3 + 0.5 * v / 240).astype(np.float32)
    progress = []
    report = lambda *each: progress.append(each)  # noqa: E731
    refined, used, count = refine_by_tiles(color, coarse, 3, inverse, seed=0, report=report)
    assert used == count == len(calls) >= 6
    assert progress[-1] == (count, count)
    np.testing.assert_allclose(refined - coarse, true - coarse, atol=0.012)
    assert np.abs(np.diff(refined, axis=1) - np.diff(true, axis=1)).max() < 0.004  # no seams


def test_tiles_that_differ_at_their_overlap_leave_no_seam():
    coarse = np.tile(np.linspace(1, 2, 400, dtype=np.float32), (100, 1))
    calls = []

    def bent(part):
        calls.append(part)
        u = np.linspace(-1, 1, part.shape[1], dtype=np.float32)
        return np.tile(u + (0.3 if len(calls) % 2 else -0.3) * u * u, (part.shape[0], 1))

    color = np.zeros((100, 400, 3), np.uint8)
    refined, used, count = refine_by_tiles(color, coarse, 3, bent, seed=0, report=lambda *_: None)
    assert used == count == 3
    assert np.abs(refined - coarse).max() > 0.03  # they differ
    assert np.abs(np.diff(refined, axis=1)).max() < 0.01  # but neighboring pixels hardly do


def test_contradicting_tiles_are_excluded():
    coarse = np.tile(np.linspace(1, 2, 200, dtype=np.float32), (150, 1))
    color = np.zeros((150, 200, 3), np.uint8)

    def falling(part):
        return np.tile(np.linspace(2, 1, part.shape[1], dtype=np.float32), (part.shape[0], 1))

    refined, used, count = refine_by_tiles(color, coarse, 2, falling, seed=0, report=lambda *_: None)
    assert (used, count) == (0, 4)
    np.testing.assert_allclose(refined, coarse, rtol=1e-6)


def test_tiles_without_finer_detail_match_the_untiled_estimate(tmp_path):
    path = linear(tmp_path / "m.onnx", size=(252, 252))
    ramp = np.tile(np.linspace(20, 220, 600).astype(np.uint8)[None, :, None], (400, 1, 3))
    untiled = loom.photogrammetry.estimate_depth(ramp, path)
    steps = []
    tiled = loom.photogrammetry.estimate_depth(ramp, path, tiles=2, progress=lambda *each: steps.append(each))
    assert tiled.tiles == (4, 4)
    assert steps[-1] == ("tiles", 4, 4)
    np.testing.assert_allclose(tiled.depth, untiled.depth, rtol=0.02)


def test_errors_follow_their_published_definitions():
    truth = np.array([[1.0, 2.0, 4.0, 0.0, 8.0]])
    depth = np.array([[1.1, 2.0, 6.0, 3.0, np.nan]])
    errors = evaluate_depth(depth, truth)
    assert errors.abs_rel == pytest.approx((0.1 + 0 + 0.5) / 3)
    assert errors.delta1 == pytest.approx(2 / 3)
    assert errors.rmse == pytest.approx(np.sqrt((0.01 + 0 + 4) / 3))
    assert (errors.coverage, errors.pixel_count) == (0.75, 3)
    raw = np.array([[1100, 2000]], np.uint16)
    assert evaluate_depth(raw, np.array([[1.0, 2.0]])).abs_rel == pytest.approx(0.05)
    assert np.isnan(evaluate_depth(np.zeros((2, 2)), np.ones((2, 2))).abs_rel)
    with pytest.raises(ValueError, match="resize one"):
        evaluate_depth(np.ones((2, 2)), np.ones((2, 3)))


def exact(count=200, scale=0.02, shift=0.1, seed=0):
    d = np.random.default_rng(seed).uniform(0, 40, count)
    return d, scale * d + shift


@pytest.mark.parametrize("wrong", [0.0, 0.4, 0.6])
def test_wrong_references_do_not_change_the_fit_to_exact_ones(wrong):
    d, y = exact(400)
    rng = np.random.default_rng(1)
    lost = rng.random(400) < wrong
    far = np.where(rng.random(400) < 0.5, y * rng.uniform(1.3, 5, 400), y * rng.uniform(0.1, 0.7, 400))
    result = align_inverse_depth(d, np.where(lost, far, y))
    assert (result.scale, result.shift) == pytest.approx((0.02, 0.1), rel=1e-9)
    assert result.inlier_fraction == pytest.approx(1 - lost.mean(), abs=0.08)


def test_the_fit_is_the_weighted_least_squares_of_the_inliers():
    d, y = exact(300)
    y = y * (1 + np.random.default_rng(2).normal(0, 0.01, 300))
    result = align_inverse_depth(d, y)
    expected = np.linalg.lstsq(np.stack([d / y, 1 / y], 1), np.ones(300), rcond=None)[0]
    np.testing.assert_allclose([result.scale, result.shift], expected, rtol=1e-9)


def test_metric_depth_is_aligned_by_scale_only():
    d = np.random.default_rng(0).uniform(0.2, 2, 100)
    y = 1.25 * d
    y[::3] *= 3
    result = align_inverse_depth(d, y, with_shift=False)
    assert (result.scale, result.shift) == (pytest.approx(1.25, rel=1e-12), 0.0)
    assert result.inlier_fraction == pytest.approx(66 / 100)
    assert result.farthest == pytest.approx(1 / y.reshape(-1)[np.arange(100) % 3 > 0].min())


def test_fewer_than_20_inliers_are_rejected():
    d, y = exact(200)
    with pytest.raises(AlignmentError, match=r"^align:.*20.*got 19"):
        align_inverse_depth(d[:19], y[:19])
    assert align_inverse_depth(d[:20], y[:20]).inlier_fraction == 1.0
    wrong = np.random.default_rng(3).uniform(0.01, 100, 30) ** 2
    with pytest.raises(AlignmentError, match=r"^align:.*30"):
        align_inverse_depth(d[:30], wrong)


def test_a_map_that_decreases_with_inverse_depth_is_rejected():
    d, y = exact(200)
    with pytest.raises(AlignmentError, match=r"^align:"):
        align_inverse_depth(d, y.max() + 0.2 - y)
    with pytest.raises(AlignmentError):
        align_inverse_depth(np.full(50, 3.0), y[:50])


def test_two_distances_determine_scale_and_shift_and_one_the_scale_unchecked():
    result = align_to_distances(np.array([10.0, 30.0]), np.array([0.25, 0.5]))
    assert (result.scale, result.shift, result.inlier_fraction) == (pytest.approx(0.0125), pytest.approx(0.125), None)
    with pytest.raises(AlignmentError, match=r"^align:"):
        align_to_distances(np.array([10.0, 30.0]), np.array([0.5, 0.25]))
    with pytest.raises(AlignmentError, match=r"^align:.*2.*got 1"):
        align_to_distances(np.array([10.0]), np.array([0.5]))
    result = align_to_distances(np.array([0.5]), np.array([0.25]), with_shift=False)
    assert (result.scale, result.shift, result.inlier_fraction) == (0.5, 0.0, None)


def test_a_majority_of_the_distances_must_agree():
    d = np.array([5.0, 10.0, 20.0, 30.0, 40.0])
    y = 0.0125 * d + 0.125
    wrong = y.copy()
    wrong[1] *= 3
    result = align_to_distances(d, wrong)
    assert (result.scale, result.shift) == pytest.approx((0.0125, 0.125), rel=1e-9)
    assert result.inlier_fraction == pytest.approx(0.8)
    wrong[[0, 4]] *= (0.2, 6.0)
    with pytest.raises(AlignmentError, match=r"^align:.*5"):
        align_to_distances(d, wrong)
    half = np.array([5.0, 10.0, 20.0, 30.0, 40.0, 50.0])
    with pytest.raises(AlignmentError, match=r"^align:.*6.*got 3"):
        align_to_distances(half, (0.0125 * half + 0.125) * (1, 2, 1, 9, 1, 0.2))
    with pytest.raises(AlignmentError, match=r"^align:.*3.*got 2"):
        align_to_distances(d[:3], y[:3] * (1, 1, 4))
