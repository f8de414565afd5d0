"""Text and lines on an image are sharp, at the given position, and change nothing else."""

import unicodedata

import numpy as np
import pytest

from pointloom.visualization.render.canvas import MAX_COORDINATE, Canvas, clip_segments
from pointloom.visualization.render.lettering import UNKNOWN, Lettering, lettering

BLACK, RED = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0)


def darkness(canvas):
    return 255 - canvas.to_numpy().min(axis=2).astype(int)


def ink_box(canvas):
    """Left, top, right, bottom of the drawn pixels."""
    rows, columns = np.nonzero(darkness(canvas))
    return columns.min(), rows.min(), columns.max(), rows.max()


def written(device, text, x=100, y=40, **options):
    canvas = Canvas.blank(200, 80, device=device)
    canvas.text(text, x, y, color=BLACK, **options)
    return canvas


def test_the_anchor_aligns_the_text(device):
    for anchor, fraction in (("left", 0.0), ("center", 0.5), ("right", 1.0)):
        left, _, right, _ = ink_box(written(device, "HHHH", anchor=anchor, size=16))
        assert left + fraction * (right - left) == pytest.approx(100, abs=2)
    for anchor, edge in (("upper left", 1), ("lower left", 3)):
        assert ink_box(written(device, "HHHH", anchor=anchor, size=16))[edge] == 40


def test_sizes_take_the_nearest_one():
    letters = lettering()
    for size, nearest in ((1, 12), (13, 12), (15, 14), (17, 16), (22, 20), (28, 24), (31, 32), (500, 32)):
        np.testing.assert_array_equal(letters.set("Height 12", size), letters.set("Height 12", nearest))
    assert len({letters.width("Height 12", size) for size in letters.sizes}) == len(letters.sizes)


def test_every_letter_of_ascii_and_the_further_signs_is_there():
    letters = Lettering()
    unknown = letters.set(UNKNOWN, 16).tolist()
    signs = [chr(code) for code in range(33, 127)] + list("°±·…µ×²³–−")
    for size in letters.sizes:
        shapes = {}
        for sign in signs:
            glyphs = letters.set(sign, size)
            assert len(glyphs) == 1 and glyphs.tolist() != unknown, unicodedata.name(sign)
            start, width, height = glyphs[0, :3]
            shapes[sign] = (width, height, letters.coverage[start : start + width * height].tobytes(), glyphs[0, 4])
        assert len(set(shapes.values())) >= len(signs) - 3  # I, l and | look alike


def test_missing_characters_are_drawn_as_a_box(device):
    np.testing.assert_array_equal(written(device, "é漢").to_numpy(), written(device, UNKNOWN * 2).to_numpy())
    np.testing.assert_array_equal(written(device, "a\nb").to_numpy(), written(device, "a b").to_numpy())


def test_a_polyline_is_broken_at_non_finite_points(device):
    canvas = Canvas.blank(60, 20, device=device)
    canvas.polyline([[5, 10], [20, 10], [np.nan, 3], [30, np.inf], [40, 10], [55, 10]], color=BLACK)
    assert np.flatnonzero(darkness(canvas)[10]).tolist() == [*range(5, 21), *range(40, 56)]


def test_lines_far_beyond_the_canvas_are_clipped_correctly(device):
    canvas = Canvas.blank(50, 40, device=device)
    canvas.line(-1e9, -1e9, 1e9, 1e9, color=BLACK)
    assert (np.diagonal(darkness(canvas)) > 250).all()
    before = canvas.to_numpy()
    canvas.line(1e30, 0, 1e30, 1e300)
    canvas.line(-50, 0, -20, 900)
    np.testing.assert_array_equal(canvas.to_numpy(), before)


def test_everything_outside_the_picture_is_left_out(device):
    canvas = Canvas.blank(30, 20, device=device)
    canvas.text("far", 1e30, 5)
    canvas.text("nan", float("nan"), 5)
    canvas.text("below", 5, 200)
    canvas.rectangle(-50, -50, 10, 10, fill=BLACK)
    canvas.rectangle(1e12, 3, 10, 10, fill=BLACK)
    canvas.image(np.zeros((5, 5, 3), np.uint8), 100, -100)
    canvas.segments(np.empty((0, 4)))
    assert not darkness(canvas).any()


LOW, HIGH = (-1.0, 0.5), (2.0, 3.0)
FRACTIONS = np.linspace(0, 1, 2001)


@pytest.mark.parametrize("extent", [1.5, 4.0, 40.0])
def test_a_part_begins_and_ends_where_points_of_the_segment_do(rng, extent):
    segments = rng.uniform(-extent, extent, (200, 4))
    parts, rows = clip_segments(segments, LOW, HIGH)
    visible_parts = dict(zip(rows.tolist(), parts, strict=True))
    assert list(visible_parts) == sorted(visible_parts)
    for row, ends in enumerate(segments):
        points = ends[:2] + FRACTIONS[:, None] * (ends[2:] - ends[:2])
        inside = points[((points >= LOW) & (points <= HIGH)).all(axis=1)]
        step = np.linalg.norm(ends[2:] - ends[:2]) / (len(FRACTIONS) - 1)
        if len(inside):
            np.testing.assert_allclose(visible_parts[row], np.r_[inside[0], inside[-1]], rtol=0, atol=step)
        elif row in visible_parts:  # a corner between two of the points
            assert np.linalg.norm(visible_parts[row][2:] - visible_parts[row][:2]) <= step


def test_inner_segments_are_unchanged_and_non_finite_ones_removed():
    inside = [0.1, 0.7, 1.9, 2.9]
    parts, rows = clip_segments(np.array([[np.nan, 1, 1, 1], inside, [0, 1, 2 * MAX_COORDINATE, 1]]), LOW, HIGH)
    assert parts.tolist() == [inside] and rows.tolist() == [1]


def test_lines_along_the_box_are_in_on_its_edge_and_out_beside_it():
    along = np.array([[-9, 0.5, 9, 0.5], [-9, 0.4, 9, 0.4], [2, 9, 2, -9], [2.1, 9, 2.1, -9]])
    parts, rows = clip_segments(along, LOW, HIGH)
    assert rows.tolist() == [0, 2]
    assert parts.tolist() == [[-1, 0.5, 2, 0.5], [2, 3, 2, 0.5]]
