"""Sums over points and over pairs of points against NumPy."""

import numpy as np
from scipy.spatial.transform import Rotation

from pointloom.kernels.lang import int64, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.poses.point_sums import count_agreeing, position_moments
from pointloom.kernels.search.nearest_point import NO_POINT


def test_moments_are_the_sums_of_coordinates_and_their_products(device, rng):
    points, origin = rng.normal(size=(300, 3)).astype(np.float32), np.array([10.0, -20.0, 30.0])
    x, y, z = (points.astype(float) + origin).T
    expected = [np.sum(a) for a in (x**0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)]
    np.testing.assert_allclose(position_moments(upload(points, vec3, device), origin), expected, rtol=1e-12)


def test_pairs_agree_where_two_poses_bring_them_within_the_distance(device, rng):
    count = 300
    source, target = rng.random((2, count, 3)).astype(np.float32)
    rows, distances = rng.permutation(count), rng.random(count).astype(np.float32)
    keys = (distances.view(np.int32).astype(np.int64) << 32) | rows
    keys[::7] = NO_POINT
    origins, poses = rng.random((2, 3)), np.tile(np.eye(4), (2, 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = Rotation.random(2, rng=rng).as_matrix(), rng.random((2, 3))
    a, b = (p.astype(float) + o for p, o in zip((source, target), origins, strict=True))
    a, b = (p @ T[:3, :3].T + T[:3, 3] for p, T in zip((a, b), poses, strict=True))
    is_pair = keys != NO_POINT
    gaps = np.linalg.norm(a - b[rows], axis=1)
    limit = float(np.median(gaps[is_pair]))
    arrays = upload(source, vec3, device), upload(target, vec3, device), upload(keys, int64, device)
    counts = download(count_agreeing(*arrays, tuple(origins), tuple(poses), limit + 1e-9))
    assert np.asarray(counts).reshape(-1).tolist() == [is_pair.sum(), (gaps[is_pair] <= limit + 1e-9).sum()]
