"""Every estimator with every kernel takes Open3D's steps: the first one, and where all of them have led."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom

from .estimator_steps import DISTANCE, on, ours_after, tensor_after, tensor_cloud, tensor_kernel
from .poses import as_pose

reg = loom.registration
STEPS = pytest.mark.parametrize("steps", [1, 20])
KERNELS = {
    "L2Loss": (), "L1Loss": (), "HuberLoss": (0.01,), "CauchyLoss": (0.02,), "GMLoss": (0.01,), "TukeyLoss": (0.06,),
}  # fmt: skip


def wavy(rng, count):
    """A wavy surface of 2 x 2 m and the colours on it."""
    xy = rng.uniform(-1, 1, (count, 2))
    z = 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1]) + 0.1 * np.sin(7 * xy[:, 1] + xy[:, 0])
    points = np.column_stack([xy, z])
    return points, 0.5 + 0.4 * np.sin(points @ np.array([[5, 1, 2], [3, 6, 2], [2, 2, 7]]))


@pytest.fixture(scope="module")
def pair():
    """Two samplings of a surface, 3 degrees and 5 cm apart, with normals and colours; 4 % of the source is clutter."""
    rng = np.random.default_rng(2)
    T = as_pose([0.03, -0.04, 0.02], [0.03, -0.03, 0.02])
    (target, paint), (source, colors) = wavy(rng, 2500), wavy(rng, 2000)
    source[:80, 2] += rng.uniform(-0.1, 0.1, 80)
    source = (source - T[:3, 3]) @ T[:3, :3]
    clouds = [loom.PointCloud(p, colors=c) for p, c in ((source, colors), (target, paint))]
    source, target = (c.estimate_normals(max_nn=20) for c in clouds)
    return SimpleNamespace(source=source, target=target, T=T)


@pytest.fixture(scope="module")
def legacy(pair, to_open3d):
    """The pair as Open3D's legacy clouds."""
    return [to_open3d(c.points, c.normals, c.colors) for c in (pair.source, pair.target)]


@pytest.fixture(scope="module")
def tensor(pair):
    """The pair as Open3D's tensor clouds in float64."""
    return [tensor_cloud(c) for c in (pair.source, pair.target)]


def legacy_after(legacy, method, steps, init=None):
    import open3d as o3d

    theirs = o3d.pipelines.registration
    call = theirs.registration_icp
    if isinstance(method, theirs.TransformationEstimationForColoredICP):
        call = theirs.registration_colored_icp
    if isinstance(method, theirs.TransformationEstimationForGeneralizedICP):
        call = theirs.registration_generalized_icp
    init = np.eye(4) if init is None else init
    return call(*legacy, DISTANCE, init, method, theirs.ICPConvergenceCriteria(0, 0, steps))


def assert_same(ours, theirs, tolerance):
    """One pose, and under it the same pairs but for those that so small a motion changes."""
    np.testing.assert_allclose(ours.transformation, theirs.transformation, rtol=0, atol=tolerance)
    assert ours.fitness == pytest.approx(theirs.fitness, abs=tolerance)
    assert ours.inlier_rmse == pytest.approx(theirs.inlier_rmse, abs=tolerance)
    mine, other = (set(map(tuple, np.asarray(r.correspondence_set).tolist())) for r in (ours, theirs))
    assert len(mine ^ other) <= (12 if tolerance > 1e-5 else 0)


def methods(name, *arguments):
    """(ours, Open3D's) of an estimator; kernels by their names."""
    import open3d as o3d

    def make(module):
        class_ = getattr(module, f"TransformationEstimation{name}")
        return class_(*(getattr(module, a)(*KERNELS[a]) if isinstance(a, str) else a for a in arguments))

    return make(reg), make(o3d.pipelines.registration)


# ------------------------------------------------------------------------------------------------ Open3D's legacy ones


@STEPS
@pytest.mark.parametrize("scaling", [False, True])
def test_point_to_point_steps_are_open3ds(device, pair, legacy, scaling, steps, tolerances):
    ours, theirs = methods("PointToPoint", scaling)
    assert_same(ours_after(device, pair, ours, steps), legacy_after(legacy, theirs, steps), tolerances.icp_pose)


@STEPS
@pytest.mark.parametrize("loss", list(KERNELS))
@pytest.mark.parametrize("name", ["PointToPlane", "Symmetric"])
def test_steps_to_planes_are_open3ds(device, pair, legacy, name, loss, steps, tolerances):
    ours, theirs = methods(name, loss)
    tolerance = tolerances.icp_pose_l1 if loss == "L1Loss" and steps > 1 else tolerances.icp_pose
    assert_same(ours_after(device, pair, ours, steps), legacy_after(legacy, theirs, steps), tolerance)


@STEPS
@pytest.mark.parametrize("loss", list(KERNELS))
def test_generalized_steps_are_open3ds(device, pair, legacy, loss, steps, tolerances, monkeypatch):
    monkeypatch.setitem(KERNELS, "HuberLoss", (1.0,))  # residuals of whitened rows have no unit
    monkeypatch.setitem(KERNELS, "TukeyLoss", (5.0,))
    ours, theirs = methods("ForGeneralizedICP", 1e-3, loss)
    tolerance = tolerances.icp_pose_l1 if loss == "L1Loss" else tolerances.icp_pose_float32
    assert_same(ours_after(device, pair, ours, steps), legacy_after(legacy, theirs, steps), tolerance)


@STEPS
@pytest.mark.parametrize("loss", list(KERNELS))
@pytest.mark.parametrize("share", [0.968, 0.5])
def test_colored_steps_are_open3ds(device, pair, legacy, share, loss, steps, tolerances):
    ours, theirs = methods("ForColoredICP", share, loss)
    tolerance = tolerances.icp_pose_l1 if loss == "L1Loss" else tolerances.icp_pose_colored
    assert_same(ours_after(device, pair, ours, steps), legacy_after(legacy, theirs, steps), tolerance)


@pytest.mark.parametrize("loss", list(KERNELS))
def test_colors_of_no_share_leave_point_to_plane(device, pair, loss, tolerances):
    """For L1 too, where Open3D divides the empty rows' zero residuals by zero and stays where it is."""
    colored, plane = (methods(n, *a)[0] for n, a in (("ForColoredICP", (1.0, loss)), ("PointToPlane", (loss,))))
    found, expected = (ours_after(device, pair, method, 3).transformation for method in (colored, plane))
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerances.icp_pose)


@pytest.mark.parametrize("name", ["PointToPoint", "PointToPlane", "Symmetric", "ForGeneralizedICP", "ForColoredICP"])
def test_an_initial_pose_is_stepped_on_from_as_by_open3d(device, pair, legacy, name, tolerances):
    """Source normals and covariances turn with it."""
    init = as_pose([0.05, 0.1, 0.3], [0.05, 0, 0.02]) @ pair.T
    ours, theirs = methods(name)
    tolerance = tolerances.icp_pose_colored if name == "ForColoredICP" else tolerances.icp_pose_float32
    result = legacy_after(legacy, theirs, 3, init)
    assert result.fitness > 0.5
    assert_same(ours_after(device, pair, ours, 3, init), result, tolerance)


def test_own_covariances_are_taken_before_normals(device, pair, legacy, rng, tolerances):
    """Each cloud on its own: one brings covariances, the other one's follow from its normals."""
    import open3d as o3d

    A = 0.2 * rng.normal(size=(len(pair.source), 3, 3)) + np.diag([1.0, 0.7, 0.1])
    C = (A @ A.transpose(0, 2, 1) + 0.01 * np.eye(3)).astype(np.float32)
    source = loom.PointCloud(pair.source.points, normals=pair.source.normals, covariances=C.reshape(-1, 9))
    theirs = o3d.geometry.PointCloud(legacy[0])
    theirs.covariances = o3d.utility.Matrix3dVector(C.astype(np.float64))
    ours = ours_after(device, SimpleNamespace(source=source, target=pair.target), methods("ForGeneralizedICP")[0], 5)
    expected = legacy_after([theirs, legacy[1]], methods("ForGeneralizedICP")[1], 5)
    assert_same(ours, expected, tolerances.icp_pose_float32)
    without = ours_after(device, pair, methods("ForGeneralizedICP")[0], 5)
    assert np.abs(without.transformation - ours.transformation).max() > 1e-4  # they do count


def test_the_functions_of_their_own_are_open3ds(device, pair):
    source, target = on(device, pair.source), on(device, pair.target)
    rules = reg.ICPConvergenceCriteria(0, 0, 2)
    for name, call in (
        ("ForColoredICP", reg.registration_colored_icp),
        ("ForGeneralizedICP", reg.registration_generalized_icp),
        ("Symmetric", reg.registration_symmetric_icp),
    ):
        method = getattr(reg, f"TransformationEstimation{name}")()
        one, other = call(source, target, DISTANCE, criteria=rules), ours_after(device, pair, method, 2)
        np.testing.assert_array_equal(one.transformation, other.transformation)


# ------------------------------------------------------------------------------------------------ Open3D's tensor ones


@STEPS
@pytest.mark.parametrize("shape", [2.0, 1.0, 0.0, -2.0, -1e8])
def test_general_kernels_step_as_open3ds(device, pair, tensor, shape, steps, tolerances):
    import open3d as o3d

    theirs = o3d.t.pipelines.registration.TransformationEstimationPointToPlane(
        tensor_kernel("GeneralizedLoss", 0.02, shape)
    )
    ours = reg.TransformationEstimationPointToPlane(reg.GeneralizedLoss(0.02, shape))
    found, expected = ours_after(device, pair, ours, steps), tensor_after(tensor, theirs, steps)
    np.testing.assert_allclose(found.transformation, expected, rtol=0, atol=tolerances.icp_pose)


# ------------------------------------------------------------------------------------------------ ours alone


@pytest.mark.parametrize("loss", [reg.HuberLoss(0.02), reg.TukeyLoss(0.1), reg.GeneralizedLoss(0.02, -2)], ids=repr)
def test_point_to_point_kernels_hold_off_clutter(device, pair, angle_between, loss):
    """Open3D has no kernels there; with one the clutter counts less."""
    init = as_pose([0.002, 0.002, 0], [0.002, 0, 0.001]) @ pair.T
    plain, robust = (
        ours_after(device, pair, reg.TransformationEstimationPointToPoint(kernel=k), 20, init).transformation
        for k in (reg.L2Loss(), loss)
    )
    assert np.abs(plain - robust).max() > 1e-6
    assert angle_between(robust, pair.T) < 0.3


def test_point_to_point_weights_are_those_of_distances(device, pair, tolerances):
    """One weighted step against the closed form in float64."""
    loss = reg.CauchyLoss(0.03)
    found = ours_after(device, pair, reg.TransformationEstimationPointToPoint(kernel=loss), 1).transformation
    pairs = reg.evaluate_registration(pair.source, pair.target, DISTANCE).correspondence_set
    p, q = pair.source.points[pairs[:, 0]], pair.target.points[pairs[:, 1]]
    w = loss.weight(np.linalg.norm(p - q, axis=1))
    from pointloom.registration.rigid import fit_pose

    np.testing.assert_allclose(found, fit_pose(p, q, weights=w), rtol=0, atol=tolerances.icp_pose)


def test_voxels_stand_for_points(device, pair, angle_between):
    """Voxelised generalised ICP reaches what the plain form does to a fraction of the voxel."""
    method = reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1)
    found = ours_after(device, pair, method, 30)
    assert angle_between(found.transformation, pair.T) < 0.1
    assert np.abs(found.transformation[:3, 3] - pair.T[:3, 3]).max() < 2e-3
    rows, voxels = found.correspondence_set.T
    assert (np.diff(rows) > 0).all() and voxels.min() >= 0 and found.fitness == len(rows) / len(pair.source)


# ------------------------------------------------------------------------------------------------ what is refused


@pytest.mark.parametrize("share", [-0.1, 1.1, np.nan])
@pytest.mark.parametrize("name", ["ForColoredICP", "ForDopplerICP"])
def test_shares_lie_between_0_and_1(name, share):
    """Open3D takes its default without a word."""
    word = "lambda_geometric" if name == "ForColoredICP" else "lambda_doppler"
    with pytest.raises(ValueError, match=rf"^{word}: expected a share from 0 to 1"):
        getattr(reg, f"TransformationEstimation{name}")(**{word: share})


@pytest.mark.parametrize("value", [0, -1, np.nan, np.inf])
@pytest.mark.parametrize(
    ("name", "word"),
    [
        ("ForGeneralizedICP", "epsilon"),
        ("ForGeneralizedICP", "voxel_size"),
        ("ForDopplerICP", "period"),
        ("ForDopplerICP", "doppler_outlier_threshold"),
    ],
)
def test_lengths_and_times_are_positive(name, word, value):
    with pytest.raises(ValueError, match=rf"^{word}: expected a finite number > 0"):
        getattr(reg, f"TransformationEstimation{name}")(**{word: value})


def test_a_sensors_pose_is_rigid_and_iterations_are_counted():
    with pytest.raises(ValueError, match=r"^transform_vehicle_to_sensor: expected a rigid motion"):
        reg.TransformationEstimationForDopplerICP(transform_vehicle_to_sensor=2 * np.eye(4))
    with pytest.raises(ValueError, match=r"^outlier_rejection_min_iteration: expected a whole number >= 0"):
        reg.TransformationEstimationForDopplerICP(outlier_rejection_min_iteration=-1)


@pytest.mark.parametrize(
    ("name", "lacking", "message"),
    [
        ("PointToPlane", "target normals", "target: point-to-plane ICP needs normals, .* call .*estimate_normals()"),
        ("Symmetric", "source normals", "source: symmetric ICP needs normals, .* call .*estimate_normals()"),
        ("Symmetric", "target normals", "target: symmetric ICP needs normals, .* call .*estimate_normals()"),
        ("ForColoredICP", "source colors", "source: coloured ICP needs colours, .* assign cloud.colors"),
        ("ForColoredICP", "target colors", "target: coloured ICP needs colours, .* assign cloud.colors"),
        ("ForColoredICP", "target normals", "target: coloured ICP needs normals, .* call .*estimate_normals()"),
        (
            "ForDopplerICP",
            "source dopplers",
            "source: Doppler ICP needs radial speeds, .* assign cloud\\['dopplers'\\]",
        ),
        ("ForDopplerICP", "target normals", "target: Doppler ICP needs normals, .* call .*estimate_normals()"),
    ],
)
def test_whoever_lacks_something_is_told_what_to_call(pair, name, lacking, message):
    clouds = {}
    for role in ("source", "target"):
        cloud = getattr(pair, role)
        parts = {"normals": cloud.normals, "colors": cloud.colors, "dopplers": np.zeros(len(cloud), np.float32)}
        parts = {part: values for part, values in parts.items() if lacking != f"{role} {part}"}
        clouds[role] = loom.PointCloud(cloud.points, **parts)
    method = getattr(reg, f"TransformationEstimation{name}")()
    with pytest.raises(ValueError, match=rf"^{message}".replace("()", "\\(\\)")):
        reg.registration_icp(clouds["source"], clouds["target"], DISTANCE, None, method)
