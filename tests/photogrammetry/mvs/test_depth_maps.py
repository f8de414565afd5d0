"""Depth maps are stored bitwise; archives of networks become checked maps; damaged files are rejected."""

import inspect
import json
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.photogrammetry.mvs.depth_bundles import DepthBundle
from pointloom.photogrammetry.mvs.depth_maps import DepthMap, DepthMaps
from pointloom.photogrammetry.mvs.posed_images import SparsePoints

from ...hostile import missing_from, read_table
from ..argument_tests import argument_tests
from .made_images import camera_at, intrinsic, scene
from .made_maps import resized, true_map, true_maps


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


def test_maps_of_other_images_are_refused(tmp_path):
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


COUNT, HEIGHT, WIDTH = 4, 36, 48
K = np.array([[40.0, 0, 23.5], [0, 41.0, 17.5], [0, 0, 1]])
BALL = np.array([0.0, 0.0, 4.0]), 1.0  # before a wall at z = 6


def poses():
    T = np.tile(np.eye(4), (COUNT, 1, 1))
    for i in range(COUNT):
        T[i, :3, :3] = Rotation.from_rotvec([0.02 * i, -0.08 * (i - 1.5), 0.01]).as_matrix()
        T[i, :3, 3] = -T[i, :3, :3] @ [0.5 * (i - 1.5), 0.3 * (i % 2), 0]
    return T


def depths(T):
    """Depth of the ball and the wall, in float64."""
    lens = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, K[0, 0], K[1, 1], K[0, 2], K[1, 2])
    ball = [(*BALL[0], BALL[1])]
    return np.array([true_map(loom.photogrammetry.PosedCamera(lens, pose), balls=ball, wall=6.0).depth for pose in T])


def arrays_of(layout, **changed):
    T, confidence = poses(), np.full((COUNT, HEIGHT, WIDTH), 4.0, np.float32)
    z = depths(T).astype(np.float32)
    bytes_ = np.full((COUNT, HEIGHT, WIDTH, 3), 128, np.uint8)
    if layout == "Depth Anything 3":
        arrays = {"depth": z, "conf": confidence, "extrinsics": T[:, :3], "intrinsics": np.tile(K, (COUNT, 1, 1))}
        arrays["image"] = bytes_
    else:
        arrays = {"depth": z[..., None], "extrinsic": T[:, :3], "intrinsic": np.tile(K, (COUNT, 1, 1))}
        if layout == "VGGT":
            floats = np.full((COUNT, 3, HEIGHT, WIDTH), 128 / 255, np.float32)
            arrays |= {"depth_conf": confidence, "images": floats, "pose_enc": np.zeros((COUNT, 9))}
        else:
            arrays |= {"final_mask": z < 5.9, "images": bytes_ / 255}
    return arrays | changed


def write(tmp_path, arrays):
    path = tmp_path / "predictions.npz"
    np.savez(path, **arrays)
    return path


@pytest.mark.parametrize("layout", ["VGGT", "Depth Anything 3", "MapAnything"])
def test_a_bundle_is_read_and_fused(tmp_path, layout):
    bundle = loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of(layout)))
    assert bundle.layout == layout and len(bundle.maps) == COUNT and bundle.images[0].max() == 128
    np.testing.assert_allclose(bundle.maps.cameras[2].T_camera_world, poses()[2], atol=1e-12)
    np.testing.assert_allclose(bundle.maps[1].depth, depths(poses())[1], rtol=1e-6)
    assert set(np.unique(bundle.maps[0].confidence)) <= ({0.0, 1.0} if layout == "MapAnything" else {0.75})
    cloud = bundle.fuse(to="points")
    apart = np.abs(np.linalg.norm(cloud.points - BALL[0], axis=1) - BALL[1])
    off = np.minimum(apart, np.abs(cloud.points[:, 2] - 6))
    assert len(cloud) > 300 and np.quantile(off, 0.95) < 0.03
    np.testing.assert_allclose(cloud.colors, 128 / 255, atol=3e-3)


def test_a_bundle_is_brought_to_scale_by_known_positions(tmp_path):
    names = [f"{i}.png" for i in range(COUNT)]
    bundle = loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT")), names=names)
    rotation = Rotation.from_rotvec([0.3, 0.5, -0.2]).as_matrix()
    eyes = np.linalg.inv(poses())[:, :3, 3]
    world = 2.5 * eyes @ rotation.T + [10, 20, 30]
    fit = loom.registration.fit_to_positions(bundle.to_model(), dict(zip(names, world, strict=True)))
    assert fit.scale == pytest.approx(2.5, rel=1e-9)
    moved = bundle.transform(fit.transformation)
    np.testing.assert_allclose([c.center for c in moved.maps.cameras], world, atol=1e-6)
    np.testing.assert_allclose(moved.maps[0].depth, 2.5 * bundle.maps[0].depth, rtol=1e-6)
    before, after = bundle.fuse(to="points"), moved.fuse(to="points")
    expected = before.transform(fit.transformation)
    assert abs(len(after) / len(before) - 1) < 0.02
    assert np.quantile(after.compute_point_cloud_distance(expected), 0.95) < 1e-3


def test_poses_that_contradict_the_depth_are_an_error(tmp_path):
    inverted = np.linalg.inv(poses())[:, :3]
    inverted[:, :, 3] += 3 * np.arange(COUNT)[:, None]
    bundle = loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT", extrinsic=inverted)))
    with pytest.raises(ValueError, match="of VGGT contradict each other"):
        bundle.fuse()


@pytest.mark.parametrize(
    ("changed", "match"),
    [
        ({"depth": np.zeros((COUNT, HEIGHT, WIDTH, 1))}, "expected depth in some pixels"),
        ({"depth": np.full((COUNT, HEIGHT, WIDTH, 1), np.nan)}, "expected depth in some pixels"),
        ({"depth": np.ones((COUNT, HEIGHT))}, "depth: expected numbers of shape"),
        ({"extrinsic": np.zeros((COUNT, 3, 4))}, "extrinsic: expected rotation matrices"),
        ({"extrinsic": np.full((COUNT, 3, 4), np.nan)}, "expected finite poses"),
        ({"extrinsic": np.zeros((2, 3, 4))}, "expected poses"),
        ({"extrinsic": np.tile(np.column_stack([np.eye(3), np.full(3, 1e300)]), (COUNT, 1, 1))}, "T_camera_world"),
        ({"extrinsic": np.full((COUNT, 3, 4), 1e200)}, "extrinsic: expected rotation matrices"),
        ({"intrinsic": np.zeros((COUNT, 3, 3))}, "focal lengths above 0"),
        ({"depth_conf": np.full((COUNT, HEIGHT, WIDTH), -1.0)}, "depth_conf: expected finite numbers"),
        ({"depth_conf": np.full((COUNT, HEIGHT, WIDTH), np.inf)}, "depth_conf: expected finite numbers"),
        ({"depth_conf": np.ones((COUNT, HEIGHT))}, "depth_conf: expected shape"),
        ({"images": np.ones((COUNT, HEIGHT, WIDTH))}, "images: expected"),
        ({"images": np.full((COUNT, HEIGHT, WIDTH, 3), 7.0)}, "images: expected uint8"),
    ],
)
def test_damaged_bundles_are_named(tmp_path, changed, match):
    with pytest.raises(FileError, match=match):
        loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT", **changed)))


def test_other_archives_and_pickles_are_named(tmp_path):
    with pytest.raises(FileError, match=r"/predictions\.npz:"):
        loom.photogrammetry.read_depth_bundle(write(tmp_path, {"points": np.zeros((3, 3))}))
    objects = np.array([{"a": 1}], dtype=object)
    with pytest.raises(FileError, match=r"predictions\.npz"):
        loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT", depth=objects)))
    path = write(tmp_path, arrays_of("VGGT", world_points=objects))  # not read
    assert len(loom.photogrammetry.read_depth_bundle(path).maps) == COUNT
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(FileError, match="truncated"):
        loom.photogrammetry.read_depth_bundle(path)
    with pytest.raises(ValueError, match="names:"):
        loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT")), names=["a", "a", "b", "c"])


def test_rotations_in_half_precision_are_made_right(tmp_path):
    rough = poses()[:, :3].astype(np.float16)
    bundle = loom.photogrammetry.read_depth_bundle(write(tmp_path, arrays_of("VGGT", extrinsic=rough)))
    R = bundle.maps.cameras[3].T_camera_world[:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)


CALLS = """
loom.photogrammetry.DepthAgreement(max_pixels=1.0, max_relative=0.01, max_angle=30.0)
loom.photogrammetry.filter_depth_maps(maps=maps, min_views=2, agreement=agreement, min_confidence=0.0, min_support=0.25, folder=None, device="cpu", progress=None)
loom.photogrammetry.fuse_depth_maps(maps=maps, images=None, to="points", voxel_size=0.5, min_views=2, agreement=agreement, device="cpu", progress=None)
loom.photogrammetry.PosedCamera(intrinsic=lens, T_camera_world=pose)
loom.photogrammetry.estimate_depth_maps(images=images, cameras=cameras, sparse=sparse, sources=sources, masks=None, method="patch_match", seed=0, device="cpu", folder=None, resume_from=None, device_bytes=1000, progress=None)
loom.photogrammetry.read_depth_bundle(path=path, names=["a", "b"], device="cpu")
bundle.transform(transformation=pose)
bundle.fuse(to="points", voxel_size=0.5, min_confidence=0.1, max_relative=0.01, device="cpu", progress=None)
"""  # noqa: E501
TABLE = {name.removeprefix("mvs."): call for name, call in read_table(CALLS, {"bundle": "DepthBundle"}).items()}


@pytest.fixture(scope="module")
def things(tmp_path_factory) -> dict[str, Any]:
    shape, poses, path = (2, 4, 5), np.eye(4)[None, :3].repeat(2, axis=0), tmp_path_factory.mktemp("in") / "good.npz"
    arrays = {"depth": np.ones((*shape, 1)), "depth_conf": np.ones(shape), "intrinsic": np.tile(np.eye(3), (2, 1, 1))}
    np.savez(path, extrinsic=poses, **arrays)
    maps, cameras = true_maps(2), [camera_at(0.0, scale=0.5), camera_at(0.2, scale=0.5)]
    images, sparse = scene(cameras)
    size = images[0].shape
    depth, normals = np.ones(size), np.zeros((*size, 3))
    return {
        "loom": loom, "lens": intrinsic(), "pose": np.eye(4), "points": sparse.points, "sparse": sparse,
        "observations": sparse.observations, "cameras": cameras, "images": images, "sources": [[1], [0]],
        "depth": depth, "normals": normals, "one": DepthMap(depth, normals, depth), "maps": maps,
        "agreement": loom.photogrammetry.DepthAgreement(),
        "bundle": DepthBundle(maps, None, ("a", "b"), "VGGT"), "path": path,
    }  # fmt: skip


def test_the_table_names_every_argument():
    calls = {
        name: set(inspect.signature(getattr(loom.photogrammetry, name)).parameters) for name in TABLE if "." not in name
    }
    assert missing_from({name: TABLE[name] for name in calls}, calls) == {}


def test_a_filter_compares_no_normals():
    with pytest.raises(ValueError, match=r"^agreement: expected no max_angle"):
        loom.photogrammetry.filter_depth_maps(true_maps(2), agreement=loom.photogrammetry.DepthAgreement(max_angle=30))


test_good_arguments_are_accepted, test_hostile_values_are_rejected_by_name = argument_tests(TABLE)


@pytest.mark.parametrize(
    ("to", "scale"),
    [("points", 1e-30), ("points", 1e30), ("tsdf", 1e-3), ("tsdf", 1e30), ("poisson", 1e-30), ("poisson", 1e6)],
)
def test_a_world_of_any_size_is_fused_or_refused(to, scale):
    maps = true_maps(2)
    try:
        made = loom.photogrammetry.fuse_depth_maps(resized(maps, scale), None, to=to)
    except (ValueError, MemoryError) as error:
        assert scale in (1e-30, 1e30), error
    else:
        assert len(made) > (1000 if scale in (1e-3, 1e6) else 0)
