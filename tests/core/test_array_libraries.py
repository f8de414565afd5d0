"""Arrays come back as they came: whose they are, where they are, at which address, and with the same numbers."""

import dataclasses
import functools
import pickle
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.depth_filters import create_normal_map, pyrdown_color
from pointloom.cameras.panoramas import Panorama
from pointloom.photogrammetry.depth.evaluation import evaluate_depth
from pointloom.registration.globally.fast_global import registration_fgr_based_on_correspondence

from ..array_library import LIBRARIES, assert_same, fake_library, package
from ..io.sfm_models import ring_model

POLYGON = loom.SelectionPolygonVolume([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "Z", axis_min=-1, axis_max=1)


@pytest.fixture(params=LIBRARIES)
def library(request, device, monkeypatch):
    """A library: `make` an array of its of NumPy's where `device` is, its address, and back to NumPy."""
    return fake_library(request.param, device, monkeypatch)


@pytest.fixture
def surface(rng):
    x, y = rng.random((2, 400))
    return np.column_stack([x, y, 0.2 * np.sin(6 * x) * np.cos(5 * y)]).astype(np.float32)


@pytest.fixture
def clouds(library, device, surface):
    cloud = loom.PointCloud(library.make(surface)).estimate_normals(max_nn=12)
    reference = loom.PointCloud(surface, device=device).estimate_normals(max_nn=12)
    assert str(cloud.device) == str(reference.device) == device
    return cloud, reference


def test_a_cloud_shares_the_memory_of_its_input(library, device, surface):
    points, normals, label = library.make(surface), library.make(surface), library.make(np.arange(400, dtype=np.int32))
    cloud = loom.PointCloud(points, normals=normals, label=label)
    assert str(cloud.device) == device
    for name, given in (("points", points), ("normals", normals), ("label", label)):
        assert cloud.arrays[name].ptr == library.address(given)
    np.testing.assert_array_equal(cloud.points, surface.astype(np.float64))
    cloud.points = library.make(surface + 1)
    np.testing.assert_array_equal(cloud.points, surface + np.float32(1))


def test_writes_to_a_shared_array_are_noticed(library, surface):
    if library.name in ("torch", "jax"):
        pytest.skip("written to through Warp below, as both are")
    points = library.make(surface)
    cloud = loom.PointCloud(points)
    before = library.host(cloud.compute_nearest_neighbor_distance()).copy()
    memory = points if library.name == "warp" else points.memory
    memory.assign(surface * 2)
    np.testing.assert_allclose(library.host(cloud.compute_nearest_neighbor_distance()), 2 * before, rtol=1e-6)


@pytest.mark.parametrize(
    "convert",
    [
        lambda p: p.astype(np.float16),
        lambda p: (p * 100).astype(np.int32),
        lambda p: p.astype(np.float64) + np.float64([5e5, 5.4e6, 100]),
        lambda p: np.vstack([p, [[np.nan, 0, 0], [np.inf, 1, 1]]]),
        lambda p: p[:0],
    ],
)
def test_other_dtypes_and_devices_convert_as_from_numpy(library, device, surface, convert):
    given = convert(surface)
    if library.name == "jax" and given.dtype == np.float64:
        pytest.skip("jax makes float32 of it")
    cloud, reference = loom.PointCloud(library.make(given)), loom.PointCloud(given, device=device)
    np.testing.assert_array_equal(cloud.origin, reference.origin)
    np.testing.assert_array_equal(cloud.points, reference.points)


def test_colors_of_both_kinds_are_taken(library, device, surface, rng):
    for colors in (rng.random((400, 3)).astype(np.float32), rng.integers(0, 256, (400, 3)).astype(np.uint8)):
        cloud = loom.PointCloud(library.make(surface), colors=library.make(colors))
        np.testing.assert_array_equal(cloud.colors, loom.PointCloud(surface, colors=colors, device=device).colors)
    with pytest.raises(ValueError, match="colors:"):
        loom.PointCloud(library.make(surface), colors=library.make(np.full((400, 3), 7, np.float32)))


def test_operations_of_a_cloud_give_arrays_of_its_library(library, clouds):
    cloud, reference = clouds
    T = np.eye(4)
    T[0, 3] = 0.01
    operations = {
        "dbscan": lambda c: c.cluster_dbscan(0.1, 4),
        "euclidean": lambda c: c.cluster_euclidean(0.06, 2),
        "nearest": lambda c: c.compute_nearest_neighbor_distance(),
        "distance": lambda c: c.compute_point_cloud_distance(c.transform(T)),
        "mahalanobis": lambda c: c.compute_mahalanobis_distance(),
        "statistical": lambda c: c.remove_statistical_outlier(8, 1.0)[1],
        "radius": lambda c: c.remove_radius_outlier(4, 0.1)[1],
        "plane": lambda c: c.segment_plane(0.05)[1],
        "planes": lambda c: c.segment_planes(0.03, min_points=20)[0],
        "hidden": lambda c: c.hidden_point_removal([0, 0, 5], 100)[1],
        "hull": lambda c: c.compute_convex_hull()[1],
        "farthest": lambda c: c.farthest_point_indices(7),
        "none farthest": lambda c: c.farthest_point_indices(0),
        "box": lambda c: loom.AxisAlignedBoundingBox([0, 0, 0], [0.5] * 3).get_point_indices_within_bounding_box(c),
        "polygon": lambda c: POLYGON.crop_in_polygon(c),
        "ground": lambda c: loom.classify_ground(c),
        "keypoints": lambda c: loom.compute_iss_keypoints(c, 0.2, 0.1, return_indices=True)[1],
        "features": lambda c: loom.compute_fpfh_feature(c, max_nn=20),
        "trace": lambda c: c.voxel_down_sample_and_trace(0.3).voxel_of_point,
        "cubes": lambda c: c.voxel_down_sample_and_trace(0.3).cubic_id,
        "voxels": lambda c: c.voxel_down_sample_and_trace(0.3).original_indices[1],
        "pairs": lambda c: loom.registration.evaluate_registration(c, c.transform(T), 0.02).correspondence_set,
        "no pairs": lambda c: loom.registration.evaluate_registration(c, c.scale(9, [9] * 3), 0.01).correspondence_set,
        "thinned": lambda c: c.voxel_down_sample(0.1).cluster_dbscan(0.2, 3),
        "sum": lambda c: (c + c).cluster_dbscan(0.1, 4),
    }
    for name, operation in operations.items():
        try:
            assert_same(library, operation(cloud), operation(reference))
        except AssertionError as error:
            raise AssertionError(name) from error


def on_host(library, values):
    """Values as NumPy's: those of a device are copied."""
    return library.host(values) if package(values) in ("warp", "torch") else np.asarray(values)


def test_search_results_have_the_array_type_of_the_queries(library, clouds, surface):
    cloud, reference = clouds
    queries = surface[::7] + np.float32(0.01)
    for search in (loom.NearestNeighborSearch(cloud), loom.NearestNeighborSearch(reference)):
        for search_method in (
            lambda q, s=search: s.knn_search(q, 5),
            lambda q, s=search: s.hybrid_search(q, 0.1, 6),
            lambda q, s=search: s.radius_search(q, 0.1),
        ):
            for result, expected in zip(search_method(library.make(queries)), search_method(queries), strict=True):
                assert package(expected) == "numpy"
                assert_same(library, result, expected)
            assert_same(library, search_method(cloud).indices, search_method(reference).indices)
    single = loom.NearestNeighborSearch(reference).knn_search(library.make(queries[3]), 4)
    assert_same(library, single.indices, loom.NearestNeighborSearch(reference).knn_search(queries[3], 4).indices)
    assert int(np.ravel(on_host(library, single.counts))[0]) == 4
    tree = loom.KDTree(reference)
    for x in (queries, queries[3]):
        for result, expected in zip(tree.query(library.make(x), 4), tree.query(x, 4), strict=True):
            assert_same(library, result, expected)


def test_a_result_is_the_memory_that_the_device_wrote(library, clouds, monkeypatch):
    from pointloom.core import array_libraries

    written, through = [], array_libraries.hand_out

    def watched(array, *args, **options):
        written.append(array)
        return through(array, *args, **options)

    monkeypatch.setattr(array_libraries, "hand_out", watched)
    labels, distances = clouds[0].cluster_dbscan(0.1, 4), clouds[0].compute_nearest_neighbor_distance()
    assert library.address(labels) == written[0].ptr
    if library.name != "jax":  # which makes float32 of them
        assert library.address(distances) == written[1].ptr


def test_indices_and_masks_may_be_arrays_of_any_library(library, clouds):
    cloud, reference = clouds
    for rows in (np.array([3, 1, 1, 399]), np.array([-1, 5], np.int32), np.array([2], np.uint8), np.zeros(0, np.int64)):
        for invert in (False, True):
            chosen = cloud.select_by_index(library.make(rows), invert)
            np.testing.assert_array_equal(chosen.points, reference.select_by_index(rows, invert).points)
    mask = np.arange(400) % 3 == 0
    for invert in (False, True):
        chosen = cloud.select_by_mask(library.make(mask), invert)
        np.testing.assert_array_equal(chosen.points, reference.select_by_mask(mask, invert).points)
    rows = np.array([7, -1, 3])
    feature = loom.compute_fpfh_feature(cloud, max_nn=20, indices=library.make(rows))
    assert_same(library, feature, loom.compute_fpfh_feature(reference, max_nn=20, indices=rows))
    with pytest.raises(IndexError, match="indices:"):
        cloud.select_by_index(library.make(np.array([0, 400])))
    with pytest.raises(TypeError, match="indices:"):
        cloud.select_by_index(library.make(np.zeros(3, np.float32)))
    with pytest.raises(ValueError, match="mask:"):
        cloud.select_by_mask(library.make(mask[:5]))


def test_registrations_use_features_and_pairs_on_their_device(library, clouds):
    cloud, reference = clouds
    T = np.eye(4)
    T[:3, 3] = 0.02, -0.01, 0.03
    features = {c: loom.compute_fpfh_feature(c, max_nn=30) for c in clouds}
    register = loom.registration
    pairs = register.correspondences_from_features(features[reference], features[reference], True)
    assert_same(library, register.correspondences_from_features(features[cloud], features[cloud], True), pairs)
    twice = np.concatenate([pairs, pairs[::-1]])
    calls = {
        "ransac": lambda c, f, p: register.registration_ransac_based_on_correspondence(
            c, c.transform(T), register.correspondences_from_features(f, f, True), 0.05, num_iterations=500
        ),
        "fgr": lambda c, f, p: registration_fgr_based_on_correspondence(c, c.transform(T), p),
        "robust": lambda c, f, p: register.registration_robust_based_on_correspondence(c, c.transform(T), p, 0.02),
    }
    for name, call in calls.items():
        result = call(cloud, features[cloud], library.make(twice))
        expected = call(reference, features[reference], twice)
        np.testing.assert_array_equal(result.transformation, expected.transformation, err_msg=name)
        assert_same(library, result.correspondence_set, expected.correspondence_set)
    with pytest.raises(IndexError, match="corres:"):
        calls["fgr"](cloud, None, library.make(np.array([[0, 0], [1, 400]])))
    with pytest.raises(TypeError, match="corres:"):
        calls["fgr"](cloud, None, library.make(np.zeros((2, 2), np.float32)))


def test_a_pickled_result_needs_no_device(library, clouds):
    evaluation = loom.registration.evaluate_registration(clouds[0], clouds[0], 0.02)
    if package(evaluation.correspondence_set) == "cupy":
        return  # arrays of the fake library cannot be pickled
    again = on_host(library, pickle.loads(pickle.dumps(evaluation)).correspondence_set)
    np.testing.assert_array_equal(again, np.column_stack([np.arange(400)] * 2))


def test_depth_and_color_images_are_used_on_their_device(library, device, rng):
    camera = loom.PinholeCameraIntrinsic(16, 12, 20.0, 20.0, 7.5, 5.5)
    color = rng.integers(0, 256, (12, 16, 3)).astype(np.uint8)
    for depth in (
        rng.integers(0, 3000, (12, 16)).astype(np.uint16),
        rng.integers(0, 3000, (12, 16)).astype(np.int32),
        rng.random((12, 16)).astype(np.float32),
    ):
        cloud = loom.PointCloud.create_from_depth_image(library.make(depth), camera)
        reference = loom.PointCloud.create_from_depth_image(depth, camera, device=device)
        assert str(cloud.device) == device
        np.testing.assert_array_equal(cloud.points, reference.points)
        assert_same(library, cloud.compute_nearest_neighbor_distance(), reference.compute_nearest_neighbor_distance())
        for shade in (color, color[:, :, 0]):
            image = loom.RGBDImage(library.make(shade), library.make(depth))
            expected = loom.RGBDImage(shade, depth, device=device)
            np.testing.assert_array_equal(image.color, expected.color)
            np.testing.assert_array_equal(image.depth, expected.depth)
        filtered = loom.filter_depth_bilateral(library.make(depth))
        assert_same(library, filtered, loom.filter_depth_bilateral(depth, device=device))
    assert_same(library, pyrdown_color(library.make(color)), pyrdown_color(color, device=device))
    normals = library.host(create_normal_map(library.make(depth), camera))
    np.testing.assert_array_equal(normals, create_normal_map(depth, camera, device=device))


def test_a_cloud_with_zero_origin_exports_dlpack(library, clouds, surface):
    reference = clouds[1]
    for cloud in clouds:
        given, stored = (each.__dlpack_device__() for each in (cloud, reference.arrays["points"]))
        assert tuple(map(int, given)) == tuple(map(int, stored))
    if reference.device.is_cpu:
        points = np.from_dlpack(reference)
        np.testing.assert_array_equal(points, surface)
        assert points.ctypes.data == reference.arrays["points"].ptr
    far = loom.PointCloud(surface + np.float64([5e5, 5.4e6, 0]))
    with pytest.raises(BufferError, match=r"the points are relative to the origin \[5000.*add cloud.origin"):
        np.from_dlpack(far)


def test_a_cloud_from_a_file_exports_to_the_requested_library(library, device, surface):
    cloud = loom.PointCloud(surface, device=device)
    exported = cloud.to(device, arrays=library.name)
    assert_same(library, exported.cluster_dbscan(0.1, 4), cloud.cluster_dbscan(0.1, 4))
    assert exported.arrays["points"] is cloud.arrays["points"]
    assert package(exported.to(device, arrays="numpy").cluster_dbscan(0.1, 4)) == "numpy"
    assert package(cloud.cluster_dbscan(0.1, 4)) == "numpy"


def test_a_library_that_is_not_installed_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "cupy", None)
    with pytest.raises(ImportError, match="arrays of cupy need the package cupy: pip install cupy"):
        loom.PointCloud([[0, 0, 0]]).to("cpu", arrays="cupy")


def test_copies_and_pickles_keep_the_library(library, clouds):
    theirs, _ = clouds
    for cloud in (theirs.copy(), pickle.loads(pickle.dumps(theirs)), theirs.select_by_index([1, 2, 3])):
        assert package(cloud.compute_nearest_neighbor_distance()) == library.name


def test_numpy_lists_and_files_give_numpy_on_every_device(device, surface):
    for given in (surface, surface.tolist(), surface.astype(">f8"), np.asfortranarray(surface)[::-1]):
        cloud = loom.PointCloud(given, device=device)
        assert type(cloud.cluster_dbscan(0.1, 4)) is np.ndarray
        assert type(loom.NearestNeighborSearch(cloud).knn_search(surface, 2).indices) is np.ndarray
    before = surface.copy()
    cloud = loom.PointCloud(surface, device=device)
    surface += 1
    np.testing.assert_array_equal(cloud.points, before)  # a copy, as ever


class Scene:
    """Objects from arrays of a library (`make`), or from NumPy arrays on a device."""

    def __init__(self, make, device, surface):
        self.make, self.device, self.surface = make, device, surface

    @functools.cached_property
    def points(self):
        return self.make(self.surface[:50] + np.float32(0.01))

    @functools.cached_property
    def cloud(self):
        cloud = loom.PointCloud(self.make(self.surface), device=self.device)
        return cloud.estimate_normals(max_nn=8).orient_normals_to_align_with_direction()

    @functools.cached_property
    def mesh(self):
        ball = loom.TriangleMesh.create_sphere(1.0, 4)
        return loom.TriangleMesh(
            self.make(ball.vertices.astype(np.float32)), self.make(ball.triangles), device=self.device
        )

    @functools.cached_property
    def grid(self):
        grid = loom.OccupancyGrid(0.2, device=self.device)
        grid.insert_scan(self.make(self.surface), origin=self.make(np.array([0.5, 0.5, 2.0], np.float32)))
        return grid

    @functools.cached_property
    def field(self):
        return loom.DistanceField.from_point_cloud(self.cloud, 0.2, 0.6)

    @functools.cached_property
    def splats(self):
        count = 20
        columns = self.surface[:count], np.full((count, 3), 0.1), np.eye(4)[np.arange(count) % 4], np.full(count, 0.5)
        arrays = [self.make(np.float32(each)) for each in (*columns, np.arange(12 * count).reshape(count, 4, 3) / 99)]
        return loom.GaussianSplats(*arrays, device=self.device)

    @functools.cached_property
    def control(self):
        control = loom.rgbd.ControlGrid(0.5, device=self.device)
        control.touch(self.cloud)
        return control


ODD = np.arange(50) % 2 == 1
LENS = loom.CameraModel("OPENCV", 64, 48, [60, 60, 32, 24, -0.1, 0.01, 0.001, 0.002])
WEIGHTS = np.linspace(0.5, 1, 400).astype(np.float32)
VOXELS = loom.TriangleMesh.create_box().voxelize(0.25)
CUBE = np.arange(64, dtype=np.float32).reshape(4, 4, 4)

# Operations that return arrays, by name. They get a Scene of a library.
RESULTS = {
    "triangle normals": lambda s: s.mesh.compute_triangle_normals(),
    "geodesic distances": lambda s: s.mesh.compute_geodesic_distances(s.make(np.array([0, 3]))),
    "tetrahedra": lambda s: loom.TriangleMesh.create_from_point_cloud_alpha_shape(s.cloud, 0.5, return_tetrahedra=True)[
        1:
    ],
    "occupancy states": lambda s: s.grid.states(s.points),
    "occupancy states of a cloud": lambda s: s.grid.states(s.cloud),
    "occupied": lambda s: s.grid.occupied(s.points),
    "occupancy probabilities": lambda s: s.grid.probabilities(s.points),
    "log odds": lambda s: s.grid.log_odds(s.points),
    "occupancy rays": lambda s: s.grid.cast_rays(s.make(np.float32([0.5, 0.5, 2])), s.points, 3.0),
    "voxel indices": lambda s: s.grid.voxel_indices(),
    "occupancy array": lambda s: s.grid.to_array(),
    "occupied voxels as a cloud": lambda s: s.grid.to_point_cloud().compute_nearest_neighbor_distance(),
    "a copied grid": lambda s: s.grid.copy().voxel_indices(),
    "occupied voxels": lambda s: s.field.occupied_voxels,
    "field array": lambda s: [s.field.to_array(values=v) for v in ("distances", "squared", "nearest", "known")],
    "field slice": lambda s: (lambda f: (f.distances, f.is_known))(s.field.slice("z", 0.1)),
    "field distances": lambda s: s.field.distances(s.points),
    "nearest obstacles": lambda s: s.field.nearest_obstacles(s.points),
    "collisions": lambda s: s.field.collides(s.points, s.make(np.full(50, 0.1, np.float32))),
    "collisions of bodies": lambda s: s.field.collides_bodies(s.make(np.float32([[0, 0, 0, 0.1]])), np.eye(4)[None]),
    "field of a grid": lambda s: loom.DistanceField.from_occupancy_grid(s.grid, 0.5).occupied_voxels,
    "field of an array": lambda s: loom.DistanceField.from_array(
        s.make((CUBE > 50).astype(np.uint8)), device=s.device
    ).to_array(),
    "field of voxels": lambda s: loom.DistanceField.from_voxels(
        s.make(np.array([[0, 0, 0], [2, 0, 1]])), 1.0, 2.0, device=s.device
    ).to_array(),
    "covariances of splats": lambda s: s.splats.covariances(),
    "image of splats": lambda s: s.splats.rasterize(LENS.undistorted(), translated(0, 0, 2)),
    "selected splats": lambda s: s.splats.select_by_mask(s.make(ODD[:20])).covariances(),
    "splats as a cloud": lambda s: s.splats.to_point_cloud().compute_nearest_neighbor_distance(),
    "projected points": lambda s: LENS.project(s.points),
    "rays of pixels": lambda s: LENS.unproject(s.make(np.float32([[10, 20], [30, 5]]))),
    "faces of a panorama": lambda s: panorama_on(s.device).apply(s.make(RAINBOW)),
    "faces of a gray panorama": lambda s: panorama_on(s.device).apply(s.make(RAINBOW[:, :, 0])),
    "points in voxels": lambda s: VOXELS.check_if_included(s.points),
    "control grid": lambda s: (s.control.get_init_positions(), s.control.get_curr_positions()),
    "moved control grid": lambda s: moved_anchors(s.control, s.make),
    "change of clouds": lambda s: (lambda c: (*fields_of(c), c.is_significant))(
        loom.m3c2(s.cloud, s.cloud.translate([0, 0, 0.02]), normal_radii=0.2, cylinder_radius=0.2, max_distance=1)
    ),
    "change from a mesh": lambda s: (lambda c: (*fields_of(c), c.is_significant))(
        loom.meshing.compare_cloud_to_mesh(s.cloud, s.mesh, radius=0.2)
    ),
    "rays through a scene of arrays": lambda s: scene_of(s).cast_rays(s.make(RAYS))["t_hit"],
    "isosurfaces": lambda s: loom.TriangleMesh.create_isosurfaces(
        s.make(CUBE), [20.0], s.device
    ).compute_triangle_areas(),
    "deskewed scan": lambda s: loom.registration.deskew_point_cloud(
        s.cloud, translated(0.1, 0, 0), s.make(np.linspace(0, 0.1, 400))
    ).compute_nearest_neighbor_distance(),
    "weighted pairs": lambda s: (
        loom.registration.registration_icp(
            s.cloud, s.cloud.translate([0.01, 0, 0]), 0.1, weights=s.make(WEIGHTS)
        ).correspondence_set
    ),
}

# Operations with array arguments whose results are objects or numbers: they return NumPy arrays for the comparison.
ARGUMENTS = {
    "vertices at a level": lambda s: s.mesh.trim(s.make(np.arange(26) % 7 / np.float32(7)), 0.3).vertices,
    "deformed mesh": lambda s: (
        s.mesh.deform_as_rigid_as_possible(
            s.make(np.array([0, 1])), s.make(np.float32([[0, 0, 1.2], [0, 0, -1]])), 2
        ).vertices
    ),
    "texture coordinates": lambda s: assigned(s.mesh, "triangle_uvs", s.make(np.ones((144, 2), np.float32))),
    "material numbers": lambda s: assigned(s.mesh, "triangle_material_ids", s.make(np.arange(48, dtype=np.int32))),
    "triangle normals": lambda s: assigned(s.mesh, "triangle_normals", s.mesh.compute_triangle_normals()),
    "points of a volume": lambda s: fused(s.points, s.make(np.float32([0, 0, 2])), s.device),
    "points of a volume in float64": lambda s: fused(s.make(s.surface.astype(np.float64)), [0, 0, 2], s.device),
    "a box": lambda s: loom.AxisAlignedBoundingBox.create_from_points(s.points).max_bound,
    "an oriented box": lambda s: loom.OrientedBoundingBox.create_from_points(s.points).extent,
    "a minimal box": lambda s: loom.OrientedBoundingBox.create_from_points_minimal(s.points).extent,
    "a view": lambda s: loom.View.fit(s.points).T_world_camera,
    "lines": lambda s: loom.LineSet(s.points, s.make(np.array([[0, 1], [1, 2]]))).points,
    "lines of pairs": lambda s: (
        loom.LineSet.create_from_point_cloud_correspondences(
            s.cloud, s.cloud, s.make(np.array([[0, 1], [1, 2]]))
        ).points
    ),
    "errors of depth": lambda s: np.array(evaluate_depth(s.make(CUBE[0] + 1), s.make(CUBE[1] + 1)).rmse),
    "a weighted plane": lambda s: loom.fit_shape(s.cloud, "plane", weights=s.make(WEIGHTS)).axis,
    "isosurfaces": lambda s: loom.TriangleMesh.create_isosurfaces(s.make(CUBE), [20.0], s.device).vertices,
    "painted change": lambda s: loom.paint_change(s.cloud, s.make(WEIGHTS)).colors,
    "text of a change": lambda s: np.array(repr(loom.meshing.compare_cloud_to_mesh(s.cloud, s.mesh)).split()),
}

RAINBOW = (np.arange(32 * 64 * 3) * 7 % 251).astype(np.uint8).reshape(32, 64, 3)
RAYS = np.column_stack([np.linspace(-1, 1, 9), np.zeros(9), np.full(9, 3), np.tile([0, 0, -1], (9, 1))]).astype("f4")


def translated(*shift):
    T = np.eye(4)
    T[:3, 3] = shift
    return T


def panorama_on(device):
    return Panorama(64, 32, device=device)


def moved_anchors(control, make):
    control.set_positions(make(1.5 * loom.asnumpy(control.get_init_positions())))
    return control.get_curr_positions()


def fields_of(result):
    return [getattr(result, field.name) for field in dataclasses.fields(result)]


def scene_of(s):
    scene = loom.RaycastingScene(s.device)
    ball = loom.TriangleMesh.create_sphere(1.0, 4)
    scene.add_triangles(s.make(ball.vertices.astype(np.float32)), s.make(ball.triangles))
    return scene


def assigned(mesh, name, values):
    changed = mesh.copy()
    setattr(changed, name, values)
    return getattr(changed, name)


def fused(points, origin, device):
    volume = loom.TSDFVolume(voxel_size=0.2, color=False, device=device)
    volume.integrate_points(points, origin)
    return volume.extract_triangle_mesh(0.0).vertices


def arrays_in(result):
    """The arrays of a result: itself, or those of a tuple or a dataclass."""
    if dataclasses.is_dataclass(result):
        result = fields_of(result)
    return list(result) if isinstance(result, tuple | list) else [result]


@pytest.fixture
def scenes(library, device, surface):
    return Scene(library.make, device, surface), Scene(lambda values: values, device, surface)


@pytest.mark.parametrize("name", RESULTS)
def test_every_result_is_an_array_of_the_library_on_its_device(library, device, scenes, name):
    theirs, ours = (arrays_in(RESULTS[name](scene)) for scene in scenes)
    assert len(theirs) == len(ours) > 0
    for result, expected in zip(theirs, ours, strict=True):
        assert_same(library, result, expected)
        if library.name in ("warp", "cupy"):
            assert str(getattr(result, "memory", result).device) == device


@pytest.mark.parametrize("name", ARGUMENTS)
def test_arguments_may_be_arrays_on_the_device(scenes, name):
    theirs, ours = (ARGUMENTS[name](scene) for scene in scenes)
    np.testing.assert_array_equal(theirs, ours, strict=True)


@pytest.mark.parametrize(
    ("origin", "direction", "message"),
    [
        ([0, 0, 2], [0, np.nan, 0], "directions: expected finite"),
        ([0, 0, 2], [0, 0, 0], "directions: expected nonzero"),
        ([0, 0, 1e9], [0, 0, 1], "origins, max_range: rays extend"),
        ([[0, 0, 1], [0, 0, 1]], [0, 0, 1], r"origins: expected shape \[3\], or \[1, 3\]"),
    ],
)
def test_invalid_rays_are_rejected_in_every_library(library, scenes, origin, direction, message):
    with pytest.raises(ValueError, match=message):
        scenes[0].grid.cast_rays(library.make(np.float32(origin)), library.make(np.float32([direction])), 3.0)


def test_pickled_grids_and_fields_keep_the_library(library, scenes):
    grid, field = (pickle.loads(pickle.dumps(each)) for each in (scenes[0].grid, scenes[0].field))
    assert grid.array_library == field.array_library == library.name
    assert package(grid.voxel_indices()) == package(field.occupied_voxels) == library.name


def test_asnumpy_converts_arrays_of_every_library(library, rng):
    for values in (
        rng.random((5, 3)),
        rng.random((4, 3, 2)).astype(np.float32),
        np.arange(6, dtype=np.int16),
        np.array([True, False]),
        np.zeros((0, 3), np.uint8),
    ):
        if library.name != "jax":  # of 32 bits
            np.testing.assert_array_equal(loom.asnumpy(library.make(values)), values, strict=True)
    rows = library.make(rng.random((6, 3)).astype(np.float32))
    np.testing.assert_array_equal(loom.asnumpy(rows[1:4]), library.host(rows)[1:4], strict=True)
    if library.name == "warp":
        np.testing.assert_array_equal(loom.asnumpy(rows[:, 1]), library.host(rows)[:, 1], strict=True)  # strides


def test_asnumpy_returns_numpy_arrays_and_lists_and_rejects_others(library, clouds):
    values = np.arange(3)
    assert loom.asnumpy(values) is values
    assert loom.asnumpy([[1, 2]]).shape == (1, 2) and loom.asnumpy(3.5).shape == ()
    for wrong in (clouds[0], loom.TriangleMesh(), "a", {"a": 1}, [object()], None):
        with pytest.raises(TypeError, match="array: expected"):
            loom.asnumpy(wrong)


def saved(path, read=None):
    """The path of a cloud that is written if it does not exist, or what another library reads from it."""
    if not path.exists():
        loom.write_point_cloud(path, loom.PointCloud(np.eye(3)))
    return path if read is None else read(str(path))


# Constructors and readers of clouds and meshes. They get the keywords `device` and `arrays`, and a folder with files.
MADE = {
    "cloud": lambda f, **k: loom.PointCloud(np.eye(3), **k),
    "depth": lambda f, **k: loom.PointCloud.create_from_depth_image(CUBE[0] + 1, PINHOLE, **k),
    "mesh": lambda f, **k: loom.TriangleMesh(np.eye(3), [[0, 1, 2]], **k),
    "isosurfaces": lambda f, **k: loom.TriangleMesh.create_isosurfaces(CUBE, [20.0], **k),
    "marching cubes": lambda f, **k: loom.meshing.marching_cubes(CUBE, 20.0, **k),
    "splats": lambda f, **k: loom.GaussianSplats(np.eye(3), np.ones((3, 3)), np.eye(4)[:3], [0.5] * 3, np.eye(3), **k),
    "cloud of a file": lambda f, **k: loom.read_point_cloud(f / "cloud.ply", **k),
    "scan of a file": lambda f, **k: loom.read_point_cloud(f / "scan.ptx", scan=0, **k),
    "stations": lambda f, **k: loom.read_stations(f / "scan.ptx", **k).clouds[0],
    "mesh of a file": lambda f, **k: loom.read_triangle_mesh(f / "mesh.ply", **k),
    "splats of a file": lambda f, **k: loom.read_splats(f / "splats.ply", **k),
    "chunk of a file": lambda f, **k: next(iter(loom.read_e57_chunks(saved(f / "cloud.e57"), **k))),
    "COPC file": lambda f, **k: loom.read_copc(saved(f / "cloud.copc.laz"), **k),
    "mesh of trimesh": lambda f, **k: loom.from_any(
        pytest.importorskip("trimesh").Trimesh(np.eye(3), [[0, 1, 2]]), **k
    ),
    "sparse points": lambda f, **k: ring_model().point_cloud(**k),
    "cloud of Open3D": lambda f, **k: loom.PointCloud.from_open3d(
        saved(f / "cloud.ply", pytest.importorskip("open3d").io.read_point_cloud), **k
    ),
    "mesh of Open3D": lambda f, **k: loom.TriangleMesh.from_open3d(
        saved(f / "mesh.ply", pytest.importorskip("open3d").io.read_triangle_mesh), **k
    ),
    "shape": lambda f, device, **k: loom.TriangleMesh.create_box().to(device, **k),
}  # fmt: skip
PINHOLE = loom.PinholeCameraIntrinsic(4, 4, 4.0, 4.0, 1.5, 1.5)
PTX = "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n4 5 6 0.5\n"


@pytest.fixture
def files(tmp_path):
    loom.write_point_cloud(tmp_path / "cloud.ply", loom.PointCloud(np.eye(3)))
    loom.write_triangle_mesh(tmp_path / "mesh.ply", loom.TriangleMesh(np.eye(3), [[0, 1, 2]]))
    loom.write_splats(tmp_path / "splats.ply", MADE["splats"](None))
    (tmp_path / "scan.ptx").write_text(PTX)
    return tmp_path


@pytest.mark.parametrize("name", MADE)
def test_constructors_and_readers_choose_the_library(library, device, files, name):
    made = MADE[name](files, device=device, arrays=library.name)
    made = getattr(made, "cloud", made)  # of splats
    assert made.array_library == library.name and str(made.device) == device
    is_cloud = isinstance(made, loom.PointCloud)
    result = made.compute_nearest_neighbor_distance() if is_cloud else made.compute_triangle_areas()
    assert package(result) == library.name
    default = MADE[name](files, device=device)
    assert getattr(default, "cloud", default).array_library == "numpy"
    with pytest.raises(ValueError, match=r"arrays: expected one of numpy, .*got 'numpi'"):
        MADE[name](files, device=device, arrays="numpi")


def test_arrays_overrides_the_library_of_the_input(library, surface):
    points = library.make(surface)
    cloud = loom.PointCloud(points, arrays="numpy")
    assert package(cloud.compute_nearest_neighbor_distance()) == "numpy"
    assert cloud.arrays["points"].ptr == library.address(points)


@pytest.mark.slow
@pytest.mark.parametrize("library", ["torch", "jax", "cupy"])
def test_no_library_is_imported_that_was_not_given(library):
    code = f"""
import sys, numpy as np, pointloom as loom
loom.PointCloud(np.zeros((3, 3))).cluster_dbscan(1.0, 1)
assert {library!r} not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)
