"""The voxel map against the same rules written out in NumPy: what it keeps, what it finds, however far it has gone."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import launch, vec3, vec3d, vec4
from pointloom.kernels.memory import empty, upload
from pointloom.kernels.odometry.voxel_map import VoxelMap

from ...registration.poses import as_pose

ROOM = 4
SEARCH = """
from pointloom.kernels.odometry.voxel_map import VoxelMap
from pointloom.kernels.odometry.voxel_map_search import find_nearest_in_map

@kernel
def search_map_kernel(queries: array(dtype=vec3d), limit: float, voxel_map: VoxelMap, found: array(dtype=vec4)):
    i = tid()
    answer = find_nearest_in_map(queries[i], limit, voxel_map)
    found[i] = vec4(float(answer[0]), float(answer[1]), float(answer[2]), float(answer[3]))
"""


@pytest.fixture(scope="module")
def search(write_kernels):
    """A function (map, queries, limit) -> [n, 4]: the vectors from the nearest points, and their squares."""
    module = write_kernels("voxel_map_search", SEARCH)

    def run(voxel_map, queries, limit):
        result = empty(len(queries), vec4, voxel_map.device)
        arguments = [upload(queries, vec3d, voxel_map.device), limit, voxel_map, result]
        launch(module.search_map_kernel, len(queries), arguments)
        return result.numpy()

    return run


def make_map(device, size=1.0, room=ROOM):
    return VoxelMap(size, room, resolve_device(device))


def add(voxel_map, points, pose=None, max_range=60.0):
    voxel_map.add(upload(points, vec3, voxel_map.device), np.eye(4) if pose is None else pose, max_range)


def content(voxel_map) -> dict[tuple[int, ...], list[list[float]]]:
    keys = voxel_map.keys.numpy()[: voxel_map.count]
    counts, offsets = voxel_map.counts.numpy(), voxel_map.offsets.numpy().reshape(-1, 3)
    mask, bias = (1 << 21) - 1, 1 << 20
    contents = {}
    for i, key in enumerate(keys.tolist()):
        cell = tuple(((key >> shift) & mask) - bias for shift in (42, 21, 0))
        contents[cell] = offsets[i * voxel_map.room : i * voxel_map.room + counts[i]].tolist()
    return contents


def keep(expected, points, pose, size, room) -> None:
    """The rule: a voxel stores points in order, while it has room and none is near."""
    spacing = np.float32(size * size / room)
    for p in points[np.isfinite(points).all(axis=1)].astype(np.float64):
        x = np.array([pose[k, 0] * p[0] + pose[k, 1] * p[1] + pose[k, 2] * p[2] + pose[k, 3] for k in range(3)])
        cell = np.floor(x / size)
        offset = (x - cell * size).astype(np.float32)
        others = expected.setdefault(tuple(int(c) for c in cell), [])
        gaps = [offset - np.array(q, np.float32) for q in others]
        if len(others) < room and all(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] >= spacing for d in gaps):
            others.append(offset.tolist())


def lattice_or_any(count):
    """Clouds with many points at one place, on faces of voxels, and some that are no numbers."""
    number = st.one_of(st.integers(-6, 6).map(lambda v: v / 2), st.floats(-5, 5, width=32), st.just(np.nan))
    return hnp.arrays(np.float32, st.tuples(st.integers(0, count), st.just(3)), elements=number)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(lattice_or_any(25), lattice_or_any(25), st.sampled_from([0.5, 1.0, 3.0]))
def test_a_voxel_keeps_the_first_points_that_are_apart(device, first, second, size):
    voxel_map, expected = make_map(device, size), {}
    for points in (first, second, first):
        pose = as_pose(shift=[len(points) * 0.25] * 3)
        add(voxel_map, points, pose)
        keep(expected, points, pose, size, ROOM)
    assert content(voxel_map) == expected


def test_a_cloud_and_a_pose_are_stored_by_the_rule(device, rng):
    voxel_map, expected = make_map(device, 1.0, 20), {}
    for _ in range(3):
        pose = as_pose(rng.normal(0, 1, 3), rng.normal(0, 5, 3))
        points = rng.normal(0, 6, (3000, 3)).astype(np.float32)
        add(voxel_map, points, pose)
        keep(expected, points, pose, 1.0, 20)
    assert content(voxel_map) == expected
    assert voxel_map.count > 1024  # it has grown


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(lattice_or_any(40), lattice_or_any(10), st.sampled_from([0.3, 1.0, 50.0]))
def test_the_nearest_point_of_27_voxels_is_returned(device, search, tolerances, points, queries, limit):
    voxel_map, expected = make_map(device), {}
    add(voxel_map, points)
    keep(expected, points, np.eye(4), 1.0, ROOM)
    queries = queries[np.isfinite(queries).all(axis=1)].astype(np.float64)
    result = search(voxel_map, queries, limit)
    for query, neighbor in zip(queries, result, strict=True):
        cell = np.floor(query)
        near = [np.add(c, p) for c, offsets in expected.items() if np.abs(cell - c).max() <= 1 for p in offsets]
        best = min((float(((query - p) ** 2).sum()) for p in near), default=np.inf)
        if abs(best - limit) < 1e-5:
            continue
        if best > limit:
            assert neighbor[3] >= np.float32(limit)
        else:
            np.testing.assert_allclose(neighbor[3], best, rtol=tolerances.sqdist_relative, atol=1e-6)
            assert min(np.abs(query - neighbor[:3] - p).max() for p in near) < 1e-6


def test_far_from_the_start_it_is_the_same_to_the_bit(device, search, rng):
    points, queries = rng.uniform(-8, 8, (2000, 3)).astype(np.float32), rng.uniform(-8, 8, (300, 3))
    shift = np.array([2.0**19, -(2.0**18), 4096.0])
    points, queries = np.round(points * 2**10) / 2**10, np.round(queries * 2**10) / 2**10  # exact at both positions
    near, far = make_map(device), make_map(device)
    add(near, points)
    add(far, points, as_pose(shift=shift))
    np.testing.assert_array_equal(search(near, queries, 9.0), search(far, queries + shift, 9.0))
    points, origin = far.points(shift)
    np.testing.assert_array_equal(origin, shift)
    np.testing.assert_array_equal(points.numpy(), near.points(np.zeros(3))[0].numpy())


def test_far_voxels_are_removed_and_near_ones_stay(device, search, rng):
    points = rng.uniform(-20, 20, (4000, 3)).astype(np.float32)
    voxel_map = make_map(device)
    add(voxel_map, points)
    before = content(voxel_map)
    center = np.array([3.0, -2.0, 1.0])
    voxel_map = voxel_map.without_far(center, 12.0)
    remaining = {c: p for c, p in before.items() if np.linalg.norm(np.array(c) + 0.5 - center) <= 12}
    assert 0 < len(remaining) < len(before) and content(voxel_map) == remaining
    queries = np.array([np.add(c, p[0]) for c, p in before.items()])
    assert ((search(voxel_map, queries, 1e-6)[:, 3] < 1e-6) == [c in remaining for c in before]).all()
    add(voxel_map, points)  # what was dropped comes back, what stayed is full already
    after = content(voxel_map)
    assert {c: p for c, p in after.items() if c in remaining} == {c: after[c] for c in remaining}
    assert set(after) == set(before)


def test_an_empty_map_finds_nothing(device, search):
    voxel_map = make_map(device)
    add(voxel_map, np.zeros((0, 3), np.float32))
    add(voxel_map, np.full((5, 3), np.nan, np.float32))
    voxel_map = voxel_map.without_far(np.zeros(3), 1.0)
    assert voxel_map.count == 0 and voxel_map.points(np.zeros(3))[0].size == 0
    assert search(voxel_map, np.zeros((2, 3)), 4.0)[:, 3].tolist() == [4.0, 4.0]


def test_a_path_beyond_its_keys_is_refused(device):
    with pytest.raises(ValueError, match="voxel_size:"):
        add(make_map(device), np.zeros((1, 3), np.float32), as_pose(shift=[2e6, 0, 0]))
