"""Semi-global matching is exact: codes, path sums and disparities equal those of plain NumPy code."""

import numpy as np
import pytest

from pointloom.kernels.lang import float32, int32, uint8, uint16
from pointloom.kernels.memory import download, empty, full, upload
from pointloom.kernels.stereo.census import (
    NO_CODE,
    WINDOW_HALF_HEIGHT,
    WINDOW_HALF_WIDTH,
    find_codes,
    rectify_brightness,
)
from pointloom.kernels.stereo.disparities import (
    MAX_SUM_PERCENT,
    NO_DISPARITY,
    PLANE_RADIUS,
    RectifiedView,
    find_depth,
    find_disparities,
)
from pointloom.kernels.stereo.path_sums import LARGE_STEP_PENALTY, MAX_CODE_DISTANCE, SMALL_STEP_PENALTY, sum_paths

WIDTH, HEIGHT, COUNT = 21, 9, 32
STEPS = [(dx, dy) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if dx or dy]


def true_codes(pixels: np.ndarray) -> np.ndarray:
    height, width = pixels.shape
    padded = np.pad(
        pixels.astype(np.int64),
        ((WINDOW_HALF_HEIGHT, WINDOW_HALF_HEIGHT), (WINDOW_HALF_WIDTH, WINDOW_HALF_WIDTH)),
        mode="edge",
    )
    codes = np.zeros((height, width), np.int64)
    for dy in range(WINDOW_HALF_HEIGHT + 1):
        for dx in range(-WINDOW_HALF_WIDTH, WINDOW_HALF_WIDTH + 1):
            if dy > 0 or dx > 0:
                ahead = padded[
                    WINDOW_HALF_HEIGHT + dy : WINDOW_HALF_HEIGHT + dy + height,
                    WINDOW_HALF_WIDTH + dx : WINDOW_HALF_WIDTH + dx + width,
                ]
                behind = padded[
                    WINDOW_HALF_HEIGHT - dy : WINDOW_HALF_HEIGHT - dy + height,
                    WINDOW_HALF_WIDTH - dx : WINDOW_HALF_WIDTH - dx + width,
                ]
                codes = 2 * codes + (ahead > behind)
    return codes


def true_costs(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Hamming distances of codes of the left image with those of the right one, stored from right to left."""
    width = left.shape[1]
    costs = np.full((*left.shape, COUNT), MAX_CODE_DISTANCE)
    for (y, x, d), _ in np.ndenumerate(costs):
        a, b = left[y, x], right[y, width - 1 - x + d]
        if a >= 0 and b >= 0:
            costs[y, x, d] = int(a ^ b).bit_count()
    return costs


def true_sums(costs: np.ndarray) -> np.ndarray:
    """Path costs of eight directions by the recursion of Hirschmueller 2008, pixel by pixel."""
    height, width, _ = costs.shape
    total = np.zeros_like(costs)
    for dx, dy in STEPS:
        paths = np.zeros_like(costs)
        for y in range(height) if dy >= 0 else range(height - 1, -1, -1):
            for x in range(width) if dx >= 0 else range(width - 1, -1, -1):
                paths[y, x] = costs[y, x]
                if 0 <= x - dx < width and 0 <= y - dy < height:
                    before = np.pad(paths[y - dy, x - dx], 1, constant_values=10**6)
                    near = np.minimum(before[:-2], before[2:]) + SMALL_STEP_PENALTY
                    low = before.min()
                    paths[y, x] += np.minimum(np.minimum(before[1:-1], near), low + LARGE_STEP_PENALTY) - low
        total += paths
    return total


def random_codes(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Codes of two images that mostly correspond at two disparities, with pixels outside the images."""
    rng = np.random.default_rng(seed)
    left = rng.integers(0, 2**31, (HEIGHT, WIDTH))
    right = rng.integers(0, 2**31, (HEIGHT, WIDTH + COUNT))
    for x in range(WIDTH):
        right[:, WIDTH - 1 - x + (7 if x < 10 else 12)] = left[:, x] ^ (1 << rng.integers(0, 31))
    left[2, 3], right[:, -4:] = NO_CODE, NO_CODE
    return left, right


def sums_of(left: np.ndarray, right: np.ndarray, device: str) -> np.ndarray:
    given = (upload(each.ravel().astype(np.int32), int32, device) for each in (left, right))
    sums = sum_paths(*given, WIDTH, HEIGHT, COUNT)
    return np.array(download(sums)).reshape(HEIGHT, WIDTH, COUNT).astype(np.int64)


def disparities_of(sums: np.ndarray, first: int, device: str) -> list[np.ndarray]:
    height, width, count = sums.shape
    found = find_disparities(upload(sums.ravel().astype(np.uint16), uint16, device), width, height, count, first)
    rows, columns = slice(PLANE_RADIUS, PLANE_RADIUS + height), slice(PLANE_RADIUS, PLANE_RADIUS + width)
    return [np.array(download(each)).reshape(height + 2 * PLANE_RADIUS, -1)[rows, columns] for each, _ in found]


@pytest.mark.parametrize("step", [1, -1])
def test_codes_compare_opposite_pixels(device, step):
    pixels = np.random.default_rng(0).integers(0, 9, (HEIGHT, WIDTH), dtype=np.uint8)
    flat = upload(pixels.ravel(), uint8, device)
    brightness = rectify_brightness(flat, 1, WIDTH, HEIGHT, None, WIDTH, HEIGHT)
    codes = full(HEIGHT * (WIDTH + 3), NO_CODE, int32, device)
    start = 2 if step > 0 else WIDTH - 1
    find_codes(brightness, WIDTH, HEIGHT, step=step, start=start, codes=codes)
    actual, expected = np.array(download(codes)).reshape(HEIGHT, -1), np.full((HEIGHT, WIDTH + 3), NO_CODE)
    expected[:, start + step * np.arange(WIDTH)] = true_codes(pixels)
    np.testing.assert_array_equal(actual, expected)


def test_a_homography_moves_brightness_and_leaves_pixels_outside_without_code(device):
    pixels = np.random.default_rng(1).integers(0, 256, (HEIGHT, WIDTH, 3), dtype=np.uint8)
    there = np.array([[1, 0, 2.5], [0, 1, 0], [0, 0, 1.0]])
    brightness = rectify_brightness(upload(pixels.ravel(), uint8, device), 3, WIDTH, HEIGHT, there, WIDTH, HEIGHT)
    shown = np.array(download(brightness)).reshape(HEIGHT + 2 * WINDOW_HALF_HEIGHT, -1)[
        WINDOW_HALF_HEIGHT:-WINDOW_HALF_HEIGHT, WINDOW_HALF_WIDTH : WINDOW_HALF_WIDTH + WIDTH
    ]
    gray = pixels @ [0.2990, 0.5870, 0.1140] / 255
    np.testing.assert_allclose(shown[:, :-3], (gray[:, 2:-1] + gray[:, 3:])[:, : WIDTH - 3] / 2, atol=1e-6)
    codes = empty(HEIGHT * WIDTH, int32, device)
    find_codes(brightness, WIDTH, HEIGHT, step=1, start=0, codes=codes)
    outside = np.array(download(codes)).reshape(HEIGHT, WIDTH) == NO_CODE
    assert outside[:, -3:].all() and not outside[:, :-3].any()


@pytest.mark.parametrize("seed", [0, 1])
def test_path_sums_are_those_of_the_recursion(device, seed):
    left, right = random_codes(seed)
    np.testing.assert_array_equal(sums_of(left, right, device), true_sums(true_costs(left, right)))


@pytest.mark.parametrize("first", [0, -3, 5])
def test_disparities_are_unique_minima_that_both_images_share(device, first):
    left, right = random_codes(2)
    sums = true_sums(true_costs(left, right))
    actual = disparities_of(sums, first, device)
    winners = np.full((HEIGHT, WIDTH), -1)
    opposite = np.full((HEIGHT, WIDTH + COUNT), 10**6 * COUNT)
    for (y, x, d), value in np.ndenumerate(sums):
        opposite[y, WIDTH - 1 - x + d] = min(opposite[y, WIDTH - 1 - x + d], value * COUNT + d)
    for y, x in np.ndindex(HEIGHT, WIDTH):
        d = int(np.argmin(sums[y, x]))
        others = np.delete(sums[y, x], range(max(d - 1, 0), d + 2))
        if 0 < d < COUNT - 1 and sums[y, x, d] * 100 < others.min() * MAX_SUM_PERCENT:
            winners[y, x] = d
    expected = np.full((2, HEIGHT, WIDTH), NO_DISPARITY)
    for y, x in np.ndindex(HEIGHT, WIDTH):
        d = winners[y, x]
        if d > 0 and abs(opposite[y, WIDTH - 1 - x + d] % COUNT - d) <= 1:
            a, b, c = sums[y, x, d - 1 : d + 2]
            expected[0, y, x] = d + (a - c) / (2 * (a + c - 2 * b))
        e = WIDTH - 1 - first - x
        d = opposite[y, e] % COUNT if 0 <= e < WIDTH + COUNT - 1 else 0
        u = WIDTH - 1 - e + d
        if 0 < d < COUNT - 1 and 0 < u < WIDTH - 1 and winners[y, u] > 0 and abs(winners[y, u] - d) <= 1:
            a, b, c = sums[y, u - 1, d - 1], sums[y, u, d], sums[y, u + 1, d + 1]
            expected[1, y, x] = d + ((a - c) / (2 * (a + c - 2 * b)) if a + c > 2 * b else 0.0)
    assert (expected[0] >= 0).sum() > 50
    np.testing.assert_allclose(actual, expected, rtol=1e-6)


def test_equal_costs_have_no_disparity(device):
    left, right = np.full((HEIGHT, WIDTH), 5), np.full((HEIGHT, WIDTH + COUNT), 5)
    for each in disparities_of(sums_of(left, right, device), 0, device):
        assert (each == NO_DISPARITY).all()


def test_a_slanted_plane_has_its_depth_and_normal(device):
    width, height, lens, per_unit, shift = 24, 12, (30.0, 32.0, 11.0, 6.0), 8.0, 3.0
    v, u = np.mgrid[:height, :width]
    disparities = np.full((height + 2 * PLANE_RADIUS, width + 2 * PLANE_RADIUS + 16), NO_DISPARITY, np.float32)
    truth = 5.0 + 0.25 * u - 0.125 * v
    disparities[PLANE_RADIUS:-PLANE_RADIUS, PLANE_RADIUS : PLANE_RADIUS + width] = truth
    disparities[PLANE_RADIUS + 6, PLANE_RADIUS + 12] = 20.0  # not on any surface
    view = RectifiedView(width, height, lens, per_unit, shift, np.eye(3))
    margins = full(width * height, 0.5, float32, device)
    given = upload(disparities.ravel(), float32, device)
    depth, normals, confidence = (np.array(download(e)) for e in find_depth(width, height, None, view, given, margins))
    depth, normals = depth.reshape(height, width), normals.reshape(height, width, 3)
    assert depth[6, 12] == 0 and confidence.reshape(height, width)[6, 12] == 0
    assert set(confidence.round(6).tolist()) == {0.0, 0.25}
    z, known = per_unit / (truth + shift), depth > 0
    assert known[2:-2, 2:-2].sum() == (height - 4) * (width - 4) - 1
    np.testing.assert_allclose(depth[known], z[known], rtol=1e-5)
    points = np.stack([(u - lens[2]) / lens[0] * z, (v - lens[3]) / lens[1] * z, z], axis=-1)
    normal = np.cross(points[2, 2] - points[9, 20], points[2, 20] - points[9, 20])
    normal *= -np.sign(normal[2]) / np.linalg.norm(normal)
    np.testing.assert_allclose(normals[known], np.broadcast_to(normal, (known.sum(), 3)), atol=1e-4)
