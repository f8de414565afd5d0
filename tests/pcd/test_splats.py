"""Gaussian splats: transformation of centers, axes and colors, selection, gradients, and rendered images."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.algebra.exponential import exp_in_float
from pointloom.kernels.lang import array, float32, kernel, launch, tid
from pointloom.kernels.memory import download, empty, upload
from pointloom.pcd.harmonics import degree_of, harmonics_at, rotation_of_harmonics, signs_of_flip

from ..programs import BENCHMARKS, benchmarks_on_path, load_program

UTM = np.array([500_000.0, 4_000_000.0, 100.0])


def made(count=200, degree=3, *, at=(0, 0, 0), device="cpu", seed=0) -> loom.GaussianSplats:
    rng = np.random.default_rng(seed)
    centers, scales = rng.normal(size=(count, 3)) + at, np.exp(rng.normal(-2, 1, (count, 3)))
    rotations, opacities = rng.normal(size=(count, 4)), rng.uniform(0.01, 0.99, count)
    harmonics = rng.normal(0, 0.3, (count, (degree + 1) ** 2, 3))
    return loom.GaussianSplats(centers, scales, rotations, opacities, harmonics, device=device)


def colors_from(splats: loom.GaussianSplats, directions) -> np.ndarray:
    return np.einsum("mk,nkc->nmc", harmonics_at(directions, splats.degree), splats.harmonics.astype(np.float64))


@pytest.fixture(scope="module")
def directions():
    rng = np.random.default_rng(1)
    vectors = rng.normal(size=(12, 3))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


@pytest.mark.parametrize("at", [np.zeros(3), UTM], ids=["near", "utm"])
def test_a_similarity_moves_centers_axes_and_colors(at, directions, device):
    splats = made(at=at, device=device)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = 2.5 * Rotation.from_rotvec([0.4, -1.1, 2.0]).as_matrix(), [1, 2, 3]
    moved = splats.transform(T)
    R = T[:3, :3] / 2.5
    np.testing.assert_allclose(moved.centers, splats.centers @ T[:3, :3].T + T[:3, 3], atol=2e-6)
    expected = 2.5**2 * R @ splats.covariances() @ R.T
    np.testing.assert_allclose(moved.covariances(), expected, atol=2e-6 * np.abs(expected).max())
    np.testing.assert_allclose(colors_from(moved, directions), colors_from(splats, directions @ R), atol=1e-6)
    np.testing.assert_array_equal(moved.opacities, splats.opacities)


def test_a_translation_leaves_every_bit_of_the_rest():
    splats = made()
    moved = splats.translate([1, 2, 3])
    for name in ("f_dc", "f_rest", "opacity", "scale", "rot"):
        np.testing.assert_array_equal(moved.cloud[name], splats.cloud[name])


@pytest.mark.parametrize("degree", range(5))
def test_harmonics_rotate_exactly(degree, directions):
    R = Rotation.from_rotvec([1.0, 0.3, -0.7]).as_matrix()
    rotation = rotation_of_harmonics(R, degree)
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(len(rotation)), atol=1e-13)
    before, after = harmonics_at(directions @ R, degree)[:, 1:], harmonics_at(directions, degree)[:, 1:]
    np.testing.assert_allclose(after @ rotation, before, atol=1e-13)


def test_harmonics_basis_follows_the_paper(directions):
    x, y, z = directions.T
    one = np.sqrt(3 / (4 * np.pi))
    two = np.sqrt(15 / (4 * np.pi))
    by_hand = [-one * y, one * z, -one * x, two * x * y, -two * y * z]
    np.testing.assert_allclose(harmonics_at(directions, 2)[:, 1:6].T, by_hand, atol=1e-14)
    np.testing.assert_array_equal(signs_of_flip((1, -1, -1), 1), [-1, -1, 1])
    assert [degree_of(count) for count in (1, 4, 9, 16, 25, 5, 36, 0)] == [0, 1, 2, 3, 4, None, None, None]


def test_cleaning_keeps_visible_splats_within_size_limits(device):
    splats = made(2000, 0, device=device)
    cleaned = splats.clean(min_opacity=0.3, min_scale=0.1, max_scale=0.5)
    largest = splats.scales.max(axis=1)
    expected = (splats.opacities >= 0.3) & (largest >= 0.1) & (largest <= 0.5)
    assert 0 < expected.sum() < 2000
    np.testing.assert_array_equal(cleaned.centers, splats.centers[expected])
    assert len(splats.clean()) == 2000


def test_cleaning_removes_invalid_splats(device):
    cloud = made(6, 0, device=device).cloud.copy()
    scale, rot, opacity = (cloud[name].copy() for name in ("scale", "rot", "opacity"))
    scale[0, 1], scale[1, 0], rot[2], opacity[3] = np.nan, np.inf, 0, np.nan
    opacity[4], scale[4, 2] = np.inf, -np.inf  # fully opaque and flat: valid
    cloud["scale"], cloud["rot"], cloud["opacity"] = scale, rot, opacity
    splats = loom.GaussianSplats.from_cloud(cloud)
    np.testing.assert_array_equal(splats.clean().centers, cloud.points[4:])


def test_choosing_and_joining_keep_all_columns():
    splats, others = made(50, 3), made(30, 1, seed=2)
    box = loom.AxisAlignedBoundingBox([-1, -1, -1], [0.5, 1, 1])
    inside = (np.abs(splats.centers) <= 1).all(axis=1) & (splats.centers[:, 0] <= 0.5)
    np.testing.assert_array_equal(splats.crop(box).harmonics, splats.harmonics[inside])
    np.testing.assert_array_equal(splats.select_by_mask(inside).rotations, splats.rotations[inside])
    joined = loom.GaussianSplats.concatenate([splats, others])
    assert (len(joined), joined.degree) == (80, 3)
    np.testing.assert_array_equal(joined.harmonics[50:, :4], others.harmonics)
    assert not joined.harmonics[50:, 4:].any()


def test_a_cloud_of_the_centers_has_colors_and_shortest_axes():
    flat = loom.GaussianSplats([[1, 2, 3]], [[1, 1, 0.1]], [[np.sqrt(0.5), np.sqrt(0.5), 0, 0]], [0.25], [[1.0, 0, -9]])
    cloud = flat.to_point_cloud()
    np.testing.assert_allclose(np.abs(cloud.normals), [[0, 1, 0]], atol=1e-6)  # z rotated by 90 degrees about x
    np.testing.assert_allclose(cloud.colors, [[0.5 + 0.28209479, 0.5, 0]], atol=1e-6)
    np.testing.assert_allclose(cloud["opacity"], [0.25], atol=1e-6)


@pytest.fixture(scope="module")
def training():
    """The module, which imports its neighbor by name."""
    with benchmarks_on_path():
        yield load_program(BENCHMARKS / "splat_training.py")


@pytest.mark.slow
def test_gradients_are_differences_of_a_float64_image(training, device):
    assert training.largest_differences(device).max() < 1e-5


CAMERA = loom.PinholeCameraIntrinsic(70, 50, 60.0, 55.0, 33.0, 26.0)


@kernel
def exp_kernel(x: array(dtype=float32), out: array(dtype=float32)):
    i = tid()
    out[i] = exp_in_float(x[i])


def made_splats(count=60, degree=2, seed=0, device="cpu", at=(0, 0, 0)):
    """Splats of all sizes in front of and behind the camera at `at`, which looks along z."""
    rng = np.random.default_rng(seed)
    centers = np.stack([rng.normal(0, 1, count), rng.normal(0, 1, count), rng.uniform(-1, 5, count)], axis=1)
    scales = np.exp(rng.normal(-2, 1, (count, 3)))
    harmonics = rng.normal(0, 0.4, (count, (degree + 1) ** 2, 3))
    opacities = rng.uniform(0.002, 1.0, count)
    return loom.GaussianSplats(centers + at, scales, rng.normal(size=(count, 4)), opacities, harmonics, device=device)


def pose_at(position, rotation=(0.05, -0.1, 0.02)):
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec(rotation).as_matrix()
    T[:3, 3] = -T[:3, :3] @ np.asarray(position, float)
    return T


def rays_of(camera):
    columns, rows = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    return np.stack([(columns - camera.cx) / camera.fx, (rows - camera.cy) / camera.fy, np.ones(rows.shape)], axis=-1)


def reference(splats, camera, T, near=0.01):
    """The image from every splat in every pixel, in float64: color, transmittance, depth, median, normals."""
    q = splats.centers @ T[:3, :3].T + T[:3, 3]
    covariances = T[:3, :3] @ splats.covariances() @ T[:3, :3].T
    eye = np.linalg.inv(T)[:3, 3]
    toward = splats.centers - eye
    toward /= np.linalg.norm(toward, axis=1, keepdims=True)
    basis = harmonics_at(toward, splats.degree)
    colors = np.maximum(np.einsum("nk,nkc->nc", basis, splats.harmonics.astype(float)) + 0.5, 0)
    sizes = splats.scales.astype(float)
    axes = T[:3, :3] @ splats._axes()
    columns, rows = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    rays = rays_of(camera)
    left = np.ones(columns.shape)
    color, depth, median, normals = (np.zeros((*columns.shape, k)).squeeze() for k in (3, 1, 1, 3))
    for i in np.argsort(q[:, 2], kind="stable"):
        x, y, z = q[i]
        if z <= near:
            continue
        margin, high = 0.15 * camera.width, 0.15 * camera.height
        tx = np.clip(x / z, (-margin - camera.cx) / camera.fx, (camera.width + margin - camera.cx) / camera.fx)
        ty = np.clip(y / z, (-high - camera.cy) / camera.fy, (camera.height + high - camera.cy) / camera.fy)
        J = np.array([[camera.fx / z, 0, -camera.fx * tx / z], [0, camera.fy / z, -camera.fy * ty / z]])
        conic = np.linalg.inv(J @ covariances[i] @ J.T + 0.3 * np.eye(2))
        off = np.stack([columns - (camera.fx * x / z + camera.cx), rows - (camera.fy * y / z + camera.cy)], axis=-1)
        power = -0.5 * np.einsum("hwi,ij,hwj->hw", off, conic, off)
        alpha = np.minimum(splats.opacities[i].astype(float) * np.exp(power), 0.99)
        alpha[(alpha < 1 / 255) | (left <= 1e-4)] = 0
        A = np.linalg.inv(covariances[i])
        ray_depth = (rays @ A @ q[i]) / np.einsum("hwi,ij,hwj->hw", rays, A, rays)
        extent = 3 * np.sqrt(covariances[i][2, 2])
        ray_depth = np.clip(ray_depth, z - extent, z + extent)
        normal = axes[i][:, sizes[i].argmin()]
        normal = -normal if normal @ q[i] > 0 else normal
        weight = left * alpha
        color += weight[..., None] * colors[i]
        normals += weight[..., None] * normal
        depth += weight * ray_depth
        median = np.where((left > 0.5) & (left - weight <= 0.5), ray_depth, median)
        left = left - weight
    lengths = np.linalg.norm(normals, axis=-1, keepdims=True)
    hit = left < 1
    depth = np.where(hit, depth / np.where(hit, 1 - left, 1), 0)
    return color, left, depth, median, normals / np.maximum(lengths, 1e-9)


@pytest.mark.parametrize("degree", [0, 2, 4])
def test_image_follows_the_equations(degree, device):
    splats = made_splats(degree=degree, seed=degree, device=device)
    T = pose_at([0.1, 0.2, -1.5])
    image = splats.rasterize(CAMERA, T)
    color, left, depth, median, normals = reference(splats, CAMERA, T)
    assert (left < 0.5).mean() > 0.2
    firm = left < 0.9
    pairs = [(image.opacity, 1 - left), (image.color, color), (image.depth[firm], depth[firm])]
    pairs += [(image.median_depth[firm], median[firm]), (image.normals[firm], normals[firm])]
    for actual, expected in pairs:
        # splats below 1/255 of opacity are skipped: rounding affects single pixels
        assert (np.abs(actual - expected) > 3e-5).mean() < 1e-3


def test_solid_surface_hides_the_splats_behind_it(device):
    """A mesh over the left half of the image, 2 m away."""
    splats, T = made_splats(device=device), np.eye(4)
    corners = [[-9, -9, 2], [0, -9, 2], [0, 9, 2], [-9, 9, 2]]
    wall = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]], vertex_colors=np.full((4, 3), 0.2), device=device)
    view, background = loom.View(CAMERA, T), (0.6, 0.8, 1.0)
    image = np.asarray(loom.render([splats, wall], view, shading="none", background=background)) / 255
    for columns, chosen, solid in (
        (slice(0, 32), splats.centers[:, 2] < 2, (0.2, 0.2, 0.2)),
        (slice(35, 70), splats.centers[:, 2] < 9, background),
    ):
        color, left, *_ = reference(splats.select_by_index(np.flatnonzero(chosen)), CAMERA, T)
        expected = np.clip(color + left[..., None] * solid, 0, 1)[:, columns]
        assert np.quantile(np.abs(image[:, columns] - expected), 0.99) < 3 / 255


def test_an_image_at_utm_coordinates_is_the_same(device):
    near, far = made_splats(device=device), made_splats(device=device, at=UTM)
    one, other = near.rasterize(CAMERA, pose_at([0, 0, -1.5])), far.rasterize(CAMERA, pose_at(UTM - [0, 0, 1.5]))
    assert np.abs(one.color - other.color).mean() < 1e-5
    assert np.abs(one.depth - other.depth).mean() < 1e-4


def test_a_flat_splat_gives_the_depth_of_its_plane(device):
    tilt = Rotation.from_rotvec([0.6, 0.3, 0])
    rotation = np.roll(tilt.as_quat(), 1)
    splats = loom.GaussianSplats([[0, 0, 3]], [[0.8, 0.8, 1e-6]], [rotation], [0.95], [[0, 0, 0]], device=device)
    image = splats.rasterize(CAMERA, np.eye(4))
    rays = rays_of(CAMERA)
    normal = tilt.as_matrix()[:, 2]
    plane = 3 * normal[2] / (rays @ normal)
    visible = image.opacity > 0.3
    assert visible.sum() > 300
    np.testing.assert_allclose(image.depth[visible], plane[visible], rtol=2e-5)
    np.testing.assert_allclose(image.normals[visible], np.broadcast_to(-normal, (visible.sum(), 3)), atol=1e-6)


def test_the_nearer_of_two_hides_the_other_and_the_background_shows_beside(device):
    centers, harmonics, unturned = [[0, 0, 2], [0, 0, 1]], [[-2, -2, 2], [2, -2, -2]], [[1, 0, 0, 0]] * 2
    two = loom.GaussianSplats(centers, np.full((2, 3), 0.1), unturned, [1, 1], harmonics, device=device)
    image = two.rasterize(CAMERA, np.eye(4), background=(0, 1, 0))
    red, green, blue = image.color[26, 33]
    assert red > 0.9 and green < 0.01 and 0 < blue < 0.02
    np.testing.assert_allclose(image.color[0, 0], [0, 1, 0], atol=1e-6)
    assert image.median_depth[26, 33] == pytest.approx(1, abs=1e-6) and image.depth[0, 0] == 0


def test_splats_that_are_not_finite_are_not_drawn(device):
    splats = made_splats(count=30, device=device).translate([0, 0, 3])
    cloud = splats.cloud.copy()
    scale, opacity = (cloud[name].copy() for name in ("scale", "opacity"))
    scale[0, 1], scale[1, 0], opacity[2], opacity[3] = np.nan, np.inf, np.nan, -np.inf
    opacity[4], scale[4, 2], scale[5] = np.inf, -np.inf, 80.0  # opaque and flat: drawn; overflowing size: skipped
    cloud["scale"], cloud["opacity"] = scale, opacity
    hostile = loom.GaussianSplats.from_cloud(cloud)
    result = hostile.rasterize(CAMERA, np.eye(4))
    valid = hostile.select_by_index([4, *range(6, 30)]).rasterize(CAMERA, np.eye(4))
    assert valid.opacity.max() > 0.5 and np.isfinite(result.color).all()
    for name in ("color", "opacity", "depth", "median_depth"):
        np.testing.assert_array_equal(getattr(result, name), getattr(valid, name))


def test_splats_behind_or_beside_the_camera_are_invisible(device):
    splats = made_splats(device=device)
    for chosen in (splats.select_by_index([]), splats.translate([0, 0, -50]), splats.translate([1000, 0, 0])):
        image = chosen.rasterize(CAMERA, pose_at([0, 0, -1]))
        assert not image.opacity.any() and not image.depth.any() and not image.normals.any()


@pytest.mark.slow
def test_exponential_is_accurate_to_two_ulps(device):
    x = np.concatenate([np.linspace(-87, 88, 20_001), [0, -np.inf, np.inf, -200, 1e-7]]).astype(np.float32)
    target_device = resolve_device(device)
    out = empty(len(x), float32, target_device)
    launch(exp_kernel, len(x), [upload(x, float32, target_device), out])
    expected = np.exp(np.clip(x.astype(np.float64), -87, 88))
    assert np.abs(download(out) / expected - 1).max() < 2 * np.finfo(np.float32).eps
