"""What users of Open3D write by habit works, or says what to write: nothing is a silent no-op."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import pointloom as loom


@pytest.fixture
def cloud(device, rng):
    return loom.PointCloud(rng.random((60, 3)), colors=rng.random((60, 3)), label=np.arange(60), device=device)


# ------------------------------------------------------------------------------------------------ dropped results

DROPPED = [
    "cloud.estimate_normals()",
    "cloud.estimate_normals(radius=0.5, max_nn=30)",
    "cloud.estimate_covariances()",
    "cloud.paint_uniform_color([1, 0, 0])",
    "cloud.transform(np.eye(4))",
    "cloud.translate([0, 0, 1])",
    "cloud.rotate(np.eye(3))",
    "cloud.scale(2.0)",
    "cloud.scale(**{'scale': 2.0})",
    "cloud.remove_non_finite_points()",
    "cloud.remove_duplicated_points()",
    "cloud.get_axis_aligned_bounding_box().translate([0, 0, 1])",
    "loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).compute_vertex_normals()",
    "loom.registration.global_optimization(loom.registration.PoseGraph([loom.registration.PoseGraphNode(np.eye(4))]))",
]


USES = ["taken = {}", "print(repr({}), end='')", "taken = [{} for _ in range(2)]", "assert len([{}])"]


@pytest.mark.parametrize("line", DROPPED)
def test_an_operation_whose_result_nobody_takes_warns(cloud, line):
    with pytest.warns(loom.DroppedResultWarning, match=r"the result is dropped; it returns a new object"):
        exec(line, {"cloud": cloud, "np": np, "loom": loom})


@pytest.mark.parametrize("line", DROPPED)
@pytest.mark.parametrize("use", USES)
def test_an_operation_whose_result_is_taken_does_not_warn(cloud, line, use):
    names = {"cloud": cloud, "np": np, "loom": loom, "print": lambda *_args, **_options: None}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(use.format(line), names)
        eval(line, names)


def test_what_an_interactive_prompt_shows_is_taken(cloud, capsys):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(compile("cloud.estimate_normals()\n", "<prompt>", "single"), {"cloud": cloud})
    assert "PointCloud(60 points, colors, label, normals" in capsys.readouterr().out


def test_the_warning_names_the_line_that_drops_the_result(cloud):
    with pytest.warns(loom.DroppedResultWarning, match=r"write cloud = cloud\.flip_normals\(\.\.\.\)") as caught:
        shaded = cloud.estimate_normals()
        shaded.flip_normals()
    assert caught[0].filename == __file__


# ------------------------------------------------------------------------------------------------ arrays and names


@pytest.mark.parametrize(
    "line",
    [
        "cloud.points[0] = 9",
        "np.asarray(cloud.points)[:, 2] *= 2",
        "cloud.colors[:] = 0",
        "cloud['label'][0] = 7",
        "cloud.attributes['label'][0] = 7",
        "cloud.get_axis_aligned_bounding_box().min_bound[0] = 1",
    ],
)
def test_writing_into_what_was_read_is_an_error(cloud, line):
    with pytest.raises(ValueError, match="read-only"):
        exec(line, {"cloud": cloud, "np": np})


def test_a_changed_copy_is_assigned(cloud):
    points = cloud.points.copy()
    points[:, 2] *= 2
    cloud.points = points
    np.testing.assert_allclose(cloud.points, points, atol=1e-6)


def test_the_attributes_are_those_of_the_cloud(cloud):
    cloud.attributes["intensity"] = np.linspace(0, 1, 60)
    assert list(cloud.attributes) == ["label", "intensity"] and "intensity" in cloud
    np.testing.assert_array_equal(cloud["intensity"], np.linspace(0, 1, 60))
    del cloud.attributes["label"]
    assert dict(cloud.attributes).keys() == {"intensity"} and len(cloud.attributes) == 1
    assert "label" not in cloud and "float64 [60]" in repr(cloud.attributes)
    with pytest.raises(ValueError, match=r"ring: expected shape \[60\]"):
        cloud.attributes["ring"] = [1, 2]
    for name in ("points", "normals", "label"):
        with pytest.raises(KeyError):
            cloud.attributes[name]
        with pytest.raises(KeyError):
            del cloud.attributes[name]
    with pytest.raises(KeyError, match=r"assign cloud\.colors"):
        cloud.attributes["colors"] = np.zeros((60, 3))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("cloud.color = [1, 0, 0]", r"PointCloud has no attribute 'color'; did you mean 'colors'\? .*cloud\['color'\]"),
        ("cloud.foo = 3", r"PointCloud has no attribute 'foo'; An attribute of the points is added by cloud\['foo'\]"),
        ("cloud.normal", r"PointCloud has no attribute 'normal'; did you mean 'normals'\?"),
        ("cloud.create_from_depth_imag", r"did you mean 'create_from_depth_image'\?"),
        ("mesh.vertex_color = 1", r"TriangleMesh has no attribute 'vertex_color'; did you mean 'vertex_colors'\?"),
        ("box.colour = (1, 0, 0)", r"AxisAlignedBoundingBox has no attribute 'colour'; did you mean 'color'\?"),
        ("loom.PointClouds", r"module 'pointloom' has no attribute 'PointClouds'; did you mean 'PointCloud'\?"),
        ("loom.geometry", r"'geometry'; here: loom itself: open3d\.geometry\.PointCloud is loom\.PointCloud"),
        ("loom.registration.registration_ipc", r"did you mean 'registration_icp'\?"),
    ],
)
def test_an_unknown_name_is_an_error_that_names_the_nearest(cloud, line, message):
    mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    names = {"cloud": cloud, "mesh": mesh, "box": loom.AxisAlignedBoundingBox(), "loom": loom}
    with pytest.raises(AttributeError, match=message):
        exec(line, names)


def test_what_is_assigned_by_its_name_still_is(cloud):
    cloud.normals = np.tile([0.0, 0, 1], (60, 1))
    cloud.grid = (6, 10)
    box = cloud.get_axis_aligned_bounding_box()
    box.color = (1, 0, 0)
    assert cloud.has_normals and cloud.grid == (6, 10) and box.color.tolist() == [1, 0, 0]
    assert not hasattr(cloud, "nothing") and getattr(cloud, "nothing", 5) == 5


# ------------------------------------------------------------------------------------------------ small questions


def test_questions_are_answered_with_and_without_a_call(cloud, device):
    assert cloud.has_colors and cloud.has_colors() is True and cloud.has_colors == True  # noqa: E712
    assert not cloud.has_normals and cloud.has_normals() is False and repr(cloud.has_normals) == "False"
    assert not cloud.is_empty and loom.PointCloud(device=device).is_empty()


def test_attributes_are_dropped_by_name(cloud):
    bare = cloud.without("colors", "label")
    assert not bare.has_colors and not len(bare.attributes) and cloud.has_colors
    with pytest.raises(ValueError, match="the cloud has no rings: the cloud has points, colors, label"):
        cloud.without("rings")
    with pytest.raises(ValueError, match=r"points: a cloud without points is PointCloud\(\)"):
        cloud.without("points")


def test_a_notebook_shows_what_a_cloud_holds(cloud):
    html = cloud._repr_html_()
    assert "<caption>PointCloud(60 points, colors, label, " in html
    assert "<td>points</td><td>float32 [60, 3]</td>" in html and "<td>label</td><td>int64 [60]</td>" in html
    assert "float32 [0, 3]" in loom.PointCloud(device=cloud.device)._repr_html_()


# ------------------------------------------------------------------------------------------------ motion


@pytest.mark.parametrize("far", [0.0, 5e5])
def test_translating_turning_and_scaling_follow_open3d(device, rng, far):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    points, R = rng.random((50, 3)) + far, np.array([[0, -1.0, 0], [1, 0, 0], [0, 0, 1]])
    normals = rng.normal(size=(50, 3)).astype(np.float32)
    ours = loom.PointCloud(points, normals=normals, device=device)
    np.testing.assert_allclose(ours.get_center(), points.mean(axis=0), atol=1e-7)

    def theirs():
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
        cloud.normals = o3d.utility.Vector3dVector(normals.astype(np.float64))
        return cloud

    for moved, expected in (
        (ours.translate([1, 2, 3]), theirs().translate([1, 2, 3])),
        (ours.translate([1, 2, 3], relative=False), theirs().translate([1, 2, 3], relative=False)),
        (ours.rotate(R), theirs().rotate(R)),
        (ours.rotate(R, center=[far, far, 1]), theirs().rotate(R, center=[far, far, 1])),
        (ours.scale(3.0, [far, far, far]), theirs().scale(3.0, [far, far, far])),
        (ours.scale(3.0), theirs().scale(3.0, points.mean(axis=0))),
    ):
        np.testing.assert_allclose(moved.points, np.asarray(expected.points), atol=1e-6)
        np.testing.assert_allclose(moved.normals, np.asarray(expected.normals), atol=1e-6)


def test_points_that_are_not_finite_do_not_move_the_middle(device):
    cloud = loom.PointCloud([[0, 0, 0], [2, 0, 0], [np.nan, 0, 0]], device=device)
    assert cloud.get_center().tolist() == [1, 0, 0]
    assert loom.PointCloud(device=device).get_center().tolist() == [0, 0, 0]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("cloud.translate([1, 2])", r"translation: expected shape \[3\], got \[2\]"),
        ("cloud.translate([1, 2, float('nan')])", "translation: expected finite numbers"),
        ("cloud.rotate([[2, 0, 0], [0, 1, 0], [0, 0, 1]])", "R: expected a rigid motion"),
        ("cloud.scale(0)", "scale: expected a finite number > 0"),
        ("cloud.scale(2, [0, 0])", r"center: expected shape \[3\]"),
    ],
)
def test_wrong_motions_are_refused(cloud, line, message):
    with pytest.raises(ValueError, match=message):
        exec(f"_ = {line}", {"cloud": cloud})


# ------------------------------------------------------------------------------------------------ search


def test_a_single_query_has_a_single_answer(cloud, device):
    search = loom.NearestNeighborSearch(cloud)
    one, rows = search.knn_search([0.5, 0.5, 0.5], 4), search.knn_search([[0.5, 0.5, 0.5]], 4)
    assert one.indices.shape == one.sqdists.shape == (4,) and one.counts == 4
    np.testing.assert_array_equal(one.indices, rows.indices[0])
    near = search.radius_search((0.5, 0.5, 0.5), 0.4)
    np.testing.assert_array_equal(near.indices, search.radius_search([[0.5, 0.5, 0.5]], 0.4).indices)
    assert near.counts == len(near.indices)
    assert search.hybrid_search(np.full(3, 0.5), 0.4, 3).indices.shape == (3,)


def test_missing_neighbours_are_infinitely_far(device):
    search = loom.NearestNeighborSearch([[0, 0, 0], [1, 0, 0]], device=device)
    found = search.knn_search([[0, 0, 0], [np.nan, 0, 0]], 3)
    assert found.indices.tolist() == [[0, 1, -1], [-1, -1, -1]]
    assert found.sqdists.tolist() == [[0, 1, np.inf], [np.inf] * 3]
    assert search.hybrid_search([0, 0, 0], 0.5, 2).sqdists.tolist() == [0, np.inf]


# ------------------------------------------------------------------------------------------------ doors


def test_the_doors_to_data_sets_are_public():
    for name in (
        "open_dataset", "read_trajectory", "write_trajectory", "Trajectory", "read_pinhole_camera_intrinsic",
        "write_pinhole_camera_intrinsic", "read_depth", "read_color",
    ):  # fmt: skip
        assert callable(getattr(loom, name)) and name in loom.__all__
