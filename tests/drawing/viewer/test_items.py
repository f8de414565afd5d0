"""What the viewer makes of geometries before any page is there: coordinates, colours, surfaces, cameras, shares."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom
from pointloom.drawing.render.geometries import Style
from pointloom.drawing.render.view import View, fit_view
from pointloom.drawing.viewer.camera import camera_of, point_radius
from pointloom.drawing.viewer.coloring_choice import ColoringChoice, choices_of
from pointloom.drawing.viewer.items import Frame, make_item, quaternion, rotation, to_bytes
from pointloom.drawing.viewer.sessions import told
from pointloom.drawing.viewer.surfaces import (
    before_tone_mapping,
    edges_beside,
    linear_colors,
    surface_arrays,
    to_glb,
    tone_mapped,
)
from pointloom.drawing.viewer.whole_cloud import even_share
from pointloom.meshing.mesh.mesh_files import read_triangle_mesh

UTM = np.array([500_000.0, 5_600_000.0, 300.0])
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]


def turn(angle, axis=2):
    T = np.eye(4)
    a, b = [i for i in range(3) if i != axis]
    T[[a, b], [a, b]] = math.cos(angle)
    T[a, b], T[b, a] = -math.sin(angle), math.sin(angle)
    return T


# -- the page's coordinates -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1.0, 1e4, 1e9])
def test_a_scene_of_any_size_is_some_units_wide_in_the_page(scale):
    low, high = UTM * scale, UTM * scale + scale
    frame = Frame.around((low, high))
    ends = [frame.place(end, None)[1] for end in (low, high)]
    width = np.linalg.norm(ends[1] - ends[0])
    assert 0.05 <= width <= 1e5
    assert np.allclose(ends[0], -ends[1], rtol=1e-3)
    if scale == 1:
        assert frame.unit == 1


@given(st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi), st.floats(-math.pi, math.pi))
def test_a_rotation_comes_back_from_its_quaternion(a, b, c):
    R = (turn(a, 0) @ turn(b, 1) @ turn(c, 2))[:3, :3]
    assert np.allclose(rotation(quaternion(R)), R, atol=1e-12)


def test_a_pose_is_applied_about_the_world_s_zero_not_the_cloud_s():
    frame, T = Frame(UTM), turn(0.5)
    T[:3, 3] = [1, 2, 3]
    origin, local = UTM + np.array([10, 20, 30]), np.array([0.1, 0.2, 0.3])
    wxyz, position = frame.place(origin, T)
    seen = rotation(wxyz) @ local + position
    assert np.allclose(seen, T[:3, :3] @ (origin + local) + T[:3, 3] - UTM, atol=1e-9)


def test_poses_of_style_and_of_the_program_follow_each_other(rng):
    item = make_item("cloud", 0, loom.PointCloud(rng.random((50, 3))), Style(pose=turn(0.3)))
    item.pose = turn(0.4)
    assert np.allclose(item.pose_of(item.parts[0]), turn(0.7))
    low, high = item.world_bounds()
    assert (item.sample() >= low - 1e-6).all()
    assert (item.sample() <= high + 1e-6).all()


# -- clouds -----------------------------------------------------------------------------------------------------------


def test_an_array_and_an_object_with_points_are_clouds_too(rng):
    points = rng.random((20, 3))
    for given_as in (points, points.astype(np.float32), loom.PointCloud(points)):
        item = make_item("cloud", 0, given_as, Style())
        assert len(item.cloud) == 20
        assert np.allclose(item.cloud.points, points, atol=1e-6)


def test_what_is_no_point_cloud_has_no_cloud():
    assert make_item("mesh", 0, loom.TriangleMesh(SQUARE, FACES), Style()).cloud is None
    assert make_item("lines", 0, loom.LineSet(SQUARE, [[0, 1]]), Style()).cloud is None


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((4, 3), np.nan)])
def test_a_cloud_without_a_finite_point_has_no_bounds(points):
    assert make_item("cloud", 0, loom.PointCloud(points), Style()).bounds is None


def test_colors_out_of_range_are_cut():
    assert to_bytes([[-1, 0.5, 2], [np.nan, np.inf, -np.inf]]).tolist() == [[0, 128, 255], [0, 255, 0]]


def test_a_cloud_shows_its_own_colors_then_those_of_the_choice(rng):
    cloud = loom.PointCloud(rng.random((30, 3)), colors=np.tile([[1.0, 0, 0]], (30, 1)), label=np.arange(30) % 3)
    item = make_item("cloud", 0, cloud, Style())
    every = np.arange(30)
    assert (item.colors_of(every) == [255, 0, 0]).all()
    item.recolor(ColoringChoice("label").of(item))
    assert len(np.unique(item.colors_of(every), axis=0)) == 3
    assert (item.colors_of(every[:3]) == item.colors_of(every[3:6])).all()
    item.recolor(ColoringChoice("intensity").of(item))  # there is none
    assert (item.colors_of(every) == [255, 0, 0]).all()


def test_a_cloud_can_be_colored_by_what_it_has(rng):
    points = rng.random((5, 3))
    cloud = loom.PointCloud(points, normals=points, colors=points, intensity=points[:, 0], flow=points)
    assert choices_of(cloud) == ["rgb", "normal", "height", "x", "y", "intensity"]
    assert choices_of(loom.PointCloud(points)) == ["height", "x", "y"]


def test_a_choice_that_no_cloud_knows_names_those_that_there_are(rng):
    items = [make_item("cloud", 0, loom.PointCloud(rng.random((5, 3)), ring=np.arange(5)), Style())]
    with pytest.raises(ValueError, match="no cloud here has 'rings'; there are height, x, y, ring"):
        ColoringChoice().checked("rings", None, None, items)
    with pytest.raises(ValueError, match="colormap"):
        ColoringChoice().checked("ring", "rainbow", None, items)
    with pytest.raises(ValueError, match="limits"):
        ColoringChoice().checked("height", None, (1, 0), items)


def test_a_share_is_of_all_parts_of_a_cloud():
    assert even_share(100, 100) is None
    rows = even_share(10_000, 1000)
    assert len(np.unique(rows)) == 1000
    assert (np.diff(rows) > 0).all()
    assert np.ptp(np.histogram(rows, 10, (0, 10_000))[0]) <= 2


@pytest.mark.parametrize(
    ("drawn", "total", "text"),
    [
        (0, 0, "0 points"),
        (1234, 1234, "1,234 points"),
        (500, 1234, "500 of 1,234 points"),
        (2_000_000, 100_000_000, "2.0 of 100 million points"),
        (1_500_000, 1_500_000, "1.5 of 1.5 million points"),
        (2_000_000, 1_234_000_000, "2.0 of 1,234 million points"),
    ],
)
def test_the_page_says_how_many_points_it_draws(drawn, total, text):
    assert told(drawn, total) == text


# -- surfaces ---------------------------------------------------------------------------------------------------------


def read_back(data, tmp_path):
    (tmp_path / "sent.glb").write_bytes(data)
    return read_triangle_mesh(tmp_path / "sent.glb")


@pytest.mark.filterwarnings("ignore:.*what the extension KHR_materials")
def test_a_mesh_is_sent_whole(tmp_path, device):
    mesh = loom.TriangleMesh(np.array(SQUARE) + UTM, FACES, device=device).compute_vertex_normals()
    (part,) = make_item("mesh", 0, mesh, Style()).parts
    sent = read_back(to_glb(part), tmp_path)
    assert np.allclose(np.asarray(sent.vertices) + part.origin, mesh.vertices, atol=1e-6)
    assert np.asarray(sent.triangles).tolist() == FACES
    assert np.allclose(sent.vertex_normals, mesh.vertex_normals)


def test_colors_come_out_of_the_page_s_tone_mapping_as_they_are(rng):
    linear = linear_colors(0.35 + 0.4 * rng.random((200, 3)))
    assert np.allclose(tone_mapped(before_tone_mapping(linear)), linear, atol=1e-5)
    saturated = np.vstack([np.eye(3), 1 - np.eye(3), np.zeros((1, 3)), np.ones((1, 3))])
    seen = tone_mapped(before_tone_mapping(saturated))
    assert np.array_equal(seen > 0.3, saturated > 0.5)  # a pure green is darker, and no white
    assert seen[-1].min() > 0.89  # 243 of 255


def test_light_falls_on_all_but_photographs():
    part_of = lambda mesh, **style: make_item("mesh", 0, mesh, Style(**style)).parts[0]  # noqa: E731
    plain, colored = loom.TriangleMesh(SQUARE, FACES), loom.TriangleMesh(SQUARE, FACES, vertex_colors=np.ones((4, 3)))
    assert b"KHR_materials_unlit" not in to_glb(part_of(plain))
    assert b"KHR_materials_unlit" not in to_glb(part_of(colored))
    assert b"KHR_materials_unlit" in to_glb(part_of(colored, shaded=False))
    picture = {"triangle_uvs": np.zeros((6, 2)), "textures": [np.zeros((2, 2, 3), np.uint8)]}
    textured = loom.TriangleMesh(SQUARE, FACES, **picture)
    assert b"KHR_materials_unlit" in to_glb(part_of(textured))
    assert b"KHR_materials_unlit" not in to_glb(part_of(textured, shaded=True))
    assert b"KHR_materials_unlit" not in to_glb(part_of(textured, color=(1, 0, 0)))
    assert b'"doubleSided":true' in to_glb(part_of(plain))
    assert b'"doubleSided":false' in to_glb(part_of(plain, back_faces=False))


@pytest.mark.filterwarnings("ignore:.*what the extension KHR_materials")
def test_a_texture_goes_along(tmp_path):
    texture = np.arange(4 * 4 * 3, dtype=np.uint8).reshape(4, 4, 3)
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], np.float32)
    mesh = loom.TriangleMesh(SQUARE, FACES, triangle_uvs=uvs, textures=[texture])
    (part,) = make_item("mesh", 0, mesh, Style()).parts
    sent = read_back(to_glb(part), tmp_path)
    assert (sent.textures[0] == texture).all()
    assert np.allclose(sent.triangle_uvs, uvs)


def test_a_mesh_without_a_finite_triangle_is_not_sent():
    empty = loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert [to_glb(part) for part in make_item("mesh", 0, empty, Style()).parts] in ([], [None])
    holed = loom.TriangleMesh([*SQUARE[:3], [np.nan, 0, 0]], FACES)
    (part,) = make_item("mesh", 0, holed, Style()).parts
    positions, faces = surface_arrays(part)
    assert np.isfinite(positions).all()
    assert faces.tolist() == FACES[:1]


def test_edges_lie_on_both_sides_of_the_faces():
    (part,) = make_item("mesh", 0, loom.TriangleMesh(SQUARE, FACES), Style()).parts
    positions, faces = edges_beside(part, 0.01)
    assert len(faces) == 4
    assert sorted({round(float(z), 4) for z in positions[:, 2]}) == [-0.0141, 0.0141]


# -- cameras ----------------------------------------------------------------------------------------------------------


def seen_from(camera, frame, points, aspect):
    """Where points are in a page, -1 to 1, by the page's own way of placing its camera."""
    eye = camera.position * frame.unit + frame.origin
    forward = camera.look_at - camera.position
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, camera.up)
    right = right / np.linalg.norm(right)
    local = (points - eye) @ np.column_stack([right, np.cross(forward, right), forward])
    tan = math.tan(camera.fov / 2)
    return local[:, :2] / local[:, 2:] / [tan * aspect, tan]


def test_the_page_s_camera_sees_what_the_view_shows(rng):
    points = rng.random((40, 3)) + UTM
    bounds = points.min(axis=0), points.max(axis=0)
    frame = Frame.around(bounds)
    for direction in ((-0.65, 0.7, -0.75), (0.1, 0.2, -1), (1, 0, 0)):
        view = fit_view(points, direction=direction, up=(0, 1, 0.1), width=800, height=600)
        camera = camera_of(view, frame, bounds)
        local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
        expected = local[:, :2] / local[:, 2:] * [view.intrinsic.fx / 400, view.intrinsic.fy / 300]
        assert np.allclose(seen_from(camera, frame, points, 800 / 600), expected, atol=1e-6)


def test_a_narrow_page_sees_as_much_as_a_wide_one(rng):
    points = rng.random((40, 3))
    bounds = points.min(axis=0), points.max(axis=0)
    view = fit_view(points, width=1600, height=400)
    for aspect in (0.3, 1.0, 4.0, 8.0):
        camera = camera_of(view, Frame.around(bounds), bounds, aspect)
        assert np.abs(seen_from(camera, Frame.around(bounds), points, aspect)).max() < 1


def test_points_keep_their_size_on_the_screen():
    points = np.zeros((1, 3))
    sizes = []
    for distance in (1.0, 10.0):
        view = View.from_open3d(([-1, -1, -1], [1, 1, 1]), lookat=[0, 0, 0], zoom=distance, width=640, height=480)
        radius = point_radius(4.0, points, view, Frame(np.zeros(3)), 1.0)
        depth = view.T_world_camera[2, 3]
        sizes.append(2 * radius * view.intrinsic.fy / depth)
    assert np.allclose(sizes, 4.0)
