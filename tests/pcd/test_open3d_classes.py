"""Open3D's queries, aliases, assignments, copies and habits work for the corresponding pointloom classes."""

import copy
import io
import pickle
import warnings

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsicParameters
from pointloom.core.errors import DatasetError
from pointloom.visualization.render.picture import Picture

CAMERA = loom.PinholeCameraIntrinsic(8, 6, 8.0, 8.0, 3.5, 2.5)
COLOR = np.arange(8 * 6 * 3, dtype=np.uint8).reshape(6, 8, 3)
DEPTH = np.linspace(1, 2, 48, dtype=np.float32).reshape(6, 8)


@pytest.fixture
def shapes(device):
    mesh = loom.TriangleMesh.create_box(1, 2, 3, device=device)
    return {
        "cloud": loom.PointCloud(mesh.vertices, device=device),
        "mesh": mesh,
        "lines": loom.LineSet.create_from_triangle_mesh(mesh),
        "box": mesh.get_axis_aligned_bounding_box(),
        "turned": loom.OrientedBoundingBox([0.5, 1, 1.5], np.eye(3), [1, 2, 3]),
    }


@pytest.mark.parametrize("kind", ["cloud", "mesh", "lines", "box", "turned"])
def test_all_shapes_are_bounded_and_moved_alike(shapes, kind):
    shape, R = shapes[kind], np.array([[0, -1.0, 0], [1, 0, 0], [0, 0, 1]])
    assert shape.get_min_bound().tolist() == [0, 0, 0] and shape.get_max_bound().tolist() == [1, 2, 3]
    assert shape.get_center().tolist() == [0.5, 1, 1.5] and not shape.is_empty()
    for moved, low in (
        (shape.scale(2.0), [0, 0, 0]),
        (shape.scale(2.0, [0, 0, 0]), [0, 0, 0]),
        (shape.translate([0, 0, 1]), [0, 0, 1]),
        (shape.rotate(R, [0, 0, 0]), [-2, 0, 0]),
        (shape.rotate(R), [-0.5, 0.5, 0]),
    ):
        keeps_center = moved.get_center().tolist() == [0.5, 1, 1.5] and low == [0, 0, 0]
        expected = np.subtract(moved.get_center(), [1, 2, 3]) if keeps_center else low
        np.testing.assert_allclose(moved.get_min_bound(), expected, atol=1e-6)


def test_questions_may_be_called(shapes):
    cloud, mesh, lines = (shapes[name] for name in ("cloud", "mesh", "lines"))
    assert cloud.has_points() and not cloud.has_covariances()
    assert cloud.has_points() is True and cloud.has_points == True and repr(cloud.has_colors) == "False"  # noqa: E712
    assert cloud.estimate_covariances(max_nn=4).has_covariances() and not mesh.has_triangle_uvs
    assert mesh.has_vertices() and mesh.has_triangles() and not mesh.has_vertex_normals() and not mesh.has_textures()
    assert mesh.compute_vertex_normals().has_vertex_normals() and not mesh.has_vertex_colors
    assert lines.has_points() and lines.has_lines() and not lines.has_colors()
    for shape in (cloud, mesh, lines):
        assert shape.clear().is_empty() and not shape.is_empty
    with pytest.warns(loom.DroppedResultWarning, match=r"TriangleMesh\.clear:.*mesh\.clear"):
        mesh.clear()


def test_the_makers_have_open3d_names():
    for kind in (loom.PointCloud, loom.TriangleMesh, loom.RGBDImage):
        makers = {name for name in dir(kind) if name.startswith("from_")}
        assert makers <= {"from_dlpack", "from_open3d", "from_polygon"}
    rgbd = loom.RGBDImage.create_from_color_and_depth(COLOR, DEPTH)
    assert len(loom.PointCloud.create_from_rgbd_image(rgbd, CAMERA)) == 48
    grid = loom.VoxelGrid.create_from_triangle_mesh(loom.TriangleMesh.create_box(), 0.5)
    assert len(grid) == len(loom.TriangleMesh.create_box().voxelize(0.5))
    low = loom.VoxelGrid.create_from_triangle_mesh_within_bounds(loom.TriangleMesh.create_box(), 0.5, [0] * 3, [1] * 3)
    assert 0 < len(low) < len(grid)


def test_vertices_and_triangles_are_assigned(shapes):
    mesh = shapes["mesh"].compute_vertex_normals()
    mesh.vertices = mesh.vertices + np.array([5e5, 0, 0])
    assert mesh.get_min_bound().tolist() == [5e5, 0, 0] and mesh.origin[0] > 0
    mesh.triangles = mesh.triangles[:4]
    assert len(mesh) == 4 and mesh.has_vertex_normals
    mesh.triangle_normals = mesh.triangle_normals
    other = loom.TriangleMesh(device=mesh.device)
    other.vertices, other.triangles, other.vertex_normals = mesh.vertices, mesh.triangles, mesh.vertex_normals
    assert len(other) == 4 and np.array_equal(other.vertices, mesh.vertices)


def test_a_cloud_is_an_array_of_its_points(shapes):
    cloud = shapes["cloud"]
    cloud.colors, cloud.normals = cloud.points / 3, cloud.points
    del cloud.colors, cloud.normals
    assert not cloud.has_colors and not cloud.has_normals
    np.testing.assert_array_equal(np.asarray(cloud), cloud.points)
    assert np.asarray(cloud, np.float32).dtype == np.float32 and np.array(cloud).flags.writeable
    assert np.linalg.norm(cloud, axis=1).shape == (8,)


def test_cameras_are_made_as_open3d_makes_them():
    made = loom.PinholeCameraIntrinsic(PinholeCameraIntrinsicParameters.PrimeSenseDefault)
    assert made == loom.PinholeCameraIntrinsic.prime_sense_default()
    assert loom.PinholeCameraIntrinsic(8, 6, CAMERA.matrix) == CAMERA == pickle.loads(pickle.dumps(CAMERA))
    np.testing.assert_array_equal(made.intrinsic_matrix, made.matrix)
    assert made.get_focal_length() == (525, 525) and made.get_principal_point() == (319.5, 239.5) and made.is_valid()
    assert made.set_intrinsics(8, 6, 8, 8, 3.5, 2.5) == CAMERA and made.get_skew() == 0
    with pytest.raises(TypeError, match="width, height, fx, fy, cx, cy:"):
        loom.PinholeCameraIntrinsic()
    with pytest.raises(TypeError, match="cx, cy:"):
        loom.PinholeCameraIntrinsic(8, 6, 8.0, 8.0)


@pytest.mark.parametrize("take", [copy.copy, copy.deepcopy, lambda image: pickle.loads(pickle.dumps(image))])
def test_images_and_scenes_are_copied(take, device):
    for image in (
        loom.RGBDImage(COLOR, DEPTH, device=device),
        loom.RGBDImage.create_from_color_and_depth(COLOR, DEPTH, device=device),
    ):
        other = take(image)
        np.testing.assert_array_equal(other.color, image.color)
        np.testing.assert_array_equal(other.depth, image.depth)
        assert repr(other) == repr(image)
    scene = loom.RaycastingScene(device)
    scene.add_triangles(loom.TriangleMesh.create_box(device=device))
    lifted = np.eye(4)
    lifted[2, 3] = 5
    scene.add_instance(0, lifted)
    other, ray = take(scene), [[0.5, 0.5, 10, 0, 0, -1]]
    assert other.cast_rays(ray)["t_hit"].tolist() == scene.cast_rays(ray)["t_hit"].tolist() == [4]
    assert other.compute_signed_distance([[0.5, 0.5, 0.5]]).tolist() == [-0.5]
    other.set_pose(1, np.eye(4))
    assert scene.cast_rays(ray)["t_hit"].tolist() == [4] and other.cast_rays(ray)["t_hit"].tolist() == [9]


def test_image_has_a_notebook_repr(shapes, tmp_path):
    picture = loom.render(shapes["mesh"], size=(32, 24))
    assert repr(picture) == "Picture(32 x 24)" and isinstance(picture, Picture)
    np.testing.assert_array_equal(np.asarray(Image.open(io.BytesIO(picture._repr_png_()))), picture)
    assert picture[:10]._repr_png_() and picture[..., 0]._repr_png_() is None and picture._repr_jpeg_() is None
    noise = Picture(np.random.default_rng(0).integers(0, 256, (900, 1000, 3), np.uint8))
    assert noise._repr_png_() is None and 50_000 < len(noise._repr_jpeg_() or b"") <= 200_000
    assert isinstance(np.hstack([picture, np.asarray(picture)]), Picture)
    assert type(picture / 2) is np.ndarray and type(picture.mean(axis=2)) is np.ndarray and picture.max() <= 255
    loom.write_image(tmp_path / "a.png", picture)
    np.testing.assert_array_equal(loom.read_color(tmp_path / "a.png"), picture)


def test_a_volume_takes_an_image_as_open3d_does(device):
    rgbd = loom.RGBDImage(COLOR, DEPTH * 4, depth_trunc=10, device=device)
    volume, other = (loom.TSDFVolume(voxel_size=0.1, device=device) for _ in range(2))
    assert volume.integrate(rgbd, CAMERA, np.eye(4)) == other.integrate(DEPTH * 4, CAMERA, np.eye(4), COLOR, None, 10)
    result, same = (one.extract_point_cloud(weight_threshold=0) for one in (volume, other))
    np.testing.assert_array_equal(result.points, same.points)
    np.testing.assert_array_equal(result.colors, same.colors)
    gray = loom.RGBDImage.create_from_color_and_depth(COLOR, DEPTH, device=device)
    with pytest.raises(TypeError, match=r"^depth:.*convert_rgb_to_intensity"):
        volume.integrate(gray, CAMERA, np.eye(4))
    plain = loom.TSDFVolume(voxel_size=0.1, color=False, device=device)
    assert plain.integrate(gray, CAMERA, np.eye(4)) > 0


def test_the_tilde_is_the_home(tmp_path, monkeypatch, shapes):
    monkeypatch.setenv("HOME", str(tmp_path))
    (tmp_path / "in").mkdir()
    mesh, cloud, picture = shapes["mesh"].compute_uvatlas(64), shapes["cloud"], Picture(COLOR)
    mesh.textures = [COLOR]
    loom.write_point_cloud("~/in/a.ply", cloud)
    assert len(loom.read_point_cloud("~/in/a.ply")) == 8
    loom.write_triangle_mesh("~/in/a.obj", mesh)
    assert loom.read_triangle_mesh("~/in/a.obj").has_textures
    loom.write_image("~/in/a.png", picture)
    assert loom.read_color("~/in/a.png").shape == COLOR.shape
    CAMERA.write("~/in/camera.json")
    assert loom.PinholeCameraIntrinsic.read("~/in/camera.json") == CAMERA
    loom.write_trajectory("~/in/path.log", loom.Trajectory(np.eye(4)[None]))
    assert len(loom.read_trajectory("~/in/path.log").poses) == 1
    assert sorted(path.name for path in (tmp_path / "in").iterdir()) == [
        "a.mtl", "a.obj", "a.ply", "a.png", "a_0.png", "camera.json", "path.log",
    ]  # fmt: skip
    with pytest.raises(loom.FileError, match=f"{tmp_path}/in/b.ply: does not exist"):
        loom.read_point_cloud("~/in/b.ply")
    with pytest.raises(DatasetError, match="/nowhere:"):
        loom.open_frames("~/nowhere")


@pytest.fixture
def cloud(device, rng):
    return loom.PointCloud(rng.random((60, 3)), colors=rng.random((60, 3)), label=np.arange(60), device=device)


def test_printed_representations_are_accepted(cloud, capsys):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(compile("cloud.estimate_normals()\n", "<prompt>", "single"), {"cloud": cloud})
    assert "PointCloud(60 points, colors, label, normals" in capsys.readouterr().out


def test_the_warning_names_the_line_that_drops_the_result(cloud):
    with pytest.warns(loom.DroppedResultWarning, match=r"PointCloud\.flip_normals:.*cloud\.flip_normals") as caught:
        shaded = cloud.estimate_normals()
        shaded.flip_normals()
    assert caught[0].filename == __file__


def test_attributes_of_the_cloud(cloud):
    cloud.attributes["intensity"] = np.linspace(0, 1, 60)
    assert list(cloud.attributes) == ["label", "intensity"] and "intensity" in cloud
    np.testing.assert_array_equal(cloud["intensity"], np.linspace(0, 1, 60))
    del cloud.attributes["label"]
    assert dict(cloud.attributes).keys() == {"intensity"} and len(cloud.attributes) == 1
    assert "label" not in cloud and "float64 [60]" in repr(cloud.attributes)
    with pytest.raises(ValueError, match="ring:"):
        cloud.attributes["ring"] = [1, 2]
    for name in ("points", "normals", "label"):
        with pytest.raises(KeyError):
            cloud.attributes[name]
        with pytest.raises(KeyError):
            del cloud.attributes[name]
    with pytest.raises(KeyError, match=r"assign cloud\.colors"):
        cloud.attributes["colors"] = np.zeros((60, 3))


def test_attributes_are_dropped_by_name(cloud):
    bare = cloud.without("colors", "label")
    assert not bare.has_colors and not len(bare.attributes) and cloud.has_colors
    with pytest.raises(ValueError, match="the cloud has no rings: the cloud has points, colors, label"):
        cloud.without("rings")
    with pytest.raises(ValueError, match="points:"):
        cloud.without("points")


@pytest.mark.parametrize("far", [0.0, 5e5])
def test_translating_turning_and_scaling_follow_open3d(device, rng, far):
    points, R = rng.random((50, 3)) + far, np.array([[0, -1.0, 0], [1, 0, 0], [0, 0, 1]])
    normals = rng.normal(size=(50, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    middle, corner = points.mean(axis=0), np.array([far, far, 1])
    np.testing.assert_allclose(cloud.get_center(), middle, atol=1e-7)
    for moved, expected, rotation in (
        (cloud.translate([1, 2, 3]), points + np.array([1, 2, 3]), np.eye(3)),
        (cloud.translate([1, 2, 3], relative=False), points - middle + [1, 2, 3], np.eye(3)),
        (cloud.rotate(R), (points - middle) @ R.T + middle, R),
        (cloud.rotate(R, center=corner), (points - corner) @ R.T + corner, R),
        (cloud.scale(3.0, corner), 3 * (points - corner) + corner, np.eye(3)),
        (cloud.scale(3.0), 3 * (points - middle) + middle, np.eye(3)),
    ):
        np.testing.assert_allclose(moved.points, expected, atol=1e-6)
        np.testing.assert_allclose(moved.normals, normals @ rotation.T, atol=1e-6)


def test_points_that_are_not_finite_do_not_move_the_middle(device):
    cloud = loom.PointCloud([[0, 0, 0], [2, 0, 0], [np.nan, 0, 0]], device=device)
    assert cloud.get_center().tolist() == [1, 0, 0]
    assert loom.PointCloud(device=device).get_center().tolist() == [0, 0, 0]


def test_a_single_query_has_a_single_answer(cloud, device):
    search = loom.NearestNeighborSearch(cloud)
    one, rows = search.knn_search([0.5, 0.5, 0.5], 4), search.knn_search([[0.5, 0.5, 0.5]], 4)
    assert one.indices.shape == one.sqdists.shape == (4,) and one.counts == 4
    np.testing.assert_array_equal(one.indices, rows.indices[0])
    near = search.radius_search((0.5, 0.5, 0.5), 0.4)
    np.testing.assert_array_equal(near.indices, search.radius_search([[0.5, 0.5, 0.5]], 0.4).indices)
    assert near.counts == len(near.indices)
    assert search.hybrid_search(np.full(3, 0.5), 0.4, 3).indices.shape == (3,)


def test_missing_neighbors_are_infinitely_far(device):
    search = loom.NearestNeighborSearch([[0, 0, 0], [1, 0, 0]], device=device)
    result = search.knn_search([[0, 0, 0], [np.nan, 0, 0]], 3)
    assert result.indices.tolist() == [[0, 1, -1], [-1, -1, -1]]
    assert result.sqdists.tolist() == [[0, 1, np.inf], [np.inf] * 3]
    assert search.hybrid_search([0, 0, 0], 0.5, 2).sqdists.tolist() == [0, np.inf]
