"""Scale and shift from references, including outliers."""

import numpy as np
import pytest

from pointloom.photogrammetry.depth.alignment import AlignmentError, align_inverse_depth, align_to_distances


def exact(count=200, scale=0.02, shift=0.1, seed=0):
    d = np.random.default_rng(seed).uniform(0, 40, count)
    return d, scale * d + shift


@pytest.mark.parametrize("wrong", [0.0, 0.4, 0.6])
def test_wrong_references_do_not_change_the_fit_to_exact_ones(wrong):
    d, y = exact(400)
    rng = np.random.default_rng(1)
    lost = rng.random(400) < wrong
    far = np.where(rng.random(400) < 0.5, y * rng.uniform(1.3, 5, 400), y * rng.uniform(0.1, 0.7, 400))
    result = align_inverse_depth(d, np.where(lost, far, y))
    assert (result.scale, result.shift) == pytest.approx((0.02, 0.1), rel=1e-9)
    assert result.inlier_share == pytest.approx(1 - lost.mean(), abs=0.08)


def test_the_fit_is_the_weighted_least_squares_of_the_inliers():
    d, y = exact(300)
    y = y * (1 + np.random.default_rng(2).normal(0, 0.01, 300))
    result = align_inverse_depth(d, y)
    rows = np.stack([d / y, 1 / y], 1)
    np.testing.assert_allclose(
        [result.scale, result.shift], np.linalg.lstsq(rows, np.ones(300), rcond=None)[0], rtol=1e-9
    )


def test_the_same_seed_gives_bitwise_identical_results():
    d, y = exact(9000)
    y = y * (1 + np.random.default_rng(2).normal(0, 0.03, 9000))
    assert align_inverse_depth(d, y, seed=3) == align_inverse_depth(d, y, seed=3)


def simulated(z, ok, seed, noise=0.01):
    """A network's map with slow noise, and 300 reference points with an error of 1%, 40% of them wrong."""
    rng = np.random.default_rng(seed)
    d = np.where(ok, 1 / np.where(ok, z, 1), 0)
    d = (d - d[ok].min()) / np.ptp(d[ok])
    rows, columns = z.shape
    slow = np.kron(rng.normal(0, 1, (rows // 32, columns // 32)), np.ones((32, 32)))
    d = 37 * (d + noise * slow) + 5
    v, u = np.nonzero(ok)
    k = rng.choice(len(v), 300, replace=False)
    y = 1 / (z[v[k], u[k]] * (1 + rng.normal(0, 0.01, 300)))
    return d, d[v[k], u[k]], np.where(rng.random(300) < 0.4, 1 / rng.uniform(0.4, 6, 300), y)


def abs_rel(d, scale, shift, z, ok):
    return float(np.mean(np.abs(1 / np.maximum(scale * d[ok] + shift, 0.05) - z[ok]) / z[ok]))


def errors_of(z, ok):
    """AbsRel of the alignment for several seeds, and of least squares over all pixels with true depth."""
    errors, best = [], []
    for seed in range(7):
        d, x, y = simulated(z, ok, seed)
        result = align_inverse_depth(x, y, seed=seed)
        errors.append(abs_rel(d, result.scale, result.shift, z, ok))
        slope = np.linalg.lstsq(np.stack([d[ok], np.ones(ok.sum())], 1), 1 / z[ok], rcond=None)[0]
        best.append(abs_rel(d, *slope, z, ok))
    return np.array(errors), np.array(best)


def test_40_percent_wrong_points_leave_a_made_up_scene_within_1_3_percent():
    v, u = np.mgrid[:480, :640]
    z = np.minimum(2.0 / np.maximum((v - 200) / 300, 0.3), 4.5) - 1.2 * (np.hypot(u - 250, v - 260) < 90)
    errors, best = errors_of(z, np.ones(z.shape, bool))
    assert np.median(errors) <= 0.013
    assert (errors <= 1.12 * best).all()


def test_metric_depth_is_aligned_by_scale_only():
    d = np.random.default_rng(0).uniform(0.2, 2, 100)
    y = 1.25 * d
    y[::3] *= 3
    result = align_inverse_depth(d, y, with_shift=False)
    assert (result.scale, result.shift) == (pytest.approx(1.25, rel=1e-12), 0.0)
    assert result.inlier_share == pytest.approx(66 / 100)
    assert result.farthest == pytest.approx(1 / y.reshape(-1)[np.arange(100) % 3 > 0].min())


def test_fewer_than_20_inliers_are_rejected():
    d, y = exact(200)
    with pytest.raises(AlignmentError, match=r"^align:.*20.*got 19"):
        align_inverse_depth(d[:19], y[:19])
    assert align_inverse_depth(d[:20], y[:20]).inlier_share == 1.0
    wrong = np.random.default_rng(3).uniform(0.01, 100, 30) ** 2
    with pytest.raises(AlignmentError, match=r"^align:.*30"):
        align_inverse_depth(d[:30], wrong)


def test_a_map_that_decreases_with_inverse_depth_is_rejected():
    d, y = exact(200)
    with pytest.raises(AlignmentError, match=r"^align:"):
        align_inverse_depth(d, y.max() + 0.2 - y)
    with pytest.raises(AlignmentError):
        align_inverse_depth(np.full(50, 3.0), y[:50])


def test_two_distances_determine_scale_and_shift_unchecked():
    result = align_to_distances(np.array([10.0, 30.0]), np.array([0.25, 0.5]))
    assert (result.scale, result.shift, result.inlier_share) == (pytest.approx(0.0125), pytest.approx(0.125), None)
    with pytest.raises(AlignmentError, match=r"^align:"):
        align_to_distances(np.array([10.0, 30.0]), np.array([0.5, 0.25]))
    with pytest.raises(AlignmentError, match=r"^align:.*2.*got 1"):
        align_to_distances(np.array([10.0]), np.array([0.5]))


def test_one_distance_determines_the_scale_unchecked():
    result = align_to_distances(np.array([0.5]), np.array([0.25]), with_shift=False)
    assert (result.scale, result.shift, result.inlier_share) == (0.5, 0.0, None)


def test_a_majority_of_the_distances_must_agree():
    d = np.array([5.0, 10.0, 20.0, 30.0, 40.0])
    y = 0.0125 * d + 0.125
    wrong = y.copy()
    wrong[1] *= 3
    result = align_to_distances(d, wrong)
    assert (result.scale, result.shift) == pytest.approx((0.0125, 0.125), rel=1e-9)
    assert result.inlier_share == pytest.approx(0.8)
    wrong[[0, 4]] *= (0.2, 6.0)
    with pytest.raises(AlignmentError, match=r"^align:.*5"):
        align_to_distances(d, wrong)
    half = np.array([5.0, 10.0, 20.0, 30.0, 40.0, 50.0])
    with pytest.raises(AlignmentError, match=r"^align:.*6.*got 3"):
        align_to_distances(half, (0.0125 * half + 0.125) * (1, 2, 1, 9, 1, 0.2))
    with pytest.raises(AlignmentError, match=r"^align:.*3.*got 2"):
        align_to_distances(d[:3], y[:3] * (1, 1, 4))
