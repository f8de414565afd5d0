"""Colors of values, labels and directions: mixed between entries, clamped, gray where there is no number."""

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.drawing import value_colors
from pointloom.kernels.drawing.value_colors import MAX_LABELS, Ramp
from pointloom.kernels.lang import float32, float64, int32, int64, vec3

TABLE = np.array([[0, 0, 1], [0, 1, 0], [1, 0, 0]], np.float32)
GRAY = (0.5, 0.5, 0.5)


def colors_of(device, values, limits, dtype=float32):
    warp_device = memory.upload(np.zeros(1), float32, device).device
    ramp = Ramp(TABLE, limits, GRAY, warp_device)
    colors = value_colors.color_values(memory.upload(np.array(values), dtype, warp_device), ramp)
    return colors.numpy(), int(ramp.flag.numpy()[0])


@pytest.mark.parametrize("dtype", [float32, float64])
def test_values_are_mixed_between_entries_and_clamped_beyond_the_limits(device, dtype):
    colors, flag = colors_of(device, [10, 15, 17.5, 20, 30, 31, -1e30], (10.0, 30.0), dtype)
    expected = [[0, 0, 1], [0, 0.5, 0.5], [0, 0.75, 0.25], [0, 1, 0], [1, 0, 0], [1, 0, 0], [0, 0, 1]]
    np.testing.assert_allclose(colors, expected, atol=1e-6)
    assert flag == 0


@pytest.mark.parametrize("dtype", [float32, float64])
def test_non_finite_values_are_gray_and_reported(device, dtype):
    colors, flag = colors_of(device, [1.0, np.nan, np.inf, -np.inf], (0.0, 1.0), dtype)
    assert colors[1:].tolist() == [list(GRAY)] * 3 and flag == 1


def test_equal_limits_give_the_color_in_the_middle(device):
    assert colors_of(device, [5.0, 5.0], (5.0, 5.0))[0].tolist() == [[0, 1, 0]] * 2


def test_values_far_from_zero_keep_their_differences(device):
    values = 3e8 + np.array([0.0, 0.25, 0.5])
    np.testing.assert_allclose(colors_of(device, values, (3e8, 3e8 + 0.5), float64)[0], TABLE, atol=1e-6)


def test_limits_beyond_half_of_float64_do_not_overflow(device):
    np.testing.assert_allclose(colors_of(device, [-1e308, 0, 1e308], (-1e308, 1e308), float64)[0], TABLE, atol=1e-6)


def test_coordinates_are_colored_as_values(device):
    points = np.array([[0, 1, 2], [3, 4, 5], [np.nan, 7, 8]], np.float32)
    table = memory.upload(points, vec3, device)
    for axis in range(3):
        ramp = Ramp(TABLE, (0.0, 8.0), GRAY, table.device)
        colors = value_colors.color_coordinates(table, axis, ramp).numpy()
        np.testing.assert_array_equal(colors, colors_of(device, points[:, axis], (0.0, 8.0))[0])


@pytest.mark.parametrize("dtype", [int32, int64])
def test_labels_repeat_the_palette_and_are_reported(device, dtype):
    labels = memory.upload(np.array([0, 2, 3, -1, -7, 10_000_000]), dtype, device)
    colors, seen = value_colors.color_labels(labels, TABLE, GRAY)
    expected = [TABLE[0], TABLE[2], TABLE[0], GRAY, GRAY, TABLE[10_000_000 % 3]]
    np.testing.assert_array_equal(colors.numpy(), np.array(expected, np.float32))
    assert seen == [-1, 0, 2, 3, MAX_LABELS - 2]


def test_directions_are_their_coordinates(device):
    normals = memory.upload(np.array([[0, 0, 1], [-1, 0, 0], [5, -5, 0], [np.nan, 0, 0]]), vec3, device)
    colors, flag = value_colors.color_normals(normals, GRAY)
    expected = [[0.5, 0.5, 1], [0, 0.5, 0.5], [1, 0, 0.5], GRAY]
    np.testing.assert_array_equal(colors.numpy(), np.array(expected, np.float32))
    assert flag.numpy()[0] == 1


@pytest.mark.parametrize(("count", "max_count"), [(10, 10), (11, 10), (100, 7), (1, 5), (0, 5)])
def test_a_sample_is_evenly_spaced_from_the_first_value_on(device, count, max_count):
    values = np.arange(count, dtype=np.float64)
    stride = max(1, -(-count // max_count))
    for dtype in (float32, float64):
        sample = value_colors.sample_evenly(memory.upload(values, dtype, device), max_count)
        np.testing.assert_array_equal(sample, values[::stride])
        assert len(sample) <= max_count
