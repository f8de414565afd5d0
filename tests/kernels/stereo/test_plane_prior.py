"""Textureless regions and reliable depth are detected; a prior applies there unless images clearly contradict it."""

import numpy as np

from pointloom.kernels.lang import vec2, vec4
from pointloom.kernels.memory import download, upload
from pointloom.kernels.stereo.patch_costs import Reference, Sources, patch_on
from pointloom.kernels.stereo.patch_match import start_planes
from pointloom.kernels.stereo.region_planes import judge_pixels, take_priors
from pointloom.kernels.stereo.textureless_regions import find_regions

from .made_brightness import stored

WIDTH, HEIGHT, FOCAL, BASELINE, SHIFT = 60, 30, 40.0, 0.2, 4
TRUE = SHIFT / (FOCAL * BASELINE)
PATCH = np.array([(u, v) for v in (-2, 0, 2) for u in (-2, 0, 2) if u or v])  # [px]
EDGE = 30  # plain columns begin here
INNER = (slice(6, -6), slice(EDGE + 6, -6))  # patches see nothing else
TEXTURED = (slice(6, -6), slice(SHIFT + 6, EDGE - 6))


def half_plain(device: str):
    """A wall that is textured on the left and gray, but for a camera's noise, on the right, in two views."""
    rng = np.random.default_rng(0)
    canvas = rng.random((HEIGHT, WIDTH + SHIFT)).astype(np.float32)
    canvas[:, EDGE:] = 0.5
    views = [canvas[:, :WIDTH], canvas[:, SHIFT:]]
    noisy = [each + rng.normal(0, 0.006, each.shape).astype(np.float32) for each in views]
    values = stored(noisy, device)
    there = np.column_stack([np.eye(3), np.array([-FOCAL * BASELINE, 0.0, 0.0])])[None]
    back = np.column_stack([np.eye(3), np.array([FOCAL * BASELINE, 0.0, 0.0])])[None]
    maps = upload(table(TRUE, 0.0), vec4, device)
    sources = Sources(there, there, back, [(WIDTH, HEIGHT, WIDTH * HEIGHT)], [(WIDTH, HEIGHT, 0)], values, maps)
    lens = (FOCAL, FOCAL, 29.5, 14.5)
    return Reference(WIDTH, HEIGHT, 0, lens, (0.2, 1.0), FOCAL * BASELINE, patch_on(PATCH, device)), sources


def table(w: float, last: float) -> np.ndarray:
    return np.tile(np.array([w, 0, 0, last], np.float32), (WIDTH * HEIGHT, 1))


def after_priors(device: str, own: float, prior: float, weight: float) -> np.ndarray:
    """Inverse depths [h, w] of planes at `own` that are offered another."""
    reference, sources = half_plain(device)
    planes = upload(table(own, 0.0), vec4, device)
    costs = start_planes(reference, sources, planes, seed=0, is_given=True, geometric=0.0, chosen=1)
    priors = upload(table(prior, weight), vec4, device)
    take_priors(1, 0.0, reference, sources, priors, planes, costs)
    return np.array(download(planes)).reshape(HEIGHT, WIDTH, 4)


def test_a_gray_wall_is_plain_in_spite_of_noise_and_a_textured_one_is_not(device):
    reference, sources = half_plain(device)
    planes = upload(table(TRUE, 0.1), vec4, device)
    plain = np.array(download(judge_pixels(reference, sources, planes))).reshape(HEIGHT, WIDTH, 2)[..., 0]
    assert plain[INNER].mean() > 0.95
    assert not plain[TEXTURED].any()


def test_depth_is_sure_where_it_fits_and_the_source_agrees(device):
    reference, sources = half_plain(device)
    sure = []
    for w, cost in ((TRUE, 0.1), (TRUE, 0.6), (TRUE * 1.1, 0.1)):
        planes = upload(table(w, cost), vec4, device)
        sure.append(np.array(download(judge_pixels(reference, sources, planes))).reshape(HEIGHT, WIDTH, 2)[..., 1])
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
