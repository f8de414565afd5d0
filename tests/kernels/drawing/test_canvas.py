"""Strokes, colors of values, labels and directions, and lines along normals."""

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.drawing import canvas as strokes
from pointloom.kernels.drawing import value_colors
from pointloom.kernels.drawing.canvas import Paint, Sheet, clip_box
from pointloom.kernels.drawing.placing import make_normal_lines_kernel
from pointloom.kernels.drawing.value_colors import MAX_LABELS, Ramp
from pointloom.kernels.lang import float32, float64, int32, int64, launch, uint8, vec3
from pointloom.kernels.memory import download, empty, upload

WIDTH, HEIGHT = 48, 36
ALL = (0, 0, WIDTH, HEIGHT)


@pytest.fixture
def sheet(device):
    return Sheet(memory.full(3 * WIDTH * HEIGHT, 200, uint8, device), WIDTH, HEIGHT)


def coverage(sheet):
    return sheet.words.numpy().reshape(HEIGHT, WIDTH)


def picture(sheet):
    return sheet.picture.numpy().reshape(HEIGHT, WIDTH, 3)


def distances(segment):
    """Of all cells from a segment [px], in float64."""
    a, b = np.array(segment[:2], float), np.array(segment[2:], float)
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    cells = np.stack([columns, rows], -1).astype(float)
    length = max(((b - a) ** 2).sum(), 1e-30)
    t = (((cells - a) @ (b - a)) / length).clip(0, 1)
    return np.linalg.norm(cells - a - t[..., None] * (b - a), axis=-1)


@pytest.mark.parametrize(
    "segment",
    [(3, 4, 40, 4), (5, 2, 5, 30), (4, 30, 44, 3), (40.3, 30.7, 36.2, 2.1), (20, 15, 20, 15), (-30, -9, 80, 50)],
)
@pytest.mark.parametrize("width", [1.0, 3.5])
def test_cells_are_covered_by_their_distance_from_a_stroke(sheet, segment, width):
    strokes.cover_segments(sheet, np.array([segment], np.float32), width)
    expected = 255 * (width / 2 + 0.5 - distances(segment)).clip(0, 1)
    np.testing.assert_allclose(coverage(sheet), expected, atol=0.6)


def test_a_line_of_half_a_pixel_is_half_as_dark(sheet):
    strokes.cover_segments(sheet, np.array([[2, 7, 40, 7]], np.float32), 0.5)
    assert np.isin(coverage(sheet)[7, 2:41], [127, 128]).all()


def test_strokes_that_cross_are_no_darker_there(sheet):
    strokes.cover_segments(sheet, np.array([[2, 7, 40, 7], [9, 2, 9, 30]], np.float32), 1.0)
    strokes.blend(sheet, ALL, Paint((0, 0, 0), 128))
    assert set(picture(sheet)[[7, 7, 20], [9, 20, 9], 0].tolist()) == {100}


def test_blending_uses_integers_and_clears_the_sheet(sheet):
    strokes.cover_box(sheet, ALL, (4.25, 3.5, 20.0, 10.5), (0, 0, 0, 0))
    fractions = coverage(sheet)
    assert fractions[6, 4] == 64 and fractions[6, 10] == 255 and fractions[3, 10] == 0 and fractions[4, 10] == 255
    strokes.blend(sheet, ALL, Paint((0, 255, 100), 200))
    fraction, new = 64 * 200, np.array([0, 255, 100])
    assert (picture(sheet)[6, 4] == (200 * (65025 - fraction) + new * fraction + 32512) // 65025).all()
    assert not sheet.words.numpy().any()


def test_letters_are_drawn_at_their_position_and_clipped_at_the_edge(sheet):
    cells = np.arange(1, 13, dtype=np.uint8) * 20
    atlas = memory.upload(cells, uint8, sheet.picture.device)
    strokes.cover_glyphs(sheet, np.array([[0, 4, 3, 5, 6], [0, 4, 3, 46, 35]], np.int32), atlas)
    assert (coverage(sheet)[6:9, 5:9] == cells.reshape(3, 4)).all() and (coverage(sheet)[35, 46:] == cells[:2]).all()
    assert coverage(sheet).sum() == cells.sum(dtype=int) + cells[:2].sum(dtype=int)


def test_a_halo_has_its_radius_and_keeps_the_coverage(sheet):
    strokes.cover_box(sheet, ALL, (19.5, 14.5, 20.5, 15.5), (0, 0, 0, 0))
    strokes.blend_halo(sheet, ALL, 2, Paint((255, 255, 255), 255))
    changed = picture(sheet)[..., 0] != 200
    rows, columns = np.nonzero(changed)
    gaps = np.hypot(rows - 15, columns - 20)
    assert gaps.max() < 2.5 and changed.sum() == 21 and coverage(sheet)[15, 20] == 255


def test_an_image_is_copied_into_a_box(sheet):
    image = np.arange(3 * 5 * 4, dtype=np.uint8)
    table = memory.upload(image, uint8, sheet.picture.device)
    strokes.copy_image(sheet, clip_box(sheet, 45, -2, 49, 1), table, 5, 45, -2)
    assert (picture(sheet)[:2, 45:] == image.reshape(4, 5, 3)[2:, :3]).all() and (picture(sheet)[2:] == 200).all()


def test_a_box_outside_the_image_is_empty(sheet):
    assert clip_box(sheet, 50, 3, 60, 9)[2] == 0 and clip_box(sheet, -9, -9, -1, -1)[2:] == (0, 0)


TABLE = np.array([[0, 0, 1], [0, 1, 0], [1, 0, 0]], np.float32)
GRAY = (0.5, 0.5, 0.5)


def colors_of(device, values, limits, dtype=float32):
    warp_device = memory.upload(np.zeros(1), float32, device).device
    ramp = Ramp(TABLE, limits, GRAY, warp_device)
    colors = value_colors.color_values(memory.upload(np.array(values), dtype, warp_device), ramp)
    return colors.numpy(), int(ramp.flag.numpy()[0])


@pytest.mark.parametrize("dtype", [float32, float64])
def test_values_are_mixed_between_entries_clamped_beyond_the_limits_and_gray_if_not_finite(device, dtype):
    colors, flag = colors_of(device, [10, 15, 17.5, 20, 30, 31, -1e30], (10.0, 30.0), dtype)
    expected = [[0, 0, 1], [0, 0.5, 0.5], [0, 0.75, 0.25], [0, 1, 0], [1, 0, 0], [1, 0, 0], [0, 0, 1]]
    np.testing.assert_allclose(colors, expected, atol=1e-6)
    assert flag == 0
    colors, flag = colors_of(device, [1.0, np.nan, np.inf, -np.inf], (0.0, 1.0), dtype)
    assert colors[1:].tolist() == [list(GRAY)] * 3 and flag == 1, "values that are not finite are reported"


def test_limits_beyond_half_of_float64_do_not_overflow(device):
    np.testing.assert_allclose(colors_of(device, [-1e308, 0, 1e308], (-1e308, 1e308), float64)[0], TABLE, atol=1e-6)


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


def test_lines_along_normals_have_one_length_and_none_where_the_normal_has_none(device, rng):
    points, normals = rng.normal(size=(2, 20, 3)).astype(np.float32)
    normals[3] = 0
    ends, lines = empty(40, vec3, device), empty(40, int32, device)
    given = [upload(points, vec3, device), upload(normals, vec3, device), 0.5, ends, lines]
    launch(make_normal_lines_kernel, 20, given)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    tips = points + 0.5 * normals / np.where(lengths > 0, lengths, 1)
    np.testing.assert_allclose(download(ends), np.stack([points, tips], axis=1).reshape(-1, 3), rtol=0, atol=1e-6)
    np.testing.assert_array_equal(download(lines), np.arange(40))
