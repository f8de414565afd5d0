"""What most triangles of a part have."""

import numpy as np
import pytest

from pointloom.kernels.lang import int32, int64, uint8
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes.mesh_components import has_marked
from pointloom.kernels.meshes.mesh_edits import repeated_positions
from pointloom.kernels.meshes.part_votes import follow_majority, keep_alone


@pytest.mark.parametrize("other", [False, True])
def test_parts_with_a_majority_of_marks_flip(device, other):
    """Part 0 has two marks of three, part 3 one of two, part 5 none of one."""
    names = upload(np.array([0, 0, 0, 3, 3, 5]), int32, device)
    marks = upload(np.array([1, 0, 1, 1, 0, 0]), uint8, device)
    follow_majority(names, marks, other)
    majority = np.array([0, 1, 0, 1, 0, 0])
    np.testing.assert_array_equal(download(marks), 1 - majority if other else majority)


def test_marks_stay_on_isolated_triangles(device):
    names, mask = (upload(np.array([0, 1, 1, 3, 4]), int32, device), upload(np.array([1, 1, 0, 0, 1]), uint8, device))
    keep_alone(names, mask)
    assert download(mask).tolist() == [1, 0, 0, 0, 1]


def test_positions_of_repeated_rows(device, rng):
    rows = rng.permutation(np.r_[np.arange(40), rng.integers(0, 40, 60)])
    repeated = download(repeated_positions(upload(rows, int32, device), 40))
    first = np.unique(rows, return_index=True)[1]
    np.testing.assert_array_equal(repeated, np.setdiff1d(np.arange(100), first))


def test_parts_with_a_mark_among_the_first_triangles(device):
    labels, marks = (upload(np.array([0, 2, 1, 2, 3]), int64, device), upload(np.array([0, 0, 1, 1]), uint8, device))
    assert has_marked(labels, marks, 4).tolist() == [False, True, True, False]
