"""Depth held against that of other pictures, beside the same arithmetic in NumPy's float64."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels.memory import download, upload
from pointloom.kernels.stereo.depth_checks import SAME_SURFACE, DepthChecks
from pointloom.photogrammetry.mvs.filtering import pair_of

from ...photogrammetry.mvs.made_maps import cameras, true_map

HALF = 0.5


def seen(p, lens):
    """Column, row and inverse depth of points in a camera's frame; inverse depth 0 outside the picture."""
    with np.errstate(all="ignore"):
        u, v = lens.fx * p[0] / p[2] + lens.cx, lens.fy * p[1] / p[2] + lens.cy
        inside = (p[2] > 0) & (u >= -HALF) & (v >= -HALF) & (u < lens.width - HALF) & (v < lens.height - HALF)
        return np.where(inside, (u, v, 1 / p[2]), 0.0)


def moved(T, p):
    """R p + t, each row summed from the left."""
    return [T[k, 0] * p[0] + T[k, 1] * p[1] + T[k, 2] * p[2] + T[k, 3] for k in range(3)]


def lifted(u, v, z, lens):
    return [(u - lens.cx) * z / lens.fx, (v - lens.cy) * z / lens.fy, z]


def surface(u, v, depth):
    """The surface at one place: bilinear inverse depth between pixels of one surface, else the nearest pixel's."""
    iu, iv = int(np.floor(u + HALF)), int(np.floor(v + HALF))
    d = float(depth[iv, iu])
    if not d > 0:
        return iu, iv, 0.0
    w, left, top = 1 / d, int(np.floor(u)), int(np.floor(v))
    if left < 0 or top < 0 or left + 1 >= depth.shape[1] or top + 1 >= depth.shape[0]:
        return iu, iv, w
    s, t, total = u - left, v - top, 0.0
    for k in range(4):
        e = float(depth[top + k // 2, left + k % 2])
        if not e > 0 or abs(1 / e - w) > SAME_SURFACE * w:
            return iu, iv, w
        total += (1 / e) * (s if k % 2 else 1 - s) * (t if k // 2 else 1 - t)
    return u, v, total


def relation(reference, source):
    return pair_of(reference, source), source.T_camera_world @ np.linalg.inv(reference.T_camera_world)


def oracle(depth, source_depth, pair, T_source_reference, max_pixels, max_relative):
    """Which pixels a source confirms, and its inverse depths there, pixel by pixel."""
    counts, totals, back = np.zeros(depth.shape, np.int32), np.zeros(depth.shape), np.linalg.inv(T_source_reference)
    for y, x in np.argwhere(depth > 0):
        d = float(depth[y, x])
        u, v, w = seen(np.array(moved(T_source_reference, lifted(x, y, d, pair.reference))), pair.source)
        if not w > 0:
            continue
        at = surface(u, v, source_depth)
        if not at[2] > 0:
            continue
        z = 1 / at[2]
        q = seen(np.array(moved(back, lifted(at[0], at[1], z, pair.source))), pair.reference)
        near = (q[0] - x) * (q[0] - x) + (q[1] - y) * (q[1] - y) <= max_pixels * max_pixels
        if q[2] > 0 and near and abs(q[2] - 1 / d) <= max_relative * (1 / d):
            counts[y, x], totals[y, x] = 1, q[2]
    return counts, totals


def checked(depths, posed, i, others, device, max_pixels=1.0, max_relative=0.01):
    """Counts, totals and kept depth of picture i, on a device."""
    arrays = [upload(depth.reshape(-1), wp.float32, device) for depth in depths]
    checks = DepthChecks(arrays[i], max_pixels, max_relative)
    for j in others:
        checks.compare(arrays[j], pair_of(posed[i], posed[j]))
    sure = upload(np.ones(depths[i].size, np.float32), wp.float32, device)
    shape = depths[i].shape
    return [download(a).reshape(shape).copy() for a in (checks.counts, checks.totals, checks.mean(1, sure, 0.0))]


@pytest.mark.parametrize("limits", [(1.0, 0.01), (0.04, 1.0)], ids=["depth decides", "pixels decide"])
def test_counts_and_sums_are_bitwise_identical_to_float64(device, rng, limits):
    posed = cameras(2)
    depths = []
    for camera in posed:
        depth = true_map(camera).depth * (1 + 0.006 * rng.normal(size=true_map(camera).depth.shape))
        depth[rng.random(depth.shape) < 0.1] = 0
        depths.append(depth.astype(np.float32))
    counts, totals, _ = checked(depths, posed, 0, [1], device, *limits)
    expected = oracle(*depths, *relation(*posed), *limits)
    assert 0.3 < expected[0].mean() < 0.9  # both answers occur
    np.testing.assert_array_equal(counts, expected[0])
    np.testing.assert_array_equal(totals, expected[1])


def test_a_plane_is_recovered_exactly(device):
    """Inverse depth is linear over a plane, so values between pixels are exact too."""
    posed = cameras(3)
    depths = [true_map(camera, balls=()).depth for camera in posed]
    counts, _, filtered = checked(depths, posed, 1, [0, 2], device, max_pixels=1e-3, max_relative=1e-6)
    inside = (slice(4, -4), slice(12, -12))
    assert (counts[inside] == 2).all()
    np.testing.assert_allclose(filtered[inside], depths[1][inside], rtol=3e-7)


@pytest.mark.parametrize("wrong", [0.9, 0.985, 1.015, 1.3])
def test_planted_wrong_depth_is_refused_and_all_else_stays(device, wrong, rng):
    posed = cameras(2)
    depths = [true_map(camera, balls=()).depth.copy() for camera in posed]
    _, _, before = checked(depths, posed, 0, [1], device, max_pixels=0.5)
    planted = rng.random(depths[0].shape) < 0.05
    depths[0][planted] *= wrong
    _, _, after = checked(depths, posed, 0, [1], device, max_pixels=0.5)
    assert not after[planted].any()
    np.testing.assert_array_equal(after[~planted], before[~planted])


def test_occluded_pixels_are_not_confirmed(device):
    """The wall beside the ball: the other camera sees the ball there."""
    posed = cameras(2, step=0.6)
    depths = [true_map(camera).depth for camera in posed]
    counts, _, _ = checked(depths, posed, 0, [1], device)
    pair, T_source_reference = relation(*posed)
    v, u = np.mgrid[: depths[0].shape[0], : depths[0].shape[1]]
    z = depths[0].astype(np.float64)
    p = np.array(moved(T_source_reference, lifted(u, v, z, pair.reference)))
    column, row, w = seen(p, pair.source)
    nearest = depths[1][np.rint(row).astype(int), np.rint(column).astype(int)]
    hidden = (w > 0) & (nearest < 0.9 / np.where(w > 0, w, 1))
    assert hidden.sum() > 20
    assert not counts[hidden].any()


@pytest.mark.parametrize("bad", [1e-38, 1e-30, 1e30, 3e38])
def test_depth_of_any_magnitude_gives_finite_results(device, bad):
    posed = cameras(2)
    depths = [np.full(true_map(camera).depth.shape, bad, np.float32) for camera in posed]
    _, totals, filtered = checked(depths, posed, 0, [1], device)
    assert np.isfinite(totals).all()
    assert np.isfinite(filtered).all()
