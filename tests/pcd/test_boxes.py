"""Boxes: Open3D's on real scans, the smallest against fine searches, and flat ones where Open3D raises errors."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import pointloom as loom

UTM = np.array([500_000.0, 5_400_000.0, 128.0])
TURN = np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]])
MAKERS = ("get_oriented_bounding_box", "get_minimal_oriented_bounding_box")


@pytest.fixture(scope="module")
def scans(fragment, lidar, scan_file):
    """Real scans that float32 holds exactly, about their middle."""
    import open3d as o3d

    terrain = np.asarray(o3d.io.read_point_cloud(str(scan_file("lidar-pcl-terrain/samp12-utm.pcd"))).points)
    clouds = {"fragment": fragment.points, "lidar": lidar[:, :3], "terrain": terrain - terrain.mean(axis=0).round()}
    return {name: points.astype(np.float32).astype(float) for name, points in clouds.items()}


def random_rotation(rng):
    Q, R = np.linalg.qr(rng.normal(size=(3, 3)))
    Q = Q * np.sign(np.diag(R))
    return Q * np.sign(np.linalg.det(Q))


def assert_same_box(found, expected, limit):
    """The same box whatever the signs of its axes."""
    np.testing.assert_allclose(found.center, expected.center, rtol=0, atol=limit)
    np.testing.assert_allclose(found.extent, expected.extent, rtol=0, atol=limit)
    assert np.abs(np.abs(np.einsum("ij,ij->j", found.R, expected.R)) - 1).max() < 1e-12
    assert np.linalg.det(found.R) > 0


# ------------------------------------------------------------------------------------------------ of clouds


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
def test_the_aligned_box_of_a_scan_is_open3ds(device, scan, scans, to_open3d):
    box = loom.PointCloud(scans[scan], device=device).get_axis_aligned_bounding_box()
    expected = to_open3d(scans[scan]).get_axis_aligned_bounding_box()
    np.testing.assert_array_equal(box.min_bound, expected.min_bound)
    np.testing.assert_array_equal(box.max_bound, expected.max_bound)


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
def test_the_principal_box_of_a_scan_is_open3ds(device, scan, scans, to_open3d, tolerances):
    points = scans[scan]
    cloud = loom.PointCloud(points, device=device)
    box, expected = cloud.get_oriented_bounding_box(), to_open3d(points).get_oriented_bounding_box()
    assert_same_box(box, expected, tolerances.box_share * np.ptp(points))
    assert len(cloud.crop(box)) == len(cloud)


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
def test_the_smallest_box_of_a_scan_is_no_larger_than_open3ds(device, scan, scans, to_open3d, tolerances):
    points = scans[scan]
    cloud = loom.PointCloud(points, device=device)
    box, expected = cloud.get_minimal_oriented_bounding_box(), to_open3d(points).get_minimal_oriented_bounding_box()
    assert holds_all(expected, points) and box.volume() <= expected.volume() * (1 + tolerances.box_volume)
    assert len(cloud.crop(box)) == len(cloud)
    assert box.volume() <= cloud.get_oriented_bounding_box().volume()


@pytest.mark.parametrize("shape", ["few", "some", "ball", "flat", "cube", "tetrahedron", "octahedron", "prism"])
def test_the_smallest_box_of_a_shape_is_no_larger_than_open3ds(device, shape, rng, to_open3d, tolerances):
    made = {
        "few": [rng.normal(size=(n, 3)) for n in (4, 5, 5, 6, 7, 8, 9)],
        "some": [rng.normal(size=(n, 3)) * [3, 2, 1] for n in (30, 100)],
        "ball": [(lambda p: p / np.linalg.norm(p, axis=1, keepdims=True))(rng.normal(size=(150, 3)))],
        "flat": [rng.random((60, 3)) * [50, 50, 1]],
        "cube": [np.indices((3, 3, 3)).reshape(3, -1).T @ TURN],
        "tetrahedron": [np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]]) @ TURN],
        "octahedron": [np.concatenate([np.eye(3), -np.eye(3)])],
        "prism": [np.array([[np.cos(a), np.sin(a), z] for a in np.arange(7) for z in (0, 0.5)]) @ TURN],
    }
    for points in made[shape]:
        points = points.astype(np.float32).astype(float)
        cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
        box, oracle = cloud.get_minimal_oriented_bounding_box(), to_open3d(points).get_minimal_oriented_bounding_box()
        assert len(cloud.crop(box)) == len(cloud)
        if holds_all(oracle, points):
            assert box.volume() <= oracle.volume() * (1 + tolerances.box_volume)
        else:
            assert shape in ("ball", "prism"), "where Open3D finds axes that are not orthogonal, and takes x, y, z"


def holds_all(oracle, points):
    """Whether a box of Open3D's, a millionth wider, holds the points that it was made around."""
    import open3d as o3d

    wider = o3d.geometry.OrientedBoundingBox(oracle.center, oracle.R, oracle.extent * (1 + 1e-6) + 1e-9)
    return len(wider.get_point_indices_within_bounding_box(o3d.utility.Vector3dVector(np.array(points)))) == len(points)


@pytest.mark.slow
def test_no_frame_of_a_fine_search_gives_a_smaller_box(device, rng, tolerances):
    """200,000 frames, then steps from the best of them that grow smaller, for each cloud."""
    frames = np.stack([random_rotation(rng) for _ in range(2000)])
    small = np.stack([random_rotation(rng) for _ in range(100)])
    frames = (frames[:, None] @ small[None]).reshape(-1, 3, 3)
    for count in (4, 6, 10, 40):
        points = rng.normal(size=(count, 3)).astype(np.float32).astype(float)
        box = loom.PointCloud(points, device=device, origin=np.zeros(3)).get_minimal_oriented_bounding_box()

        def volumes(turns, points=points):
            return np.ptp(np.einsum("nj,fjk->fnk", points, turns), axis=1).prod(axis=1)

        found = volumes(frames)
        best, frame = found.min(), frames[found.argmin()]
        for scale in 0.5 ** np.arange(1, 22):
            axes = rng.normal(size=(200, 3)) * scale * 0.2
            K = np.zeros((200, 3, 3))
            K[:, 0, 1], K[:, 0, 2], K[:, 1, 2] = axes.T
            steps, _ = np.linalg.qr(np.eye(3) + K - K.transpose(0, 2, 1))
            found = volumes(frame @ steps)
            if found.min() < best:
                best, frame = found.min(), frame @ steps[found.argmin()]
        assert box.volume() <= best * (1 + tolerances.box_volume)
        assert best < box.volume() * 1.02, "the search finds nearly the same box"


@pytest.mark.parametrize("maker", MAKERS)
def test_a_turned_box_is_found_again(device, maker, rng):
    corners = loom.AxisAlignedBoundingBox([0, 0, 0], [4, 2, 1]).get_box_points()
    inside = rng.random((300, 3)) * [4, 2, 1]
    R = random_rotation(rng)
    points = np.concatenate([corners, inside]) @ R.T + [7, 8, 9]
    cloud = loom.PointCloud(points, device=device, origin=[7, 8, 9])
    box = getattr(cloud, maker)()
    if maker == "get_oriented_bounding_box":
        cloud = loom.PointCloud(points[:8], device=device, origin=[7, 8, 9])
        box = getattr(cloud, maker)()
    np.testing.assert_allclose(np.sort(box.extent), [1, 2, 4], atol=2e-6)
    np.testing.assert_allclose(box.center, R @ [2, 1, 0.5] + [7, 8, 9], atol=2e-6)
    order = np.argsort(-box.extent)
    np.testing.assert_allclose(np.abs(np.einsum("ij,ij->j", box.R[:, order], R)), 1, atol=1e-9)


@pytest.mark.parametrize("maker", MAKERS)
def test_boxes_far_from_zero_are_those_at_zero(device, maker, rng, tolerances):
    points = (rng.normal(size=(500, 3)) * [30, 20, 5]).astype(np.float32).astype(float)
    near = getattr(loom.PointCloud(points, device=device, origin=np.zeros(3)), maker)()
    cloud = loom.PointCloud(points + UTM, device=device, origin=UTM)
    far = getattr(cloud, maker)()
    np.testing.assert_allclose(far.center - UTM, near.center, atol=2e-9)
    np.testing.assert_allclose(far.extent, near.extent, atol=1e-8)
    assert len(cloud.crop(far)) == 500


@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("turn", [np.eye(3), TURN], ids=["aligned", "turned"])
def test_boxes_of_degenerate_clouds_are_flat(device, maker, turn, to_open3d):
    """Open3D raises errors of Qhull for each of them."""
    square = np.array([[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0], [1, 1, 0]], float)
    clouds = {"plane": (square, [0, 2, 4]), "triangle": (square[:3], None), "line": (square[:2], [0, 0, 4])}
    clouds |= {"point": (square[:1] + 3, [0, 0, 0]), "equal": (np.ones((9, 3)), [0, 0, 0])}
    for name, (points, extents) in clouds.items():
        points = points @ turn.T
        with pytest.raises(RuntimeError, match=r"QH|Open3D Error"):
            getattr(to_open3d(points), maker)()
        cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
        box = getattr(cloud, maker)()
        assert np.sort(box.extent)[0] < 2e-6 and len(cloud.crop(box)) == len(points), name
        if extents is not None:
            np.testing.assert_allclose(np.sort(box.extent), extents, atol=2e-6, err_msg=name)


def test_the_smallest_box_of_points_in_a_plane_has_the_least_area(device, rng):
    flat = rng.normal(size=(300, 2))
    points = np.column_stack([flat, np.full(300, 2.0)])
    box = loom.PointCloud(points, device=device).get_minimal_oriented_bounding_box()
    angles = np.linspace(0, np.pi / 2, 20_001)
    across = np.ptp(np.outer(np.cos(angles), flat[:, 0]) + np.outer(np.sin(angles), flat[:, 1]), axis=1)
    along = np.ptp(np.outer(-np.sin(angles), flat[:, 0]) + np.outer(np.cos(angles), flat[:, 1]), axis=1)
    assert np.sort(box.extent)[0] < 1e-6
    assert np.sort(box.extent)[1:].prod() == pytest.approx((across * along).min(), rel=1e-3)
    assert np.sort(box.extent)[1:].prod() <= (across * along).min() * (1 + 1e-6)


@pytest.mark.parametrize("maker", MAKERS)
def test_a_large_noisy_plane_has_a_thin_box_that_holds_it(device, maker, rng):
    """Turned, float32 rounds its points off the plane by up to 1e-7."""
    points = np.column_stack([rng.random((20_000, 2)), np.zeros(20_000)]) @ TURN.T
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    box = getattr(cloud, maker)()
    assert np.sort(box.extent)[0] < 1e-6 and len(cloud.crop(box)) == len(cloud)


@pytest.mark.parametrize("maker", MAKERS)
def test_a_cloud_without_finite_points_has_no_turned_box(device, maker):
    for points in (np.zeros((0, 3)), [[np.nan, 0, 0], [np.inf, 0, 0]]):
        cloud = loom.PointCloud(points, device=device)
        with pytest.raises(ValueError, match="points: expected at least one finite point, got none"):
            getattr(cloud, maker)()
        aligned = cloud.get_axis_aligned_bounding_box()
        assert aligned == loom.AxisAlignedBoundingBox([0] * 3, [0] * 3) and aligned.is_empty()


coordinate = st.sampled_from([0.0, 0.5, 1.0, -1.0]) | st.integers(-512, 512).map(lambda n: n / 128)


@given(rows=st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=1, max_size=12), gap=st.integers(1, 30))
@settings(max_examples=50, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_boxes_hold_their_points_and_the_smallest_is_smallest(device, rows, gap):
    points = np.array(rows)
    if gap < len(points):
        points[gap, gap % 3] = np.nan
    cloud = loom.PointCloud(points, device=device)
    finite = int(np.isfinite(points).all(axis=1).sum())
    aligned = cloud.get_axis_aligned_bounding_box()
    principal, smallest = (getattr(cloud, maker)() for maker in MAKERS)
    for box in (aligned, principal, smallest):
        assert len(cloud.crop(box)) == finite
        assert len(box.get_point_indices_within_bounding_box(cloud)) == finite
    assert smallest.volume() <= min(aligned.volume(), principal.volume()) * (1 + 1e-9) + 1e-9


@pytest.mark.parametrize("maker", MAKERS)
def test_the_box_of_a_slanted_segment_holds_its_ends(device, maker):
    """Across it the ends lie at 0 in one order of sums and at 1e-17 in another."""
    cloud = loom.PointCloud([(0.0, 1 / 128, 0.5), (1.0, 0.5, 0.0)], device=device)
    box = getattr(cloud, maker)()
    assert len(cloud.crop(box)) == 2
    assert np.sort(box.extent)[:2].max() < 1e-14


def test_joggling_changes_little(device, rng):
    cloud = loom.PointCloud(rng.normal(size=(300, 3)), device=device)
    for maker in MAKERS:
        plain, joggled = getattr(cloud, maker)(), getattr(cloud, maker)(robust=True)
        assert joggled.volume() == pytest.approx(plain.volume(), rel=1e-6)


def test_two_runs_give_the_same_boxes(device, rng):
    cloud = loom.PointCloud(rng.normal(size=(7000, 3)), device=device)
    for maker in MAKERS:
        assert getattr(cloud, maker)() == getattr(cloud, maker)()


# ------------------------------------------------------------------------------------------------ boxes themselves


def pairs():
    import open3d as o3d

    low, high, middle = [0.5, 1, 2], [3, 5, 8.25], [1, 2, 3]
    aligned = loom.AxisAlignedBoundingBox(low, high), o3d.geometry.AxisAlignedBoundingBox(low, high)
    kinds = (loom.OrientedBoundingBox, o3d.geometry.OrientedBoundingBox)
    turned = tuple(kind(middle, TURN, [2, 4, 6]) for kind in kinds)
    return {"aligned": aligned, "turned": turned}


def assert_corners_agree(box, oracle):
    np.testing.assert_allclose(box.get_box_points(), np.asarray(oracle.get_box_points()), rtol=1e-14, atol=1e-14)


@pytest.mark.parametrize("kind", ["aligned", "turned"])
def test_measures_and_corners_of_a_box_are_open3ds(kind):
    box, oracle = pairs()[kind]
    assert_corners_agree(box, oracle)
    for name in ("get_center", "get_min_bound", "get_max_bound", "volume", "is_empty"):
        np.testing.assert_allclose(getattr(box, name)(), getattr(oracle, name)(), rtol=1e-14)
    extent = oracle.get_extent() if kind == "aligned" else oracle.extent
    np.testing.assert_array_equal(box.get_extent(), extent)
    np.testing.assert_array_equal(box.get_half_extent(), extent / 2)
    assert box.get_max_extent() == extent.max()
    assert box.color.tolist() == ([1, 1, 1] if kind == "aligned" else [0, 0, 0]), "Open3D leaves the latter undefined"
    aligned, theirs = box.get_axis_aligned_bounding_box(), oracle.get_axis_aligned_bounding_box()
    assert_corners_agree(aligned, theirs)
    if kind == "aligned":
        assert box.get_print_info() == oracle.get_print_info()


@pytest.mark.parametrize("kind", ["aligned", "turned"])
def test_boxes_move_as_open3ds_and_stay_as_they_were(kind):
    moves = {
        "translate": ([1, 2, 3],),
        "translate there": ([1, 2, 3], False),
        "scale": (2.5, [1, 0, -1]),
        "rotate": (TURN, [1, 0, -1]),
    }
    for name, arguments in moves.items():
        box, oracle = pairs()[kind]
        box.color = (1, 0, 0)
        before = box.get_box_points()
        moved = getattr(box, name.split()[0])(*arguments)
        if kind == "aligned" and name == "rotate":
            import open3d as o3d

            with pytest.raises(RuntimeError, match="not be axis-aligned"):
                oracle.rotate(*arguments)
            oracle = o3d.geometry.OrientedBoundingBox.create_from_axis_aligned_bounding_box(pairs()[kind][1])
        expected = getattr(oracle, name.split()[0])(*arguments)
        assert_corners_agree(moved, expected)
        np.testing.assert_array_equal(box.get_box_points(), before)
    assert pairs()[kind][0].translate([1, 2, 3], relative=False).get_center().tolist() == [1, 2, 3]


def test_a_box_keeps_its_colour_when_it_moves():
    for box, _ in pairs().values():
        box.color = (1, 0, 0)
        for moved in (box.translate([1, 2, 3]), box.scale(2, [0, 0, 0]), box.rotate(TURN)):
            assert moved.color.tolist() == [1, 0, 0]
        for wrong in ((1, 0), (2, 0, 0), (np.nan, 0, 0)):
            with pytest.raises(ValueError, match="color: expected"):
                box.color = wrong


def test_rotating_about_no_point_keeps_the_middle():
    for box, _ in pairs().values():
        np.testing.assert_allclose(box.rotate(TURN).get_center(), box.get_center())


def test_the_points_in_a_box_are_open3ds_of_arrays_and_of_clouds(device, rng):
    import open3d as o3d

    points = np.concatenate([rng.integers(-2, 12, (800, 3)) / 2.0, rng.random((300, 3)) * 8, [[np.nan, 1, 1]]])
    cloud = loom.PointCloud(points, device=device, origin=np.zeros(3))
    for box, oracle in pairs().values():
        held = cloud.points
        expected = oracle.get_point_indices_within_bounding_box(o3d.utility.Vector3dVector(held.copy()))
        assert 10 < len(expected) < 1000
        for given_points in (held, cloud):
            np.testing.assert_array_equal(box.get_point_indices_within_bounding_box(given_points), expected)
    with pytest.raises(ValueError, match=r"points: expected shape \[n, 3\]"):
        box.get_point_indices_within_bounding_box(np.zeros((3, 2)))


def test_sums_of_boxes_are_open3ds():
    import open3d as o3d

    bounds = [([0, 1, 2], [3, 5, 8]), ([10, 10, 10], [11, 11, 11]), ([50, 50, 50], [50, 51, 51]), ([0] * 3, [0] * 3)]
    for a in bounds:
        for b in bounds:
            oracle = o3d.geometry.AxisAlignedBoundingBox(*a)
            oracle += o3d.geometry.AxisAlignedBoundingBox(*b)
            total = loom.AxisAlignedBoundingBox(*a) + loom.AxisAlignedBoundingBox(*b)
            assert total == loom.AxisAlignedBoundingBox(oracle.min_bound, oracle.max_bound)
    with pytest.raises(TypeError):
        total + 1


def test_boxes_made_of_points_are_those_of_the_cloud(rng, tolerances):
    points = (rng.normal(size=(400, 3)) * [3, 2, 1]).astype(np.float32).astype(float)
    points[7] = np.nan
    cloud = loom.PointCloud(points, origin=np.zeros(3))
    assert loom.AxisAlignedBoundingBox.create_from_points(points) == cloud.get_axis_aligned_bounding_box()
    assert loom.AxisAlignedBoundingBox.create_from_points([]).is_empty()
    made = loom.OrientedBoundingBox.create_from_points(points)
    assert_same_box(made, cloud.get_oriented_bounding_box(), 100 * tolerances.box_share)
    smallest = loom.OrientedBoundingBox.create_from_points_minimal(points)
    assert smallest.volume() == pytest.approx(cloud.get_minimal_oriented_bounding_box().volume())
    turned = loom.OrientedBoundingBox.create_from_axis_aligned_bounding_box(cloud.get_axis_aligned_bounding_box())
    np.testing.assert_array_equal(turned.R, np.eye(3))
    for create in (loom.OrientedBoundingBox.create_from_points, loom.OrientedBoundingBox.create_from_points_minimal):
        with pytest.raises(ValueError, match="at least one finite point"):
            create([])


def test_boxes_compare_by_value_and_show_it():
    aligned, turned = (pairs()[kind][0] for kind in ("aligned", "turned"))
    assert aligned == pairs()["aligned"][0] and turned == pairs()["turned"][0] and aligned != turned
    assert aligned != aligned.translate([0, 0, 1]) and turned != turned.scale(2, [0, 0, 0])
    assert repr(aligned) == "AxisAlignedBoundingBox([0.5, 1.0, 2.0], [3.0, 5.0, 8.25])"
    assert repr(turned).startswith("OrientedBoundingBox([1.0, 2.0, 3.0], [[0.8,")
    # six digits of its size, wherever it lies
    far = loom.AxisAlignedBoundingBox([500_000 + 1 / 3, 1 / 3, -1e-9], [500_002, 2 / 3, 0.1])
    assert repr(far) == "AxisAlignedBoundingBox([500000.333333, 0.333333, 0.0], [500002.0, 0.666667, 0.1])"
    small = loom.AxisAlignedBoundingBox([1e-5 / 3] * 3, [1e-5] * 3)
    assert repr(small) == f"AxisAlignedBoundingBox({[3.333333e-06] * 3}, {[1e-05] * 3})"
    tilted = loom.OrientedBoundingBox([1 / 3] * 3, np.eye(3), [1000 / 3, 2, 1])
    assert repr(tilted).startswith("OrientedBoundingBox([0.3333, 0.3333, 0.3333], [[1.0, 0.0,")
    with pytest.raises(TypeError, match="unhashable"):
        hash(aligned)
    with pytest.raises(ValueError, match="read-only"):
        aligned.min_bound[0] = 99


@pytest.mark.parametrize("factor", [0, -1, np.nan])
def test_a_scale_that_is_none_is_refused(factor):
    for box, _ in pairs().values():
        with pytest.raises(ValueError, match="scale: expected a finite number > 0"):
            box.scale(factor, [0, 0, 0])
        with pytest.raises(ValueError, match="translation: expected finite numbers"):
            box.translate([0, 0, np.nan])
