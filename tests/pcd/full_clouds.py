"""Clouds with all kinds of attributes, and their comparison."""

import numpy as np

import pointloom as loom

UTM = np.array([5.01234e5, 5.412345e6, 212.5])
EXTRAS = ("ring", "time", "label", "pair", "half", "flag")


def full_cloud(rng, device, count=200, shift=0.0):
    """A cloud with normals, colors and attributes of many types."""
    normals = rng.normal(size=(count, 3))
    return loom.PointCloud(
        rng.random((count, 3)) * 10 + shift,
        normals=normals / np.linalg.norm(normals, axis=1, keepdims=True),
        colors=rng.random((count, 3)),
        device=device,
        ring=rng.integers(0, 64, count).astype(np.uint8),
        time=rng.random(count) + 1.7e9,
        label=rng.integers(-(2**31), 2**31, count).astype(np.int32),
        pair=rng.random((count, 2)).astype(np.float32),
        half=rng.random(count).astype(np.float16),
        flag=rng.random(count) < 0.5,
    )


def contents(cloud):
    names = ["points", *(n for n in ("normals", "colors") if n in cloud), *cloud.attributes]
    return {n: cloud.arrays[n].numpy().copy() for n in names} | {"origin": cloud.origin, "grid": cloud.grid}


def assert_same(left, right):
    assert list(left) == list(right)
    for name, values in left.items():
        if name != "grid":
            assert values.dtype == right[name].dtype, name
        np.testing.assert_array_equal(values, right[name], err_msg=name)


def rigid(rng, shift=1.0):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = q if np.linalg.det(q) > 0 else -q, rng.normal(size=3) * shift
    return T
