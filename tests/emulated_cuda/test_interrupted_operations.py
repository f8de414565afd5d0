"""An operation whose recording is interrupted, at any launch in it, leaves the device and its owner as they were."""

import contextlib
from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.language import device_lock

from ..small_scenes import ON_CLOUDS, ONCE, digest

CAMERA = loom.PinholeCameraIntrinsic(24, 18, 20.0, 20.0, 12.0, 9.0)
RECORDED = ("icp, point to plane", "icp, generalized", "registration_icp_batch, three poses")
RECORDED_ONCE = (
    *("iterate_odometry", "mesh, deform_as_rigid_as_possible", "ransac, features"),
    *("rgbd odometry", "icp, colored"),
)


@contextlib.contextmanager
def interrupted_recording(device, number: int | None = None, error: type = KeyboardInterrupt) -> Iterator:
    """Count the launches that are recorded in here; the one of this number, from 1 on, does not come about."""
    core, launches = wp._src.context.runtime.core, SimpleNamespace(count=0)
    real = core.wp_cuda_launch_kernel

    def launch(*arguments):
        if device.streams.captures:
            launches.count += 1
            if launches.count == number:
                raise error("in the recording")
        return real(*arguments)

    core.wp_cuda_launch_kernel = launch
    try:
        yield launches
    finally:
        core.wp_cuda_launch_kernel = real


def check(emulated, run) -> None:
    def work() -> object:
        loom.free_memory()  # and recordings that are kept for further calls
        return run()

    expected = digest(work())
    with interrupted_recording(emulated) as recorded:
        assert digest(work()) == expected
    assert recorded.count, "it records nothing"
    for number, error in ((1, KeyboardInterrupt), (recorded.count, MemoryError)):
        with interrupted_recording(emulated, number, error), pytest.raises(error, match="in the recording"):
            digest(work())  # some of a result is worked out when it is read
        assert emulated.streams.captures == 0
        assert device_lock.lock.acquire(blocking=False)
        device_lock.lock.release()
        assert digest(work()) == expected


@pytest.mark.parametrize("operation", RECORDED)
def test_an_interrupted_operation_on_clouds_is_as_if_it_had_not_begun(emulated, small, operation):
    check(emulated, lambda: ON_CLOUDS[operation](small.surface))


@pytest.mark.slow
@pytest.mark.parametrize("operation", RECORDED_ONCE)
def test_an_interrupted_operation_on_scenes_is_as_if_it_had_not_begun(emulated, small, operation):
    check(emulated, lambda: ONCE[operation](small))


@pytest.mark.parametrize("error", [KeyboardInterrupt, MemoryError])
@pytest.mark.parametrize("number", [1, 3])
def test_a_volume_whose_recording_is_interrupted_takes_the_frame_again(emulated, error, number):
    depths = [np.full((18, 24), depth, np.float32) for depth in (0.8, 0.81, 0.82, 0.83)]

    def fuse(broken: bool) -> str:
        volume = loom.TSDFVolume(voxel_size=0.05, color=False, device="cuda:0")
        for k, depth in enumerate(depths):
            if broken:
                frames = volume.frame_count
                with interrupted_recording(emulated, number, error), contextlib.suppress(error):
                    volume.integrate(depth, CAMERA, np.eye(4))
                if volume.frame_count > frames:
                    continue  # it records nothing for this one
            volume.integrate(depth, CAMERA, np.eye(4))
            assert volume.frame_count == k + 1
        return digest([volume.extract_point_cloud(), volume.block_count])

    assert fuse(True) == fuse(False)
