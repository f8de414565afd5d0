"""Registration from given correspondences: robust to outliers, with a reason where there is no pose."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom

from .poses import moved
from .wrong_pairs import assert_no_pose, fgr, made_up, ransac, robust

reg = loom.registration
# For each method: its call, the minimal number of correspondences, and the pose errors [degrees], [m].
METHODS = {"ransac": (ransac, 3, 0.05, 1e-3), "fgr": (fgr, 10, 0.5, 0.01), "robust": (robust, 3, 0.5, 0.01)}
EACH = pytest.mark.parametrize("method", METHODS)


@pytest.mark.parametrize(
    ("method", "outliers"),
    [("ransac", 0.0), ("ransac", 0.95), ("fgr", 0.0), ("fgr", 0.8), ("fgr", 0.95), ("robust", 0.5), ("robust", 0.98)],
)
def test_the_pose_is_estimated_among_outlier_correspondences(device, rng, method, outliers, angle_between):
    case, (run, _, degrees, distance) = made_up(rng, outliers=outliers), METHODS[method]
    result = run(case, device)
    assert angle_between(result.transformation, case.T) < degrees
    assert np.linalg.norm(result.transformation[:3, 3] - case.T[:3, 3]) < distance
    assert result.fitness > 0.95 and result.converged and result.transformation.dtype == np.float64


@EACH
def test_too_few_correspondences_fail_with_a_reason(device, rng, method):
    run, minimum, _, _ = METHODS[method]
    for count in (0, 1, minimum - 1):
        case = made_up(rng, 50, outliers=0.0)
        case.pairs = case.pairs[:count]
        result = run(case, device)
        assert (result.transformation == np.eye(4)).all() and result.score == 0 and not result.converged
        (warning,) = result.warnings
        assert f"{count} given" in warning or f"of {count} correspondences" in warning


def test_empty_clouds_fail_with_a_reason(device):
    empty, one = loom.PointCloud(np.empty((0, 3)), device=device), loom.PointCloud([[0, 0, 0]], device=device)
    for pair in ((empty, empty), (empty, one), (one, empty)):
        result = reg.registration_ransac_based_on_correspondence(*pair, np.empty((0, 2)), 0.1)
        assert_no_pose(result, "0 given")
        features = [np.zeros((len(cloud), 33), np.float32) for cloud in pair]
        assert_no_pose(reg.registration_ransac_based_on_feature_matching(*pair, *features, True, 0.1), "0 given")
        assert_no_pose(reg.registration_fgr_based_on_feature_matching(*pair, *features), "0 given")


@pytest.mark.parametrize("shape", ["one place", "line", "plane"])
def test_degenerate_clouds_raise_no_exception(device, rng, shape):
    t = rng.uniform(-1, 1, (200, 1))
    points = {
        "one place": np.ones((200, 3)),
        "line": t * [1, 2, 3],
        "plane": np.column_stack([t, rng.uniform(-1, 1, 200), np.zeros(200)]),
    }[shape]
    case = SimpleNamespace(
        source=points, target=np.add(points, [1.0, 0, 0]), pairs=np.column_stack([np.arange(200)] * 2)
    )
    rules, scaled = reg.RANSACConvergenceCriteria(3000), reg.TransformationEstimationPointToPoint(True)
    results = [ransac(case, device, estimation_method=method, criteria=rules) for method in (None, scaled)]
    results += [fgr(case, device, tuple_test=tested) for tested in (True, False)]
    for k, result in enumerate(results):
        assert np.isfinite(result.transformation).all()
        if shape == "one place" and k < 3:
            assert_no_pose(result, "no hypothesis passed" if k < 2 else "0 left")
        else:
            np.testing.assert_allclose(moved(points, result.transformation), case.target, atol=1e-5)
            assert result.fitness == 1
