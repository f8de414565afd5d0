"""Arrays of other libraries on a GPU: no copy through the host, and streams that wait for each other by events."""

import contextlib
import pickle
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.cameras.panoramas import Panorama

from ..array_library import installed, ndarray
from .test_callers_streams import Speaker, move_kernel
from .test_captures import add_kernel

DEVICE = "cuda:0"
COUNT = 2000


@pytest.fixture
def library(emulated, monkeypatch):
    return installed(DEVICE, monkeypatch)


@pytest.fixture
def surface(rng):
    x, y = rng.random((2, COUNT))
    return np.column_stack([x, y, 0.2 * np.sin(6 * x) * np.cos(5 * y)]).astype(np.float32)


@pytest.fixture
def traffic(emulated, monkeypatch):
    """A context that notes the bytes of each copy to and from the host, and the waits for the whole device."""

    @contextlib.contextmanager
    def watched():
        sizes = {"wp_memcpy_d2h": [], "wp_memcpy_h2d": [], "wp_cuda_context_synchronize": []}
        with monkeypatch.context() as patch:

            def watch(library, name, size, noted):
                through = getattr(library, name)

                def call(*arguments):
                    sizes[noted].append(size(arguments))
                    return through(*arguments)

                patch.setattr(library, name, call, raising=False)

            core, waits = wp._src.context.runtime.core, "wp_cuda_context_synchronize"
            for name in ("wp_memcpy_d2h", "wp_memcpy_h2d"):
                watch(core, name, lambda arguments: arguments[3], name)
            watch(core, waits, lambda _: 0, waits)
            watch(emulated.driver, "cuCtxSynchronize", lambda _: 0, waits)
            yield sizes

    return watched


OPERATIONS = {
    "make": lambda c, e: loom.PointCloud(e.points, normals=e.points, label=e.rows),
    "dbscan": lambda c, e: c.cluster_dbscan(0.05, 4),
    "nearest": lambda c, e: c.compute_nearest_neighbor_distance(),
    "distance": lambda c, e: c.compute_point_cloud_distance(c),
    "mahalanobis": lambda c, e: c.compute_mahalanobis_distance(),
    "outliers": lambda c, e: c.remove_radius_outlier(4, 0.1)[1],
    "plane": lambda c, e: c.segment_plane(0.05)[1],
    "features": lambda c, e: loom.compute_fpfh_feature(c, max_nn=20),
    "pairs": lambda c, e: loom.registration.correspondences_from_features(e.features, e.features, True),
    "registered": lambda c, e: loom.registration.evaluate_registration(c, c, 0.02).correspondence_set,
    "ransac": lambda c, e: loom.registration.registration_ransac_based_on_correspondence(
        c, c, loom.registration.correspondences_from_features(e.features, e.features, True), 0.05, num_iterations=200
    ),
    "knn": lambda c, e: e.search.knn_search(e.points, 5),
    "radius": lambda c, e: e.search.radius_search(e.points, 0.05),
    "indices": lambda c, e: c.select_by_index(e.rows),
    "mask": lambda c, e: c.select_by_mask(e.mask),
    "box": lambda c, e: loom.AxisAlignedBoundingBox([0] * 3, [0.5] * 3).get_point_indices_within_bounding_box(c),
    "rays": lambda c, e: e.scene.cast_rays(e.rays),
    "closest": lambda c, e: e.scene.compute_closest_points(e.points),
    "inside": lambda c, e: e.scene.compute_occupancy(e.points),
    "depth": lambda c, e: loom.PointCloud.create_from_depth_image(e.depth, e.camera),
    "images": lambda c, e: loom.RGBDImage(e.color, e.depth),
    "frame": lambda c, e: loom.TSDFVolume(voxel_size=0.1, device=DEVICE).integrate(
        e.depth, e.camera, np.eye(4), color=e.color
    ),
    "seen": lambda c, e: e.volume.ray_cast(e.camera, np.eye(4), weight_threshold=0),
    "faces": lambda c, e: e.mesh.compute_triangle_normals(),
    "scan": lambda c, e: e.grid.copy().insert_scan(e.points, origin=[0.5, 0.5, 2]),
    "states": lambda c, e: e.grid.states(e.points),
    "occupied": lambda c, e: e.grid.occupied(e.points),
    "odds": lambda c, e: e.grid.log_odds(c),
    "views": lambda c, e: e.grid.cast_rays(e.points, e.points, 3.0).distances,
    "field": lambda c, e: e.field.to_array(),
    "voxels": lambda c, e: e.field.occupied_voxels,
    "panorama": lambda c, e: e.panorama.apply(e.sphere),
    "level": lambda c, e: loom.TriangleMesh.create_isosurfaces(e.samples, [0.5]),
    "points": lambda c, e: loom.TSDFVolume(voxel_size=0.1, color=False, device=DEVICE).integrate_points(
        e.points, [0.5, 0.5, 2]
    ),
}
RETAINED = {"pairs": 2 * 512 * 33 * 4, "ransac": 2 * 512 * 33 * 4}  # samples by which two trees choose their axes


@pytest.fixture
def everything(library, surface, rng):
    """What the operations are given, all of it on the device."""
    camera = loom.PinholeCameraIntrinsic(80, 60, 60.0, 60.0, 39.5, 29.5)
    points, scene = library.asarray(surface), loom.RaycastingScene(DEVICE)
    scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    cloud = loom.PointCloud(points).estimate_normals(max_nn=12)
    depth = library.asarray(rng.integers(900, 1100, (60, 80)).astype(np.uint16))
    color = library.asarray(rng.integers(0, 256, (60, 80, 3)).astype(np.uint8))
    volume = loom.TSDFVolume(voxel_size=0.1, device=DEVICE)
    volume.integrate(depth, camera, np.eye(4), color=color)
    grid = loom.OccupancyGrid(0.1, device=DEVICE)
    grid.insert_scan(points, origin=[0.5, 0.5, 2])
    return SimpleNamespace(
        points=points, rows=library.asarray(rng.permutation(COUNT).astype(np.int32)), cloud=cloud, camera=camera,
        mask=library.asarray(np.arange(COUNT) % 2 == 0), features=loom.compute_fpfh_feature(cloud, max_nn=20),
        search=loom.NearestNeighborSearch(cloud), scene=scene, volume=volume, depth=depth, color=color,
        rays=library.asarray(np.hstack([surface, -np.ones_like(surface)])), panorama=Panorama(128, 64, device=DEVICE),
        mesh=loom.TriangleMesh(points, library.asarray(np.arange(COUNT - 2)[:, None] + np.arange(3))), grid=grid,
        field=loom.DistanceField.from_point_cloud(cloud, 0.1, 0.3), samples=library.asarray(rng.random((12, 13, 14))),
        sphere=library.asarray(rng.integers(0, 256, (64, 128, 3)).astype(np.uint8)),
    )  # fmt: skip


@pytest.mark.parametrize("name", ["dbscan", "nearest", "distance", "outliers", "features", "registered"])
def test_frozen_points_wait_no_more_than_points_of_the_cloud(everything, emulated, name):
    waits = {}
    for title, options in (("shared", {}), ("frozen", {"frozen": True}), ("own", None)):
        normals = everything.cloud.arrays["normals"]
        points = everything.points if options is not None else np.asarray(everything.cloud.points)
        cloud = loom.PointCloud(points, normals=normals, device=DEVICE, **(options or {})).to(DEVICE, arrays="cupy")
        for _ in range(2):
            OPERATIONS[name](cloud, everything)
        waits[title] = emulated.count_requests(lambda cloud=cloud: OPERATIONS[name](cloud, everything))["waits"]
    assert waits["frozen"] == waits["own"] < waits["shared"]


@pytest.mark.parametrize("name", OPERATIONS)
def test_no_array_goes_through_the_host(everything, traffic, name):
    OPERATIONS[name](everything.cloud, everything)  # what is kept after a first call
    with traffic() as sizes:
        result = OPERATIONS[name](everything.cloud, everything)
    arrays = list(result.values()) if isinstance(result, dict) else result if isinstance(result, tuple) else [result]
    for array in arrays:
        if isinstance(array, ndarray):
            assert array.memory.device.is_cuda
        else:
            assert not isinstance(array, np.ndarray)
    largest = max([0, *sizes["wp_memcpy_d2h"], *sizes["wp_memcpy_h2d"]])
    assert largest < max(2 * COUNT, RETAINED.get(name, 0) + 1), sizes  # bytes: less than any array of a number a point
    assert not sizes["wp_cuda_context_synchronize"]


def test_a_rendered_surface_is_copied_by_the_arrays_that_are_read(everything, traffic):
    depth, color = np.full((60, 80), 1000, np.uint16), np.full((60, 80, 3), 200, np.uint8)
    volume = loom.TSDFVolume(voxel_size=0.1, device=DEVICE)
    volume.integrate(depth, everything.camera, np.eye(4), color=color)
    with traffic() as sizes:
        view = volume.ray_cast(everything.camera, np.eye(4), weight_threshold=0)
        before = sum(sizes["wp_memcpy_d2h"])
        assert view.depth is view.depth and view.depth.any()
        assert before < 1000 and sum(sizes["wp_memcpy_d2h"]) == before + view.depth.nbytes
    again = pickle.loads(pickle.dumps(view))
    for name in ("depth", "points", "normals", "colors"):
        np.testing.assert_array_equal(getattr(again, name), getattr(view, name))


def test_pending_writes_on_the_callers_stream_are_awaited(library, surface):
    points = library.asarray(surface)
    wp.launch(move_kernel, COUNT, [points.memory, 1.0], stream=library.stream)  # not run yet
    cloud = loom.PointCloud(points)
    current_stream = wp.get_stream(DEVICE).cuda_stream
    assert library.requested_streams == [current_stream]
    np.testing.assert_array_equal(cloud.points[:, 0], (surface[:, 0] + np.float32(1)).astype(np.float64))


def test_a_result_is_ready_on_the_takers_stream(library, surface):
    expected = loom.PointCloud(surface).cluster_dbscan(0.05, 4)
    labels = loom.PointCloud(library.asarray(surface)).cluster_dbscan(0.05, 4)
    wp.launch(add_kernel, COUNT, [labels.memory, 7], stream=library.stream)
    host = wp.empty(COUNT, dtype=wp.int32, device="cpu", pinned=True)
    wp.copy(host, labels.memory, stream=library.stream)
    wp.synchronize_stream(library.stream)  # and no other
    np.testing.assert_array_equal(host.numpy(), expected + 7)


def test_work_runs_on_the_callers_stream(library, surface):
    chosen = wp.Stream(DEVICE)
    with wp.ScopedStream(chosen):
        labels = loom.PointCloud(library.asarray(surface)).cluster_dbscan(0.05, 4)
        neighbors = loom.NearestNeighborSearch(surface, device=DEVICE).knn_search(library.asarray(surface), 3)
        assert library.requested_streams == [chosen.cuda_stream] * 2
    np.testing.assert_array_equal(labels.get(), loom.PointCloud(surface).cluster_dbscan(0.05, 4))
    expected = loom.NearestNeighborSearch(surface).knn_search(surface, 3).indices
    np.testing.assert_array_equal(neighbors.indices.get(), expected)


def test_the_stream_of_the_cuda_array_interface_is_waited_for(library, surface, traffic):
    memory = library.asarray(surface).memory
    wp.launch(move_kernel, COUNT, [memory, 2.0], stream=library.stream)
    with traffic() as sizes:
        cloud = loom.PointCloud(Speaker(memory, library.stream.cuda_stream))
    assert cloud.arrays["points"].ptr == memory.ptr
    assert not sizes["wp_cuda_context_synchronize"]
    np.testing.assert_array_equal(cloud.points[:, 0], (surface[:, 0] + np.float32(2)).astype(np.float64))


def test_torch_receives_the_stream_that_reads_its_tensor(library, surface, monkeypatch):
    torch = ModuleType("torch")
    torch.cuda = SimpleNamespace(ExternalStream=lambda stream, device: (stream, device))
    monkeypatch.setitem(sys.modules, "torch", torch)
    noted = []

    class Tensor(ndarray):
        def record_stream(self, stream):
            noted.append(stream)

    Tensor.__module__ = "torch"
    loom.PointCloud(Tensor(library.asarray(surface).memory, library))
    assert noted == [(wp.get_stream(DEVICE).cuda_stream, DEVICE)]


def test_strided_arrays_are_made_contiguous_on_the_device(library, surface, traffic):
    padded = library.asarray(np.hstack([surface, surface]))
    with traffic() as sizes:
        part = loom.PointCloud(ndarray(padded.memory[::2, :3], library))
        transposed = loom.PointCloud(ndarray(library.asarray(surface.T).memory.transpose(), library))
        same = loom.PointCloud(ndarray(wp.array(ptr=padded.memory.ptr, dtype=float, shape=(50, 3), strides=(0, 4),
                                                device=DEVICE), library))  # fmt: skip
    assert max(sizes["wp_memcpy_d2h"]) < 2 * COUNT
    np.testing.assert_array_equal(part.points, surface[::2].astype(np.float64))
    np.testing.assert_array_equal(transposed.points, surface.astype(np.float64))
    np.testing.assert_array_equal(same.points, np.tile(surface[:1], (50, 1)).astype(np.float64))


@pytest.mark.parametrize(
    ("call", "error", "reason"),
    [
        (lambda c, a: c.select_by_index(a(np.arange(3))), loom.DeviceError, r"indices: operands on cuda:0 and cpu"),
        (lambda c, a: c.select_by_mask(a(np.ones(4, bool))), loom.DeviceError, r"mask: operands on cuda:0 and cpu"),
        (lambda c, a: setattr(c, "normals", a(np.ones((4, 3)))), loom.DeviceError, r"normals: .* move one with .to\("),
        (lambda c, a: c.__setitem__("label", a(np.ones(4))), loom.DeviceError, "label: operands on"),
        (lambda c, a: loom.NearestNeighborSearch(c).knn_search(a(np.ones((4, 3))), 1), loom.DeviceError, "queries: "),
        (lambda c, a: loom.RaycastingScene().cast_rays(a(np.ones((4, 6)))), loom.DeviceError, "rays: operands on"),
        (lambda c, a: loom.RGBDImage(a(np.ones((4, 6, 3), np.uint8)), np.ones((4, 6))), loom.DeviceError, "color: "),
        (lambda c, a: c.transform(a(np.eye(4))), TypeError, "transformation: expected an array on the host"),
        (lambda c, a: loom.PointCloud(a(np.ones((4, 2)))), ValueError, r"points: expected shape \[n, 3\]"),
        (lambda c, a: loom.PointCloud(a(np.ones(3))), ValueError, r"points: expected shape \[n, 3\]"),
        (lambda c, a: loom.PointCloud(a(np.ones((4, 3))), label=a(np.ones(5))), ValueError, "label: expected shape"),
        (lambda c, a: loom.PointCloud(a(np.full((2, 3), [[1e300], [-1e300]]))), ValueError, "points: .*beyond the fl"),
    ],
)
def test_unsupported_arrays_are_refused_by_name(library, call, error, reason):
    with pytest.raises(error, match=reason):
        call(loom.PointCloud(np.zeros((4, 3))), library.asarray)
