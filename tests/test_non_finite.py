"""NaN or infinity in one element of an input: an error that names the argument, or the result of the other elements.

Each input of each operation gets one more element at its end, of which one number is not finite. The result of the
other elements must be the one without that element, or, where the operation does not read the number, the one with a
finite element there. No solver may report a better result. Operations on one cloud are in test_operations.py.
"""

from __future__ import annotations

import re
import warnings
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from .test_translation import CASES, things

COUNT = 750
ARGUMENT = re.compile(r"[\w.\[\], ]+: ")
POSITION = np.array([1.53, 1.22, 0.01])  # of the element that is added

# More operations, by inputs that test_translation.py has none of.
MORE = """
0 made(points, weight=weight).voxel_down_sample(0.25)["weight"]
1e-4 made(points, covariances=covariances).voxel_down_sample(0.25)["covariances"]
1e-5 made(points, normals=normals).smooth_taubin(2).points
0 made(points, normals=normals).segment_shape("cylinder", 0.02, seed=1)[1]
0 loom.detect_shapes(made(points, normals=normals), 0.02).labels
1e-3 loom.meshing.create_surface(made(points, normals=normals)).mesh.get_surface_area()
1e-3 reg.registration_icp(other, made(points, covariances=covariances), 0.2, start, reg.TransformationEstimationForGeneralizedICP())
1e-3 reg.registration_icp(made(points, covariances=covariances), other, 0.2, near, reg.TransformationEstimationForGeneralizedICP())
1e-3 reg.registration_icp(made(points, normals=normals, dopplers=dopplers, directions=normals), cloud, 0.2, near, reg.TransformationEstimationForDopplerICP())
1e-3 reg.registration_icp(other, cloud, 0.2, near, reg.TransformationEstimationPointToPlane(), constraint=reg.Constraint(prior=reg.Prior(near, information)))
1e-3 reg.registration_ransac_based_on_correspondence(other, made(points), reg.correspondences_from_features(features[0], descriptors, True), 0.15, seed=1)
1e-3 reg.registration_fgr_based_on_correspondence(other, made(points), reg.correspondences_from_features(features[0], descriptors, True, 0.0))
0 reg.correspondences_from_features(features[0], descriptors)
1e-6 reg.get_information_matrix_from_point_clouds(made(points), other, 0.1, near)
1e-6 reg.deskew_point_cloud(made(points), start, times).points
1e-4 reg.register_stations([other, made(points, normals=normals)]).poses
0 reg.register_stations([other, cloud], poses=poses).poses
0 reg.evaluate_trajectory(loom.Trajectory(poses, stamps), loom.Trajectory(poses, stamps)).absolute_translation.rmse
0 reg.global_optimization(reg.PoseGraph([reg.PoseGraphNode(T) for T in poses], [reg.PoseGraphEdge(0, 1, near, information)])).nodes[1].pose
1e-5 drive(made(points, times=times))
1e-6 loom.meshing.compare_cloud_to_mesh(made(points), mesh).distances
1e-6 loom.meshing.compare_cloud_to_mesh(cloud, loom.TriangleMesh(vertices, mesh.triangles)).distances
1e-6 loom.rasterize(made(points), 0.5, "dsm").values
0 loom.NearestNeighborSearch(cloud).hybrid_search(queries, 0.3, 5)[0]
0 scene.compute_signed_distance(queries)
0 scene.compute_distance(queries)
0 scene.compute_occupancy(queries)
0 scene.compute_closest_points(queries)["points"]
0 loom.RaycastingScene(mesh.device).add_triangles(mesh, pose=near)
0 fused("integrate_points", points, direction)
0 fused("integrate", depth, camera, near)
0 mapped(points, direction).to_point_cloud().points
0 mapped(cloud.points, direction).probabilities(queries)
0 mapped(cloud.points, direction).states(queries)
0 loom.DistanceField.from_point_cloud(made(points), 0.1, 1.0).distances(queries)
0 loom.DistanceField.from_point_cloud(cloud, 0.1, 1.0).gradients(queries)
0 loom.DistanceField.from_point_cloud(cloud, 0.1, 1.0).collides(queries, radii)
0 loom.DistanceField.from_point_cloud(cloud, 0.1, 1.0).collides_bodies([[0, 0, 0, 0.1]], poses)[0]
0 loom.VoxelGrid.check_if_included(mesh.voxelize(0.25), queries)
0 loom.GaussianSplats(queries, scales, np.ones((len(scales), 4)), np.full(len(scales), 0.5), np.zeros((len(scales), 1, 3))).rasterize(camera, view).color
0 loom.SelectionPolygonVolume(outline, "Z", 0, 2).crop_in_polygon(points)
0 loom.TriangleMesh.from_polygon(outline[:, :2]).vertices
0 loom.TriangleMesh.revolve(outline[:2, 1:] + 1).vertices
0 mesh.clip_plane([0, 0, 0], direction).vertices
0 mesh.trim(values, 0.5).vertices
1e-5 loom.rgbd.compute_rgbd_odometry(rgbd(depth), rgbd(np.full_like(depth, 2.01)), camera, near).transformation
0 loom.filter_depth_bilateral(depth)
0 loom.erode_depth_edges(depth)
0 loom.fill_depth_holes(depth, 1, 1e-6)[0]
0 loom.meshing.fuse_volumes([volume, volume], poses).extract_point_cloud(weight_threshold=0).points
0 loom.AxisAlignedBoundingBox.create_from_points(points).max_bound
1e-6 loom.OrientedBoundingBox.create_from_points_minimal(points).extent
0 loom.TriangleMesh(vertices, mesh.triangles).remove_duplicated_vertices().vertices
0 loom.TriangleMesh(vertices, mesh.triangles).fill_holes().triangles
1e-6 mesh.compute_error_map(loom.TriangleMesh(vertices, mesh.triangles))[1]
0 loom.meshing.clean_mesh(loom.TriangleMesh(vertices, mesh.triangles)).mesh.triangles
0 loom.meshing.orthophoto(loom.TriangleMesh(vertices, mesh.triangles), 0.25).heights.values
0 loom.render(made(points), size=(64, 48))
"""  # noqa: E501

# Where a number that is not finite has other effects: the reason, and the claim about (the result, that without it).
EXCEPTIONS = {
    "mesh.subdivide_loop corner": ("a new vertex is a mean of those around it", lambda actual, _: few_rows(actual, 6)),
    "mesh.subdivide_midpoint corner": ("a new vertex is the middle of an edge", lambda actual, _: few_rows(actual, 3)),
    "mesh.extrude_linear corner": ("each vertex is copied", lambda actual, _: few_rows(actual, 2)),
    "mesh.compute_vertex_curvature corner": ("it depends on the triangles", lambda actual, _: few_rows(actual, 3)),
    "loom.TriangleMesh.concatenate corner": (
        "triangles of the second mesh have other numbers",
        lambda actual, without: np.array_equal(actual - (actual > 768), without),
    ),
}
TOLERANCES = {"registration": 1e-3}  # a neighbor without a normal takes a place


def few_rows(actual: np.ndarray, count: int) -> bool:
    """True if no more rows of a result than these are not finite."""
    return int((~np.isfinite(actual).reshape(len(actual), -1).all(axis=1)).sum()) <= count


def grown_cloud(cloud: loom.PointCloud, changes: dict[str, np.ndarray]) -> loom.PointCloud:
    """The cloud with one more point."""
    rows = {"points": POSITION, "normals": np.array([0, 0, 1.0]), "colors": np.full(3, 0.5)} | changes
    arrays = {n: np.vstack([getattr(cloud, n), row]) for n, row in rows.items() if n == "points" or n in cloud}
    return loom.PointCloud(arrays.pop("points"), device=cloud.device, **arrays)


def grown_mesh(mesh: loom.TriangleMesh, x: float, is_used: bool) -> loom.TriangleMesh:
    """The mesh with one more vertex, which a triangle uses or none."""
    triangles = np.vstack([mesh.triangles, [[0, 1, len(mesh.vertices)]]])[: len(mesh.triangles) + is_used]
    return loom.TriangleMesh(np.vstack([mesh.vertices, [x, 0.1, 0.2]]), triangles, device=mesh.device)


def with_value(values: Any, value: float) -> np.ndarray:
    """The array with another number at its end; a matrix of a pose with another translation."""
    values = np.array(values, np.float64)
    end = (-1, 0, 3) if values.shape[1:] == (4, 4) else (-1,) * values.ndim
    values[(0, 3) if values.shape == (4, 4) else end] = value
    return values


def grown(values: Any, value: float | None = None) -> np.ndarray:
    """The rows and one more, the last with another number in it."""
    values = np.concatenate([values, values[-1:]])
    return values if value is None else with_value(values, value)


PER_POINT = ("points", "normals", "weight", "covariances", "dopplers", "times", "descriptors")
PER_QUERY = ("queries", "radii", "scales")
MODIFIED = ("near", "start", "view", "turn", "information", "direction", "poses", "stamps", "outline", "values")


def inputs_of(operation: str) -> list[tuple[str, str]]:
    """The inputs that an operation names, and what in them is changed."""
    parts = {"cloud": ["points", "normals"], "mesh": ["vertex", "corner"], "features": ["source", "target"]}
    parts |= {"other": parts["cloud"], "ball": parts["cloud"], "soup": parts["mesh"]}
    names = (*parts, *PER_POINT, *PER_QUERY, *MODIFIED, "rays", "depth", "at", "vertices")
    named = [name for name in names if re.search(rf"(?<![\w.\"]){name}\b(?!=)", operation)]
    return [(name, part) for name in named for part in parts.get(name, [""])]


def changed(scene: dict[str, Any], name: str, part: str, value: float) -> dict[str, Any]:
    """The scene with one more element in an input, which has this number in it."""
    given = scene[name]
    if part in ("points", "normals"):
        row = np.array([POSITION if part == "points" else [0, 0, 1.0]]).ravel()
        row[0] = value
        features = [*scene["features"]]
        if name != "ball":
            features[name == "cloud"] = grown(features[name == "cloud"])
        return {name: grown_cloud(given, {part: row}), "features": features}
    if part in ("vertex", "corner"):
        return {name: grown_mesh(given, value, part == "corner")}
    if name == "features":
        return {name: [with_value(f, value) if k == (part == "target") else f for k, f in enumerate(given)]}
    for group in (PER_POINT, PER_QUERY):
        if name in group:
            return {n: grown(scene[n], value if n == name else None) for n in group}
    if name == "at":
        return {name: lambda x: with_value(x, value) if np.ndim(x) == 1 else grown(x, value)}
    if name == "depth":
        return {name: np.where(np.arange(given.size).reshape(given.shape) == 1000, value, given).astype(np.float32)}
    return {name: grown(given, value) if name in ("rays", "vertices") else with_value(given, value)}


def outcome(operation: str, scene: dict[str, Any]) -> tuple[np.ndarray, Any] | ValueError:
    """The numbers of a result and the result of a solver, or the error."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)
            result = eval(operation.removesuffix(".transformation"), dict(scene))
    except ValueError as error:
        return error
    return np.asarray(getattr(result, "transformation", result), np.float64), result


def agree(actual: np.ndarray, expected: np.ndarray, count: int, tolerance: float) -> bool:
    """True if the rows of the elements that both have are equal."""
    if actual.ndim and expected.ndim and abs(len(actual) - len(expected)) <= 1:
        count = min(len(actual), len(expected), count)
        if np.allclose(actual[:count], expected[:count], rtol=0, atol=tolerance, equal_nan=True):
            return True
    if actual.ndim:
        actual = actual[np.isfinite(actual).reshape(len(actual), -1).all(axis=1)]
    return actual.shape == expected.shape and np.allclose(actual, expected, rtol=0, atol=tolerance, equal_nan=True)


def is_better(result: Any, other: Any) -> bool:
    """True if a solver reports more than in another result."""
    return any(getattr(result, name, 0) > getattr(other, name, 0) + 1e-3 for name in ("fitness", "converged"))


@pytest.fixture(scope="module")
def scenes() -> dict[Any, dict[str, Any]]:
    return {}


def scene_on(device: Any) -> dict[str, Any]:
    """The names in CASES and MORE."""
    scene = things((0, 0, 0), device, COUNT)

    def made(points: Any, **arrays: Any) -> loom.PointCloud:
        return loom.PointCloud(points, device=device, **arrays)

    def fused(method: str, *arguments: Any) -> np.ndarray:
        volume = loom.TSDFVolume(voxel_size=0.1, device=device)
        getattr(volume, method)(*arguments)
        return volume.extract_triangle_mesh(weight_threshold=0).vertices

    def mapped(points: Any, origin: Any) -> loom.OccupancyGrid:
        grid = loom.OccupancyGrid(0.2, device=device)
        grid.insert_scan(points, origin)
        return grid

    def drive(scan: loom.PointCloud) -> np.ndarray:
        odometry = reg.LidarOdometry(voxel_size=0.2, max_range=20, min_range=0.1)
        odometry.register(scan)
        return odometry.register(scan)

    reg, cloud, rng = loom.registration, scene["cloud"], np.random.default_rng(5)
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, :3, 3] = [0.01, 0.02, 0.03]
    return scene | {
        "about": lambda T: T, "made": made,
        "fused": fused, "mapped": mapped, "drive": drive, "poses": poses, "stamps": np.arange(2.0),
        "points": np.array(cloud.points), "normals": np.array(cloud.normals), "weight": rng.random(COUNT),
        "covariances": np.array(cloud.estimate_covariances(max_nn=12)["covariances"]),
        "dopplers": np.zeros(COUNT), "times": np.linspace(1, 0, COUNT), "descriptors": np.array(scene["features"][1]),
        "queries": np.array(scene["other"].points[:20]), "radii": np.full(20, 0.1), "scales": np.full((20, 3), 0.05),
        "vertices": np.array(scene["mesh"].vertices), "values": np.linspace(0, 1, len(scene["mesh"].vertices)),
        "outline": np.array([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0.0]]), "direction": np.array([0.2, 0.3, 1.0]),
        "information": np.eye(6), "rgbd": lambda depth: loom.RGBDImage(np.full((48, 64, 3), 100, np.uint8), depth),
    }  # fmt: skip


ROWS = [
    line.replace(" @ shift(-1)", "").replace(" @ shift(1)", "").split(" ", 2)[1:] for line in CASES.strip().splitlines()
]
ROWS += [line.split(" ", 1) for line in MORE.strip().splitlines()]


@pytest.mark.slow_on_emulated_cuda("170 operations, some thousand runs")
@pytest.mark.parametrize(("tolerance", "operation"), ROWS, ids=[operation for _, operation in ROWS])
def test_one_element_that_is_not_finite_is_refused_or_left_out(tolerance, operation, device, scenes):
    scene = scenes[device] = scenes.get(device) or scene_on(device)
    tolerance = max([float(tolerance), *(limit for word, limit in TOLERANCES.items() if word in operation)])
    without, result = outcome(operation, scene)
    count = len(without) if without.ndim else 0
    for name, part in inputs_of(operation):
        exception = EXCEPTIONS.get(f"{operation.partition('(')[0]} {part}")
        finite = None
        for value in (np.nan, np.inf):
            actual = outcome(operation, scene | changed(scene, name, part, value))
            case = f"{value} in {name} {part}"
            if isinstance(actual, ValueError):
                assert ARGUMENT.match(str(actual)), f"{case}: {actual}"
                continue
            if exception is not None:
                assert exception[1](actual[0], without), case
                continue
            if agree(actual[0], without, count, tolerance) and not is_better(actual[1], result):
                continue
            finite = finite or outcome(operation, scene | changed(scene, name, part, 0.0))
            assert isinstance(finite, tuple), f"{case}: {finite}"
            assert agree(actual[0], finite[0], count, tolerance) or agree(actual[0], without, count, tolerance), case
            assert not is_better(actual[1], finite[1]), case
