"""Odometry of real frames: the poses of a kitchen, failures, and the results of Open3D's two odometries."""

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.rgbd.odometry.options import (
    OdometryConvergenceCriteria,
    OdometryMethod,
    OdometryOption,
    RGBDOdometryJacobianFromColorTerm,
    RGBDOdometryJacobianFromHybridTerm,
)
from pointloom.rgbd.odometry.rgbd_odometry import (
    compute_odometry_information_matrix,
    open3d_multi_scale_odometry,
    open3d_odometry,
)

from .made_frames import CAMERA, errors_of, image, pose_of

od = loom.rgbd


@pytest.fixture(scope="module")
def kitchen(real_file):
    """A function that prepares a frame, and its pose."""
    frames = loom.open_dataset(real_file("rgbd-7scenes-redkitchen"))

    def prepare(i):
        frame = frames.read(int(i))
        return od.OdometryFrame(frame.depth, frames.intrinsic, frame.color), frame.T_world_camera

    return prepare


@pytest.mark.slow
def test_ten_pairs_of_the_kitchen(kitchen, tolerances):
    errors = []
    for i in np.linspace(0, 289, 10).astype(int):
        (source, first), (target, second) = kitchen(i), kitchen(i + 10)
        result = od.align_frames(source, target)
        assert result.reliable, result.warnings
        errors.append(errors_of(result.transformation, np.linalg.inv(second) @ first))
    angle, distance = np.median(errors, axis=0)
    assert angle < tolerances.odometry_kitchen_angle and distance < tolerances.odometry_kitchen_distance


@pytest.mark.parametrize(("i", "j"), [(0, 200), (40, 250), (280, 10), (90, 299)])
def test_far_apart_in_the_kitchen(kitchen, i, j):
    assert not od.align_frames(kitchen(i)[0], kitchen(j)[0]).reliable


def test_a_desk_is_no_kitchen(kitchen, real_file):
    folder = real_file("rgbd-slambook-ch7")
    camera = loom.PinholeCameraIntrinsic(640, 480, 521.0, 521.0, 325.1, 249.7)
    desks = []
    for name in "12":
        depth, color = (np.asarray(Image.open(folder / f"{name}{part}.png")) for part in ("_depth", ""))
        desks.append(od.OdometryFrame(depth, camera, color[..., :3], depth_scale=5000.0))
    assert od.align_frames(*desks).reliable and not od.align_frames(desks[0], kitchen(0)[0]).reliable


POSES = pose_of([0, 0, 0], [0, 0, 0]), pose_of([0.01, -0.02, 0.005], [0.02, -0.01, 0.01])
STEPS = [(0, 0, 1), (0, 1, 0), (1, 0, 0), (6, 4, 2)]
LEGACY = [(with_depth, steps) for with_depth in (True, False) for steps in STEPS]
TENSOR = [
    (method, steps) for method in OdometryMethod for steps in STEPS[:3]
]  # with more, runs of Open3D differ in float32


def made_images():
    """Two synthetic images with holes, depth in whole millimeters."""
    images = []
    for k, pose in enumerate(POSES):
        depth, color = image(pose, noise=0.3, seed=k)
        raw = np.round(1000 * depth).astype(np.uint16)
        raw[20:24, 30:37] = raw[60, 100] = 0
        images.append((color, raw))
    return images, CAMERA


def legacy(o3d, pairs, camera, with_depth, steps):
    """(success, pose, information) of Open3D."""
    pipeline, images = o3d.pipelines.odometry, []
    for color, raw in pairs:
        both = o3d.geometry.Image(np.ascontiguousarray(color)), o3d.geometry.Image(raw)
        images.append(o3d.geometry.RGBDImage.create_from_color_and_depth(*both, 1000.0, 4.0, True))
    term = pipeline.RGBDOdometryJacobianFromHybridTerm() if with_depth else pipeline.RGBDOdometryJacobianFromColorTerm()
    numbers = (camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
    intrinsic = o3d.camera.PinholeCameraIntrinsic(*numbers)
    option = pipeline.OdometryOption(o3d.utility.IntVector(steps))
    return pipeline.compute_rgbd_odometry(*images, intrinsic, np.eye(4), term, option)


def tensor(o3d, pairs, camera, method, steps):
    """(pose, fitness) of Open3D's tensor API."""
    pipeline, images = o3d.t.pipelines.odometry, []
    for color, raw in pairs:
        parts = (o3d.t.geometry.Image(o3d.core.Tensor(np.ascontiguousarray(part))) for part in (color, raw))
        images.append(o3d.t.geometry.RGBDImage(*parts))
    criteria = [pipeline.OdometryConvergenceCriteria(step, 1e-12, 1e-12) for step in steps]
    matrix, start = o3d.core.Tensor(camera.matrix), o3d.core.Tensor(np.eye(4))
    kind = getattr(pipeline.Method, method.name)
    result = pipeline.rgbd_odometry_multi_scale(*images, matrix, start, 1000.0, 3.0, criteria, kind)
    return result.transformation.numpy(), result.fitness


def of_made_images(o3d):
    """Open3D's results of all cases of the synthetic images."""
    made = made_images()
    of_legacy = [legacy(o3d, *made, with_depth, steps) for with_depth, steps in LEGACY]
    return of_legacy, [tensor(o3d, *made, method, steps) for method, steps in TENSOR]


def test_the_odometries_of_made_images(device, oracle, tolerances):
    of_legacy, of_tensor = oracle("rgbd/odometry", of_made_images)
    pairs, camera = made_images()
    images = [loom.RGBDImage.create_from_color_and_depth(*pair, 1000.0, 4.0, device=device) for pair in pairs]
    for (success, pose, information), (with_depth, steps) in zip(of_legacy, LEGACY, strict=True):
        term = RGBDOdometryJacobianFromHybridTerm() if with_depth else RGBDOdometryJacobianFromColorTerm()
        result = open3d_odometry(*images, camera, np.eye(4), term, OdometryOption(steps))
        assert result.reliable == success
        assert np.abs(result.transformation - pose).max() < tolerances.odometry_open3d_legacy
        assert abs(result.information[5, 5] - information[5, 5]) <= 1e-4 * information[5, 5]
        assert not np.allclose(pose, np.eye(4), atol=1e-5)
    for (pose, fitness), (method, steps) in zip(of_tensor, TENSOR, strict=True):
        criteria = [OdometryConvergenceCriteria(step, 1e-12, 1e-12) for step in steps]
        result = open3d_multi_scale_odometry(*images, camera.matrix, np.eye(4), 3.0, criteria, method, None)
        assert np.abs(result.transformation - pose).max() < tolerances.odometry_open3d_tensor
        assert abs(result.fitness - fitness) < 2e-4


def information_of(o3d, raws, camera, pose):
    images = [o3d.t.geometry.Image(o3d.core.Tensor(raw)) for raw in raws]
    numbers = (o3d.core.Tensor(camera.matrix), o3d.core.Tensor(pose), 0.07, 1000.0, 3.0)
    return o3d.t.pipelines.odometry.compute_odometry_information_matrix(*images, *numbers).numpy()


def test_the_information_of_two_depths(oracle):
    (first, second), camera = made_images()
    raws, pose = [np.ascontiguousarray(pair[1]) for pair in (first, second)], np.linalg.inv(POSES[1]) @ POSES[0]
    expected = oracle("rgbd/odometry_information", information_of, raws, camera, pose)
    information = compute_odometry_information_matrix(*raws, camera, pose, 0.07)
    assert np.abs(information - expected).max() < 2e-3 * np.abs(expected).max()


def test_a_blank_pair_fails_where_open3d_reports_success(device):
    image = loom.RGBDImage(np.zeros((120, 160, 3), np.uint8), np.zeros((120, 160), np.uint16), device=device)
    result = open3d_odometry(image, image, CAMERA, np.eye(4), RGBDOdometryJacobianFromHybridTerm(), OdometryOption())
    assert not result.reliable and "no pixels correspond" in result.warnings[0]
