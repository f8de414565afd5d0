"""Depth compared with other images, and fused pixels, against the same arithmetic in float64 NumPy."""

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.memory import download, upload
from pointloom.kernels.stereo.depth_checks import SAME_SURFACE, DepthChecks
from pointloom.kernels.stereo.depth_fusion import Agreement, DepthPixels, Gathered, gather_pixels, make_points
from pointloom.photogrammetry.mvs.depth_maps import DepthMap
from pointloom.photogrammetry.mvs.filtering import pair_of

from ...photogrammetry.mvs.made_maps import cameras, true_map

HALF = 0.5


def seen(p, lens):
    """Column, row and inverse depth of points in a camera's frame; inverse depth 0 outside the image."""
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
    """Counts, totals and kept depth of image i, on a device."""
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


@pytest.mark.parametrize("bad", [1e-38, 1e-30, 1e30, 3e38])
def test_depth_of_any_magnitude_gives_finite_results(device, bad):
    posed = cameras(2)
    depths = [np.full(true_map(camera).depth.shape, bad, np.float32) for camera in posed]
    _, totals, filtered = checked(depths, posed, 0, [1], device)
    assert np.isfinite(totals).all() and np.isfinite(filtered).all()


def uploaded(each, color, device):
    return DepthPixels(
        upload(each.depth.reshape(-1), wp.float32, device),
        upload(each.normals.reshape(-1, 3), wp.vec3, device),
        upload(each.confidence.reshape(-1), wp.float32, device),
        upload(color.reshape(-1, 3), wp.uint8, device),
    )


def fused(maps, posed, colors, i, device, min_views=1, angle=30.0):
    """Arrays, kept and beaten pixels of image i beside all others."""
    limits = Agreement(2.0, 0.01, np.cos(np.radians(angle)))
    pixels = [uploaded(*given, device) for given in zip(maps, colors, strict=True)]
    gathered = Gathered(maps[i].depth.size, device)
    for j in range(len(maps)):
        if j != i:
            gather_pixels(pixels[i], pixels[j], pair_of(posed[i], posed[j]), limits, j < i, gathered)
    T = np.linalg.inv(posed[i].T_camera_world)
    arrays, selected = make_points(pixels[i], posed[i].intrinsic, T, min_views, gathered)
    shape = maps[i].depth.shape
    result = {k: download(v).reshape(*shape, -1) for k, v in zip("pncqv", arrays, strict=True)}
    return result, download(selected).reshape(shape) > 0, download(gathered.beaten).reshape(shape) > 0


def noisy(posed, rng):
    maps, colors = [], []
    for camera in posed:
        each = true_map(camera)
        depth = each.depth * (1 + 0.003 * rng.normal(size=each.depth.shape))
        depth[rng.random(depth.shape) < 0.1] = 0
        maps.append(DepthMap(depth, each.normals, rng.random(depth.shape)))
        colors.append(rng.integers(0, 256, (*depth.shape, 3)).astype(np.uint8))
    return maps, colors


def met_pixel(x, y, d, pair, T_source_reference):
    """The source's nearest pixel to what a pixel shows."""
    u, v, _ = seen(np.array(moved(T_source_reference, lifted(x, y, d, pair.reference))), pair.source)
    return int(np.floor(v + HALF)), int(np.floor(u + HALF))


def octave(depth, lens):
    return np.frexp(np.float32(np.float64(depth) / lens.fx))[1]


def test_fused_points_are_means_of_the_agreeing_pixels(device, rng):
    posed = cameras(3)
    maps, colors = noisy(posed, rng)
    result, _, beaten = fused(maps, posed, colors, 1, device)
    reference_map, views = maps[1], np.ones(maps[1].depth.shape, int)
    color, sure = colors[1].astype(float), reference_map.confidence.astype(float)
    z, lost = reference_map.depth.astype(float), np.zeros(reference_map.depth.shape, bool)
    for j in (0, 2):
        pair, T_source_reference = relation(posed[1], posed[j])
        agree, inverse = oracle(reference_map.depth, maps[j].depth, pair, T_source_reference, 2.0, 0.01)
        rotation = posed[1].T_camera_world[:3, :3] @ posed[j].T_camera_world[:3, :3].T
        for y, x in np.argwhere(agree > 0):
            at = met_pixel(x, y, float(reference_map.depth[y, x]), pair, T_source_reference)
            if reference_map.normals[y, x] @ rotation @ maps[j].normals[at] < np.cos(np.radians(30)):
                continue
            views[y, x] += 1
            color[y, x] += colors[j][at]
            sure[y, x] += maps[j].confidence[at]
            z[y, x] += 1 / inverse[y, x]
            ranks = octave(maps[j].depth[at], pair.source), octave(reference_map.depth[y, x], pair.reference)
            lost[y, x] |= ranks[0] < ranks[1] or (ranks[0] == ranks[1] and j == 0)
    left = (reference_map.depth > 0) & ~lost
    assert 0.1 < left.mean() < 0.9
    np.testing.assert_array_equal(beaten, lost)
    np.testing.assert_array_equal(result["v"][left, 0], views[left])
    np.testing.assert_allclose(result["c"][left], (color / views[..., None] / 255)[left], rtol=1e-5, atol=1e-7)
    np.testing.assert_allclose(result["q"][left, 0], (sure / views)[left], rtol=1e-5)
    depth = result["p"] @ posed[1].T_camera_world[2, :3] + posed[1].T_camera_world[2, 3]
    np.testing.assert_allclose(depth[left], (z / views)[left], rtol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(result["n"][left], axis=1), 1, rtol=1e-6)


@pytest.mark.parametrize("near", [0, 1])
def test_the_image_with_the_finest_pixels_makes_the_point(device, near):
    """Two cameras on one axis before a wall, one at a third of the other's distance."""
    lens = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    poses = [np.eye(4), np.eye(4)]
    poses[near][2, 3] = -2.0  # the wall is 3 m from the other and 1 m from this one
    posed = [loom.photogrammetry.PosedCamera(lens, T) for T in poses]
    maps = [true_map(camera, balls=()) for camera in posed]
    colors = [np.zeros((24, 32, 3), np.uint8)] * 2
    selected = [fused(maps, posed, colors, i, device)[1] for i in (0, 1)]
    assert selected[near].all()
    assert not selected[1 - near][10:14, 13:19].any()  # what both see
    assert selected[1 - near][0].all()


def test_surfaces_that_face_elsewhere_do_not_merge(device):
    posed = cameras(2)
    maps, colors = [true_map(camera, balls=()) for camera in posed], []
    rotated = DepthMap(maps[1].depth, maps[1].normals[..., [1, 2, 0]], maps[1].confidence)
    colors = [np.zeros((*each.depth.shape, 3), np.uint8) for each in maps]
    assert fused(maps, posed, colors, 0, device)[0]["v"].max() == 2
    assert fused([maps[0], rotated], posed, colors, 0, device)[0]["v"].max() == 1
    bare = DepthMap(maps[1].depth, 0 * maps[1].normals, maps[1].confidence)
    assert fused([maps[0], bare], posed, colors, 0, device)[0]["v"].max() == 2
