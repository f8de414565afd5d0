"""Rendering: sizes of silhouettes, positions of colors and depths, bitwise reproducible images, rejected input."""

import contextlib
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.visualization.render.coloring import color_cloud
from pointloom.visualization.render.frame_views import view_scene

SMALL = (160, 120)
BLACK, WHITE = (0, 0, 0), (255, 255, 255)


def sphere(radius=1.0, rings=60, center=(0.0, 0.0, 0.0)):
    """A sphere with outward triangles."""
    theta, phi = np.meshgrid(np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False))
    points = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)
    i, j = np.meshgrid(np.arange(2 * rings), np.arange(rings), indexing="ij")
    a, b = i * (rings + 1) + j, ((i + 1) % (2 * rings)) * (rings + 1) + j
    triangles = np.concatenate([np.stack([a, a + 1, b], -1), np.stack([b, a + 1, b + 1], -1)]).reshape(-1, 3)
    normals = points.reshape(-1, 3)
    return SimpleNamespace(vertices=radius * normals + center, triangles=triangles, vertex_normals=normals)


def straight_view(distance, focal=200.0):
    """A camera on the negative z axis that looks along z."""
    T = np.eye(4)
    T[2, 3] = -distance
    return loom.View(loom.PinholeCameraIntrinsic(160, 120, focal, focal, 79.5, 59.5), T)


def coverage(image):
    """The area [px] of black shapes on a white image, with fractions at edges."""
    return (255 - image[..., 0].astype(float)).sum() / 255


def paint(geometry, color=BLACK, **style):
    return {"geometry": geometry, "color": color, "shaded": False, **style}


def test_a_sphere_has_the_silhouette_of_a_sphere(device):
    view, distance = straight_view(5.0), 5.0
    image = loom.render(paint(sphere()), view, device=device)
    expected = np.pi * 200.0**2 / (distance**2 - 1)  # the tangent cone of a sphere on the axis
    assert coverage(image) == pytest.approx(expected, rel=0.01)
    rows, columns = np.nonzero(image[..., 0] < 128)
    assert rows.mean() == pytest.approx(59.5, abs=0.1) and columns.mean() == pytest.approx(79.5, abs=0.1)


def ramp():
    """A tilted square whose red increases with x, and a view of it."""
    vertices = np.array([[-1.0, -1.0, 2.0], [1.0, -1.0, 6.0], [1.0, 1.0, 6.0], [-1.0, 1.0, 2.0]])
    view = loom.View(loom.PinholeCameraIntrinsic(160, 120, 60.0, 60.0, 79.5, 59.5), np.eye(4))
    return vertices, [[0, 2, 1], [0, 3, 2]], view


def x_of_ramp(columns):
    slope = (columns - 79.5) / 60  # x = 2 share - 1 is on the plane z = 4 + 2 x
    return 4 * slope / (1 - 2 * slope)


def test_vertex_colors_are_interpolated_in_perspective(device):
    vertices, triangles, view = ramp()
    colors = np.column_stack([(vertices[:, 0] + 1) / 2, np.zeros(4), np.zeros(4)])
    mesh = loom.TriangleMesh(vertices, triangles, vertex_colors=colors)
    columns = np.arange(60, 88)
    row = loom.render(mesh, view, shading="none", device=device)[59, columns, 0].astype(float) / 255
    assert row == pytest.approx((x_of_ramp(columns) + 1) / 2, abs=0.01)


def test_textures_are_read_between_their_pixels_in_perspective(device):
    vertices, triangles, view = ramp()
    texture = np.zeros((4, 256, 3), np.uint8)
    texture[..., 0] = np.arange(256)
    uvs = np.column_stack([(vertices[:, 0] + 1) / 2, (1 - vertices[:, 1]) / 2])[np.ravel(triangles)]
    mesh = loom.TriangleMesh(vertices, triangles, triangle_uvs=uvs, textures=[texture])
    columns = np.arange(60, 88)
    row = loom.render(mesh, view, device=device)[59, columns, 0].astype(float)
    assert row == pytest.approx(128 * (x_of_ramp(columns) + 1) - 0.5, abs=1.5)


def test_the_lower_left_corner_of_a_texture_is_its_last_row(device):
    texture = np.array([[WHITE, WHITE], [(255, 0, 0), WHITE]], np.uint8).repeat(20, axis=0).repeat(20, axis=1)
    vertices = [[-0.5, 0.5, 0], [0.5, 0.5, 0], [0.5, -0.5, 0], [-0.5, -0.5, 0]]  # lower left first in the image
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])[[0, 1, 2, 0, 2, 3]]
    mesh = loom.TriangleMesh(vertices, [[0, 1, 2], [0, 2, 3]], triangle_uvs=uvs, textures=[texture])
    image = loom.render(mesh, straight_view(5.0), device=device, background=BLACK)
    assert image[70, 70].tolist() == [255, 0, 0]
    assert image[50, 70].tolist() == image[70, 90].tolist() == list(WHITE)


def test_each_triangle_has_the_texture_of_its_material(device):
    vertices = [[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]]
    images = [np.full((2, 2, 4), color, np.uint8) for color in ((255, 0, 0, 255), (0, 255, 0, 255))]
    mesh = loom.TriangleMesh(vertices, [[0, 2, 1], [0, 3, 2]], triangle_uvs=np.zeros((6, 2)), textures=images)
    mesh.triangle_material_ids = [1, 0]
    image = loom.render(mesh, straight_view(5.0), device=device)
    assert image[52, 87].tolist() == [0, 255, 0] and image[67, 72].tolist() == [255, 0, 0]


def test_one_looks_into_a_closed_box_through_its_near_walls(device):
    inward = sphere()
    inward.triangles, inward.vertex_colors = inward.triangles[:, ::-1], np.clip(inward.vertices, 0, 1)
    options = {"shading": "none", "device": device}
    culled = loom.render(inward, straight_view(5.0), mesh_show_back_face=False, **options)
    assert culled[60, 80, 2] > 240 and loom.render(inward, straight_view(5.0), **options)[60, 80, 2] < 15


def test_light_on_a_smooth_sphere_changes_less_from_pixel_to_pixel(device):
    ball = sphere(rings=10)
    mesh = loom.TriangleMesh(ball.vertices, ball.triangles)
    steps = {}
    for shading in ("flat", "smooth"):
        row = loom.render(mesh, straight_view(5.0), shading=shading, device=device)[60, 50:110, 0].astype(int)
        steps[shading] = np.abs(np.diff(row)).max()
    assert steps["smooth"] * 2 < steps["flat"]
    plain = loom.render(mesh, straight_view(5.0), shading="none", device=device)
    assert np.unique(plain[60, 50:110], axis=0).shape[0] == 1


@pytest.mark.parametrize("with_normals", [False, True], ids=["flat", "smooth"])
def test_a_painted_mesh_is_lit_as_one_without_colors_is(device, with_normals):
    ball = loom.TriangleMesh.create_sphere(1.0)
    ball = ball.compute_vertex_normals() if with_normals else ball
    plain = loom.render({"geometry": ball, "color": (1, 0.6, 0.2)}, straight_view(5.0), device=device)
    painted = ball.paint_uniform_color([1, 0.6, 0.2])
    image = loom.render(painted, straight_view(5.0), device=device)
    assert np.unique(image.reshape(-1, 3), axis=0).shape[0] > 50
    assert np.abs(image.astype(int) - plain).max() <= 1  # colors between three corners are rounded
    bare = loom.render({"geometry": painted, "shaded": False}, straight_view(5.0), device=device)
    assert np.unique(bare[60, 50:110], axis=0).tolist() == [[255, 153, 51]]


def test_a_texture_keeps_the_light_of_its_photographs(device):
    square = loom.TriangleMesh(
        [[-1, -1, 0], [1, -1, 0.5], [1, 1, 0], [-1, 1, 0]], [[0, 2, 1], [0, 3, 2]],
        triangle_uvs=np.zeros((6, 2)), textures=[np.full((2, 2, 3), 200, np.uint8)],
    )  # fmt: skip
    middle = loom.render(square, straight_view(5.0), device=device)[60, 80]
    lit = loom.render({"geometry": square, "shaded": True}, straight_view(5.0), device=device)[60, 80]
    assert middle.tolist() == [200, 200, 200] and lit[0] < 200


def test_edges_are_drawn_over_faces_and_as_wide_on_each_slope(device):
    spokes = [[0, 0, 0], *([np.cos(a), np.sin(a), 0] for a in np.linspace(0, 2 * np.pi, 12, endpoint=False))]
    mesh = loom.TriangleMesh(spokes, [[0, 1 + (k + 1) % 12, 1 + k] for k in range(12)])
    options = {"shading": "none", "device": device}
    image, bare = (loom.render(mesh, straight_view(4.0), mesh_show_wireframe=w, **options) for w in (True, False))
    loss = bare[..., 0].astype(float) - image[..., 0]
    v, u = np.mgrid[:120, :160]
    ring = (np.hypot(u - 79.5, v - 59.5) > 20) & (np.hypot(u - 79.5, v - 59.5) < 40)
    sector = np.round(np.arctan2(v - 59.5, u - 79.5) / (np.pi / 6)).astype(int) % 12
    sums = np.array([loss[ring & (sector == k)].sum() for k in range(12)])
    assert sums.min() > 0.9 * sums.max() and loss.min() >= 0
    assert sums.mean() == pytest.approx(20 * 204 * 0.88, rel=0.1)  # as dark as an edge of 1 px


def test_the_order_of_triangles_does_not_change_the_picture(device):
    mesh = sphere(rings=30)
    first = loom.render(mesh, None, SMALL, device=device)
    assert first.tobytes() == loom.render(mesh, None, SMALL, device=device).tobytes()
    mesh.triangles = mesh.triangles[::-1]
    # triangles with the same depth in a sample may be swapped there
    assert (first != loom.render(mesh, None, SMALL, device=device)).mean() < 0.01


def test_points_keep_their_colors_and_one_point_is_a_disc(device):
    cloud = loom.PointCloud([[0, 0, 0]], colors=[[1.0, 0, 0]])
    image = loom.render(cloud, straight_view(2.0), point_size=20, device=device)
    assert (image[60, 80] == (255, 0, 0)).all()
    assert (255 - image[..., 1].astype(float)).sum() / 255 == pytest.approx(np.pi * 100, rel=0.03)


def test_points_sized_in_meters_are_larger_when_nearer(device):
    point = {"geometry": np.zeros((1, 3)), "point_size": 0.2, "metric": True, "color": BLACK}
    areas = [coverage(loom.render(point, straight_view(d), device=device)) for d in (1.0, 2.0)]
    assert areas == pytest.approx([np.pi * 400, np.pi * 100], rel=0.05)


def test_the_point_size_closes_nearly_all_gaps(device):
    rng = np.random.default_rng(2)
    for count in (1500, 60_000):
        points = np.column_stack([rng.uniform(-1, 1, (count, 2)), np.zeros(count)])
        image = loom.render({"geometry": points, "color": BLACK}, straight_view(5.0, 400.0), device=device)
        assert (image[10:110, 30:130, 0] < 128).mean() > 0.9


def test_crowded_points_look_as_when_each_is_drawn(device):
    points = np.random.default_rng(4).normal(size=(40_000, 3))
    colors = (points - points.min(axis=0)) / np.ptp(points, axis=0)
    view = straight_view(14.0)
    crowded = loom.render(loom.PointCloud(points, colors=colors), view, point_size=2.0, device=device)
    parts = [loom.PointCloud(points[k::20], colors=colors[k::20]) for k in range(20)]
    assert np.abs(crowded.astype(int) - loom.render(parts, view, point_size=2.0, device=device)).mean() < 8


def test_points_behind_their_neighbors_are_darker_and_those_with_normals_are_lit(device):
    x, y = np.meshgrid(np.linspace(-1, 1, 200), np.linspace(-1, 1, 200))
    step = np.column_stack([x.ravel(), y.ravel(), np.where(x < 0, 0.0, 0.5).ravel()])
    options = {"camera": straight_view(6.0), "device": device}
    gray = {"color": (0.5, 0.5, 0.5)}
    image = loom.render({"geometry": step, **gray}, **options)[40:80].astype(int).sum(axis=2)
    far = image[:, 100:105].mean()
    assert image[:, 78:86].mean(axis=0).min() < 0.8 * far and image[:, 60:75].mean() == pytest.approx(far, rel=0.02)
    normals = np.tile([[0, 0, -1.0]], (len(step), 1)) + 0.9 * (step[:, :1] > 0) * [[1.0, 0, 0]]
    cloud = loom.PointCloud(step, normals=normals / np.linalg.norm(normals, axis=1)[:, None])
    lit = loom.render({"geometry": cloud, **gray}, **options)
    assert abs(int(lit[60, 60, 0]) - int(lit[60, 100, 0])) > 5
    colored = loom.PointCloud(step, normals=normals, colors=np.full((len(step), 3), 0.5))
    assert loom.render(colored, **options)[60, 60].tolist() == [128, 128, 128]  # at full brightness


@pytest.mark.parametrize("lean", [(0.02, 0.05), (0.15, -0.1)])
def test_lines_are_visible_over_the_faces_that_contain_them(device, lean):
    cube = loom.TriangleMesh.create_box(2, 2, 2)
    cube = paint(loom.TriangleMesh(cube.vertices - 1, cube.triangles), (0, 0, 1))
    face = loom.LineSet([[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]], [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]])
    view = loom.View.from_open3d(([-1] * 3, [1] * 3), front=[1, *lean], width=160, height=120)
    red, alone = (
        ((image[..., 0] > 128) & (image[..., 2] < 128)).sum()
        for image in (loom.render([*back, paint(face, (1, 0, 0))], view, device=device) for back in ([cube], []))
    )
    assert 0.97 * alone < red <= 1.15 * alone  # over the blue cube, edge pixels count from a smaller fraction on


def test_line_widths_and_colors_are_independent(device):
    lines = loom.LineSet([[-1, -0.2, 0], [1, -0.2, 0], [-1, 0.2, 0], [1, 0.2, 0]], [[0, 1], [2, 3]])
    lines = loom.LineSet(lines.points, lines.lines, [[1, 0, 0], [0, 1, 0]])
    image = loom.render([{"geometry": lines, "line_width": 4}], straight_view(2.0), device=device)
    below, above = image[80], image[39]  # y runs down
    assert below[80].tolist() == [0, 255, 0] and above[80].tolist() == [255, 0, 0]
    black = loom.render(paint(lines, line_width=4), straight_view(2.0), device=device)
    assert coverage(black) == pytest.approx(2 * 4 * 160, rel=0.05)


def test_nearer_geometries_hide_farther_ones_of_any_kind(device):
    ball = {"geometry": sphere(), "color": (1, 0, 0), "shaded": False}
    cloud = {"geometry": np.array([[0, 0, -2.0], [0.0, 0.3, 2.0]]), "color": (0, 1, 0), "point_size": 6}
    line = {"geometry": loom.LineSet([[-1, 0.2, -3], [1, 0.2, -3], [-1, -0.2, 3], [1, -0.2, 3]], [[0, 1], [2, 3]])}
    for order in ([ball, cloud, line], [line, cloud, ball]):
        image = loom.render(order, straight_view(5.0), device=device)
        assert image[60, 80].tolist() == [0, 255, 0]  # the near point; the far one is hidden
        assert image[68, 80].tolist() == [255, 0, 0]
        assert (image[79:81, 80] < 60).all() and image[55, 80].tolist() == [255, 0, 0]


def test_depth_is_that_of_the_visible_surface(device):
    _, depth = loom.render(sphere(rings=200), straight_view(5.0), depth=True, device=device)
    assert depth.shape == (120, 160) and depth.dtype == np.float32
    v, u = np.mgrid[:120, :160]
    rays = np.stack([(u - 79.5) / 200, (v - 59.5) / 200, np.ones((120, 160))], -1)
    length = (rays**2).sum(axis=-1)
    root = 25 - 24 * length  # |t ray - (0, 0, 5)| = 1
    inside = root > 0.5
    expected = (5 - np.sqrt(root[inside])) / length[inside]
    assert np.abs(depth[inside] - expected).max() < 2e-3
    assert (depth[root < -0.5] == 0).all()


def test_a_path_behind_a_wall_is_visible_in_images_and_not_in_depth_maps(device):
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[:, :3, 3] = [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]
    corners = [[-2, -2, -1], [2, -2, -1], [2, 2, -1], [-2, 2, -1]]  # between the path and the camera at z = -3
    wall = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]])
    path = {"geometry": loom.Trajectory(poses), "color": (1.0, 0.0, 0.0)}
    view = straight_view(3.0)
    image = loom.render([wall, path], view, device=device).astype(int)
    assert ((image[..., 0] > 200) & (image[..., 1] < 60)).sum() > 20
    hidden, depth = loom.render([wall, path], view, depth=True, device=device)
    np.testing.assert_array_equal(hidden, loom.render(wall, view, device=device))
    np.testing.assert_allclose(depth[depth > 0], 2.0, rtol=1e-4)


def test_depth_of_lines_is_their_own(device):
    line = loom.LineSet([[-1, 0, 0], [1, 0, 0]], [[0, 1]])
    _, depth = loom.render({"geometry": line, "line_width": 3}, straight_view(2.0), depth=True, device=device)
    assert depth[60, 80] == pytest.approx(2.0, rel=1e-6)


def test_a_pose_moves_the_drawn_geometry(device):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], (5.0, -3.0, 1.0)
    cloud = loom.PointCloud(np.random.default_rng(0).random((3000, 3))).estimate_normals()
    view = loom.View.fit(cloud.transform(T).points, width=160, height=120)
    moved = loom.render(cloud.transform(T), view, device=device).astype(int)
    assert np.abs(moved - loom.render({"geometry": cloud, "pose": T}, view, device=device)).mean() < 0.5


def test_coordinates_of_a_map_grid_are_drawn_as_exactly_as_small_ones(device):
    far = sphere(center=(5e5, 5.4e6, 300.0))
    near = loom.render(sphere(), None, SMALL, device=device).astype(int)
    assert np.abs(near - loom.render(far, None, SMALL, device=device)).mean() < 0.5


@pytest.mark.parametrize("scale", [1e-12, 1e12])
def test_scenes_of_any_size_are_drawn_alike(device, scale):
    points, ball = np.random.default_rng(0).uniform(-1, 1, (2000, 3)), sphere(rings=20)
    images = []
    for factor in (1.0, scale):
        mesh = SimpleNamespace(vertices=ball.vertices * factor, triangles=ball.triangles)
        lines = loom.LineSet(np.array([[-1, -1, -1], [1, 1, 1.0]]) * factor, [[0, 1]])
        images.append(loom.render([mesh, points * factor * 2, lines], None, SMALL, device=device).astype(int))
    assert np.abs(images[0] - images[1]).mean() < 1.0 and (images[1] < 200).any()


def test_open3ds_parameters_and_files_give_the_same_picture(tmp_path, device):
    ball, parameters = sphere(), {"front": [1, 0, 0], "up": [0, 0, 1], "zoom": 0.8, "field_of_view": 45}
    bounds = ball.vertices.min(axis=0), ball.vertices.max(axis=0)
    view = loom.View.from_open3d(bounds, **parameters, width=160, height=120)
    loom.write_view(tmp_path / "view.json", view, bounds)
    images = [loom.render(ball, camera, SMALL, device=device) for camera in (parameters, tmp_path / "view.json", view)]
    assert images[0].tobytes() == images[2].tobytes()
    assert np.abs(images[0].astype(int) - images[1]).max() <= 40  # the last digits of the camera differ
    assert (images[0] != images[1]).mean() < 0.01


@pytest.mark.parametrize(
    "nothing", [[], np.empty((0, 3)), loom.PointCloud(), loom.TriangleMesh(), np.full((3, 3), np.nan)]
)
def test_nothing_gives_the_background(device, nothing):
    has_rows = isinstance(nothing, np.ndarray) and nothing.size  # that are NaN
    with contextlib.nullcontext() if has_rows else pytest.warns(UserWarning, match=r"^geometries:"):
        image, depth = loom.render(nothing, None, SMALL, background=(0.2, 0.4, 1.0), depth=True, device=device)
    assert image.shape == (120, 160, 3) and image.dtype == np.uint8
    assert np.unique(image.reshape(-1, 3), axis=0).tolist() == [[51, 102, 255]] and not depth.any()


def test_colors_out_of_range_are_clamped(device):
    cloud = SimpleNamespace(points=[[0, 0, 0]], colors=[[7.0, -3.0, np.nan]])
    assert loom.render(cloud, straight_view(2.0), point_size=20, device=device)[60, 80].tolist() == [255, 0, 0]


def test_labels_legends_and_color_bars_are_drawn(device):
    cloud = loom.PointCloud(np.random.default_rng(0).random((500, 3)))
    shown = {"geometry": cloud, "name": "dust", "color_by": "height", "colormap": "jet"}
    size = (320, 240)
    view = loom.View.fit(cloud.points, width=320, height=240)
    bare = loom.render(shown, view, device=device)
    labels = [("here", view.T_world_camera[:3, 3] - view.T_world_camera[:3, 2])]
    assert loom.render(shown, view, labels=labels, device=device).tobytes() == bare.tobytes()
    for extra in ({"labels": [("corner", [1, 1, 1])]}, {"legend": True}, {"color_bar": True}, {"scale_bar": True}):
        assert 20 < (loom.render(shown, view, device=device, **extra) != bare).any(axis=2).sum() < 0.5 * 320 * 240
    coloring = color_cloud(cloud, "height", colormap="jet")
    given = loom.render(shown, None, size, color_bar=coloring, device=device)
    assert given.tobytes() == loom.render(shown, None, size, color_bar=True, device=device).tobytes()


@pytest.mark.parametrize(
    ("change", "kind", "message"),
    [
        ({"size": (2**17, 4)}, ValueError, "size"),
        ({"background": "mauve"}, ValueError, "background: expected one of white, black, gray, grey, transparent"),
        ({"up": (0, 0, 0)}, ValueError, "up: expected a direction"),
        ({"camera": {"zom": 1}}, ValueError, "'zom'"),
        ({"camera": "no-file.json"}, FileError, "no-file"),
        ({"labels": [(3, [1, 2, 3])]}, TypeError, "labels"),
        ({"color_bar": True}, ValueError, "color_by"),
        ({"color_bar": "height"}, TypeError, "color_bar"),
        ({"mesh_show_wireframe": "yes"}, TypeError, "wireframe"),
    ],
)
def test_options_out_of_range_are_refused(change, kind, message):
    with pytest.raises(kind, match=message):
        loom.render(sphere(rings=4), **{"size": SMALL, **change})


def test_arrays_that_do_not_belong_together_are_refused():
    mesh = sphere(rings=4)
    mesh.triangles = mesh.triangles + 1
    with pytest.raises(ValueError, match="triangle"):
        loom.render(mesh, None, SMALL)
    with pytest.raises(ValueError, match="colors"):
        loom.render(SimpleNamespace(points=np.zeros((3, 3)), colors=np.zeros((2, 3))), None, SMALL)
    for geometry in (loom.PointCloud(np.zeros((1, 3))), loom.TriangleMesh([[0, 0, 0]] * 3, [[0, 1, 2]])):
        with pytest.raises(ValueError, match="label"):
            loom.render({"geometry": geometry, "color_by": "label"}, None, SMALL)


def test_a_result_of_frames_is_seen_upright_from_the_side_of_its_cameras(device):
    v, u = np.mgrid[:48, :64]
    depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    frames = loom.frames_from([(None, depth)] * 2, [[60.0, 0, 31.5], [0, 60, 23.5], [0, 0, 1]])
    result = loom.rgbd.reconstruct(frames, voxel_size=0.05, device=device)
    assert result.mesh.up == (0.0, -1.0, 0.0)
    view = view_scene(result.mesh, result.trajectory.poses, width=64, height=48)
    assert view.T_world_camera[2, 2] > 0.5  # forward, as the first camera
    image = loom.render(result, size=(64, 48))
    np.testing.assert_array_equal(image, loom.render(result.mesh, view))
    assert not np.array_equal(image, loom.render(result.mesh, size=(64, 48)))
    assert loom.render([result], size=(64, 48)).shape == (48, 64, 3)
