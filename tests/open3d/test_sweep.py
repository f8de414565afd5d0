"""Signatures and results of methods of geometries, images, searches, cameras and registration are those of Open3D."""

import inspect
import re
from ast import literal_eval
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import pointloom.open3d as bridge

MODULES = ("geometry", "utility", "camera", "io", "pipelines.registration", "pipelines.odometry")
MODULES += ("pipelines.integration", "pipelines.color_map")


def functions_of(package) -> Iterator[tuple[str, Any]]:
    """The public functions and methods of a package by path."""
    for module in MODULES:
        home = package
        for part in module.split("."):
            home = getattr(home, part)
        for name in dir(home):
            value = getattr(home, name)
            if inspect.isclass(value):
                yield from ((f"{module}.{name}.{key}", getattr(value, key)) for key in dir(value) if key[0] != "_")
            elif name[0] != "_":
                yield f"{module}.{name}", value


def signatures(o3d) -> dict[str, list[list[str]]]:
    """The parameters of each overload in Open3D's docstrings: "name", or "name=value" for plain defaults."""
    found = {}
    for path, function in functions_of(o3d):
        start = rf"^(?:\d+\. )?{path.rpartition('.')[2]}"
        lines = re.findall(rf"{start}\((.*?)\)(?: -> .*)?$", getattr(function, "__doc__", None) or "", re.M)
        lines = [re.sub(r"\([^()]*\)", "", line) for line in lines]
        plain = r"(?:: [\w.]+ = (-?[\d.]+(?:e-?\d+)?|True|False)(?=, |$))?"
        parts = [re.findall(rf"(?:^|, )(\w+)(?=: |, | = |$){plain}", line) for line in lines]
        texts = [[f"{name}={value}" if value else name for name, value in part if name != "self"] for part in parts]
        is_named = bool(lines) and "args" not in lines[0] and "arg0" not in lines[0]
        is_read = all(part or re.fullmatch(r"(self: [\w.]+)?", line) for line, part in zip(lines, texts, strict=True))
        if is_named and is_read and callable(function):
            found[path] = texts
    return found


def test_signatures_agree_with_open3d(oracle):
    stored = oracle("open3d/signatures", signatures)
    assert len(stored) > 400
    for path, function in functions_of(bridge):
        if path not in stored:
            continue
        given = [p for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = [p.name for p in given if p.name != "self"]
        overloads = [[text.partition("=")[0] for text in texts] for texts in stored[path]]
        assert names in overloads or any(p.kind is p.VAR_POSITIONAL for p in given), (path, stored[path])
        texts = stored[path][overloads.index(names)] if names in overloads else []
        defaults = dict(text.split("=") for text in texts if "=" in text)
        actual = {p.name: p.default for p in given if p.name in defaults}
        assert actual == pytest.approx({k: literal_eval(v) for k, v in defaults.items()}, rel=1e-6), path


def cloud(o3d, points=None):
    """A colored cloud with normals, of random points by default."""
    random = np.random.default_rng(0)
    made = o3d.geometry.PointCloud(vector(o3d, random.uniform(-1, 2, (40, 3)) if points is None else points))
    made.normals = vector(o3d, random.normal(size=(len(made.points), 3)))
    made.colors = vector(o3d, random.random((len(made.points), 3)))
    return made


def grid(o3d):
    return cloud(o3d, np.stack(np.meshgrid(*[np.arange(3.0)] * 3, indexing="ij"), -1).reshape(-1, 3))


def mesh(o3d):
    """A box with an unused vertex and a duplicate triangle, colors, vertex normals and assigned triangle normals."""
    random, box = np.random.default_rng(1), o3d.geometry.TriangleMesh.create_box()
    triangles, vertices = np.asarray(box.triangles), np.r_[np.asarray(box.vertices), [[2, 2, 2.0]]]
    triangles = o3d.utility.Vector3iVector(np.r_[triangles, triangles[:1]])
    made, normals = o3d.geometry.TriangleMesh(vector(o3d, vertices), triangles), random.normal(size=(9, 3))
    made.vertex_normals = vector(o3d, normals / np.linalg.norm(normals, axis=1, keepdims=True))
    made.vertex_colors = vector(o3d, random.random((9, 3)))
    made.triangle_normals = vector(o3d, random.normal(size=(13, 3)))
    return made


def lines(o3d):
    points, pairs = np.random.default_rng(2).uniform(-1, 1, (6, 3)), [[0, 1], [1, 2], [4, 3]]
    made = o3d.geometry.LineSet(vector(o3d, points), o3d.utility.Vector2iVector(pairs))
    made.colors = vector(o3d, np.eye(3))
    return made


def box(o3d):
    return o3d.geometry.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 0.5])


def rotated_box(o3d):
    return o3d.geometry.OrientedBoundingBox([0, 0, 1], rotation(o3d), [1, 2, 3])


def vector(o3d, rows):
    return o3d.utility.Vector3dVector(rows)


def rotation(o3d):
    return o3d.geometry.get_rotation_matrix_from_xyz([0.1, 0.2, 0.3])


def searches(o3d):
    param = o3d.geometry
    return [param.KDTreeSearchParamHybrid(1.0, 6), param.KDTreeSearchParamRadius(1.0), param.KDTreeSearchParamKNN(8)]


SHAPES = {"PointCloud": [cloud, grid], "TriangleMesh": [mesh], "LineSet": [lines]}
SHAPES |= {"AxisAlignedBoundingBox": [box], "OrientedBoundingBox": [rotated_box]}
POINTS = [[0, 0, 0], [1, 1, 1], [1, 2, 3], [0.5, 0.5, 0.5], [0, 0, 1], [0.5, 1, 1.5]]
MOTION = [[1, 0, 0, 1], [0, 0, -1, 2], [0, 1, 0, 3], [0, 0, 0, 1.0]]

# Values of arguments by name. Calls take the first ones, and then the others, one at a time. Sizes and limits occur
# exactly in the grid and in the boxes.
ARGUMENTS: dict[str, Any] = {
    "R": lambda o3d: [rotation(o3d)], "allow_boundary_edges": [True, False],
    "arg0": [MOTION], "bounding_box": lambda o3d: [box(o3d), rotated_box(o3d)], "camera_location": [[0, 0, 3.0]],
    "center": [[0, 0, 1.0]], "cleanup": [True, False], "color": [[1, 0, 0.5]], "eps": [0.5, 1.0],
    "every_k_points": [2, 100], "indices": [[], [0, 2, 2]], "input": lambda o3d: [cloud(o3d)], "invert": [False, True],
    "iterations": [3, 0], "knn": [6, 3], "lambda_": [0.3, 0.5], "lambda_filter": [0.5, 0.3], "line_index": [0, 2],
    "max_bound": [[2, 2, 2.0]], "min_bound": [[-1, -1, -1.0]], "min_points": [3, 5], "mu": [-0.53, -0.4],
    "nb_neighbors": [5, 10], "nb_points": [3, 1], "normalized": [True, False], "num_samples": [1, 5],
    "number_of_iterations": [1, 2], "orientation_reference": [[0, 1, 0.0]],
    "points": lambda o3d: [vector(o3d, POINTS)], "radius": [1.0, 0.5], "relative": [True, False],
    "remove_infinite": [True, False], "remove_nan": [True, False], "scale": [2, 0.5], "search_param": searches,
    "sigma_r": [0.05, 0.5], "sigma_s": [0.05, 0.5], "start_index": [0, 1], "std_ratio": [1.0, 0.1],
    "strength": [1.0, 0.5], "target": lambda o3d: [cloud(o3d, POINTS)], "translation": [[1, 2, 3.0]],
    "triangle_indices": [[], [0, 1, 1]], "triangle_mask": [np.arange(13) % 3 == 0], "vertex_indices": [[], [0, 1, 1]],
    "vertex_mask": [np.arange(9) % 3 == 0], "voxel_size": [0.5, 0.9], "use_fixed_neighborhoods": [False, True],
}  # fmt: skip

# Results that are compared as sums of rows: those of hash tables have no defined order.
UNORDERED = {"voxel_down_sample", "voxel_down_sample_and_trace", "simplify_vertex_clustering"}
UNORDERED |= {"get_non_manifold_edges", "get_oriented_bounding_box"}

# Methods with documented differences.
DIFFERENT = {
    **dict.fromkeys(("sample_points_uniformly", "sample_points_poisson_disk", "random_down_sample"), "random"),
    **dict.fromkeys(("segment_plane", "detect_planar_patches", "get_minimal_oriented_bounding_box"), "other draws"),
    **dict.fromkeys(("compute_convex_hull", "hidden_point_removal"), "indices ascend"),
    **dict.fromkeys(("orient_normals_consistent_tangent_plane", "simplify_quadric_decimation"), "other order"),
    **dict.fromkeys(("is_orientable", "orient_triangles"), "False if an edge has three triangles"),
    "subdivide_loop": "NaN at unused vertices in Open3D",
    "get_oriented_bounding_ellipsoid": "other axes of symmetric shapes (test_other_geometries.py compares the others)",
    **dict.fromkeys(("get_geometry_type", "get_extent"), "none of oriented boxes in Open3D"),
}
FILTERS = ("filter_sharpen", "filter_smooth_simple", "filter_smooth_laplacian", "filter_smooth_taubin")
# Attributes with documented differences.
LEFT_OUT = {
    **dict.fromkeys(FILTERS, ("vertex_normals",)),  # of unit length
    "smooth_mls": ("normals",),  # on either side
    "subdivide_midpoint": ("vertex_normals",),  # of unit length
    "merge_close_vertices": ("vertex_normals", "triangle_normals"),  # of unit length
    "compute_vertex_normals": ("vertex_normals",),  # (0, 0, 1) at unused vertices
}  # fmt: skip
NEIGHBORS = ("estimate_normals", "estimate_covariances", "smooth_laplacian", "smooth_taubin", "smooth_mls")
ATTRIBUTES = ("points", "normals", "colors", "covariances", "vertices", "vertex_normals", "vertex_colors", "triangles")
ATTRIBUTES += ("triangle_normals", "lines", "min_bound", "max_bound")


def calls() -> Iterator[tuple[str, Any, dict[str, int]]]:
    """(method, function that makes the shape, number of the value of each argument) of each call."""
    for kind, shapes in SHAPES.items():
        owner = getattr(bridge.geometry, kind)
        for method in sorted(key for key in dir(owner) if inspect.isfunction(inspect.getattr_static(owner, key))):
            parameters = list(inspect.signature(getattr(owner, method)).parameters.values())[1:]
            names = [p.name for p in parameters if p.name in ARGUMENTS]
            required = {p.name for p in parameters if p.default is p.empty}
            if method[0] == "_" or method in DIFFERENT or not required <= {*names}:
                continue
            first = dict.fromkeys(names, 0)
            for make in shapes if method not in NEIGHBORS else shapes[:1]:
                yield method, make, first
                for name in names:
                    values = ARGUMENTS[name]
                    for i in range(1, len(values(bridge) if callable(values) else values)):
                        yield method, make, first | {name: i}
            if method != "get_line_coordinate":  # Open3D crashes
                yield method, lambda o3d, kind=kind: getattr(o3d.geometry, kind)(), first


def creations() -> Iterator[tuple[str, Any, dict[str, Any]]]:
    """As `calls`, for the meshes with plain arguments: their defaults, and one other value at a time."""
    for method in sorted(name for name in dir(bridge.geometry.TriangleMesh) if name.startswith("create_")):
        parameters = inspect.signature(getattr(bridge.geometry.TriangleMesh, method)).parameters.values()
        if all(isinstance(p.default, bool | int | float) for p in parameters):
            yield method, empty_mesh, {}
            for p in parameters:
                other = not p.default if isinstance(p.default, bool) else p.default + 2
                yield method, empty_mesh, {p.name: other}


def empty_mesh(o3d):
    return o3d.geometry.TriangleMesh()


def numbers(value: Any, left_out: tuple[str, ...], weighted: bool) -> list[float]:
    """Shapes, sums and weighted sums of the arrays of a result."""
    if hasattr(value, "get_box_points"):
        return numbers(np.array(value.get_box_points()), (), False)
    if attributes := [name for name in ATTRIBUTES if name in dir(type(value)) and name not in left_out]:
        return [x for name in attributes for x in numbers(np.array(getattr(value, name)), (), weighted)]
    if isinstance(value, list | tuple) and not all(isinstance(item, int | float) for item in value):
        parts = [numbers(item, left_out, weighted) for item in value]
        return [len(value), *(x for part in (parts if weighted else sorted(parts)) for x in part)]
    array = np.array(value if value is not None else [], float)
    weights = np.cos(np.arange(array.size)) if weighted else np.ones(array.size)
    return [*array.shape, np.abs(array).sum(), array.reshape(-1) @ weights]


def results(o3d) -> list[list[Any]]:
    """The numbers of each result and of the shape after the call, "error" for errors, "text" for text."""
    found = []
    for method, make, chosen in [*calls(), *creations()]:
        shape, rules = make(o3d), (LEFT_OUT.get(method, ()), method not in UNORDERED)
        listed = {name: ARGUMENTS.get(name) for name in chosen}
        values = {name: options(o3d) if callable(options) else options for name, options in listed.items()}
        given = {name: values[name][i] for name, i in chosen.items()} if make is not empty_mesh else chosen
        positional = [given.pop(name) for name in ("arg0", "color") if name in given]
        try:
            result = getattr(shape, method)(*positional, **given)
            result = "text" if isinstance(result, str) else "self" if result is shape else result
        except Exception:
            result = "error"
        found.append([*([result] if isinstance(result, str) else numbers(result, *rules)), *numbers(shape, *rules)])
    return found


def compact(found: list[list[Any]]) -> dict[str, Any]:
    """The results as few arrays, which make a small file."""
    texts = [[x if isinstance(x, str) else "" for x in numbers] for numbers in found]
    values = [0.0 if isinstance(x, str) else x for numbers in found for x in numbers]
    return {"texts": [" ".join(text) for text in texts], "values": np.array(values)}


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore:.*most points have fewer than:pointloom.UnitWarning")
def test_results_agree_with_open3d(oracle):
    stored, actual = oracle("open3d/results", lambda o3d: compact(results(o3d))), results(bridge)
    begin = 0
    assert len(actual) == len(stored["texts"]) > 450
    rows = zip([*calls(), *creations()], actual, stored["texts"], strict=True)
    for (method, make, chosen), numbers_of_call, text in rows:
        expected = stored["values"][begin : begin + text.count(" ") + 1]
        begin += len(expected)
        case = f"{method} of {make.__name__} with {chosen}"
        found = compact([numbers_of_call])
        assert found["texts"] == [text], case
        np.testing.assert_allclose(found["values"], expected, rtol=1e-5, atol=2e-5, err_msg=case)


FORMATS = ("color_and_depth", "redwood_format", "tum_format", "nyu_format", "sun_format")
METHODS = {
    "remove_non_finite_points": (), "voxel_down_sample": (0.5,), "get_center": (), "get_axis_aligned_bounding_box": (),
    "compute_mean_and_covariance": (), "cluster_dbscan": (1.0, 3), "uniform_down_sample": (3,),
    "remove_duplicated_points": (), "normalize_normals": (), "paint_uniform_color": ([1, 0, 0],),
}  # fmt: skip

# Methods with Open3D's results for non-finite points. The others ignore these points, and spoil results in Open3D.
MISSING = ("remove_non_finite_points", "uniform_down_sample", "normalize_normals", "paint_uniform_color")
MISSING += ("remove_duplicated_points",)


def image(o3d, kind, channels=1):
    values = np.random.default_rng(0).random((12, 16) if channels == 1 else (12, 16, channels))
    return o3d.geometry.Image((values * {"uint8": 255, "uint16": 5000, "float32": 1}[kind]).astype(kind))


def normal_cloud(o3d, is_finite=True):
    random = np.random.default_rng(1)
    points, normals = random.uniform(-1, 2, (40, 3)), random.normal(size=(40, 3))
    if not is_finite:
        points[3], points[7, 1] = np.nan, np.inf
    made = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    made.normals = o3d.utility.Vector3dVector(normals / np.linalg.norm(normals, axis=1, keepdims=True))
    made.colors = o3d.utility.Vector3dVector(random.random((40, 3)))
    return made


def camera(o3d):
    return o3d.camera.PinholeCameraIntrinsic(16, 12, 20, 20, 7.5, 5.5)


def pose():
    T = np.eye(4)
    T[:3, 3] = 0.1, 0, 0.2
    return T


def flipped(o3d, kind, channels):
    pixels = image(o3d, kind, channels)
    return [pixels.flip_horizontal(), pixels.flip_vertical(), pixels.get_max_bound(), pixels.create_pyramid(2, False)] \
        if kind == "float32" and channels == 1 else [pixels.flip_horizontal(), pixels.get_min_bound()]  # fmt: skip


def filtered(o3d, name):
    pixels, kind = image(o3d, "float32"), getattr(o3d.geometry.ImageFilterType, name)
    return [pixels.filter(kind), o3d.geometry.Image.filter_pyramid(pixels.create_pyramid(2, True), kind)]


def rgbd(o3d, name, is_gray):
    create = getattr(o3d.geometry.RGBDImage, f"create_from_{name}")
    images = create(image(o3d, "uint8", 3), image(o3d, "uint16"), convert_rgb_to_intensity=is_gray)
    return [images, o3d.geometry.PointCloud.create_from_rgbd_image(images, camera(o3d), pose())]


def depth_cloud(o3d, kind, stride, truncation):
    scale = 1.0 if kind == "float32" else 1000.0
    given = image(o3d, kind), camera(o3d), pose(), scale, truncation, stride
    return o3d.geometry.PointCloud.create_from_depth_image(*given)


def searched(o3d, query):
    tree, g = o3d.geometry.KDTreeFlann(normal_cloud(o3d)), o3d.geometry
    params = g.KDTreeSearchParamKNN(3), g.KDTreeSearchParamRadius(0.8), g.KDTreeSearchParamHybrid(0.8, 2)
    found = [tree.search_knn_vector_3d(query, count) for count in (1, 5, 60)]
    found += [tree.search_radius_vector_3d(query, radius) for radius in (0.1, 1.0, 20.0)]
    found += [tree.search_hybrid_vector_3d(query, radius, 7) for radius in (0.1, 1.0, 20.0)]
    return found + [tree.search_vector_3d(query, param) for param in params]


def parameters(o3d, name):
    made = o3d.camera.PinholeCameraIntrinsic(getattr(o3d.camera.PinholeCameraIntrinsicParameters, name))
    return [made.width, made.height, made.intrinsic_matrix, made.get_focal_length(), made.get_principal_point()]


def registered(o3d, distance):
    module, clouds = o3d.pipelines.registration, [normal_cloud(o3d), normal_cloud(o3d)]
    clouds[1].translate([0.02, 0.01, -0.01])
    to_planes = module.TransformationEstimationPointToPlane()
    results = [module.evaluate_registration(*clouds, distance), module.registration_icp(*clouds, distance)]
    results += [module.registration_icp(*clouds, distance, np.eye(4), to_planes), module.RegistrationResult()]
    information = module.get_information_matrix_from_point_clouds(*clouds, distance, np.eye(4))
    return [[r.transformation, r.fitness, r.inlier_rmse, r.correspondence_set] for r in results] + [information]


def called(o3d, method, is_finite):
    shape = normal_cloud(o3d, is_finite)
    return [getattr(shape, method)(*METHODS[method]), shape]


def cases() -> dict[str, Callable[[Any], Any]]:
    """The functions of a package by name."""
    calls = [(flipped, kind, channels) for kind in ("uint8", "uint16", "float32") for channels in (1, 3)]
    calls += [(filtered, name) for name in ("Gaussian3", "Gaussian5", "Gaussian7", "Sobel3dx", "Sobel3dy")]
    calls += [(rgbd, name, is_gray) for name in FORMATS for is_gray in (False, True)]
    calls += [(depth_cloud, *given) for given in (("uint16", 1, 1000.0), ("uint16", 2, 3.0), ("float32", 1, 0.5))]
    calls += [(searched, query) for query in ([0.0, 0, 0], [0.5, 0.5, 0.5], [9.0, 9, 9])]
    calls += [(parameters, f"{name}Default") for name in ("PrimeSense", "Kinect2DepthCamera", "Kinect2ColorCamera")]
    calls += [(registered, distance) for distance in (0.001, 0.1, 0.5)]
    calls += [(called, method, finite) for method in METHODS for finite in (True, method not in MISSING)]
    return {f"{call.__name__} {given}": lambda o3d, c=call, g=given: c(o3d, *g) for call, *given in calls}


def arrays_of(value) -> list[np.ndarray]:
    """The arrays of a result."""
    if hasattr(value, "get_box_points"):
        return arrays_of(value.get_box_points())
    if hasattr(value, "points"):
        return [np.array(getattr(value, name), float) for name in ("points", "normals", "colors")]
    if hasattr(value, "depth"):
        return [*arrays_of(value.color), *arrays_of(value.depth)]
    if isinstance(value, list | tuple) and not all(isinstance(item, int | float) for item in value):
        return [array for part in value for array in arrays_of(part)]
    return [np.array(value, float)]


def other_results(o3d) -> dict[str, np.ndarray]:
    """Shape, sum of magnitudes and weighted sum of each array of each case. Errors count as -1."""
    found = {}
    for name, call in cases().items():
        rows = []
        try:
            arrays = arrays_of(call(o3d))
        except Exception:
            arrays = [np.full(1, -1.0)]  # an error
        for array in arrays:  # voxels have no order
            weights = np.ones(array.size) if "voxel" in name else np.cos(np.arange(array.size))
            values = np.nan_to_num(array.reshape(-1), posinf=9.0)
            rows += [*array.shape, np.abs(values).sum(), values @ weights]
        found[name] = np.array(rows)
    return found


@pytest.mark.slow
def test_results_of_other_classes_agree_with_open3d(oracle):
    expected, actual = oracle("open3d/other_results", other_results), other_results(bridge)
    assert len(actual) > 40 and actual.keys() == expected.keys()
    for name, values in actual.items():
        np.testing.assert_allclose(values, expected[name], rtol=2e-5, atol=2e-5, err_msg=name)


def test_searches_find_all_finite_points_and_no_others():
    tree, finite = (bridge.geometry.KDTreeFlann(normal_cloud(bridge, False)), [i for i in range(40) if i not in (3, 7)])
    for search, *limits in (("knn", 60), ("radius", 20.0), ("hybrid", 20.0, 60)):
        found = getattr(tree, f"search_{search}_vector_3d")([0.5, 0.5, 0.5], *limits)
        assert found[0] == 38 and sorted(found[1]) == finite and np.isfinite(found[2]).all()
    none = bridge.geometry.KDTreeFlann(np.full((3, 2), np.nan))
    assert none.search_knn_vector_3d([0, 0, 0], 1)[0] == none.search_radius_vector_3d([0, 0, 0], 1.0)[0] == 0
