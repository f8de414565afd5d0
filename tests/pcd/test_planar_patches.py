"""Planar patches: Open3D's on a real scan, the faces of rooms, and none on curved surfaces."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

TUTORIAL = {"normal_variance_threshold_deg": 60, "coplanarity_deg": 75, "outlier_ratio": 0.75}
ROOM = np.array([6.0, 4.0, 2.7])  # [m]


def room(rng, count, noise, size=ROOM):
    """Points of the six faces of a box, equally many per face, and the face of each: axis, or axis + 3."""
    face = np.arange(count) % 6
    points = rng.random((count, 3)) * size
    points[np.arange(count), face % 3] = np.where(face < 3, 0, size[face % 3])
    return points + noise * rng.normal(size=points.shape), face


def covered(box, other, slack):
    """Fraction of a box's face inside another box that is enlarged by a slack [m]."""
    u, v = np.meshgrid(np.linspace(-0.45, 0.45, 20), np.linspace(-0.45, 0.45, 20))
    face = np.stack([u, v, 0 * u], axis=-1).reshape(-1, 3) * np.asarray(box.extent)
    local = (face @ np.asarray(box.R).T + np.asarray(box.center) - np.asarray(other.center)) @ np.asarray(other.R)
    return (np.abs(local) <= np.asarray(other.extent) / 2 + slack).all(axis=1).mean()


def matches(box, others, tolerances):
    for other in others:
        cosine = abs(np.asarray(box.R)[:, 2] @ np.asarray(other.R)[:, 2])
        if cosine > np.cos(np.radians(tolerances.patch_degrees)):
            shared = max(covered(box, other, tolerances.patch_slack), covered(other, box, tolerances.patch_slack))
            if shared > tolerances.patch_overlap:
                return True
    return False


@pytest.fixture(scope="module", params=["stored", "fitted"])
def scan(request, fragment, o3d, to_open3d):
    """Half of the fragment with normals, and Open3D's patches of it."""
    cloud = loom.PointCloud(fragment.points[::2], normals=fragment.normals[::2])
    if request.param == "fitted":
        cloud = cloud.estimate_normals(max_nn=30)
    limits = dict(TUTORIAL, min_plane_edge_length=0, min_num_points=0)
    oracle = to_open3d(cloud.points, cloud.normals)
    return cloud, oracle.detect_planar_patches(**limits, search_param=o3d.geometry.KDTreeSearchParamKNN(30))


def test_patches_of_the_fragment_are_open3ds(device, scan, tolerances):
    cloud, expected = scan
    result = cloud.to(device).detect_planar_patches(**TUTORIAL)
    for boxes, others in ((result, expected), (expected, result)):
        areas = np.array([box.extent[0] * box.extent[1] for box in boxes])
        known = np.array([matches(box, others, tolerances) for box in boxes])
        assert areas[known].sum() / areas.sum() > tolerances.patch_area


@pytest.mark.parametrize(
    ("noise", "shift", "rotated"), [(0.0, 0.0, False), (0.02, 0.0, False), (0.005, 5.0e6, True)], ids=str
)
def test_a_room_has_its_six_faces(device, noise, shift, rotated, rng):
    """Open3D detects only some of them without noise: no point is closer than 0 to an exact plane."""
    points, _ = room(rng, 12_000, noise)
    R, offset = np.eye(3), np.array([shift / 10, shift, 100])
    if rotated:
        R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        R *= np.sign(np.linalg.det(R))
    cloud = loom.PointCloud(points @ R.T + offset, device=device).estimate_normals(max_nn=30)
    patches = cloud.detect_planar_patches()
    assert len(patches) == 6
    faces = set()
    for patch in patches:
        np.testing.assert_allclose(patch.R.T @ patch.R, np.eye(3), atol=1e-9)
        rotation, middle = R.T @ patch.R, R.T @ (patch.center - offset)
        axis = int(np.abs(rotation[:, 2]).argmax())
        assert abs(rotation[axis, 2]) > 0.999 and np.linalg.det(patch.R) > 0
        assert not rotated or np.abs(rotation[:, 0]).max() > 0.99, "sides along the room's own edges"
        faces.add((axis, bool(middle[axis] > ROOM[axis] / 2)))
        assert min(abs(middle[axis]), abs(middle[axis] - ROOM[axis])) < 0.15
        sides = np.sort(np.delete(ROOM, axis))
        assert (np.sort(patch.extent[:2]) > 0.75 * sides).all() and (np.sort(patch.extent[:2]) < sides + 0.2).all()
    assert len(faces) == 6


def test_a_floor_with_a_step_is_two_patches(device, rng):
    """The two levels do not fit each other; rough points on the step fit both, which joins them in Open3D."""
    x, y = rng.random((2, 24_000)) * [[2], [1.5]]
    rough = np.where((x > 0.95) & (x < 1.15), 0.0075, 0.003)
    height = 0.04 * np.clip((x - 1) / 0.1, 0, 1) + rough * rng.normal(size=len(x))
    frame = [[0, 0, 1.5], [2, 1.5, 1.5]]  # far above, so that a level is not an eighth of the box
    points = np.vstack([np.column_stack([x, y, height]), frame])
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    patches = sorted(cloud.detect_planar_patches(**TUTORIAL), key=lambda patch: patch.center[0])
    assert len(patches) == 2
    for patch, middle, level in zip(patches, (0.5, 1.5), (0.0, 0.04), strict=True):
        assert sorted(patch.extent)[1:] == pytest.approx([1.0, 1.5], abs=0.1)
        assert patch.center[[0, 2]] == pytest.approx([middle, level], abs=0.06)


def test_box_of_a_rectangle_is_the_rectangle(device, rng):
    """Minimal area to a tenth of a degree, all points inside up to rounding."""
    side = rng.random((20_000, 2)) * [3.0, 1.0]
    angle = np.radians(17.0)
    across = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    flat = np.column_stack([side @ across.T, 0.002 * rng.normal(size=20_000)])
    frame = np.array([[0, 0, 4.0], [3, 0, 4.2]])  # far below, so that the rectangle is not an eighth of the box
    cloud = loom.PointCloud(np.vstack([flat, frame]), device=device).estimate_normals(max_nn=20)
    (patch,) = cloud.detect_planar_patches()
    np.testing.assert_allclose(np.sort(patch.extent)[1:], [1.0, 3.0], atol=0.02)
    long_side = patch.R[:, np.argmax(patch.extent)]
    assert abs(long_side @ [np.cos(angle), np.sin(angle), 0]) > np.cos(np.radians(0.5))
    local = np.abs((cloud.points[:-2] - patch.center) @ patch.R)
    assert (local <= patch.extent / 2 + 1e-5).all(axis=1).mean() > 0.98, "its outliers may lie outside"


def test_normals_need_no_common_side(device, rng):
    """Open3D uses the median of the signed normals, which is undefined for mixed signs."""
    points, _ = room(rng, 12_000, 0.004)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    expected = cloud.detect_planar_patches()
    cloud.normals = cloud.normals * rng.choice([-1.0, 1.0], len(cloud))[:, None]
    result = cloud.detect_planar_patches()
    assert len(result) == len(expected) == 6
    for a, b in zip(result, expected, strict=True):
        np.testing.assert_allclose(a.center, b.center, atol=1e-5)
        np.testing.assert_allclose(a.extent, b.extent, atol=1e-5)


def test_a_ball_and_a_cloud_of_noise_have_no_large_patch(device, rng):
    directions = rng.normal(size=(8000, 3))
    ball = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    for points in (ball, rng.random((8000, 3))):
        patches = loom.PointCloud(points, device=device).estimate_normals(max_nn=20).detect_planar_patches(20, 85, 0.3)
        assert all(patch.extent[:2].max() < 0.8 for patch in patches)


def test_limits_choose_patches(device, rng):
    points, _ = room(rng, 12_000, 0.004)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    assert len(cloud.detect_planar_patches(min_plane_edge_length=5.0)) == 4, "the others are 4 m long"
    assert cloud.detect_planar_patches(min_plane_edge_length=50.0) == []
    assert cloud.detect_planar_patches(min_num_points=20_000) == []
    assert cloud.detect_planar_patches(normal_variance_threshold_deg=0.0) == []
    assert len(cloud.detect_planar_patches(radius=0.5)) == 6
    assert cloud.detect_planar_patches(radius=1e-6) == [], "no neighbor to grow to"


@pytest.mark.parametrize("count", [0, 1, 2, 12])
def test_clouds_of_a_few_points_have_no_patches(device, count):
    points = np.column_stack([np.arange(count), np.arange(count) % 3, np.zeros(count)]).astype(float).reshape(-1, 3)
    cloud = loom.PointCloud(points, normals=np.tile([0, 0, 1.0], (count, 1)), device=device)
    assert cloud.detect_planar_patches() == []


@pytest.mark.parametrize("points", [np.ones((500, 3)), np.outer(np.linspace(0, 1, 500), [1, 2, 3])])
def test_equal_points_and_lines_end(device, points):
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=10)
    patches = cloud.detect_planar_patches()
    assert all(np.sort(patch.extent)[1] < 0.002 * patch.extent.max() for patch in patches), "a tenth of a degree"


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**20), kind=st.sampled_from(["lattice", "noise", "copies", "nan"]))
def test_boxes_of_any_cloud_are_boxes(seed, kind):
    rng = np.random.default_rng(seed)
    points = rng.integers(0, 5, (150, 3)).astype(float) if kind == "lattice" else rng.random((150, 3))
    if kind == "copies":
        points = np.repeat(points[:15], 10, axis=0)
    if kind == "nan":
        points[rng.random(150) < 0.3] = np.nan
    patches = loom.PointCloud(points).estimate_normals(max_nn=8).detect_planar_patches(80, 30, 1.0, max_nn=8)
    sizes = [patch.extent[:2].prod() for patch in patches]
    assert np.isfinite(sizes).all() and (np.array(sizes) >= 0).all()
