"""Undocumented conventions of Open3D that scripts rely on, compared with Open3D's results."""

import numpy as np
import pytest

import pointloom.open3d as bridge

ROWS = (3, 1, 1, 0)
GRID = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
ROTATION = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])
EDITS = ("select_by_index", "remove_triangles_by_index", "remove_vertices_by_index")
FANS = [(np.eye(5, 3), np.array(rows, np.int32)) for rows in ([[0, 1, 2], [0, 2, 3]], [[0, 1, 1]], [[0, 1, 2]] * 2, [])]
COLUMN = np.array([[1.0], [2], [3]])
CROSS = np.eye(8, 3), np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 0, 5], [0, 2, 4], [3, 0, 5]], np.int32)
SHEAR = np.array([[2.0, 0, 0, 1], [0, 1, 0.5, 0], [0, 0, 3, 0], [0, 0, 0.1, 2]])


def cloud(o3d, count=5, seed=0):
    random = np.random.default_rng(seed)
    made = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(random.uniform(-1, 1, (count, 3))))
    made.normals = o3d.utility.Vector3dVector(random.normal(size=(count, 3)))
    made.colors = o3d.utility.Vector3dVector(random.random((count, 3)))
    half = random.normal(size=(count, 3, 3))
    made.covariances = o3d.utility.Matrix3dVector(half @ half.transpose(0, 2, 1))
    return made


def mesh(o3d):
    """A sphere with assigned vertex and triangle normals, neither unit vectors nor its own."""
    made, random = o3d.geometry.TriangleMesh.create_sphere(1.0, 3), np.random.default_rng(0)
    made.vertex_normals = o3d.utility.Vector3dVector(random.normal(size=(len(made.vertices), 3)))
    made.triangle_normals = o3d.utility.Vector3dVector(random.normal(size=(len(made.triangles), 3)))
    return made


def arrays(shape):
    names = ("points", "normals", "covariances", "vertices", "vertex_normals", "triangle_normals", "lines")
    return {name: np.array(getattr(shape, name), float) for name in names if name in dir(type(shape))}


def edited(shape, method, *values):
    """A shape after a method that modifies it and returns something else."""
    getattr(shape, method)(*values)
    return arrays(shape)


def feature(o3d):
    made = o3d.pipelines.registration.Feature()
    made.data = np.arange(10.0).reshape(2, 5)
    return made


def neighbor_count(o3d, search, *values):
    tree = o3d.geometry.KDTreeFlann(o3d.geometry.PointCloud(o3d.utility.Vector3dVector(GRID)))
    return getattr(tree, search)([1, 1, 1], *values)[0]


def fpfh(o3d, rows):
    near = o3d.geometry.KDTreeSearchParamHybrid(2.0, 30)
    return np.array(o3d.pipelines.registration.compute_fpfh_feature(cloud(o3d, 30), near, rows).data).shape


def textured(o3d):
    made = o3d.geometry.TriangleMesh.create_box()
    made.textures = [o3d.geometry.Image(np.zeros((2, 2, 3), np.uint8))]
    return made


def points_in_box(o3d, shape):
    return shape.get_axis_aligned_bounding_box().get_point_indices_within_bounding_box(shape.points)


def traced(o3d, shape, *corners):
    corners = corners or (shape.get_min_bound(), shape.get_max_bound())
    return shape.voxel_down_sample_and_trace(0.5, *corners)[2]


def points_of(o3d, rows, last):
    points = o3d.utility.Vector3dVector(rows)
    points.append(last)
    points[0] = 2 * last
    return np.array(points)


def rotations(o3d):
    return [getattr(o3d.geometry, f"get_rotation_matrix_from_{name}") for name in ("xyz", "zyx", "axis_angle")]


def sampled(o3d, how):
    made = o3d.geometry.TriangleMesh.create_box()
    made.triangle_normals = o3d.utility.Vector3dVector(np.tile([[0.6, 0, 0.8]], (12, 1)))
    return getattr(made, f"sample_points_{how}")(5, use_triangle_normal=True)


def mesh_of(o3d, vertices, triangles):
    vectors = o3d.utility.Vector3dVector(vertices), o3d.utility.Vector3iVector(np.reshape(triangles, (-1, 3)))
    return o3d.geometry.TriangleMesh(*vectors)


def criteria(o3d, confidence):
    return o3d.pipelines.registration.RANSACConvergenceCriteria(4000, confidence)


def assigned(made, name, value):
    setattr(made, name, value)
    return made


def registered(o3d, criteria):
    source, target = cloud(o3d, 30), cloud(o3d, 30).rotate(ROTATION, center=(0, 0, 0))
    pairs = o3d.utility.Vector2iVector(np.repeat(np.arange(30, dtype=np.int32)[:, None], 2, axis=1))
    register = o3d.pipelines.registration.registration_ransac_based_on_correspondence
    return np.array(register(source, target, pairs, 0.05, criteria=criteria).transformation)


def param(o3d, radius):
    return o3d.geometry.KDTreeSearchParamRadius(radius)


# Each claim is called with Open3D and with pointloom.open3d. Open3D's results are stored.
CLAIMS = {
    # Indices are flags: repeats and order have no effect, except for meshes, whose vertices they order.
    "select repeats": lambda o3d: arrays(cloud(o3d).select_by_index(ROWS)),
    "select an IntVector": lambda o3d: arrays(cloud(o3d).select_by_index(o3d.utility.IntVector(ROWS))),
    "select a set": lambda o3d: arrays(cloud(o3d).select_by_index(set(ROWS))),
    "select the rest of repeats": lambda o3d: arrays(cloud(o3d).select_by_index(ROWS, invert=True)),
    "select features": lambda o3d: np.array(feature(o3d).select_by_index(ROWS).data),
    "select the rest of features": lambda o3d: np.array(feature(o3d).select_by_index(ROWS, invert=True).data),
    "features of repeats": lambda o3d: fpfh(o3d, ROWS),
    "select vertices": lambda o3d: arrays(mesh(o3d).select_by_index([*range(12, -1, -1), 3, 3])),
    "remove triangles by repeats": lambda o3d: edited(mesh(o3d), "remove_triangles_by_index", ROWS),
    "remove vertices by repeats": lambda o3d: edited(mesh(o3d), "remove_vertices_by_index", ROWS),
    # Points at exactly the radius are not within it.
    "radius": lambda o3d: [neighbor_count(o3d, "search_radius_vector_3d", r) for r in (0, 1, 1.01, 2**0.5, 2, np.inf)],
    "radius of any dimension": lambda o3d: [neighbor_count(o3d, "search_radius_vector_xd", r) for r in (1, 2)],
    "hybrid": lambda o3d: [neighbor_count(o3d, "search_hybrid_vector_3d", r, 50) for r in (0, 1, 1.01, 2, np.inf)],
    "radius of a parameter": lambda o3d: [neighbor_count(o3d, "search_vector_3d", param(o3d, r)) for r in (1, 1.01)],
    # Normals of triangles, computed or assigned.
    "areas by normals": lambda o3d: arrays(mesh(o3d).compute_triangle_normals(normalized=False))["triangle_normals"],
    "normals weighted by areas": lambda o3d: arrays(mesh(o3d).compute_vertex_normals(normalized=False)),
    "computed normals": lambda o3d: arrays(mesh(o3d).compute_vertex_normals()),
    "no normals to normalize": lambda o3d: arrays(o3d.geometry.PointCloud(cloud(o3d).points).normalize_normals()),
    "mean of no points": lambda o3d: np.vstack(o3d.geometry.PointCloud().compute_mean_and_covariance()),
    "normalized normals": lambda o3d: arrays(mesh(o3d).normalize_normals()),
    "mesh translated": lambda o3d: arrays(mesh(o3d).translate([1, 2, 3])),
    "mesh scaled": lambda o3d: arrays(mesh(o3d).scale(2, center=(0, 0, 1))),
    "mesh rotated": lambda o3d: arrays(mesh(o3d).rotate(ROTATION, center=(0, 0, 1))),
    "mesh painted": lambda o3d: arrays(mesh(o3d).paint_uniform_color([1, 0, 0])),
    "mesh written to": lambda o3d: arrays(edited_vertices(o3d).translate([0, 0, 1])),
    "vertices removed": lambda o3d: edited(mesh(o3d), "remove_vertices_by_mask", np.arange(14) % 5 == 0),
    "triangles removed": lambda o3d: edited(mesh(o3d), "remove_triangles_by_mask", np.arange(24) % 3 == 0),
    "duplicates removed": lambda o3d: arrays((mesh(o3d) + mesh(o3d)).remove_duplicated_vertices()),
    "mesh cropped": lambda o3d: arrays(mesh(o3d).crop(o3d.geometry.AxisAlignedBoundingBox([-1] * 3, [1, 1, 0.1]))),
    "meshes added": lambda o3d: arrays(mesh(o3d) + mesh(o3d).translate([3, 0, 0])),
    "textures assigned before their coordinates": lambda o3d: len(textured(o3d).translate([1, 0, 0]).textures),
    "samples with assigned normals": lambda o3d: np.array(sampled(o3d, "uniformly").normals),
    "even samples with assigned normals": lambda o3d: np.array(sampled(o3d, "poisson_disk").normals),
    "a mesh without normals added": lambda o3d: arrays(mesh(o3d) + o3d.geometry.TriangleMesh.create_box()),
    "a mesh added to an empty one": lambda o3d: arrays(o3d.geometry.TriangleMesh() + mesh(o3d)),
    # Points of both clouds, including those without a line.
    "correspondences": lambda o3d: arrays(joined(o3d, [(0, 1), (2, 3)])),
    "correspondences that repeat": lambda o3d: arrays(joined(o3d, [(0, 1), (0, 1), (4, 5)])),
    "edges of a mesh": lambda o3d: arrays(o3d.geometry.LineSet.create_from_triangle_mesh(mesh(o3d))),
    "points in their own box": lambda o3d: len(points_in_box(o3d, cloud(o3d, 200))),
    "voxels from the lowest corner": lambda o3d: len(traced(o3d, cloud(o3d, 200))),
    "no correspondences": lambda o3d: arrays(joined(o3d, [])),
    # Matrices that are not rigid motions are applied unchanged.
    "cloud translated": lambda o3d: arrays(cloud(o3d).translate([1, 2, 3])),
    "mirror": lambda o3d: arrays(cloud(o3d).rotate(np.diag([1, 1, -1.0]), center=(0, 0, 1))),
    "mirror about the mean": lambda o3d: arrays(cloud(o3d).rotate(-np.eye(3))),
    "enlarging rotation": lambda o3d: arrays(cloud(o3d).rotate(2 * ROTATION, center=(0, 0, 1)))["points"],
    "projection": lambda o3d: arrays(cloud(o3d).rotate(np.diag([1, 1, 0.0]), center=(0, 0, 1))),
    "negative scale": lambda o3d: arrays(cloud(o3d).scale(-2, center=(1, 0, 0))),
    "scale 0": lambda o3d: arrays(cloud(o3d).scale(0, center=(1, 0, 0))),
    "projective cloud": lambda o3d: arrays(cloud(o3d).transform(SHEAR)),
    "projective mesh": lambda o3d: arrays(mesh(o3d).transform(SHEAR)),
    "projective lines": lambda o3d: arrays(joined(o3d, [(0, 1)]).transform(SHEAR)),
    "columns": lambda o3d: arrays(cloud(o3d).translate(COLUMN).scale(1, center=COLUMN).rotate(ROTATION, center=COLUMN)),
    "points of columns": lambda o3d: points_of(o3d, [COLUMN, -COLUMN], COLUMN),
    "rotations of columns": lambda o3d: [rotate(COLUMN) for rotate in rotations(o3d)],
    "columns of corners": lambda o3d: len(traced(o3d, cloud(o3d, 200), -np.ones((3, 1)), np.ones((3, 1)))),
    "a frame at a column": lambda o3d: o3d.geometry.TriangleMesh.create_coordinate_frame(1, COLUMN).get_min_bound(),
    "a camera at a column": lambda o3d: sorted(cloud(o3d, 30).hidden_point_removal(9 * COLUMN, 100.0)[1]),
    "box of columns": lambda o3d: corners(o3d.geometry.AxisAlignedBoundingBox(-COLUMN, COLUMN)),
    "box of swapped corners": lambda o3d: corners(o3d.geometry.AxisAlignedBoundingBox([1, 2, 3], [0, 3, 0])),
    # The second number was a count before Open3D 0.12.
    "confidence": lambda o3d: [criteria(o3d, value).confidence for value in (500, 1.5, 0.9, -1)],
    "registration with a count": lambda o3d: registered(o3d, criteria(o3d, 500)),
    "registration with an assigned count": lambda o3d: registered(o3d, assigned(criteria(o3d, 0.9), "confidence", 500)),
    "boxes scaled": lambda o3d: [turned_box(o3d).scale(f, center=COLUMN).get_center() for f in (2, -1)],
    "rotated box mirrored": lambda o3d: box_points(turned_box(o3d).rotate(np.diag([1, 1, -1.0]), center=(0, 0, 1))),
    "rotated box enlarged": lambda o3d: box_points(turned_box(o3d).rotate(-2 * ROTATION, center=(0, 0, 1))),
    "negative extent": lambda o3d: box_points(o3d.geometry.OrientedBoundingBox([0, 0, 0], ROTATION, [1, -2, 3])),
    "lines and no lines": lambda o3d: np.vstack([shape.colors for shape in added_lines(o3d)]),
    "normals of a frame": lambda o3d: len(o3d.geometry.TriangleMesh.create_coordinate_frame().triangle_normals),
    "unit normals at both": lambda o3d: arrays(scaled_normals(o3d).compute_triangle_normals()),
    "intensities as colors": lambda o3d: [rgbd(o3d, dtype) for dtype in (np.uint8, np.float32)],
    "a surface of a width": lambda o3d: poisson_height(o3d, depth=0, width=0.3),
    "types": lambda o3d: cloud(o3d).get_geometry_type() == o3d.geometry.Geometry.PointCloud,
    # A closed mesh neither touches nor intersects itself.
    "watertight": lambda o3d: [pair(o3d, t).is_watertight() for t in ([3, 0, 0], [0.5, 0.5, 0.5], [1, 1, 1])],
    "watertight without triangles": lambda o3d: o3d.geometry.TriangleMesh().is_watertight(),
    # Vertices without triangles count.
    "Euler characteristic": lambda o3d: [mesh_of(o3d, *shape).euler_poincare_characteristic() for shape in FANS],
    "orientable": lambda o3d: [mesh_of(o3d, *shape).is_orientable() for shape in (FANS[0], FANS[3], CROSS)],
    "oriented": lambda o3d: [mesh_of(o3d, *shape).orient_triangles() for shape in (FANS[0], CROSS)],
    "version": lambda o3d: [int(part) for part in o3d.__version__.split(".")],
    "oriented box of columns": lambda o3d: corners(o3d.geometry.OrientedBoundingBox(-COLUMN, ROTATION, COLUMN)),
}


def edited_vertices(o3d):
    made = mesh(o3d)
    np.asarray(made.vertices)[:] *= 2
    return made


def joined(o3d, pairs):
    return o3d.geometry.LineSet.create_from_point_cloud_correspondences(cloud(o3d, 5, 1), cloud(o3d, 6, 2), pairs)


def corners(box):
    return np.array(box.get_box_points())


def turned_box(o3d):
    return o3d.geometry.OrientedBoundingBox([0, 0, 1], ROTATION, [1, 2, 3])


def box_points(box):
    """Corners in a defined order."""
    points = np.round(np.array(box.get_box_points()), 6) + 0.0
    return points[np.lexsort(points.T)]


def added_lines(o3d):
    colored, empty = joined(o3d, [(0, 1), (2, 3)]).paint_uniform_color([0, 0, 1]), o3d.geometry.LineSet()
    return colored + empty, empty + colored, colored + joined(o3d, [(0, 1)])


def scaled_normals(o3d):
    made = mesh(o3d)
    made.vertex_normals = o3d.utility.Vector3dVector(3 * np.asarray(made.vertex_normals))
    return made


def pair(o3d, translation):
    """Two cubes as one mesh; they share the vertices at which they touch."""
    box = o3d.geometry.TriangleMesh.create_box()
    return (box + o3d.geometry.TriangleMesh.create_box().translate(translation)).remove_duplicated_vertices()


def rgbd(o3d, dtype):
    """The color of an RGBDImage of a gray image that is not converted."""
    color, depth = np.arange(12).reshape(3, 4).astype(dtype), np.full((3, 4), 1000, np.uint16)
    images = o3d.geometry.Image(color), o3d.geometry.Image(depth)
    return np.array(o3d.geometry.RGBDImage.create_from_color_and_depth(*images, convert_rgb_to_intensity=False).color)


def poisson_height(o3d, **options):
    ball = o3d.geometry.TriangleMesh.create_sphere(1.0, 12).compute_vertex_normals()
    points = o3d.geometry.PointCloud(ball.vertices)
    points.normals = ball.vertex_normals
    surface, _ = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(points, **options)
    return np.round(surface.get_max_bound(), 1)


@pytest.fixture(scope="module")
def expected(oracle):
    return oracle("open3d/conventions", lambda o3d: {name: claim(o3d) for name, claim in CLAIMS.items()})


@pytest.mark.parametrize("name", CLAIMS)
def test_conventions_agree_with_open3d(name, expected):
    theirs, actual = expected[name], CLAIMS[name](bridge)
    if not isinstance(theirs, dict):
        theirs, actual = {name: theirs}, {name: actual}
    assert theirs.keys() == actual.keys()
    for part, values in theirs.items():
        np.testing.assert_allclose(actual[part], values, rtol=2e-6, atol=2e-6, err_msg=part)


def files(o3d, folder):
    """What writers return for incomplete shapes, and the vertices and normals of meshes that are read."""
    box, empty = o3d.geometry.TriangleMesh.create_box(), o3d.geometry.PointCloud()
    returned, bare = [], o3d.geometry.TriangleMesh()
    returned += [o3d.io.write_point_cloud(str(folder / f"a.{kind}"), empty) for kind in ("ply", "pcd", "xyzrgb")]
    returned += [o3d.io.write_triangle_mesh(str(folder / f"a.{kind}"), bare) for kind in ("ply", "off")]
    shapes = [box.compute_vertex_normals(), o3d.geometry.TriangleMesh.create_sphere(1, 4).compute_vertex_normals()]
    paths = [str(folder / name) for name in ("b.stl", "c.stl", "d.ply")]
    for path, shape in zip(paths[:2], shapes, strict=True):
        o3d.io.write_triangle_mesh(path, shape)
    o3d.io.write_point_cloud(paths[2], cloud(o3d))
    return returned, [arrays(o3d.io.read_triangle_mesh(path)) for path in paths]


@pytest.mark.filterwarnings("ignore:.*(not written|contains no faces)")
def test_files_agree_with_those_of_open3d(oracle, tmp_path):
    (stored, expected), (returned, actual) = oracle("open3d/files", files, tmp_path), files(bridge, tmp_path)
    assert returned == stored == [False] * 5 and [len(shape["vertices"]) for shape in actual] == [24, 112, 5]
    for shape, theirs in zip(actual, expected, strict=True):
        for name, values in theirs.items():
            np.testing.assert_allclose(shape[name], values, atol=2e-6, err_msg=name)


def test_incomplete_shapes_lose_no_data(tmp_path):
    with pytest.warns(UserWarning, match="not written"):
        assert not bridge.io.write_point_cloud(tmp_path / "a.ply", bridge.geometry.PointCloud())
    assert not (tmp_path / "a.ply").exists()
    assert bridge.io.write_triangle_mesh(tmp_path / "a.stl", bridge.geometry.TriangleMesh.create_box())
    assert len(bridge.io.read_triangle_mesh(tmp_path / "a.stl").triangles) == 12  # Open3D writes nothing
    bridge.io.write_point_cloud(tmp_path / "b.ply", cloud(bridge))
    with pytest.warns(UserWarning, match="contains no faces"):
        read = bridge.io.read_triangle_mesh(tmp_path / "b.ply")
    assert read.has_vertex_normals() and read.has_vertex_colors() and not read.has_triangles()


@pytest.mark.parametrize(("angle", "vertices"), [(0.0, 4), (5e-6, 4), (2e-4, 6), (0.1, 6)])
def test_corners_of_an_stl_are_one_vertex_if_their_normals_are_equal(tmp_path, angle, vertices):
    corners = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [-np.cos(angle), 0, np.sin(angle)]]
    triangles = bridge.utility.Vector3iVector([[0, 2, 1], [0, 1, 3]])
    mesh = bridge.geometry.TriangleMesh(bridge.utility.Vector3dVector(corners), triangles)
    bridge.io.write_triangle_mesh(tmp_path / "a.stl", mesh)
    read = bridge.io.read_triangle_mesh(tmp_path / "a.stl")
    assert len(read.vertices) == vertices
    placed = np.asarray(read.vertices)[np.asarray(read.triangles)]
    np.testing.assert_allclose(placed, np.asarray(corners)[np.asarray(triangles)], atol=1e-7)


@pytest.mark.parametrize(
    ("indices", "kind"),
    [([True], TypeError), (np.arange(4) < 3, TypeError), ([0.0], TypeError), ([-1], IndexError), ([9], IndexError)],
)
def test_invalid_index_lists_are_rejected(indices, kind):
    calls = [cloud(bridge).select_by_index, feature(bridge).select_by_index]
    calls += [getattr(bridge.geometry.TriangleMesh.create_tetrahedron(), name) for name in EDITS]
    for call in calls:
        with pytest.raises(kind, match="indices"):
            call(indices)
