"""PatchMatch and plane priors: exact planes, costs of shifted patches, hidden sources, textureless regions."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from pointloom.kernels.lang import launch, uint8, uint64, vec2, vec4
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.stereo.brightness import MAX_PACKED_LEVEL, resize_brightness_kernel
from pointloom.kernels.stereo.inverse_planes import refine_planes_kernel
from pointloom.kernels.stereo.patch_costs import MAX_PATCH_COST, Reference, Sources, patch_on
from pointloom.kernels.stereo.patch_match import HalfIteration, spread_planes, start_planes
from pointloom.kernels.stereo.plane_results import finish_planes
from pointloom.kernels.stereo.region_planes import judge_pixels, take_priors
from pointloom.kernels.stereo.textureless_regions import find_regions


def as_blocks(levels: np.ndarray) -> np.ndarray:
    """Pixels [h, w], the ones to the right, below, and opposite, with a repeated border, [h, w, 4]."""
    height, width = levels.shape
    padded = np.pad(levels, ((0, 1), (0, 1)), mode="edge")
    return np.stack([padded[k // 2 :, k % 2 :][:height, :width] for k in range(4)], -1)


def stored(images: Sequence[np.ndarray], device: str) -> Any:
    levels = [np.round(np.clip(each, 0, 1) * MAX_PACKED_LEVEL).astype(np.uint16) for each in images]
    return upload(np.concatenate([as_blocks(each).reshape(-1) for each in levels]).view(np.uint64), uint64, device)


WIDTH, HEIGHT, FOCAL, BASELINE = 40, 30, 40.0, 0.2
LENS = (FOCAL, FOCAL, 19.5, 14.5)
PATCH = np.array([(u, v) for v in range(-5, 6, 2) for u in range(-5, 6, 2) if u * u + v * v < 50])  # [px]
STEREO = FOCAL * BASELINE
SHIFT = 4  # [px] at inverse depth SHIFT / STEREO = 0.5


def resized(pixels: np.ndarray, width: int, height: int, device: str) -> np.ndarray:
    out = empty(width * height, uint64, device)
    channels = 3 if pixels.ndim == 3 else 1
    rows, columns = pixels.shape[:2]
    flat = upload(pixels.reshape(-1), uint8, device)
    launch(resize_brightness_kernel, width * height, [flat, channels, columns, rows, width, height, 0, out])
    blocks = download(out).view(np.uint16).reshape(height, width, 4) / MAX_PACKED_LEVEL
    np.testing.assert_array_equal(blocks, as_blocks(blocks[..., 0]))
    return blocks[..., 0]


def views_of(images: Sequence[np.ndarray], lens: tuple[float, ...], patch: np.ndarray, device: str):
    """A reference, and sources at the baseline with maps of inverse depth 0.5."""
    width, count = images[0].shape[1], len(images) - 1
    there, back = (np.column_stack([np.eye(3), [x, 0.0, 0.0]])[None].repeat(count, 0) for x in (-STEREO, STEREO))
    layout = [(width, HEIGHT, (1 + k) * width * HEIGHT) for k in range(count)]
    maps = upload(np.tile(np.float32([0.5, 0, 0, 0]), (width * HEIGHT, 1)), vec4, device)
    sources = Sources(there, there, back, layout, [(width, HEIGHT, 0)] * count, stored(images, device), maps)
    return Reference(width, HEIGHT, 0, lens, (0.2, 1.0), STEREO, patch_on(patch, device)), sources


def problem(device: str, count: int = 1, hidden: int = -1):
    """An image and sources that see all of it SHIFT pixels to the left; a hidden one shows something else."""
    rng = np.random.default_rng(0)
    wide = rng.random((HEIGHT, WIDTH + SHIFT)).astype(np.float32)
    images = [wide[:, :WIDTH]]
    for k in range(count):
        images.append(rng.random((HEIGHT, WIDTH)).astype(np.float32) if k == hidden else wide[:, SHIFT:])
    return views_of(images, LENS, PATCH, device)


def planes_of(w: float, device: str):
    return upload(np.tile(np.float32([w, 0, 0, 0]), (WIDTH * HEIGHT, 1)), vec4, device)


def costs_of(w: float, device: str, geometric: float = 0.0) -> np.ndarray:
    reference, sources = problem(device)
    given = {"seed": 0, "is_given": True, "geometric": geometric, "chosen": 1}
    costs = start_planes(reference, sources, planes_of(w, device), **given)
    return np.array(download(costs)).reshape(HEIGHT, WIDTH)


def test_a_smaller_image_is_the_mean_of_the_covered_pixels(device):
    rng = np.random.default_rng(1)
    pixels = rng.integers(0, 256, (12, 16), dtype=np.uint8)
    halved = pixels.reshape(6, 2, 8, 2).mean(axis=(1, 3)) / 255
    np.testing.assert_allclose(resized(pixels, 8, 6, device), halved, atol=1e-5)
    np.testing.assert_allclose(resized(pixels, 16, 12, device), pixels / 255, atol=1e-5)
    np.testing.assert_allclose(resized(pixels, 7, 5, device).mean(), pixels.mean() / 255, atol=1e-5)
    color = rng.integers(0, 256, (12, 16, 3), dtype=np.uint8)
    gray = color @ [0.299, 0.587, 0.114] / 255
    np.testing.assert_allclose(resized(color, 16, 12, device), gray, atol=1e-5)


def test_a_plane_is_the_same_plane_in_a_larger_image(device):
    v, u = np.mgrid[:6, :8]
    small = np.stack([0.5 + 0.01 * u - 0.02 * v, *np.broadcast_arrays(0.01, -0.02, u * 0.0)[:3]], -1).reshape(-1, 4)
    planes = empty(16 * 12, vec4, device)
    launch(refine_planes_kernel, 16 * 12, [upload(small, vec4, device), 8, 6, 16, 12, planes])
    result = np.array(download(planes)).reshape(12, 16, 4)
    v, u = (np.mgrid[:12, :16] + 0.5) / 2 - 0.5
    np.testing.assert_allclose(result[..., 0], 0.5 + 0.01 * u - 0.02 * v, atol=1e-6)
    np.testing.assert_allclose(result[..., 1:3].reshape(-1, 2), np.tile([0.005, -0.01], (192, 1)), atol=1e-7)


def test_the_true_plane_costs_nothing_and_others_do(device):
    inside = (slice(6, -6), slice(SHIFT + 6, -6))
    true, wrong = costs_of(SHIFT / STEREO, device), costs_of(0.25, device)
    assert true[inside].max() < 1e-4 and np.median(wrong[inside]) > 0.7
    assert (true[:, :SHIFT] == np.float32(MAX_PATCH_COST)).all()  # seen left of the source


def test_brightness_and_contrast_of_a_source_do_not_matter(device):
    reference, sources = problem(device)
    levels = np.array(download(sources.images)).view(np.uint16)
    source = levels[4 * WIDTH * HEIGHT :]
    source[:] = np.round(0.3 * source + 0.4 * MAX_PACKED_LEVEL)
    sources.images = upload(levels.view(np.uint64), uint64, device)
    planes = planes_of(0.5, device)
    costs = start_planes(reference, sources, planes, seed=0, is_given=True, geometric=0.0, chosen=1)
    assert np.array(download(costs)).reshape(HEIGHT, WIDTH)[6:-6, SHIFT + 6 : -6].max() < 1e-3


def test_the_way_there_and_back_counts_in_pixels(device):
    inside = (slice(6, -6), slice(SHIFT + 6, -6))
    off = 0.5 + 0.5 / STEREO  # half a pixel beside the source's surface
    difference = costs_of(off, device, geometric=0.2) - costs_of(off, device)
    np.testing.assert_allclose(difference[inside], 0.1, atol=1e-4)


def test_planes_converge_despite_an_occluded_source(device):
    reference, sources = problem(device, count=3, hidden=1)
    planes = empty(WIDTH * HEIGHT, vec4, device)
    costs = start_planes(reference, sources, planes, seed=3, is_given=False, geometric=0.0, chosen=2)
    for number in range(4):
        for color in (0, 1):
            iteration = HalfIteration(3, number, color, 8, 4, 2, 0.5 * 0.5**number, 0.0, 0.8)
            spread_planes(iteration, reference, sources, planes, costs)
    result = np.array(download(planes)).reshape(HEIGHT, WIDTH, 4)[4:-4, SHIFT + 4 : -4]
    assert (np.abs(result[..., 0] - 0.5) * STEREO < 0.25).mean() > 0.9  # a quarter of a pixel
    assert np.median(result[..., 3]) < 0.1  # the hidden source, whose cost is 1, has no influence


def test_perturbed_planes_stay_within_the_spread_and_some_change_their_normal_alone(device):
    reference, sources = problem(device)
    start, spread = np.float32(0.55), 0.5  # [px]: 0.4 px beside the surface
    planes = planes_of(start, device)
    costs = start_planes(reference, sources, planes, seed=0, is_given=True, geometric=0.0, chosen=1)
    for color in (0, 1):
        spread_planes(HalfIteration(3, 0, color, 0, 2, 1, spread, 0.0, 0.8), reference, sources, planes, costs)
    w, *slopes = np.array(download(planes)).reshape(HEIGHT, WIDTH, 4)[6:-6, SHIFT + 6 : -6, :3].T
    assert np.abs(w - start).max() < spread / STEREO and (np.abs(w - 0.5) < 0.049).mean() > 0.3
    assert ((w == start) & (np.abs(slopes).max(axis=0) > 0)).mean() > 0.02


def test_stored_costs_belong_to_the_stored_planes(device):
    reference, sources = problem(device, count=3, hidden=1)
    rng = np.random.default_rng(2)
    table = np.tile(np.float32([0.5, 0, 0, 0]), (WIDTH * HEIGHT, 1))
    table[:, 0] += rng.uniform(-0.1, 0.1, len(table)).astype(np.float32)
    planes, given = upload(table, vec4, device), {"seed": 0, "is_given": True, "geometric": 0.1, "chosen": 2}
    costs = start_planes(reference, sources, planes, **given)
    for color in (0, 1):
        spread_planes(HalfIteration(3, 0, color, 8, 4, 2, 0.3, 0.1, 0.8), reference, sources, planes, costs)
    stored = np.array(download(costs))
    assert (np.array(download(planes)).reshape(-1, 4)[:, 0] != table[:, 0]).mean() > 0.5
    np.testing.assert_array_equal(stored, np.array(download(start_planes(reference, sources, planes, **given))))


@pytest.mark.parametrize("slopes", [(0.0, 0.0), (0.004, -0.003)])
def test_depth_and_normals_are_those_of_the_plane(device, slopes):
    reference, sources = problem(device)
    v, u = np.mgrid[:HEIGHT, :WIDTH].astype(np.float64)
    w = 0.5 + slopes[0] * (u - 19.5) + slopes[1] * (v - 14.5)
    table = np.stack([w, w * 0 + slopes[0], w * 0 + slopes[1], w * 0 + 0.2], -1)
    planes = upload(table.reshape(-1, 4), vec4, device)
    depth, normals, confidence = (np.array(download(each)) for each in finish_planes(reference, sources, planes))
    np.testing.assert_allclose(depth, 1 / w.ravel(), rtol=1e-5)
    points = np.stack([(u - 19.5) / FOCAL / w, (v - 14.5) / FOCAL / w, 1 / w], -1)
    normal = np.cross(points[0, -1] - points[0, 0], points[-1, 0] - points[0, 0])
    normal *= -np.sign(normal[2]) / np.linalg.norm(normal)
    np.testing.assert_allclose(normals, np.tile(normal, (WIDTH * HEIGHT, 1)), atol=1e-4)
    if slopes == (0.0, 0.0):
        trust = confidence.reshape(HEIGHT, WIDTH)
        np.testing.assert_allclose(trust[:, SHIFT:], 0.4, atol=1e-6)  # (1 - 0.2) / 2: one source agrees
        assert not trust[:, : SHIFT - 1].any()
    table[..., 3] = 1.0
    depth = download(finish_planes(reference, sources, upload(table.reshape(-1, 4), vec4, device))[0])
    assert not np.array(depth).any()  # patches that have nothing to do with each other


WALL_WIDTH = 60
TRUE = SHIFT / STEREO
WALL_PATCH = np.array([(u, v) for v in (-2, 0, 2) for u in (-2, 0, 2) if u or v])  # [px]
EDGE = 30  # plain columns begin here
INNER = (slice(6, -6), slice(EDGE + 6, -6))  # patches see nothing else
TEXTURED = (slice(6, -6), slice(SHIFT + 6, EDGE - 6))


def half_plain(device: str):
    """A wall that is textured on the left and gray, but for a camera's noise, on the right, in two views."""
    rng = np.random.default_rng(0)
    canvas = rng.random((HEIGHT, WALL_WIDTH + SHIFT)).astype(np.float32)
    canvas[:, EDGE:] = 0.5
    views = [canvas[:, :WALL_WIDTH], canvas[:, SHIFT:]]
    noisy = [each + rng.normal(0, 0.006, each.shape).astype(np.float32) for each in views]
    return views_of(noisy, (FOCAL, FOCAL, 29.5, 14.5), WALL_PATCH, device)


def table(w: float, last: float) -> np.ndarray:
    return np.tile(np.array([w, 0, 0, last], np.float32), (WALL_WIDTH * HEIGHT, 1))


def after_priors(device: str, own: float, prior: float, weight: float) -> np.ndarray:
    """Inverse depths [h, w] of planes at `own` that are offered another."""
    reference, sources = half_plain(device)
    planes = upload(table(own, 0.0), vec4, device)
    costs = start_planes(reference, sources, planes, seed=0, is_given=True, geometric=0.0, chosen=1)
    priors = upload(table(prior, weight), vec4, device)
    take_priors(1, 0.0, reference, sources, priors, planes, costs)
    return np.array(download(planes)).reshape(HEIGHT, WALL_WIDTH, 4)


def test_a_gray_wall_is_plain_in_spite_of_noise_and_a_textured_one_is_not(device):
    reference, sources = half_plain(device)
    planes = upload(table(TRUE, 0.1), vec4, device)
    plain = np.array(download(judge_pixels(reference, sources, planes))).reshape(HEIGHT, WALL_WIDTH, 2)[..., 0]
    assert plain[INNER].mean() > 0.95 and not plain[TEXTURED].any()


def test_depth_is_sure_where_it_fits_and_the_source_agrees(device):
    reference, sources = half_plain(device)
    sure = []
    for w, cost in ((TRUE, 0.1), (TRUE, 0.6), (TRUE * 1.1, 0.1)):
        planes = upload(table(w, cost), vec4, device)
        sure.append(np.array(download(judge_pixels(reference, sources, planes))).reshape(HEIGHT, WALL_WIDTH, 2)[..., 1])
    assert (sure[0][:, SHIFT:] == 1).all()  # one source is all that there is
    assert not sure[1].any()  # does not fit
    assert not sure[2].any()  # fits, but the source disagrees


def test_plain_pixels_take_the_prior_and_textured_ones_take_it_only_where_it_fits(device):
    far = after_priors(device, 0.3, TRUE, 1.0)
    assert (far[INNER][..., 0] == np.float32(TRUE)).mean() > 0.8
    assert (far[TEXTURED][..., 0] == np.float32(TRUE)).mean() > 0.95
    wrong = after_priors(device, TRUE, 0.3, 0.25)
    assert (wrong[TEXTURED][..., 0] == np.float32(TRUE)).mean() > 0.95  # although marked as slightly textureless
    assert (far[INNER][..., 3] < 1.0).all()  # depth that counts


def test_a_prior_without_weight_or_out_of_range_is_none(device):
    for prior, weight in ((TRUE, 0.0), (0.1, 1.0), (1.5, 1.0)):
        assert (after_priors(device, 0.3, prior, weight)[..., 0] == np.float32(0.3)).all()


def test_a_sure_pixel_between_two_regions_counts_once_for_each(device):
    width, height, seam = 21, 18, 10
    judged = np.zeros((height, width, 2), np.float32)
    judged[:, :, 0] = 1.0
    judged[:, seam] = (0.0, 1.0)
    regions = find_regions(upload(judged.reshape(-1, 2), vec2, device), width)
    assert regions is not None
    pairs = np.array(download(regions.pairs))
    pixels = np.arange(height) * width + seam
    np.testing.assert_array_equal(pairs, np.concatenate([pixels, (1 << 32) + pixels]))
