"""What most triangles of a part have."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import int32, int64, uint8
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes.mesh_components import has_marked
from pointloom.kernels.meshes.mesh_edits import repeated_positions
from pointloom.kernels.meshes.part_votes import follow_majority, keep_alone


@pytest.mark.parametrize("other", [False, True])
def test_parts_of_which_most_are_marked_turn_over(device, other):
    """Part 0 has two marks of three, part 3 one of two, part 5 none of one."""
    place = resolve_device(device)
    names, marks = (
        upload(np.array([0, 0, 0, 3, 3, 5]), int32, place),
        upload(np.array([1, 0, 1, 1, 0, 0]), uint8, place),
    )
    follow_majority(names, marks, other)
    wanted = np.array([0, 1, 0, 1, 0, 0])
    np.testing.assert_array_equal(download(marks), 1 - wanted if other else wanted)


def test_marks_stay_on_triangles_that_are_alone(device):
    place = resolve_device(device)
    names, mask = upload(np.array([0, 1, 1, 3, 4]), int32, place), upload(np.array([1, 1, 0, 0, 1]), uint8, place)
    keep_alone(names, mask)
    assert download(mask).tolist() == [1, 0, 0, 0, 1]


def test_places_where_a_row_was_listed_before(device, rng):
    rows = rng.permutation(np.r_[np.arange(40), rng.integers(0, 40, 60)])
    later = download(repeated_positions(upload(rows, int32, resolve_device(device)), 40))
    first = np.unique(rows, return_index=True)[1]
    np.testing.assert_array_equal(later, np.setdiff1d(np.arange(100), first))


def test_parts_that_hold_a_mark_among_the_first_triangles(device):
    place = resolve_device(device)
    labels, marks = upload(np.array([0, 2, 1, 2, 3]), int64, place), upload(np.array([0, 0, 1, 1]), uint8, place)
    assert has_marked(labels, marks, 4).tolist() == [False, True, True, False]
