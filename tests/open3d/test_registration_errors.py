"""Registration of the bridge: NDT, and invalid arguments, for which Open3D raises RuntimeError."""

import copy
import pickle

import numpy as np
import pytest

import pointloom.open3d as bridge

reg = bridge.pipelines.registration
SHIFT = np.array([0.0625, -0.03125, 0.0625])


def cloud_of(points, **vectors):
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(points))
    for name, rows in vectors.items():
        setattr(cloud, name, bridge.utility.Vector3dVector(rows))
    return cloud


def wavy_clouds(package, points):
    """A wavy surface and itself, shifted."""
    vectors = [package.utility.Vector3dVector(p) for p in (points, points + SHIFT)]
    return [package.geometry.PointCloud(vector) for vector in vectors]


def ndt_results(package, points):
    theirs = package.pipelines.registration
    clouds = wavy_clouds(package, points)
    results = []
    for option in ({"voxel_size": 0.5}, {"voxel_size": 0.5, "neighbor_search_type": 0}):
        found = theirs.registration_ndt(*clouds, theirs.NormalDistributionsTransformOption(**option), np.eye(4))
        pairs = np.asarray(found.correspondence_set)
        pairs = pairs[np.argsort(pairs[:, 0], kind="stable")]
        results.append((np.array(found.transformation), found.fitness, found.inlier_rmse, pairs))
    return results


def test_ndt_matches_open3d(oracle, rng):
    x, y = np.round(rng.uniform(-1, 1, (2, 800)) * 2**16) / 2**16
    points = np.column_stack([x, y, np.round(0.3 * np.sin(3 * x) * np.cos(4 * y) * 2**16) / 2**16])
    expected = oracle("open3d/ndt", ndt_results, points)
    for (T, fitness, rmse, pairs), found in zip(expected, ndt_results(bridge, points), strict=True):
        np.testing.assert_allclose(found[0], T, rtol=0, atol=1e-5)  # the default limits end both a step apart
        assert found[1] == pytest.approx(fitness, abs=2 / 800) and found[2] == pytest.approx(rmse, abs=1e-4)
        assert (found[3][: len(pairs)] == pairs[: len(found[3])]).mean() > 0.98
        assert np.abs(T[:3, 3] - SHIFT).max() < 0.02


def option_texts(package):
    kind = package.pipelines.registration.NormalDistributionsTransformOption
    options = kind(), kind(0.25, 7, 1e-7), kind(2, outlier_threshold=4.5, neighbor_search_type=0, max_iteration=100)
    return [repr(one) for option in options for one in (option, copy.copy(option), kind(option))]


def test_ndt_options_have_the_repr_of_open3d(oracle):
    assert option_texts(bridge) == oracle("open3d/ndt_options", option_texts)
    option = reg.NormalDistributionsTransformOption(0.25)
    assert repr(pickle.loads(pickle.dumps(option))) == repr(option) == repr(copy.deepcopy(option))


@pytest.mark.parametrize("options", [
    {"voxel_size": -1.0}, {"voxel_size": np.inf}, {"min_points_per_voxel": 3}, {"covariance_regularization": 1.0},
    {"transformation_epsilon": 0.0}, {"relative_objective": np.nan}, {"max_iteration": 0}, {"outlier_threshold": 0.0},
    {"neighbor_search_type": 2},
])  # fmt: skip
def test_invalid_ndt_options_are_rejected_when_made_and_when_used(options):
    (name, value) = next(iter(options.items()))
    for kind in (RuntimeError, ValueError):
        with pytest.raises(kind, match=f"{name}:"):
            reg.NormalDistributionsTransformOption(**options)
    option = reg.NormalDistributionsTransformOption()
    setattr(option, name, value)
    cloud = cloud_of(np.random.default_rng(0).random((50, 3)))
    with pytest.raises(RuntimeError, match=f"{name}:"):
        reg.registration_ndt(cloud, cloud, option)


def test_ndt_takes_no_criteria_of_icp_and_needs_voxels():
    cloud = cloud_of(np.random.default_rng(0).random((50, 3)))
    for arguments in ((None, np.eye(4), reg.ICPConvergenceCriteria()), (reg.ICPConvergenceCriteria(),)):
        with pytest.raises(TypeError):
            reg.registration_ndt(cloud, cloud, *arguments)
    with pytest.raises(RuntimeError, match=r"voxel_size: .*Increase it"):
        reg.registration_ndt(cloud, cloud, reg.NormalDistributionsTransformOption(0.001))
    empty = reg.registration_ndt(cloud_of(np.empty((0, 3))), cloud)
    assert empty.fitness == 0 and len(empty.correspondence_set) == 0 and np.array_equal(empty.transformation, np.eye(4))


PAIRS = bridge.utility.Vector2iVector([[0, 0]])
CALLS = {
    "registration_icp": lambda a, b: reg.registration_icp(a, b, -1.0),
    "evaluate_registration": lambda a, b: reg.evaluate_registration(a, b, 0.1, np.zeros((4, 4))),
    "plane": lambda a, b: reg.registration_icp(a, b, 0.1, np.eye(4), reg.TransformationEstimationPointToPlane()),
    "plane step": lambda a, b: reg.TransformationEstimationPointToPlane().compute_transformation(a, b, PAIRS),
    "plane rmse": lambda a, b: reg.TransformationEstimationPointToPlane().compute_rmse(a, b, PAIRS),
    "symmetric": lambda a, b: reg.registration_symmetric_icp(a, b, 0.1),
    "colored": lambda a, b: reg.registration_colored_icp(a, b, 0.1),
    "features": lambda a, _: reg.compute_fpfh_feature(a, bridge.geometry.KDTreeSearchParamKNN(5)),
}


def errors_of(package, points):
    """The names of the errors of the calls."""
    module, places = package.pipelines.registration, globals()
    kept = {name: places[name] for name in ("reg", "bridge", "PAIRS")}
    places.update(reg=module, bridge=package, PAIRS=package.utility.Vector2iVector([[0, 0]]))
    clouds = [package.geometry.PointCloud(package.utility.Vector3dVector(points)) for _ in range(2)]
    names = []
    try:
        for call in CALLS.values():
            try:
                call(*clouds)
                names.append("none")
            except Exception as error:
                names.append("RuntimeError" if isinstance(error, RuntimeError) else type(error).__name__)
    finally:
        places.update(kept)
    return names


def test_invalid_arguments_are_runtime_errors_and_value_errors(oracle):
    points = np.random.default_rng(0).random((20, 3))
    theirs = dict(zip(CALLS, oracle("open3d/registration_errors", errors_of, points), strict=True))
    assert sum(name == "RuntimeError" for name in theirs.values()) >= 5
    for name, call in CALLS.items():
        if theirs[name] == "RuntimeError":
            for kind in (RuntimeError, ValueError):
                with pytest.raises(kind):
                    call(cloud_of(points), cloud_of(points))


def test_symmetric_icp_names_the_cloud_without_normals():
    bare, full = cloud_of(np.eye(3)), cloud_of(np.eye(3), normals=np.eye(3))
    for pair, name in (((bare, full), "source"), ((full, bare), "target")):
        with pytest.raises(RuntimeError, match=rf"{name}: .* call {name}\.estimate_normals"):
            reg.registration_symmetric_icp(*pair, 0.1)
