"""Archives of networks: poses, depth and confidence become checked and fused depth maps."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.errors import FileError

from .made_maps import true_map

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
    return np.array([true_map(loom.mvs.PosedCamera(lens, pose), balls=ball, wall=6.0).depth for pose in T])


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
    bundle = loom.mvs.read_depth_bundle(write(tmp_path, arrays_of(layout)))
    assert bundle.layout == layout and len(bundle.maps) == COUNT and bundle.pictures[0].max() == 128
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
    bundle = loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT")), names=names)
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
    bundle = loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT", extrinsic=inverted)))
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
        ({"images": np.ones((COUNT, HEIGHT, WIDTH))}, "pictures: expected"),
        ({"images": np.full((COUNT, HEIGHT, WIDTH, 3), 7.0)}, "pictures: expected uint8"),
    ],
)
def test_damaged_bundles_are_named(tmp_path, changed, match):
    with pytest.raises(FileError, match=match):
        loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT", **changed)))


def test_other_archives_and_pickles_are_named(tmp_path):
    with pytest.raises(FileError, match=r"/predictions\.npz:"):
        loom.mvs.read_depth_bundle(write(tmp_path, {"points": np.zeros((3, 3))}))
    objects = np.array([{"a": 1}], dtype=object)
    with pytest.raises(FileError, match=r"predictions\.npz"):
        loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT", depth=objects)))
    path = write(tmp_path, arrays_of("VGGT", world_points=objects))  # not read
    assert len(loom.mvs.read_depth_bundle(path).maps) == COUNT
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(FileError, match="truncated"):
        loom.mvs.read_depth_bundle(path)
    with pytest.raises(ValueError, match="names:"):
        loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT")), names=["a", "a", "b", "c"])


def test_rotations_in_half_precision_are_made_right(tmp_path):
    rough = poses()[:, :3].astype(np.float16)
    bundle = loom.mvs.read_depth_bundle(write(tmp_path, arrays_of("VGGT", extrinsic=rough)))
    R = bundle.maps.cameras[3].T_camera_world[:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
