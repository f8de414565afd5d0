"""Which of the pixels that meet makes the point, and what it takes in, beside a slow float64 form."""

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.memory import download, upload
from pointloom.kernels.stereo.depth_fusion import Agreement, DepthPixels, Gathered, gather_pixels, make_points
from pointloom.photogrammetry.mvs.depth_maps import DepthMap
from pointloom.photogrammetry.mvs.filtering import pair_of

from ...photogrammetry.mvs.made_maps import cameras, true_map
from .test_depth_checks import lifted, moved, oracle, relation, seen

HALF = 0.5


def uploaded(each, color, device):
    return DepthPixels(
        upload(each.depth.reshape(-1), wp.float32, device),
        upload(each.normals.reshape(-1, 3), wp.vec3, device),
        upload(each.confidence.reshape(-1), wp.float32, device),
        upload(color.reshape(-1, 3), wp.uint8, device),
    )


def fused(maps, posed, colors, i, device, min_views=1, angle=30.0):
    """Arrays, kept and beaten pixels of picture i beside all others."""
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


def test_of_two_pixels_that_meet_only_one_makes_a_point(device, rng):
    posed = cameras(4)
    maps, colors = noisy(posed, rng)
    selected = [fused(maps, posed, colors, i, device)[1] for i in range(4)]
    both = 0
    for i in range(4):
        for j in range(4):
            if i == j:
                continue
            pair, T_source_reference = relation(posed[i], posed[j])
            agree, _ = oracle(maps[i].depth, maps[j].depth, pair, T_source_reference, 2.0, 0.01)
            rotation = posed[i].T_camera_world[:3, :3] @ posed[j].T_camera_world[:3, :3].T
            for y, x in np.argwhere((agree > 0) & selected[i]):
                at = met_pixel(x, y, float(maps[i].depth[y, x]), pair, T_source_reference)
                if selected[j][at] and maps[i].normals[y, x] @ rotation @ maps[j].normals[at] > np.cos(np.radians(29)):
                    ranks = octave(maps[j].depth[at], pair.source), octave(maps[i].depth[y, x], pair.reference)
                    both += ranks[0] < ranks[1] or (ranks[0] == ranks[1] and j < i)
    assert both == 0


@pytest.mark.parametrize("near", [0, 1])
def test_the_image_with_the_finest_pixels_makes_the_point(device, near):
    """Two cameras on one axis before a wall, one at a third of the other's distance."""
    lens = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
    poses = [np.eye(4), np.eye(4)]
    poses[near][2, 3] = -2.0  # the wall is 3 m from the other and 1 m from this one
    posed = [loom.mvs.PosedCamera(lens, T) for T in poses]
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
