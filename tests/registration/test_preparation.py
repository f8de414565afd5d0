"""What estimators need of a cloud: colour gradients, planes' covariances, radial speeds, and the errors without."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.algebra.transform import widen
from pointloom.kernels.icp.color_gradients import average_colors, estimate_color_gradients
from pointloom.kernels.icp.plane_covariances import plane_covariances, plane_covariances_from_normals, plane_information
from pointloom.kernels.lang import array, float32, float64, kernel, launch, tid, vec3
from pointloom.kernels.memory import empty, upload
from pointloom.kernels.search.point_tree import PointTree
from pointloom.registration.preparation import (
    colored_source,
    colored_target,
    doppler_measurements,
    generalized_covariances,
    require_colors,
    require_normals,
)


def gradients_of(points, normals, colors, radius, max_nn, device="cpu", tree=None):
    """Our intensities and gradients as NumPy."""
    arrays = [
        upload(np.asarray(values, np.float32).reshape(-1, 3), vec3, device) for values in (points, normals, colors)
    ]
    intensities, gradients = estimate_color_gradients(*arrays, radius, max_nn, tree)
    return intensities.numpy(), gradients.numpy()


def lists_within(points, radius, max_nn):
    """The hybrid search in float64: each point's nearest within the radius, itself among them."""
    sqdists, rows = cKDTree(points).query(points, min(max_nn, len(points)))
    sqdists, rows = sqdists.reshape(len(points), -1), rows.reshape(len(points), -1)
    return [near[reach < radius] for near, reach in zip(rows, sqdists, strict=True)]


def reference_gradients(points, normals, intensities, radius, max_nn):
    """The least squares of least norm in float64 over the neighbours, projected onto the tangent plane."""
    points, normals = np.asarray(points, np.float64), np.asarray(normals, np.float64)
    gradients = np.zeros((len(points), 3))
    for row, near in enumerate(lists_within(points, radius, max_nn)):
        if len(near) >= 4 and normals[row].any():
            n = normals[row] / np.linalg.norm(normals[row])
            ways = points[near] - points[row]
            ways = ways - np.outer(ways @ n, n)
            gradients[row] = np.linalg.lstsq(ways, intensities[near] - intensities[row], rcond=1e-3)[0]
    return gradients


def paint(points, scale=1.0):
    """Colours that vary along a surface."""
    x, y, _ = points.T / scale
    return np.column_stack([0.5 + 0.3 * np.sin(5 * x + c) * np.cos(4 * y) for c in range(3)])


def wavy(rng, count=1500):
    xy = rng.uniform(-1, 1, (count, 2))
    return np.column_stack([xy, 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1])]).astype(np.float32)


@pytest.fixture(scope="module")
def frames(data):
    """Two coloured RGB-D frames, thinned: points, normals and colours as float32."""
    clouds = []
    for name in ("frame_1.ply", "frame_2.ply"):
        cloud = loom.read_point_cloud(data / "reg-cilantro" / name).uniform_down_sample(23)
        good = np.isfinite(cloud.normals).all(axis=1) & np.isfinite(cloud.points).all(axis=1)
        clouds.append(cloud.select_by_mask(good))
    return [
        SimpleNamespace(cloud=c, points=c.points.astype(np.float32), normals=c.normals, colors=c.colors) for c in clouds
    ]


# ----------------------------------------------------------------------------------------------- colour gradients


@pytest.mark.parametrize("scene", ["fragment", "frame"])
def test_gradients_are_the_least_squares_of_the_neighbours(device, scene, frames, fragment, tolerances):
    if scene == "frame":
        points, normals, colors, radius = frames[0].points, frames[0].normals, frames[0].colors, 0.03
    else:
        part = np.s_[40000:44000]
        points, normals, colors = (
            a[part].astype(np.float32) for a in (fragment.points, fragment.normals, fragment.colors)
        )
        radius = 0.06
    intensities, found = gradients_of(points, normals, colors, radius, 30, device)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), radius, 30)
    error = np.abs(found - expected).max(axis=1) / np.maximum(
        np.abs(expected).max(axis=1), np.abs(expected).max() / 100
    )
    assert np.abs(expected).max() > 1
    assert (error < tolerances.gradient).mean() >= tolerances.gradient_share
    np.testing.assert_allclose(intensities, colors.mean(axis=1), atol=2e-7)
    flat = np.abs((found * normals).sum(axis=1)) <= 1e-6 * np.linalg.norm(found, axis=1) * np.linalg.norm(
        normals, axis=1
    )
    assert flat.all(), "a gradient lies in the plane"


def colored_step(source, target, gradients, pairs, lambda_geometric):
    """One step of coloured ICP from pairs [m, 2] in float64 (Open3D's rows, no kernel)."""
    p, q, n = (
        source.points[pairs[:, 0]].astype(float),
        target.points[pairs[:, 1]].astype(float),
        target.normals[pairs[:, 1]],
    )
    n, g, d = n.astype(float), gradients[pairs[:, 1]].astype(float), p - q
    change = source.colors.mean(axis=1)[pairs[:, 0]] - target.colors.mean(axis=1)[pairs[:, 1]]
    height = (d * n).sum(axis=1)
    r = np.concatenate([height, change - (g * (d - height[:, None] * n)).sum(axis=1)])
    h = (g * n).sum(axis=1)[:, None] * n - g
    J = np.vstack([np.hstack([np.cross(p, n), n]), np.hstack([np.cross(p, h), h])])
    w = np.repeat([lambda_geometric, 1 - lambda_geometric], len(p))
    x = np.linalg.solve((J * w[:, None]).T @ J, -(J * w[:, None]).T @ r)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_euler("xyz", x[:3]).as_matrix(), x[3:]
    return T


def open3d_step(to_open3d, source, target, distance, lambda_geometric, scale=1.0):
    """One step of Open3D's coloured ICP, and the pairs that it began with."""
    import open3d as o3d

    module = o3d.pipelines.registration
    clouds = [to_open3d(c.points.astype(float) * scale, c.normals, c.colors) for c in (source, target)]
    estimator = module.TransformationEstimationForColoredICP(lambda_geometric)
    step, start = (
        module.registration_colored_icp(
            *clouds, distance * scale, np.eye(4), estimator, module.ICPConvergenceCriteria(0.0, 0.0, count)
        )
        for count in (1, 0)
    )
    return step.transformation, np.asarray(start.correspondence_set)


@pytest.mark.parametrize("lambda_geometric", [0.968, 0.3])
def test_a_step_with_our_gradients_is_open3ds(device, lambda_geometric, frames, to_open3d, tolerances):
    """Two real frames, as far apart as their own sampling; Open3D makes its gradients itself."""
    source, target, distance = frames[1], frames[0], 0.02
    expected, pairs = open3d_step(to_open3d, source, target, distance, lambda_geometric)
    assert len(pairs) > 0.5 * len(source.points)
    _, gradients = gradients_of(target.points, target.normals, target.colors, 2 * distance, 30, device)
    found = colored_step(source, target, gradients, pairs, lambda_geometric)
    moved = np.abs(expected - np.eye(4)).max()
    assert moved > 1e-3
    np.testing.assert_allclose(found, expected, atol=tolerances.colored_step * moved)
    without = colored_step(source, target, gradients * 0.9, pairs, lambda_geometric)
    assert np.abs(without - expected).max() > 100 * tolerances.colored_step * moved, "the step depends on the gradients"


def test_gradients_do_not_depend_on_the_unit_of_length_as_open3ds_do(device, rng, to_open3d, tolerances):
    """Open3D's steps in metres and in centimetres disagree, as its neighbours are not projected onto the plane."""
    clouds, T = [], Rotation.from_rotvec([0.03, -0.02, 0.06])
    for moved in (True, False):
        points = wavy(rng, 800)
        normals = loom.PointCloud(points).estimate_normals(max_nn=12).normals
        place = T.apply(points).astype(np.float32) if moved else points
        clouds.append(SimpleNamespace(points=place, normals=normals, colors=paint(points)))
    source, target = clouds
    ours = [
        gradients_of(target.points * np.float32(unit), target.normals, target.colors, 0.3 * unit, 30, device)[1] * unit
        for unit in (1.0, 128.0)
    ]
    np.testing.assert_allclose(ours[0], ours[1], atol=1e-6 * np.abs(ours[0]).max())
    steps = [open3d_step(to_open3d, source, target, 0.15, 0.0, unit)[0][:3, :3] for unit in (1.0, 128.0)]
    pairs = open3d_step(to_open3d, source, target, 0.15, 0.0)[1]
    assert np.abs(steps[0] - steps[1]).max() > 1e-3
    found = colored_step(source, target, ours[1], pairs, 0.0)[:3, :3]
    np.testing.assert_allclose(found, steps[0], atol=1e-5)


def test_the_gradient_of_a_linear_colour_is_exact(device, rng):
    """On a plane anywhere in space, whatever the neighbours, and with normals of any length."""
    R = Rotation.from_rotvec([0.4, -1.1, 0.3]).as_matrix()
    plane = np.column_stack([rng.uniform(-1, 1, (600, 2)), np.zeros(600)])
    true = R @ [0.3, -0.2, 0.0]
    points = (plane @ R.T + [3.0, -2.0, 1.0]).astype(np.float32)
    colors = np.repeat((0.5 + plane @ [0.3, -0.2, 0.0])[:, None], 3, axis=1)
    normals = np.outer(rng.uniform(0.1, 9.0, 600), R[:, 2]) * rng.choice([-1, 1], 600)[:, None]
    _, found = gradients_of(points, normals, colors, 0.5, 30, device)
    np.testing.assert_allclose(found, np.tile(true, (600, 1)), atol=2e-5)


@pytest.mark.parametrize("direction", [(1, 0, 0), (0, 0, 1), (1, 2, 3)], ids=str)
def test_neighbours_on_a_line_tell_the_gradient_along_it_alone(device, direction):
    """Least norm; a solution by elimination would be noise of any size across the line."""
    d = np.array(direction) / np.linalg.norm(direction)
    normal = np.cross(d, [0.3, 0.5, -0.8])
    t = np.linspace(-1, 1, 41)
    colors = np.repeat((0.5 + 0.25 * t)[:, None], 3, axis=1)
    _, found = gradients_of(np.outer(t, d), np.tile(normal, (41, 1)), colors, 0.3, 10, device)
    np.testing.assert_allclose(found, np.tile(0.25 * d, (41, 1)), atol=1e-5)


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4])
def test_fewer_than_four_points_have_no_gradient(device, count):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.0]])[:count]
    colors = np.array([[0.1], [0.2], [0.4], [0.5]])[:count].repeat(3, axis=1)
    intensities, found = gradients_of(points, np.tile([0, 0, 1.0], (count, 1)), colors, 10.0, 30, device)
    assert found.shape == (count, 3) and intensities.shape == (count,)
    np.testing.assert_allclose(found, np.tile([0.1, 0.3, 0] if count == 4 else [0, 0, 0], (count, 1)), atol=1e-7)


def test_points_without_neighbours_or_extent_have_no_gradient(device, rng):
    colors = rng.random((50, 3))
    up = np.tile([0, 0, 1.0], (50, 1))
    assert not gradients_of(np.full((50, 3), 0.3), up, colors, 1.0, 30, device)[1].any(), "all at one place"
    assert not gradients_of(np.outer(np.arange(50), [0, 0, 1]), up, colors, 10.0, 30, device)[1].any(), (
        "along the normal"
    )
    assert not gradients_of(rng.random((50, 3)), up, colors, 1e-6, 30, device)[1].any(), "nobody near"
    assert not gradients_of(rng.random((50, 3)), up * 0, colors, 1.0, 30, device)[1].any(), "zero normals"


def test_what_is_not_finite_counts_for_nobody(device, rng):
    points, normals = wavy(rng, 900), np.tile([0, 0, 1.0], (900, 1))
    colors, bad = paint(points), rng.permutation(900)[:90]
    spoiled, dark = points.copy(), colors.copy()
    spoiled[bad[:30]], spoiled[bad[30:40]], dark[bad[40:]] = np.nan, [np.inf, 0, 0], np.nan
    intensities, found = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    good = np.setdiff1d(np.arange(900), bad)
    _, expected = gradients_of(points[good], normals[good], colors[good], 0.3, 900, device)
    np.testing.assert_allclose(found[good], expected, atol=1e-6)
    assert not found[bad].any() and np.isnan(intensities[bad[40:]]).all()
    normals[good[:7]] = [np.nan, 0, 1]
    _, lopsided = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    assert not lopsided[good[:7]].any()
    np.testing.assert_array_equal(lopsided[good[7:]], found[good[7:]], "a neighbour's normal has no say")


lattice = st.lists(st.tuples(*[st.integers(-2, 2)] * 3, st.integers(0, 9)), min_size=1, max_size=40)


@settings(max_examples=40, deadline=None)
@given(rows=lattice, radius=st.sampled_from([0.9, 1.2, 2.1, 50.0]), normal=st.sampled_from([(0, 0, 1), (1, 2, -1)]))
def test_gradients_of_lattices_are_the_least_squares(rows, radius, normal):
    """Duplicates, lines and planes; no distance equals the radius and no count cuts a tie."""
    table = np.array(rows, np.float64)
    points, colors = table[:, :3], table[:, 3:].repeat(3, axis=1) / 9
    normals = np.tile(np.array(normal, float), (len(points), 1))
    intensities, found = gradients_of(points, normals, colors, radius, 64)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), radius, 64)
    np.testing.assert_allclose(found, expected, atol=1e-5)


def test_a_tree_that_is_there_is_used(device, rng):
    points, normals = wavy(rng, 300), np.tile([0, 0, 1.0], (300, 1))
    own = PointTree(upload(points, vec3, device))
    with_tree = gradients_of(points, normals, paint(points), 0.2, 30, device, own)[1]
    np.testing.assert_array_equal(with_tree, gradients_of(points, normals, paint(points), 0.2, 30, device)[1])


def test_two_runs_give_the_same_bits(device, frames):
    frame = frames[0]
    runs = [gradients_of(frame.points, frame.normals, frame.colors, 0.04, 30, device)[1] for _ in range(2)]
    np.testing.assert_array_equal(*(run.view(np.int32) for run in runs))


# ----------------------------------------------------------------------------------------------- planes' covariances


def covariances_from(normals, epsilon, device="cpu"):
    found = plane_covariances_from_normals(upload(np.asarray(normals, np.float32), vec3, device), epsilon)
    return found.numpy().reshape(-1, 3, 3)


@pytest.mark.parametrize("epsilon", [1e-3, 1e-6, 1.0, 0.5])
def test_covariances_from_normals_are_flat_along_them(device, epsilon, rng, tolerances):
    """Also for normals near -x, where Open3D takes those of x; and for normals of any length."""
    normals = rng.normal(size=(500, 3)) * 3
    normals[:50] = [-5, 0, 0] + rng.normal(size=(50, 3)) * 0.3
    normals[0], normals[1] = [-1, 0, 0], [1, 0, 0]
    normals = normals.astype(np.float32)
    units = normals.astype(float) / np.linalg.norm(normals.astype(float), axis=1, keepdims=True)
    expected = np.eye(3) + (epsilon - 1) * units[:, :, None] * units[:, None, :]
    found = covariances_from(normals, epsilon, device)
    np.testing.assert_allclose(found, expected, atol=tolerances.float32_relative)
    for row in range(0, 500, 20):  # the paper's form: a rotation from the first axis to the normal
        R = Rotation.align_vectors(units[row : row + 1], [[1.0, 0, 0]])[0].as_matrix()
        np.testing.assert_allclose(R @ np.diag([epsilon, 1, 1]) @ R.T, expected[row], atol=1e-7)


def test_open3d_gives_normals_near_minus_x_another_plane(device, rng, to_open3d, tolerances):
    """A plane has no side, yet flipped normals change Open3D's step; ours are the same bits."""
    import open3d as o3d

    module = o3d.pipelines.registration
    n = np.array([0.995, 0.0998, 0.0])
    points = np.column_stack([0.1 * rng.random(400), rng.uniform(-1, 1, (400, 2))])
    normals = np.tile(n / np.linalg.norm(n), (400, 1)) + rng.normal(size=(400, 3)) * 0.02
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    np.testing.assert_array_equal(covariances_from(normals, 1e-3, device), covariances_from(-normals, 1e-3, device))
    steps = []
    for side in (1.0, -1.0):
        clouds = [to_open3d(points + shift, side * normals) for shift in ([0.01, 0.02, -0.01], [0, 0, 0])]
        steps.append(
            module.registration_generalized_icp(
                *clouds, 0.1, np.eye(4), criteria=module.ICPConvergenceCriteria(0.0, 0.0, 1)
            ).transformation
        )
    assert np.abs(steps[0] - steps[1]).max() > 1e-4


def test_unknown_planes_are_round(device):
    found = covariances_from([[0, 0, 0], [np.nan, 0, 1], [0, np.inf, 0], [0, 0, 1e-30]], 0.1, device)
    np.testing.assert_array_equal(found[0], np.eye(3))
    assert np.isnan(found[1:3]).all()
    np.testing.assert_allclose(found[3], np.diag([1, 1, 0.1]), atol=1e-7)
    assert covariances_from(np.empty((0, 3)), 0.1, device).shape == (0, 3, 3)


@pytest.mark.parametrize("scene", ["lidar", "fragment"])
def test_covariances_of_twenty_neighbours_are_small_gicps(device, scene, lidar, fragment, tolerances):
    gicp = pytest.importorskip("small_gicp")
    points = (lidar[:, :3] if scene == "lidar" else fragment.points[::20]).astype(np.float32)
    theirs = gicp.PointCloud(points.astype(np.float64))
    gicp.estimate_covariances(theirs)
    expected = np.array([theirs.cov(row)[:3, :3] for row in range(len(points))])
    found = plane_covariances(upload(points, vec3, device)).numpy().reshape(-1, 3, 3)
    clear = np.abs(found - expected).max(axis=(1, 2)) < tolerances.plane_covariance
    assert clear.mean() > tolerances.normal_share
    np.testing.assert_allclose(np.linalg.eigvalsh(found), np.tile([1e-3, 1, 1], (len(points), 1)), atol=1e-6)


@pytest.mark.parametrize("count", [0, 1, 3, 4, 5])
def test_fewer_than_five_points_have_round_covariances(device, count):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0.0]])[:count]
    with_nan = np.vstack([points, [[np.nan, 0, 0]]])
    found = plane_covariances(upload(with_nan, vec3, device)).numpy().reshape(-1, 3, 3)
    np.testing.assert_allclose(
        found[:-1], np.tile(np.diag([1, 1, 1e-3 if count == 5 else 1]), (count, 1, 1)), atol=1e-7
    )
    assert np.isnan(found[-1]).all()


@kernel
def invert_planes_kernel(
    a: array(dtype=vec3), b: array(dtype=vec3), epsilon: float64, out: array(dtype=float64, ndim=2)
):
    i = tid()
    C = plane_information(widen(a[i]), widen(b[i]), epsilon)
    for row in range(3):
        for column in range(3):
            out[i, 3 * row + column] = C[row, column]


@pytest.mark.parametrize("epsilon", [1e-3, 1e-6, 0.9])
def test_the_information_of_two_planes_is_the_inverse_of_their_sum(device, epsilon, rng):
    a = rng.normal(size=(200, 3))
    b = np.where(rng.random((200, 1)) < 0.5, rng.normal(size=(200, 3)), a + rng.normal(size=(200, 3)) * 0.01)
    b[0], b[1] = a[0], -a[1]
    a, b = ((v / np.linalg.norm(v, axis=1, keepdims=True)).astype(np.float32) for v in (a, b))
    a[2], b[2], b[3] = [1, 0, 0], [-1, 0, 0], 0
    out = empty((200, 9), float64, device)
    launch(invert_planes_kernel, 200, [upload(a, vec3, device), upload(b * 4, vec3, device), epsilon, out])
    units = [v / np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-9) for v in (a.astype(float), b.astype(float))]
    expected = np.linalg.inv(sum(np.eye(3) + (epsilon - 1) * v[:, :, None] * v[:, None, :] for v in units))
    scale = np.abs(expected).max(axis=(1, 2), keepdims=True)
    np.testing.assert_allclose(out.numpy().reshape(-1, 3, 3) / scale, expected / scale, atol=1e-9)


# ----------------------------------------------------------------------------------------------- what a cloud has


def test_who_lacks_normals_or_colours_is_told_what_to_call(device):
    cloud = loom.PointCloud(np.zeros((4, 3)), device=device)
    with pytest.raises(ValueError, match=r"source: point-to-plane ICP needs normals, and it has none; call estimate_n"):
        require_normals(cloud, "source", "point-to-plane ICP")
    with pytest.raises(ValueError, match=r"target: coloured ICP needs colours, and it has none; assign cloud.colors"):
        require_colors(cloud, "target", "coloured ICP")
    with pytest.raises(ValueError, match="source: coloured ICP needs colours"):
        colored_source(cloud)
    with pytest.raises(ValueError, match="target: coloured ICP needs normals"):
        colored_target(cloud, 0.1)
    with pytest.raises(ValueError, match="target: coloured ICP needs colours"):
        colored_target(cloud.estimate_normals(), 0.1)
    with pytest.raises(
        ValueError, match=r"source: Doppler ICP needs radial speeds, and it has none; assign cloud\['dop"
    ):
        doppler_measurements(cloud)


def test_a_coloured_target_has_gradients_of_twice_the_distance(device, rng):
    points = wavy(rng, 500)
    cloud = loom.PointCloud(points, colors=paint(points), device=device).estimate_normals(max_nn=12)
    surface = colored_target(cloud, 0.1)
    intensities, gradients = gradients_of(points, cloud.normals, cloud.colors, 0.2, 30, device)
    np.testing.assert_array_equal(surface.gradients.numpy(), gradients)
    np.testing.assert_array_equal(surface.intensities.numpy(), intensities)
    np.testing.assert_array_equal(colored_source(cloud).numpy(), average_colors(cloud.array("colors")).numpy())
    assert surface.normals is cloud.array("normals")


def test_covariances_are_the_clouds_own_then_its_normals_then_its_neighbours(device, rng, tolerances):
    cloud = loom.PointCloud(wavy(rng, 400), device=device)
    near = generalized_covariances(cloud, 1e-3).numpy()
    np.testing.assert_array_equal(near, plane_covariances(cloud.array("points"), 20, 1e-3).numpy())
    tilted = cloud.estimate_normals(max_nn=5)
    by_normals = generalized_covariances(tilted, 0.01).numpy()
    np.testing.assert_array_equal(by_normals, plane_covariances_from_normals(tilted.array("normals"), 0.01).numpy())
    measured = tilted.estimate_covariances(max_nn=9)
    assert generalized_covariances(measured, 0.5) is measured.array("covariances")
    wide = cloud.copy()
    wide["covariances"] = measured["covariances"].astype(np.float64)
    found = generalized_covariances(wide, 0.5)
    assert found.dtype == float32
    np.testing.assert_array_equal(found.numpy(), measured["covariances"])
    wide["covariances"] = np.zeros((400, 6))
    with pytest.raises(ValueError, match=r"target: expected covariances of shape \[400, 9\], got \[400, 6\]"):
        generalized_covariances(wide, 0.5, "target")


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("shape", [(300,), (300, 1)], ids=str)
def test_directions_point_from_the_sensor_to_the_points(device, shape, dtype, rng):
    points, speeds = rng.normal(size=(300, 3)) * 30, rng.normal(size=300)
    points[7] = 0
    cloud = loom.PointCloud(
        points, dopplers=speeds.reshape(shape).astype(dtype), device=device, origin=[5.0, -9.0, 1.0]
    )
    found = doppler_measurements(cloud)
    expected = points / np.maximum(np.linalg.norm(points, axis=1, keepdims=True), 1e-9)
    np.testing.assert_allclose(np.delete(found.directions.numpy(), 7, 0), np.delete(expected, 7, 0), atol=1e-5)
    np.testing.assert_array_equal(found.dopplers.numpy(), speeds.astype(np.float32))
    assert found.dopplers.dtype == float32 and found.dopplers.shape == (300,)


def test_directions_that_a_cloud_brings_are_taken(device, rng):
    cloud = loom.PointCloud(rng.normal(size=(40, 3)), dopplers=np.zeros(40), device=device)
    for dtype in (np.float32, np.float64):
        cloud["directions"] = np.tile([0, 3, 4.0], (40, 1)).astype(dtype)
        found = doppler_measurements(cloud).directions.numpy()
        np.testing.assert_allclose(found, np.tile([0, 0.6, 0.8], (40, 1)), atol=1e-7)
    cloud["directions"] = np.zeros((40, 2))
    with pytest.raises(ValueError, match=r"source: expected directions of shape \[40, 3\], got \[40, 2\]"):
        doppler_measurements(cloud)
    cloud["dopplers"] = np.zeros((40, 2))
    with pytest.raises(ValueError, match=r"frame: expected dopplers of shape \[40\], got \[40, 2\]"):
        doppler_measurements(cloud, "frame")
