"""Accepted and reverted iterations, and the end of the search."""

import numpy as np
import pytest

from pointloom.kernels.lang import float64, launch, mat44d
from pointloom.kernels.memory import download, empty, upload, zeros
from pointloom.kernels.textures import color_steps as steps


def judge(state, squares, warp_device, counts=(10.0, 10.0)):
    sums = np.zeros((2, 29))
    sums[:, steps.SQUARES], sums[:, steps.COUNT] = squares, counts
    given = upload(sums, steps.pose_sums, warp_device)
    launch(steps.judge_iteration_kernel, 1, [given, zeros(2, float64, warp_device), state])
    return given, download(state.error).copy(), int(download(state.running)[0]), int(download(state.outcome)[0])


def test_an_iteration_that_increases_the_residual_is_reverted(device):
    state = steps.SearchState(10, device)
    good, *_ = judge(state, (1.0, 2.0), device)
    poses, best = upload(np.tile(np.eye(4), (2, 1, 1)), mat44d, device), empty(2, mat44d, device)
    best_sums = zeros(2, steps.pose_sums, device)
    launch(steps.keep_best_kernel, 2, [state, good, poses, best_sums, best])
    worse, error, running, outcome = judge(state, (3.0, 2.0), device)
    moved = upload(np.tile(2 * np.eye(4), (2, 1, 1)), mat44d, device)
    launch(steps.keep_best_kernel, 2, [state, worse, moved, best_sums, best])
    assert outcome == 0 and running == 1 and error[1] == pytest.approx(0.15) and error[3] == pytest.approx(0.25)
    assert error[2] > steps.FIRST_DAMPING
    assert (download(moved)[:, 0, 0] == 1).all() and (download(best_sums)[:, steps.SQUARES] == (1, 2)).all()


@pytest.mark.parametrize(
    ("all_squares", "counts", "ends"),
    [
        (((3.0, 2.0), (1.0, 1.0)), (10.0, 10.0), False),
        (((3.0, 2.0), (2.9999999, 2.0)), (10.0, 10.0), True),  # nearly nothing won
        (((3.0, 2.0), (1.0, 1.0), (0.5, 0.5)), (10.0, 10.0), True),  # out of iterations
        (((0.0, 0.0),), (0.0, 0.0), True),  # no pairs
    ],
)
def test_the_search_ends_where_nothing_is_won_or_left(device, all_squares, counts, ends):
    state = steps.SearchState(2, device)
    for squares in all_squares:
        _, _, running, _ = judge(state, squares, device, counts)
    assert (running == 0) == ends


def test_damping_without_end_ends_the_search(device):
    state = steps.SearchState(1000, device)
    judge(state, (1.0, 1.0), device)
    iterations = 0
    while judge(state, (2.0, 2.0), device)[2]:
        iterations += 1
    assert iterations < 20
