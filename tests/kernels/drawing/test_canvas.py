"""Strokes: coverage by distance, crossings no darker, whole-number blending, nothing outside the picture."""

import numpy as np
import pytest

from pointloom.kernels import memory
from pointloom.kernels.drawing import canvas as strokes
from pointloom.kernels.drawing.canvas import Paint, Sheet, clip_box
from pointloom.kernels.lang import uint8

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


def test_a_line_of_one_pixel_along_a_row_fills_that_row_alone(sheet):
    strokes.cover_segments(sheet, np.array([[2, 7, 40, 7]], np.float32), 1.0)
    assert (coverage(sheet)[7, 2:41] == 255).all() and coverage(sheet).sum() == 39 * 255


def test_a_line_of_half_a_pixel_is_half_as_dark(sheet):
    strokes.cover_segments(sheet, np.array([[2, 7, 40, 7]], np.float32), 0.5)
    assert np.isin(coverage(sheet)[7, 2:41], [127, 128]).all()


def test_strokes_that_cross_are_no_darker_there(sheet):
    strokes.cover_segments(sheet, np.array([[2, 7, 40, 7], [9, 2, 9, 30]], np.float32), 1.0)
    strokes.blend(sheet, ALL, Paint((0, 0, 0), 128))
    assert set(picture(sheet)[[7, 7, 20], [9, 20, 9], 0].tolist()) == {100}


def test_blending_uses_integers_and_clears_the_sheet(sheet):
    strokes.cover_box(sheet, ALL, (4.25, 3.5, 20.0, 10.5), (0, 0, 0, 0))
    shares = coverage(sheet)
    assert shares[6, 4] == 64 and shares[6, 10] == 255 and shares[3, 10] == 0 and shares[4, 10] == 255
    strokes.blend(sheet, ALL, Paint((0, 255, 100), 200))
    share, new = 64 * 200, np.array([0, 255, 100])
    assert (picture(sheet)[6, 4] == (200 * (65025 - share) + new * share + 32512) // 65025).all()
    assert not sheet.words.numpy().any()


def test_letters_are_drawn_at_their_position_and_clipped_at_the_edge(sheet):
    cells = np.arange(1, 13, dtype=np.uint8) * 20
    atlas = memory.upload(cells, uint8, sheet.picture.device)
    strokes.cover_glyphs(sheet, np.array([[0, 4, 3, 5, 6], [0, 4, 3, 46, 35]], np.int32), atlas)
    assert (coverage(sheet)[6:9, 5:9] == cells.reshape(3, 4)).all()
    assert (coverage(sheet)[35, 46:] == cells[:2]).all()
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
    assert (picture(sheet)[:2, 45:] == image.reshape(4, 5, 3)[2:, :3]).all()
    assert (picture(sheet)[2:] == 200).all()


def test_a_box_outside_the_image_is_empty(sheet):
    assert clip_box(sheet, 50, 3, 60, 9)[2] == 0 and clip_box(sheet, -9, -9, -1, -1)[2:] == (0, 0)
