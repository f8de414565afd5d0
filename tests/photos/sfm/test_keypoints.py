"""Features of pictures by kernels of our own: where they are, what they look like, and which are the same."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import pointloom as loom
from pointloom.kernels.keypoints.extrema import EDGE, PEAK
from pointloom.kernels.keypoints.scale_space import LEVELS, Octave, ScaleSpace, blur_weights, level_sigma
from pointloom.kernels.lang import uint8
from pointloom.kernels.memory import download, upload


@pytest.fixture(scope="module")
def picture() -> np.ndarray:
    """Blobs of several sizes, uint8 [96, 120]."""
    noise = np.random.default_rng(4).normal(size=(96, 120))
    rough = gaussian_filter(noise, 2.0) + 3 * gaussian_filter(noise[::-1], 5.0)
    return np.clip(128 + 60 * rough / rough.std(), 0, 255).astype(np.uint8)


def levels_of(octave: Octave) -> np.ndarray:
    shape = (LEVELS, octave.height, octave.stride)
    return download(octave.levels).reshape(shape)[:, :, : octave.width].astype(np.float64)


def blurred(image: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """By rows and columns, as the border goes on."""
    for axis in (0, 1):
        sides = [(len(weights) // 2,) * 2 if k == axis else (0, 0) for k in (0, 1)]
        windows = np.lib.stride_tricks.sliding_window_view(np.pad(image, sides, mode="edge"), len(weights), axis)
        image = windows @ weights
    return image


def test_levels_are_blurred_as_lowe_has_them(device, picture):
    space = ScaleSpace(120, 96, device)
    space.show(upload(picture.reshape(-1), uint8, device))
    first = levels_of(space.octaves[0])
    at = np.minimum(np.arange(240) / 2, 119), np.minimum(np.arange(192) / 2, 95)
    wide = np.array([np.interp(at[0], np.arange(120), row) for row in picture / 255.0])
    expected = np.array([np.interp(at[1], np.arange(96), column) for column in wide.T]).T
    sigmas = [np.sqrt(1.6**2 - 1.0)] + [np.sqrt(level_sigma(k) ** 2 - level_sigma(k - 1) ** 2) for k in range(1, 6)]
    for level, sigma in zip(first, sigmas, strict=True):
        expected = blurred(expected, blur_weights(sigma).astype(np.float64))
        np.testing.assert_allclose(level, expected, atol=2e-6)  # float32 sums of up to 27 products below 1
    assert np.array_equal(levels_of(space.octaves[1])[0], first[3, ::2, ::2])


def expected_extrema(levels: np.ndarray) -> np.ndarray:
    """x, y and level of the kept extrema of one octave by the definition, in float64."""
    d = np.diff(levels, axis=0)
    found = []
    for k, y, x in np.argwhere(np.abs(d) >= 0.8 * PEAK).tolist():
        if not (1 <= k <= 3 and 1 <= y < d.shape[1] - 1 and 1 <= x < d.shape[2] - 1):
            continue
        cube = d[k - 1 : k + 2, y - 1 : y + 2, x - 1 : x + 2].ravel() * np.sign(d[k, y, x])
        if (np.delete(cube, 13) >= cube[13]).any():
            continue
        for turn in range(5):
            c = d[k - 1 : k + 2, y - 1 : y + 2, x - 1 : x + 2]
            slope = np.array([c[1, 1, 2] - c[1, 1, 0], c[1, 2, 1] - c[1, 0, 1], c[2, 1, 1] - c[0, 1, 1]]) / 2
            xx, yy = c[1, 1, 2] + c[1, 1, 0] - 2 * c[1, 1, 1], c[1, 2, 1] + c[1, 0, 1] - 2 * c[1, 1, 1]
            ss = c[2, 1, 1] + c[0, 1, 1] - 2 * c[1, 1, 1]
            xy = (c[1, 2, 2] + c[1, 0, 0] - c[1, 2, 0] - c[1, 0, 2]) / 4
            xs = (c[2, 1, 2] + c[0, 1, 0] - c[2, 1, 0] - c[0, 1, 2]) / 4
            ys = (c[2, 2, 1] + c[0, 0, 1] - c[2, 0, 1] - c[0, 2, 1]) / 4
            step = -np.linalg.solve([[xx, xy, xs], [xy, yy, ys], [xs, ys, ss]], slope)
            right = int(step[0] > 0.6 and x < d.shape[2] - 2) - int(step[0] < -0.6 and x > 1)
            down = int(step[1] > 0.6 and y < d.shape[1] - 2) - int(step[1] < -0.6 and y > 1)
            if turn == 4 or not (right or down):
                break
            x, y = x + right, y + down
        bend = xx * yy - xy**2
        round_enough = bend > 0 and (xx + yy) ** 2 / bend < (EDGE + 1) ** 2 / EDGE
        if abs(d[k, y, x] + slope @ step / 2) > PEAK and round_enough and (np.abs(step) < 1.5).all():
            found.append((x + step[0], y + step[1], k + step[2]))
    return np.array(found)


def test_features_are_the_extrema_of_differences(device, picture):
    space = ScaleSpace(120, 96, device)
    space.show(upload(picture.reshape(-1), uint8, device))
    expected = []
    for octave in space.octaves:
        x, y, level = expected_extrema(levels_of(octave)).reshape(-1, 3).T
        expected.append(np.column_stack([x * octave.step, y * octave.step, octave.step * level_sigma(level)]))
    expected = np.concatenate(expected)
    found = loom.sfm.detect_keypoints(picture, device=device)
    places = np.column_stack([found.positions, found.scales])
    once = places[np.r_[True, (np.diff(places, axis=0) != 0).any(axis=1)]]  # those of two orientations stand twice
    assert len(once) == len(expected) > 40
    np.testing.assert_allclose(once, expected, atol=1e-3)


def test_a_picture_that_is_turned_has_the_same_features_turned(device, picture):
    upright = loom.sfm.detect_keypoints(picture, device=device)
    turned = loom.sfm.detect_keypoints(np.ascontiguousarray(np.rot90(picture)), device=device)
    pairs = loom.sfm.match_keypoints(upright, turned, device=device)
    a, b = upright.positions[pairs[:, 0]], turned.positions[pairs[:, 1]]
    off = np.linalg.norm(np.column_stack([a[:, 1], 119 - a[:, 0]]) - b, axis=1)
    assert len(pairs) > 0.8 * len(upright)
    assert np.median(off) < 0.3  # the doubled picture has its last column twice, which shifts it by half a pixel of it
    angles = upright.orientations[pairs[:, 0]] - turned.orientations[pairs[:, 1]]
    assert np.median(np.abs(np.angle(np.exp(1j * (angles - np.pi / 2))))) < 0.05


def test_brightness_changes_no_descriptor_much(device, picture):
    bright = loom.sfm.detect_keypoints(picture, device=device)
    dark = loom.sfm.detect_keypoints((picture * 0.6).astype(np.uint8), device=device)
    pairs = loom.sfm.match_keypoints(bright, dark, device=device)
    assert len(pairs) > 0.8 * len(dark)
    off = bright.descriptors[pairs[:, 0]].astype(float) - dark.descriptors[pairs[:, 1]]
    assert np.median(np.linalg.norm(off, axis=1)) < 40  # of 512
    lengths = np.linalg.norm(bright.descriptors.astype(float), axis=1)
    assert np.all(np.abs(lengths - 512) < 6)  # each number is rounded


def test_finer_scales_are_left_out_first(device, picture):
    every = loom.sfm.detect_keypoints(picture, device=device)
    few = loom.sfm.detect_keypoints(picture, max_features=10, device=device)
    assert 10 < len(few) < len(every)
    assert np.array_equal(few.descriptors, every.descriptors[-len(few) :])
    counts = {len(loom.sfm.detect_keypoints(picture, max_features=most, device=device)) for most in range(1, 60, 4)}
    assert len(counts) > 4  # there are four octaves, each of three scales that are kept or left out


def test_features_are_left_out_where_the_mask_is_false(device, picture):
    mask = np.zeros(picture.shape, bool)
    mask[:, :60] = True
    every = loom.sfm.detect_keypoints(picture, device=device)
    left = loom.sfm.detect_keypoints(picture, mask=mask, device=device)
    inside = np.floor(every.positions[:, 0] + 0.5) < 60
    assert 0 < inside.sum() < len(every)
    assert np.array_equal(left.positions, every.positions[inside])


@pytest.mark.parametrize("shape", [(1, 1), (1, 40), (3, 3), (17, 16)])
def test_an_even_picture_has_no_features(device, shape):
    found = loom.sfm.detect_keypoints(np.full(shape, 9, np.uint8), device=device)
    assert len(found) == 0 and found.descriptors.shape == (0, 128)
    assert loom.sfm.match_keypoints(found, found, device=device).shape == (0, 2)


def made(descriptors: np.ndarray) -> loom.sfm.Keypoints:
    n = len(descriptors)
    return loom.sfm.Keypoints(np.zeros((n, 2)), np.ones(n), np.zeros(n), descriptors.astype(np.uint8))


@pytest.mark.parametrize("counts", [(70, 50), (1, 5), (5, 1)])
def test_matches_are_those_of_the_definition(device, counts):
    rng = np.random.default_rng(2)
    a = rng.integers(0, 90, (counts[0], 128))
    b = rng.integers(0, 90, (counts[1], 128))
    n = min(counts) // 2 + 1
    b[:n] = np.clip(a[:n] + rng.integers(-9, 10, (n, 128)), 0, 255)
    b[-1] = b[0]  # of two that are equally near, neither is clear
    if n > 1:
        a[-1] = a[1]  # b[1] is near both
    sqdists = ((a[:, None] - b[None]) ** 2).sum(axis=2)

    def clear(sqdists: np.ndarray) -> np.ndarray:
        ranked = np.sort(np.pad(sqdists, ((0, 0), (0, 1)), constant_values=2**31 - 1), axis=1)
        near = ranked[:, 0] <= (1024 * np.sin(0.35)) ** 2
        return np.where(near & (ranked[:, 0] < 0.64 * ranked[:, 1]), sqdists.argmin(axis=1), -1)

    there, back = clear(sqdists), clear(sqdists.T)
    expected = [(i, j) for i, j in enumerate(there.tolist()) if j >= 0 and back[j] == i]
    found = loom.sfm.match_keypoints(made(a), made(b), device=device)
    assert found.tolist() == [list(pair) for pair in expected]


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"picture": np.zeros((4, 4))}, TypeError, "picture: expected numbers of type uint8, got float64"),
        ({"picture": np.zeros((4, 4, 4), np.uint8)}, ValueError, "picture: expected shape"),
        ({"picture": np.broadcast_to(np.uint8(0), (40000, 40000))}, ValueError, "give a max_size"),
        ({"mask": np.ones((4, 4), np.uint8)}, TypeError, "mask: expected bool"),
        ({"mask": np.ones((4, 5), bool)}, ValueError, "mask: expected shape"),
    ],
)
def test_wrong_arguments_are_told(options, error, words):
    with pytest.raises(error, match=words.replace("[", r"\[")):
        loom.sfm.detect_keypoints(**({"picture": np.zeros((4, 4), np.uint8)} | options))
