"""Depth of posed photographs: choice of sources, accuracy, reproducibility, resumed searches, masks."""

import hashlib
import os
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.io.images.image_files import write_png
from pointloom.photogrammetry.mvs import plane_search
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.mvs.posed_images import SparsePoints
from pointloom.photogrammetry.mvs.rectification import rectify
from pointloom.photogrammetry.mvs.sources import choose_sources

from .made_images import FOCAL, HEIGHT, NORMAL, WIDTH, camera_at, look, scene, three
from .made_maps import moved, pose

ALL = [[1, 2], [0, 2], [0, 1]]


def digest(maps: DepthMaps) -> str:
    parts = [getattr(each, name).tobytes() for each in maps for name in ("depth", "normals", "confidence")]
    return hashlib.sha256(b"".join(parts)).hexdigest()


def estimate(cameras, **options):
    images, sparse = scene(cameras)
    return loom.photogrammetry.estimate_depth_maps(
        images, cameras, sparse, **({"sources": ALL[: len(cameras)]} | options)
    )


def errors(each: DepthMap, camera: loom.photogrammetry.PosedCamera, unit: float = 1.0) -> np.ndarray:
    """Reprojection error of each pixel in a source 0.18 to the side [px]."""
    truth, has = look(camera)[1], each.depth > 0
    return np.abs(unit / each.depth[has] - 1 / truth[has]) * FOCAL * 0.18


def test_a_textured_plane_has_accurate_depth(device):
    cameras = three()
    maps = estimate(cameras, device=device)
    assert [each.depth.shape for each in maps] == [(36, 48)] * 3
    for each, camera in zip(maps, cameras, strict=True):
        wrong = errors(each, camera)
        assert each.fraction > 0.8
        assert np.median(wrong) < 0.05
        assert (wrong < 0.2).mean() > 0.9


def test_normals_point_to_the_camera_and_confidence_follows_the_error():
    maps = estimate(three())
    inner = (slice(6, -6), slice(12, -12))
    cosine = maps[0].normals[inner] @ NORMAL
    assert np.median(cosine) > 0.95
    np.testing.assert_allclose(np.linalg.norm(maps[0].normals[inner], axis=-1), 1.0, atol=1e-5)
    trusted = maps[0].confidence > 0.5
    assert trusted.mean() > 0.25
    truth = look(three()[0])[1]
    wrong = np.abs(maps[0].depth - truth) / truth
    assert wrong[trusted].mean() < wrong[~trusted & (maps[0].depth > 0)].mean()


def test_repeated_runs_and_folders_are_bitwise_identical(tmp_path):
    first = estimate(three())
    assert digest(first) == digest(estimate(three()))
    stored = estimate(three(), folder=tmp_path / "maps")
    assert digest(first) == digest(stored) == digest(DepthMaps.open(tmp_path / "maps"))
    assert sorted(path.name for path in (tmp_path / "maps").iterdir()) == [
        "000000.npz", "000001.npz", "000002.npz", "depth_maps.json",
    ]  # fmt: skip


def test_little_device_memory_changes_no_bit():
    cameras = [*three(), camera_at(0.1, -0.1)]
    sources = [[1, 2], [0, 3], [3, 0], [2, 1]]
    assert digest(estimate(cameras, sources=sources)) == digest(estimate(cameras, sources=sources, device_bytes=0))


def test_another_seed_gives_other_planes_of_the_same_surface():
    one, other = estimate(three()), estimate(three(), seed=1)
    assert digest(one) != digest(other)
    assert np.median(errors(other[0], three()[0])) < 0.05


def test_files_give_what_their_arrays_give(tmp_path):
    cameras = three()
    images, sparse = scene(cameras)
    colored = [np.repeat(image[..., None], 3, axis=2) for image in images]
    paths = [tmp_path / f"{i}.png" for i in range(3)]
    for path, image in zip(paths, colored, strict=True):
        Image.fromarray(image).save(path)
    files, arrays = (
        loom.photogrammetry.estimate_depth_maps(each, cameras, sparse, sources=ALL) for each in (paths, colored)
    )
    assert digest(files) == digest(arrays)


def test_images_of_several_sizes_have_maps_of_their_own_sizes():
    cameras = [camera_at(0.0), camera_at(0.18, scale=1.5), camera_at(-0.05, 0.15, scale=0.75)]
    maps = estimate(cameras)
    assert [each.depth.shape for each in maps] == [(36, 48), (54, 72), (27, 36)]
    assert all(np.median(errors(each, camera)) < 0.05 for each, camera in zip(maps, cameras, strict=True))


def test_black_images_have_no_depth_and_harm_no_others():
    cameras, black = three(), np.zeros((36, 48), np.uint8)
    images, sparse = scene(cameras)
    maps = loom.photogrammetry.estimate_depth_maps([black] * 3, cameras, sparse, sources=ALL)
    assert all(each.fraction == 0 and not each.confidence.any() for each in maps)
    maps = loom.photogrammetry.estimate_depth_maps([*images[:2], black], cameras, sparse, sources=ALL)
    assert maps[2].fraction == 0
    assert np.median(errors(maps[0], cameras[0])) < 0.05


def test_the_unit_of_the_poses_and_a_far_origin_change_little():
    cameras = three()
    images, sparse = scene(cameras)
    for factor, origin in ((1e3, 0.0), (1e-3, 0.0), (1.0, 5e6)):
        posed = moved(cameras, factor, (origin, origin, origin))
        points = SparsePoints(sparse.points * factor + origin, sparse.observations)
        maps = loom.photogrammetry.estimate_depth_maps(images, posed, points, sources=ALL)
        assert np.median(errors(maps[0], cameras[0], factor)) < 0.05


def test_an_image_without_sources_has_no_depth():
    maps = estimate(three(), sources=[[1], [0], []])
    assert maps.sources[2] == () and maps[2].fraction == 0 and maps[0].fraction > 0.8


def test_cameras_that_only_rotate_are_rejected():
    with pytest.raises(ValueError, match="cameras:"):
        estimate([camera_at(0.0)] * 2, sources=[[1], [0]])


def test_depth_is_estimated_where_frusta_overlap_without_points():
    cameras = three()
    images, _ = scene(cameras)
    maps = loom.photogrammetry.estimate_depth_maps(images, cameras)
    for each, camera in zip(maps, cameras, strict=True):
        wrong = errors(each, camera)
        assert each.fraction > 0.8
        assert np.median(wrong) < 0.05
        assert (wrong < 0.2).mean() > 0.85
    none = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), int))
    assert digest(maps) == digest(loom.photogrammetry.estimate_depth_maps(images, cameras, none))


def test_an_image_that_sees_no_points_is_searched_where_frusta_meet():
    cameras = three()
    images, sparse = scene(cameras)
    blind = SparsePoints(sparse.points, sparse.observations[sparse.observations[:, 0] != 2])
    maps = loom.photogrammetry.estimate_depth_maps(images, cameras, blind, sources=ALL)
    assert maps.sources[2] == (0, 1) and maps[2].fraction > 0.8
    assert np.median(errors(maps[2], cameras[2])) < 0.05


def test_invalid_images_are_reported_by_number(tmp_path):
    cameras = three()
    images, sparse = scene(cameras)

    def refused(changed, error, match):
        with pytest.raises(error, match=match):
            loom.photogrammetry.estimate_depth_maps(changed, cameras, sparse, sources=ALL)

    refused(images[:1], ValueError, "images: expected at least 2, got 1")
    refused(images[:2], ValueError, "cameras: expected one for each of the 2 images, got 3")
    wanted = r"images\[2\]: expected 48 x 36 pixels as of its camera, got 48 x 35"
    refused([*images[:2], images[2][:-1]], ValueError, wanted)
    refused([*images[:2], images[2].astype(np.uint16)], TypeError, r"images\[2\]: expected uint8.*divide 16-bit")
    refused([*images[:2], np.zeros((36, 48, 4), np.uint8)], ValueError, r"images\[2\]: expected shape")
    Image.fromarray(images[2][:-1]).save(tmp_path / "small.png")
    refused([*images[:2], tmp_path / "small.png"], loom.FileError, "expected 48 x 36 pixels .*, got 48 x 35")
    refused([*images[:2], tmp_path / "none.png"], loom.FileError, "cannot be read")
    Image.fromarray(images[2].astype(np.uint16) * 256).save(tmp_path / "deep.png")
    refused([*images[:2], tmp_path / "deep.png"], loom.FileError, "16-bit")


def test_invalid_sources_are_rejected():
    for sources, match in (
        ([[1], [0]], "for each of the 3"),
        ([[3], [], []], r"sources\[0\]"),
        ([[0], [], []], "other"),
    ):
        with pytest.raises(ValueError, match=match):
            estimate(three(), sources=sources)


def test_a_failure_leaves_no_finished_folder(tmp_path):
    def stop(stage, done, total):
        if done == total:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        estimate(three(), folder=tmp_path / "maps", progress=stop)
    with pytest.raises(loom.FileError, match="/maps:"):
        DepthMaps.open(tmp_path / "maps")
    assert not [path for path in (tmp_path / "maps").iterdir() if path.is_dir()]


def test_an_interrupted_search_resumes_at_the_next_image(tmp_path, monkeypatch):
    expected = digest(estimate(three(), sources=None))
    steps, matched, match = [], [], plane_search._PhaseRun.match
    noted = lambda phase, i: matched.append((phase.number, i)) or match(phase, i)  # noqa: E731
    monkeypatch.setattr(plane_search._PhaseRun, "match", noted)

    def run(stop):
        matched.clear()

        def progress(name, done, total):
            steps.append(total)
            if done == stop:
                raise KeyboardInterrupt

        return estimate(three(), sources=None, resume_from=tmp_path / "resume_from", progress=progress)

    for stop in (2, 4, 6, 9):
        with pytest.raises(KeyboardInterrupt):
            run(stop)
    assert digest(run(None)) == expected
    assert matched == [(k // 3, k % 3) for k in range(9, steps[0] // 3 * 3)]  # finished images are not matched again


def test_damaged_files_are_matched_again(tmp_path):
    options = {"sources": None, "resume_from": tmp_path / "resume_from"}
    expected = estimate(three(), **options)
    files = sorted((tmp_path / "resume_from").iterdir())
    files[0].write_bytes(files[0].read_bytes()[:-7])
    files[1].write_bytes(b"")
    np.save(files[2], np.zeros((3, 4), np.float32))
    assert digest(estimate(three(), **options)) == digest(expected)
    files[0].write_bytes(files[0].read_bytes().replace(b"}", b"(", 1))  # an error of Python's parser
    assert digest(estimate(three(), **options)) == digest(expected)
    for value in (np.nan, np.inf):
        np.save(files[0], np.full_like(np.load(files[1]), value))
        assert digest(estimate(three(), **options)) == digest(expected)


@pytest.mark.parametrize("name", ["folder", "resume_from"])
def test_folders_with_links_are_not_used(tmp_path, name):
    (tmp_path / name).mkdir()
    (tmp_path / "mine").write_text("mine")
    (tmp_path / name / "000000.npz").symlink_to(tmp_path / "mine")
    with pytest.raises(loom.FileError, match="is a symbolic link"):
        estimate(three(), sources=None, **{name: tmp_path / name})
    assert (tmp_path / "mine").read_text() == "mine"


@pytest.mark.parametrize(
    "change", [lambda path: os.truncate(path, 400), lambda path: np.save(path, [1.0]), Path.unlink]
)
@pytest.mark.parametrize("options", [{"resume_from": "planes"}, {"folder": "planes", "device_bytes": 0}])
def test_planes_that_another_program_changes_are_an_error(tmp_path, monkeypatch, options, change):
    def progress(name, done, total):
        if done == 3:  # the planes of the first phase are complete
            change(min((tmp_path / "planes").rglob("0-0*.npy")))

    monkeypatch.chdir(tmp_path)
    with pytest.raises(loom.FileError, match=r"0-0+\.npy.*Run it again"):
        estimate(three(), sources=None, progress=progress, **options)


@pytest.fixture(scope="module")
def masks():
    """A mask that excludes the right half of each image."""
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    mask[:, : WIDTH // 2] = 255
    return mask


def test_masked_pixels_have_no_depth_and_no_points(masks, tmp_path):
    cameras = three()
    images, sparse = scene(cameras)
    write_png(tmp_path / "m.png", masks)
    given = [tmp_path / "m.png", masks, masks > 0]
    unmasked = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse)
    maps = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, masks=given)
    for each, all_of_it in zip(maps, unmasked, strict=True):
        out = masks == 0
        assert not each.depth[out].any() and not each.confidence[out].any() and not each.normals[out].any()
        assert np.array_equal(each.depth[~out], all_of_it.depth[~out]) and each.depth[~out].any()
    cloud = loom.photogrammetry.fuse_depth_maps(maps, images)
    inside = np.zeros(len(cloud), bool)
    for camera in cameras:
        p = cloud.points @ camera.T_camera_world[:3, :3].T + camera.T_camera_world[:3, 3]
        inside |= camera.intrinsic.fx * p[:, 0] / p[:, 2] + camera.intrinsic.cx < WIDTH // 2 + 1
    assert len(cloud) > 100 and inside.all()
    maps = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, masks=[None, masks, None])
    assert np.array_equal(maps[0].depth, unmasked[0].depth) and not np.array_equal(maps[1].depth, unmasked[1].depth)


def test_masks_that_do_not_fit_are_refused(masks, tmp_path):
    write_png(tmp_path / "m.png", masks[:-1])
    for wrong, error, match in [
        ([masks], ValueError, "masks: expected one, or None, for each of the 3 images, got 1"),
        ([masks, masks, masks[1:]], ValueError, r"masks\[2\]: expected shape"),
        ([masks, masks, 1.0 * masks], TypeError, r"masks\[2\]: expected a path, or an array of bool or uint8"),
        ([masks, masks, tmp_path / "m.png"], loom.FileError, "m.png: expected a mask of 48 x 36 pixels"),
    ]:
        with pytest.raises(error, match=match):
            estimate(three(), sources=None, masks=wrong)


def camera_from(x, y=0.0, z=0.0, angle=0.0):
    T = pose(x, y, angle)
    T[:3, 3] -= T[:3, 2] * z
    return loom.photogrammetry.PosedCamera(loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), T)


def scattered(rng, count=9, points=300):
    """Cameras in a row and points that some of them see."""
    cameras = [camera_from(*rng.normal(0, 0.5, 2)) for _ in range(count)]
    positions = rng.normal((0, 0, 6), 1, (points, 3))
    return cameras, SparsePoints(positions, np.argwhere(rng.random((count, points)) < 0.4))


def plain_cover(cameras, sparse, count):
    """The greedy choice with one matrix per image."""
    centers, out = np.array([camera.center for camera in cameras]), []
    for i in range(len(cameras)):
        mine = sparse.seen_by(i)
        weights = np.zeros((len(cameras), len(mine)))
        for j in range(len(cameras)):
            if j == i:
                continue
            a, b = sparse.points[mine] - centers[i], sparse.points[mine] - centers[j]
            cosine = (a * b).sum(1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
            angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
            weight = np.clip(angle / 3, 0, 1) * np.exp(-np.maximum(angle - 10, 0) / 10)
            weights[j] = np.isin(mine, sparse.seen_by(j)) * weight
        left, chosen = np.full(len(mine), 3.0), []
        for _ in range(count):
            gain = np.minimum(weights, left).sum(1)
            gain[chosen] = -1
            if gain.max() <= 0:
                break
            chosen.append(int(gain.argmax()))
            left = np.maximum(left - weights[chosen[-1]], 0)
        out.append(tuple(chosen))
    return tuple(out)


@pytest.mark.parametrize("count", [1, 4, 8])
def test_the_choice_matches_a_plain_loop(rng, count):
    cameras, sparse = scattered(rng)
    assert choose_sources(cameras, sparse, count=count) == plain_cover(cameras, sparse, count)


def test_a_source_covering_unseen_points_precedes_better_ones():
    """Images 1 to 4 see the left half well; only image 5 sees the right half, at a poorer angle."""
    cameras = [camera_from(x) for x in (0.0, 0.5, 0.52, 0.54, 0.56, 0.15)]
    points = np.stack([np.linspace(-1, 1, 40), np.zeros(40), np.full(40, 5.0)], axis=1)
    left = np.flatnonzero(points[:, 0] < 0).tolist()
    right = np.flatnonzero(points[:, 0] > 0).tolist()
    seen = [(0, k) for k in range(40)] + [(j, k) for j in (1, 2, 3, 4) for k in left] + [(5, k) for k in right]
    chosen = choose_sources(cameras, SparsePoints(points, seen), count=4)[0]
    assert chosen.index(5) == 3  # after three good views of the left half a fourth adds nothing
    assert choose_sources(cameras, SparsePoints(points, seen), count=8)[0] == chosen


def test_angles_of_some_degrees_are_preferred():
    degrees = np.array([0.0, 0.3, 6.0, 40.0, 85.0])
    cameras = [camera_from(5 * np.sin(a), 0, 5 - 5 * np.cos(a)) for a in np.radians(degrees)]
    sparse = SparsePoints([[0.0, 0.0, 5.0]], [(i, 0) for i in range(5)])
    assert choose_sources(cameras, sparse)[0] == (2, 1, 3, 4)


def test_sources_are_independent_of_origin_and_unit(rng):
    cameras, sparse = scattered(rng)
    expected = choose_sources(cameras, sparse)
    for scale, shift in ((1.0, (5e5, 5.4e6, 300.0)), (1e-6, np.zeros(3)), (1e6, np.zeros(3))):
        points = SparsePoints(sparse.points * scale + shift, sparse.observations)
        assert choose_sources(moved(cameras, scale, shift), points) == expected


def test_nearby_cameras_of_the_same_direction_are_sources_without_points():
    cameras = [camera_from(0.1 * k) for k in range(6)] + [camera_from(0.05, angle=3.0)]
    none = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), int))
    chosen = choose_sources(cameras, none, count=3)
    assert chosen == choose_sources(cameras, None, count=3)
    assert set(chosen[0]) <= {1, 2, 3, 4}
    assert set(chosen[3]) <= {1, 2, 4, 5}
    assert all(6 not in each for each in chosen[:6])  # it looks the other way
    assert chosen[6] == ()


def test_a_model_of_structure_from_motion_is_taken_for_its_points(rng):
    cameras, sparse = scattered(rng)
    model = SimpleNamespace(points=sparse.points, observations=sparse.observations, names=("a.jpg",) * 9)
    assert choose_sources(cameras, model) == choose_sources(cameras, sparse)


def test_only_an_image_without_shared_points_is_chosen_for_by_its_camera(rng):
    cameras, sparse = scattered(rng)
    bare = SparsePoints(sparse.points, sparse.observations[sparse.observations[:, 0] != 4])
    chosen = choose_sources(cameras, bare, count=3)
    assert len(chosen[4]) == 3
    assert all(4 not in each for i, each in enumerate(chosen) if i != 4)


def test_cameras_at_one_position_have_no_sources():
    for count in (0, 1, 3):
        assert choose_sources([camera_from(0.0)] * count, None) == ((),) * count
    sparse = SparsePoints([[0.0, 0.0, 2.0]], [(0, 0), (1, 0), (2, 0)])
    assert choose_sources([camera_from(0.0)] * 3, sparse) == ((), (), ())


def test_an_observation_by_an_image_that_is_not_there_is_refused():
    sparse = SparsePoints([[0.0, 0.0, 2.0]], [(3, 0)])
    with pytest.raises(ValueError, match="sparse:"):
        choose_sources([camera_from(0.0)] * 2, sparse)


PAIR_WIDTH, PAIR_HEIGHT = 96, 72
PAIR_LENS = loom.PinholeCameraIntrinsic(PAIR_WIDTH, PAIR_HEIGHT, 2 * FOCAL, 2 * FOCAL, 47.5, 35.5)
BASELINE = 0.18


def rotated_camera(x, y=0.0, z=0.0, *, angle=0.0, roll=0.0) -> loom.photogrammetry.PosedCamera:
    """A camera at a position, rotated about its vertical axis, then about its optical axis [rad]."""
    c, s, a, b = np.cos(angle), np.sin(angle), np.cos(roll), np.sin(roll)
    T = np.eye(4)
    T[:3, :3] = np.array([[a, -b, 0], [b, a, 0], [0, 0, 1]]) @ [[c, 0, -s], [0, 1, 0], [s, 0, c]]
    T[:3, 3] = -T[:3, :3] @ (x, y, z)
    return loom.photogrammetry.PosedCamera(PAIR_LENS, T)


def estimate_pair(cameras, **options) -> DepthMaps:
    images, sparse = scene(cameras)
    return loom.photogrammetry.estimate_depth_maps(
        images, cameras, sparse, method="sgm", **({"sources": [[1], [0]]} | options)
    )


def disparity_errors(each, camera) -> np.ndarray:
    """Errors of disparity [px] for the baseline of the pairs."""
    truth, has = look(camera)[1], each.depth > 0
    return np.abs(1 / each.depth[has] - 1 / truth[has]) * PAIR_LENS.fx * BASELINE


PAIRS = {
    "rectified": (rotated_camera(0.0), rotated_camera(BASELINE)),
    "second on the left": (rotated_camera(0.0), rotated_camera(-BASELINE)),
    "toward each other": (rotated_camera(0.0, angle=0.06), rotated_camera(BASELINE, angle=-0.06)),
    "one above the other": (rotated_camera(0.0), rotated_camera(0.0, BASELINE)),
    "rolled": (rotated_camera(0.0, roll=0.3), rotated_camera(BASELINE, 0.02, 0.03, roll=-0.2)),
}


@pytest.mark.parametrize("name", PAIRS)
def test_a_slanted_plane_has_subpixel_depth_and_its_normal(device, name):
    cameras = PAIRS[name]
    maps = estimate_pair(cameras, device=device)
    assert maps.sources == ((1,), (0,))
    for each, camera in zip(maps, cameras, strict=True):
        wrong = disparity_errors(each, camera)
        assert each.fraction > 0.5
        assert np.median(wrong) < 0.2
        assert (wrong < 1).mean() > 0.97
        has = each.depth > 0
        cosines = each.normals[has] @ (camera.T_camera_world[:3, :3] @ NORMAL)
        assert np.median(cosines) > 0.92
        assert (each.confidence[has] > 0).all() and each.confidence.max() <= 0.5
        assert not each.confidence[~has].any() and not each.normals[~has].any()


def test_hidden_pixels_have_no_depth():
    """A textured bar before a textured wall hides a strip of the wall from the right image."""
    rng = np.random.default_rng(0)
    wall, bar = (rng.integers(0, 256, (PAIR_HEIGHT, 2 * PAIR_WIDTH), dtype=np.uint8) for _ in range(2))
    images = [wall[:, 20 : 20 + PAIR_WIDTH].copy(), wall[:, 24 : 24 + PAIR_WIDTH].copy()]
    images[0][:, 40:60], images[1][:, 28:48] = bar[:, :20], bar[:, :20]  # disparities 4 and 12
    cameras = [rotated_camera(0.0), rotated_camera(BASELINE)]
    near, far = PAIR_LENS.fx * BASELINE / 12, PAIR_LENS.fx * BASELINE / 4
    points = SparsePoints([[0, 0, z] for z in (near, near, far, far)], [[i, k] for i in (0, 1) for k in range(4)])
    left, right = loom.photogrammetry.estimate_depth_maps(images, cameras, points, sources=[[1], [0]], method="sgm")
    hidden, inner = (slice(8, -8), slice(34, 38)), (slice(8, -8), slice(44, 56))
    assert (left.depth[hidden] > 0).mean() < 0.1
    np.testing.assert_allclose(np.median(left.depth[inner]), near, rtol=0.02)
    assert (left.depth[8:-8, 8:30] > 0).mean() > 0.9
    np.testing.assert_allclose(np.median(left.depth[8:-8, 8:30]), far, rtol=0.02)
    assert (right.depth[8:-8, 50:54] > 0).mean() < 0.1


@pytest.mark.parametrize("value", [0, 128])
def test_images_without_texture_have_no_depth(device, value):
    _, sparse = scene(list(PAIRS["rectified"]))
    plain = [np.full((PAIR_HEIGHT, PAIR_WIDTH), value, np.uint8)] * 2
    given = {"sources": [[1], [0]], "method": "sgm", "device": device}
    maps = loom.photogrammetry.estimate_depth_maps(plain, PAIRS["rectified"], sparse, **given)
    assert [each.fraction for each in maps] == [0.0, 0.0]


@pytest.mark.parametrize("name", ["rectified", "rolled"])
def test_results_are_bitwise_identical_for_one_and_two_threads(name):
    before, digests = loom.get_num_threads(), []
    try:
        for count in (1, 2):
            loom.set_num_threads(count)
            digests.append(digest(estimate_pair(PAIRS[name])))
    finally:
        loom.set_num_threads(before)
    assert digests[0] == digests[1]


def test_exposure_colors_files_and_folders_change_nothing(tmp_path):
    cameras = list(PAIRS["rectified"])
    images, sparse = scene(cameras)
    given = {"sources": [[1], [0]], "method": "sgm"}
    first = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, **given)
    darker = [images[0], (images[1] // 2).astype(np.uint8)]
    dark = loom.photogrammetry.estimate_depth_maps(darker, cameras, sparse, **given)
    assert np.median(disparity_errors(dark[0], cameras[0])) < 0.2
    given |= {"folder": tmp_path / "maps", "resume_from": tmp_path / "resume_from", "device_bytes": 0, "seed": 3}
    stored = loom.photogrammetry.estimate_depth_maps(images, cameras, sparse, **given)
    assert digest(first) == digest(stored) == digest(DepthMaps.open(tmp_path / "maps"))


def test_masked_pixels_and_images_without_sources_have_no_depth():
    mask = np.zeros((PAIR_HEIGHT, PAIR_WIDTH), bool)
    mask[:, : PAIR_WIDTH // 2] = True
    maps = estimate_pair(PAIRS["rectified"], masks=[None, mask], sources=[[1], [0]])
    assert maps[0].fraction > 0.5 and not maps[1].depth[:, PAIR_WIDTH // 2 :].any()
    maps = estimate_pair(PAIRS["rectified"], sources=[[1], []])
    assert maps[0].fraction > 0.5 and maps[1].fraction == 0


def test_the_unit_of_the_poses_scales_the_depth():
    cameras = PAIRS["rectified"]
    images, sparse = scene(list(cameras))
    points = SparsePoints(sparse.points * 1000, sparse.observations)
    scaled = moved(cameras, 1000, (0, 0, 0))
    far = loom.photogrammetry.estimate_depth_maps(images, scaled, points, sources=[[1], [0]], method="sgm")
    np.testing.assert_allclose(far[0].depth, 1000 * estimate_pair(cameras)[0].depth, rtol=1e-4)


def test_a_rectified_pair_keeps_its_pixels():
    pair = rectify(PAIRS["rectified"])
    assert (pair.width, pair.height, pair.order) == (PAIR_WIDTH, PAIR_HEIGHT, (0, 1))
    assert all(view.there is None for view in pair.views)
    assert rectify(PAIRS["second on the left"]).order == (1, 0)
    np.testing.assert_allclose(pair.per_unit, PAIR_LENS.fx * BASELINE)


def test_pairs_that_cannot_be_matched_are_rejected(tmp_path):
    def refused(error, match, cameras=PAIRS["rectified"], **options):
        with pytest.raises(error, match=match):
            estimate_pair(list(cameras), folder=tmp_path / "maps", **options)
        assert not (tmp_path / "maps").exists()

    refused(ValueError, "cameras: expected a baseline across", (rotated_camera(0.0), rotated_camera(0.01, 0.0, 0.5)))
    refused(ValueError, "images: expected 2", [rotated_camera(0.1 * k) for k in range(3)], sources=[[1], [0], []])
    images, sparse = scene(list(PAIRS["rectified"]))
    for method, error in (("sgbm", ValueError), (None, TypeError), (1, TypeError)):
        with pytest.raises(error, match="method: expected"):
            loom.photogrammetry.estimate_depth_maps(images, PAIRS["rectified"], sparse, method=method)
