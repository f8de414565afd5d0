"""Depth of posed photographs is accurate on a textured plane and reproducible."""

import hashlib

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.mvs.posed_pictures import SparsePoints

from .made_maps import moved
from .made_pictures import FOCAL, NORMAL, camera_at, look, scene, three

ALL = [[1, 2], [0, 2], [0, 1]]


def digest(maps: DepthMaps) -> str:
    parts = [getattr(each, name).tobytes() for each in maps for name in ("depth", "normals", "confidence")]
    return hashlib.sha256(b"".join(parts)).hexdigest()


def estimate(cameras, **options):
    pictures, sparse = scene(cameras)
    return loom.mvs.estimate_depth_maps(pictures, cameras, sparse, **({"sources": ALL[: len(cameras)]} | options))


def errors(each: DepthMap, camera: loom.mvs.PosedCamera, unit: float = 1.0) -> np.ndarray:
    """Reprojection error of each pixel in a source 0.18 to the side [px]."""
    truth, has = look(camera)[1], each.depth > 0
    return np.abs(unit / each.depth[has] - 1 / truth[has]) * FOCAL * 0.18


def test_a_textured_plane_has_accurate_depth(device):
    cameras = three()
    maps = estimate(cameras, device=device)
    assert [each.depth.shape for each in maps] == [(36, 48)] * 3
    for each, camera in zip(maps, cameras, strict=True):
        wrong = errors(each, camera)
        assert each.share > 0.8
        assert np.median(wrong) < 0.05
        assert (wrong < 0.2).mean() > 0.9


def test_normals_point_to_the_camera_and_confidence_follows_the_error():
    cameras = three()
    maps = estimate(cameras)
    inner = (slice(6, -6), slice(12, -12))
    cosine = maps[0].normals[inner] @ NORMAL
    assert np.median(cosine) > 0.95
    np.testing.assert_allclose(np.linalg.norm(maps[0].normals[inner], axis=-1), 1.0, atol=1e-5)
    trusted = maps[0].confidence > 0.5
    assert trusted.mean() > 0.25
    truth = look(cameras[0])[1]
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
    pictures, sparse = scene(cameras)
    colored = [np.repeat(picture[..., None], 3, axis=2) for picture in pictures]
    paths = [tmp_path / f"{i}.png" for i in range(3)]
    for path, picture in zip(paths, colored, strict=True):
        Image.fromarray(picture).save(path)
    given = {"sources": ALL}
    maps = [loom.mvs.estimate_depth_maps(each, cameras, sparse, **given) for each in (paths, colored)]
    assert digest(maps[0]) == digest(maps[1])


def test_pictures_of_several_sizes_have_maps_of_their_own_sizes():
    cameras = [camera_at(0.0), camera_at(0.18, scale=1.5), camera_at(-0.05, 0.15, scale=0.75)]
    maps = estimate(cameras)
    assert [each.depth.shape for each in maps] == [(36, 48), (54, 72), (27, 36)]
    assert all(np.median(errors(each, camera)) < 0.05 for each, camera in zip(maps, cameras, strict=True))


def test_black_pictures_have_no_depth_and_harm_no_others():
    cameras, black = three(), np.zeros((36, 48), np.uint8)
    pictures, sparse = scene(cameras)
    maps = loom.mvs.estimate_depth_maps([black] * 3, cameras, sparse, sources=ALL)
    assert all(each.share == 0 and not each.confidence.any() for each in maps)
    maps = loom.mvs.estimate_depth_maps([*pictures[:2], black], cameras, sparse, sources=ALL)
    assert maps[2].share == 0
    assert np.median(errors(maps[0], cameras[0])) < 0.05


def test_the_unit_of_the_poses_and_a_far_origin_change_little():
    cameras = three()
    pictures, sparse = scene(cameras)
    for factor, origin in ((1e3, 0.0), (1e-3, 0.0), (1.0, 5e6)):
        posed = moved(cameras, factor, (origin, origin, origin))
        points = SparsePoints(sparse.points * factor + origin, sparse.observations)
        maps = loom.mvs.estimate_depth_maps(pictures, posed, points, sources=ALL)
        assert np.median(errors(maps[0], cameras[0], factor)) < 0.05


def test_a_picture_without_sources_has_no_depth():
    cameras = three()
    pictures, sparse = scene(cameras)
    maps = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, sources=[[1], [0], []])
    assert maps.sources[2] == () and maps[2].share == 0 and maps[0].share > 0.8


def test_cameras_that_only_rotate_are_rejected():
    cameras = [camera_at(0.0), camera_at(0.0)]
    with pytest.raises(ValueError, match="cameras:"):
        estimate(cameras, sources=[[1], [0]])


def test_depth_is_estimated_where_frusta_overlap_without_points():
    cameras = three()
    pictures, _ = scene(cameras)
    maps = loom.mvs.estimate_depth_maps(pictures, cameras)
    for each, camera in zip(maps, cameras, strict=True):
        wrong = errors(each, camera)
        assert each.share > 0.8
        assert np.median(wrong) < 0.05
        assert (wrong < 0.2).mean() > 0.85
    none = SparsePoints(np.zeros((0, 3)), np.zeros((0, 2), int))
    assert digest(maps) == digest(loom.mvs.estimate_depth_maps(pictures, cameras, none))


def test_a_picture_that_sees_no_points_is_searched_where_frusta_meet():
    cameras = three()
    pictures, sparse = scene(cameras)
    blind = SparsePoints(sparse.points, sparse.observations[sparse.observations[:, 0] != 2])
    maps = loom.mvs.estimate_depth_maps(pictures, cameras, blind, sources=ALL)
    assert maps.sources[2] == (0, 1) and maps[2].share > 0.8
    assert np.median(errors(maps[2], cameras[2])) < 0.05


def test_invalid_pictures_are_reported_by_number(tmp_path):
    cameras = three()
    pictures, sparse = scene(cameras)

    def refused(changed, error, match):
        with pytest.raises(error, match=match):
            loom.mvs.estimate_depth_maps(changed, cameras, sparse, sources=ALL)

    refused(pictures[:1], ValueError, "pictures: expected at least 2, got 1")
    refused(pictures[:2], ValueError, "cameras: expected one for each of the 2 images, got 3")
    wanted = r"pictures\[2\]: expected 48 x 36 pixels as of its camera, got 48 x 35"
    refused([*pictures[:2], pictures[2][:-1]], ValueError, wanted)
    refused([*pictures[:2], pictures[2].astype(np.uint16)], TypeError, r"pictures\[2\]: expected uint8.*divide 16-bit")
    refused([*pictures[:2], np.zeros((36, 48, 4), np.uint8)], ValueError, r"pictures\[2\]: expected shape")
    Image.fromarray(pictures[2][:-1]).save(tmp_path / "small.png")
    refused([*pictures[:2], tmp_path / "small.png"], loom.FileError, "expected 48 x 36 pixels .*, got 48 x 35")
    refused([*pictures[:2], tmp_path / "none.png"], loom.FileError, "cannot be read")
    Image.fromarray(pictures[2].astype(np.uint16) * 256).save(tmp_path / "deep.png")
    refused([*pictures[:2], tmp_path / "deep.png"], loom.FileError, "16-bit")


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
