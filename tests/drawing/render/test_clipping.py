"""What is left of segments in a box is what points along them say."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.drawing.render.clipping import FARTHEST, clip_segments

LOW, HIGH = (-1.0, 0.5), (2.0, 3.0)
SHARES = np.linspace(0, 1, 2001)


@pytest.mark.parametrize("reach", [1.5, 4.0, 40.0])
def test_a_part_begins_and_ends_where_points_of_the_segment_do(rng, reach):
    segments = rng.uniform(-reach, reach, (200, 4))
    parts, rows = clip_segments(segments, LOW, HIGH)
    kept = dict(zip(rows.tolist(), parts, strict=True))
    assert list(kept) == sorted(kept)
    for row, ends in enumerate(segments):
        points = ends[:2] + SHARES[:, None] * (ends[2:] - ends[:2])
        inside = points[((points >= LOW) & (points <= HIGH)).all(axis=1)]
        step = np.linalg.norm(ends[2:] - ends[:2]) / (len(SHARES) - 1)
        if len(inside):
            np.testing.assert_allclose(kept[row], np.r_[inside[0], inside[-1]], rtol=0, atol=step)
        elif row in kept:  # a corner that lies between two of the points
            assert np.linalg.norm(kept[row][2:] - kept[row][:2]) <= step


def test_a_segment_inside_stays_as_it_is_and_one_that_is_not_finite_goes():
    inside = [0.1, 0.7, 1.9, 2.9]
    parts, rows = clip_segments(np.array([[np.nan, 1, 1, 1], inside, [0, 1, 2 * FARTHEST, 1]]), LOW, HIGH)
    assert parts.tolist() == [inside] and rows.tolist() == [1]


def test_lines_along_the_box_are_in_on_its_edge_and_out_beside_it():
    along = np.array([[-9, 0.5, 9, 0.5], [-9, 0.4, 9, 0.4], [2, 9, 2, -9], [2.1, 9, 2.1, -9]])
    parts, rows = clip_segments(along, LOW, HIGH)
    assert rows.tolist() == [0, 2]
    assert parts.tolist() == [[-1, 0.5, 2, 0.5], [2, 3, 2, 0.5]]
