"""Every function of multi-view stereo rejects invalid arguments by name."""

import inspect
from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.mvs.depth_bundles import DepthBundle
from pointloom.photogrammetry.mvs.depth_maps import DepthMap

from ...hostile import faults_of, missing_from, read_table
from .made_maps import resized, true_maps
from .made_pictures import camera_at, intrinsic, scene

CALLS = """
loom.mvs.filter_depth_maps(maps=maps, min_views=2, max_pixels=1.0, max_relative=0.01, min_confidence=0.0, min_support=0.25, folder=None, device="cpu", progress=None)
loom.mvs.fuse(maps=maps, pictures=None, to="points", voxel_size=0.5, min_views=2, max_pixels=2.0, max_relative=0.01, max_angle=30.0, device="cpu", progress=None)
loom.mvs.PosedCamera(intrinsic=lens, T_camera_world=pose)
loom.mvs.estimate_depth_maps(pictures=pictures, cameras=cameras, sparse=sparse, sources=sources, masks=None, method="patch_match", seed=0, device="cpu", folder=None, going=None, device_bytes=1000, progress=None)
loom.mvs.read_depth_bundle(path=path, names=["a", "b"], device="cpu")
bundle.transform(transformation=pose)
bundle.fuse(to="points", voxel_size=0.5, min_confidence=0.1, max_relative=0.01, device="cpu", progress=None)
"""  # noqa: E501
TABLE = {name.removeprefix("mvs."): call for name, call in read_table(CALLS, {"bundle": "DepthBundle"}).items()}
CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@cache
def things() -> dict[str, Any]:
    maps, cameras = true_maps(2), [camera_at(0.0, scale=0.5), camera_at(0.2, scale=0.5)]
    pictures, sparse = scene(cameras)
    size = pictures[0].shape
    depth, normals = np.ones(size), np.zeros((*size, 3))
    return {
        "loom": loom, "lens": intrinsic(), "pose": np.eye(4), "points": sparse.points, "sparse": sparse,
        "observations": sparse.observations, "cameras": cameras, "pictures": pictures, "sources": [[1], [0]],
        "depth": depth, "normals": normals, "one": DepthMap(depth, normals, depth), "maps": maps,
        "bundle": DepthBundle(maps, None, ("a", "b"), "VGGT"),
    }  # fmt: skip


@pytest.fixture
def call_of(tmp_path, monkeypatch):
    """A function (name) -> a call of the table and its good arguments, in an empty folder: a string may be a file."""
    monkeypatch.chdir(tmp_path)
    shape, poses = (2, 4, 5), np.eye(4)[None, :3].repeat(2, axis=0)
    arrays = {"depth": np.ones((*shape, 1)), "depth_conf": np.ones(shape), "intrinsic": np.tile(np.eye(3), (2, 1, 1))}
    np.savez("good.npz", extrinsic=poses, **arrays)

    def find(name):
        function, expressions = TABLE[name]
        values = things() | {"path": tmp_path / "good.npz"}
        good = {key: eval(value, dict(values)) for key, value in expressions.items()}
        return lambda **given: eval(function, dict(values))(**given), good

    return find


def test_the_table_names_every_argument():
    calls = {name: set(inspect.signature(getattr(loom.mvs, name)).parameters) for name in TABLE if "." not in name}
    assert missing_from({name: TABLE[name] for name in calls}, calls) == {}


@pytest.mark.parametrize("name", TABLE)
def test_the_good_arguments_are_taken(name, call_of):
    call, good = call_of(name)
    call(**good)


@pytest.mark.parametrize(("name", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(name, argument, call_of):
    faults = faults_of(*call_of(name), argument)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    ("to", "scale"),
    [("points", 1e-30), ("points", 1e30), ("tsdf", 1e-3), ("tsdf", 1e30), ("poisson", 1e-30), ("poisson", 1e6)],
)
def test_a_world_of_any_size_is_fused_or_refused(to, scale):
    maps = true_maps(2)
    try:
        made = loom.mvs.fuse(resized(maps, scale), None, to=to)
    except (ValueError, MemoryError) as error:
        assert scale in (1e-30, 1e30), error
    else:
        assert len(made) > (1000 if scale in (1e-3, 1e6) else 0)
