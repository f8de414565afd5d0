"""Geometries before they are sent to pages: coordinates, colors, cameras; and rejected arguments of the viewer."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.visualization.render.styles import Style
from pointloom.visualization.render.view import fit_view
from pointloom.visualization.viewer.camera import camera_limits, camera_of, view_of
from pointloom.visualization.viewer.coloring_choice import ColoringChoice, choices_of
from pointloom.visualization.viewer.extents import Extents
from pointloom.visualization.viewer.items import Frame, make_item, to_bytes
from pointloom.visualization.viewer.link import CameraState
from pointloom.visualization.viewer.sessions import counts_text
from pointloom.visualization.viewer.surfaces import line_arrays, surface_arrays

from ...hostile import faults_of, hostile_clouds, read_table, warnings_of
from .stand_in import page_in

UTM = np.array([500_000.0, 5_600_000.0, 300.0])
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
FACES = [[0, 1, 2], [0, 2, 3]]


def rotation_about(angle, axis=2):
    T = np.eye(4)
    a, b = [i for i in range(3) if i != axis]
    T[[a, b], [a, b]] = math.cos(angle)
    T[a, b], T[b, a] = -math.sin(angle), math.sin(angle)
    return T


def test_poses_of_style_and_of_the_program_follow_each_other(rng):
    item = make_item("cloud", 0, loom.PointCloud(rng.random((50, 3))), Style(pose=rotation_about(0.3)))
    item.pose = rotation_about(0.4)
    assert np.allclose(item.pose_of(item.parts[0]), rotation_about(0.7))
    low, high = item.world_bounds()
    assert ((low - 1e-6 <= item.sample()) & (item.sample() <= high + 1e-6)).all()


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


def test_a_cloud_can_be_colored_by_its_attributes(rng):
    points = rng.random((5, 3))
    cloud = loom.PointCloud(points, normals=points, colors=points, intensity=points[:, 0], flow=points)
    assert choices_of(cloud) == ["rgb", "normal", "height", "x", "y", "intensity"]
    assert choices_of(loom.PointCloud(points)) == ["height", "x", "y"]


@pytest.mark.parametrize(
    ("drawn", "total", "triangles", "text"),
    [
        (0, 0, 0, ""),
        (0, 0, 70_000, "70,000 triangles"),
        (0, 3, 1, "0 of 3 points, 1 triangle"),
        (1234, 1234, 0, "1,234 points"),
        (500, 1234, 12, "500 of 1,234 points, 12 triangles"),
        (2_000_000, 100_000_000, 0, "2.0 of 100 million points"),
        (1_500_000, 1_500_000, 0, "1.5 of 1.5 million points"),
        (2_000_000, 1_234_000_000, 0, "2.0 of 1,234 million points"),
    ],
)
def test_the_page_reports_the_numbers_of_drawn_points_and_triangles(drawn, total, triangles, text):
    assert counts_text(drawn, total, triangles) == text


def arrays_of(mesh, **style):
    (part,) = make_item("mesh", 0, mesh, Style(**style)).parts
    return part, surface_arrays(part)


def test_a_mesh_is_sent_completely(device):
    mesh = loom.TriangleMesh(np.array(SQUARE) + UTM, FACES, device=device).compute_vertex_normals()
    part, sent = arrays_of(mesh)
    assert np.allclose(sent["positions"] + part.origin, mesh.vertices, atol=1e-6)
    assert sent["indices"].tolist() == FACES
    assert np.allclose(sent["normals"], mesh.vertex_normals)


def test_a_mesh_has_its_vertex_colors_or_the_default_warm_gray():
    assert arrays_of(loom.TriangleMesh(SQUARE, FACES))[1]["plain"].tolist() == [204, 199, 189]
    colored = loom.TriangleMesh(SQUARE, FACES, vertex_colors=np.tile([[1, 0, 0.5]], (4, 1)))
    assert arrays_of(colored)[1]["colors"].tolist() == [[255, 0, 128]] * 4
    assert "plain" not in arrays_of(colored)[1]
    assert arrays_of(colored, color=(0, 1, 0))[1]["plain"].tolist() == [0, 255, 0]


def test_light_falls_on_all_but_photographs():
    plain, colored = loom.TriangleMesh(SQUARE, FACES), loom.TriangleMesh(SQUARE, FACES, vertex_colors=np.ones((4, 3)))
    picture = {"triangle_uvs": np.zeros((6, 2)), "textures": [np.zeros((2, 2, 3), np.uint8)]}
    textured = loom.TriangleMesh(SQUARE, FACES, **picture)
    lit = lambda mesh, **style: arrays_of(mesh, **style)[1]["lit"]  # noqa: E731
    assert lit(plain) and lit(colored) and lit(textured, shaded=True) and lit(textured, color=(1, 0, 0))
    assert not lit(colored, shaded=False) and not lit(textured)
    assert not arrays_of(plain)[1]["cull"] and arrays_of(plain, back_faces=False)[1]["cull"]


def test_a_texture_goes_along():
    texture = np.arange(4 * 4 * 3, dtype=np.uint8).reshape(4, 4, 3)
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]], np.float32)
    part, sent = arrays_of(loom.TriangleMesh(SQUARE, FACES, triangle_uvs=uvs, textures=[texture]))
    assert (sent["texture"] == texture).all()
    assert np.allclose(sent["uvs"], np.stack([uvs[:, 0], 1 - uvs[:, 1]], axis=1))  # the page's v runs down
    corners = sent["positions"][sent["indices"].ravel()] + part.origin
    assert (corners == np.array(SQUARE)[np.ravel(FACES)]).all()


def test_non_finite_points_are_not_sent():
    empty = loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert [surface_arrays(part) for part in make_item("mesh", 0, empty, Style()).parts] in ([], [None])
    _, holed = arrays_of(loom.TriangleMesh([*SQUARE[:3], [np.nan, 0, 0]], FACES))
    assert np.isfinite(holed["positions"]).all() and holed["indices"].tolist() == FACES[:1]
    (lines,) = make_item("lines", 0, loom.LineSet(SQUARE, [[0, 1], [2, 3], [1, 2]]), Style()).parts
    positions = np.array([*SQUARE[:3], [np.nan] * 3], np.float32)
    part = dataclasses.replace(lines, positions=upload(positions, vec3, lines.positions.device))
    assert line_arrays(part)["ends"].tolist() == [SQUARE[:2], [SQUARE[1], SQUARE[2]]]


def seen_from(camera, frame, points, aspect):
    """Positions of points in a page, -1 to 1."""
    local = (points - frame.to_world(camera.position)) @ camera.rotation
    tan = math.tan(camera.fov / 2)
    return local[:, :2] / local[:, 2:] / [tan * aspect, tan]


def test_the_page_camera_matches_the_view(rng):
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


@pytest.mark.parametrize("zoom", [1.0, 0.01])
def test_an_orthographic_camera_matches_a_very_distant_view(rng, zoom):
    points = rng.random((40, 3)) + UTM
    bounds = points.min(axis=0), points.max(axis=0)
    frame, size = Frame.around(bounds), (800, 600)
    camera = camera_of(fit_view(points, width=800, height=600), frame, bounds)
    depth = zoom * (camera.pivot - camera.position) @ camera.rotation[:, 2]
    near = CameraState(
        camera.pivot - depth * camera.rotation[:, 2], camera.rotation, camera.fov, size, camera.pivot, orthographic=True
    )
    view = view_of(near, frame, bounds, size)
    local = (points - frame.to_world(camera.pivot)) @ camera.rotation
    expected = local[:, :2] / depth * (300 / math.tan(camera.fov / 2))  # the page's scale, at the depth of its pivot
    camera_points = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    pixels = camera_points[:, :2] / camera_points[:, 2:] * view.intrinsic.fx
    shown = (np.abs(expected) < [400, 300]).all(axis=1)
    assert np.abs(pixels - expected)[shown].max(initial=0) < 1
    assert zoom < 1 or shown.mean() > 0.8


@pytest.mark.parametrize("distance", [1.0, 600.0])
def test_the_scene_is_between_the_near_and_far_planes(distance):
    camera = CameraState(np.array([0, 0, -distance]), np.eye(3), 1.0, (800, 600), np.zeros(3))
    limits = camera_limits(camera, Frame(np.zeros(3)), (np.full(3, -0.5), np.full(3, 0.5)))
    assert limits["near"] < distance - 0.5 and distance + 0.5 < limits["far"]
    assert limits["closest"] < distance < limits["farthest"]
    assert limits["far"] / limits["near"] <= 1e5


def test_the_union_is_that_of_all_boxes_after_each_of_many_changes(rng):
    extents, boxes = Extents(), {}
    for _ in range(400):
        name = f"box {rng.integers(40)}"
        if rng.random() < 0.3:
            extents.drop(name)
            boxes.pop(name, None)
        else:
            low = rng.integers(-5, 5, 3).astype(float)
            boxes[name] = low, low + rng.integers(0, 3, 3)
            extents.put(name, boxes[name])
        union = extents.union()
        assert len(extents) == len(boxes)
        if not boxes:
            assert union is None
            continue
        assert (union[0] == np.min([low for low, _ in boxes.values()], axis=0)).all()
        assert (union[1] == np.max([high for _, high in boxes.values()], axis=0)).all()
    corners = extents.corners()
    assert corners.shape == (8 * len(boxes), 3)
    assert {tuple(corner) for corner in corners} >= {tuple(low) for low, _ in boxes.values()}


CALLS = """
viewer.add(name="cloud", geometry=cloud, color=(1, 0, 0), color_by="height", colormap="jet", limits=(0, 1), point_size=2.0, line_width=1.0, pose=pose)
viewer.add_all(geometries=[cloud])
viewer.update(name="cloud", geometry=cloud)
viewer.remove(name="cloud")
viewer.set_pose(name="cloud", T=pose)
viewer.set_visible(name="cloud", visible=True)
viewer.set_view(view=None)
viewer.set_view(zoom=0.5, front=(0, 0, 1), lookat=(0, 0, 0), up=(0, 1, 0), field_of_view=60.0)
viewer.get_view(client=None)
viewer.color_by(by="height", colormap="jet", limits=(0, 1))
loom.Viewer(port=0, max_points=10, point_size=3.0, background=(1, 1, 1))
"""  # noqa: E501
CASES = []


for line in CALLS.strip().splitlines():
    ((function, expressions),) = read_table(line, {}).values()
    CASES += [(function, expressions, name) for name in expressions if name not in ("visible", "port")]


# Accepted names in messages.
WORDS = {"name": "geometries", "geometries": "points", "geometry": "geometries|points", "color_by": "by"}


@pytest.fixture(scope="module")
def viewer():
    with loom.Viewer(port=0) as viewer:
        yield viewer


@pytest.mark.parametrize(("function", "expressions", "argument"), CASES, ids=lambda value: str(value)[:24])
def test_a_hostile_value_is_refused_by_name(viewer, function, expressions, argument):
    check_argument(viewer, function, expressions, argument, every=False)


@pytest.mark.slow
@pytest.mark.parametrize(("function", "expressions", "argument"), CASES, ids=lambda value: str(value)[:24])
def test_all_hostile_values_are_refused_by_name(viewer, function, expressions, argument):
    check_argument(viewer, function, expressions, argument, every=True)


def check_argument(viewer, function, expressions, argument, every):
    cloud = loom.PointCloud(np.random.default_rng(0).random((60, 3)))
    things: dict[str, Any] = {"viewer": viewer, "loom": loom, "cloud": cloud, "pose": np.eye(4)}

    def call(**given: Any) -> None:
        viewer.clear()
        viewer.add("cloud", cloud)
        made = eval(function, things)(**given)
        if isinstance(made, loom.Viewer):
            made.close()

    good = {name: eval(value, things) for name, value in expressions.items()}
    call(**good)
    faults = faults_of(call, good, argument, also=WORDS.get(argument, ""), every=every)
    assert not faults, "\n".join(faults)


def test_clouds_of_all_kinds_are_shown_without_a_warning(viewer):
    with page_in(viewer):
        for title, cloud in hostile_clouds().items():

            def show(cloud=cloud):
                viewer.clear()
                viewer.add("cloud", cloud)
                viewer.show_normals(True)
                viewer.color_by("height")
                viewer.update("cloud", cloud)
                viewer.color_by(None)
                viewer.show_normals(False)

            assert warnings_of(show) == [], title
