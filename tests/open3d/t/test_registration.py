"""Registration of tensor clouds, and argument names of tensor geometries, as in Open3D."""

import copy
import inspect
import pickle
import re

import numpy as np
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom.open3d as bridge
from pointloom.core.open3d_names import SHAPES, row_of

SIDE, DISTANCE = 40, 0.1
POSE = np.eye(4)  # of the target in the source
POSE[:3, :3], POSE[:3, 3] = Rotation.from_rotvec([0.02, -0.01, 0.03]).as_matrix(), (0.02, -0.01, 0.015)


def wave():
    """Points, normals and colors of a surface."""
    x, y = (axis.ravel() for axis in np.meshgrid(*[np.linspace(0, 1, SIDE)] * 2))
    slope = np.cos(6 * x + 2 * y)
    slopes = np.column_stack([-0.6 * slope, -0.2 * slope + 0.3 * np.sin(5 * y), 1 + 0 * x])
    points = np.column_stack([x, y, 0.1 * np.sin(6 * x + 2 * y) + 0.06 * np.cos(5 * y)])
    colors = 0.5 + 0.4 * np.sin(np.array([3, 5, 7]) * x[:, None])
    return points, slopes / np.linalg.norm(slopes, axis=1, keepdims=True), colors


def clouds_of(package, dtype=np.float64, device="CPU:0", **attributes):
    """The wave, and the wave in other coordinates with every second point missing."""
    points, normals, colors = wave()
    keep = np.arange(len(points)) % 2 == 0
    moved = (points - POSE[:3, 3]) @ POSE[:3, :3]
    sides = (moved[keep], normals[keep] @ POSE[:3, :3], colors[keep]), (points, normals, colors)
    clouds = []
    for values in sides:
        cloud = package.t.geometry.PointCloud(package.core.Device(device))
        for name, array in zip(("positions", "normals", "colors"), values, strict=True):
            cloud.point[name] = package.core.Tensor(array.astype(dtype), device=package.core.Device(device))
        clouds.append(cloud)
    return clouds


def methods_of(reg):
    tukey = reg.robust_kernel.RobustKernel(reg.robust_kernel.RobustKernelMethod.TukeyLoss, 0.05)
    return {
        "point": reg.TransformationEstimationPointToPoint(),
        "plane": reg.TransformationEstimationPointToPlane(),
        "tukey": reg.TransformationEstimationPointToPlane(tukey),
        "symmetric": reg.TransformationEstimationSymmetric(),
    }


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_icp_finds_the_motion_and_its_results_are_tensors(device, dtype):
    reg, (source, target) = bridge.t.pipelines.registration, clouds_of(bridge, dtype, device.upper())
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 60)
    methods = methods_of(reg) | {"colored": reg.TransformationEstimationForColoredICP()}
    for name, method in methods.items():
        states = []
        found = reg.icp(source, target, DISTANCE, np.eye(4), method, rules, callback_after_iteration=states.append)
        assert np.allclose(found.transformation.numpy(), POSE, atol=1e-5), name
        assert (found.fitness, found.converged, found.num_iterations) == (1.0, True, len(states))
    pairs, T = found.correspondence_set, found.transformation
    assert str(T.device) == "CPU:0" and T.numpy().dtype == np.float64
    assert pairs.device == source.device and pairs.numpy().dtype == np.int64
    assert np.array_equal(pairs.numpy()[:, 0], np.arange(0, SIDE * SIDE, 2))
    assert [int(state["iteration_index"].numpy()) for state in states] == [*range(len(states))]
    assert np.allclose(states[-1]["transformation"].numpy(), POSE, atol=1e-5)
    names = "iteration_index", "scale_index", "scale_iteration_index", "inlier_rmse", "fitness", "transformation"
    assert {*states[0]} == {*names}


def registrations_of(package):
    reg, (source, target) = package.t.pipelines.registration, clouds_of(package)
    start, lengths = np.eye(4), package.utility.DoubleVector
    results = {}
    for name, method in methods_of(reg).items():
        rules = reg.ICPConvergenceCriteria(0.0, 0.0, 3)
        found = reg.icp(source, target, DISTANCE, start, method, rules)
        scales = [lengths([0.1, 0.05, -1]), [rules] * 3, lengths([0.2, 0.1, 0.05])]
        again = reg.multi_scale_icp(source, target, *scales, start, method)
        for kind, result in (("icp", found), ("scales", again)):
            numbers = np.array([result.fitness, result.inlier_rmse, result.num_iterations])
            results[f"{name} {kind}"] = numbers, result.transformation.numpy()
    coarse = reg.icp(source, target, DISTANCE, start, criteria=rules, voxel_size=0.08)
    results["shape"] = np.array(coarse.correspondence_set.numpy().shape)  # voxels have another order in Open3D
    evaluated = reg.evaluate_registration(source, target, 0.02, start)
    results["evaluated"] = evaluated.correspondence_set.numpy(), evaluated.fitness, evaluated.inlier_rmse
    results["information"] = reg.get_information_matrix(source, target, DISTANCE, POSE).numpy()
    return results


def test_results_are_those_of_open3d(oracle):
    expected, actual = oracle("open3d/t/registration", registrations_of), registrations_of(bridge)
    assert expected.keys() == actual.keys()
    for name, values in expected.items():
        for number, other in zip(values, actual[name], strict=True):
            assert np.allclose(number, other, atol=3e-5, rtol=1e-5), name


def test_correspondences_are_the_nearest_points_or_minus_one():
    reg, (source, target) = bridge.t.pipelines.registration, clouds_of(bridge)
    found = reg.evaluate_registration(source, target, 0.028)
    distances, nearest = cKDTree(target.point.positions.numpy()).query(source.point.positions.numpy())
    met = distances < 0.028
    assert 0.1 < met.mean() < 0.9 and found.fitness == pytest.approx(met.mean())
    assert np.array_equal(found.correspondence_set.numpy(), np.where(met, nearest, -1)[:, None])
    assert found.inlier_rmse == pytest.approx(np.sqrt((distances[met] ** 2).mean()), rel=1e-5)
    p, q = source.point.positions.numpy()[met], target.point.positions.numpy()[nearest[met]]
    n = target.point.normals.numpy()[nearest[met]]
    for pairs in (found.correspondence_set, bridge.core.Tensor(found.correspondence_set.numpy()[:, 0])):
        point, plane = reg.TransformationEstimationPointToPoint(), reg.TransformationEstimationPointToPlane()
        assert point.compute_rmse(source, target, pairs) == pytest.approx(found.inlier_rmse, rel=1e-5)
        # Open3D sums the squares of the components of gap times normal instead
        rmse = np.sqrt((((p - q) * n).sum(axis=1) ** 2).mean())
        assert plane.compute_rmse(source, target, pairs) == pytest.approx(rmse, rel=1e-5)
        T = point.compute_transformation(source, target, pairs).numpy()
        best = Rotation.align_vectors(q - q.mean(axis=0), p - p.mean(axis=0))[0].as_matrix()
        assert np.allclose(T[:3, :3], best, atol=1e-9)
        assert np.allclose(T[:3, :3] @ p.mean(axis=0) + T[:3, 3], q.mean(axis=0))
        moved = source.clone().transform(plane.compute_transformation(source, target, pairs))
        assert plane.compute_rmse(moved, target, pairs) < 0.5 * rmse
    with pytest.raises(ValueError, match="correspondences:"):
        plane.compute_rmse(source, target, bridge.core.Tensor(np.zeros(3, np.int64)))


def test_doppler_icp_finds_a_motion_along_a_wall(rng):
    """A plane hides the motion along itself, the radial speeds show it."""
    reg, period = bridge.t.pipelines.registration, 0.1
    points = np.column_stack([rng.uniform(-4, 4, 900), np.full(900, 3.0), rng.uniform(-1, 1, 900)])
    shift = np.array([-0.3, 0.05, 0.0])
    directions = points / np.linalg.norm(points, axis=1, keepdims=True)
    columns = {"positions": points, "dopplers": (directions @ shift / period)[:, None], "directions": directions}
    source, target = (bridge.t.geometry.PointCloud() for _ in range(2))
    for name, values in columns.items():
        source.point[name] = bridge.core.Tensor(values)
    target.point.positions = bridge.core.Tensor(points + shift)
    target.point.normals = bridge.core.Tensor(np.tile([0.0, -1, 0], (900, 1)))
    method = reg.TransformationEstimationForDopplerICP(0.1)
    assert (method.lambda_doppler, method.period) == (0.1, period)
    found = reg.icp(source, target, 1.0, np.eye(4), method, reg.ICPConvergenceCriteria(1e-9, 1e-9, 60))
    assert np.allclose(found.transformation.numpy()[:3, 3], shift, atol=2e-3)
    same = bridge.core.Tensor(np.arange(900))
    step = method.compute_transformation(source, target, same, bridge.core.Tensor(np.eye(4)), 0)
    assert np.allclose(step.numpy()[:3, 3], shift, atol=5e-3)
    assert method.compute_rmse(source, target, same) == pytest.approx(0.05, rel=1e-4)


def test_features_match_the_same_points():
    reg, (source, target) = bridge.t.pipelines.registration, clouds_of(bridge)
    rows = [reg.compute_fpfh_feature(cloud, 60, 0.15) for cloud in (target, target)]
    assert rows[0].shape == (SIDE * SIDE, 33) and str(rows[0].dtype) == "Float64"
    few = reg.compute_fpfh_feature(target, 60, 0.15, bridge.core.Tensor([9, 3, 3]))
    assert np.array_equal(few.numpy(), rows[0].numpy()[[3, 9]])
    pairs = reg.correspondences_from_features(*rows, mutual_filter=True).numpy()
    assert pairs.dtype == np.int64 and (pairs[:, 0] == pairs[:, 1]).mean() > 0.99
    with pytest.raises(ValueError, match="max_nn, radius:"):
        reg.compute_fpfh_feature(source, None, None)


def objects_of(package):
    reg, odometry = package.t.pipelines.registration, package.t.pipelines.odometry
    kernel = reg.robust_kernel.RobustKernel(reg.robust_kernel.GeneralizedLoss, 0.1, -2.0)
    return [
        *(reg.ICPConvergenceCriteria(), reg.RegistrationResult(), kernel, *methods_of(reg).values()),
        *(reg.TransformationEstimationForColoredICP(kernel), reg.TransformationEstimationForColoredICP(0.5)),
        *(reg.TransformationEstimationForDopplerICP(), reg.TransformationEstimationPointToPlane(kernel)),
        *(odometry.OdometryConvergenceCriteria(3), odometry.OdometryLossParams(0.1), odometry.OdometryResult()),
    ]


def test_options_and_results_have_the_repr_of_open3d(oracle):
    texts = oracle("open3d/t/options", lambda open3d: [repr(one) for one in objects_of(open3d)])
    for text, one in zip(texts, objects_of(bridge), strict=True):
        for same in (one, copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one)), type(one)(one)):
            assert repr(same) == text


def test_kernels_weigh_as_their_formulas():
    names = bridge.t.pipelines.registration.robust_kernel
    kernel = names.RobustKernel
    r, k, shape = np.linspace(0.01, 0.5, 20), 0.1, -2.0
    expected = {
        "L2Loss": np.ones(20),
        "L1Loss": 1 / r,
        "HuberLoss": k / np.maximum(r, k),
        "CauchyLoss": 1 / (1 + (r / k) ** 2),
        "GMLoss": k / (k + r**2) ** 2,
        "TukeyLoss": (1 - np.minimum(1, r / k) ** 2) ** 2,
        "GeneralizedLoss": ((r / k) ** 2 / abs(shape - 2) + 1) ** (shape / 2 - 1) / k**2,
    }
    assert [method.name for method in names.RobustKernelMethod] == [*expected]
    for name, weights in expected.items():
        assert np.allclose(kernel(getattr(names, name), k, shape).native.weight(r), weights)
    first = kernel(names.TukeyLoss, k)
    method = bridge.t.pipelines.registration.TransformationEstimationPointToPlane(first)
    first.scaling_parameter = 0.3
    method.kernel.shape_parameter = 0.7
    assert (method.kernel.scaling_parameter, method.kernel.shape_parameter) == (k, 0.7)  # a copy, as in Open3D


def test_arguments_are_checked():
    reg, (source, target) = bridge.t.pipelines.registration, clouds_of(bridge)
    plane, rules = reg.TransformationEstimationPointToPlane, [reg.ICPConvergenceCriteria()] * 2
    with pytest.raises(TypeError, match="source:"):
        reg.icp(source.to_legacy(), target, DISTANCE)
    with pytest.raises(ValueError, match="max_correspondence_distances:"):
        reg.icp(source, target, -1.0)
    with pytest.raises(ValueError, match="voxel_sizes"):
        reg.multi_scale_icp(source, target, [0.1, 0.2], rules, [0.1, 0.1])
    with pytest.raises(TypeError, match="estimation_method:"):
        reg.registration_symmetric_icp(source, target, DISTANCE, np.eye(4), plane())
    with pytest.raises(TypeError, match="type:"):
        reg.icp(source, target, 0.1, np.eye(4), plane(reg.robust_kernel.RobustKernel(5)))
    del target.point["normals"]
    with pytest.raises(ValueError, match="target:"):
        reg.icp(source, target, DISTANCE, np.eye(4), plane())


CLASSES = ("TensorMap", "PointCloud", "LineSet", "Image", "RGBDImage", "AxisAlignedBoundingBox", "OrientedBoundingBox")
FUNCTIONS = ("read_point_cloud", "write_point_cloud", "read_image", "write_image")
ROLES = {"self", "arg0", "arg1"}  # names that no caller writes
NOT_TAKEN = {"gaussian_splat_antialias"}


def arguments(thing, name):
    """Argument names of each overload, from the first lines of a docstring."""
    found = re.findall(rf"^(?:\d+\. )?{name}\((.*)\) ->", thing.__doc__ or "", re.MULTILINE)
    names = [[word for word in re.findall(r"(\w+): ", line) if word not in ROLES] for line in found]
    return ["property" if not found else " ".join(overload) for overload in (names or [[]])]


def signatures(o3d, owner):
    parent = o3d.t.io if owner == "io" else getattr(o3d.t.geometry, owner)
    names = FUNCTIONS if owner == "io" else [name for name in dir(parent) if not name.startswith("_")]
    return {name: arguments(getattr(parent, name), name) for name in names}


@pytest.mark.parametrize("owner", [*CLASSES, "io"])
def test_arguments_have_their_names(oracle, owner):
    parent = bridge.t.io if owner == "io" else getattr(bridge.t.geometry, owner)
    for name, overloads in oracle(f"open3d/t/signatures_{owner}", signatures, owner).items():
        made = inspect.getattr_static(parent, name, None) if owner != "io" else getattr(parent, name)
        is_field = any(name in getattr(base, "__annotations__", {}) for base in getattr(parent, "__mro__", ()))
        if made is None and not is_field:
            assert row_of(name, (*(base.__name__ for base in parent.__mro__), SHAPES)), f"{owner}.{name}: no row"
            continue
        if [*overloads] == ["property"]:
            continue
        taken = inspect.signature(getattr(parent, name)).parameters
        takes_any = any(part.kind is part.VAR_KEYWORD for part in taken.values())
        for overload in overloads:
            assert takes_any or {*overload.split()} - NOT_TAKEN <= {*taken}, f"{owner}.{name}({overload})"
