"""The verdict on a turn: what is kept, what is taken back, and when the search ends."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels.lang import float64, launch, mat44d
from pointloom.kernels.memory import download, empty, upload, zeros
from pointloom.kernels.textures.color_steps import (
    COUNT,
    FIRST_DAMPING,
    SQUARES,
    SearchState,
    judge_iteration_kernel,
    keep_best_kernel,
    pose_sums,
)


def judge(state, squares, place, counts=(10.0, 10.0)):
    """The state after a turn of two pictures with these sums of squares."""
    sums = np.zeros((2, 29))
    sums[:, SQUARES], sums[:, COUNT] = squares, counts
    given = upload(sums, pose_sums, place)
    launch(judge_iteration_kernel, 1, [given, zeros(2, float64, place), state])
    return given, download(state.error).copy(), int(download(state.running)[0]), int(download(state.outcome)[0])


def test_a_turn_that_makes_the_residual_larger_is_taken_back(device):
    place = wp.get_device(device)
    state = SearchState(10, place)
    good, *_ = judge(state, (1.0, 2.0), place)
    poses, best = upload(np.tile(np.eye(4), (2, 1, 1)), mat44d, place), empty(2, mat44d, place)
    best_sums = zeros(2, pose_sums, place)
    launch(keep_best_kernel, 2, [state, good, poses, best_sums, best])
    worse, error, running, outcome = judge(state, (3.0, 2.0), place)
    moved = upload(np.tile(2 * np.eye(4), (2, 1, 1)), mat44d, place)
    launch(keep_best_kernel, 2, [state, worse, moved, best_sums, best])
    assert outcome == 0 and running == 1 and error[1] == pytest.approx(0.15) and error[3] == pytest.approx(0.25)
    assert error[2] > FIRST_DAMPING
    assert (download(moved)[:, 0, 0] == 1).all() and (download(best_sums)[:, SQUARES] == (1, 2)).all()


@pytest.mark.parametrize(
    ("turns", "counts", "ends"),
    [
        (((3.0, 2.0), (1.0, 1.0)), (10.0, 10.0), False),
        (((3.0, 2.0), (2.9999999, 2.0)), (10.0, 10.0), True),  # nearly nothing won
        (((3.0, 2.0), (1.0, 1.0), (0.5, 0.5)), (10.0, 10.0), True),  # out of turns
        (((0.0, 0.0),), (0.0, 0.0), True),  # no pairs
    ],
)
def test_the_search_ends_where_nothing_is_won_or_left(device, turns, counts, ends):
    place = wp.get_device(device)
    state = SearchState(2, place)
    for squares in turns:
        _, _, running, _ = judge(state, squares, place, counts)
    assert (running == 0) == ends


def test_damping_without_end_ends_the_search(device):
    place = wp.get_device(device)
    state = SearchState(1000, place)
    judge(state, (1.0, 1.0), place)
    turns = 0
    while judge(state, (2.0, 2.0), place)[2]:
        turns += 1
    assert turns < 20
