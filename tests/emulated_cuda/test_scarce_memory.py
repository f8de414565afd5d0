"""Memory that runs out at any allocation of an operation: a named error, what there was is as before, and goes on."""

import numpy as np
import pytest

import pointloom as loom

from ..small_scenes import digest
from .scarce_memory import failing_allocation

POINTS = np.random.default_rng(0).random((300, 3)).astype(np.float32)
NORMALS = (POINTS - 0.5) / np.linalg.norm(POINTS - 0.5, axis=1, keepdims=True)
SPHERE = (0.5 + 0.4 * NORMALS).astype(np.float32)
SDF = np.linalg.norm(np.indices((9, 9, 9)).reshape(3, -1) - 4.0, axis=0).reshape(9, 9, 9).astype(np.float32) - 3
CAMERA = loom.PinholeCameraIntrinsic(24, 18, 20.0, 20.0, 12.0, 9.0)
DEPTHS = [np.full(size, depth, np.float32) for size, depth in (((18, 24), 0.8), ((36, 48), 0.9))]
LARGER = loom.PinholeCameraIntrinsic(48, 36, 40.0, 40.0, 24.0, 18.0)  # its first frame needs arrays of its size


def cloud(**channels) -> loom.PointCloud:
    return loom.PointCloud(SPHERE, device="cuda:0", **channels)


def state_of(thing) -> str:
    """The digest of a result or an input. A volume's is that of its surface and its number of blocks."""
    is_volume = isinstance(thing, loom.TSDFVolume)
    return digest([thing.block_count, thing.extract_point_cloud()] if is_volume else thing)


def fused() -> loom.TSDFVolume:
    volume = loom.TSDFVolume(voxel_size=0.05, color=False, device="cuda:0")
    volume.integrate(DEPTHS[0], CAMERA, np.eye(4))
    return volume


def icp(target):
    method = loom.registration.TransformationEstimationPointToPlane()
    moved = loom.PointCloud(SPHERE + np.float32(0.01), device="cuda:0")
    result = loom.registration.registration_icp(moved, target, 0.2, estimation_method=method)
    return [result.transformation, result.correspondence_set]


SEARCHES = ("estimate_normals", "poisson")  # go on with less scratch
# what there is before, and the operation on it
OPERATIONS = {
    "voxel_down_sample": (cloud, lambda c: c.voxel_down_sample(0.1)),
    "estimate_normals": (cloud, lambda c: c.estimate_normals(max_nn=8)),
    "cluster_dbscan": (cloud, lambda c: c.cluster_dbscan(0.1, 4)),
    "registration_icp": (lambda: cloud(normals=NORMALS), icp),
    "integrate": (fused, lambda v: [v.integrate(DEPTHS[1], LARGER, np.eye(4)), v][1]),
    "marching_cubes": (lambda: SDF, lambda s: loom.meshing.marching_cubes(s, 0.0, device="cuda:0")),
    "poisson": (
        lambda: cloud(normals=NORMALS),
        lambda c: loom.TriangleMesh.create_from_point_cloud_poisson(c, depth=2),
    ),
}


def goes_on(emulated, number, act, expected) -> bool:
    """Whether an operation goes on in less memory where an allocation fails, to the same result; else it is refused."""
    with failing_allocation(emulated, number) as tried:
        try:
            result = act()
        except MemoryError as error:
            assert "cuda:0 has no room" in str(error)
            assert tried.count == number, "nothing goes on after it"
            return False
    assert tried.count > number, "what it did without was not needed"
    assert state_of(result) == expected
    return True


@pytest.mark.parametrize("name", OPERATIONS)
def test_at_every_allocation_memory_may_run_out_and_nothing_is_lost(emulated, name):
    make, act = OPERATIONS[name]
    before = make()
    with failing_allocation(emulated) as allocated:
        result = act(before)
    expected = state_of(result)
    assert allocated.count
    for number in range(1, allocated.count + 1):
        before = make()
        state = state_of(before)
        if goes_on(emulated, number, lambda: act(before), expected):  # noqa: B023  at once
            assert name in SEARCHES
            continue
        if isinstance(before, loom.TSDFVolume) and before.frame_count == 2:
            assert state_of(before) == expected  # it ran out once the frame was in
            continue
        assert state_of(before) == state
        if name != "poisson" or number % 20 == 1:  # it has 200 allocations, and leaves the cloud alone
            assert state_of(act(before)) == expected
