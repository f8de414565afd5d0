"""Depth maps are stored bitwise, in memory or in a folder; damaged or unfinished folders are rejected."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.mvs.posed_pictures import SparsePoints

from .made_pictures import camera_at, intrinsic


def a_map(seed: int, scale: float = 1.0) -> DepthMap:
    rng, lens = np.random.default_rng(seed), intrinsic(scale)
    size = (lens.height, lens.width)
    return DepthMap(rng.random(size), rng.normal(size=(*size, 3)), rng.random(size))


def stored_in(folder) -> DepthMaps:
    cameras = [camera_at(0.0), camera_at(0.2, scale=1.5)]
    return DepthMaps(cameras, [(1,), (0,)], (a_map(i, 1 + i / 2) for i in range(2)), folder=folder)


def test_a_folder_restores_maps_bitwise(tmp_path):
    made, opened = stored_in(tmp_path / "maps"), DepthMaps.open(tmp_path / "maps")
    assert len(opened) == len(made) == 2 and opened.sources == ((1,), (0,))
    for i, each in enumerate(opened):
        for name in ("depth", "normals", "confidence"):
            np.testing.assert_array_equal(getattr(each, name), getattr(a_map(i, 1 + i / 2), name))
    for a, b in zip(opened.cameras, made.cameras, strict=True):
        assert a.intrinsic == b.intrinsic
        np.testing.assert_array_equal(a.T_camera_world, b.T_camera_world)
    assert opened[-1].depth.shape == opened[0:2][1].depth.shape == (54, 72)
    with pytest.raises(IndexError):
        opened[2]


def test_the_same_maps_make_the_same_files(tmp_path):
    for name in ("one", "other"):
        stored_in(tmp_path / name)
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "other" / path.name).read_bytes()


@pytest.mark.parametrize(
    ("name", "damage"),
    [
        ("000001.npz", lambda data: data[:-40]),
        ("000001.npz", lambda data: data[:300] + b"\0\1\2" + data[303:]),
        ("000001.npz", lambda data: b""),
        ("000000.npz", None),
        ("depth_maps.json", None),
        ("depth_maps.json", lambda data: data[:-20]),
        ("depth_maps.json", lambda data: data.replace(b'"version": 1', b'"version": 7')),
        ("depth_maps.json", lambda data: data.replace(b'"width": 48', b'"width": 49')),
    ],
)
def test_a_damaged_folder_is_refused(tmp_path, name, damage):
    stored_in(tmp_path)
    path = tmp_path / name
    if damage is None:
        path.unlink()
    else:
        path.write_bytes(damage(path.read_bytes()))
    with pytest.raises(loom.FileError):
        list(DepthMaps.open(tmp_path))


def test_maps_of_other_pictures_are_refused(tmp_path):
    stored_in(tmp_path)
    index = json.loads((tmp_path / "depth_maps.json").read_text())
    (tmp_path / "000000.npz").write_bytes((tmp_path / "000001.npz").read_bytes())
    with pytest.raises(loom.FileError, match=r"/000000\.npz:.*float32.*36.*48"):
        DepthMaps.open(tmp_path)[0]
    index["sources"] = [[5], []]
    (tmp_path / "depth_maps.json").write_text(json.dumps(index))
    with pytest.raises(loom.FileError, match=r"sources\[0\]"):
        DepthMaps.open(tmp_path)


def test_a_folder_that_is_written_anew_is_unfinished_till_the_end(tmp_path):
    stored_in(tmp_path)

    def broken():
        yield a_map(0)
        raise RuntimeError("stop")

    with pytest.raises(RuntimeError, match="stop"):
        DepthMaps([camera_at(0.0)], [()], broken(), folder=tmp_path)
    with pytest.raises(loom.FileError, match="no finished depth maps"):
        DepthMaps.open(tmp_path)


def test_invalid_depth_maps_are_rejected():
    size = (6, 8)
    good = {"depth": np.ones(size), "normals": np.zeros((*size, 3)), "confidence": np.ones(size)}
    for name, value, match in (
        ("depth", -np.ones(size), "depth: expected numbers >= 0"),
        ("depth", np.full(size, np.nan), "depth: expected finite"),
        ("depth", np.full(size, 1e60), "depth: a number is beyond"),
        ("depth", np.ones((0, 8)), r"depth: expected shape \[h, w\]"),
        ("normals", np.zeros(size), "normals: expected shape"),
        ("confidence", np.full(size, 1.5), "confidence: expected 0 to 1"),
    ):
        with pytest.raises(ValueError, match=match):
            DepthMap(**(good | {name: value}))
    with pytest.raises(ValueError, match=r"maps\[0\]:"):
        DepthMaps([camera_at(0.0)], [()], [DepthMap(**good)])
    with pytest.raises(ValueError, match="maps:"):
        DepthMaps([camera_at(0.0)] * 2, [(), ()], [a_map(0)])


def test_a_map_is_read_only():
    depth = np.ones((6, 8), np.float32)
    made = DepthMap(depth, np.zeros((6, 8, 3)), np.ones((6, 8)))
    with pytest.raises(ValueError, match="read-only"):
        made.depth[0, 0] = 2.0


def test_sparse_points_are_sorted_and_checked():
    sparse = SparsePoints(np.zeros((3, 3)), [[1, 2], [0, 1], [1, 0], [0, 1]])
    assert sparse.observations.tolist() == [[0, 1], [1, 0], [1, 2]]
    assert [sparse.seen_by(i).tolist() for i in range(3)] == [[1], [0, 2], []]
    for points, pairs, error in (
        (np.zeros((3, 3)), [[0, 3]], ValueError),
        (np.zeros((3, 3)), [[-1, 0]], ValueError),
        (np.zeros((3, 3)), [[0.5, 0.0]], TypeError),
        (np.full((3, 3), np.nan), [[0, 0]], ValueError),
        (np.zeros((3, 2)), [[0, 0]], ValueError),
    ):
        with pytest.raises(error, match=r"points|observations"):
            SparsePoints(points, pairs)
