"""The checks of what users pass in: each at its limit, and a step beyond."""

import numpy as np
import pytest

from pointloom.core.checks import LARGEST_NUMBER, check_count, check_positive, check_rigid, check_rows, check_seed
from pointloom.core.pose_checks import is_plainly_rigid


@pytest.mark.parametrize("value", [True, False, np.True_, np.False_, 2.0, "2", None, np.float64(3)])
def test_counts_are_integers_and_not_booleans(value):
    with pytest.raises(TypeError, match=r"^max_nn:"):
        check_count("max_nn", value, minimum=0)


def test_a_count_may_equal_its_minimum():
    assert check_count("n", 1) == 1 and check_count("n", np.int64(7), minimum=7) == 7
    for value, minimum in ((0, 1), (6, 7), (-1, 0)):
        with pytest.raises(ValueError, match=f"^n: expected an integer >= {minimum}, got {value}"):
            check_count("n", value, minimum=minimum)


def test_a_length_may_be_zero_only_where_that_is_allowed():
    assert check_positive("size", 0, allow_zero=True) == 0 and check_positive("size", 5e-324) > 0
    for value in (0, -1e-300, np.nan, np.inf, -np.inf):
        with pytest.raises(ValueError, match=r"^size:"):
            check_positive("size", value)


def test_a_seed_is_below_two_to_the_31st():
    assert check_seed(2**31 - 1) == 2**31 - 1 and check_seed(0) == 0
    for value in (2**31, -1):
        with pytest.raises(ValueError, match=r"^seed:"):
            check_seed(value)


def test_a_pose_may_be_rounded_but_no_mirror_and_no_scale():
    rounded = np.eye(4)
    rounded[0, 0] = 1.009  # R R^T is off by 0.018
    assert check_rigid("T", rounded) is not None
    scaled, mirrored, projective = np.eye(4), np.diag([1.0, 1, -1, 1]), np.eye(4)
    scaled[0, 0], projective[3, 0] = 1.011, 1e-3  # ... by 0.022
    for wrong in (scaled, mirrored, projective):
        with pytest.raises(ValueError, match=r"^T:"):
            check_rigid("T", wrong)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e200, -0.5])
def test_a_pose_with_one_invalid_number_is_rejected(bad):
    for row, column in np.ndindex(4, 4):
        wrong = np.eye(4)
        wrong[row, column] = bad
        if abs(bad) == 0.5 and column == 3 and row < 3:
            continue  # a translation
        with pytest.raises(ValueError, match=r"^T:"):
            check_rigid("T", wrong)


@pytest.mark.parametrize("tolerance", [1e-12, 1e-6, 0.02])
def test_the_fast_check_of_poses_agrees_with_numpy(tolerance):
    rng = np.random.default_rng(0)
    plain = 0
    for _ in range(300):
        R = np.linalg.qr(rng.standard_normal((3, 3)))[0] + rng.uniform(-2, 2) * tolerance * rng.random((3, 3))
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = R, rng.standard_normal(3)
        is_rigid = np.abs(R @ R.T - np.eye(3)).max() <= tolerance and np.linalg.det(R) > 0
        is_plain = is_plainly_rigid(T.tolist(), tolerance, LARGEST_NUMBER)
        assert is_rigid or not is_plain
        plain += is_plain
    assert 20 < plain < 200


def test_rows_have_the_requested_width_and_count():
    assert check_rows("p", [], 3).shape == (0, 3)
    for values, rows in (([[1, 2]], None), ([1, 2, 3], None), ([[1, 2, 3]], 2)):
        with pytest.raises(ValueError, match=r"^p:"):
            check_rows("p", values, 3, rows=rows)


def test_a_number_beyond_float32_is_refused_and_infinity_is_not():
    assert np.isinf(check_rows("p", [[np.inf, 0, 0]], 3, dtype=np.float32)[0, 0])
    with pytest.raises(ValueError, match=r"^p:"):
        check_rows("p", [[1e39, 0, 0]], 3, dtype=np.float32)
